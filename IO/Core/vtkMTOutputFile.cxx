// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOutputFile.h"

#include "vtkMTPosix.h"

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
bool SyncFolder(const std::string& folder)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return false;
  }
  const bool done = ::fsync(descriptor) == 0 || errno == EINVAL; // some file systems cannot sync a folder
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return done;
}
}

vtkMTOutputFile::vtkMTOutputFile() = default;

vtkMTOutputFile::~vtkMTOutputFile()
{
  this->Abandon();
}

bool vtkMTOutputFile::Fail(const std::string& what)
{
  const int reason = errno;
  this->Error = this->Path + ": " + what + ": " + std::strerror(reason);
  this->Abandon();
  return false;
}

bool vtkMTOutputFile::Open(const std::string& path)
{
  this->Abandon();
  this->Error.clear();
  this->Path = path;
  this->Target = path;
  this->Written = 0;
  struct stat status;
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (path.empty() || (exists && !S_ISREG(status.st_mode)))
  {
    this->Error = path.empty() ? "no output file name given" : path + ": exists and is not a regular file";
    return false;
  }
  if (exists)
  {
    char* resolved = ::realpath(path.c_str(), nullptr);
    this->Target = resolved ? resolved : path;
    std::free(resolved);
  }
  this->Descriptor = vtkMTPosix::CreateUnique(this->Target, this->Temporary);
  if (this->Descriptor < 0)
  {
    this->Temporary.clear();
    return this->Fail("cannot be created");
  }
  if (exists && ::fchmod(this->Descriptor, status.st_mode & 0777) != 0)
  {
    return this->Fail("cannot be given the earlier file's permissions");
  }
  return true;
}

bool vtkMTOutputFile::Write(const void* data, std::size_t size)
{
  if (this->Descriptor < 0)
  {
    return false;
  }
  if (!vtkMTPosix::WriteAll(this->Descriptor, data, size))
  {
    return this->Fail("writing failed after " + std::to_string(this->Written) + " bytes");
  }
  this->Written += size;
  return true;
}

bool vtkMTOutputFile::Commit()
{
  if (this->Descriptor < 0)
  {
    return false;
  }
  if (::fsync(this->Descriptor) != 0)
  {
    return this->Fail("writing failed");
  }
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  if (::close(descriptor) != 0)
  {
    return this->Fail("writing failed");
  }
  if (std::rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    return this->Fail("cannot be put in place");
  }
  this->Temporary.clear();
  if (!SyncFolder(vtkMTPosix::FolderOf(this->Target)))
  {
    this->Error = this->Path + ": was written, but its folder cannot be made durable: " + std::strerror(errno);
    return false;
  }
  return true;
}

void vtkMTOutputFile::Abandon()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
    this->Descriptor = -1;
  }
  if (!this->Temporary.empty())
  {
    ::unlink(this->Temporary.c_str());
    this->Temporary.clear();
  }
}

void vtkMTOutputFile::RemoveStrays(const std::string& path, bool ownToo)
{
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::path resolved = fs::weakly_canonical(path, code);
  const fs::path target = code ? fs::path(path) : resolved;
  const std::string begin = target.filename().string() + "."; // and the process, as vtkMTPosix::CreateUnique names it
  std::vector<fs::path> strays;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), code))
  {
    const std::string name = entry.path().filename().string();
    long process = 0;
    int number = 0;
    int length = 0;
    const bool isTemporary = name.compare(0, begin.size(), begin) == 0 &&
      std::sscanf(name.c_str() + begin.size(), "%ld-%d.tmp%n", &process, &number, &length) == 2 &&
      begin.size() + static_cast<std::size_t>(length) == name.size() && process > 0;
    const bool isOwn = isTemporary && process == ::getpid();
    const bool isDead = isTemporary && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
    if (isDead || (isOwn && ownToo))
    {
      strays.push_back(entry.path());
    }
  }
  for (const fs::path& stray : strays)
  {
    fs::remove(stray, code);
  }
}
