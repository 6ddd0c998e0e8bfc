// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemoryPlan
 * @brief who may hold how much memory while a model is built
 *
 * Three kinds of things are in memory. What is worked on: regions, one for each thread; where they are larger than
 * usual, fewer are worked on at a time (vtkMTOrderedWork), and one that is larger than all memory for work is an error.
 * What grows with the input: the DAG's records, a few numbers per region. What is left serves for sorting, and sorts
 * take whatever they are given: so this is what the limit sets. While regions are worked on nothing is sorted, so they
 * may have that as well. The numbers come from the builder (vtkMTMeshMemory for meshes); their use is the same for all.
 *
 * The limit of a builder counts from what the process holds when it begins. For a limit of the whole process, Divide
 * takes off a base: the process's resident size with a reserve, and never less than LeastBase. A resident size is not
 * the same twice (which pages of the program are mapped depends on the system's page cache), so the least limit that a
 * refusal names has room for a larger one: with that limit the same call is accepted, unless the process holds
 * GetVariation more by then.
 */
#ifndef vtkMTMemoryPlan_h
#define vtkMTMemoryPlan_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <string>

struct vtkMTWorkSettings;

class VTKMTFILTERSCORE_EXPORT vtkMTMemoryPlan
{
public:
  /// What a build needs, in bytes; as doubles, since counts that a damaged file claims may be of any size.
  struct Needs
  {
    double Standing = 0.0; ///< buffers, and what grows with the input
    double Work = 0.0;     ///< the least for what is worked on at a time
    double Blocks = 0.0;   ///< what Standing has for blocks of the input
    double Sorts = 0.0;    ///< more sort memory than this is of no use
    double Spools = 0.0;   ///< at most in the spools, the sink's included
  };

  explicit vtkMTMemoryPlan(const Needs& needs);

  /// Bytes with which the input can be built; what no machine has counts as 2^60.
  std::uint64_t GetLeast() const { return this->Fixed + LeastSortMemory; }
  /// Bytes for sorting under a limit of at least that; 0: none.
  std::size_t GetSortMemory(std::uint64_t limit) const;
  /// Bytes for regions that are worked on, while nothing is sorted; 0: no limit.
  std::uint64_t GetWorkMemory(std::uint64_t limit) const;
  /// Bytes for the input's blocks that are worked on, while others are sorted; 0: no limit.
  std::uint64_t GetBlockMemory(std::uint64_t limit) const;
  /// An upper estimate of what the spools of a build hold at most, the sink's included, bytes.
  std::uint64_t GetSpoolSize() const { return this->SpoolSize; }

  /// Hands all of this to the settings. False, with a message that names the least limit, when the limit is too small.
  bool Apply(std::uint64_t limit, vtkMTWorkSettings& settings, std::string& error) const;

  ///@{
  /**
   * A limit of the whole process, which holds `resident` bytes before it builds: what a builder has of it. False, with
   * a message that names the least limit, when that is not enough. IsWhole: whether spools and sorts fit in memory as
   * well.
   */
  bool Divide(std::uint64_t limit, std::uint64_t resident, std::uint64_t& builderLimit, std::string& error) const;
  bool IsWhole(std::uint64_t limit, std::uint64_t resident) const;
  static std::uint64_t GetBase(std::uint64_t resident);
  static std::uint64_t GetVariation(std::uint64_t resident) { return LeastVariation + resident / 32; }
  static constexpr std::uint64_t LeastBase = std::uint64_t(80) << 20; ///< bytes
  ///@}

  /// "1.5 GiB", "320 MiB", rounded up.
  static std::string ToText(std::uint64_t bytes);

private:
  static constexpr std::uint64_t LeastSortMemory = std::uint64_t(16) << 20;
  static constexpr std::uint64_t LeastVariation = std::uint64_t(8) << 20;

  std::uint64_t Standing;
  std::uint64_t Fixed; // standing, and the least for work
  std::uint64_t Blocks;
  std::uint64_t Whole;
  std::uint64_t SpoolSize;
};

#endif
