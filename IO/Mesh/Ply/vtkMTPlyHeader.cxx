// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyHeader.h"

#include "vtkType.h"

#include <algorithm>
#include <limits>

namespace
{
using vtkMTTextFormat::NextToken;

constexpr std::size_t LargestHeaderLine = 65536;
constexpr std::size_t MostHeaderLines = 65536;

struct TypeName
{
  const char* Name;
  const char* Other;
  int Value;
};
constexpr TypeName TypeNames[] = { { "char", "int8", VTK_SIGNED_CHAR }, { "uchar", "uint8", VTK_UNSIGNED_CHAR },
  { "short", "int16", VTK_SHORT }, { "ushort", "uint16", VTK_UNSIGNED_SHORT }, { "int", "int32", VTK_INT },
  { "uint", "uint32", VTK_UNSIGNED_INT }, { "float", "float32", VTK_FLOAT }, { "double", "float64", VTK_DOUBLE } };

// 0 for a name that is no type of PLY.
int ParseType(std::string_view name)
{
  for (const TypeName& type : TypeNames)
  {
    if (name == type.Name || name == type.Other)
    {
      return type.Value;
    }
  }
  return 0;
}
}

const vtkMTPlyProperty* vtkMTPlyElement::FindCorners() const
{
  const vtkMTPlyProperty* corners = this->Find("vertex_indices");
  return corners ? corners : this->Find("vertex_index");
}

const vtkMTPlyProperty* vtkMTPlyElement::Find(const std::string& name) const
{
  for (const vtkMTPlyProperty& property : this->Properties)
  {
    if (property.Name == name)
    {
      return &property;
    }
  }
  return nullptr;
}

const vtkMTPlyElement* vtkMTPlyHeader::Find(const std::string& name) const
{
  for (const vtkMTPlyElement& element : this->Elements)
  {
    if (element.Name == name)
    {
      return &element;
    }
  }
  return nullptr;
}

vtkMTInputReport vtkMTPlyHeader::GetReport() const
{
  vtkMTInputReport report;
  vtkMTInputReports::Add("ignored_header_lines", this->IgnoredLines, report);
  vtkMTInputReports::Add("renamed_properties", this->RenamedProperties, report);
  return report;
}

std::size_t vtkMTPlyHeader::GetSize(int type)
{
  switch (type)
  {
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
      return 1;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return 2;
    case VTK_DOUBLE:
      return 8;
    default:
      return 4;
  }
}

std::uint64_t vtkMTPlyHeader::GetSmallestRow(const vtkMTPlyElement& element) const
{
  std::uint64_t size = 0;
  for (const vtkMTPlyProperty& property : element.Properties)
  {
    // In text a number takes a digit and what ends it.
    size += this->Format == Ascii ? 2 : GetSize(property.IsList() ? property.CountType : property.Type);
  }
  return size;
}

bool vtkMTPlyHeader::ParseFormat(std::string_view line, std::string& error)
{
  const std::string_view name = NextToken(line);
  const std::string_view version = NextToken(line);
  const bool isKnown = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
  if (!isKnown || version != "1.0" || this->HasFormat)
  {
    error = this->HasFormat ? "a second format"
                            : "format \"" + std::string(name) + " " + std::string(version) + "\" is unknown";
    return false;
  }
  this->Format = name == "ascii" ? Ascii : name == "binary_little_endian" ? LittleEndian : BigEndian;
  this->HasFormat = true;
  return true;
}

bool vtkMTPlyHeader::ParseElement(std::string_view line, std::string& error)
{
  vtkMTPlyElement element;
  element.Name = std::string(NextToken(line));
  const std::string_view count = NextToken(line);
  std::int64_t number = 0;
  if (element.Name.empty() || !vtkMTTextFormat::ToNumber(count, number) || number < 0)
  {
    error = "element \"" + element.Name + "\" has the impossible count \"" + std::string(count) + "\"";
    return false;
  }
  if (this->Find(element.Name))
  {
    error = "element \"" + element.Name + "\" comes twice";
    return false;
  }
  element.Count = static_cast<std::uint64_t>(number);
  this->Elements.push_back(std::move(element));
  return true;
}

bool vtkMTPlyHeader::ParseProperty(std::string_view line, std::string& error)
{
  if (this->Elements.empty())
  {
    error = "a property comes before the first element";
    return false;
  }
  vtkMTPlyElement& element = this->Elements.back();
  vtkMTPlyProperty property;
  std::string_view type = NextToken(line);
  if (type == "list")
  {
    const std::string_view countType = NextToken(line);
    property.CountType = ParseType(countType);
    if (property.CountType == 0 || property.CountType == VTK_FLOAT || property.CountType == VTK_DOUBLE)
    {
      error = "a list cannot have a count of type \"" + std::string(countType) + "\"";
      return false;
    }
    type = NextToken(line);
  }
  property.Type = ParseType(type);
  property.Name = std::string(NextToken(line));
  if (property.Type == 0 || property.Name.empty())
  {
    error = property.Type == 0 ? "type \"" + std::string(type) + "\" is unknown" : "a property has no name";
    return false;
  }
  if (element.Find(property.Name))
  {
    ++this->RenamedProperties;
    do
    {
      property.Name += "_";
    } while (element.Find(property.Name));
  }
  element.Properties.push_back(std::move(property));
  return true;
}

bool vtkMTPlyHeader::ParseLine(std::string_view line, bool& isAtEnd, std::string& error)
{
  const std::string_view keyword = NextToken(line);
  if (keyword.empty() || keyword == "comment" || keyword == "obj_info")
  {
    const bool isTexture = keyword == "comment" && NextToken(line) == "TextureFile";
    const std::size_t first = isTexture ? line.find_first_not_of(" \t") : std::string_view::npos;
    if (first != std::string_view::npos)
    {
      this->TextureFiles.emplace_back(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
    }
    return true;
  }
  if (keyword == "format")
  {
    return this->ParseFormat(line, error);
  }
  if (keyword == "element")
  {
    return this->ParseElement(line, error);
  }
  if (keyword == "property")
  {
    return this->ParseProperty(line, error);
  }
  // Some programs write their name into a line of its own; what is no keyword announces no data.
  isAtEnd = keyword == "end_header";
  this->IgnoredLines += isAtEnd ? 0 : 1;
  return true;
}

bool vtkMTPlyHeader::ParseLines(vtkMTTextFormat::Stream& stream, std::string& error)
{
  std::string_view line;
  bool isAtEnd = false;
  for (std::size_t number = 2; !isAtEnd; ++number)
  {
    if (!stream.TakeLine(line) || line.size() > LargestHeaderLine || number > MostHeaderLines)
    {
      error = stream.GetError().empty() ? "ends within its header, or has none" : stream.GetError();
      return false;
    }
    if (!this->ParseLine(line, isAtEnd, error))
    {
      error = "header line " + std::to_string(number) + ": " + error;
      return false;
    }
  }
  error = this->HasFormat ? error : "has no format in its header";
  return this->HasFormat;
}

bool vtkMTPlyHeader::Parse(vtkMTTextFormat::Stream& stream, std::string& error)
{
  using Stream = vtkMTTextFormat::Stream;
  *this = vtkMTPlyHeader();
  stream.SkipByteOrderMark();
  std::string_view line;
  if (!stream.TakeLine(line) || line.size() > LargestHeaderLine)
  {
    error = !stream.GetError().empty() ? stream.GetError()
      : stream.IsAtEnd()               ? "is empty"
                                       : "does not begin with \"ply\"";
    return false;
  }
  if (NextToken(line) != "ply")
  {
    error = "does not begin with \"ply\"";
    return false;
  }
  const Stream::LineEndType lineEnd = stream.GetLineEnd();
  if (!this->ParseLines(stream, error))
  {
    return false;
  }
  // Where lines end in a return alone, a newline after the last one is the first byte of the data.
  if (lineEnd == Stream::Return && stream.GetLineEnd() == Stream::ReturnAndNewLine)
  {
    stream.GiveNewLineBack();
  }
  return true;
}

const char* vtkMTPlyHeader::GetTypeName(int type)
{
  constexpr int PlainChar = std::numeric_limits<char>::is_signed ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
  for (const TypeName& entry : TypeNames)
  {
    if (entry.Value == (type == VTK_CHAR ? PlainChar : type))
    {
      return entry.Name;
    }
  }
  return "";
}

bool vtkMTPlyHeader::CheckIsMesh(std::string& error) const
{
  const vtkMTPlyElement* vertex = this->Find("vertex");
  if (!vertex)
  {
    error = "has no element vertex";
    return false;
  }
  for (const char* name : { "x", "y", "z" })
  {
    const vtkMTPlyProperty* property = vertex->Find(name);
    if (!property || property->IsList())
    {
      error = std::string("its element vertex has no property ") + name;
      return false;
    }
  }
  for (const char* name : { "face", "tristrips" })
  {
    const vtkMTPlyElement* element = this->Find(name);
    const vtkMTPlyProperty* indices = element ? element->FindCorners() : nullptr;
    const bool isGood = indices && indices->IsList() && indices->Type != VTK_FLOAT && indices->Type != VTK_DOUBLE;
    if (element && element->Count > 0 && !isGood)
    {
      error = std::string("its element ") + name + " has no list of whole numbers vertex_indices";
      return false;
    }
  }
  return true;
}
