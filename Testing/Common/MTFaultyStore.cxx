// SPDX-License-Identifier: BSD-3-Clause
#include "MTFaultyStore.h"

#include <utility>

//------------------------------------------------------------------------------
class MTFaultyStore::Spool : public vtkMTSpool
{
public:
  Spool(MTFaultyStore& store, std::unique_ptr<vtkMTSpool> spool)
    : Store(store)
    , Bytes(std::move(spool))
  {
  }
  bool Append(const void* data, std::size_t size, std::string& error) override
  {
    return this->Store.CountWrite(error) && this->Bytes->Append(data, size, error);
  }
  bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const override
  {
    if (this->Store.Reads++ >= this->Store.FailingRead)
    {
      error = "planned failure of a read";
      return false;
    }
    return this->Bytes->Read(offset, size, data, error);
  }
  std::uint64_t GetSize() const override { return this->Bytes->GetSize(); }

private:
  MTFaultyStore& Store;
  std::unique_ptr<vtkMTSpool> Bytes;
};

//------------------------------------------------------------------------------
MTFaultyStore::MTFaultyStore(vtkMTSpoolStore& store)
  : Store(store)
{
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkMTSpool> MTFaultyStore::Create(std::string& error)
{
  return this->Wrap(this->Store.Create(error));
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkMTSpool> MTFaultyStore::Create(const std::string& name, std::string& error)
{
  return this->CountWrite(error) ? this->Wrap(this->Store.Create(name, error)) : nullptr;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkMTSpool> MTFaultyStore::Open(const std::string& name, std::uint64_t size, std::string& error)
{
  return this->Wrap(this->Store.Open(name, size, error));
}

//------------------------------------------------------------------------------
void MTFaultyStore::Remove(const std::string& name)
{
  this->Store.Remove(name);
}

//------------------------------------------------------------------------------
bool MTFaultyStore::IsLasting() const
{
  return this->Store.IsLasting();
}

//------------------------------------------------------------------------------
bool MTFaultyStore::Commit(const std::vector<unsigned char>& state, std::string& error)
{
  return this->CountWrite(error) && this->Store.Commit(state, error);
}

//------------------------------------------------------------------------------
bool MTFaultyStore::Restore(std::vector<unsigned char>& state, std::string& error)
{
  return this->Store.Restore(state, error);
}

//------------------------------------------------------------------------------
void MTFaultyStore::Clear()
{
  this->Store.Clear();
}

//------------------------------------------------------------------------------
std::uint64_t MTFaultyStore::GetSize() const
{
  return this->Store.GetSize();
}

//------------------------------------------------------------------------------
std::uint64_t MTFaultyStore::GetLargestSize() const
{
  return this->Store.GetLargestSize();
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkMTSpool> MTFaultyStore::Wrap(std::unique_ptr<vtkMTSpool> spool)
{
  return spool ? std::make_unique<Spool>(*this, std::move(spool)) : nullptr;
}

//------------------------------------------------------------------------------
bool MTFaultyStore::CountWrite(std::string& error)
{
  if (this->Writes++ >= this->FailingWrite)
  {
    error = "planned failure: no space left";
    return false;
  }
  return true;
}
