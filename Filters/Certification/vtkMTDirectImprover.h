// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDirectImprover
 * @brief lowers what is known of a fragment's triangles by one finer mesh
 *
 * The two directions of vtkMTDirectDeviation, for one part of a finer mesh. Not for use by others.
 */
#ifndef vtkMTDirectImprover_h
#define vtkMTDirectImprover_h

#include "vtkMTBoxRuns.h"
#include "vtkMTDeviation.h"
#include "vtkMTDirectDeviation.h"
#include "vtkMTPieceBound.h"

#include <cstdint>
#include <optional>
#include <vector>

class vtkMTDirectImprover
{
public:
  using Ball = vtkMTBoxRuns::Ball;
  using Deviations = vtkMTDirectDeviation::Deviations;
  using Mesh = vtkMTDirectDeviation::Mesh;
  using Range = vtkMTDirectDeviation::Range;
  using Vector = vtkMTSurface::Vector;
  static constexpr std::uint32_t None = vtkMTSurface::None;

  /// What passes from one part to the next.
  struct State
  {
    double Loose;               ///< times the true deviation is near enough
    double TrueDeviation = 0.0; ///< what is known of it
    double Kept = 0.0;          ///< what some triangles keep, so that less need not be improved
    bool IsLast = true;         ///< no finer mesh follows
  };

  /// The floor, and boxes around its triangles and what stands on them, which are made when they are asked for.
  struct FloorOf
  {
    const Mesh& Triangles;
    std::optional<vtkMTBoxRuns>& Boxes;
  };
  /// Lowers known: [fragment's triangles].
  vtkMTDirectImprover(
    const FloorOf& floor, const vtkMTSurface& fragment, const Mesh& finer, const State& state, Deviations& known);

  const State& GetState() const { return this->Sought; }

  /// ToInput of the triangles that have more than least.
  void ImproveToInput(const Range& range, double least);
  void ImproveFromInput(const Range& range);

  static double GetLarger(const vtkMTTriangleDeviation& deviation);
  static Ball GetBall(const vtkMTSurface& surface, std::uint32_t t, double wider);
  /// Whether a place is so near to a triangle.
  static bool IsWithin(const vtkMTSurface& surface, std::uint32_t t, const Vector& x, double reach);

private:
  bool IsExhausted() const { return this->Effort > this->MostEffort; }
  double GetLimit() const;
  void FindCandidates(std::uint32_t t, double known);
  Ball GetBallOfFiner(std::uint32_t s) const;
  std::uint32_t FindOver(std::uint32_t t) const;
  vtkMTSurface::Hit FindNearest(const Vector& x, const vtkMTSurface::Hit& guess);
  double BoundCandidates(std::uint32_t t, double known, std::vector<unsigned char>& isBound);
  void BoundCandidate(std::uint32_t s, std::uint32_t t);
  bool IsNearFloor(const Ball& ball);
  void HandOn(const std::vector<std::uint32_t>& handedOn, const std::vector<unsigned char>& isHanded);

  struct Candidate
  {
    Ball Around; // and around what stands on it
    std::uint32_t Triangle;
  };

  const FloorOf Floor;
  const vtkMTSurface& Fragment;
  const Mesh Finer;
  Deviations& Known;
  State Sought;
  const double Slack;
  vtkMTDeviation UpResult;
  vtkMTDeviation DownResult;
  vtkMTPieceBound Up;
  vtkMTPieceBound Down;
  const vtkMTBoxRuns FinerBoxes; // around each triangle and what stands on it
  std::vector<Candidate> Candidates;
  std::uint32_t Searched = None;   // the triangle that is held against the finer mesh
  bool HasCandidates = false;      // of that
  std::uint32_t LastOver = None;   // what lies over the candidate that was bounded last
  std::uint32_t LastNearFloor = 0; // the floor's triangle that was looked at last
  double Reach = 0.0;              // of what stands on the finer triangle that is bounded
  std::size_t Budget;
  const std::size_t MostEffort;
  std::size_t Effort = 0; // balls that were looked at
};

#endif
