// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTScratchStore.h"

#include "vtkMTSpoolFile.h"

struct vtkMTScratchStore::Internals
{
  std::string Folder; // with a slash at its end
  std::shared_ptr<vtkMTSpoolAccount> Account = std::make_shared<vtkMTSpoolAccount>();
};

vtkMTScratchStore::vtkMTScratchStore(const std::string& folder)
  : Implementation(std::make_unique<Internals>())
{
  this->Implementation->Folder = (folder.empty() ? "." : folder) + "/";
}

vtkMTScratchStore::~vtkMTScratchStore() = default;

std::unique_ptr<vtkMTSpool> vtkMTScratchStore::Create(std::string& error)
{
  return vtkMTSpoolFile::CreateNameless(this->Implementation->Folder, this->Implementation->Account, error);
}

std::unique_ptr<vtkMTSpool> vtkMTScratchStore::Create(const std::string& name, std::string& error)
{
  error = name + ": a scratch store has no named spools";
  return nullptr;
}

std::unique_ptr<vtkMTSpool> vtkMTScratchStore::Open(const std::string& name, std::uint64_t, std::string& error)
{
  return this->Create(name, error);
}

bool vtkMTScratchStore::Restore(std::vector<unsigned char>& state, std::string&)
{
  state.clear();
  return true;
}

std::uint64_t vtkMTScratchStore::GetSize() const
{
  return this->Implementation->Account->Size;
}

std::uint64_t vtkMTScratchStore::GetLargestSize() const
{
  return this->Implementation->Account->Largest;
}
