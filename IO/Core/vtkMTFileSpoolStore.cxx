// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSpoolStore.h"

#include "vtkMTPosix.h"
#include "vtkMTSpoolFile.h"
#include "vtkMTSpoolState.h"

#include <cerrno>
#include <filesystem>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

const std::string Ending = ".spool";

}

//------------------------------------------------------------------------------
struct vtkMTFileSpoolStore::Internals
{
  std::string Folder; // empty: not open
  int Lock = -1;
  bool HasCommitted = false;
  std::shared_ptr<vtkMTSpoolAccount> Account = std::make_shared<vtkMTSpoolAccount>();
  std::map<std::string, std::shared_ptr<vtkMTSpoolFile>> Named;
  std::set<std::string> InState; // names that the last state needs
  std::set<std::string> Doomed;  // of these, those that are not wanted any more

  std::string GetPath(const std::string& name) const { return this->Folder + "/" + name + Ending; }

  // What the last commit knows is spared.
  void RemoveStrays()
  {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(this->Folder, code))
    {
      const fs::path& path = entry.path();
      if (path.extension() == Ending && this->InState.count(path.stem().string()) == 0)
      {
        fs::remove(path, code);
      }
    }
  }
};

vtkMTFileSpoolStore::vtkMTFileSpoolStore()
  : Implementation(std::make_unique<Internals>())
{
}

vtkMTFileSpoolStore::~vtkMTFileSpoolStore()
{
  if (!this->Implementation->HasCommitted)
  {
    this->Clear();
  }
  if (this->Implementation->Lock >= 0)
  {
    ::close(this->Implementation->Lock);
  }
}

bool vtkMTFileSpoolStore::OpenFolder(const std::string& folder, std::string& error)
{
  Internals& own = *this->Implementation;
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
  {
    error = vtkMTSpoolFile::Describe(folder, "the folder for temporary files cannot be made");
    return false;
  }
  const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock < 0 || ::access(folder.c_str(), W_OK) != 0)
  {
    error = vtkMTSpoolFile::Describe(folder, "the folder for temporary files cannot be used");
    if (lock >= 0)
    {
      ::close(lock);
    }
    return false;
  }
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    error = folder + ": another build uses this folder";
    ::close(lock);
    return false;
  }
  own.Lock = lock;
  own.Folder = folder;
  own.HasCommitted = HasState(folder);
  return true;
}

const std::string& vtkMTFileSpoolStore::GetFolder() const
{
  return this->Implementation->Folder;
}

bool vtkMTFileSpoolStore::HasState(const std::string& folder)
{
  std::error_code code;
  return fs::exists(vtkMTSpoolState::GetPath(folder), code);
}

bool vtkMTFileSpoolStore::HasFiles(const std::string& folder)
{
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
  {
    if (entry.path().extension() == Ending)
    {
      return true;
    }
  }
  return false;
}

void vtkMTFileSpoolStore::RemoveFiles(const std::string& folder)
{
  Internals left;
  left.Folder = folder;
  left.RemoveStrays();
  ::rmdir(folder.c_str());
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::CreateBeside(const std::string& path, std::string& error)
{
  return vtkMTSpoolFile::CreateNameless(vtkMTPosix::FolderOf(path), std::make_shared<vtkMTSpoolAccount>(), error);
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::Create(std::string& error)
{
  return vtkMTSpoolFile::CreateNameless(this->Implementation->Folder + "/", this->Implementation->Account, error);
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::Create(const std::string& name, std::string& error)
{
  Internals& own = *this->Implementation;
  const std::string path = own.GetPath(name);
  if (own.Named.count(name) > 0 || own.InState.count(name) > 0)
  {
    error = path + ": exists already";
    return nullptr;
  }
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    error = vtkMTSpoolFile::Describe(path, "a temporary file cannot be created");
    return nullptr;
  }
  const auto file = std::make_shared<vtkMTSpoolFile>(path, descriptor, own.Account);
  own.Named.emplace(name, file);
  return std::make_unique<vtkMTFileSpool>(file);
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::Open(const std::string& name, std::uint64_t size, std::string& error)
{
  Internals& own = *this->Implementation;
  const std::string path = own.GetPath(name);
  const auto known = own.Named.find(name);
  if (known != own.Named.end())
  {
    if (known->second->GetSize() != size)
    {
      error =
        path + ": has " + std::to_string(known->second->GetSize()) + " bytes and should have " + std::to_string(size);
      return nullptr;
    }
    return std::make_unique<vtkMTFileSpool>(known->second);
  }
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  struct stat status;
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0 || static_cast<std::uint64_t>(status.st_size) < size ||
    ::ftruncate(descriptor, static_cast<off_t>(size)) != 0)
  {
    error = path + ": is not there with the " + std::to_string(size) + " bytes that the checkpoint says";
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
    return nullptr;
  }
  const auto file = std::make_shared<vtkMTSpoolFile>(path, descriptor, own.Account);
  file->SetSize(size);
  own.Named.emplace(name, file);
  return std::make_unique<vtkMTFileSpool>(file);
}

void vtkMTFileSpoolStore::Remove(const std::string& name)
{
  Internals& own = *this->Implementation;
  own.Named.erase(name);
  if (own.InState.count(name) > 0)
  {
    own.Doomed.insert(name);
  }
  else
  {
    ::unlink(own.GetPath(name).c_str());
  }
}

bool vtkMTFileSpoolStore::Commit(const std::vector<unsigned char>& state, std::string& error)
{
  Internals& own = *this->Implementation;
  std::vector<std::string> names;
  for (const auto& [name, file] : own.Named)
  {
    if (!file->Sync(error))
    {
      return false;
    }
    names.push_back(name);
  }
  if (!vtkMTSpoolState::SyncFolder(own.Folder, error) || !vtkMTSpoolState::Write(own.Folder, names, state, error))
  {
    return false;
  }
  own.HasCommitted = true;
  own.InState = std::set<std::string>(names.begin(), names.end());
  for (const std::string& name : own.Doomed)
  {
    ::unlink(own.GetPath(name).c_str());
  }
  own.Doomed.clear();
  return true;
}

bool vtkMTFileSpoolStore::Restore(std::vector<unsigned char>& state, std::string& error)
{
  Internals& own = *this->Implementation;
  state.clear();
  own.InState.clear();
  if (HasState(own.Folder))
  {
    std::vector<std::string> names;
    if (!vtkMTSpoolState::Read(own.Folder, names, state, error))
    {
      return false;
    }
    own.InState = std::set<std::string>(names.begin(), names.end());
  }
  own.RemoveStrays();
  return true;
}

void vtkMTFileSpoolStore::Clear()
{
  Internals& own = *this->Implementation;
  if (own.Folder.empty())
  {
    return;
  }
  // The state first: without it nothing else is needed.
  ::unlink(vtkMTSpoolState::GetPath(own.Folder).c_str());
  ::unlink((vtkMTSpoolState::GetPath(own.Folder) + ".new").c_str());
  own.Named.clear();
  own.InState.clear();
  own.Doomed.clear();
  own.RemoveStrays();
  own.HasCommitted = false;
  ::rmdir(own.Folder.c_str());
}

std::uint64_t vtkMTFileSpoolStore::GetSize() const
{
  return this->Implementation->Account->Size;
}

std::uint64_t vtkMTFileSpoolStore::GetLargestSize() const
{
  return this->Implementation->Account->Largest;
}
