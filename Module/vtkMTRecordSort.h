// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRecordSort
 * @brief external sorting of fixed-size records by 64-bit keys
 *
 * Records begin with their key, eight bytes in the machine's order. They are added in any order and given back in
 * increasing order of key, equal ones in the order in which they were added: the result depends on nothing else, the
 * memory least of all. What does not fit is sorted in runs (radix sort, least digit first; bits that all keys share are
 * passed over, so keys of a small range are counted once), the runs go to a nameless spool, and are merged through one
 * buffer each (Knuth, TAOCP 3, section 5.4). When there are more runs than buffers of 64 KiB fit, groups of runs are
 * merged to longer ones first.
 *
 * Memory: at most what is given, and at least MinimumMemory. While nothing has been written, what was added is all that
 * is held. One thread.
 */
#ifndef vtkMTRecordSort_h
#define vtkMTRecordSort_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTRecordSort
{
public:
  static constexpr std::size_t MinimumMemory = std::size_t(1) << 19;

  /// recordSize counts the key. memory is in bytes.
  vtkMTRecordSort(vtkMTSpoolStore& store, std::size_t recordSize, std::size_t memory);
  ~vtkMTRecordSort();

  bool Add(const void* record) { return this->Add(record, 1); }
  /// So many records, one behind the other.
  bool Add(const void* records, std::size_t count);
  /// Nothing can be added from here on.
  bool Finish();
  /// The next record in order, valid until the next call; null at the end and on failure, with a message in GetError.
  const unsigned char* Next();
  /// The key of what Next gave.
  static std::uint64_t GetKey(const unsigned char* record)
  {
    std::uint64_t key;
    std::memcpy(&key, record, sizeof(key));
    return key;
  }

  std::uint64_t GetNumberOfRecords() const { return this->Count; }
  /// Bytes held now; a little more while a run is sorted.
  std::size_t GetMemorySize() const;
  /// Empty unless something failed.
  const std::string& GetError() const { return this->Error; }
  bool HasFailed() const { return !this->Error.empty(); }

private:
  struct Run
  {
    std::uint64_t Begin; // bytes
    std::uint64_t End;
  };
  class Merge;

  bool Grow(std::size_t size);
  void SortBuffer();
  const unsigned char* GetSorted(std::size_t place) const
  {
    return this->Buffer.get() + (this->Order ? this->Order[place] : place) * this->RecordSize;
  }
  bool WriteRun();
  bool MergeGroups();
  std::size_t GetFanIn() const;

  vtkMTSpoolStore& Store;
  const std::size_t RecordSize;
  const std::size_t Memory;
  const std::size_t Capacity; // records
  std::string Error;
  struct Free
  {
    void operator()(unsigned char* bytes) const { std::free(bytes); }
  };
  std::unique_ptr<unsigned char, Free> Buffer; // of malloc: large blocks grow where they are
  std::size_t BufferSize = 0;                  // bytes
  std::size_t BufferCapacity = 0;
  std::unique_ptr<std::uint32_t[]> Order; // records of the buffer, sorted; null: as they are
  std::unique_ptr<vtkMTSpool> Spool;
  std::vector<Run> Runs;
  std::unique_ptr<Merge> Merger;
  std::size_t NextInBuffer = 0;
  std::uint64_t Count = 0;
};

#endif
