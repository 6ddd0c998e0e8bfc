// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemorySpool.h"

#include <utility>

//------------------------------------------------------------------------------
bool vtkMTMemorySpool::Reset(std::size_t keys)
{
  this->Error.clear();
  this->Bins.clear();
  this->Bins.resize(keys);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTMemorySpool::Put(std::size_t key, vtkMTPatch&& patch)
{
  if (key >= this->Bins.size())
  {
    this->Error = "Spool: key " + std::to_string(key) + " of " + std::to_string(this->Bins.size());
    return false;
  }
  this->Bins[key].push_back(std::move(patch));
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTMemorySpool::Take(std::size_t key, std::vector<vtkMTPatch>& patches)
{
  patches.clear();
  // No message here: Take is called from several threads at once and Error is one.
  if (key >= this->Bins.size())
  {
    return false;
  }
  patches.swap(this->Bins[key]);
  return true;
}
