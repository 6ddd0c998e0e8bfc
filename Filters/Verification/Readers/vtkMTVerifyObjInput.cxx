// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyObjInput.h"

#include "vtkMTVerifyMesh.h"
#include "vtkMTVerifyText.h"

#include <algorithm>
#include <limits>
#include <map>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Words = std::vector<std::string_view>;
using Corner = std::array<vtkIdType, 3>; // place, texture coordinate, normal; -1: none

class Reader
{
public:
  explicit Reader(vtkMTVerifyMesh& mesh)
    : Mesh(mesh)
  {
  }

  void ReadLine(std::string_view line)
  {
    Words words = vtkMTVerifyText::Split(line); // a comment begins a word: "1.#QNAN" has none
    words.erase(
      std::find_if(words.begin(), words.end(), [](std::string_view word) { return word[0] == '#'; }), words.end());
    const std::string_view keyword = words.empty() ? std::string_view() : words[0];
    if (keyword == "v")
    {
      this->AddVertex(words);
    }
    else if (keyword == "vt" || keyword == "vn")
    {
      std::array<double, 3> x{ 0.0, 0.0, 0.0 };
      for (std::size_t i = 0; i < 3 && i + 1 < words.size(); ++i)
      {
        x[i] = vtkMTVerifyText::ParseNumber(words[i + 1], x[i]) ? x[i] : NaN;
      }
      (keyword == "vt" ? this->Coordinates : this->Normals).push_back(x);
    }
    else if (keyword == "f" || keyword == "fo")
    {
      this->AddFace(words);
    }
    else if (keyword == "g" || keyword == "usemtl")
    {
      std::string& name = keyword == "g" ? this->Group : this->Material;
      name.clear();
      for (std::size_t i = 1; i < words.size(); ++i)
      {
        name += (i > 1 ? " " : "") + std::string(words[i]);
      }
    }
  }

  void Finish()
  {
    // Points of the file become those of corners: one for each different corner that a face names.
    std::map<Corner, vtkIdType> points;
    std::vector<Corner> corners;
    for (std::size_t f = 0; f < this->Mesh.Polygons.size(); ++f)
    {
      std::size_t index = this->FirstCorner[f];
      for (vtkIdType& point : this->Mesh.Polygons[f])
      {
        const auto added = points.emplace(this->Corners[index], static_cast<vtkIdType>(corners.size()));
        if (added.second)
        {
          corners.push_back(this->Corners[index]);
        }
        point = added.first->second;
        ++index;
      }
    }
    this->GiveArrays(corners);
  }

private:
  void AddVertex(const Words& words)
  {
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      double value = NaN;
      numbers.push_back(vtkMTVerifyText::ParseNumber(words[i], value) ? value : NaN);
    }
    const std::size_t count = numbers.size();
    numbers.resize(std::max<std::size_t>(count, 8), NaN);
    this->Places.push_back({ numbers[0], numbers[1], numbers[2] });
    std::array<double, 4> color{ NaN, NaN, NaN, NaN };
    if (count >= 6)
    {
      color = { numbers[3], numbers[4], numbers[5], count >= 7 ? numbers[6] : 1.0 };
      this->HasColors = true;
      this->HasAlpha = this->HasAlpha || count >= 7;
    }
    this->Colors.push_back(color);
  }

  // An index of OBJ: from 1, or from the end when negative. -1 when there is no such entry, or no index.
  static vtkIdType Resolve(std::string_view word, std::size_t count)
  {
    long long index = 0;
    if (!vtkMTVerifyText::ParseInteger(word, index))
    {
      return -1;
    }
    index = index < 0 ? index + static_cast<long long>(count) : index - 1;
    return index < 0 || index >= static_cast<long long>(count) ? -1 : static_cast<vtkIdType>(index);
  }

  void AddFace(const Words& words)
  {
    const std::size_t first = this->Corners.size();
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      std::array<std::string_view, 3> parts;
      std::string_view rest = words[i];
      for (std::string_view& part : parts)
      {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        part = rest.substr(0, slash);
        rest.remove_prefix(std::min(slash + 1, rest.size()));
      }
      this->Corners.push_back({ Resolve(parts[0], this->Places.size()), Resolve(parts[1], this->Coordinates.size()),
        Resolve(parts[2], this->Normals.size()) });
    }
    if (this->Corners.size() - first < 3)
    {
      this->Corners.resize(first);
      return;
    }
    this->FirstCorner.push_back(first);
    this->Mesh.Polygons.emplace_back(this->Corners.size() - first);
    this->Names[0].push_back(this->Group);
    this->Names[1].push_back(this->Material);
  }

  template <std::size_t N>
  void GiveArray(const std::string& name, vtkMTVerifyMesh::KindType kind, const std::vector<Corner>& corners, int which,
    int components, const std::vector<std::array<double, N>>& values)
  {
    vtkMTVerifyMesh::Array& array = this->Mesh.GetArray(name, kind, false, components);
    for (const Corner& corner : corners)
    {
      for (int c = 0; c < components; ++c)
      {
        array.Values.push_back(corner[which] < 0 ? NaN : values[static_cast<std::size_t>(corner[which])][c]);
      }
    }
  }

  void GiveArrays(const std::vector<Corner>& corners)
  {
    for (const Corner& corner : corners)
    {
      // A place that is not there is told from one that is not finite by its index, which is made to miss.
      this->Mesh.Points.push_back(corner[0] < 0 ? std::array<double, 3>{ NaN, NaN, NaN } : this->Places[corner[0]]);
    }
    const auto has = [&](int which)
    { return std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) { return corner[which] >= 0; }); };
    for (std::vector<vtkIdType>& polygon : this->Mesh.Polygons)
    {
      for (vtkIdType& point : polygon)
      {
        point = corners[static_cast<std::size_t>(point)][0] < 0 ? -1 : point;
      }
    }
    if (has(1))
    {
      this->GiveArray("TCoords", vtkMTVerifyMesh::Coordinates, corners, 1, 2, this->Coordinates);
    }
    if (has(2))
    {
      this->GiveArray("Normals", vtkMTVerifyMesh::Normals, corners, 2, 3, this->Normals);
    }
    if (this->HasColors)
    {
      const bool isAlpha = this->HasAlpha;
      this->GiveArray(isAlpha ? "RGBA" : "RGB", vtkMTVerifyMesh::Colors, corners, 0, isAlpha ? 4 : 3, this->Colors);
    }
    const char* const titles[2] = { "GroupIds", "MaterialIds" };
    for (int i = 0; i < 2; ++i)
    {
      vtkMTVerifyMesh::Array names;
      std::vector<double> values;
      std::transform(this->Names[i].begin(), this->Names[i].end(), std::back_inserter(values),
        [&](const std::string& name) { return vtkMTVerifyMesh::GetIndexOfName(names, name); });
      if (names.Names.size() > 1)
      {
        vtkMTVerifyMesh::Array& array = this->Mesh.GetArray(titles[i], vtkMTVerifyMesh::Names, true, 1);
        array.Values = values;
        array.Names = names.Names;
      }
    }
  }

  vtkMTVerifyMesh& Mesh;
  std::vector<std::array<double, 3>> Places;
  std::vector<std::array<double, 4>> Colors;
  bool HasColors = false;
  bool HasAlpha = false;
  std::vector<std::array<double, 3>> Coordinates;
  std::vector<std::array<double, 3>> Normals;
  std::vector<Corner> Corners;
  std::vector<std::size_t> FirstCorner; // of each polygon
  std::string Group;
  std::string Material;
  std::vector<std::string> Names[2]; // of each polygon's group and material
};
}

bool vtkMTVerifyObjInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  std::string bytes;
  if (!vtkMTVerifyText::Load(path, bytes, error) || !vtkMTVerifyText::IsReadable(bytes, error))
  {
    return false;
  }
  vtkMTVerifyMesh mesh;
  Reader reader(mesh);
  vtkMTVerifyText lines(vtkMTVerifyText::SkipMark(bytes));
  std::string_view line;
  std::string joined;
  while (lines.Next(line))
  {
    const std::size_t last = line.find_last_not_of(" \t");
    const bool goesOn = last != std::string_view::npos && line[last] == '\\';
    joined.append(line.substr(0, goesOn ? last : line.size())).append(goesOn ? " " : "");
    if (!goesOn)
    {
      reader.ReadLine(joined);
      joined.clear();
    }
  }
  reader.ReadLine(joined);
  reader.Finish();
  mesh.Give(out);
  return true;
}
