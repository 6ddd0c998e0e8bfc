// SPDX-License-Identifier: BSD-3-Clause
// Looks things up in a sequence that is too long for memory. Not installed.
#ifndef vtkMTSpoolLookup_h
#define vtkMTSpoolLookup_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkMTRecordSort.h"
#include "vtkMTSpoolQueue.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/**
 * Requests name items of a sequence by their index, in any order; the sequence then goes by once; the answers come in
 * the order of the requests, as often as wanted. Two external sorts: by index, and back.
 */
class VTKMTIOCORE_EXPORT vtkMTSpoolLookup
{
public:
  /// itemSize: bytes. memory: bytes, for the sorts.
  vtkMTSpoolLookup(vtkMTSpoolStore& store, std::size_t itemSize, std::size_t memory);

  ///@{
  /// All requests, then all items of the sequence, then Finish. False on failure, with a message in error.
  bool Request(std::uint64_t index, std::string& error);
  bool PassBy(const void* item, std::string& error);
  bool Finish(std::string& error);
  ///@}
  std::uint64_t GetNumberOfRequests() const { return this->Requested; }

  void Rewind() { this->Answers.Rewind(); }
  /// The item that the next request asked for, valid until the next call; null on failure, with a message in error.
  const unsigned char* Next(std::string& error) { return this->Answers.Take(this->ItemSize, error); }

private:
  bool NextRequest(std::string& error);

  vtkMTSpoolStore& Store;
  const std::size_t ItemSize;
  const std::size_t Memory;
  std::unique_ptr<vtkMTRecordSort> Requests; // index, number of the request
  std::unique_ptr<vtkMTRecordSort> Found;    // number of the request, item
  vtkMTSpoolQueue Answers;
  std::vector<unsigned char> Record;
  const unsigned char* Wanted = nullptr;
  std::uint64_t Passed = 0;
  std::uint64_t Requested = 0;
  bool IsPassing = false;
};

#endif
