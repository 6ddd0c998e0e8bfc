// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTWorkSettings
 * @brief with what a builder works: threads, memory, spools, and whom it reports to
 *
 * Nothing of this has an influence on the result. What a builder is to make is its own settings' (vtkMTBuildSettings
 * for partition sequences); the shares of the memory limit are filled in by vtkMTMemoryPlan.
 */
#ifndef vtkMTWorkSettings_h
#define vtkMTWorkSettings_h

#include <cstddef>
#include <cstdint>
#include <functional>

class vtkMTSpoolStore;
class vtkMTStageTimes;

struct vtkMTWorkSettings
{
  /// How far the work has come.
  struct ProgressReport
  {
    double Fraction = 0.0;
    const char* Step = "";      ///< "reading triangles", "placing regions", "simplifying" ...
    std::uint32_t Level = 0;    ///< of what is made; 0: the input
    std::uint64_t Done = 0;     ///< triangles, points or samples in this step
    std::uint64_t Expected = 0; ///< in all; 0: not known
  };

  int Threads = 1;
  std::uint64_t MemoryLimit = 0;                  ///< bytes that the builder is to hold at most; 0: no limit
  std::size_t SortMemory = std::size_t(64) << 20; ///< bytes, for all sorts that go on at a time
  std::uint64_t WorkMemory = 0;  ///< bytes for all that is worked on at a time, while nothing is sorted; 0: no limit
  std::uint64_t BlockMemory = 0; ///< the same for blocks of the input, while others are sorted; 0: no limit
  vtkMTSpoolStore* Store = nullptr;
  vtkMTStageTimes* Times = nullptr; ///< gets the time that is spent
  /// Called now and then; false stops the work.
  std::function<bool(const ProgressReport&)> Progress;

  /// False when the work is to stop.
  bool Report(const ProgressReport& report) const { return !this->Progress || this->Progress(report); }
};

#endif
