// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchCache
 * @brief patches in main memory, by arc, within a limit
 *
 * Request says which patches are wanted, the most wanted first; Get gives what is there. Between the two stands
 * whatever brings patches in: Request reads them itself, one after the other, so what it asked for and what fits is
 * there when it returns.
 *
 * The limit holds for the patches that the cache keeps, counted as vtkMTPatch::GetMemorySize does. When a patch does
 * not fit, the one that has not been asked for longest goes, but never one of the same Request. A patch that somebody
 * still holds lives on.
 *
 * A patch that cannot be read, or does not fit the limit by itself, is a failure: TakeFailures names it once, and
 * Request does not try it again before Retry.
 *
 * Threads: all calls from one thread.
 */
#ifndef vtkMTPatchCache_h
#define vtkMTPatchCache_h

#include "vtkMTCutModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkMTPatchSource;

class VTKMTCUT_EXPORT vtkMTPatchCache
{
public:
  using PatchPointer = std::shared_ptr<const vtkMTPatch>;

  struct Failure
  {
    std::uint32_t Arc = 0;
    std::string What;
  };

  /// Bytes; 512 MiB.
  static constexpr std::size_t DefaultLimit = std::size_t(512) << 20;

  explicit vtkMTPatchCache(std::shared_ptr<const vtkMTPatchSource> source, std::size_t limit = DefaultLimit);
  ~vtkMTPatchCache();
  vtkMTPatchCache(const vtkMTPatchCache&) = delete;
  vtkMTPatchCache& operator=(const vtkMTPatchCache&) = delete;

  /// In bytes. A smaller limit than what is held drops patches at once.
  void SetLimit(std::size_t limit);
  std::size_t GetLimit() const { return this->Limit; }
  std::size_t GetBytes() const { return this->Bytes; }
  std::size_t GetNumberOfPatches() const { return this->Entries.size(); }

  /**
   * The arrays that patches are wanted with from now on, one flag per array of the graph. A patch that is there without
   * one of them is as good as not there, and is read again, with that array, when it is requested.
   */
  void SetArrays(const std::vector<unsigned char>& arrays) { this->Arrays = arrays; }

  /// Asks for the arcs' patches. Arcs out of range are ignored.
  void Request(const std::vector<std::uint32_t>& arcs);

  /// The patch, or null when it is not there with all the wanted arrays.
  PatchPointer Get(std::uint32_t arc) const;

  std::vector<Failure> TakeFailures();
  /// Forgets which patches could not be had.
  void Retry() { this->Failed.clear(); }

  /// Patches read since construction.
  std::uint64_t GetNumberOfReads() const { return this->Reads; }

private:
  struct Entry
  {
    PatchPointer Patch;
    std::vector<unsigned char> Arrays;
    std::size_t Bytes = 0;
    std::uint64_t LastRequest = 0;
    std::list<std::uint32_t>::iterator Position; // in Order
  };

  bool Has(const Entry& entry) const;
  void Read(std::uint32_t arc);
  void Keep(std::uint32_t arc, Entry&& entry);
  bool MakeRoom(std::size_t bytes);
  void Drop(std::uint32_t arc);
  void Fail(std::uint32_t arc, const std::string& what);

  std::shared_ptr<const vtkMTPatchSource> Source;
  std::size_t Limit;
  std::size_t Bytes = 0;
  std::uint64_t Reads = 0;
  std::uint64_t RequestCount = 0;
  std::vector<unsigned char> Arrays; // empty: all
  std::unordered_map<std::uint32_t, Entry> Entries;
  std::list<std::uint32_t> Order; // least recently requested first
  std::unordered_set<std::uint32_t> Failed;
  std::vector<Failure> Failures;
};

#endif
