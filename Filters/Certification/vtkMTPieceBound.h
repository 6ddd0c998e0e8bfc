// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPieceBound
 * @brief how far single triangles of one mesh can be from another mesh, by splitting them into pieces
 *
 * The distance from a point to one fixed triangle s is convex, so over a convex piece of the plane it is largest at the
 * piece's corners: the largest corner distance to s is an upper bound of how far any point of the piece is from the
 * other mesh. A triangle is held against one triangle of the other mesh after the other, and where the least bound is
 * far above the largest true distance seen so far (a lower bound of the result, from points), it is split into the
 * cells below the triangles that lie over it (vtkMTCellsOver), each of which is held against its own. Where these are
 * not known to cover it, and where one of them is not near enough, pieces are bounded one by one: they are split along
 * the edges of the triangle nearest to the piece's middle, seen along that triangle's normal, so that they come to lie
 * over one triangle each; else what is near enough to the triangle nearest to one of the corners is split off, however
 * long or thin it is; else in halves. Pieces are split until their bound is within Share of that lower bound (more
 * after many halvings of one triangle) or within Looseness of their own, or the budget of pieces is used up; the result
 * is then still an upper bound. Where a piece lies in the plane of s, which is decided in exact integers, and over s,
 * its distance is exactly zero.
 *
 * What is known of either side's triangles already is added to a distance: `Before` of the triangle itself, `After` of
 * the one that it is held against.
 */
#ifndef vtkMTPieceBound_h
#define vtkMTPieceBound_h

#include "vtkMTCellsOver.h"
#include "vtkMTPiece.h"
#include "vtkMTSurface.h"
#include "vtkMTTriangleTree.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

struct vtkMTDeviation;

class vtkMTPieceBound
{
public:
  using Vector = vtkMTSurface::Vector;
  static constexpr std::uint32_t None = vtkMTSurface::None;

  /// Distances above zero are raised by slack, in steps. The bounds go to result as well.
  vtkMTPieceBound(const vtkMTSurface& from, const vtkMTSurface& to, double slack, vtkMTDeviation& result);

  /// A bound that is no more than so many times the lower bound need not be improved.
  double Share;
  /// A trial is made where a better mesh to be held against follows: what is known by a place does not raise the lower
  /// bound, and a triangle of which a place is above what is near enough is given up; its bound is infinite then.
  bool IsTrial = false;
  /// Whether GetBoundOfTriangle is all that is asked for afterwards.
  bool IsOneSided = false;
  /// Whether a ball holds nothing of what is to be bounded: pieces within it that are not near enough are left out.
  /// Null: everything counts.
  std::function<bool(const Vector& middle, double radius)> IsElsewhere;
  /// Finds the triangle nearest to a place, at most so far away as a guess is, in place of a tree over all. Null: the
  /// tree does.
  std::function<vtkMTSurface::Hit(const Vector& x, const vtkMTSurface::Hit& guess)> Search;

  std::vector<float> Before; ///< [from's triangles]
  std::vector<float> After;  ///< [to's triangles]

  /// The triangle nearest to x; guess is one to begin with, or None.
  vtkMTSurface::Hit FindNearest(const Vector& x, std::uint32_t guess) { return this->Tree.FindNearest(x, guess); }
  /// Makes guess (or None) a triangle near x, a place on `triangle`, and gives what is known by it; where that is above
  /// the lower bound, the nearest triangle, and raises the lower bound to what is true.
  double Visit(const Vector& x, std::uint32_t triangle, std::uint32_t& guess);
  /// Whether a bound need not be improved.
  bool IsNearEnough(double bound, double trueHere = 0.0) const { return bound <= this->GetEnough(trueHere); }
  /// Notes that part of a triangle is within a bound, Before and After counted, of another one.
  void Credit(std::uint32_t from, std::uint32_t to, double bound);
  /// Distance of a convex shape inside triangle t from triangle s, from its largest corner distance: zero where both
  /// are in one plane, else rounded up.
  double Raise(double distance, std::uint32_t t, std::uint32_t s) const;
  /// A triangle, the one that it was held against by a piece, and their distance, rounded up.
  struct Credited
  {
    std::uint32_t From;
    std::uint32_t To;
    double Distance;
  };
  /// Of all pieces; what follows upon itself is there once.
  const std::vector<Credited>& GetCredited() const { return this->PiecesCredited; }
  /// Bounds and credits a triangle by pieces; guesses are triangles (or None) to begin with.
  void Bound(std::uint32_t triangle, const std::array<std::uint32_t, 3>& guesses, std::size_t& budget);
  /// The same by a triangle nearby, from which the way is not far to the one that lies over the middle; first, where it
  /// is not None, by one that may be nearer still. Gives the one that lies over the middle, or None.
  std::uint32_t BoundNear(std::uint32_t triangle, std::uint32_t guess, std::uint32_t nearer, std::size_t& budget);

  ///@{
  /// The largest bound that was credited to each triangle.
  const std::vector<double>& GetBoundOfTriangle() const { return this->BoundOfTriangle; }
  const std::vector<double>& GetBoundOnTriangle() const { return this->BoundOnTriangle; }
  ///@}

private:
  using Piece = vtkMTPiece;
  // What a triangle of the other mesh gives for a piece.
  struct Match
  {
    double Bound = std::numeric_limits<double>::infinity();
    std::uint32_t Triangle = None;
    double Distance = 0.0; // what the bound has of it
  };
  struct Entry
  {
    Piece Shape;
    Match Best;          // a part is within its whole's bound
    std::uint32_t Guess; // a triangle of the other mesh that may lie below
    bool IsNearest;      // the guess is the triangle nearest to the piece's middle
  };

  double GetEnough(double trueHere) const;
  bool IsCoplanar(std::uint32_t t, std::uint32_t s) const;
  void Improve(Entry& entry, std::uint32_t s) const;
  bool Accept(const Entry& entry, double trueHere);
  bool IsLeftOut(const Piece& piece) const;
  bool TouchesHub(std::uint32_t s) const;
  Entry MakeWhole(std::uint32_t triangle) const;
  double VisitPlace(const Vector& x, std::uint32_t triangle, std::uint32_t& guess);
  double VisitMiddle(Entry& entry);
  bool GivesUp(const Entry& entry, double trueHere);
  void CreditPiece(const Entry& entry);
  void CreditBy(const Entry& whole, const Piece& part, std::uint32_t s);
  void BoundPieces(const Entry& whole, std::size_t& budget);
  bool BoundCells(const Entry& whole, std::size_t& budget);
  void BoundPiece(Entry& entry);
  bool CutAlong(const Entry& entry);
  void Push(const Piece& shape, const Match& best, std::uint32_t guess);
  void Divide(Entry& entry);
  bool SplitOffWithinReach(const Entry& entry, int corner, std::uint32_t nearest, double reach);

  const vtkMTSurface& From;
  const vtkMTSurface& To;
  vtkMTTriangleTree Tree; // of To
  vtkMTCellsOver Over;
  const double Slack;
  vtkMTDeviation& Result;
  std::vector<double> BoundOfTriangle;
  std::vector<double> BoundOnTriangle;
  std::vector<Credited> PiecesCredited;
  std::vector<Entry> Stack;
  Entry Current;            // the piece that is looked at
  std::size_t Halvings = 0; // of pieces of the triangle that is bounded
};

#endif
