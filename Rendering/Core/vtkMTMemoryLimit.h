// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemoryLimit
 * @brief a number of bytes that several threads share and do not exceed
 *
 * Who wants memory reserves it first, and does without when it is refused; so what is reserved is never more than the
 * limit, not even for a moment. Only lowering the limit can leave more reserved than it allows, until enough is given
 * back.
 *
 * Threads: all members may be called from any number of threads at once; none waits.
 */
#ifndef vtkMTMemoryLimit_h
#define vtkMTMemoryLimit_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <atomic>
#include <cstddef>

class VTKMTRENDERINGCORE_EXPORT vtkMTMemoryLimit
{
public:
  explicit vtkMTMemoryLimit(std::size_t limit)
    : Limit(limit)
  {
  }

  void SetLimit(std::size_t limit) { this->Limit = limit; }
  std::size_t GetLimit() const { return this->Limit; }

  /// False, and nothing reserved, where that would be more than the limit.
  bool Reserve(std::size_t bytes);
  void Release(std::size_t bytes) { this->Used -= bytes; }

  std::size_t GetUsed() const { return this->Used; }
  /// The most that has ever been reserved at once.
  std::size_t GetMostUsed() const { return this->MostUsed; }

private:
  std::atomic<std::size_t> Limit;
  std::atomic<std::size_t> Used{ 0 };
  std::atomic<std::size_t> MostUsed{ 0 };
};

#endif
