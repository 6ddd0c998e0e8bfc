// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshFormat.h"

#include "vtkMTTextFormat.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
using namespace vtkMTMeshFormat;

bool BeginsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

bool IsOff(std::string_view begin)
{
  const std::string_view word = vtkMTTextFormat::NextToken(begin);
  static const char* const words[] = { "OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCOFF", "STNOFF", "STCNOFF" };
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

FormatType FromContent(std::string_view begin)
{
  begin.remove_prefix(vtkMTTextFormat::GetByteOrderMarkSize(begin));
  if (BeginsWith(begin, "ply\n") || BeginsWith(begin, "ply\r") || BeginsWith(begin, "ply "))
  {
    return Ply;
  }
  if (BeginsWith(begin, "glTF"))
  {
    return Glb;
  }
  if (BeginsWith(begin, "# vtk DataFile"))
  {
    return Legacy;
  }
  if (BeginsWith(begin, "LASF") || BeginsWith(begin, "ASTM-E57") || BeginsWith(begin, "# .PCD"))
  {
    return Points;
  }
  return begin.find("<VTKFile") != std::string_view::npos ? Xml : IsOff(begin) ? Off : Unknown;
}

FormatType FromEnding(const std::string& ending)
{
  static const std::pair<const char*, FormatType> formats[] = { { "ply", Ply }, { "stl", Stl }, { "obj", Obj },
    { "off", Off }, { "coff", Off }, { "noff", Off }, { "vtp", Xml }, { "vtu", Xml }, { "vtm", Xml }, { "vts", Xml },
    { "vtr", Xml }, { "vtk", Legacy }, { "gltf", Gltf }, { "glb", Glb }, { "las", Points }, { "laz", Points },
    { "xyz", Points }, { "pts", Points }, { "ptx", Points }, { "pcd", Points }, { "e57", Points }, { "asc", Points } };
  const auto found = std::find_if(
    std::begin(formats), std::end(formats), [&ending](const auto& format) { return ending == format.first; });
  return found == std::end(formats) ? Unknown : found->second;
}
}

FormatType vtkMTMeshFormat::Find(std::string_view begin, const std::string& path)
{
  const FormatType format = FromContent(begin);
  return format == Unknown ? FromEnding(GetEnding(path)) : format;
}

std::string vtkMTMeshFormat::GetEnding(const std::string& path)
{
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  return ending == "gz" ? vtkMTTextFormat::GetLowerCaseEnding(path.substr(0, path.size() - 3)) : ending;
}
