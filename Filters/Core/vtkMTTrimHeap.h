// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTrimHeap
 * @brief gives what was freed back to the system when it goes out of scope
 *
 * What threads have freed stays with their heaps, and counts as the process's, otherwise. Pages that are given back and
 * wanted again cost time, up to a tenth of a build in memory, so nothing is done while the process holds a quarter of
 * its limit at most. To be made before what is freed, so that it goes after that.
 */
#ifndef vtkMTTrimHeap_h
#define vtkMTTrimHeap_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <cstdint>

class VTKMTFILTERSCORE_EXPORT vtkMTTrimHeap
{
public:
  static constexpr std::uint64_t Always = 1;
  /// The most that the process is to hold, in bytes; with 0, no limit, nothing is given back.
  explicit vtkMTTrimHeap(std::uint64_t limit)
    : Limit(limit)
  {
  }
  ~vtkMTTrimHeap();
  vtkMTTrimHeap(const vtkMTTrimHeap&) = delete;
  void operator=(const vtkMTTrimHeap&) = delete;

  /// What the process holds, in bytes; 0 where the system does not say.
  static std::uint64_t GetResidentSize();

private:
  std::uint64_t Limit;
};

#endif
