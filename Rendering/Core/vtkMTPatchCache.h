// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchCache
 * @brief patches in main memory, by arc, within a limit
 *
 * Each view of the model says with SetWants which patches it wants and how much; the cache has the missing ones loaded
 * (vtkMTPatchLoader), the most wanted first, and keeps the others from being dropped. Collect takes in what has been
 * loaded since, and Get gives what is there. None of these waits for anything that takes long. Request does: it returns
 * when everything that it asks for is there or known not to come, so that pictures and tests do not depend on timing.
 *
 * The limit is hard: what is kept, what is being loaded, and patches that have been dropped but that are still in
 * use are together never more, counted as vtkMTPatch::GetMemorySize does, with the stored bytes of what is being
 * loaded and what decoding it takes. To make room, the patch that is wanted least goes, among those that no view wants
 * the one that has not been wanted longest; but never for one that is wanted less or as much, so two patches do not
 * push each other out in turn.
 *
 * A patch that cannot be loaded, or that does not fit the limit by itself, is a failure: TakeFailures names it once,
 * and it is not tried again before Retry.
 *
 * Threads: all calls from one thread. The loader's threads are started by the first call that has something loaded, and
 * stopped by the destructor.
 */
#ifndef vtkMTPatchCache_h
#define vtkMTPatchCache_h

#include "vtkMTPatch.h"
#include "vtkMTPatchLoader.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkMTMemoryLimit;
class vtkMTPatchSource;

class VTKMTRENDERINGCORE_EXPORT vtkMTPatchCache
{
public:
  using PatchPointer = std::shared_ptr<const vtkMTPatch>;

  struct Failure
  {
    std::uint32_t Arc = 0;
    std::string What;
  };

  struct Want
  {
    std::uint32_t Arc = 0;
    double Priority = 0.0; ///< the larger, the sooner it is loaded and the later dropped
    bool Load = true;      ///< otherwise it is only kept, if it is there
  };

  /// Bytes; 512 MiB.
  static constexpr std::size_t DefaultLimit = std::size_t(512) << 20;

  explicit vtkMTPatchCache(std::shared_ptr<const vtkMTPatchSource> source, std::size_t limit = DefaultLimit,
    const vtkMTPatchLoader::Settings& settings = vtkMTPatchLoader::Settings());
  ~vtkMTPatchCache();
  vtkMTPatchCache(const vtkMTPatchCache&) = delete;
  vtkMTPatchCache& operator=(const vtkMTPatchCache&) = delete;

  /// In bytes. A smaller limit than what is held drops patches at once.
  void SetLimit(std::size_t limit);
  std::size_t GetLimit() const;
  /// Of the patches that are kept.
  std::size_t GetBytes() const { return this->Bytes; }
  /// Of everything that the limit counts, and the most that it has ever been.
  std::size_t GetUsedBytes() const;
  std::size_t GetMostUsedBytes() const;
  std::size_t GetNumberOfPatches() const { return this->Entries.size(); }

  /**
   * The arrays that patches are wanted with from now on, one flag per array of the graph. A patch that is there without
   * one of them is as good as not there, and is read again, with that array, when it is wanted.
   */
  void SetArrays(const std::vector<unsigned char>& arrays) { this->Arrays = arrays; }

  /// Takes in what has been loaded. True when that was anything, failures included.
  bool Collect();

  /// Replaces what the view (any address that stands for it) wants. Arcs out of range are ignored.
  void SetWants(const void* view, std::vector<Want> wants);
  /// The view wants nothing any more.
  void Forget(const void* view);

  /// Whether something that is wanted is still to come; false also when there is no room for it.
  bool IsLoading() const { return this->Missing > 0; }

  /**
   * Waits until these patches are there, the first ones first, or cannot be had: they are damaged, or do not fit the
   * limit together. What views want must be set again afterwards.
   */
  void Request(const std::vector<std::uint32_t>& arcs);

  /// The patch, or null when it is not there with all the wanted arrays.
  PatchPointer Get(std::uint32_t arc) const;
  bool Has(std::uint32_t arc) const;
  bool IsFailed(std::uint32_t arc) const { return this->Failed.count(arc) != 0; }

  std::vector<Failure> TakeFailures();
  /// Forgets which patches could not be had.
  void Retry() { this->Failed.clear(); }

  /// Patches read since construction.
  std::uint64_t GetNumberOfReads() const { return this->Reads; }
  const vtkMTPatchLoader& GetLoader() const { return *this->Loader; }

private:
  struct Entry
  {
    PatchPointer Patch;
    std::vector<unsigned char> Arrays;
    std::size_t Bytes = 0;
    double Priority = 0.0;
    std::uint64_t LastWanted = 0;
  };

  bool Has(const Entry& entry) const;
  void Insert(vtkMTPatchLoader::Delivery&& delivery);
  void Drop(std::uint32_t arc);
  void Fail(std::uint32_t arc, const std::string& what);
  std::size_t GetRoomFor(std::uint32_t arc, const std::vector<unsigned char>& arrays) const;
  std::vector<unsigned char> GetArraysToRead(const std::vector<Want>& missing) const;
  std::vector<Want> MergeWants();
  void Order();
  void Post(std::shared_ptr<const vtkMTPatchLoader::Order> order);

  std::shared_ptr<const vtkMTPatchSource> Source;
  std::shared_ptr<vtkMTMemoryLimit> Memory;
  vtkMTPatchLoader::Settings LoaderSettings;
  std::unique_ptr<vtkMTPatchLoader> Loader;
  std::size_t Bytes = 0;
  std::uint64_t Reads = 0;
  std::uint64_t Tick = 0;
  std::size_t Missing = 0;           // ordered and not there yet
  std::vector<unsigned char> Arrays; // empty: all
  std::map<const void*, std::vector<Want>> Wants;
  std::unordered_map<std::uint32_t, Entry> Entries;
  std::unordered_set<std::uint32_t> Failed;
  std::vector<Failure> Failures;
};

#endif
