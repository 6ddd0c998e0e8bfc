// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSpoolStore.h"

#include "vtkMTFileFormat.h"
#include "vtkMTPosix.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
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

constexpr char Magic[8] = { 'M', 'T', 's', 't', 'a', 't', 'e', '1' };
const std::string Ending = ".spool";

struct Account
{
  std::atomic<std::uint64_t> Size{ 0 };
  std::uint64_t Largest = 0;

  void Add(std::uint64_t size)
  {
    this->Size += size;
    this->Largest = std::max(this->Largest, this->Size.load());
  }
};

std::string Describe(const std::string& name, const std::string& what)
{
  return name + ": " + what + ": " + std::strerror(errno);
}

bool SyncFolder(const std::string& folder, std::string& error)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Some file systems cannot sync a folder.
  const bool done = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  if (!done)
  {
    error = Describe(folder, "cannot be made durable");
  }
  if (descriptor >= 0)
  {
    ::close(descriptor);
  }
  return done;
}

//------------------------------------------------------------------------------
struct File
{
  File(std::string name, int descriptor, std::shared_ptr<Account> account)
    : Name(std::move(name))
    , Descriptor(descriptor)
    , Holder(std::move(account))
  {
  }
  ~File()
  {
    ::close(this->Descriptor);
    this->Holder->Size -= this->Size;
  }
  File(const File&) = delete;
  void operator=(const File&) = delete;

  bool Append(const unsigned char* data, std::size_t size, std::string& error)
  {
    constexpr std::size_t largestWrite = std::size_t(1) << 30;
    while (size > 0)
    {
      const ssize_t written =
        ::pwrite(this->Descriptor, data, std::min(size, largestWrite), static_cast<off_t>(this->Size));
      if (written < 0 && errno == EINTR)
      {
        continue;
      }
      if (written <= 0)
      {
        errno = written == 0 ? ENOSPC : errno;
        error = Describe(this->Name, "writing temporary data failed after " + std::to_string(this->Size) + " bytes");
        return false;
      }
      data += written;
      size -= static_cast<std::size_t>(written);
      this->Size += static_cast<std::uint64_t>(written);
      this->Holder->Add(static_cast<std::uint64_t>(written));
      this->IsDirty = true;
    }
    return true;
  }

  bool Read(std::uint64_t offset, std::size_t size, unsigned char* to, std::string& error) const
  {
    while (size > 0)
    {
      const ssize_t got = ::pread(this->Descriptor, to, size, static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR)
      {
        continue;
      }
      if (got <= 0)
      {
        const std::string what = "reading temporary data failed at byte " + std::to_string(offset);
        error = got < 0 ? Describe(this->Name, what) : this->Name + ": " + what + ": it is too short";
        return false;
      }
      to += got;
      offset += static_cast<std::uint64_t>(got);
      size -= static_cast<std::size_t>(got);
    }
    return true;
  }

  const std::string Name;
  const int Descriptor;
  std::shared_ptr<Account> Holder;
  std::uint64_t Size = 0;
  bool IsDirty = true;
};

class FileSpool : public vtkMTSpool
{
public:
  explicit FileSpool(std::shared_ptr<File> file)
    : Bytes(std::move(file))
  {
  }
  bool Append(const void* data, std::size_t size, std::string& error) override
  {
    return this->Bytes->Append(static_cast<const unsigned char*>(data), size, error);
  }
  bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const override
  {
    return this->Bytes->Read(offset, size, static_cast<unsigned char*>(data), error);
  }
  std::uint64_t GetSize() const override { return this->Bytes->Size; }

private:
  std::shared_ptr<File> Bytes;
};

std::unique_ptr<vtkMTSpool> CreateNameless(
  const std::string& folder, const std::shared_ptr<Account>& account, std::string& error)
{
  std::string name;
  const int descriptor = vtkMTPosix::CreateUnique(folder + ".multitriangulation", name);
  if (descriptor < 0)
  {
    error = Describe(folder, "a temporary file cannot be created");
    return nullptr;
  }
  ::unlink(name.c_str());
  return std::make_unique<FileSpool>(std::make_shared<File>(folder, descriptor, account));
}

void Put(std::vector<unsigned char>& bytes, const void* data, std::size_t size)
{
  const unsigned char* from = static_cast<const unsigned char*>(data);
  bytes.insert(bytes.end(), from, from + size);
}

void PutNumber(std::vector<unsigned char>& bytes, std::uint64_t number)
{
  Put(bytes, &number, sizeof(number));
}

bool TakeNumber(const std::vector<unsigned char>& bytes, std::size_t& place, std::uint64_t& number)
{
  if (bytes.size() - place < sizeof(number))
  {
    return false;
  }
  std::memcpy(&number, bytes.data() + place, sizeof(number));
  place += sizeof(number);
  return true;
}

bool ReadWhole(const std::string& name, std::vector<unsigned char>& bytes, std::string& error)
{
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status;
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0)
  {
    error = Describe(name, "cannot be read");
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
    return false;
  }
  bytes.resize(static_cast<std::size_t>(status.st_size));
  File file(name, descriptor, std::make_shared<Account>());
  return file.Read(0, bytes.size(), bytes.data(), error);
}
}

//------------------------------------------------------------------------------
struct vtkMTFileSpoolStore::Internals
{
  std::string Folder; // empty: not open
  int Lock = -1;
  bool HasCommitted = false;
  std::shared_ptr<Account> Holder = std::make_shared<Account>();
  std::map<std::string, std::shared_ptr<File>> Named;
  std::set<std::string> InState; // names that the last state needs
  std::set<std::string> Doomed;  // of these, those that are not wanted any more

  std::string GetPath(const std::string& name) const { return this->Folder + "/" + name + Ending; }
  std::string GetStatePath() const { return this->Folder + "/state"; }

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

  bool Parse(const std::vector<unsigned char>& bytes, std::vector<unsigned char>& state)
  {
    std::size_t place = sizeof(Magic) + sizeof(std::uint64_t);
    if (bytes.size() < place || std::memcmp(bytes.data(), Magic, sizeof(Magic)) != 0)
    {
      return false;
    }
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, bytes.data() + sizeof(Magic), sizeof(checksum));
    if (checksum != vtkMTFileFormat::Checksum(bytes.data() + place, bytes.size() - place))
    {
      return false;
    }
    std::uint64_t names = 0;
    bool isSound = TakeNumber(bytes, place, names);
    for (std::uint64_t i = 0; isSound && i < names; ++i)
    {
      std::uint64_t length = 0;
      isSound = TakeNumber(bytes, place, length) && bytes.size() - place >= length;
      if (isSound)
      {
        this->InState.emplace(reinterpret_cast<const char*>(bytes.data()) + place, static_cast<std::size_t>(length));
        place += static_cast<std::size_t>(length);
      }
    }
    state.assign(bytes.begin() + static_cast<std::ptrdiff_t>(isSound ? place : bytes.size()), bytes.end());
    return isSound;
  }

  bool WriteState(const std::vector<unsigned char>& state, std::string& error) const
  {
    std::vector<unsigned char> body;
    PutNumber(body, this->Named.size());
    for (const auto& [name, file] : this->Named)
    {
      PutNumber(body, name.size());
      Put(body, name.data(), name.size());
    }
    Put(body, state.data(), state.size());
    std::vector<unsigned char> head;
    Put(head, Magic, sizeof(Magic));
    PutNumber(head, vtkMTFileFormat::Checksum(body.data(), body.size()));

    const std::string path = this->GetStatePath();
    const std::string fresh = path + ".new";
    const int descriptor = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const bool written = descriptor >= 0 && vtkMTPosix::WriteAll(descriptor, head.data(), head.size()) &&
      vtkMTPosix::WriteAll(descriptor, body.data(), body.size()) && ::fsync(descriptor) == 0;
    error = written ? error : Describe(fresh, "writing the checkpoint failed");
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
    if (written && ::rename(fresh.c_str(), path.c_str()) != 0)
    {
      error = Describe(path, "the checkpoint cannot be put in place");
      return false;
    }
    if (!written)
    {
      ::unlink(fresh.c_str());
    }
    return written && SyncFolder(this->Folder, error);
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
    error = Describe(folder, "the folder for temporary files cannot be made");
    return false;
  }
  const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock < 0 || ::access(folder.c_str(), W_OK) != 0)
  {
    error = Describe(folder, "the folder for temporary files cannot be used");
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
  return fs::exists(folder + "/state", code);
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

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::CreateBeside(const std::string& path, std::string& error)
{
  return CreateNameless(vtkMTPosix::FolderOf(path), std::make_shared<Account>(), error);
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::Create(std::string& error)
{
  return CreateNameless(this->Implementation->Folder + "/", this->Implementation->Holder, error);
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
    error = Describe(path, "a temporary file cannot be created");
    return nullptr;
  }
  const auto file = std::make_shared<File>(path, descriptor, own.Holder);
  own.Named.emplace(name, file);
  return std::make_unique<FileSpool>(file);
}

std::unique_ptr<vtkMTSpool> vtkMTFileSpoolStore::Open(const std::string& name, std::uint64_t size, std::string& error)
{
  Internals& own = *this->Implementation;
  const std::string path = own.GetPath(name);
  const auto known = own.Named.find(name);
  if (known != own.Named.end())
  {
    if (known->second->Size != size)
    {
      error = path + ": has " + std::to_string(known->second->Size) + " bytes and should have " + std::to_string(size);
      return nullptr;
    }
    return std::make_unique<FileSpool>(known->second);
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
  const auto file = std::make_shared<File>(path, descriptor, own.Holder);
  file->Size = size;
  own.Holder->Add(size);
  own.Named.emplace(name, file);
  return std::make_unique<FileSpool>(file);
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
  for (const auto& [name, file] : own.Named)
  {
    if (file->IsDirty && ::fsync(file->Descriptor) != 0)
    {
      error = Describe(file->Name, "cannot be made durable");
      return false;
    }
    file->IsDirty = false;
  }
  if (!SyncFolder(own.Folder, error) || !own.WriteState(state, error))
  {
    return false;
  }
  own.HasCommitted = true;
  own.InState.clear();
  for (const auto& [name, file] : own.Named)
  {
    own.InState.insert(name);
  }
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
    std::vector<unsigned char> bytes;
    if (!ReadWhole(own.GetStatePath(), bytes, error))
    {
      return false;
    }
    if (!own.Parse(bytes, state))
    {
      error = own.GetStatePath() + ": the checkpoint is damaged; delete the folder and build anew";
      return false;
    }
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
  ::unlink(own.GetStatePath().c_str());
  ::unlink((own.GetStatePath() + ".new").c_str());
  own.Named.clear();
  own.InState.clear();
  own.Doomed.clear();
  own.RemoveStrays();
  own.HasCommitted = false;
  ::rmdir(own.Folder.c_str());
}

std::uint64_t vtkMTFileSpoolStore::GetSize() const
{
  return this->Implementation->Holder->Size;
}

std::uint64_t vtkMTFileSpoolStore::GetLargestSize() const
{
  return this->Implementation->Holder->Largest;
}
