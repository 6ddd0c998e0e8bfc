// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputFiles.h"

#include "vtkMTBuildError.h"
#include "vtkMTFileByteSource.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include <sys/stat.h>
#include <xxhash.h>

namespace
{
std::string ToText(std::uint64_t hash)
{
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}
}

vtkMTInputFiles::State vtkMTInputFiles::Look(const std::string& path)
{
  State state;
  state.Path = path;
  struct stat status;
  if (::stat(path.c_str(), &status) == 0)
  {
    state.Size = static_cast<std::uint64_t>(status.st_size);
    state.Time = static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec;
    state.File = static_cast<std::uint64_t>(status.st_ino);
  }
  return state;
}

vtkMTInputFiles::vtkMTInputFiles(const std::vector<std::string>& paths)
{
  std::transform(paths.begin(), paths.end(), std::back_inserter(this->Files), Look);
}

std::string vtkMTInputFiles::FindChanged() const
{
  const auto changed =
    std::find_if(this->Files.begin(), this->Files.end(), [](const State& file) { return !(Look(file.Path) == file); });
  return changed == this->Files.end() ? "" : changed->Path;
}

bool vtkMTInputFiles::GetHash(const std::function<bool()>& goesOn, std::string& hash, vtkMTBuildError& error) const
{
  constexpr std::size_t blockSize = std::size_t(1) << 20;
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(state.get());
  std::vector<unsigned char> block(blockSize);
  std::string reason;
  for (const State& file : this->Files)
  {
    const auto bytes = vtkMTFileByteSource::Open(file.Path, reason);
    const std::uint64_t size = bytes ? bytes->GetSize() : 0;
    XXH3_64bits_update(state.get(), &size, sizeof(size)); // where one file ends and the next begins
    for (std::uint64_t place = 0; reason.empty() && place < size; place += blockSize)
    {
      if (!goesOn())
      {
        return error.Fail(vtkMultiTriangulationFileBuilder::AbortError, "aborted");
      }
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(blockSize, size - place));
      if (bytes->Read(place, count, block.data(), reason))
      {
        XXH3_64bits_update(state.get(), block.data(), count);
      }
    }
    if (!reason.empty())
    {
      return error.Fail(vtkErrorCode::CannotOpenFileError, reason);
    }
  }
  hash = ToText(XXH3_64bits_digest(state.get()));
  return true;
}

std::string vtkMTInputFiles::GetHash(const std::string& text)
{
  return ToText(XXH3_64bits(text.data(), text.size()));
}
