// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchCodec.h"

#include "vtkMTByteCodec.h"
#include "vtkMTChecksum.h"
#include "vtkMTColumnCodec.h"
#include "vtkMTDecodeScratch.h"
#include "vtkMTMadeNormals.h"
#include "vtkMTNormalCodec.h"
#include "vtkMTPackedGeometry.h"
#include "vtkMTPatchOrder.h"
#include "vtkMTRawGeometry.h"

#include <limits>

namespace
{
using vtkMTFileFormat::Codec;
using vtkMTFileFormat::SectionRecord;

bool IsKindKnown(vtkMTPatchKind kind, std::string& error)
{
  if (kind != vtkMTPatchKind::Triangles)
  {
    error = std::string("is of ") +
      (kind == vtkMTPatchKind::Points      ? "points"
          : kind == vtkMTPatchKind::Voxels ? "voxels"
                                           : "a grid's samples") +
      ": there is no codec for this kind in this version; there is one for triangles";
  }
  return kind == vtkMTPatchKind::Triangles;
}

bool IsGeometryConsistent(const vtkMTPatch& patch, std::string& error)
{
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  const std::size_t wedges = patch.GetNumberOfWedges();
  if (patch.Points.size() > most || wedges > most || patch.Triangles.size() > most)
  {
    error = "has more than 2^32 - 1 points, wedges or triangles";
    return false;
  }
  if (patch.Ids.size() > patch.Points.size())
  {
    error = "has more ids than points";
    return false;
  }
  for (const std::uint32_t point : patch.WedgePoints)
  {
    if (point >= patch.Points.size())
    {
      error = "has a wedge of a point that it does not have";
      return false;
    }
  }
  for (const vtkMTTriangle& triangle : patch.Triangles)
  {
    if (triangle[0] >= wedges || triangle[1] >= wedges || triangle[2] >= wedges)
    {
      error = "has a triangle of a wedge that it does not have";
      return false;
    }
  }
  return true;
}

// The section from `begin` to the end of bytes is complete: pads it and makes its record.
bool CloseSection(Codec codec, std::size_t sectionClass, std::size_t begin, std::vector<unsigned char>& bytes,
  std::vector<vtkMTFileSection>& sections)
{
  const std::size_t size = bytes.size() - begin;
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    return false;
  }
  vtkMTFileSection section{};
  section.Offset = begin;
  section.StoredSize = static_cast<std::uint32_t>(size);
  section.Codec = codec;
  section.Class = static_cast<std::uint16_t>(sectionClass);
  bytes.resize(static_cast<std::size_t>(vtkMTFileFormat::Align(bytes.size())), 0);
  section.Checksum = vtkMTChecksum(bytes.data() + begin, bytes.size() - begin);
  sections.push_back(section);
  return true;
}

bool PackColumn(const vtkMTArrayInfo& array, const vtkMTColumn& column, const vtkMTDecodeScratch& traversal,
  Codec codec, std::vector<unsigned char>& bytes)
{
  const std::size_t begin = bytes.size();
  const std::vector<unsigned char> packed = vtkMTColumnCodec::Pack(array, column, traversal);
  return vtkMTByteCodec::Compress(codec, packed.data(), packed.size(), bytes) &&
    vtkMTByteCodec::IsPlausible(bytes.size() - begin, packed.size());
}

// A column of no bytes has no section. An array that does not become smaller is stored as it is, and so is one without
// neighbours.
bool AppendColumn(const vtkMTArrayInfo& array, const vtkMTColumn& column, const vtkMTPatch& patch,
  const vtkMTDecodeScratch& traversal, Codec codec, std::size_t sectionClass, std::vector<unsigned char>& bytes,
  std::vector<vtkMTFileSection>& sections)
{
  if (column.empty())
  {
    return true;
  }
  const std::size_t begin = bytes.size();
  bool isSmaller = traversal.IsKnown;
  if (isSmaller && vtkMTMadeNormals::AreIn(array))
  {
    vtkMTNormalCodec::Encode(column, patch, vtkMTMadeNormals::GetBits(array), bytes);
    codec = vtkMTFileFormat::Expected;
  }
  else if (isSmaller)
  {
    isSmaller = PackColumn(array, column, traversal, codec, bytes);
  }
  isSmaller = isSmaller && bytes.size() - begin < column.size();
  if (!isSmaller)
  {
    bytes.resize(begin);
    bytes.insert(bytes.end(), column.begin(), column.end());
  }
  return CloseSection(isSmaller ? codec : vtkMTFileFormat::Raw, sectionClass, begin, bytes, sections);
}

bool AreColumnsRight(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays, std::string& error)
{
  std::size_t next[2] = { 0, 0 }; // of the point columns and of the cell columns
  for (const vtkMTArrayInfo& array : arrays)
  {
    const bool ofPoints = array.Association == vtkMTArrayInfo::Point;
    const std::vector<vtkMTColumn>& columns = ofPoints ? patch.PointColumns : patch.CellColumns;
    const std::size_t column = next[ofPoints ? 0 : 1]++;
    const std::size_t tuples = ofPoints ? patch.GetNumberOfWedges() : patch.Triangles.size();
    const bool mayBeEmpty = array.IsFinestOnly();
    if (column >= columns.size() ||
      (columns[column].size() != tuples * array.GetTupleSize() && !(mayBeEmpty && columns[column].empty())))
    {
      error = "has no array \"" + array.Name + "\" of the right size";
      return false;
    }
  }
  if (next[0] != patch.PointColumns.size() || next[1] != patch.CellColumns.size())
  {
    error = "has more arrays than were announced";
    return false;
  }
  return true;
}
}

namespace vtkMTPatchCodec
{
bool Encode(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays, Codec codec,
  std::vector<unsigned char>& bytes, std::vector<vtkMTFileSection>& sections, std::string& error)
{
  bytes.clear();
  sections.clear();
  if (!IsKindKnown(patch.Kind, error) || !IsGeometryConsistent(patch, error) || !AreColumnsRight(patch, arrays, error))
  {
    return false;
  }
  if (patch.Points.empty() && patch.Triangles.empty())
  {
    return true; // a dependency
  }
  thread_local vtkMTDecodeScratch traversal;
  const vtkMTPatchOrder order = vtkMTPatchOrder::Make(patch, traversal.Mesh);
  Codec used = codec;
  if (codec == vtkMTFileFormat::Raw || !vtkMTPackedGeometry::Encode(order, codec, bytes, traversal))
  {
    traversal.IsKnown = false;
    bytes.clear();
    used = vtkMTFileFormat::Raw;
    vtkMTRawGeometry::Encode(order.Patch, bytes);
  }
  bool fits = CloseSection(used, vtkMTFileFormat::GeometryClass, 0, bytes, sections);
  error = fits ? error : "has more than 4 GiB of geometry";
  std::size_t next[2] = { 0, 0 };
  for (std::size_t i = 0; fits && i < arrays.size(); ++i)
  {
    const bool ofPoints = arrays[i].Association == vtkMTArrayInfo::Point;
    const std::vector<vtkMTColumn>& columns = ofPoints ? order.Patch.PointColumns : order.Patch.CellColumns;
    fits = AppendColumn(arrays[i], columns[next[ofPoints ? 0 : 1]++], order.Patch, traversal, codec,
      vtkMTFileFormat::FirstArrayClass + i, bytes, sections);
    error = fits ? error : "has more than 4 GiB of array \"" + arrays[i].Name + "\"";
  }
  return fits;
}

bool Check(const SectionRecord& section, const unsigned char* padded, std::string& error)
{
  const auto size = static_cast<std::size_t>(vtkMTFileFormat::Align(section.StoredSize));
  if (vtkMTChecksum(padded, size) != section.Checksum)
  {
    error = "is damaged: its checksum is wrong";
    return false;
  }
  return true;
}

bool DecodeGeometry(const SectionRecord& section, const unsigned char* data, const vtkMTArc& arc,
  vtkMTDecodeScratch& traversal, vtkMTPatch& patch, std::string& error)
{
  traversal.IsKnown = false;
  if (!IsKindKnown(arc.Kind, error))
  {
    return false;
  }
  return section.Codec == vtkMTFileFormat::Raw ? vtkMTRawGeometry::Decode(data, section.StoredSize, arc, patch, error)
                                               : vtkMTPackedGeometry::Decode(static_cast<Codec>(section.Codec), data,
                                                   section.StoredSize, arc, traversal, patch, error);
}

bool MayBeMissing(const vtkMTGraph& graph, std::uint32_t arc, const vtkMTArrayInfo& array)
{
  const vtkMTArc& record = graph.Arcs[arc];
  return (array.IsFinestOnly() && (array.Role == vtkMTArrayInfo::ExactPoints || !graph.IsFinest(arc))) ||
    (array.Association == vtkMTArrayInfo::Point ? record.Wedges : record.Triangles) == 0;
}

bool DecodeColumn(const SectionRecord& section, const unsigned char* data, const vtkMTArc& arc,
  const vtkMTArrayInfo& array, const vtkMTPatch& patch, const vtkMTDecodeScratch& traversal, vtkMTColumn& column,
  std::string& error)
{
  const std::uint64_t tuples = array.Association == vtkMTArrayInfo::Point ? arc.Wedges : arc.Triangles;
  if (section.Codec == vtkMTFileFormat::Raw)
  {
    if (section.StoredSize != tuples * array.GetTupleSize())
    {
      error = "has " + std::to_string(section.StoredSize) + " bytes where " +
        std::to_string(tuples * array.GetTupleSize()) + " are expected";
      return false;
    }
    column.assign(data, data + section.StoredSize);
    return true;
  }
  if (section.Codec == vtkMTFileFormat::Expected)
  {
    const bool done = vtkMTMadeNormals::AreIn(array) && patch.GetNumberOfWedges() == arc.Wedges &&
      patch.Triangles.size() == arc.Triangles && vtkMTNormalCodec::Decode(data, section.StoredSize, patch, column);
    error = done ? error : "holds no normals of this patch";
    return done;
  }
  if (!traversal.IsKnown)
  {
    error = "is packed where the geometry is not";
    return false;
  }
  if (vtkMTMadeNormals::AreIn(array))
  {
    const bool done =
      vtkMTColumnCodec::UnpackDirections(data, section.StoredSize, static_cast<std::size_t>(tuples), traversal, column);
    error = done ? error : "has directions of an impossible length";
    return done;
  }
  const std::uint64_t size = vtkMTColumnCodec::GetPackedSize(array, tuples);
  if (!vtkMTByteCodec::IsPlausible(section.StoredSize, size))
  {
    error = "is too small for what it should hold";
    return false;
  }
  std::vector<unsigned char> packed(static_cast<std::size_t>(size));
  if (!vtkMTByteCodec::Decompress(
        static_cast<Codec>(section.Codec), data, section.StoredSize, packed.data(), packed.size()))
  {
    error = "cannot be decompressed";
    return false;
  }
  vtkMTColumnCodec::Unpack(array, packed, static_cast<std::size_t>(tuples), traversal, column);
  return true;
}
}
