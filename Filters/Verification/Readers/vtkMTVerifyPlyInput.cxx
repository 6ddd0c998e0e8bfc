// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyPlyInput.h"

#include "vtkMTVerifyMesh.h"
#include "vtkMTVerifyPlyColors.h"
#include "vtkMTVerifyText.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>

namespace
{
struct Property
{
  std::string Name;
  std::string Type;
  std::string CountType; // of a list; else empty
};

struct Element
{
  std::string Name;
  std::size_t Count = 0;
  std::vector<Property> Properties;
};

// What a row of an element holds: a number for each property, and the numbers of each list.
struct Row
{
  std::vector<double> Values;
  std::vector<std::vector<double>> Lists;
};

std::size_t GetSize(const std::string& type)
{
  static const std::map<std::string, std::size_t> sizes = { { "char", 1 }, { "int8", 1 }, { "uchar", 1 },
    { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 }, { "int", 4 }, { "int32", 4 },
    { "uint", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

double Convert(std::uint64_t bits, const std::string& type)
{
  const std::size_t size = GetSize(type);
  if (type[0] == 'f' && size == 4)
  {
    const auto low = static_cast<std::uint32_t>(bits);
    float value = 0.0f;
    std::memcpy(&value, &low, sizeof(value));
    return value;
  }
  if (size == 8)
  {
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  const bool isNegative = type[0] != 'u' && (bits >> (8 * size - 1)) != 0;
  return static_cast<double>(bits) - (isNegative ? std::ldexp(1.0, static_cast<int>(8 * size)) : 0.0);
}

class Body
{
public:
  Body(std::string_view bytes, const std::string& format)
    : Bytes(bytes)
    , Lines(bytes)
    , IsText(format == "ascii")
    , IsBig(format == "binary_big_endian")
  {
  }

  bool ReadRow(const Element& element, Row& row)
  {
    row.Values.assign(element.Properties.size(), 0.0);
    row.Lists.assign(element.Properties.size(), {});
    this->Word = this->Words.size(); // what else is on a line of text belongs to nothing
    for (std::size_t p = 0; p < element.Properties.size(); ++p)
    {
      const Property& property = element.Properties[p];
      if (property.CountType.empty() ? !this->Read(property.Type, row.Values[p])
                                     : !this->ReadList(property, row.Lists[p]))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool ReadList(const Property& property, std::vector<double>& list)
  {
    double count = 0.0;
    if (!this->Read(property.CountType, count) || !(count >= 0.0) || count > static_cast<double>(this->Bytes.size()))
    {
      return false;
    }
    list.resize(static_cast<std::size_t>(count));
    return std::all_of(list.begin(), list.end(), [&](double& value) { return this->Read(property.Type, value); });
  }

  bool Read(const std::string& type, double& value)
  {
    if (this->IsText)
    {
      std::string_view line;
      while (this->Word >= this->Words.size())
      {
        if (!this->Lines.Next(line))
        {
          return false;
        }
        this->Words = vtkMTVerifyText::Split(line);
        this->Word = 0;
      }
      return vtkMTVerifyText::ParseNumber(this->Words[this->Word++], value);
    }
    const std::size_t size = GetSize(type);
    if (size > this->Bytes.size() - this->Position)
    {
      return false;
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t place = this->IsBig ? size - 1 - i : i;
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(this->Bytes[this->Position + i])) << (8 * place);
    }
    this->Position += size;
    value = Convert(bits, type);
    return true;
  }

  std::string_view Bytes;
  vtkMTVerifyText Lines;
  bool IsText;
  bool IsBig;
  std::size_t Position = 0;
  std::vector<std::string_view> Words;
  std::size_t Word = 0;
};

bool ReadHeader(vtkMTVerifyText& lines, std::string& format, std::vector<Element>& elements, std::string& error)
{
  std::string_view line;
  while (lines.Next(line))
  {
    const std::vector<std::string_view> words = vtkMTVerifyText::Split(line);
    const std::string keyword(words.empty() ? "" : words[0]);
    long long count = 0;
    if (keyword == "format" && words.size() > 1)
    {
      format = words[1];
    }
    else if (keyword == "element" && words.size() > 2 && vtkMTVerifyText::ParseInteger(words[2], count) && count >= 0)
    {
      elements.push_back({ std::string(words[1]), static_cast<std::size_t>(count), {} });
    }
    else if (keyword == "property" && !elements.empty() && words.size() > 2)
    {
      const bool isList = words[1] == "list" && words.size() > 4;
      Property property{ std::string(words[isList ? 4 : 2]), std::string(words[isList ? 3 : 1]),
        std::string(isList ? words[2] : std::string_view()) };
      if (GetSize(property.Type) == 0 || (isList && GetSize(property.CountType) == 0))
      {
        error = "has a property of a type that is not one of PLY's";
        return false;
      }
      elements.back().Properties.push_back(property);
    }
    else if (keyword == "end_header")
    {
      return true;
    }
  }
  error = "has no end_header";
  return false;
}

// Where properties become one array: by their names, in the order of the components.
struct Group
{
  const char* Array;
  vtkMTVerifyMesh::KindType Kind;
  std::vector<const char*> Names;
};
const std::vector<Group> Groups = { { "Normals", vtkMTVerifyMesh::Normals, { "nx", "ny", "nz" } },
  { "RGBA", vtkMTVerifyMesh::Colors, { "red", "green", "blue", "alpha" } },
  { "RGB", vtkMTVerifyMesh::Colors, { "red", "green", "blue" } },
  { "RGBA", vtkMTVerifyMesh::Colors, { "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha" } },
  { "RGB", vtkMTVerifyMesh::Colors, { "diffuse_red", "diffuse_green", "diffuse_blue" } },
  { "RGBA", vtkMTVerifyMesh::Colors, { "r", "g", "b", "a" } }, { "RGB", vtkMTVerifyMesh::Colors, { "r", "g", "b" } },
  { "TCoords", vtkMTVerifyMesh::Coordinates, { "s", "t" } }, { "TCoords", vtkMTVerifyMesh::Coordinates, { "u", "v" } },
  { "TCoords", vtkMTVerifyMesh::Coordinates, { "texture_u", "texture_v" } },
  { "TCoords", vtkMTVerifyMesh::Coordinates, { "texture_s", "texture_t" } } };

// A column of an array: which property, of which type.
struct Source
{
  std::size_t Property;
  std::string Type;
};

class Columns
{
public:
  Columns(const Element& element, bool isOfCells, vtkMTVerifyMesh& mesh)
    : Mesh(mesh)
  {
    std::vector<bool> taken(element.Properties.size(), false);
    const auto find = [&](const std::string& name)
    {
      std::size_t p = 0;
      for (; p < taken.size(); ++p)
      {
        if (element.Properties[p].Name == name && element.Properties[p].CountType.empty() && !taken[p])
        {
          break;
        }
      }
      return p;
    };
    for (std::size_t axis = 0; !isOfCells && axis < 3; ++axis)
    {
      this->Places[axis] = find(std::string(1, static_cast<char>('x' + axis)));
      this->HasPlaces = this->HasPlaces && this->Places[axis] < taken.size();
      taken.at(std::min(this->Places[axis], taken.size() - 1)) = true;
    }
    for (const Group& group : Groups)
    {
      std::vector<Source> sources;
      for (const char* name : group.Names)
      {
        const std::size_t p = find(name);
        if (p < taken.size())
        {
          sources.push_back({ p, element.Properties[p].Type });
        }
      }
      if (sources.size() == group.Names.size())
      {
        std::for_each(sources.begin(), sources.end(), [&](const Source& source) { taken[source.Property] = true; });
        this->Add(group.Array, group.Kind, isOfCells, sources);
      }
    }
    for (std::size_t p = 0; p < taken.size(); ++p)
    {
      if (!taken[p] && element.Properties[p].CountType.empty())
      {
        this->Add(element.Properties[p].Name, vtkMTVerifyMesh::Plain, isOfCells, { { p, {} } });
      }
    }
  }

  void Append(const Row& row)
  {
    for (std::size_t a = 0; a < this->Sources.size(); ++a)
    {
      for (const Source& source : this->Sources[a])
      {
        this->Mesh.Arrays[this->First[a]].Values.push_back(row.Values[source.Property]);
      }
    }
  }

  // Behind the last row: only then is it known what the values of a colour count to.
  void ScaleColors()
  {
    for (std::size_t a = 0; a < this->Sources.size(); ++a)
    {
      if (this->Mesh.Arrays[this->First[a]].Kind == vtkMTVerifyMesh::Colors)
      {
        std::vector<std::string> types;
        std::transform(this->Sources[a].begin(), this->Sources[a].end(), std::back_inserter(types),
          [](const Source& source) { return source.Type; });
        vtkMTVerifyPlyColors::Scale(types, this->Mesh.Arrays[this->First[a]].Values);
      }
    }
  }

  std::array<std::size_t, 3> Places{ 0, 0, 0 };
  bool HasPlaces = true;

private:
  void Add(const std::string& name, vtkMTVerifyMesh::KindType kind, bool isOfCells, const std::vector<Source>& sources)
  {
    this->Mesh.GetArray(name, kind, isOfCells, static_cast<int>(sources.size()));
    this->First.push_back(this->Mesh.Arrays.size() - 1);
    this->Sources.push_back(sources);
  }

  vtkMTVerifyMesh& Mesh;
  std::vector<std::size_t> First;
  std::vector<std::vector<Source>> Sources;
};

std::vector<vtkIdType> ToIds(const std::vector<double>& list)
{
  std::vector<vtkIdType> ids(list.size());
  std::transform(list.begin(), list.end(), ids.begin(), [](double x) { return static_cast<vtkIdType>(x); });
  return ids;
}

void AddStrip(const std::vector<vtkIdType>& ids, std::vector<std::vector<vtkIdType>>& triangles)
{
  std::size_t begin = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (ids[i] < 0) // a new strip begins
    {
      begin = i + 1;
    }
    else if (i >= begin + 2)
    {
      const bool isOdd = (i - begin) % 2 == 1;
      triangles.push_back({ ids[i - 2], ids[i - (isOdd ? 0 : 1)], ids[i - (isOdd ? 1 : 0)] });
    }
  }
}

bool ReadVertices(const Element& element, Body& body, vtkMTVerifyMesh& mesh, std::string& error)
{
  if (element.Properties.empty())
  {
    error = "has vertices without coordinates";
    return false;
  }
  Columns columns(element, false, mesh);
  Row row;
  for (std::size_t i = 0; i < element.Count; ++i)
  {
    if (!columns.HasPlaces || !body.ReadRow(element, row))
    {
      error = columns.HasPlaces ? "ends within its vertices" : "has vertices without coordinates";
      return false;
    }
    const std::array<std::size_t, 3>& p = columns.Places;
    mesh.Points.push_back({ row.Values[p[0]], row.Values[p[1]], row.Values[p[2]] });
    columns.Append(row);
  }
  columns.ScaleColors();
  return true;
}

bool ReadFaces(const Element& element, Body& body, vtkMTVerifyMesh& mesh, std::string& error)
{
  const auto list = std::find_if(element.Properties.begin(), element.Properties.end(),
    [](const Property& property)
    { return !property.CountType.empty() && property.Name.compare(0, 8, "vertex_i") == 0; });
  if (list == element.Properties.end())
  {
    error = "has faces without vertices";
    return false;
  }
  const bool isStrip = element.Name == "tristrips";
  Columns columns(isStrip ? Element() : element, true, mesh);
  Row row;
  for (std::size_t i = 0; i < element.Count; ++i)
  {
    if (!body.ReadRow(element, row))
    {
      error = "ends within its faces";
      return false;
    }
    const std::vector<vtkIdType> ids = ToIds(row.Lists[static_cast<std::size_t>(list - element.Properties.begin())]);
    if (isStrip)
    {
      AddStrip(ids, mesh.Polygons);
      continue;
    }
    mesh.Polygons.push_back(ids);
    columns.Append(row);
  }
  columns.ScaleColors();
  return true;
}
}

bool vtkMTVerifyPlyInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  std::string bytes;
  if (!vtkMTVerifyText::Load(path, bytes, error) || !vtkMTVerifyText::IsReadable(bytes, error))
  {
    return false;
  }
  const std::string_view text = vtkMTVerifyText::SkipMark(bytes);
  vtkMTVerifyText lines(text);
  std::string format;
  std::vector<Element> elements;
  if (!ReadHeader(lines, format, elements, error))
  {
    return false;
  }
  Body body(text.substr(std::min(lines.GetPosition(), text.size())), format);
  vtkMTVerifyMesh mesh;
  Row row;
  for (const Element& element : elements)
  {
    bool good = true;
    if (element.Name == "vertex")
    {
      good = ReadVertices(element, body, mesh, error);
    }
    else if (element.Name == "face" || element.Name == "tristrips")
    {
      good = ReadFaces(element, body, mesh, error);
    }
    else
    {
      for (std::size_t i = 0; good && i < element.Count; ++i)
      {
        good = body.ReadRow(element, row);
      }
      error = good ? error : "ends within its element " + element.Name;
    }
    if (!good)
    {
      return false;
    }
  }
  mesh.Give(out);
  return true;
}
