// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileByteSource.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

vtkMTFileByteSource::vtkMTFileByteSource(const std::string& path, int descriptor, std::uint64_t size)
  : Path(path)
  , Descriptor(descriptor)
  , Size(size)
{
}

vtkMTFileByteSource::~vtkMTFileByteSource()
{
  ::close(this->Descriptor);
}

std::unique_ptr<vtkMTFileByteSource> vtkMTFileByteSource::Open(const std::string& path, std::string& error)
{
  // O_NONBLOCK: a named pipe must be refused, not waited for.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0)
  {
    error = path + ": cannot be opened: " + std::strerror(errno);
    return nullptr;
  }
  struct stat status;
  if (::fstat(descriptor, &status) != 0)
  {
    error = path + ": cannot be examined: " + std::strerror(errno);
    ::close(descriptor);
    return nullptr;
  }
  if (!S_ISREG(status.st_mode))
  {
    error = path + ": is not a regular file";
    ::close(descriptor);
    return nullptr;
  }
  return std::unique_ptr<vtkMTFileByteSource>(
    new vtkMTFileByteSource(path, descriptor, static_cast<std::uint64_t>(status.st_size)));
}

bool vtkMTFileByteSource::Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const
{
  if (offset > this->Size || count > this->Size - offset)
  {
    error = this->Path + ": bytes " + std::to_string(offset) + " to " + std::to_string(offset + count) +
      " lie beyond the end at " + std::to_string(this->Size);
    return false;
  }
  constexpr std::size_t largestRead = std::size_t(1) << 30; // the kernel reads less than 2 GiB at a time
  unsigned char* to = static_cast<unsigned char*>(destination);
  while (count > 0)
  {
    const ssize_t got = ::pread(this->Descriptor, to, std::min(count, largestRead), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      error = this->Path + ": reading at byte " + std::to_string(offset) +
        " failed: " + (got == 0 ? "the file has become shorter" : std::strerror(errno));
      return false;
    }
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
  return true;
}
