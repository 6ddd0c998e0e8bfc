// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfDraco.h"

#include <algorithm>
#include <array>

#ifdef MT_HAS_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

using namespace vtkMTGltfJson;

#ifdef MT_HAS_DRACO
namespace
{
// Entropy codes have no least size for a triangle; no real mesh comes near to this.
constexpr std::uint64_t LargestRatio = 1024;
constexpr std::size_t BlockLength = 4096;

bool TakeCount(draco::DecoderBuffer& buffer, bool isVariable, std::uint32_t& count)
{
  return isVariable ? draco::DecodeVarint<std::uint32_t>(&count, &buffer) : buffer.Decode(&count);
}

// The head of draco::PointCloudDecoder and of its two decoders of meshes, as far as their counts.
bool TakeCounts(draco::DecoderBuffer& buffer, std::uint32_t& points, std::uint32_t& triangles)
{
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() || header.encoder_type != draco::TRIANGULAR_MESH)
  {
    return false;
  }
  const int version = 256 * header.version_major + header.version_minor;
  buffer.set_bitstream_version(static_cast<std::uint16_t>(version));
  draco::GeometryMetadata metadata;
  const bool hasMetadata = version >= 0x0103 && (header.flags & METADATA_FLAG_MASK);
  if (hasMetadata && !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
  {
    return false;
  }
  const bool isVariable = version >= 0x0202;
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
  {
    return TakeCount(buffer, isVariable, triangles) && TakeCount(buffer, isVariable, points);
  }
  std::uint8_t traversal = 0;
  std::uint32_t skipped = 0;
  const bool hasNewVertices = version < 0x0202;
  if (!buffer.Decode(&traversal) || (hasNewVertices && !TakeCount(buffer, version >= 0x0200, skipped)))
  {
    return false;
  }
  return TakeCount(buffer, version >= 0x0200, points) && TakeCount(buffer, version >= 0x0200, triangles);
}

int ToComponentType(draco::DataType type, const std::string& where)
{
  switch (type)
  {
    case draco::DT_INT8:
      return vtkMTGltfAccessor::Byte;
    case draco::DT_UINT8:
      return vtkMTGltfAccessor::UnsignedByte;
    case draco::DT_INT16:
      return vtkMTGltfAccessor::Short;
    case draco::DT_UINT16:
      return vtkMTGltfAccessor::UnsignedShort;
    case draco::DT_INT32:
      return vtkMTGltfAccessor::Int;
    case draco::DT_UINT32:
      return vtkMTGltfAccessor::UnsignedInt;
    case draco::DT_FLOAT32:
      return vtkMTGltfAccessor::Float;
    default:
      Fail(where, "an attribute is of type " + std::to_string(type) + ", which is not known");
  }
}
}

struct vtkMTGltfDraco::Internals
{
  std::unique_ptr<draco::Mesh> Mesh;
};

bool vtkMTGltfDraco::IsAvailable()
{
  return true;
}

std::uint64_t vtkMTGltfDraco::FindNumberOfTriangles(const std::vector<unsigned char>& bytes, const std::string& where)
{
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::uint32_t points = 0;
  std::uint32_t triangles = 0;
  if (!TakeCounts(buffer, points, triangles))
  {
    Fail(where, "is no triangle mesh of Draco");
  }
  if (std::max(points, triangles) / LargestRatio > bytes.size())
  {
    Fail(where,
      "announces " + std::to_string(points) + " points and " + std::to_string(triangles) + " triangles in " +
        std::to_string(bytes.size()) + " bytes");
  }
  return triangles;
}

vtkMTGltfDraco::vtkMTGltfDraco(const std::vector<unsigned char>& bytes, const std::string& where)
  : Implementation(std::make_unique<Internals>())
  , Where(where)
{
  FindNumberOfTriangles(bytes, where); // refuses what would take memory without reason
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
  {
    Fail(where, decoded.status().error_msg_string());
  }
  this->Implementation->Mesh = std::move(decoded).value();
}

vtkMTGltfDraco::~vtkMTGltfDraco() = default;

std::uint64_t vtkMTGltfDraco::GetNumberOfPoints() const
{
  return this->Implementation->Mesh->num_points();
}

std::uint64_t vtkMTGltfDraco::GetNumberOfTriangles() const
{
  return this->Implementation->Mesh->num_faces();
}

void vtkMTGltfDraco::ReadAttribute(
  std::uint64_t number, const vtkMTGltfAccessor& accessor, const vtkMTGltfAccessor::Consumer& consumer) const
{
  const draco::Mesh& mesh = *this->Implementation->Mesh;
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(number));
  if (!attribute || static_cast<std::size_t>(attribute->num_components()) != accessor.GetComponents())
  {
    Fail(this->Where, "attribute " + std::to_string(number) + " is missing, or is not as " + accessor.GetName());
  }
  vtkMTGltfAccessor::Layout layout = accessor.GetLayout();
  layout.Type = ToComponentType(attribute->data_type(), this->Where);
  layout.IsNormalized = layout.IsNormalized && layout.Type != vtkMTGltfAccessor::Float;
  layout.Stride = layout.GetElementSize();
  const std::size_t components = layout.GetComponents();
  std::vector<double> values(BlockLength * components);
  for (std::uint64_t first = 0; first < mesh.num_points(); first += BlockLength)
  {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(BlockLength, mesh.num_points() - first));
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto index = attribute->mapped_index(draco::PointIndex(static_cast<std::uint32_t>(first + i)));
      if (index.value() >= attribute->size())
      {
        Fail(this->Where, "attribute " + std::to_string(number) + " is damaged");
      }
      layout.Convert(attribute->GetAddress(index), 1, values.data() + i * components);
    }
    consumer(first, count, values.data());
  }
}

void vtkMTGltfDraco::ReadCorners(const vtkMTGltfAccessor::Consumer& consumer) const
{
  const draco::Mesh& mesh = *this->Implementation->Mesh;
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face)
  {
    const draco::Mesh::Face& corners = mesh.face(draco::FaceIndex(face));
    const double indices[3] = { static_cast<double>(corners[0].value()), static_cast<double>(corners[1].value()),
      static_cast<double>(corners[2].value()) };
    consumer(3ull * face, 3, indices);
  }
}
#else
struct vtkMTGltfDraco::Internals
{
};

bool vtkMTGltfDraco::IsAvailable()
{
  return false;
}

std::uint64_t vtkMTGltfDraco::FindNumberOfTriangles(const std::vector<unsigned char>&, const std::string& where)
{
  Fail(where, "cannot be decoded: this program was built without Draco");
}

vtkMTGltfDraco::vtkMTGltfDraco(const std::vector<unsigned char>& bytes, const std::string& where)
  : Where(where)
{
  FindNumberOfTriangles(bytes, where);
}

vtkMTGltfDraco::~vtkMTGltfDraco() = default;

std::uint64_t vtkMTGltfDraco::GetNumberOfPoints() const
{
  return 0;
}

std::uint64_t vtkMTGltfDraco::GetNumberOfTriangles() const
{
  return 0;
}

void vtkMTGltfDraco::ReadAttribute(std::uint64_t, const vtkMTGltfAccessor&, const vtkMTGltfAccessor::Consumer&) const
{
}

void vtkMTGltfDraco::ReadCorners(const vtkMTGltfAccessor::Consumer&) const
{
}
#endif
