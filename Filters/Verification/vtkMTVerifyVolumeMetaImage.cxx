// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeMetaImage.h"

#include "vtkMTVerifyVolumeBytes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
constexpr std::size_t MostHeader = std::size_t(1) << 22;

struct NamedType
{
  const char* Name;
  int Type;
};

/// A "long" of MetaImage has 4 bytes in the file, whatever it has in memory.
constexpr NamedType Types[] = { { "MET_CHAR", VTK_TYPE_INT8 }, { "MET_UCHAR", VTK_TYPE_UINT8 },
  { "MET_SHORT", VTK_TYPE_INT16 }, { "MET_USHORT", VTK_TYPE_UINT16 }, { "MET_INT", VTK_TYPE_INT32 },
  { "MET_UINT", VTK_TYPE_UINT32 }, { "MET_LONG", VTK_TYPE_INT32 }, { "MET_ULONG", VTK_TYPE_UINT32 },
  { "MET_LONG_LONG", VTK_TYPE_INT64 }, { "MET_ULONG_LONG", VTK_TYPE_UINT64 }, { "MET_FLOAT", VTK_TYPE_FLOAT32 },
  { "MET_DOUBLE", VTK_TYPE_FLOAT64 } };
}

vtkMTVerifyVolumeMetaImage::vtkMTVerifyVolumeMetaImage(const std::string& path, vtkMTVerifyVolumeHeader& header)
  : Path(path)
  , Header(header)
{
}

bool vtkMTVerifyVolumeMetaImage::Parse(std::string& error)
{
  this->Header.Facts.Reader = "the checker's MetaImage reader";
  return this->ReadTags(error) && this->ParseSizes(error) && this->ParseType(error) && this->ParsePlace(error) &&
    this->ParseData(error);
}

bool vtkMTVerifyVolumeMetaImage::ReadTags(std::string& error)
{
  Bytes bytes;
  if (!ReadFile(this->Path, bytes, error, MostHeader))
  {
    return false;
  }
  const std::string text(bytes.begin(), bytes.end());
  std::size_t at = 0;
  bool isLast = false;
  while (at < text.size() && !isLast)
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    const std::size_t equals = std::min(line.find('='), line.find(':'));
    if (equals == std::string::npos)
    {
      continue;
    }
    const std::string name = ToLower(Trim(line.substr(0, equals)));
    this->Tags.emplace(name, Trim(line.substr(equals + 1)));
    isLast = name == "elementdatafile";
  }
  if (!isLast)
  {
    error = "its header has no ElementDataFile";
    return false;
  }
  this->End = static_cast<std::int64_t>(at);
  while (at < text.size() && this->Lines.size() < 100000)
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    this->Lines.push_back(Trim(text.substr(at, end - at)));
    at = end + 1;
  }
  return true;
}

std::string vtkMTVerifyVolumeMetaImage::Find(const std::vector<std::string>& names, const std::string& otherwise) const
{
  for (const std::string& name : names)
  {
    const auto found = this->Tags.find(name);
    if (found != this->Tags.end())
    {
      return found->second;
    }
  }
  return otherwise;
}

bool vtkMTVerifyVolumeMetaImage::FindNumbers(
  const std::vector<std::string>& names, std::size_t count, std::vector<double>& numbers, std::string& error) const
{
  const std::string text = this->Find(names);
  numbers.clear();
  if (text.empty())
  {
    return true;
  }
  if (!ToNumbers(Split(text), numbers) || numbers.size() < count ||
    !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
  {
    error = names.front() + " must be " + std::to_string(count) + " numbers, and is: " + text;
    return false;
  }
  return true;
}

bool vtkMTVerifyVolumeMetaImage::IsTrue(const std::vector<std::string>& names) const
{
  const std::string text = ToLower(this->Find(names));
  return !text.empty() && (text[0] == 't' || text[0] == 'y' || text[0] == '1');
}

bool vtkMTVerifyVolumeMetaImage::ParseSizes(std::string& error)
{
  std::vector<double> dimensions, sizes;
  if (!this->FindNumbers({ "ndims" }, 1, dimensions, error))
  {
    return false;
  }
  if (dimensions.empty() || dimensions[0] < 1 || dimensions[0] > 10)
  {
    error = "NDims must be 1 to 10";
    return false;
  }
  this->NDims = static_cast<std::size_t>(dimensions[0]);
  if (!this->FindNumbers({ "dimsize" }, this->NDims, sizes, error))
  {
    return false;
  }
  std::vector<std::int64_t> whole;
  for (std::size_t i = 0; i < std::min(this->NDims, sizes.size()); ++i)
  {
    whole.push_back(std::abs(sizes[i]) < 1e15 ? static_cast<std::int64_t>(sizes[i]) : 0);
  }
  return this->Header.SetSizes(whole, error);
}

bool vtkMTVerifyVolumeMetaImage::ParseType(std::string& error)
{
  std::vector<double> channels, slope, offset;
  if (!this->FindNumbers({ "elementnumberofchannels" }, 1, channels, error) ||
    !this->FindNumbers({ "elementtointensityfunctionslope" }, 1, slope, error) ||
    !this->FindNumbers({ "elementtointensityfunctionoffset" }, 1, offset, error))
  {
    return false;
  }
  if (!channels.empty() && channels[0] != 1)
  {
    return this->Header.Refuse("MetaImage of several channels", error);
  }
  this->Header.Slope = slope.empty() ? 1.0 : slope[0];
  this->Header.Intercept = offset.empty() ? 0.0 : offset[0];
  const std::string name = this->Find({ "elementtype" });
  for (const NamedType& type : Types)
  {
    if (ToLower(name) == ToLower(type.Name))
    {
      this->Header.Type = type.Type;
      return true;
    }
  }
  return this->Header.Refuse("ElementType " + name, error);
}

bool vtkMTVerifyVolumeMetaImage::ParsePlace(std::string& error)
{
  const std::size_t n = this->NDims;
  std::vector<double> matrix, offset, spacing, size, centre;
  if (!this->FindNumbers({ "transformmatrix", "rotation", "orientation" }, n * n, matrix, error) ||
    !this->FindNumbers({ "offset", "position", "origin" }, n, offset, error) ||
    !this->FindNumbers({ "elementspacing" }, n, spacing, error) ||
    !this->FindNumbers({ "elementsize" }, n, size, error) ||
    !this->FindNumbers({ "centerofrotation" }, n, centre, error))
  {
    return false;
  }
  const std::vector<double>& steps = spacing.empty() ? size : spacing;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double direction[3] = { axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0 };
    for (std::size_t i = 0; i < 3 && !matrix.empty(); ++i)
    {
      direction[i] = matrix[n * axis + i];
    }
    const double step = steps.empty() ? 1.0 : steps[axis];
    this->Header.SetAxis(static_cast<int>(axis), step * direction[0], step * direction[1], step * direction[2]);
  }
  if (!offset.empty())
  {
    this->Header.SetOrigin(offset[0], offset[1], offset[2]);
  }
  if (std::any_of(centre.begin(), centre.end(), [](double x) { return x != 0.0; }))
  {
    this->Header.Facts.Notes.emplace_back("CenterOfRotation is ignored: Offset is the place of the first sample.");
  }
  this->Header.Facts.Frame = this->Find({ "anatomicalorientation" });
  return true;
}

bool vtkMTVerifyVolumeMetaImage::ParseData(std::string& error)
{
  vtkMTVerifyVolumeHeader& header = this->Header;
  header.IsBigEndian = this->IsTrue({ "binarydatabyteordermsb", "elementbyteordermsb" });
  const bool isBinary = this->Find({ "binarydata" }).empty() || this->IsTrue({ "binarydata" });
  const bool isCompressed = this->IsTrue({ "compresseddata" });
  header.Encoding = !isBinary ? vtkMTVerifyVolumeHeader::Encodings::Ascii
    : isCompressed            ? vtkMTVerifyVolumeHeader::Encodings::Deflate
                              : vtkMTVerifyVolumeHeader::Encodings::Raw;
  if (!this->ParseFiles(this->Find({ "elementdatafile" }), error))
  {
    return false;
  }
  std::vector<double> skip;
  if (!this->FindNumbers({ "headersize" }, 1, skip, error))
  {
    return false;
  }
  if (!skip.empty() && skip[0] < 0)
  {
    if (header.Encoding != vtkMTVerifyVolumeHeader::Encodings::Raw)
    {
      return header.Refuse("HeaderSize -1 of compressed data", error);
    }
    header.ByteSkip = -1;
  }
  else if (!skip.empty())
  {
    for (vtkMTVerifyVolumeHeader::DataFile& file : header.Files)
    {
      file.Offset += static_cast<std::int64_t>(skip[0]);
    }
  }
  return true;
}

bool vtkMTVerifyVolumeMetaImage::ParseFiles(const std::string& text, std::string& error)
{
  std::vector<std::string> names;
  const std::vector<std::string> words = Split(text);
  if (ToLower(text) == "local")
  {
    this->Header.Files.push_back({ this->Path, this->End });
    return true;
  }
  if (!words.empty() && words[0] == "LIST")
  {
    for (const std::string& line : this->Lines)
    {
      if (!line.empty())
      {
        names.push_back(line);
      }
    }
  }
  else if (words.size() > 1 && words[0].find('%') != std::string::npos)
  {
    std::vector<double> range;
    const bool areNumbers = ToNumbers({ words.begin() + 1, words.end() }, range);
    const std::int64_t first = range.empty() ? 1 : static_cast<std::int64_t>(range[0]);
    const std::int64_t step = range.size() > 2 ? static_cast<std::int64_t>(range[2]) : 1;
    const std::int64_t last =
      range.size() > 1 ? static_cast<std::int64_t>(range[1]) : first + step * (this->Header.Facts.Dimensions[2] - 1);
    if (!areNumbers || !ExpandPattern(words[0], { first, last, step }, names))
    {
      error = "ElementDataFile is no pattern of file names: " + text;
      return false;
    }
  }
  else if (!text.empty())
  {
    names.push_back(text);
  }
  for (const std::string& name : names)
  {
    this->Header.Files.push_back({ Beside(this->Path, name), 0 });
  }
  error = names.empty() ? "ElementDataFile names no file" : "";
  return !names.empty();
}
