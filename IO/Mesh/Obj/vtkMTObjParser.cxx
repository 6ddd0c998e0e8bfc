// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjParser.h"

#include "vtkMTSinglePrecision.h"

#include <algorithm>
#include <cmath>

using vtkMTTextFormat::NextToken;

namespace
{
constexpr std::size_t MostNumbers = 7; // of a vertex: x y z r g b a

// Whether the decimal text says more than single precision keeps: whether rounding moves it by more than half of its
// last digit.
bool NeedsDouble(std::string_view token, double value)
{
  const double shift = std::abs(vtkMTSinglePrecision::Round(value) - value);
  if (!(shift > 0.0) || !std::isfinite(shift))
  {
    return false;
  }
  const std::size_t mantissa = std::min(token.find_first_of("eE"), token.size());
  const std::size_t dot = token.substr(0, mantissa).find('.');
  const double decimals = dot == std::string_view::npos ? 0.0 : static_cast<double>(mantissa - dot - 1);
  std::int64_t exponent = 0;
  if (mantissa < token.size())
  {
    vtkMTTextFormat::ToNumber(token.substr(mantissa + 1), exponent);
  }
  return shift > 0.5 * std::pow(10.0, static_cast<double>(exponent) - decimals);
}

bool IsComment(std::string_view token)
{
  return !token.empty() && token[0] == '#';
}

std::string_view Trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// Numbers up to the first token that is none. Those that are not finite are none here.
std::size_t ReadFinite(std::string_view line, std::size_t most, float* values)
{
  std::size_t count = 0;
  for (; count < most; ++count)
  {
    float value = 0.0f;
    if (!vtkMTTextFormat::ToNumber(NextToken(line), value) || !std::isfinite(value))
    {
      break;
    }
    values[count] = value;
  }
  return count;
}

enum class IndexType
{
  Good,
  Empty,
  Missing, // there is nothing of that number
  Bad
};

// The number before the next slash: counted from 1, or backwards from the latest.
IndexType ReadIndex(std::string_view& token, std::uint64_t count, std::uint64_t& index)
{
  const std::size_t slash = std::min(token.find('/'), token.size());
  const std::string_view digits = token.substr(0, slash);
  token.remove_prefix(std::min(slash + 1, token.size()));
  if (digits.empty())
  {
    return IndexType::Empty;
  }
  std::int64_t number = 0;
  if (!vtkMTTextFormat::ToNumber(digits, number))
  {
    return IndexType::Bad;
  }
  if (number == 0 || number < -static_cast<std::int64_t>(count))
  {
    return IndexType::Missing;
  }
  index = number > 0 ? static_cast<std::uint64_t>(number) - 1 : count - static_cast<std::uint64_t>(-number);
  return IndexType::Good;
}
}

int vtkMTObjParser::NameList::GetId(const std::string& name)
{
  const auto inserted = this->Ids.emplace(name, static_cast<int>(this->Names.size()));
  if (inserted.second)
  {
    this->Names.push_back(name);
  }
  return inserted.first->second;
}

//------------------------------------------------------------------------------
bool vtkMTObjParser::Parse(std::string& error)
{
  bool good = this->CheckEncoding();
  for (std::string_view line; good && this->TakeWholeLine(line);)
  {
    good = this->ReadLine(line);
  }
  error = good ? this->Stream.GetError() : this->Error;
  return error.empty();
}

bool vtkMTObjParser::CheckEncoding()
{
  this->Stream.SkipByteOrderMark();
  const auto [bytes, size] = this->Stream.GetBuffered();
  return !vtkMTTextFormat::IsUtf16({ reinterpret_cast<const char*>(bytes), size }) ||
    this->Fail("is text in UTF-16; save it as UTF-8");
}

// A backslash at the end of a line, but for comments, joins it to the next as a blank would.
bool vtkMTObjParser::TakeWholeLine(std::string_view& line)
{
  this->Joined.clear();
  while (this->Stream.TakeLine(line))
  {
    const std::size_t last = line.find_last_not_of(" \t");
    const bool goesOn = last != std::string_view::npos && line[last] == '\\' &&
      (!this->Joined.empty() || !IsComment(line.substr(line.find_first_not_of(" \t"))));
    if (!goesOn && this->Joined.empty())
    {
      return true;
    }
    this->Joined.append(goesOn ? line.substr(0, last) : line);
    this->Joined.push_back(' ');
    if (!goesOn || this->Joined.size() > vtkMTTextFormat::Stream::LargestLine)
    {
      line = this->Joined;
      return true;
    }
  }
  line = this->Joined;
  return !this->Joined.empty() && this->Stream.GetError().empty();
}

bool vtkMTObjParser::ReadLine(std::string_view line)
{
  const std::string_view keyword = NextToken(line);
  if (keyword.empty() || IsComment(keyword))
  {
    return true;
  }
  if (keyword == "v")
  {
    return this->ReadVertex(line);
  }
  if (keyword == "vt")
  {
    return this->ReadTexture(line);
  }
  if (keyword == "vn")
  {
    return this->ReadNormal(line);
  }
  if (keyword == "f" || keyword == "fo")
  {
    return this->ReadCell(line, Face, 3);
  }
  if (keyword == "l")
  {
    return this->ReadCell(line, Line, 2);
  }
  if (keyword == "p")
  {
    return this->ReadCell(line, Vertices, 1);
  }
  if (!this->ReadNames(keyword, line))
  {
    this->CountIgnored(keyword, line);
  }
  return true;
}

//------------------------------------------------------------------------------
// The numbers before the first token that is none: how many there are, up to one more than MostNumbers.
std::size_t vtkMTObjParser::ReadCoordinates(std::string_view line, double* values)
{
  std::size_t count = 0;
  for (std::string_view token = NextToken(line); !token.empty() && !IsComment(token); token = NextToken(line))
  {
    double value = 0.0;
    const bool isNumber = vtkMTTextFormat::ToNumber(token, value);
    if (count == MostNumbers || !isNumber)
    {
      vtkMTInputReports::Add("ignored_numbers", count < 3 ? 0 : 1, this->Report);
      return count + (isNumber ? 1 : 0);
    }
    this->IsDouble = this->IsDouble || (count < 3 && NeedsDouble(token, value));
    values[count++] = value;
  }
  return count;
}

// x y z, x y z w, x y z r g b, x y z r g b a
bool vtkMTObjParser::ReadVertex(std::string_view line)
{
  double values[MostNumbers];
  const std::size_t count = this->ReadCoordinates(line, values);
  ++this->Points;
  if (count < 3)
  {
    this->Count("bad_vertices"); // keeps its number
    std::fill_n(values, 3, std::numeric_limits<double>::quiet_NaN());
  }
  else if (!std::all_of(values, values + 3, [](double value) { return std::isfinite(value); }))
  {
    this->Count("not_finite_vertices");
  }
  if (count == 5 || (count == 4 && values[3] != 1.0))
  {
    this->Count(count == 5 ? "ignored_numbers" : "ignored_weights");
  }
  return this->AddVertex(values, this->TakeColor(values, count));
}

vtkMTObjParser::Color vtkMTObjParser::TakeColor(const double* values, std::size_t count)
{
  Color color = { NoColor, NoColor, NoColor, NoColor };
  if (count < 6 || count > MostNumbers ||
    !std::all_of(values + 3, values + count, [](double value) { return std::isfinite(value); }))
  {
    return color;
  }
  ++this->ColoredVertices;
  for (std::size_t i = 0; i + 3 < count; ++i)
  {
    color[i] = static_cast<float>(values[3 + i]);
    this->AreColorsWhole = this->AreColorsWhole && (i == 3 || color[i] == std::floor(color[i]));
    float& largest = i < 3 ? this->LargestColor : this->LargestAlpha;
    largest = std::max(largest, color[i]);
  }
  return color;
}

// Colors are counted from 0 to 255 where they are whole numbers above 1, or far above 1.
vtkMTObjParser::Color vtkMTObjParser::FinishColor(Color color) const
{
  const bool isOf255 = this->LargestColor > 2.0f || (this->LargestColor > 1.0f && this->AreColorsWhole);
  const float scales[2] = { isOf255 ? 255.0f : 1.0f, this->LargestAlpha > 1.0f ? 255.0f : 1.0f };
  for (std::size_t i = 0; i < color.size(); ++i)
  {
    color[i] = std::isnan(color[i]) ? 1.0f : color[i] / scales[i / 3];
  }
  return color;
}

bool vtkMTObjParser::ReadTexture(std::string_view line)
{
  float values[2] = { 0.0f, 0.0f };
  std::string_view rest = line;
  NextToken(rest);
  const std::string_view second = NextToken(rest);
  const std::size_t wanted = second.empty() || IsComment(second) ? 1 : 2;
  if (ReadFinite(line, wanted, values) < wanted)
  {
    this->Count("bad_texture_coordinates");
    values[0] = values[1] = 0.0f;
  }
  ++this->Textures;
  return this->AddTexture(values);
}

bool vtkMTObjParser::ReadNormal(std::string_view line)
{
  float values[3] = { 0.0f, 0.0f, 0.0f };
  if (ReadFinite(line, 3, values) < 3)
  {
    this->Count("bad_normals");
    std::fill_n(values, 3, 0.0f);
  }
  ++this->Normals;
  return this->AddNormal(values);
}

//------------------------------------------------------------------------------
bool vtkMTObjParser::ReadCorner(std::string_view token, Corner& corner)
{
  const IndexType point = ReadIndex(token, this->Points, corner.Point);
  const IndexType texture = ReadIndex(token, this->Textures, corner.Texture);
  const IndexType normal = ReadIndex(token, this->Normals, corner.Normal);
  this->MissingTextures += texture == IndexType::Missing ? 1 : 0;
  this->MissingNormals += normal == IndexType::Missing ? 1 : 0;
  return token.empty() && point == IndexType::Good && texture != IndexType::Bad && normal != IndexType::Bad;
}

void vtkMTObjParser::CountCorners()
{
  this->FaceCorners += this->ThisCell.Corners.size();
  for (const Corner& corner : this->ThisCell.Corners)
  {
    this->CornersWithTexture += corner.Texture != None ? 1 : 0;
    this->CornersWithNormal += corner.Normal != None ? 1 : 0;
  }
}

bool vtkMTObjParser::ReadCell(std::string_view line, KindType kind, std::size_t least)
{
  Cell& cell = this->ThisCell;
  cell.Kind = kind;
  cell.Corners.clear();
  bool good = true;
  for (std::string_view token = NextToken(line); !token.empty() && !IsComment(token); token = NextToken(line))
  {
    cell.Corners.emplace_back();
    good = this->ReadCorner(token, cell.Corners.back()) && good;
  }
  if (!good || cell.Corners.size() < least)
  {
    this->Count(good ? "degenerate_cells" : "bad_cells");
    return true;
  }
  this->Group = this->Group < 0 ? this->Groups.GetId(this->GroupName) : this->Group;
  this->Object = this->Object < 0 && !this->ObjectName.empty() ? this->Objects.GetId(this->ObjectName) : this->Object;
  this->HasCellsOfNoObject = this->HasCellsOfNoObject || this->Object < 0;
  cell.Material = this->Material;
  cell.Group = this->Group;
  cell.Object = this->Object;
  if (kind == Face)
  {
    ++this->Faces;
    this->CountCorners();
  }
  return this->AddCell(cell);
}

//------------------------------------------------------------------------------
bool vtkMTObjParser::ReadNames(std::string_view keyword, std::string_view line)
{
  const std::string name(Trim(line));
  if (keyword == "g")
  {
    this->Group = -1;
    this->GroupName = name.empty() ? "default" : name;
  }
  else if (keyword == "o")
  {
    this->Object = -1;
    this->ObjectName = name;
  }
  else if (keyword == "usemtl")
  {
    this->Material = name.empty() ? -1 : this->Materials.GetId(name);
  }
  else if (keyword == "mtllib")
  {
    const bool isKnown = std::find(this->Libraries.begin(), this->Libraries.end(), name) != this->Libraries.end();
    if (!isKnown && !name.empty())
    {
      this->Libraries.push_back(name);
    }
  }
  else
  {
    return false;
  }
  return true;
}

void vtkMTObjParser::CountIgnored(std::string_view keyword, std::string_view line)
{
  static const char* const freeForms[] = { "curv", "curv2", "surf" };
  static const char* const others[] = { "vp", "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv", "sp",
    "end", "con", "mg", "bevel", "c_interp", "d_interp", "lod", "usemap", "maplib", "shadow_obj", "trace_obj", "ctech",
    "stech", "call", "csh", "res", "bsp", "bzp", "cdc", "cdp" };
  if (keyword == "s")
  {
    const std::string_view group = NextToken(line);
    if (group != "off" && group != "0" && !group.empty())
    {
      this->SmoothingGroups.emplace(group);
    }
  }
  else if (std::find(std::begin(freeForms), std::end(freeForms), keyword) != std::end(freeForms))
  {
    this->Count("free_forms");
  }
  else if (std::find(std::begin(others), std::end(others), keyword) == std::end(others))
  {
    this->Count("unknown_records");
  }
}

void vtkMTObjParser::CountAll(const std::array<std::uint64_t, 2>& missing, std::uint64_t badCells)
{
  const auto add = [this](const char* reason, std::uint64_t count)
  { vtkMTInputReports::Add(reason, count, this->Report); };
  add("bad_cells", badCells);
  add("missing_texture_coordinates", this->MissingTextures + missing[0]);
  add("missing_normals", this->MissingNormals + missing[1]);
  const std::uint64_t withTexture = this->CornersWithTexture - missing[0];
  const std::uint64_t withNormal = this->CornersWithNormal - missing[1];
  add("filled_texture_coordinates", withTexture > 0 ? this->FaceCorners - withTexture : 0);
  add("filled_normals", withNormal > 0 ? this->FaceCorners - withNormal : 0);
  add("filled_colors", this->HasColors() ? this->Points - this->ColoredVertices : 0);
  // Where the file has normals they say what is smooth.
  add(
    "ignored_smoothing_groups", withNormal > 0 || this->SmoothingGroups.size() < 2 ? 0 : this->SmoothingGroups.size());
}
