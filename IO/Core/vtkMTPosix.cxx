// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPosix.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

namespace vtkMTPosix
{
std::string FolderOf(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

int CreateUnique(const std::string& prefix, std::string& name)
{
  // Not mkstemp: its files are private, and an output must get the permissions that the user's umask gives.
  static std::atomic<unsigned> counter{ 0 };
  for (int attempt = 0; attempt < 1000; ++attempt)
  {
    name = prefix + "." + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
    const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST)
    {
      return descriptor;
    }
  }
  return -1;
}

bool WriteAll(int descriptor, const void* data, std::size_t size)
{
  constexpr std::size_t largestWrite = std::size_t(1) << 30; // the kernel writes less than 2 GiB at a time
  const unsigned char* from = static_cast<const unsigned char*>(data);
  while (size > 0)
  {
    const ssize_t written = ::write(descriptor, from, std::min(size, largestWrite));
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      errno = written == 0 ? ENOSPC : errno;
      return false;
    }
    from += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

std::uint64_t GetMachineMemory()
{
  const auto pages = static_cast<std::uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
  const std::uint64_t machine = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  std::ifstream file("/sys/fs/cgroup/memory.max"); // "max" where there is no limit
  std::uint64_t group = 0;
  return file >> group && group > 0 ? std::min(machine, group) : machine;
}
}
