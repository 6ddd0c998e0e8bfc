// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRecordSpool
 * @brief byte records put into a spool under keys, and taken by key
 *
 * Between two steps of the construction every fragment, and then every patch, is put under the region that will use it.
 * Records are written one behind the other through a buffer of 1 MiB; what stays in memory is one entry of 16 bytes per
 * record and 4 per key. Regions are numbered along a space-filling curve, so records of one region, and of regions that
 * follow one another, were written close together.
 *
 * Put comes from one thread; after Seal, Take may be called from several.
 */
#ifndef vtkMTRecordSpool_h
#define vtkMTRecordSpool_h

#include "vtkMTBytes.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTRecordSpool
{
public:
  vtkMTRecordSpool();
  ~vtkMTRecordSpool();

  /// Forgets everything and begins a new spool of that name for the keys 0 .. keys-1.
  bool Begin(vtkMTSpoolStore& store, const std::string& name, std::size_t keys, std::string& error);
  /// At most 2^32 - 1 bytes.
  bool Put(std::size_t key, const void* data, std::size_t size, std::string& error);
  /// Writes what is buffered; from here on records are taken.
  bool Seal(std::string& error);
  /// The key's records in the order in which they were put, until Begin or Remove.
  bool Take(std::size_t key, std::vector<vtkMTBytes::Record>& records, std::string& error) const;
  /// One of the key's records, by its place in that order.
  bool Take(std::size_t key, std::size_t place, vtkMTBytes::Record& record, std::string& error) const;
  /// The key's records will not be taken again: see vtkMTSpool::Forget.
  void Forget(std::size_t key);
  /// Bytes of the key's records together.
  std::uint64_t GetSize(std::size_t key) const;
  std::size_t GetNumberOfKeys() const { return this->First.empty() ? 0 : this->First.size() - 1; }

  ///@{
  /// What must be kept for Open to give the sealed spool back.
  void Save(std::vector<unsigned char>& state) const;
  bool Open(
    vtkMTSpoolStore& store, const std::string& name, const std::vector<unsigned char>& state, std::string& error);
  ///@}
  /// Gives up the spool's memory and removes it from the store.
  void Remove();

private:
  struct Entry
  {
    std::uint64_t Offset;
    std::uint32_t Size;
    std::uint32_t Key;
  };

  bool Flush(std::string& error);
  bool Take(const Entry& entry, vtkMTBytes::Record& record, std::string& error) const;
  void SortEntries();

  vtkMTSpoolStore* Store = nullptr;
  std::string Name;
  std::unique_ptr<vtkMTSpool> Spool;
  std::vector<unsigned char> Buffer;
  std::vector<Entry> Entries;
  std::vector<std::uint32_t> First; // per key, one more than keys
};

#endif
