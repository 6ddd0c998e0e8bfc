// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTemporaryFile.h"

#include "vtkMTPosix.h"

#include <cerrno>
#include <cstring>

#include <unistd.h>

vtkMTTemporaryFile::vtkMTTemporaryFile() = default;

vtkMTTemporaryFile::~vtkMTTemporaryFile()
{
  this->Close();
}

bool vtkMTTemporaryFile::OpenBeside(const std::string& path)
{
  this->Close();
  this->Error.clear();
  this->Folder = vtkMTPosix::FolderOf(path);
  std::string name;
  this->Descriptor = vtkMTPosix::CreateUnique(this->Folder + ".multitriangulation", name);
  if (this->Descriptor < 0)
  {
    this->Error = this->Folder + ": a temporary file cannot be created: " + std::strerror(errno);
    return false;
  }
  ::unlink(name.c_str());
  return true;
}

bool vtkMTTemporaryFile::Append(const void* data, std::size_t size)
{
  if (this->Descriptor < 0 || !vtkMTPosix::WriteAll(this->Descriptor, data, size))
  {
    this->Error = this->Folder + ": writing a temporary file failed after " + std::to_string(this->Size) +
      " bytes: " + std::strerror(errno);
    return false;
  }
  this->Size += size;
  return true;
}

bool vtkMTTemporaryFile::Read(std::uint64_t offset, std::size_t count, void* destination)
{
  unsigned char* to = static_cast<unsigned char*>(destination);
  while (count > 0)
  {
    const ssize_t got = ::pread(this->Descriptor, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      this->Error = this->Folder + ": reading a temporary file failed at byte " + std::to_string(offset) + ": " +
        (got == 0 ? "it is too short" : std::strerror(errno));
      return false;
    }
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

void vtkMTTemporaryFile::Close()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
  this->Descriptor = -1;
  this->Size = 0;
}
