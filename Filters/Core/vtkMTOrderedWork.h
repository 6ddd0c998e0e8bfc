// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOrderedWork
 * @brief does independent work in parallel and takes their results over in order
 *
 * Worker threads take the indices 0, 1, 2 ... one after the other; the calling thread takes the results over in the
 * order of the indices, while the workers go on. No worker is further ahead than the number of slots, nor do all of
 * them together take up more memory than a budget, so memory in flight is bounded. Reading belongs into the work,
 * writing into the taking over: both then overlap with everything else. What can only be read in order is fetched, by
 * one worker at a time, just before its work. A lock is taken a few times per index and never within its work.
 *
 * Errors: the message of the smallest index that failed, whatever the threads; exceptions of the work become messages.
 */
#ifndef vtkMTOrderedWork_h
#define vtkMTOrderedWork_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

struct VTKMTFILTERSCORE_EXPORT vtkMTOrderedWork
{
  /// Called by any thread; slot is this index's own until it is taken over. False with a message in error.
  using Work = std::function<bool(std::size_t index, std::size_t slot, std::string& error)>;

  /// What the indices that are worked on at a time may cost together, in bytes: one more than that is only begun when
  /// nothing else is worked on. Cost may be called by any thread.
  struct Budget
  {
    std::uint64_t Memory = 0; ///< 0: no limit
    std::function<std::uint64_t(std::size_t index)> Cost;
  };

  /// Slots that Run uses with so many threads.
  static std::size_t GetNumberOfSlots(int threads) { return threads > 1 ? 3 * static_cast<std::size_t>(threads) : 1; }

  /// work for all indices below count by the workers, take by the calling thread. False when one of them gave false.
  static bool Run(std::size_t count, int threads, const Work& work, const Work& take, std::string& error);
  static bool Run(
    std::size_t count, int threads, const Budget& budget, const Work& work, const Work& take, std::string& error);
  /// The same, with a fetch before the work: by the same thread, one index after the other.
  static bool Run(
    std::size_t count, int threads, const Work& fetch, const Work& work, const Work& take, std::string& error);
  static bool Run(std::size_t count, int threads, const Budget& budget, const Work& fetch, const Work& work,
    const Work& take, std::string& error);
};

#endif
