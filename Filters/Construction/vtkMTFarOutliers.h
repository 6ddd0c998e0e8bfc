// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFarOutliers
 * @brief finds the few triangles that would coarsen the lattice for all others
 *
 * The lattice's step follows from the extent, so that one vertex at 1e38 would round a whole scan to a single point. A
 * triangle is a far outlier when all of this holds:
 *
 * 1. the lattice would be too coarse: the longest side over 2^bits is more than 1/16 of the median edge length;
 * 2. there is a gap: measured from the middle of the input (the median, axis by axis, of the triangles' corners) in the
 *    largest of the three coordinates, the triangle reaches at least 64 times as far as all triangles on the near side
 *    of the gap, and nothing lies in between;
 * 3. the triangles beyond the gap are few: at most 16 or 1/1000 of all, whichever is more, and never more than a
 *    quarter.
 *
 * Gaps are looked at from the outside, and only until the lattice is fine enough. More than a few triangles beyond a
 * gap, but not more than half of all, are no accident: then the input is refused, with what can be done. More
 * than half (small things scattered over a vast space) have no near side; they are built as they are, with a warning.
 *
 * Distances and lengths are counted by powers of two, so the result does not depend on the order of the triangles; the
 * median edge length is taken as the power of two above it.
 *
 * The input comes in blocks, up to three times: for bounds and edges; then, only where the lattice is too coarse, for
 * the middle (by external sorting), and for the counts of how far triangles reach, with their bounds.
 */
#ifndef vtkMTFarOutliers_h
#define vtkMTFarOutliers_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTRecordSort.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTFarOutliers
{
public:
  /// memory: bytes for sorting.
  vtkMTFarOutliers(int latticeBits, vtkMTSpoolStore& store, std::size_t memory);
  ~vtkMTFarOutliers();

  ///@{
  /// Every step is fed with all blocks, then asked whether another one is needed. All coordinates must be finite. False
  /// on failure, with a message in GetError.
  bool Add(const vtkMTInputBlock& block);
  bool FinishStep();
  bool IsFinished() const { return this->Step == Finished; }
  ///@}

  bool IsFar(const vtkMTInputBlock& block, const vtkMTInputBlock::Triangle& triangle) const;
  std::uint64_t GetNumberOfOutliers() const { return this->Outliers; }
  /// Of all triangles that are not left out: xmin, xmax, ymin, ymax, zmin, zmax.
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }

  /// For a person, where there are any; or why the input is refused.
  const std::string& GetMessage() const { return this->Message; }
  bool IsRefused() const { return this->Refused; }
  const std::string& GetError() const { return this->Error; }

private:
  using Box = std::array<double, 6>;
  struct Shell
  {
    std::uint64_t Triangles = 0;
    Box Bounds;
  };
  enum StepType
  {
    Edges,
    Middles,
    Reaches,
    Finished
  };

  bool AddMiddles(const vtkMTInputBlock& block);
  void AddReaches(const vtkMTInputBlock& block);
  bool FindMiddle();
  void FindTypicalEdge();
  void Decide();
  void Collect();
  void Explain(std::uint64_t beyond, int power);
  double GetReach(const vtkMTInputBlock& block, const vtkMTInputBlock::Triangle& triangle) const;
  Box FindBox(int limit) const;
  bool IsTooCoarse(const Box& box) const;
  std::uint64_t GetMostFew() const;

  const int Bits;
  StepType Step = Edges;
  int Limit; // triangles that reach a higher power of two are outliers
  std::uint64_t Triangles = 0;
  std::uint64_t Outliers = 0;
  std::vector<std::uint64_t> Lengths; // edges, by power of two
  double TypicalEdge = 0.0;
  Box Bounds;
  std::array<double, 3> Middle{ 0.0, 0.0, 0.0 };
  std::vector<std::unique_ptr<vtkMTRecordSort>> Coordinates; // one per axis
  std::map<int, Shell> Shells;                               // by power of two of the reach
  std::string Message;
  bool Refused = false;
  std::string Error;
};

#endif
