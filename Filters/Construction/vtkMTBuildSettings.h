// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildSettings
 * @brief what the parts of the construction are told: what to make, with which threads, memory and spools
 *
 * vtkMultiTriangulationBuilder documents the settings that users have; this is how they are handed down.
 */
#ifndef vtkMTBuildSettings_h
#define vtkMTBuildSettings_h

#include "vtkMTConstructionModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <functional>

class vtkMTPartitionStrategy;
class vtkMTSimplifier;
class vtkMTSpoolStore;
class vtkMTStageTimes;

struct VTKMTCONSTRUCTION_EXPORT vtkMTBuildSettings
{
  /// How far the work has come.
  struct ProgressReport
  {
    double Fraction = 0.0;
    const char* Step = "";         ///< "reading", "placing regions", "simplifying" ...
    std::uint32_t Level = 0;       ///< of the mesh that is made
    std::uint64_t Triangles = 0;   ///< done in this step
    std::uint64_t OfTriangles = 0; ///< in all; 0: not known
  };

  ///@{
  /// These have an influence on the result.
  std::size_t PatchTriangles = 1000;
  int LatticeBits = 24;
  bool MakeNormals = true;
  bool KeepFarOutliers = false;
  bool ExactPoints = false;
  const vtkMTPartitionStrategy* Partition = nullptr;
  const vtkMTSimplifier* Simplifier = nullptr;
  ///@}

  ///@{
  /// These have none.
  int Threads = 1;
  std::uint64_t MemoryLimit = 0;                  ///< bytes that the process is to hold at most; 0: no limit
  std::size_t SortMemory = std::size_t(64) << 20; ///< bytes, for all sorts that go on at a time
  /// Bytes for all regions that are worked on at a time, while nothing is sorted; 0: no limit. And what cutting a
  /// fragment, or simplifying a region, takes per byte of its records.
  std::uint64_t WorkMemory = 0;
  /// The same for the input's blocks that are in hand at a time, while others are sorted; 0: no limit.
  std::uint64_t BlockMemory = 0;
  double MemoryPerByteCut = 0.0;
  double MemoryPerByteSimplified = 0.0;
  vtkMTSpoolStore* Store = nullptr;
  vtkMTStageTimes* Times = nullptr; ///< gets the time that is spent
  /// Called now and then; false stops the work.
  std::function<bool(const ProgressReport&)> Progress;
  ///@}

  /**
   * Triangles of a region of Psi_i on M_i over those of a patch: a crossing with the next partition, of half as many
   * regions, cuts a region into about this many patches once slivers are merged (measured on scans and fractal spheres:
   * Testing/Construction prints the mean patch of every model that it builds).
   */
  static constexpr double PatchesPerRegion = 2.9;

  /// The wanted mean number of triangles in a region of Psi_i on M_i.
  double GetRegionTarget() const { return PatchesPerRegion * static_cast<double>(this->PatchTriangles); }

  /// False when the work is to stop.
  bool Report(const ProgressReport& report) const { return !this->Progress || this->Progress(report); }
};

#endif
