// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLegacyCheck.h"

#include "vtkMTTextFormat.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
using vtkMTTextFormat::NextToken;

// Bytes of one value in binary; 0 for what has no fixed size.
std::size_t SizeOf(const std::string& type)
{
  static const std::pair<const char*, std::size_t> sizes[] = { { "char", 1 }, { "unsigned_char", 1 },
    { "signed_char", 1 }, { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 }, { "unsigned_int", 4 }, { "float", 4 },
    { "vtkidtype", 4 }, { "long", 8 }, { "unsigned_long", 8 }, { "double", 8 }, { "vtktypeint64", 8 },
    { "vtktypeuint64", 8 }, { "vtktypeint32", 4 }, { "vtktypeuint32", 4 } };
  const auto* found =
    std::find_if(std::begin(sizes), std::end(sizes), [&type](const auto& entry) { return type == entry.first; });
  return found == std::end(sizes) ? 0 : found->second;
}

class Checker
{
public:
  explicit Checker(const vtkMTByteSource& bytes)
    : Stream(bytes)
  {
  }

  bool Check(std::string& error)
  {
    const bool done = this->CheckHead() && this->CheckSections();
    error = done ? error : this->Stream.GetError().empty() ? this->Error : this->Stream.GetError();
    if (done && this->Type.empty())
    {
      error = "holds no polydata, and no grid that has a surface";
    }
    return done && !this->Type.empty();
  }

private:
  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }

  // The next line that is not blank, in which Line then stands before the first token.
  bool TakeLine()
  {
    while (this->Stream.TakeLine(this->Line))
    {
      std::string_view rest = this->Line;
      if (!NextToken(rest).empty())
      {
        return true;
      }
    }
    return false;
  }

  bool CheckHead()
  {
    std::string_view title;
    if (!this->TakeLine() || !this->ReadVersion() || !this->Stream.TakeLine(title) || !this->TakeLine())
    {
      return this->Fail("ends within its header");
    }
    const std::string format = vtkMTTextFormat::ToLower(NextToken(this->Line));
    this->IsBinary = format == "binary";
    return this->IsBinary || format == "ascii" || this->Fail("is neither ASCII nor BINARY");
  }

  bool ReadVersion()
  {
    const std::size_t place = this->Line.find("Version ");
    this->IsNew = place != std::string_view::npos && place + 8 < this->Line.size() && this->Line[place + 8] >= '5' &&
      this->Line[place + 8] <= '9';
    return true;
  }

  bool CheckSections()
  {
    while (this->TakeLine())
    {
      const std::string keyword = vtkMTTextFormat::ToLower(NextToken(this->Line));
      if (keyword == "point_data" || keyword == "cell_data")
      {
        return true;
      }
      if (!this->CheckSection(keyword))
      {
        return false;
      }
    }
    return this->Stream.GetError().empty();
  }

  bool CheckSection(const std::string& keyword)
  {
    if (keyword == "points")
    {
      return this->CheckPoints();
    }
    if (keyword == "vertices" || keyword == "lines" || keyword == "polygons" || keyword == "triangle_strips" ||
      keyword == "cells")
    {
      const bool done = this->IsNew ? this->CheckNewCells() : this->CheckOldCells();
      this->Error = done ? this->Error : keyword + ": " + this->Error;
      return done;
    }
    if (keyword == "field")
    {
      return this->SkipField();
    }
    if (keyword == "metadata")
    {
      this->SkipMetadata();
      return true;
    }
    if (keyword == "dataset")
    {
      return this->CheckType();
    }
    if (keyword == "cell_types")
    {
      std::uint64_t count = 0;
      return this->TakeCount(count) && this->SkipValues(count, 4);
    }
    if (keyword == "x_coordinates" || keyword == "y_coordinates" || keyword == "z_coordinates")
    {
      return this->SkipCoordinates();
    }
    return keyword == "dimensions" ||
      this->Fail("\"" + keyword.substr(0, 40) + "\" is no keyword of polydata or grids");
  }

  bool CheckType()
  {
    this->Type = vtkMTTextFormat::ToLower(NextToken(this->Line));
    return this->Type == "polydata" || this->Type == "unstructured_grid" || this->Type == "structured_grid" ||
      this->Type == "rectilinear_grid" ||
      this->Fail("holds no polydata, and no grid that has a surface, but " + this->Type.substr(0, 40));
  }

  bool SkipCoordinates()
  {
    std::uint64_t count = 0;
    return this->TakeCount(count) && this->SkipValues(count, SizeOf(vtkMTTextFormat::ToLower(NextToken(this->Line))));
  }

  // A count that follows a keyword.
  bool TakeCount(std::uint64_t& count)
  {
    std::int64_t value = 0;
    if (!vtkMTTextFormat::ToNumber(NextToken(this->Line), value) || value < 0)
    {
      return this->Fail("an impossible count");
    }
    count = static_cast<std::uint64_t>(value);
    return true;
  }

  // Whether so many values can be there.
  bool HasRoomFor(std::uint64_t count, std::size_t size)
  {
    const std::uint64_t each = this->IsBinary ? size : 2; // in text, a digit and what ends it
    return count <= (this->Stream.GetLeft() + 1) / each ||
      this->Fail("the file is too short for " + std::to_string(count) + " values");
  }

  bool SkipValues(std::uint64_t count, std::size_t size)
  {
    if (size == 0 || !this->HasRoomFor(count, size))
    {
      return size != 0 || this->Fail("values of an unknown type");
    }
    if (this->IsBinary)
    {
      return this->Stream.Skip(count * size) || this->Fail("the file is truncated");
    }
    std::string_view token;
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (!this->TakeToken(token))
      {
        return false;
      }
    }
    return true;
  }

  // Of text: the next token, from this line or the next.
  bool TakeToken(std::string_view& token)
  {
    token = NextToken(this->Line);
    while (token.empty())
    {
      if (!this->Stream.TakeLine(this->Line))
      {
        return this->Fail("the file is truncated");
      }
      token = NextToken(this->Line);
    }
    return true;
  }

  bool TakeInteger(std::size_t size, std::int64_t& value)
  {
    if (!this->IsBinary)
    {
      std::string_view token;
      return this->TakeToken(token) &&
        (vtkMTTextFormat::ToNumber(token, value) ||
          this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no whole number"));
    }
    const unsigned char* bytes = this->Stream.Take(size);
    if (!bytes)
    {
      return this->Fail("the file is truncated");
    }
    std::uint64_t bits = bytes[0] & 0x80 ? ~std::uint64_t(0) : 0; // big-endian, with a sign
    for (std::size_t i = 0; i < size; ++i)
    {
      bits = bits << 8 | bytes[i];
    }
    value = static_cast<std::int64_t>(bits);
    return true;
  }

  bool TakePoint(std::size_t size)
  {
    std::int64_t point = 0;
    return this->TakeInteger(size, point) &&
      ((point >= 0 && static_cast<std::uint64_t>(point) < this->Points) ||
        this->Fail("point " + std::to_string(point) + " does not exist; there are " + std::to_string(this->Points)));
  }

  bool CheckPoints()
  {
    if (!this->TakeCount(this->Points))
    {
      return false;
    }
    const std::string type = vtkMTTextFormat::ToLower(NextToken(this->Line));
    return this->HasRoomFor(this->Points, 3) &&
      (this->SkipValues(3 * this->Points, SizeOf(type)) || this->Fail("points: " + this->Error));
  }

  // Number of cells and of all values; then for each cell its number of points and they.
  bool CheckOldCells()
  {
    std::uint64_t cells = 0;
    std::uint64_t size = 0;
    if (!this->TakeCount(cells) || !this->TakeCount(size) || !this->HasRoomFor(size, 4))
    {
      return false;
    }
    std::uint64_t used = 0;
    for (std::uint64_t cell = 0; cell < cells; ++cell)
    {
      std::int64_t count = 0;
      if (used == size)
      {
        return this->Fail("has fewer values than cells need");
      }
      if (!this->TakeInteger(4, count))
      {
        return false;
      }
      ++used;
      if (count < 0 || static_cast<std::uint64_t>(count) > size - used)
      {
        return this->Fail("cell " + std::to_string(cell) + " has the impossible count " + std::to_string(count));
      }
      for (std::int64_t i = 0; i < count; ++i, ++used)
      {
        if (!this->TakePoint(4))
        {
          return false;
        }
      }
    }
    return used == size || this->Fail("has more values than cells need");
  }

  // Number of offsets and of points; then the offsets and the points.
  bool CheckNewCells()
  {
    std::uint64_t offsets = 0;
    std::uint64_t size = 0;
    std::size_t width = 0;
    if (!this->TakeCount(offsets) || !this->TakeCount(size) || !this->TakeArray("offsets", offsets, width))
    {
      return false;
    }
    std::int64_t last = 0;
    for (std::uint64_t i = 0; i < offsets; ++i)
    {
      std::int64_t offset = 0;
      if (!this->TakeInteger(width, offset))
      {
        return false;
      }
      if (offset < last || (i == 0 && offset != 0) || static_cast<std::uint64_t>(offset) > size)
      {
        return this->Fail("offset " + std::to_string(i) + " is impossible");
      }
      last = offset;
    }
    if (static_cast<std::uint64_t>(last) != size || !this->TakeArray("connectivity", size, width))
    {
      return this->Error.empty() ? this->Fail("the offsets do not end at the number of points") : false;
    }
    for (std::uint64_t i = 0; i < size; ++i)
    {
      if (!this->TakePoint(width))
      {
        return false;
      }
    }
    return true;
  }

  // The line before an array of whole numbers.
  bool TakeArray(const std::string& name, std::uint64_t count, std::size_t& width)
  {
    if (!this->TakeLine() || vtkMTTextFormat::ToLower(NextToken(this->Line)) != name)
    {
      return this->Fail("has no " + name);
    }
    width = SizeOf(vtkMTTextFormat::ToLower(NextToken(this->Line)));
    return width >= 4 ? this->HasRoomFor(count, width) : this->Fail("has " + name + " of an unknown type");
  }

  bool SkipArray(std::uint64_t count, const std::string& type)
  {
    if (type == "bit" && this->IsBinary)
    {
      return this->SkipValues((count + 7) / 8, 1);
    }
    if (type != "string" && type != "utf8_string")
    {
      return this->SkipValues(count, type == "bit" ? 1 : SizeOf(type));
    }
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (this->IsBinary ? !this->SkipBinaryString() : !this->Stream.TakeLine(this->Line))
      {
        return this->Fail("the file is truncated");
      }
    }
    this->Line = std::string_view();
    return true;
  }

  // The first two bits say in how many bytes the length is.
  bool SkipBinaryString()
  {
    const unsigned char* first = this->Stream.Take(1);
    if (!first)
    {
      return false;
    }
    static const int more[4] = { 7, 3, 1, 0 };
    const int count = more[*first >> 6];
    std::uint64_t length = *first & 0x3f;
    const unsigned char* bytes = this->Stream.Take(static_cast<std::size_t>(count));
    for (int i = 0; bytes && i < count; ++i)
    {
      length = length << 8 | bytes[i];
    }
    return bytes && this->Stream.Skip(length);
  }

  // Arrays of the dataset as a whole: name, components, tuples, type, then values.
  bool SkipField()
  {
    NextToken(this->Line); // its name
    std::uint64_t arrays = 0;
    if (!this->TakeCount(arrays))
    {
      return false;
    }
    for (std::uint64_t i = 0; i < arrays; ++i)
    {
      std::uint64_t components = 0;
      std::uint64_t tuples = 0;
      if (!this->TakeLine())
      {
        return this->Fail("ends within its field data");
      }
      const std::string name(NextToken(this->Line));
      if (vtkMTTextFormat::ToLower(name) == "metadata")
      {
        this->SkipMetadata();
        --i;
        continue;
      }
      if (!this->TakeCount(components) || !this->TakeCount(tuples))
      {
        return false;
      }
      const std::string type = vtkMTTextFormat::ToLower(NextToken(this->Line));
      if (components != 0 && tuples > this->Stream.GetLeft() / components)
      {
        return this->Fail("array " + name + " is longer than the file");
      }
      if (!this->SkipArray(components * tuples, type))
      {
        return false;
      }
    }
    return true;
  }

  // Up to a blank line.
  void SkipMetadata()
  {
    std::string_view line;
    while (this->Stream.TakeLine(line))
    {
      std::string_view rest = line;
      if (NextToken(rest).empty())
      {
        return;
      }
    }
  }

  vtkMTTextFormat::Stream Stream;
  std::string_view Line;
  bool IsBinary = false;
  bool IsNew = false;
  std::string Type; // of the dataset
  std::uint64_t Points = 0;
  std::string Error;
};
}

bool vtkMTLegacyCheck::Check(const vtkMTByteSource& bytes, std::string& error)
{
  return Checker(bytes).Check(error);
}
