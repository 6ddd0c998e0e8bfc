// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemoryPlan
 * @brief who may hold how much memory while a mesh is built
 *
 * Three kinds of things are in memory. What is worked on: regions, one for each thread, whose size the wanted patch
 * sets as a rule; where they are larger, fewer are worked on at a time (vtkMTOrderedWork), and one that is larger than
 * all memory for work is an error. What grows with the mesh: the DAG's records, a sample for placing seeds, a few
 * numbers per region. What is left serves for sorting, and sorts take whatever they are given: so this is what the
 * limit sets. While regions are simplified nothing is sorted, so they may have that as well. The figures per triangle
 * were measured and rounded up (Testing/Applications measures them again, from outside).
 */
#ifndef vtkMTMemoryPlan_h
#define vtkMTMemoryPlan_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro

#include <cstdint>
#include <string>

class vtkMTTriangleStream;

class VTKMTCONSTRUCTION_EXPORT vtkMTMemoryPlan
{
public:
  vtkMTMemoryPlan(const vtkMTTriangleStream& input, const vtkMTBuildSettings& settings);

  /// Bytes with which the mesh can be built.
  std::uint64_t GetLeast() const { return this->Fixed + LeastSortMemory; }
  /// Bytes for sorting under a limit of at least that; 0: none.
  std::size_t GetSortMemory(std::uint64_t limit) const;
  /// Bytes for regions that are worked on, while nothing is sorted; 0: no limit.
  std::uint64_t GetWorkMemory(std::uint64_t limit) const;
  /// Bytes for the input's blocks that are in hand, while others are sorted; 0: no limit.
  std::uint64_t GetBlockMemory(std::uint64_t limit) const;
  /// Hands all of this to the settings.
  void Apply(std::uint64_t limit, vtkMTBuildSettings& settings) const;

  /// An upper estimate of what the spools of a build hold at most, the sink's included, bytes.
  std::uint64_t GetSpoolSize() const { return this->SpoolSize; }

  /// "1.5 GiB", "320 MiB", rounded up.
  static std::string ToText(std::uint64_t bytes);

private:
  static constexpr std::uint64_t LeastSortMemory = std::uint64_t(16) << 20;

  std::uint64_t Standing = 0; // buffers, and what grows with the mesh
  std::uint64_t Fixed = 0;    // and the least for work
  std::uint64_t Blocks = 0;   // what Standing has for blocks of the input
  double PerByteSimplified = 0.0;
  double PerByteCut = 0.0;
  std::uint64_t Whole = 0; // more sort memory than this is of no use
  std::uint64_t SpoolSize = 0;
};

#endif
