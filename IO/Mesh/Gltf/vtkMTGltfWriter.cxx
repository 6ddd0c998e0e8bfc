// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfWriter.h"

#include "vtkMTOutputFile.h"
#include "vtkMTSinglePrecision.h"
#include "vtkMTStreamWalk.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
using Json = nlohmann::ordered_json;

// glTF's numbers for types and uses.
constexpr int UnsignedByte = 5121;
constexpr int UnsignedInt = 5125;
constexpr int Float = 5126;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr std::size_t LargestStride = 252;

double GetReal(const unsigned char* values, int type, std::size_t i)
{
  if (type == VTK_DOUBLE)
  {
    double value;
    std::memcpy(&value, values + i * sizeof(value), sizeof(value));
    return value;
  }
  float value;
  std::memcpy(&value, values + i * sizeof(value), sizeof(value));
  return value;
}

void PutFloat(unsigned char* to, double value)
{
  const float rounded = static_cast<float>(value);
  std::memcpy(to, &rounded, sizeof(rounded));
}

// glTF wants unit length; what has none points up.
void PutNormal(unsigned char* to, const double normal[3])
{
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const bool isGood = length > 0.0 && std::isfinite(length);
  for (int i = 0; i < 3; ++i)
  {
    PutFloat(to + 4 * i, isGood ? normal[i] / length : (i == 2 ? 1.0 : 0.0));
  }
}

std::size_t RoundUp(std::size_t size)
{
  return (size + 3) / 4 * 4;
}
}

//------------------------------------------------------------------------------
// The buffer's bytes, plain or as base64 (RFC 4648).
class vtkMTGltfWriter::Output
{
public:
  Output(vtkMTOutputFile& file, bool base64)
    : File(file)
    , IsBase64(base64)
  {
  }

  bool Write(const std::vector<unsigned char>& bytes)
  {
    if (!this->IsBase64)
    {
      return this->File.Write(bytes.data(), bytes.size());
    }
    this->Pending.insert(this->Pending.end(), bytes.begin(), bytes.end());
    return this->Flush(this->Pending.size() / 3 * 3);
  }

  bool Finish() { return this->Flush(this->Pending.size()); }

private:
  bool Flush(std::size_t count)
  {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(count / 3 * 4 + 4);
    for (std::size_t i = 0; i < count; i += 3)
    {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        bits = bits << 8 | (i + k < count ? this->Pending[i + k] : 0u);
      }
      for (std::size_t k = 0; k < 4; ++k)
      {
        text += i + k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
      }
    }
    this->Pending.erase(this->Pending.begin(), this->Pending.begin() + static_cast<std::ptrdiff_t>(count));
    return this->File.Write(text.data(), text.size());
  }

  vtkMTOutputFile& File;
  const bool IsBase64;
  std::vector<unsigned char> Pending;
};

//------------------------------------------------------------------------------
vtkMTGltfWriter::vtkMTGltfWriter(vtkMTTriangleStream& mesh, bool binary)
  : Mesh(mesh)
  , IsBinary(binary)
{
  this->ChooseAttributes();
}

void vtkMTGltfWriter::ChooseAttributes()
{
  std::size_t column = 0;
  for (const vtkMTArrayInfo& array : this->Mesh.GetArrays())
  {
    const bool isPoint = array.Association == vtkMTArrayInfo::Point;
    if (!isPoint || !this->Choose(array, column))
    {
      this->Dropped.push_back((isPoint ? "point " : "cell ") + array.Name);
    }
    column += isPoint ? 1 : 0;
  }
}

bool vtkMTGltfWriter::Choose(const vtkMTArrayInfo& array, std::size_t column)
{
  const bool isReal = array.Type == VTK_FLOAT || array.Type == VTK_DOUBLE;
  const auto isFree = [this](Kind kind)
  {
    return std::none_of(this->Attributes.begin(), this->Attributes.end(),
      [kind](const Attribute& attribute) { return attribute.What == kind; });
  };
  Attribute attribute{ Kind::Custom, "_" + array.Name, array.Type, static_cast<std::size_t>(array.Components), column,
    this->Stride };
  std::size_t size = 4 * attribute.Components;
  if (isReal && array.Components == 3 && isFree(Kind::Normal) &&
    (array.Attribute == vtkDataSetAttributes::NORMALS || array.Name == "Normals"))
  {
    attribute.What = Kind::Normal;
    attribute.Name = "NORMAL";
  }
  else if (isReal && array.Components == 2 && isFree(Kind::TextureCoordinates) &&
    (array.Attribute == vtkDataSetAttributes::TCOORDS || array.Name == "TCoords"))
  {
    attribute.What = Kind::TextureCoordinates;
    attribute.Name = "TEXCOORD_0";
  }
  else if (array.Type == VTK_UNSIGNED_CHAR && (array.Components == 3 || array.Components == 4) && isFree(Kind::Color))
  {
    attribute.What = Kind::Color;
    attribute.Name = "COLOR_0";
    size = 4;
  }
  else if (array.Type != VTK_FLOAT || array.Components > 4)
  {
    return false;
  }
  if (this->Stride + size > LargestStride)
  {
    return false;
  }
  this->Stride += size;
  this->Attributes.push_back(attribute);
  return true;
}

//------------------------------------------------------------------------------
// Bounds, and whether single precision holds the places as they are.
bool vtkMTGltfWriter::Survey(std::string& error)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    this->Bounds[2 * i] = inf;
    this->Bounds[2 * i + 1] = -inf;
  }
  const auto look = [this](const vtkMTTriangleStream::PointBlock& block)
  {
    for (const std::array<double, 3>& p : block.Points)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Bounds[2 * i] = std::min(this->Bounds[2 * i], p[i]);
        this->Bounds[2 * i + 1] = std::max(this->Bounds[2 * i + 1], p[i]);
        this->NeedsDouble = this->NeedsDouble || !vtkMTSinglePrecision::Holds(p[i]);
      }
    }
    return true;
  };
  if (!vtkMTStreamWalk::Rewind(this->Mesh, error) || !vtkMTStreamWalk::ForEachPointBlock(this->Mesh, error, look))
  {
    return false;
  }
  if (this->Mesh.GetNumberOfPoints() == 0 || this->Mesh.GetNumberOfTriangles() == 0)
  {
    error = "glTF cannot hold a mesh without triangles";
    return false;
  }
  if (this->Mesh.GetNumberOfPoints() >= std::numeric_limits<std::uint32_t>::max())
  {
    error = "glTF cannot hold more than 2^32 - 2 points";
    return false;
  }
  this->ChooseOrigin();
  return true;
}

// Far from the origin, places relative to the middle keep their digits; the node puts them back.
void vtkMTGltfWriter::ChooseOrigin()
{
  for (int i = 0; i < 3 && this->NeedsDouble; ++i)
  {
    this->Origin[i] =
      static_cast<double>(static_cast<float>(0.5 * this->Bounds[2 * i] + 0.5 * this->Bounds[2 * i + 1]));
  }
}

Json vtkMTGltfWriter::Describe() const
{
  const std::size_t points = this->Mesh.GetNumberOfPoints();
  const std::size_t indices = 3 * this->Mesh.GetNumberOfTriangles();
  Json gltf;
  gltf["asset"] = { { "version", "2.0" }, { "generator", "Multi-Triangulation toolkit for VTK" } };
  gltf["scene"] = 0;
  gltf["scenes"] = Json::array({ { { "nodes", { 0 } } } });
  Json node = { { "mesh", 0 } };
  if (this->NeedsDouble)
  {
    node["translation"] = { this->Origin[0], this->Origin[1], this->Origin[2] };
  }
  gltf["nodes"] = Json::array({ node });
  gltf["materials"] =
    Json::array({ { { "pbrMetallicRoughness", { { "metallicFactor", 0.0 }, { "roughnessFactor", 1.0 } } },
      { "doubleSided", true } } });

  Json accessors = Json::array();
  accessors.push_back(
    { { "bufferView", 1 }, { "componentType", UnsignedInt }, { "count", indices }, { "type", "SCALAR" } });
  Json position = { { "bufferView", 0 }, { "byteOffset", 0 }, { "componentType", Float }, { "count", points },
    { "type", "VEC3" } };
  for (int i = 0; i < 3; ++i)
  {
    // Rounding is monotonic, so these are the least and the largest of what is written.
    position["min"].push_back(static_cast<float>(this->Bounds[2 * i] - this->Origin[i]));
    position["max"].push_back(static_cast<float>(this->Bounds[2 * i + 1] - this->Origin[i]));
  }
  accessors.push_back(position);
  Json attributes = { { "POSITION", 1 } };
  static const char* const types[] = { "SCALAR", "VEC2", "VEC3", "VEC4" };
  for (const Attribute& attribute : this->Attributes)
  {
    const bool isColor = attribute.What == Kind::Color;
    attributes[attribute.Name] = accessors.size();
    accessors.push_back(
      { { "bufferView", 0 }, { "byteOffset", attribute.Offset }, { "componentType", isColor ? UnsignedByte : Float },
        { "count", points }, { "type", types[isColor ? 3 : attribute.Components - 1] } });
    if (isColor)
    {
      accessors.back()["normalized"] = true;
    }
  }
  gltf["meshes"] = Json::array(
    { { { "primitives", Json::array({ { { "attributes", attributes }, { "indices", 0 }, { "material", 0 } } }) } } });
  gltf["accessors"] = accessors;
  gltf["bufferViews"] = Json::array({ { { "buffer", 0 }, { "byteOffset", 0 }, { "byteLength", points * this->Stride },
                                        { "byteStride", this->Stride }, { "target", ArrayBuffer } },
    { { "buffer", 0 }, { "byteOffset", points * this->Stride }, { "byteLength", 4 * indices },
      { "target", ElementArrayBuffer } } });
  gltf["buffers"] = Json::array({ { { "byteLength", points * this->Stride + 4 * indices } } });
  return gltf;
}

//------------------------------------------------------------------------------
void vtkMTGltfWriter::FillVertex(
  const vtkMTTriangleStream::PointBlock& block, std::size_t i, unsigned char* vertex) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    PutFloat(vertex + 4 * axis, block.Points[i][axis] - this->Origin[axis]);
  }
  for (const Attribute& attribute : this->Attributes)
  {
    const std::size_t size = attribute.Type == VTK_DOUBLE ? 8 : attribute.Type == VTK_FLOAT ? 4 : 1;
    const unsigned char* values = block.Columns[attribute.Column].data() + i * attribute.Components * size;
    unsigned char* to = vertex + attribute.Offset;
    double real[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (std::size_t c = 0; c < attribute.Components && attribute.What != Kind::Color; ++c)
    {
      real[c] = GetReal(values, attribute.Type, c);
    }
    switch (attribute.What)
    {
      case Kind::Normal:
        PutNormal(to, real);
        break;
      case Kind::TextureCoordinates:
        PutFloat(to, real[0]);
        PutFloat(to + 4, 1.0 - real[1]); // glTF's images begin at the top, VTK's at the bottom
        break;
      case Kind::Color:
        to[3] = 255;
        std::memcpy(to, values, attribute.Components);
        break;
      case Kind::Custom:
        std::memcpy(to, values, 4 * attribute.Components);
    }
  }
}

bool vtkMTGltfWriter::WritePoints(Output& output, std::string& error)
{
  std::vector<unsigned char> bytes;
  return vtkMTStreamWalk::Rewind(this->Mesh, error) &&
    vtkMTStreamWalk::ForEachPointBlock(this->Mesh, error,
      [&](const vtkMTTriangleStream::PointBlock& block)
      {
        bytes.resize(block.Points.size() * this->Stride);
        for (std::size_t i = 0; i < block.Points.size(); ++i)
        {
          this->FillVertex(block, i, bytes.data() + i * this->Stride);
        }
        return output.Write(bytes);
      });
}

bool vtkMTGltfWriter::WriteTriangles(Output& output, std::string& error)
{
  std::vector<unsigned char> bytes;
  return vtkMTStreamWalk::ForEachTriangleBlock(this->Mesh, error,
    [&](const vtkMTTriangleStream::TriangleBlock& block)
    {
      bytes.resize(12 * block.Triangles.size());
      for (std::size_t t = 0; t < block.Triangles.size(); ++t)
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          if (block.Triangles[t][c] >= this->Mesh.GetNumberOfPoints())
          {
            error = "a triangle has a corner that does not exist";
            return false;
          }
          const auto index = static_cast<std::uint32_t>(block.Triangles[t][c]);
          std::memcpy(bytes.data() + 12 * t + 4 * c, &index, sizeof(index));
        }
      }
      return output.Write(bytes);
    });
}

//------------------------------------------------------------------------------
bool vtkMTGltfWriter::Write(vtkMTOutputFile& file, std::string& error)
{
  if (!this->Survey(error))
  {
    return false;
  }
  Json gltf = this->Describe();
  const std::uint64_t buffer = gltf["buffers"][0]["byteLength"].get<std::uint64_t>();
  std::string before;
  std::string after;
  if (this->IsBinary)
  {
    std::string text = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(RoundUp(text.size()), ' ');
    const std::uint64_t size = 28 + text.size() + buffer;
    if (size > std::numeric_limits<std::uint32_t>::max())
    {
      error = "GLB cannot hold more than 4 GB; write a coarser cut, or .ply or .vtp";
      return false;
    }
    // Magic, version, length of all; length of the JSON, "JSON"; length of the buffer, "BIN".
    const std::uint32_t head[5] = { 0x46546c67, 2, static_cast<std::uint32_t>(size),
      static_cast<std::uint32_t>(text.size()), 0x4e4f534a };
    const std::uint32_t chunk[2] = { static_cast<std::uint32_t>(buffer), 0x004e4942 };
    before.assign(reinterpret_cast<const char*>(head), sizeof(head));
    before += text;
    before.append(reinterpret_cast<const char*>(chunk), sizeof(chunk));
  }
  else
  {
    // The buffer goes where this mark is.
    gltf["buffers"][0]["uri"] = "@";
    const std::string text = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::size_t mark = text.rfind("\"@\"") + 1;
    before = text.substr(0, mark) + "data:application/octet-stream;base64,";
    after = text.substr(mark + 1);
  }
  Output output(file, !this->IsBinary);
  const bool good = file.Write(before.data(), before.size()) && this->WritePoints(output, error) &&
    this->WriteTriangles(output, error) && output.Finish() && file.Write(after.data(), after.size());
  error = !good && error.empty() ? file.GetError() : error;
  return good;
}
