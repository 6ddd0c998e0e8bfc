// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyRows.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
template <typename Number>
double Load(const unsigned char* bytes, bool swap)
{
  unsigned char ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof(Number));
  if (swap)
  {
    std::reverse(ordered, ordered + sizeof(Number));
  }
  Number value;
  std::memcpy(&value, ordered, sizeof(Number));
  return static_cast<double>(value);
}

double LoadNumber(int type, const unsigned char* bytes, bool swap)
{
  switch (type)
  {
    case VTK_SIGNED_CHAR:
      return Load<std::int8_t>(bytes, swap);
    case VTK_UNSIGNED_CHAR:
      return Load<std::uint8_t>(bytes, swap);
    case VTK_SHORT:
      return Load<std::int16_t>(bytes, swap);
    case VTK_UNSIGNED_SHORT:
      return Load<std::uint16_t>(bytes, swap);
    case VTK_INT:
      return Load<std::int32_t>(bytes, swap);
    case VTK_UNSIGNED_INT:
      return Load<std::uint32_t>(bytes, swap);
    case VTK_FLOAT:
      return Load<float>(bytes, swap);
    default:
      return Load<double>(bytes, swap);
  }
}

template <typename Integer>
bool IsWithin(double value)
{
  return value >= std::numeric_limits<Integer>::min() && value <= std::numeric_limits<Integer>::max() &&
    value == std::floor(value);
}

bool FitsType(int type, double value)
{
  switch (type)
  {
    case VTK_SIGNED_CHAR:
      return IsWithin<std::int8_t>(value);
    case VTK_UNSIGNED_CHAR:
      return IsWithin<std::uint8_t>(value);
    case VTK_SHORT:
      return IsWithin<std::int16_t>(value);
    case VTK_UNSIGNED_SHORT:
      return IsWithin<std::uint16_t>(value);
    case VTK_INT:
      return IsWithin<std::int32_t>(value);
    case VTK_UNSIGNED_INT:
      return IsWithin<std::uint32_t>(value);
    default:
      return true;
  }
}
}

vtkMTPlyRows::vtkMTPlyRows(vtkMTTextFormat::Stream& stream, const vtkMTPlyHeader& header)
  : Stream(stream)
  , Header(header)
{
}

bool vtkMTPlyRows::Fail(const std::string& reason)
{
  this->Error = "element " + (this->Element ? this->Element->Name : "?") + ", row " + std::to_string(this->Row) +
    " (byte " + std::to_string(this->RowPosition) +
    "): " + (this->Stream.GetError().empty() ? reason : this->Stream.GetError());
  return false;
}

bool vtkMTPlyRows::BeginElement(const vtkMTPlyElement& element)
{
  this->Element = &element;
  this->Row = 0;
  this->BadRows = 0;
  this->RowPosition = this->Stream.GetPosition();
  const std::uint64_t smallest = this->Header.GetSmallestRow(element);
  // The last number of a text need not be followed by anything.
  const std::uint64_t left = this->Stream.GetLeft() + (this->Header.Format == vtkMTPlyHeader::Ascii ? 1 : 0);
  if (smallest > 0 && element.Count > left / smallest)
  {
    return this->Fail("the header announces " + std::to_string(element.Count) + " rows, for which the " +
      std::to_string(this->Stream.GetLeft()) + " bytes that are left do not suffice; the file is truncated");
  }
  return true;
}

bool vtkMTPlyRows::BeginRow()
{
  ++this->Row;
  this->HasBadCorner = false;
  this->RowPosition = this->Stream.GetPosition();
  if (this->Header.Format != vtkMTPlyHeader::Ascii || this->Element->Properties.empty())
  {
    return true;
  }
  do
  {
    this->RowPosition = this->Stream.GetPosition();
    if (!this->Stream.TakeLine(this->Line))
    {
      return this->Fail("the file ends before it");
    }
    this->Line.remove_prefix(std::min(this->Line.find_first_not_of(" \t\v\f"), this->Line.size()));
  } while (this->Line.empty());
  return true;
}

bool vtkMTPlyRows::EndRow(bool isRead, bool& isGood)
{
  isGood = isRead && !this->HasBadCorner;
  const bool isText = this->Header.Format == vtkMTPlyHeader::Ascii;
  if (isGood)
  {
    if (isText && !vtkMTTextFormat::NextToken(this->Line).empty())
    {
      this->Count("rows_with_more_values");
    }
    return true;
  }
  constexpr std::uint64_t few = 10;
  const bool isLost = !isRead && (!isText || this->Stream.GetLineEnd() == vtkMTTextFormat::Stream::NoEnd);
  if (isLost || !this->Stream.GetError().empty() || ++this->BadRows > few + this->Element->Count / few)
  {
    return false;
  }
  this->Count("bad_records");
  return true;
}

bool vtkMTPlyRows::ReadNumber(int type, const std::string& name, double& value)
{
  return this->Header.Format == vtkMTPlyHeader::Ascii ? this->ReadText(type, name, value)
                                                      : this->ReadBinary(type, name, value);
}

bool vtkMTPlyRows::ReadText(int type, const std::string& name, double& value)
{
  const std::string_view token = vtkMTTextFormat::NextToken(this->Line);
  if (token.empty())
  {
    return this->Fail("the line ends before the value of " + name);
  }
  bool isNumber;
  if (type == VTK_FLOAT)
  {
    float single = 0.0f; // rounded once, not by way of a double
    isNumber = vtkMTTextFormat::ToNumber(token, single);
    value = single;
  }
  else
  {
    isNumber = vtkMTTextFormat::ToNumber(token, value);
  }
  if (!isNumber || !FitsType(type, value))
  {
    return this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no value for " + name);
  }
  return true;
}

bool vtkMTPlyRows::ReadBinary(int type, const std::string& name, double& value)
{
  const unsigned char* bytes = this->Stream.Take(vtkMTPlyHeader::GetSize(type));
  if (!bytes)
  {
    return this->Fail("the file ends before the value of " + name);
  }
  value = LoadNumber(type, bytes, this->Header.Format == vtkMTPlyHeader::BigEndian);
  return true;
}

bool vtkMTPlyRows::ReadCount(const vtkMTPlyProperty& property, std::uint64_t& count)
{
  double value = 0.0;
  if (!this->ReadNumber(property.CountType, property.Name, value))
  {
    return false;
  }
  const bool isText = this->Header.Format == vtkMTPlyHeader::Ascii;
  const std::uint64_t left = isText ? this->Line.size() : this->Stream.GetLeft();
  const std::uint64_t each = isText ? 2 : vtkMTPlyHeader::GetSize(property.Type); // a space and a digit
  const std::uint64_t most = left / each;
  if (value < 0.0 || value > static_cast<double>(most))
  {
    return this->Fail(
      "the list " + property.Name + " has the impossible count " + std::to_string(static_cast<std::int64_t>(value)));
  }
  count = static_cast<std::uint64_t>(value);
  return true;
}

bool vtkMTPlyRows::SkipItems(const vtkMTPlyProperty& property, std::uint64_t count)
{
  if (this->Header.Format != vtkMTPlyHeader::Ascii)
  {
    return this->Stream.Skip(count * vtkMTPlyHeader::GetSize(property.Type)) || this->Fail("the file ends in a list");
  }
  double value;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    if (!this->ReadText(VTK_DOUBLE, property.Name, value))
    {
      return false;
    }
  }
  return true;
}

bool vtkMTPlyRows::SkipProperty(const vtkMTPlyProperty& property)
{
  double value;
  std::uint64_t count = 0;
  return property.IsList() ? this->ReadCount(property, count) && this->SkipItems(property, count)
                           : this->Read(property, value);
}

bool vtkMTPlyRows::SkipRows(std::uint64_t count)
{
  if (this->Header.Format != vtkMTPlyHeader::Ascii)
  {
    this->Row += count;
    return this->Stream.Skip(count * this->Header.GetSmallestRow(*this->Element)) ||
      this->Fail("the file ends before it");
  }
  bool good = true;
  for (std::uint64_t row = 0; good && row < count; ++row)
  {
    good = this->BeginRow();
  }
  return good;
}

std::uint64_t vtkMTPlyRows::GetBuffered(std::uint64_t most, const unsigned char*& rows) const
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  const std::uint64_t size = this->Header.GetSmallestRow(*this->Element);
  if (this->Header.Format != (first == 1 ? vtkMTPlyHeader::LittleEndian : vtkMTPlyHeader::BigEndian) || size == 0)
  {
    return 0;
  }
  const auto [bytes, left] = this->Stream.GetBuffered();
  rows = bytes;
  return std::min<std::uint64_t>(most, left / size);
}

namespace
{
std::uint64_t Load32(const unsigned char* bytes)
{
  return std::uint64_t(bytes[0]) | std::uint64_t(bytes[1]) << 8 | std::uint64_t(bytes[2]) << 16 |
    std::uint64_t(bytes[3]) << 24;
}
}

std::uint64_t vtkMTPlyRows::TakeTriangles(
  const vtkMTPlyProperty& list, std::uint64_t most, std::uint64_t vertices, std::vector<std::uint64_t>& corners)
{
  if (this->Header.Format != vtkMTPlyHeader::LittleEndian || vtkMTPlyHeader::GetSize(list.CountType) != 1 ||
    vtkMTPlyHeader::GetSize(list.Type) != 4)
  {
    return 0;
  }
  constexpr std::size_t rowSize = 13;
  const std::uint64_t range = std::uint64_t(1) << (list.Type == VTK_INT ? 31 : 32);
  const std::uint64_t end = std::min(vertices, range);
  const auto [bytes, size] = this->Stream.GetBuffered();
  const std::uint64_t rows = std::min<std::uint64_t>(most, size / rowSize);
  std::uint64_t taken = 0;
  for (; taken < rows; ++taken)
  {
    const unsigned char* row = bytes + rowSize * taken;
    const std::array<std::uint64_t, 3> points{ Load32(row + 1), Load32(row + 5), Load32(row + 9) };
    if (row[0] != 3 || points[0] >= end || points[1] >= end || points[2] >= end)
    {
      break;
    }
    corners.insert(corners.end(), points.begin(), points.end());
  }
  this->Stream.Skip(rowSize * taken);
  this->Row += taken;
  return taken;
}

bool vtkMTPlyRows::CheckIsAtEnd(std::string& error)
{
  const std::uint64_t left = this->Stream.GetLeft();
  while (const unsigned char* byte = this->Stream.Take(1))
  {
    if (*byte != ' ' && *byte != '\t' && *byte != '\n' && *byte != '\r' && *byte != 0 && *byte != 0x1a)
    {
      error = "has " + std::to_string(left) + " bytes after the last element that its header announces";
      return false;
    }
  }
  return true;
}
