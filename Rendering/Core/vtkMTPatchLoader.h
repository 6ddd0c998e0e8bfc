// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchLoader
 * @brief brings patches into main memory, on threads of its own
 *
 * The PatchServer thread of Cignoni et al., "Batched Multi Triangulation" (2005), section 5. The owner posts what it
 * wants, the most urgent first; each post replaces the one before, so what only a past view wanted is dropped unless it
 * is being read already. A loader thread takes the most urgent request that no thread works at, together with requests
 * whose patches lie beside it in the store, reads them at once and decodes them one after the other; the owner takes
 * away what is done. All that is started is delivered, be it with an error, and nothing is delivered that was not
 * posted.
 *
 * Memory: before a patch is read, room is reserved for it, for its stored bytes and for what the codec needs to decode
 * it (vtkMTPatchSource::GetDecodeSize); while there is none, loading waits. A delivered patch keeps its room until the
 * last pointer to it is gone; the rest is given back when all that is read together has been delivered.
 *
 * Threads: Post, Take, Wait, Start and Stop are the owner's, one thread. Post and Take hold a lock for a few pointer
 * assignments, and no thread ever holds that lock while it reads or decodes; GetLongestLock says how long they took at
 * most. No vtkObject is touched by the loader's threads, and no exception leaves them.
 */
#ifndef vtkMTPatchLoader_h
#define vtkMTPatchLoader_h

#include "vtkMTPatch.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTGraph;
class vtkMTMemoryLimit;
class vtkMTPatchSource;

class VTKMTRENDERINGCORE_EXPORT vtkMTPatchLoader
{
public:
  using PatchPointer = std::shared_ptr<const vtkMTPatch>;

  struct Settings
  {
    /// 1 to 64; what is outside is clamped. One thread reads while another one decodes, so 2 is the default.
    int Threads = 2;
    /// Stored bytes that are read at once, at most, unless a single patch has more. Default 1 MiB.
    std::uint64_t LargestRead = std::uint64_t(1) << 20;
    /// Bytes between two wanted patches in the store, at most, for them to be read together. Default 4096.
    std::uint64_t LargestGap = 4096;
  };

  /// What to load, the most urgent first, and with which arrays (one flag per array of the graph; empty: all).
  struct Order
  {
    std::vector<std::uint32_t> Arcs;
    std::vector<unsigned char> Arrays;
  };

  struct Delivery
  {
    std::uint32_t Arc = 0;
    PatchPointer Patch; ///< null when it could not be loaded
    std::size_t Bytes = 0;
    std::vector<unsigned char> Arrays; ///< those that it was read with; empty: all
    std::string Error;
  };

  vtkMTPatchLoader(std::shared_ptr<const vtkMTPatchSource> source, std::shared_ptr<vtkMTMemoryLimit> memory);
  /// Stops.
  ~vtkMTPatchLoader();
  vtkMTPatchLoader(const vtkMTPatchLoader&) = delete;
  vtkMTPatchLoader& operator=(const vtkMTPatchLoader&) = delete;

  ///@{
  /// Start makes the threads; false, with a message, where the system has none to give. Stop waits for what is being
  /// read, drops the rest and joins the threads. What has been delivered can still be taken. Either may be called
  /// again, and Start after Stop.
  bool Start(const Settings& settings, std::string& error);
  void Stop();
  bool IsRunning() const;
  ///@}

  /// Replaces what was posted before. Arcs that are out of range are ignored.
  void Post(std::shared_ptr<const Order> order);
  /// Appends what has been delivered since the last call.
  void Take(std::vector<Delivery>& deliveries);
  /// Waits until there is something to take. False when there will be nothing: everything posted is done, or there is
  /// no room for what comes next, or the loader does not run.
  bool Wait();

  ///@{
  /// Since construction. Batches are what was read together. Lock is the longest time, in seconds, that a call of Post
  /// or Take took to get the lock and to do its work.
  std::uint64_t GetNumberOfPatches() const;
  std::uint64_t GetNumberOfBatches() const;
  std::uint64_t GetNumberOfStoredBytes() const;
  double GetLongestLock() const;
  ///@}

  /// Bytes that an arc's patch takes at most once it is there, as vtkMTPatch::GetMemorySize counts them.
  static std::size_t GetPatchBytes(
    const vtkMTGraph& graph, std::uint32_t arc, const std::vector<unsigned char>& arrays);

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
