// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolState.h"

#include "vtkMTBytes.h"
#include "vtkMTChecksum.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTPosix.h"
#include "vtkMTSpoolFile.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace
{
constexpr char Magic[8] = { 'M', 'T', 's', 't', 'a', 't', 'e', '1' };
constexpr std::size_t HeadSize = sizeof(Magic) + sizeof(std::uint64_t); // and a checksum of all that follows

bool Parse(const std::vector<unsigned char>& file, std::vector<std::string>& names, std::vector<unsigned char>& bytes)
{
  std::uint64_t checksum = 0;
  if (file.size() < HeadSize || std::memcmp(file.data(), Magic, sizeof(Magic)) != 0)
  {
    return false;
  }
  std::memcpy(&checksum, file.data() + sizeof(Magic), sizeof(checksum));
  if (checksum != vtkMTChecksum(file.data() + HeadSize, file.size() - HeadSize))
  {
    return false;
  }
  const std::vector<unsigned char> body(file.begin() + static_cast<std::ptrdiff_t>(HeadSize), file.end());
  vtkMTBytes::Reader reader(body);
  for (auto count = reader.Take<std::uint64_t>(); count > 0 && reader.IsSound(); --count)
  {
    names.push_back(reader.TakeText());
  }
  reader.TakeList(bytes);
  return reader.IsSound() && reader.IsAtEnd();
}
}

namespace vtkMTSpoolState
{
std::string GetPath(const std::string& folder)
{
  return folder + "/state";
}

bool SyncFolder(const std::string& folder, std::string& error)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Some file systems cannot sync a folder.
  const bool done = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  if (!done)
  {
    error = vtkMTSpoolFile::Describe(folder, "cannot be made durable");
  }
  if (descriptor >= 0)
  {
    ::close(descriptor);
  }
  return done;
}

bool Write(const std::string& folder, const std::vector<std::string>& names, const std::vector<unsigned char>& bytes,
  std::string& error)
{
  std::vector<unsigned char> body;
  vtkMTBytes::Writer writer(body);
  writer.Put<std::uint64_t>(names.size());
  for (const std::string& name : names)
  {
    writer.PutText(name);
  }
  writer.PutList(bytes);
  unsigned char head[HeadSize];
  const std::uint64_t checksum = vtkMTChecksum(body.data(), body.size());
  std::memcpy(head, Magic, sizeof(Magic));
  std::memcpy(head + sizeof(Magic), &checksum, sizeof(checksum));

  const std::string path = GetPath(folder);
  const std::string fresh = path + ".new";
  const int descriptor = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const bool written = descriptor >= 0 && vtkMTPosix::WriteAll(descriptor, head, sizeof(head)) &&
    vtkMTPosix::WriteAll(descriptor, body.data(), body.size()) && ::fsync(descriptor) == 0;
  error = written ? error : vtkMTSpoolFile::Describe(fresh, "writing the checkpoint failed");
  if (descriptor >= 0)
  {
    ::close(descriptor);
  }
  if (written && std::rename(fresh.c_str(), path.c_str()) != 0)
  {
    error = vtkMTSpoolFile::Describe(path, "the checkpoint cannot be put in place");
    return false;
  }
  if (!written)
  {
    ::unlink(fresh.c_str());
  }
  return written && SyncFolder(folder, error);
}

bool Read(
  const std::string& folder, std::vector<std::string>& names, std::vector<unsigned char>& bytes, std::string& error)
{
  const auto file = vtkMTFileByteSource::Open(GetPath(folder), error);
  if (!file)
  {
    return false;
  }
  std::vector<unsigned char> read(static_cast<std::size_t>(file->GetSize()));
  if (!file->Read(0, read.size(), read.data(), error))
  {
    return false;
  }
  names.clear();
  const bool isSound = Parse(read, names, bytes);
  error = isSound ? error : GetPath(folder) + ": the checkpoint is damaged; delete the folder and build anew";
  return isSound;
}
}
