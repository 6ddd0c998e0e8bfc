// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileBeside.h"

#include "vtkMTTextFormat.h"

#include <algorithm>
#include <filesystem>

namespace
{
std::string WithoutQuotes(const std::string& name)
{
  const bool isQuoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
  return isQuoted ? name.substr(1, name.size() - 2) : name;
}

// One of the folder's files whose name differs in case alone: the first of them in order, or none.
std::string FindInAnyCase(const std::filesystem::path& wanted)
{
  std::error_code code;
  std::string found;
  const std::string name = vtkMTTextFormat::ToLower(wanted.filename().string());
  const std::filesystem::path folder = wanted.has_parent_path() ? wanted.parent_path() : std::filesystem::path(".");
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
  {
    const std::string path = (wanted.parent_path() / entry->path().filename()).string();
    if (vtkMTTextFormat::ToLower(entry->path().filename().string()) == name && (found.empty() || path < found))
    {
      found = path;
    }
  }
  return found;
}
}

bool vtkMTFileBeside::IsFile(const std::string& path)
{
  std::error_code code;
  return std::filesystem::is_regular_file(path, code);
}

std::string vtkMTFileBeside::FindBeside(const std::string& mesh, std::string name)
{
  name = WithoutQuotes(name);
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path folder = std::filesystem::path(mesh).parent_path();
  const std::filesystem::path wanted(name);
  const bool leadsAway = wanted.is_absolute() || name.find(':') != std::string::npos ||
    std::find(wanted.begin(), wanted.end(), "..") != wanted.end();
  const std::filesystem::path beside = folder / wanted.filename();
  if (!leadsAway && IsFile(folder / wanted))
  {
    return (folder / wanted).string();
  }
  const std::string found = IsFile(beside) ? "" : FindInAnyCase(beside);
  return found.empty() ? beside.string() : found;
}
