// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDeviation.h"

#include "vtkMTTriangleTree.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
// A convex polygon inside one triangle. A cut adds at most one corner to either part.
struct Piece
{
  static constexpr int Capacity = 16;
  std::array<Vector, Capacity> Corners;
  int Count = 0;
  int Depth = 0;
  std::uint32_t Triangle = 0;

  void Append(const Vector& x) { this->Corners[this->Count++] = x; }
  Vector GetMiddle() const
  {
    Vector sum{ 0.0, 0.0, 0.0 };
    for (int i = 0; i < this->Count; ++i)
    {
      sum = Add(sum, this->Corners[i]);
    }
    return Scale(sum, 1.0 / this->Count);
  }
};

constexpr int MaximumDepth = 48;

// Splits a convex piece by the plane through `on` with normal `normal` into what lies on the normal's side and the
// rest. False when the plane leaves it whole, but for slivers thinner than `thin` (then only one of the two has
// corners).
bool Split(const Piece& piece, const Vector& on, const Vector& normal, double thin, Piece& inside, Piece& outside)
{
  inside = Piece{ {}, 0, piece.Depth + 1, piece.Triangle };
  outside = inside;
  std::array<double, Piece::Capacity> side;
  bool anyIn = false;
  bool anyOut = false;
  const double tolerance = thin * Norm(normal);
  for (int i = 0; i < piece.Count; ++i)
  {
    side[i] = Dot(Subtract(piece.Corners[i], on), normal);
    anyIn = anyIn || side[i] > tolerance;
    anyOut = anyOut || side[i] < -tolerance;
  }
  if (!anyIn || !anyOut || piece.Count + 1 > Piece::Capacity)
  {
    (anyOut ? outside : inside) = piece;
    return false;
  }
  for (int i = 0; i < piece.Count; ++i)
  {
    const int j = (i + 1) % piece.Count;
    if (side[i] >= 0.0)
    {
      inside.Append(piece.Corners[i]);
    }
    if (side[i] <= 0.0)
    {
      outside.Append(piece.Corners[i]);
    }
    if ((side[i] > 0.0 && side[j] < 0.0) || (side[i] < 0.0 && side[j] > 0.0))
    {
      const Vector cut = Lerp(piece.Corners[i], piece.Corners[j], side[i] / (side[i] - side[j]));
      inside.Append(cut);
      outside.Append(cut);
    }
  }
  return true;
}

// Across its longest side or diagonal.
bool Halve(const Piece& piece, double thin, Piece& one, Piece& other)
{
  double longest = 0.0;
  int from = 0;
  int to = 0;
  for (int i = 0; i < piece.Count; ++i)
  {
    for (int j = i + 1; j < piece.Count; ++j)
    {
      const Vector d = Subtract(piece.Corners[j], piece.Corners[i]);
      if (Dot(d, d) > longest)
      {
        longest = Dot(d, d);
        from = i;
        to = j;
      }
    }
  }
  const Vector direction = Subtract(piece.Corners[to], piece.Corners[from]);
  return longest > 0.0 && Split(piece, Lerp(piece.Corners[from], piece.Corners[to], 0.5), direction, thin, one, other);
}

using Integer = __int128;

// Whether all corners of triangle t lie in the plane of triangle s, exactly: coordinates are integers below 2^33.
bool IsCoplanar(const vtkMTTriangleTree& treeOfT, std::uint32_t t, const vtkMTTriangleTree& treeOfS, std::uint32_t s)
{
  const auto difference = [](const Vector& a, const Vector& b)
  {
    return std::array<Integer, 3>{ static_cast<std::int64_t>(a[0] - b[0]), static_cast<std::int64_t>(a[1] - b[1]),
      static_cast<std::int64_t>(a[2] - b[2]) };
  };
  const Vector& origin = treeOfS.GetCorner(s, 0);
  const auto u = difference(treeOfS.GetCorner(s, 1), origin);
  const auto v = difference(treeOfS.GetCorner(s, 2), origin);
  const std::array<Integer, 3> normal{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0] };
  for (int c = 0; c < 3; ++c)
  {
    const auto w = difference(treeOfT.GetCorner(t, c), origin);
    if (w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2] != 0)
    {
      return false;
    }
  }
  return true;
}

// One direction: how far the triangles of one mesh are from the other. What is known of either side's triangles already
// is added to a distance: `before` of the triangle itself, `after` of the one that it is held against.
class OneSided
{
public:
  // What a triangle of the other mesh gives for a piece.
  struct Match
  {
    double Bound = std::numeric_limits<double>::infinity();
    std::uint32_t Triangle = vtkMTTriangleTree::None;
  };

  OneSided(const vtkMTTriangleTree& from, const vtkMTTriangleTree& to, vtkMTDeviation& result, double slack)
    : From(from)
    , To(to)
    , Result(result)
    , Slack(slack)
    , Before(from.GetNumberOfTriangles(), 0.0f)
    , After(to.GetNumberOfTriangles(), 0.0f)
    , BoundOfTriangle(from.GetNumberOfTriangles(), 0.0)
    , BoundOnTriangle(to.GetNumberOfTriangles(), 0.0)
  {
  }

  // A triangle of the other mesh for every point, and the lower bound to start with. Points are met triangle by
  // triangle, so that a neighbour's triangle is a good guess; where it is near enough nothing is to be learned from a
  // query.
  void VisitPoints(const vtkMTPatch& mesh)
  {
    this->NearestToPoint.assign(mesh.Points.size(), vtkMTTriangleTree::None);
    std::uint32_t guess = vtkMTTriangleTree::None;
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
      for (std::uint32_t p : points)
      {
        guess = this->NearestToPoint[p] != vtkMTTriangleTree::None ? this->NearestToPoint[p] : guess;
      }
      for (int c = 0; c < 3; ++c)
      {
        std::uint32_t& nearest = this->NearestToPoint[points[c]];
        if (nearest == vtkMTTriangleTree::None)
        {
          nearest = this->Visit(this->From.GetCorner(t, c), t, guess);
          guess = nearest;
        }
      }
    }
  }

  void BoundTriangles(const vtkMTPatch& mesh, std::size_t& budget)
  {
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      Piece piece;
      piece.Triangle = t;
      for (int c = 0; c < 3; ++c)
      {
        piece.Append(this->From.GetCorner(t, c));
      }
      const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
      Entry whole{ piece, Match(), this->NearestToPoint[points[0]], false };
      for (int c = 0; c < 3 && !this->IsNearEnough(whole.Best.Bound, 0.0); ++c)
      {
        this->Improve(whole, this->NearestToPoint[points[c]]);
      }
      if (!this->Accept(whole, 0.0))
      {
        whole.Guess = whole.Best.Triangle != vtkMTTriangleTree::None ? whole.Best.Triangle : whole.Guess;
        this->BoundPieces(whole, budget);
      }
    }
  }

  std::vector<float>& GetBefore() { return this->Before; }
  std::vector<float>& GetAfter() { return this->After; }
  /// The largest bound of a triangle's pieces, and of the pieces that were held against a triangle.
  const std::vector<double>& GetBoundOfTriangle() const { return this->BoundOfTriangle; }
  const std::vector<double>& GetBoundOnTriangle() const { return this->BoundOnTriangle; }

private:
  struct Entry
  {
    Piece Shape;
    Match Best;          // a part is within its whole's bound
    std::uint32_t Guess; // a triangle of the other mesh that may lie below
    bool IsNearest;      // the guess is the triangle nearest to the piece's middle
  };

  // Raises the lower bound by what is true at x; gives a triangle that is nearest, or near enough.
  std::uint32_t Visit(const Vector& x, std::uint32_t triangle, std::uint32_t guess)
  {
    if (guess != vtkMTTriangleTree::None)
    {
      const double enough = this->Result.LowerBound - this->Before[triangle] - this->After[guess];
      if (enough > 0.0 && this->To.GetDistance2(x, guess, enough * enough) < enough * enough)
      {
        return guess;
      }
    }
    this->FindNearest(x, triangle, guess);
    return guess;
  }

  // Makes the guess the triangle nearest to x and raises the lower bound; gives what is true at x.
  double FindNearest(const Vector& x, std::uint32_t triangle, std::uint32_t& guess)
  {
    const vtkMTTriangleTree::Hit hit = this->To.FindNearest(x, guess);
    guess = hit.Triangle;
    // What rounding may have added must not raise the lower bound.
    const double here =
      std::max(0.0, std::sqrt(hit.Distance2) - this->Slack) + this->Before[triangle] + this->After[hit.Triangle];
    this->Result.LowerBound = std::max(this->Result.LowerBound, here);
    return here;
  }

  // Holds the piece against one triangle: its largest corner distance.
  void Improve(Entry& entry, std::uint32_t s) const
  {
    const Piece& piece = entry.Shape;
    const double added = static_cast<double>(this->Before[piece.Triangle]) + this->After[s];
    const double limit = entry.Best.Bound - added;
    if (!(limit > 0.0))
    {
      return;
    }
    double distance2 = 0.0;
    for (int i = 0; i < piece.Count && distance2 < limit * limit; ++i)
    {
      distance2 = std::max(distance2, this->To.GetDistance2(piece.Corners[i], s, limit * limit));
    }
    const double distance = std::sqrt(distance2);
    const bool isZero = distance <= this->Slack && IsCoplanar(this->From, piece.Triangle, this->To, s);
    const double bound = added + (isZero ? 0.0 : distance + this->Slack);
    if (bound < entry.Best.Bound)
    {
      entry.Best = { bound, s };
    }
  }

  bool IsNearEnough(double bound, double trueHere) const
  {
    return bound <= std::max({ vtkMTDeviation::Share * this->Result.LowerBound, vtkMTDeviation::Looseness * trueHere,
                      2.0 * this->Slack });
  }

  bool Accept(const Entry& entry, double trueHere)
  {
    if (!this->IsNearEnough(entry.Best.Bound, trueHere))
    {
      return false;
    }
    this->Credit(entry);
    return true;
  }

  void Credit(const Entry& entry)
  {
    double& of = this->BoundOfTriangle[entry.Shape.Triangle];
    double& on = this->BoundOnTriangle[entry.Best.Triangle];
    of = std::max(of, entry.Best.Bound);
    on = std::max(on, entry.Best.Bound);
    this->Result.UpperBound = std::max(this->Result.UpperBound, entry.Best.Bound);
  }

  void BoundPieces(const Entry& whole, std::size_t& budget)
  {
    this->Stack.assign(1, whole);
    while (!this->Stack.empty())
    {
      const Entry entry = this->Stack.back();
      this->Stack.pop_back();
      if (budget == 0 || entry.Shape.Depth >= MaximumDepth)
      {
        this->Result.BudgetUsedUp = true;
        this->Credit(entry);
        continue;
      }
      --budget;
      ++this->Result.Pieces;
      this->BoundPiece(entry);
    }
  }

  void BoundPiece(Entry entry)
  {
    double trueHere = 0.0;
    if (entry.Guess == vtkMTTriangleTree::None)
    {
      trueHere = this->FindNearest(entry.Shape.GetMiddle(), entry.Shape.Triangle, entry.Guess);
      entry.IsNearest = true;
    }
    this->Improve(entry, entry.Guess);
    if (this->Accept(entry, trueHere) || this->CutAlong(entry))
    {
      return;
    }
    if (!entry.IsNearest)
    {
      trueHere = this->FindNearest(entry.Shape.GetMiddle(), entry.Shape.Triangle, entry.Guess);
      entry.IsNearest = true;
      this->Improve(entry, entry.Guess);
      if (this->Accept(entry, trueHere) || this->CutAlong(entry))
      {
        return;
      }
    }
    this->CutInHalves(entry);
  }

  // Cuts the piece along the edges of the guessed triangle, seen along its normal. What lies outside an edge belongs to
  // the triangle behind that edge, as a guess. False when the piece is not partly over the triangle, or has too many
  // corners.
  bool CutAlong(const Entry& entry)
  {
    const Vector& normal = this->To.GetNormal(entry.Guess);
    if (!(Dot(normal, normal) > 0.0) || entry.Shape.Count + 3 > Piece::Capacity)
    {
      return false;
    }
    const std::size_t before = this->Stack.size();
    Piece rest = entry.Shape;
    for (int e = 0; e < 3; ++e)
    {
      const Vector& a = this->To.GetCorner(entry.Guess, e);
      const Vector inward = Cross(normal, Subtract(this->To.GetCorner(entry.Guess, (e + 1) % 3), a));
      Piece inside;
      Piece outside;
      if (Split(rest, a, inward, this->Slack, inside, outside))
      {
        this->Stack.push_back({ outside, entry.Best, this->To.GetNeighbor(entry.Guess, e), false });
        rest = inside;
      }
      else if (inside.Count == 0)
      {
        this->Stack.resize(before); // nothing of it is over the triangle
        return false;
      }
    }
    if (this->Stack.size() == before)
    {
      return false; // all of it is
    }
    this->Stack.push_back({ rest, entry.Best, entry.Guess, false });
    return true;
  }

  void CutInHalves(const Entry& entry)
  {
    double trueHere = 0.0;
    for (int i = 0; i < entry.Shape.Count; ++i)
    {
      std::uint32_t guess = entry.Guess;
      trueHere = std::max(trueHere, this->FindNearest(entry.Shape.Corners[i], entry.Shape.Triangle, guess));
    }
    Piece one;
    Piece other;
    if (this->Accept(entry, trueHere))
    {
      return;
    }
    if (Halve(entry.Shape, this->Slack, one, other))
    {
      this->Stack.push_back({ one, entry.Best, entry.Guess, false });
      this->Stack.push_back({ other, entry.Best, entry.Guess, false });
      return;
    }
    this->Credit(entry); // too small to be cut
  }

  const vtkMTTriangleTree& From;
  const vtkMTTriangleTree& To;
  vtkMTDeviation& Result;
  const double Slack;
  std::vector<float> Before;
  std::vector<float> After;
  std::vector<double> BoundOfTriangle;
  std::vector<double> BoundOnTriangle;
  std::vector<std::uint32_t> NearestToPoint;
  std::vector<Entry> Stack;
};

float RoundUp(double value)
{
  const float rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

double GetExtent(const vtkMTPatch& mesh, const vtkMTPoint& origin)
{
  const vtkMTBox box = mesh.GetBox();
  double extent = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    extent = std::max({ extent, std::abs(static_cast<double>(box[2 * i]) - static_cast<double>(origin[i])),
      std::abs(static_cast<double>(box[2 * i + 1]) - static_cast<double>(origin[i])) });
  }
  return extent;
}
}

vtkMTDeviation vtkMTDeviation::Between(const vtkMTPatch& floor, const vtkMTTriangleTree& floorTree,
  const vtkMTPatch& fragment, const vtkMTTriangleTree& fragmentTree, const vtkMTPoint& origin,
  const std::vector<vtkMTReach>& floorReach, std::vector<vtkMTReach>& fragmentReach)
{
  vtkMTDeviation result;
  const double slack = std::ldexp(std::max(GetExtent(floor, origin), GetExtent(fragment, origin)), -40);
  OneSided down(floorTree, fragmentTree, result, slack);
  OneSided up(fragmentTree, floorTree, result, slack);
  for (std::size_t t = 0; t < floorReach.size(); ++t)
  {
    down.GetBefore()[t] = floorReach[t].FromInput;
    up.GetAfter()[t] = floorReach[t].ToInput;
  }
  down.VisitPoints(floor);
  up.VisitPoints(fragment);
  std::size_t budget = PiecesPerTriangle * (floor.Triangles.size() + fragment.Triangles.size());
  down.BoundTriangles(floor, budget);
  up.BoundTriangles(fragment, budget);
  fragmentReach.resize(fragment.Triangles.size());
  for (std::size_t t = 0; t < fragmentReach.size(); ++t)
  {
    fragmentReach[t] = { RoundUp(up.GetBoundOfTriangle()[t]), RoundUp(down.GetBoundOnTriangle()[t]) };
    result.UpperBound =
      std::max({ result.UpperBound, double(fragmentReach[t].ToInput), double(fragmentReach[t].FromInput) });
  }
  return result;
}
