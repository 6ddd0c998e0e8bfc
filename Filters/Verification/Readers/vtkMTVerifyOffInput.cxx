// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyOffInput.h"

#include "vtkMTVerifyMesh.h"
#include "vtkMTVerifyText.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Words = std::vector<std::string_view>;

bool NextWords(vtkMTVerifyText& lines, Words& words)
{
  std::string_view line;
  while (lines.Next(line))
  {
    words = vtkMTVerifyText::Split(line.substr(0, line.find('#')));
    if (!words.empty())
    {
      return true;
    }
  }
  return false;
}

std::vector<double> ToNumbers(const Words& words)
{
  std::vector<double> numbers;
  for (std::string_view word : words)
  {
    double value = NaN;
    numbers.push_back(vtkMTVerifyText::ParseNumber(word, value) ? value : NaN);
  }
  return numbers;
}

// Three or four numbers from `first` on as a colour from 0 to 1; NaN where there are fewer.
std::array<double, 4> GetColor(const std::vector<double>& numbers, const Words& words, std::size_t first)
{
  if (numbers.size() < first + 3)
  {
    return { NaN, NaN, NaN, NaN };
  }
  const std::size_t count = std::min<std::size_t>(numbers.size() - first, 4);
  const bool isReal = std::any_of(words.begin() + first, words.begin() + first + count,
    [](std::string_view word) { return word.find_first_of(".eE") != std::string_view::npos; });
  std::array<double, 4> color{ 0.0, 0.0, 0.0, 1.0 };
  for (std::size_t c = 0; c < count; ++c)
  {
    color[c] = numbers[first + c] / (isReal ? 1.0 : 255.0);
  }
  return color;
}

struct Header
{
  bool HasNormals = false;
  bool HasColors = false;
  bool HasCoordinates = false;
  std::size_t Vertices = 0;
  std::size_t Faces = 0;
};

bool ReadHeader(vtkMTVerifyText& lines, Header& header, std::string& error)
{
  Words words;
  if (!NextWords(lines, words))
  {
    error = "is empty";
    return false;
  }
  std::string prefix(words[0]);
  const std::size_t keyword = prefix.find("OFF");
  if (keyword != std::string::npos)
  {
    prefix.resize(keyword);
    header.HasCoordinates = prefix.find("ST") != std::string::npos;
    header.HasColors = prefix.find('C') != std::string::npos;
    header.HasNormals = prefix.find('N') != std::string::npos;
    words.erase(words.begin());
    const bool isOther = prefix.find('4') != std::string::npos || prefix.find('n') != std::string::npos;
    if (isOther || (!words.empty() && words[0] == "BINARY"))
    {
      error = "is binary, or of other than three dimensions";
      return false;
    }
  }
  long long vertices = -1, faces = -1;
  if ((words.empty() && !NextWords(lines, words)) || words.size() < 2 ||
    !vtkMTVerifyText::ParseInteger(words[0], vertices) || !vtkMTVerifyText::ParseInteger(words[1], faces) ||
    vertices < 0 || faces < 0)
  {
    error = "has no counts of vertices and faces";
    return false;
  }
  header.Vertices = static_cast<std::size_t>(vertices);
  header.Faces = static_cast<std::size_t>(faces);
  return true;
}

bool ReadVertices(vtkMTVerifyText& lines, const Header& header, vtkMTVerifyMesh& mesh)
{
  std::vector<double> normals, colors, coordinates;
  Words words;
  for (std::size_t i = 0; i < header.Vertices; ++i)
  {
    if (!NextWords(lines, words))
    {
      return false;
    }
    const std::vector<double> numbers = ToNumbers(words);
    const auto get = [&](std::size_t n) { return n < numbers.size() ? numbers[n] : NaN; };
    mesh.Points.push_back({ get(0), get(1), get(2) });
    std::size_t next = 3;
    if (header.HasNormals)
    {
      normals.insert(normals.end(), { get(next), get(next + 1), get(next + 2) });
      next += 3;
    }
    if (header.HasColors)
    {
      const std::array<double, 4> color = GetColor(numbers, words, next);
      colors.insert(colors.end(), color.begin(), color.end());
    }
    if (header.HasCoordinates) // at the end of the line, whatever is before them
    {
      coordinates.insert(coordinates.end(), { get(numbers.size() - 2), get(numbers.size() - 1) });
    }
  }
  if (header.HasNormals)
  {
    mesh.GetArray("Normals", vtkMTVerifyMesh::Normals, false, 3).Values = normals;
  }
  if (header.HasColors)
  {
    mesh.GetArray("RGBA", vtkMTVerifyMesh::Colors, false, 4).Values = colors;
  }
  if (header.HasCoordinates)
  {
    mesh.GetArray("TCoords", vtkMTVerifyMesh::Coordinates, false, 2).Values = coordinates;
  }
  return true;
}

bool ReadFaces(vtkMTVerifyText& lines, const Header& header, vtkMTVerifyMesh& mesh)
{
  std::vector<double> colors;
  bool isColored = false;
  Words words;
  for (std::size_t i = 0; i < header.Faces; ++i)
  {
    if (!NextWords(lines, words))
    {
      return false;
    }
    const std::vector<double> numbers = ToNumbers(words);
    const auto count = static_cast<std::size_t>(numbers[0] > 0.0 ? numbers[0] : 0.0);
    if (numbers.size() < count + 1)
    {
      return false;
    }
    std::vector<vtkIdType> polygon(count);
    std::transform(numbers.begin() + 1, numbers.begin() + 1 + count, polygon.begin(),
      [](double x) { return x >= 0.0 ? static_cast<vtkIdType>(x) : vtkIdType(-1); });
    mesh.Polygons.push_back(polygon);
    const std::array<double, 4> color = GetColor(numbers, words, count + 1);
    isColored = isColored || color[0] == color[0];
    colors.insert(colors.end(), color.begin(), color.end());
  }
  if (isColored)
  {
    mesh.GetArray("Colors", vtkMTVerifyMesh::Colors, true, 4).Values = colors;
  }
  return true;
}
}

bool vtkMTVerifyOffInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  std::string bytes;
  if (!vtkMTVerifyText::Load(path, bytes, error) || !vtkMTVerifyText::IsReadable(bytes, error))
  {
    return false;
  }
  vtkMTVerifyText lines(vtkMTVerifyText::SkipMark(bytes));
  Header header;
  vtkMTVerifyMesh mesh;
  if (!ReadHeader(lines, header, error))
  {
    return false;
  }
  if (!ReadVertices(lines, header, mesh) || !ReadFaces(lines, header, mesh))
  {
    error = "ends before its last vertex or face, or a face is incomplete";
    return false;
  }
  mesh.Give(out);
  return true;
}
