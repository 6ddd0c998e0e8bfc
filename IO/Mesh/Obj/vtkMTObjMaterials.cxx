// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjMaterials.h"

#include "vtkMTFileBeside.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkMTTextFormat::NextToken;

std::string Trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

bool IsNumber(std::string_view token)
{
  double value = 0.0;
  return vtkMTTextFormat::ToNumber(token, value);
}

// What follows the options: -s 1 1 1 -clamp on "name with blanks.png".
std::string SkipOptions(std::string_view line)
{
  std::string_view rest = line;
  for (std::string_view token = NextToken(rest); !token.empty() && token[0] == '-'; token = NextToken(rest))
  {
    std::string_view after = rest;
    const bool takesNumbers = token == "-o" || token == "-s" || token == "-t" || token == "-mm";
    NextToken(after);
    rest = after;
    for (int i = 0; takesNumbers && i < 2; ++i)
    {
      std::string_view next = after;
      if (!IsNumber(NextToken(next)))
      {
        break;
      }
      rest = after = next;
    }
    line = rest;
  }
  return Trim(line);
}

// Kd r g b, or r alone for all three; spectral curves are no colour here.
void ReadColor(std::string_view line, vtkMTObjMaterials::Material& material)
{
  vtkMTIdNames::Color color = {};
  std::size_t count = 0;
  while (count < 3 && vtkMTTextFormat::ToNumber(NextToken(line), color[count]) && std::isfinite(color[count]))
  {
    color[count] = std::min(std::max(color[count], 0.0), 1.0);
    ++count;
  }
  if (count == 1)
  {
    color[1] = color[2] = color[0];
  }
  if (count == 1 || count == 3)
  {
    material.Color = color;
    material.HasColor = true;
  }
}

void ReadLibrary(const vtkMTByteSource& source, std::map<std::string, vtkMTObjMaterials::Material>& materials)
{
  vtkMTTextFormat::Stream stream(source);
  stream.SkipByteOrderMark();
  vtkMTObjMaterials::Material* material = nullptr;
  for (std::string_view line; stream.TakeLine(line);)
  {
    const std::string keyword = vtkMTTextFormat::ToLower(NextToken(line));
    if (keyword == "newmtl")
    {
      const auto inserted = materials.emplace(Trim(line), vtkMTObjMaterials::Material());
      material = inserted.second ? &inserted.first->second : nullptr;
    }
    else if (keyword == "kd" && material)
    {
      ReadColor(line, *material);
    }
    else if (keyword == "map_kd" && material && material->Image.empty())
    {
      material->Image = SkipOptions(line);
    }
  }
}
}

std::map<std::string, vtkMTObjMaterials::Material> vtkMTObjMaterials::Read(
  const std::string& mesh, const std::vector<std::string>& libraries, std::vector<std::string>& problems)
{
  std::map<std::string, Material> materials;
  const auto read = [&](const std::string& name)
  {
    std::string error;
    const auto source = vtkMTFileByteSource::Open(vtkMTFileBeside::FindBeside(mesh, name), error);
    if (source)
    {
      ReadLibrary(*source, materials);
    }
    else
    {
      problems.push_back("material library " + name + ": " + error);
    }
  };
  for (const std::string& line : libraries)
  {
    std::string_view names = line;
    const bool isOne = vtkMTFileBeside::IsFile(vtkMTFileBeside::FindBeside(mesh, line)) ||
      Trim(line).find_first_of(" \t") == std::string::npos;
    for (std::string_view name = isOne ? names : NextToken(names); !name.empty(); name = NextToken(names))
    {
      read(std::string(name));
      names = isOne ? std::string_view() : names;
    }
  }
  return materials;
}

void vtkMTObjMaterials::SetTable(
  vtkDataArray* ids, const std::vector<std::string>& names, const std::map<std::string, Material>& materials)
{
  std::vector<vtkMTIdNames::Color> colors;
  bool hasColors = false;
  for (const std::string& name : names)
  {
    const auto found = materials.find(name);
    const Material material = found == materials.end() ? Material() : found->second;
    hasColors = hasColors || material.HasColor;
    colors.push_back(material.Color);
  }
  vtkMTIdNames::Set(ids, names, hasColors ? colors : std::vector<vtkMTIdNames::Color>());
}
