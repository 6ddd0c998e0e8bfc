// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCheckpoint.h"

#include "vtkMTBytes.h"
#include "vtkMTSpoolStore.h"

#include <cstdint>

namespace
{
// To be changed with what states hold: a checkpoint of another version of the program is an error then.
constexpr std::uint64_t Version = 0x4d54637000000003; // "MTcp"
}

bool vtkMTCheckpoint::Write(vtkMTSpoolStore& store, std::string& error) const
{
  std::vector<unsigned char> bytes;
  vtkMTBytes::Writer writer(bytes);
  writer.Put(Version);
  writer.PutText(this->Identity);
  writer.PutList(this->State);
  writer.PutList(this->Sink);
  return store.Commit(bytes, error);
}

bool vtkMTCheckpoint::Read(vtkMTSpoolStore& store, std::string& error)
{
  *this = vtkMTCheckpoint();
  std::vector<unsigned char> bytes;
  if (!store.Restore(bytes, error))
  {
    return false;
  }
  if (bytes.empty())
  {
    return true;
  }
  vtkMTBytes::Reader reader(bytes);
  if (reader.Take<std::uint64_t>() != Version)
  {
    error = "the checkpoint is of another version of the program: begin anew";
    return false;
  }
  this->Identity = reader.TakeText();
  reader.TakeList(this->State);
  reader.TakeList(this->Sink);
  if (!reader.IsSound() || !reader.IsAtEnd())
  {
    *this = vtkMTCheckpoint();
    error = "the checkpoint does not hold what was kept";
    return false;
  }
  return true;
}
