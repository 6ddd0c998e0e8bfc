// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjParser.h"

#include "vtkMTSinglePrecision.h"

#include <algorithm>
#include <cmath>

using vtkMTTextFormat::NextToken;

namespace
{
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
}

bool vtkMTObjParser::Parse(std::string& error)
{
  std::string_view line;
  while (this->TakeWholeLine(line))
  {
    if (!this->ReadLine(line))
    {
      error = "line " + std::to_string(this->LineNumber) + ": " + this->Error;
      return false;
    }
  }
  error = this->Stream.GetError();
  return error.empty() && this->CheckIndices(error);
}

bool vtkMTObjParser::TakeWholeLine(std::string_view& line)
{
  this->Joined.clear();
  while (this->Stream.TakeLine(line))
  {
    ++this->LineNumber;
    const bool goesOn = !line.empty() && line.back() == '\\';
    if (!goesOn && this->Joined.empty())
    {
      return true;
    }
    this->Joined.append(line.substr(0, line.size() - (goesOn ? 1 : 0)));
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
  float values[3] = { 0.0f, 0.0f, 0.0f };
  if (keyword == "v")
  {
    return this->ReadVertex(line);
  }
  if (keyword == "vt")
  {
    ++this->Textures;
    return this->ReadNumbers(line, 1, 2, values) && this->AddTexture(values);
  }
  if (keyword == "vn")
  {
    ++this->Normals;
    return this->ReadNumbers(line, 3, 3, values) && this->AddNormal(values);
  }
  if (keyword == "f" || keyword == "fo")
  {
    return this->ReadCell(line, true);
  }
  if (keyword == "l")
  {
    return this->ReadCell(line, false);
  }
  if (keyword == "g")
  {
    ++this->Group;
  }
  else if (keyword == "usemtl")
  {
    this->UseMaterial(line);
  }
  else if (keyword == "mtllib")
  {
    this->UseLibraries(line);
  }
  return true;
}

// x y z, x y z w, x y z r g b
bool vtkMTObjParser::ReadVertex(std::string_view line)
{
  double values[7];
  std::size_t count = 0;
  for (std::string_view token = NextToken(line); !token.empty() && token[0] != '#'; token = NextToken(line))
  {
    if (count == 7 || !vtkMTTextFormat::ToNumber(token, values[count]))
    {
      return this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no coordinate");
    }
    this->IsDouble = this->IsDouble || (count < 3 && NeedsDouble(token, values[count]));
    ++count;
  }
  if (count < 3)
  {
    return this->Fail("a vertex with " + std::to_string(count) + " coordinates");
  }
  this->HasColors = count >= 6 && (this->HasColors || this->Points == 0);
  ++this->Points;
  float colors[3] = { 0.0f, 0.0f, 0.0f };
  for (std::size_t i = 0; this->HasColors && i < 3; ++i)
  {
    colors[i] = static_cast<float>(values[count - 3 + i]);
  }
  return this->AddVertex(values, this->HasColors ? colors : nullptr);
}

bool vtkMTObjParser::ReadNumbers(std::string_view line, std::size_t least, std::size_t count, float* values)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string_view token = NextToken(line);
    if ((!token.empty() || i < least) && !vtkMTTextFormat::ToNumber(token, values[i]))
    {
      return this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no number");
    }
  }
  return true;
}

// The number before the next slash: counted from 1, or backwards from the latest. An empty one is None.
bool vtkMTObjParser::ReadIndex(std::string_view& token, std::uint64_t count, std::uint64_t& index)
{
  const std::size_t slash = std::min(token.find('/'), token.size());
  const std::string_view digits = token.substr(0, slash);
  token.remove_prefix(std::min(slash + 1, token.size()));
  index = None;
  if (digits.empty())
  {
    return true;
  }
  std::int64_t number = 0;
  if (!vtkMTTextFormat::ToNumber(digits, number) || number == 0 || number < -static_cast<std::int64_t>(count))
  {
    return false;
  }
  index = number > 0 ? static_cast<std::uint64_t>(number) - 1 : count - static_cast<std::uint64_t>(-number);
  return true;
}

bool vtkMTObjParser::ReadCorner(std::string_view token, Corner& corner)
{
  const std::string_view whole = token;
  if (!ReadIndex(token, this->Points, corner.Point) || corner.Point == None ||
    !ReadIndex(token, this->Textures, corner.Texture) || !ReadIndex(token, this->Normals, corner.Normal) ||
    !token.empty())
  {
    return this->Fail("\"" + std::string(whole.substr(0, 40)) + "\" is no corner of a face");
  }
  const auto see = [](std::uint64_t index, std::uint64_t& largest)
  { largest = index == None ? largest : std::max(largest, index + 1); };
  see(corner.Point, this->Largest.Point);
  see(corner.Texture, this->Largest.Texture);
  see(corner.Normal, this->Largest.Normal);
  return true;
}

bool vtkMTObjParser::ReadCell(std::string_view line, bool isFace)
{
  const std::size_t least = isFace ? 3 : 2;
  this->ThisCell.IsFace = isFace;
  this->ThisCell.Corners.clear();
  for (std::string_view token = NextToken(line); !token.empty() && token[0] != '#'; token = NextToken(line))
  {
    this->ThisCell.Corners.emplace_back();
    if (!this->ReadCorner(token, this->ThisCell.Corners.back()))
    {
      return false;
    }
  }
  if (this->ThisCell.Corners.size() < least)
  {
    return this->Fail(std::string(isFace ? "a face" : "a line") + " with " +
      std::to_string(this->ThisCell.Corners.size()) + " corners");
  }
  this->ThisCell.Material = this->Material;
  this->ThisCell.Group = std::max(this->Group, 0);
  ++(isFace ? this->Faces : this->Lines);
  return this->AddCell(this->ThisCell);
}

void vtkMTObjParser::UseMaterial(std::string_view line)
{
  const std::string name(NextToken(line));
  const auto inserted = this->Materials.emplace(name, static_cast<int>(this->MaterialNames.size()));
  if (inserted.second)
  {
    this->MaterialNames.push_back(name);
  }
  this->Material = inserted.first->second;
}

// One name with blanks in it, or several: the first is what most programs write and mean.
void vtkMTObjParser::UseLibraries(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t last = line.find_last_not_of(" \t");
  if (first != std::string_view::npos)
  {
    const std::string name(line.substr(first, last - first + 1));
    if (std::find(this->Libraries.begin(), this->Libraries.end(), name) == this->Libraries.end())
    {
      this->Libraries.push_back(name);
    }
  }
}

// A face may name what only comes later in the file, so this is known at the end.
bool vtkMTObjParser::CheckIndices(std::string& error) const
{
  const auto check = [&error](std::uint64_t largest, std::uint64_t count, const char* kind)
  {
    if (largest > count)
    {
      error =
        std::string("a face uses ") + kind + " " + std::to_string(largest) + ", but there are " + std::to_string(count);
    }
    return largest <= count;
  };
  return check(this->Largest.Point, this->Points, "vertex") &&
    check(this->Largest.Texture, this->Textures, "texture coordinate") &&
    check(this->Largest.Normal, this->Normals, "normal");
}
