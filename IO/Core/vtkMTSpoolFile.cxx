// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolFile.h"

#include "vtkMTPosix.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

void vtkMTSpoolAccount::Add(std::uint64_t size)
{
  this->Size += size;
  this->Largest = std::max(this->Largest, this->Size.load());
}

vtkMTSpoolFile::vtkMTSpoolFile(std::string name, int descriptor, std::shared_ptr<vtkMTSpoolAccount> account)
  : Name(std::move(name))
  , Descriptor(descriptor)
  , Account(std::move(account))
{
}

vtkMTSpoolFile::~vtkMTSpoolFile()
{
  ::close(this->Descriptor);
  this->Account->Size -= this->Size;
}

std::string vtkMTSpoolFile::Describe(const std::string& name, const std::string& what)
{
  return name + ": " + what + ": " + std::strerror(errno);
}

void vtkMTSpoolFile::SetSize(std::uint64_t size)
{
  this->Size = size;
  this->Account->Add(size);
}

bool vtkMTSpoolFile::Append(const unsigned char* data, std::size_t size, std::string& error)
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
    this->Account->Add(static_cast<std::uint64_t>(written));
    this->IsDirty = true;
  }
  return true;
}

bool vtkMTSpoolFile::Read(std::uint64_t offset, std::size_t size, unsigned char* to, std::string& error) const
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

bool vtkMTSpoolFile::Sync(std::string& error)
{
  if (this->IsDirty && ::fsync(this->Descriptor) != 0)
  {
    error = Describe(this->Name, "cannot be made durable");
    return false;
  }
  this->IsDirty = false;
  return true;
}

std::unique_ptr<vtkMTSpool> vtkMTSpoolFile::CreateNameless(
  const std::string& folder, const std::shared_ptr<vtkMTSpoolAccount>& account, std::string& error)
{
  // Where the file system can, it never has a name, and nothing is left whenever the process is killed.
  int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor < 0 && errno != ENOENT)
  {
    std::string name;
    descriptor = vtkMTPosix::CreateUnique(folder + ".multitriangulation", name);
    ::unlink(name.c_str());
  }
  if (descriptor < 0)
  {
    error = Describe(folder, "a temporary file cannot be created");
    return nullptr;
  }
  return std::make_unique<vtkMTFileSpool>(std::make_shared<vtkMTSpoolFile>(folder, descriptor, account));
}
