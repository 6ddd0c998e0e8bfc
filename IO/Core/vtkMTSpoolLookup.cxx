// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolLookup.h"

#include <cstring>

vtkMTSpoolLookup::vtkMTSpoolLookup(vtkMTSpoolStore& store, std::size_t itemSize, std::size_t memory)
  : Store(store)
  , ItemSize(itemSize)
  , Memory(memory)
  , Requests(std::make_unique<vtkMTRecordSort>(store, 2 * sizeof(std::uint64_t), memory / 2))
  , Answers(store)
  , Record(sizeof(std::uint64_t) + itemSize)
{
}

bool vtkMTSpoolLookup::Request(std::uint64_t index, std::string& error)
{
  const std::uint64_t record[2] = { index, this->Requested++ };
  const bool added = this->Requests->Add(record);
  error = added ? error : this->Requests->GetError();
  return added;
}

bool vtkMTSpoolLookup::NextRequest(std::string& error)
{
  this->Wanted = this->Requests->Next();
  error = this->Requests->HasFailed() ? this->Requests->GetError() : error;
  return !this->Requests->HasFailed();
}

bool vtkMTSpoolLookup::PassBy(const void* item, std::string& error)
{
  if (!this->IsPassing)
  {
    this->IsPassing = true;
    this->Found = std::make_unique<vtkMTRecordSort>(this->Store, this->Record.size(), this->Memory / 2);
    if (!this->Requests->Finish())
    {
      error = this->Requests->GetError();
      return false;
    }
    if (!this->NextRequest(error))
    {
      return false;
    }
  }
  while (this->Wanted && vtkMTRecordSort::GetKey(this->Wanted) == this->Passed)
  {
    std::memcpy(this->Record.data(), this->Wanted + sizeof(std::uint64_t), sizeof(std::uint64_t));
    std::memcpy(this->Record.data() + sizeof(std::uint64_t), item, this->ItemSize);
    if (!this->Found->Add(this->Record.data()))
    {
      error = this->Found->GetError();
      return false;
    }
    if (!this->NextRequest(error))
    {
      return false;
    }
  }
  ++this->Passed;
  return true;
}

bool vtkMTSpoolLookup::Finish(std::string& error)
{
  if (this->Requested > 0 && (!this->IsPassing || this->Wanted))
  {
    error = "something was looked up that does not exist";
    return false;
  }
  this->Requests.reset();
  if (this->Found && this->Found->Finish())
  {
    while (const unsigned char* record = this->Found->Next())
    {
      if (!this->Answers.Put(record + sizeof(std::uint64_t), this->ItemSize, error))
      {
        return false;
      }
    }
  }
  if (this->Found && this->Found->HasFailed())
  {
    error = this->Found->GetError();
    return false;
  }
  this->Found.reset();
  return this->Answers.Seal(error);
}
