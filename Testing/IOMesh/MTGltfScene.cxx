// SPDX-License-Identifier: BSD-3-Clause
#include "MTGltfScene.h"

#include "vtkMTMemoryByteSource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

namespace
{
std::vector<double> GetAll(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
  return values;
}

void Put(MTIOTest::Bytes& bytes, std::uint32_t value)
{
  const auto* from = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof(value));
}

std::string ToBase64(const MTIOTest::Bytes& bytes)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string ToPercent(const MTIOTest::Bytes& bytes)
{
  static const char digits[] = "0123456789aBcDeF"; // both cases are right
  std::string text;
  for (const unsigned char byte : bytes)
  {
    text += '%';
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}
}

//------------------------------------------------------------------------------
MTGltfScene::MTGltfScene()
  : Document(Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[]}],"nodes":[],"meshes":[],
"accessors":[],"bufferViews":[],"buffers":[{"byteLength":0}]})"))
{
}

std::size_t MTGltfScene::AddView(const void* bytes, std::size_t size, std::size_t stride)
{
  this->Buffer.resize((this->Buffer.size() + 3) / 4 * 4);
  Json view = { { "buffer", 0 }, { "byteOffset", this->Buffer.size() }, { "byteLength", size } };
  if (stride > 0)
  {
    view["byteStride"] = stride;
  }
  const auto* from = static_cast<const unsigned char*>(bytes);
  this->Buffer.insert(this->Buffer.end(), from, from + size);
  this->Document["buffers"][0]["byteLength"] = this->Buffer.size();
  this->Document["bufferViews"].push_back(view);
  return this->Document["bufferViews"].size() - 1;
}

std::size_t MTGltfScene::AddAccessor(
  std::size_t view, int componentType, std::size_t count, const std::string& type, bool isNormalized)
{
  this->Document["accessors"].push_back({ { "bufferView", view }, { "componentType", componentType },
    { "count", count }, { "type", type }, { "normalized", isNormalized } });
  return this->Document["accessors"].size() - 1;
}

std::size_t MTGltfScene::AddMesh(const std::vector<Json>& primitives)
{
  this->Document["meshes"].push_back({ { "primitives", primitives } });
  return this->Document["meshes"].size() - 1;
}

std::size_t MTGltfScene::AddNode(const Json& node)
{
  const std::size_t number = this->Document["nodes"].size();
  this->Document["nodes"].push_back(node);
  this->Document["scenes"][0]["nodes"].push_back(number);
  return number;
}

MTGltfScene::Json MTGltfScene::MakeCube()
{
  return { { "attributes", { { "POSITION", this->AddAccessor(GetCubePlaces(), "VEC3") } } },
    { "indices", this->AddAccessor(GetCubeCorners(), "SCALAR") } };
}

void MTGltfScene::Require(const std::string& extension)
{
  this->Document["extensionsUsed"].push_back(extension);
  this->Document["extensionsRequired"].push_back(extension);
}

MTGltfScene::Bytes MTGltfScene::ToGlb() const
{
  std::string json = this->Document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes buffer = this->Buffer;
  buffer.resize((buffer.size() + 3) / 4 * 4);
  Bytes bytes = { 'g', 'l', 'T', 'F' };
  Put(bytes, 2);
  Put(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  Put(bytes, static_cast<std::uint32_t>(json.size()));
  Put(bytes, 0x4e4f534a);
  bytes.insert(bytes.end(), json.begin(), json.end());
  Put(bytes, static_cast<std::uint32_t>(buffer.size()));
  Put(bytes, 0x004e4942);
  bytes.insert(bytes.end(), buffer.begin(), buffer.end());
  return bytes;
}

std::string MTGltfScene::ToGltf(bool isBase64) const
{
  Json document = this->Document;
  document["buffers"][0]["uri"] = isBase64 ? "data:application/octet-stream;base64," + ToBase64(this->Buffer)
                                           : "data:application/octet-stream," + ToPercent(this->Buffer);
  return document.dump();
}

const std::vector<float>& MTGltfScene::GetCubePlaces()
{
  static const std::vector<float> places = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 };
  return places;
}

const std::vector<std::uint16_t>& MTGltfScene::GetCubeCorners()
{
  static const std::vector<std::uint16_t> corners = { 0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1,
    6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7 };
  return corners;
}

//------------------------------------------------------------------------------
MTGltfMesh MTGltfMesh::Read(const MTIOTest::Bytes& bytes, std::uint64_t memoryLimit)
{
  MTGltfMesh result;
  const bool done =
    vtkMTGltfReader::Read(vtkMTMemoryByteSource(bytes), result.Mesh, result.Error, &result.Counts, memoryLimit);
  EXPECT_NE(done, !result.Error.empty());
  EXPECT_TRUE(done || result.Mesh->GetNumberOfPoints() == 0);
  return result;
}

double MTGltfMesh::GetVolume() const
{
  double volume = 0.0;
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPolys(); ++i)
  {
    this->Mesh->GetPolys()->GetCellAtId(i, count, corners);
    double p[3][3];
    for (vtkIdType c = 0; c < 3; ++c)
    {
      this->Mesh->GetPoint(corners[c], p[c]);
    }
    volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6.0;
  }
  return volume;
}

std::array<double, 6> MTGltfMesh::GetBounds() const
{
  std::array<double, 6> bounds;
  this->Mesh->GetBounds(bounds.data());
  return bounds;
}

vtkIdType MTGltfMesh::CountOutwardNormals(const double middle[3], vtkIdType first, vtkIdType count) const
{
  vtkIdType outward = 0;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    double place[3];
    this->Mesh->GetPoint(i, place);
    vtkMath::Subtract(place, middle, place);
    outward += vtkMath::Dot(place, this->Mesh->GetPointData()->GetNormals()->GetTuple3(i)) > 0.0 ? 1 : 0;
  }
  return outward;
}

std::vector<double> MTGltfMesh::GetValues(const char* pointArray) const
{
  return GetAll(this->Mesh->GetPointData()->GetArray(pointArray));
}

std::vector<double> MTGltfMesh::GetCellValues(const char* cellArray) const
{
  return GetAll(this->Mesh->GetCellData()->GetArray(cellArray));
}
