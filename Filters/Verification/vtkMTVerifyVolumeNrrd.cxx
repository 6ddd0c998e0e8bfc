// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeNrrd.h"

#include "vtkMTVerifyVolumeBytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
constexpr std::size_t MostHeader = std::size_t(1) << 22;
const double NaN = std::numeric_limits<double>::quiet_NaN();

const std::map<std::string, int>& GetTypes()
{
  static const std::map<std::string, int> types = { { "signed char", VTK_TYPE_INT8 }, { "int8", VTK_TYPE_INT8 },
    { "int8_t", VTK_TYPE_INT8 }, { "uchar", VTK_TYPE_UINT8 }, { "unsigned char", VTK_TYPE_UINT8 },
    { "uint8", VTK_TYPE_UINT8 }, { "uint8_t", VTK_TYPE_UINT8 }, { "short", VTK_TYPE_INT16 },
    { "short int", VTK_TYPE_INT16 }, { "signed short", VTK_TYPE_INT16 }, { "signed short int", VTK_TYPE_INT16 },
    { "int16", VTK_TYPE_INT16 }, { "int16_t", VTK_TYPE_INT16 }, { "ushort", VTK_TYPE_UINT16 },
    { "unsigned short", VTK_TYPE_UINT16 }, { "unsigned short int", VTK_TYPE_UINT16 }, { "uint16", VTK_TYPE_UINT16 },
    { "uint16_t", VTK_TYPE_UINT16 }, { "int", VTK_TYPE_INT32 }, { "signed int", VTK_TYPE_INT32 },
    { "int32", VTK_TYPE_INT32 }, { "int32_t", VTK_TYPE_INT32 }, { "uint", VTK_TYPE_UINT32 },
    { "unsigned int", VTK_TYPE_UINT32 }, { "uint32", VTK_TYPE_UINT32 }, { "uint32_t", VTK_TYPE_UINT32 },
    { "longlong", VTK_TYPE_INT64 }, { "long long", VTK_TYPE_INT64 }, { "long long int", VTK_TYPE_INT64 },
    { "signed long long", VTK_TYPE_INT64 }, { "signed long long int", VTK_TYPE_INT64 }, { "int64", VTK_TYPE_INT64 },
    { "int64_t", VTK_TYPE_INT64 }, { "ulonglong", VTK_TYPE_UINT64 }, { "unsigned long long", VTK_TYPE_UINT64 },
    { "unsigned long long int", VTK_TYPE_UINT64 }, { "uint64", VTK_TYPE_UINT64 }, { "uint64_t", VTK_TYPE_UINT64 },
    { "float", VTK_TYPE_FLOAT32 }, { "double", VTK_TYPE_FLOAT64 } };
  return types;
}

/// "(1,0,0) none (0, 1, 0)": a vector for each axis, empty for none. False where it is not of that form.
bool ParseVectors(const std::string& text, std::vector<std::vector<double>>& vectors)
{
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r", at)) != std::string::npos)
  {
    if (ToLower(text.substr(at, 4)) == "none")
    {
      vectors.emplace_back();
      at += 4;
      continue;
    }
    const std::size_t close = text.find(')', at);
    if (text[at] != '(' || close == std::string::npos)
    {
      return false;
    }
    std::string inside = text.substr(at + 1, close - at - 1);
    std::replace(inside.begin(), inside.end(), ',', ' ');
    vectors.emplace_back();
    if (!ToNumbers(Split(inside), vectors.back()) || vectors.back().empty())
    {
      return false;
    }
    at = close + 1;
  }
  return true;
}

/// "space dimension" and "spacedimension" are one name; data file, axis mins and the like alike.
std::string ToFieldName(const std::string& text)
{
  std::string name;
  for (const char c : ToLower(text))
  {
    if (c != ' ')
    {
      name.push_back(c);
    }
  }
  return name == "centerings" ? "centers" : name;
}
}

vtkMTVerifyVolumeNrrd::vtkMTVerifyVolumeNrrd(const std::string& path, vtkMTVerifyVolumeHeader& header)
  : Path(path)
  , Header(header)
{
}

bool vtkMTVerifyVolumeNrrd::Parse(std::string& error)
{
  this->Header.Facts.Reader = "the checker's NRRD reader";
  return this->ReadFields(error) && this->ParseAxes(error) && this->ParseType(error) && this->ParseSpace(error) &&
    this->ParseData(error);
}

bool vtkMTVerifyVolumeNrrd::ReadFields(std::string& error)
{
  Bytes bytes;
  if (!ReadFile(this->Path, bytes, error, MostHeader))
  {
    return false;
  }
  const std::string text(bytes.begin(), bytes.end());
  if (text.compare(0, 5, "NRRD0") != 0 && text.compare(0, 4, "NRRD") != 0)
  {
    error = "it does not begin with NRRD";
    return false;
  }
  bool isList = false;
  std::size_t at = std::min(text.find('\n'), text.size() - 1) + 1;
  while (at < text.size())
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = Trim(text.substr(at, end - at));
    at = std::min(end + 1, text.size());
    const std::size_t colon = line.find(':');
    if (line.empty() && !isList)
    {
      break;
    }
    if (isList)
    {
      this->Lines.push_back(line);
    }
    else if (line[0] != '#' && colon != std::string::npos && line.compare(colon, 2, ":=") != 0)
    {
      const std::string value = Trim(line.substr(colon + 1));
      const std::string name = ToFieldName(line.substr(0, colon));
      this->Fields.emplace(name, value);
      isList = name == "datafile" && value.compare(0, 4, "LIST") == 0;
    }
  }
  this->End = static_cast<std::int64_t>(at);
  return true;
}

std::string vtkMTVerifyVolumeNrrd::Find(const std::string& name) const
{
  const auto found = this->Fields.find(name);
  return found == this->Fields.end() ? std::string() : found->second;
}

bool vtkMTVerifyVolumeNrrd::FindPerAxis(const std::string& name, std::vector<double>& numbers, std::string& error) const
{
  const std::string text = this->Find(name);
  numbers.assign(this->Axes.size(), NaN);
  if (!text.empty() && (!ToNumbers(Split(text), numbers) || numbers.size() != this->Axes.size()))
  {
    error = name + " must be a number for each axis, and is: " + text;
    return false;
  }
  return true;
}

bool vtkMTVerifyVolumeNrrd::ParseType(std::string& error)
{
  const std::vector<std::string> words = Split(ToLower(this->Find("type")));
  std::string name;
  for (const std::string& word : words)
  {
    name += (name.empty() ? "" : " ") + word;
  }
  const auto found = GetTypes().find(name);
  if (found == GetTypes().end())
  {
    return this->Header.Refuse("NRRD's type " + name, error);
  }
  this->Header.Type = found->second;
  return true;
}

bool vtkMTVerifyVolumeNrrd::ParseAxes(std::string& error)
{
  std::vector<double> dimension, sizes;
  if (!ToNumbers(Split(this->Find("dimension")), dimension) || dimension.size() != 1 || dimension[0] < 1 ||
    dimension[0] > 16 || !ToNumbers(Split(this->Find("sizes")), sizes) ||
    static_cast<double>(sizes.size()) != dimension[0])
  {
    error = "its header needs a dimension of 1 to 16 and as many sizes";
    return false;
  }
  this->Axes.resize(sizes.size());
  const std::vector<std::string> kinds = Split(ToLower(this->Find("kinds")));
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    this->Axes[i].Size = std::abs(sizes[i]) < 1e15 ? static_cast<std::int64_t>(sizes[i]) : 0;
    const std::string kind = i < kinds.size() ? kinds[i] : "domain";
    this->Axes[i].IsSpatial = kind == "domain" || kind == "space" || kind == "???" || kind == "none";
  }
  const std::string directions = this->Find("spacedirections");
  std::vector<std::vector<double>> vectors;
  if (!directions.empty())
  {
    if (!ParseVectors(directions, vectors) || vectors.size() != this->Axes.size())
    {
      error = "space directions must be a vector or none for each axis, and are: " + directions;
      return false;
    }
    for (std::size_t i = 0; i < vectors.size(); ++i)
    {
      this->Axes[i].Direction = vectors[i];
      this->Axes[i].IsSpatial = !vectors[i].empty();
    }
  }
  return this->ChooseAxes(error);
}

bool vtkMTVerifyVolumeNrrd::ChooseAxes(std::string& error)
{
  std::vector<std::size_t> spatial;
  for (std::size_t i = 0; i < this->Axes.size(); ++i)
  {
    if (this->Axes[i].IsSpatial)
    {
      spatial.push_back(i);
    }
  }
  // Without other knowledge axes of one sample are those to leave out.
  for (std::size_t i = spatial.size(); i-- > 0 && spatial.size() > 3;)
  {
    if (this->Axes[spatial[i]].Size == 1)
    {
      spatial.erase(spatial.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  if (spatial.size() > 3)
  {
    spatial.resize(3);
  }
  std::vector<std::int64_t> sizes;
  for (const std::size_t i : spatial)
  {
    sizes.push_back(this->Axes[i].Size);
  }
  for (std::size_t i = 0; i < this->Axes.size(); ++i)
  {
    if (std::find(spatial.begin(), spatial.end(), i) != spatial.end())
    {
      continue;
    }
    if (this->Axes[i].Size != 1 && !spatial.empty() && i < spatial.back())
    {
      return this->Header.Refuse("NRRD with several values for each sample", error);
    }
    sizes.push_back(this->Axes[i].Size);
  }
  this->Spatial = spatial;
  if (spatial.size() < 3)
  {
    error = "it has no volume to contour: fewer than 3 axes of space";
    return false;
  }
  return this->Header.SetSizes(sizes, error);
}

bool vtkMTVerifyVolumeNrrd::ParseSpace(std::string& error)
{
  vtkMTVerifyVolumeInput::Facts& facts = this->Header.Facts;
  facts.Frame = this->Find("space");
  for (const char* name : { "oldmin", "oldmax" })
  {
    if (!this->Find(name).empty())
    {
      facts.Notes.emplace_back("old min and old max (of values before quantization) are ignored.");
      break;
    }
  }
  if (this->Find("spacedirections").empty())
  {
    return this->ParseSteps(error);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& d = this->Axes[this->Spatial[axis]].Direction;
    if (d.size() != 3)
    {
      return this->Header.Refuse("A NRRD whose space has not 3 dimensions", error);
    }
    this->Header.SetAxis(static_cast<int>(axis), d[0], d[1], d[2]);
  }
  std::vector<std::vector<double>> origin;
  const std::string text = this->Find("spaceorigin");
  if (!ParseVectors(text, origin) || origin.size() > 1 || (origin.size() == 1 && origin[0].size() != 3))
  {
    error = "space origin must be a vector of 3 numbers, and is: " + text;
    return false;
  }
  if (!origin.empty())
  {
    this->Header.SetOrigin(origin[0][0], origin[0][1], origin[0][2]);
  }
  return true;
}

bool vtkMTVerifyVolumeNrrd::ParseSteps(std::string& error)
{
  std::vector<double> spacings, mins, maxs;
  if (!this->FindPerAxis("spacings", spacings, error) || !this->FindPerAxis("axismins", mins, error) ||
    !this->FindPerAxis("axismaxs", maxs, error))
  {
    return false;
  }
  const std::vector<std::string> centers = Split(ToLower(this->Find("centers")));
  double origin[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t i = this->Spatial[axis];
    const bool isNode = i < centers.size() && centers[i] == "node";
    double step = spacings[i];
    if (!std::isfinite(step) && std::isfinite(mins[i]) && std::isfinite(maxs[i]))
    {
      step = (maxs[i] - mins[i]) / static_cast<double>(this->Axes[i].Size - (isNode ? 1 : 0));
    }
    step = std::isfinite(step) ? step : 1.0;
    origin[axis] = !std::isfinite(mins[i]) ? 0.0 : isNode ? mins[i] : mins[i] + 0.5 * step;
    this->Header.SetAxis(
      static_cast<int>(axis), axis == 0 ? step : 0.0, axis == 1 ? step : 0.0, axis == 2 ? step : 0.0);
  }
  this->Header.SetOrigin(origin[0], origin[1], origin[2]);
  return true;
}

bool vtkMTVerifyVolumeNrrd::ParseData(std::string& error)
{
  vtkMTVerifyVolumeHeader& header = this->Header;
  const std::string encoding = ToLower(this->Find("encoding"));
  const std::string endian = ToLower(this->Find("endian"));
  header.IsBigEndian = endian == "big";
  if (encoding == "raw")
  {
    header.Encoding = vtkMTVerifyVolumeHeader::Encodings::Raw;
  }
  else if (encoding == "gz" || encoding == "gzip")
  {
    header.Encoding = vtkMTVerifyVolumeHeader::Encodings::Deflate;
  }
  else if (encoding == "txt" || encoding == "text" || encoding == "ascii")
  {
    header.Encoding = vtkMTVerifyVolumeHeader::Encodings::Ascii;
  }
  else if (encoding == "hex")
  {
    header.Encoding = vtkMTVerifyVolumeHeader::Encodings::Hex;
  }
  else
  {
    return header.Refuse("NRRD's encoding " + (encoding.empty() ? "(none)" : encoding), error);
  }
  std::vector<double> skips[2];
  const std::string texts[2] = { this->Find("lineskip"), this->Find("byteskip") };
  for (int i = 0; i < 2; ++i)
  {
    if (!texts[i].empty() &&
      (!ToNumbers({ texts[i] }, skips[i]) || skips[i][0] < (i == 0 ? 0 : -1) || skips[i][0] > 1e15))
    {
      error = "line skip or byte skip is out of range: " + texts[i];
      return false;
    }
  }
  header.LineSkip = skips[0].empty() ? 0 : static_cast<std::int64_t>(skips[0][0]);
  header.ByteSkip = skips[1].empty() ? 0 : static_cast<std::int64_t>(skips[1][0]);
  return this->ParseFiles(this->Find("datafile"), error);
}

bool vtkMTVerifyVolumeNrrd::ParseFiles(const std::string& text, std::string& error)
{
  const std::vector<std::string> words = Split(text);
  std::vector<std::string> names;
  std::vector<double> range;
  if (words.empty())
  {
    this->Header.Files.push_back({ this->Path, this->End });
    return true;
  }
  if (words[0] == "LIST")
  {
    for (const std::string& line : this->Lines)
    {
      if (!line.empty())
      {
        names.push_back(line);
      }
    }
  }
  else if (words.size() >= 4 && words[0].find('%') != std::string::npos)
  {
    const bool areNumbers = ToNumbers({ words.begin() + 1, words.begin() + 4 }, range);
    if (!areNumbers ||
      !ExpandPattern(words[0],
        { static_cast<std::int64_t>(range[0]), static_cast<std::int64_t>(range[1]),
          static_cast<std::int64_t>(range[2]) },
        names))
    {
      error = "data file is no pattern of file names: " + text;
      return false;
    }
  }
  else
  {
    names.push_back(text);
  }
  for (const std::string& name : names)
  {
    this->Header.Files.push_back({ Beside(this->Path, name), 0 });
  }
  error = names.empty() ? "data file: LIST names no file" : "";
  return !names.empty();
}
