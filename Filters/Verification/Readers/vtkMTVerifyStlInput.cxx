// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyStlInput.h"

#include "vtkMTVerifyMesh.h"
#include "vtkMTVerifyText.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace
{
constexpr std::size_t HeaderSize = 84;
constexpr std::size_t RecordSize = 50;

std::uint32_t ReadLittle(const char* bytes, int count)
{
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

double ReadFloat(const char* bytes)
{
  const std::uint32_t bits = ReadLittle(bytes, 4);
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// Five bits each, from the lowest.
std::array<double, 3> GetColor(std::uint32_t word, bool isRedLowest)
{
  const double low = (word & 31) / 31.0;
  const double middle = (word >> 5 & 31) / 31.0;
  const double high = (word >> 10 & 31) / 31.0;
  return { isRedLowest ? low : high, middle, isRedLowest ? high : low };
}

void ReadColors(const std::string& bytes, std::size_t count, vtkMTVerifyMesh& mesh)
{
  const std::size_t magics = bytes.substr(0, 80).find("COLOR=");
  const bool isMagics = magics != std::string::npos && magics + 10 <= 80;
  std::array<double, 3> whole;
  whole.fill(std::numeric_limits<double>::quiet_NaN());
  for (int c = 0; isMagics && c < 3; ++c)
  {
    whole[c] = static_cast<unsigned char>(bytes[magics + 6 + c]) / 255.0;
  }
  std::vector<double> values;
  bool isColored = isMagics;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t word = ReadLittle(bytes.data() + HeaderSize + i * RecordSize + 48, 2);
    const bool isOwn = (word >> 15 != 0) != isMagics;
    isColored = isColored || isOwn;
    const std::array<double, 3> color = isOwn ? GetColor(word, isMagics) : whole;
    values.insert(values.end(), color.begin(), color.end());
  }
  if (isColored)
  {
    mesh.GetArray("Colors", vtkMTVerifyMesh::Colors, true, 3).Values = values;
  }
}

bool ReadBinary(const std::string& bytes, vtkMTVerifyMesh& mesh, std::string& error)
{
  const std::size_t there = bytes.size() < HeaderSize ? 0 : (bytes.size() - HeaderSize) / RecordSize;
  const std::size_t announced = there == 0 ? 0 : ReadLittle(bytes.data() + 80, 4);
  if (there == 0 || (announced > there && announced != 0xffffffffu))
  {
    error = "has fewer triangles than its header announces";
    return false;
  }
  const bool isWhole = bytes.size() == HeaderSize + there * RecordSize;
  const std::size_t count = isWhole || announced == 0 || announced > there ? there : announced;
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* const corner = bytes.data() + HeaderSize + i * RecordSize + 12;
    for (int j = 0; j < 3; ++j)
    {
      mesh.Points.push_back(
        { ReadFloat(corner + 12 * j), ReadFloat(corner + 12 * j + 4), ReadFloat(corner + 12 * j + 8) });
    }
    const auto first = static_cast<vtkIdType>(3 * i);
    mesh.Polygons.push_back({ first, first + 1, first + 2 });
  }
  ReadColors(bytes, count, mesh);
  return true;
}

std::string GetRest(std::string_view line, std::string_view word)
{
  std::string_view rest = line.substr(static_cast<std::size_t>(word.data() + word.size() - line.data()));
  const std::size_t begin = rest.find_first_not_of(" \t");
  rest = begin == std::string_view::npos ? std::string_view() : rest.substr(begin);
  return std::string(rest.substr(0, rest.find_last_not_of(" \t\r") + 1));
}

bool ReadText(std::string_view text, vtkMTVerifyMesh& mesh)
{
  std::vector<vtkIdType> loop;
  std::vector<std::string> solids;
  std::vector<double> solidOfCell;
  vtkMTVerifyText lines(text);
  std::string_view line;
  while (lines.Next(line))
  {
    const std::vector<std::string_view> words = vtkMTVerifyText::Split(line);
    const std::string word = words.empty() ? "" : vtkMTVerifyText::ToLower(words[0]);
    if (word == "solid")
    {
      solids.push_back(GetRest(line, words[0]));
    }
    else if (word == "vertex" && words.size() >= 4)
    {
      std::array<double, 3> x;
      for (int c = 0; c < 3; ++c)
      {
        x[c] = vtkMTVerifyText::ParseNumber(words[1 + c], x[c]) ? x[c] : std::numeric_limits<double>::quiet_NaN();
      }
      loop.push_back(static_cast<vtkIdType>(mesh.Points.size()));
      mesh.Points.push_back(x);
    }
    else if (word.compare(0, 3, "end") == 0 && !loop.empty())
    {
      mesh.Polygons.push_back(loop);
      solidOfCell.push_back(static_cast<double>(solids.size()) - 1.0);
      loop.clear();
    }
  }
  if (solids.size() > 1)
  {
    vtkMTVerifyMesh::Array& array = mesh.GetArray("SolidIds", vtkMTVerifyMesh::Names, true, 1);
    array.Values = solidOfCell;
    array.Names = solids;
  }
  return !mesh.Polygons.empty();
}
}

bool vtkMTVerifyStlInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  std::string bytes;
  if (!vtkMTVerifyText::Load(path, bytes, error) || !vtkMTVerifyText::IsReadable(bytes, error))
  {
    return false;
  }
  const std::string_view text = vtkMTVerifyText::SkipMark(bytes);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t announced = bytes.size() < HeaderSize ? 0 : ReadLittle(bytes.data() + 80, 4);
  const bool isOfSize = bytes.size() >= HeaderSize && bytes.size() == HeaderSize + announced * RecordSize;
  const bool isText = !isOfSize && vtkMTVerifyText::ToLower(text.substr(start, 5)) == "solid" &&
    vtkMTVerifyText::ToLower(text.substr(0, 4096)).find("facet") != std::string::npos;
  vtkMTVerifyMesh mesh;
  if (isText ? !ReadText(text, mesh) : !ReadBinary(bytes, mesh, error))
  {
    error = error.empty() ? "has no facet" : error;
    return false;
  }
  mesh.Give(out);
  return true;
}
