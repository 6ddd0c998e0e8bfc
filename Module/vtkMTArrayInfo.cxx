// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArrayInfo.h"

#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <iterator>
#include <limits>

//------------------------------------------------------------------------------
static std::size_t GetTypeSize(int type)
{
  switch (type)
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
      return 1;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return 2;
    case VTK_INT:
    case VTK_UNSIGNED_INT:
    case VTK_FLOAT:
      return 4;
    case VTK_LONG:
    case VTK_UNSIGNED_LONG:
      return sizeof(long);
    case VTK_ID_TYPE:
      return sizeof(vtkIdType);
    case VTK_LONG_LONG:
    case VTK_UNSIGNED_LONG_LONG:
    case VTK_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
std::size_t vtkMTArrayInfo::GetTupleSize() const
{
  return this->Components > 0 ? GetTypeSize(this->Type) * static_cast<std::size_t>(this->Components) : 0;
}

//------------------------------------------------------------------------------
bool vtkMTArrayInfo::IsFinestOnly() const
{
  const auto levels = this->Properties.find("levels");
  return this->Role == ExactPoints || (levels != this->Properties.end() && levels->second == "finest");
}

//------------------------------------------------------------------------------
// Compared in the values' own type, so that nothing is lost before the end. What is compared with NaN stays.
template <typename Value>
static void FindRanges(const vtkMTColumn& column, std::vector<vtkMTRange>& ranges)
{
  using Limits = std::numeric_limits<Value>;
  const std::size_t components = ranges.size();
  const std::size_t tuples = column.size() / (sizeof(Value) * components);
  for (std::size_t c = 0; tuples > 0 && c < components; ++c)
  {
    Value least = Limits::has_infinity ? Limits::infinity() : Limits::max();
    Value largest = Limits::has_infinity ? -Limits::infinity() : Limits::lowest();
    const unsigned char* from = column.data() + c * sizeof(Value);
    for (std::size_t i = 0; i < tuples; ++i, from += components * sizeof(Value))
    {
      Value value;
      std::memcpy(&value, from, sizeof(Value));
      least = value < least ? value : least;
      largest = value > largest ? value : largest;
    }
    ranges[c] = { static_cast<double>(least), static_cast<double>(largest) };
  }
}

//------------------------------------------------------------------------------
std::vector<vtkMTRange> vtkMTArrayInfo::GetRanges(const vtkMTColumn& column) const
{
  std::vector<vtkMTRange> ranges(static_cast<std::size_t>(this->Components));
  if (this->Role == ExactPoints)
  {
    return ranges;
  }
  switch (this->Type)
  {
    case VTK_CHAR:
      FindRanges<char>(column, ranges);
      break;
    case VTK_SIGNED_CHAR:
      FindRanges<signed char>(column, ranges);
      break;
    case VTK_UNSIGNED_CHAR:
      FindRanges<unsigned char>(column, ranges);
      break;
    case VTK_SHORT:
      FindRanges<short>(column, ranges);
      break;
    case VTK_UNSIGNED_SHORT:
      FindRanges<unsigned short>(column, ranges);
      break;
    case VTK_INT:
      FindRanges<int>(column, ranges);
      break;
    case VTK_UNSIGNED_INT:
      FindRanges<unsigned int>(column, ranges);
      break;
    case VTK_LONG:
      FindRanges<long>(column, ranges);
      break;
    case VTK_UNSIGNED_LONG:
      FindRanges<unsigned long>(column, ranges);
      break;
    case VTK_LONG_LONG:
      FindRanges<long long>(column, ranges);
      break;
    case VTK_UNSIGNED_LONG_LONG:
      FindRanges<unsigned long long>(column, ranges);
      break;
    case VTK_ID_TYPE:
      FindRanges<vtkIdType>(column, ranges);
      break;
    case VTK_FLOAT:
      FindRanges<float>(column, ranges);
      break;
    case VTK_DOUBLE:
      FindRanges<double>(column, ranges);
      break;
    default:
      break;
  }
  return ranges;
}

//------------------------------------------------------------------------------
bool vtkMTArrayInfo::operator==(const vtkMTArrayInfo& other) const
{
  return this->Name == other.Name && this->Type == other.Type && this->Components == other.Components &&
    this->Association == other.Association && this->Resampling == other.Resampling && this->Role == other.Role &&
    this->Attribute == other.Attribute && this->ComponentNames == other.ComponentNames &&
    this->Properties == other.Properties;
}

//------------------------------------------------------------------------------
// Meanings
namespace
{
// As vtkDataSetAttributes counts them; this class is of use where there is no VTK.
constexpr int NormalsAttribute = 2;
constexpr int GlobalIdsAttribute = 5;
constexpr int PedigreeIdsAttribute = 6;

bool IsReal(const vtkMTArrayInfo& info)
{
  return info.Type == VTK_FLOAT || info.Type == VTK_DOUBLE;
}

bool IsDirection(const vtkMTArrayInfo& info)
{
  const bool named = info.Name == "Normals" || info.Name == "NORMAL";
  return IsReal(info) && info.Components == 3 && (named || info.Attribute == NormalsAttribute);
}

bool IsId(const vtkMTArrayInfo& info)
{
  return info.Attribute == GlobalIdsAttribute || info.Attribute == PedigreeIdsAttribute ||
    info.Role == vtkMTArrayInfo::InputCellIds || info.Role == vtkMTArrayInfo::InputPointIds;
}

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool IsNamedAsChannel(const std::string& name)
{
  static const char* const channels[] = { "red", "green", "blue", "alpha", "intensity", "gray", "grey", "luminance",
    "brightness" };
  const std::string last = name.substr(name.rfind('_') + 1); // of diffuse_red
  return std::find(std::begin(channels), std::end(channels), last) != std::end(channels);
}

// Calls change for each point array of these names.
template <class Change>
std::string ForEach(const std::vector<std::string>& names, std::vector<vtkMTArrayInfo>& arrays, Change&& change)
{
  for (const std::string& name : names)
  {
    bool isThere = false;
    for (vtkMTArrayInfo& info : arrays)
    {
      if (info.Name == name)
      {
        isThere = true;
        if (info.Association == vtkMTArrayInfo::Point)
        {
          change(info);
        }
      }
    }
    if (!isThere)
    {
      return name;
    }
  }
  return "";
}
}

bool vtkMTArrayInfo::IsColor() const
{
  const std::string name = ToLower(this->Name);
  if (this->Components == 1)
  {
    return !IsReal(*this) && IsNamedAsChannel(name);
  }
  const bool isNamed = name.find("color") != std::string::npos || name.find("colour") != std::string::npos ||
    name.find("rgb") != std::string::npos;
  return (this->Type == VTK_UNSIGNED_CHAR && this->Components <= 4) ||
    (isNamed && (this->Components == 3 || this->Components == 4));
}

vtkMTArrayInfo::ResamplingType vtkMTArrayInfo::GetDefaultResampling() const
{
  if (this->Association == Cell || IsId(*this) || this->Name == "vtkGhostType")
  {
    return Nearest;
  }
  if (IsDirection(*this))
  {
    return Direction;
  }
  return IsReal(*this) || this->IsColor() ? Interpolate : Nearest;
}

const char* vtkMTArrayInfo::GetMeaning() const
{
  const bool isOfPoints = this->Association == Point;
  if (IsId(*this) || this->Resampling == Direction)
  {
    return IsId(*this) ? "ids" : "directions";
  }
  // Of points the resampling is what was chosen in the end, of cells it is always the same.
  const bool isLabel = this->Resampling == Nearest && (isOfPoints || !IsReal(*this));
  if (this->IsColor() && !(isOfPoints && isLabel))
  {
    return "colors";
  }
  return isLabel ? "labels" : "values";
}

std::string vtkMTArrayInfo::ChooseMeanings(
  const std::vector<std::string>& labels, const std::vector<std::string>& values, std::vector<vtkMTArrayInfo>& arrays)
{
  const std::string missing =
    ForEach(labels, arrays, [](vtkMTArrayInfo& info) { info.Resampling = vtkMTArrayInfo::Nearest; });
  return !missing.empty()
    ? missing
    : ForEach(values, arrays,
        [](vtkMTArrayInfo& info)
        { info.Resampling = IsDirection(info) ? vtkMTArrayInfo::Direction : vtkMTArrayInfo::Interpolate; });
}

//------------------------------------------------------------------------------
std::string vtkMTArrayInfo::FindUncertifiable(
  const std::vector<std::string>& names, const std::vector<vtkMTArrayInfo>& arrays)
{
  for (const std::string& name : names)
  {
    const auto isIt = [&name](const vtkMTArrayInfo& info) { return info.Name == name; };
    const auto array = std::find_if(arrays.begin(), arrays.end(), isIt);
    if (array == arrays.end())
    {
      return "the input has no array \"" + name + "\"";
    }
    if (std::find_if(array + 1, arrays.end(), isIt) != arrays.end())
    {
      return "the input has two arrays \"" + name +
        "\", of points and of cells, so the values of neither can be certified";
    }
    if (array->Components != 1)
    {
      return "the array \"" + name + "\" has more than one component, so its values cannot be certified";
    }
  }
  return "";
}
