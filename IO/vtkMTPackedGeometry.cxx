// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPackedGeometry.h"

#include "vtkMTByteCodec.h"
#include "vtkMTGraph.h"
#include "vtkMTIdCodec.h"
#include "vtkMTNumberCode.h"
#include "vtkMTPatchOrder.h"
#include "vtkMTPositionCodec.h"
#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <cstring>

namespace
{
using vtkMTFileFormat::PackedGeometryRecord;

// What a section begins with, and what its arc says of the patch.
struct Record : PackedGeometryRecord
{
  std::uint32_t Points;
  std::uint32_t Wedges;
  std::uint32_t Triangles;
  std::uint32_t SharedPoints;

  Record(const PackedGeometryRecord& record, const vtkMTArc& arc)
    : PackedGeometryRecord(record)
    , Points(arc.Points)
    , Wedges(arc.Wedges)
    , Triangles(arc.Triangles)
    , SharedPoints(arc.SharedPoints)
  {
  }
};

using SideReader = vtkMTNumberCode::Reader;
using vtkMTNumberCode::Append;

//------------------------------------------------------------------------------
// The wedges' points: 0 is the next point that was not met yet, k the k-th last one met.
void AppendWedges(const std::vector<std::uint32_t>& wedgePoints, std::vector<unsigned char>& side)
{
  std::uint32_t next = 0;
  for (std::uint32_t point : wedgePoints)
  {
    Append(side, point == next ? 0 : next - point);
    next += point == next ? 1 : 0;
  }
}

bool ReadWedges(SideReader& side, const Record& record, std::vector<std::uint32_t>& wedgePoints)
{
  wedgePoints.reserve(record.Wedges);
  std::uint32_t next = 0;
  for (std::uint32_t w = 0; w < record.Wedges; ++w)
  {
    std::uint64_t back = 0;
    if (!side.Get(back) || back > next || (back == 0 && next >= record.Points))
    {
      return false;
    }
    wedgePoints.push_back(back == 0 ? next++ : next - static_cast<std::uint32_t>(back));
  }
  return true;
}

//------------------------------------------------------------------------------
// The bases of wedges as those of points: a point is met with its first wedge.
vtkMTPositionCodec::Bases ToPoints(
  const vtkMTPositionCodec::Bases& ofWedges, const std::vector<std::uint32_t>& wedgePoints)
{
  vtkMTPositionCodec::Bases result;
  const auto pointOf = [&wedgePoints](std::uint32_t w) { return w == vtkMTTriangleCodec::None ? w : wedgePoints[w]; };
  for (std::size_t w = 0; w < ofWedges.size(); ++w)
  {
    if (wedgePoints[w] == result.size())
    {
      result.push_back({ pointOf(ofWedges[w].A), pointOf(ofWedges[w].B), pointOf(ofWedges[w].C) });
    }
  }
  return result;
}

// What the decoder will know once it has the triangles.
struct Known
{
  vtkMTPositionCodec::Bases Bases; // of points
  std::vector<std::uint32_t> BorderOrder;

  explicit Known(const vtkMTPatchOrder& order)
  {
    std::vector<vtkMTTriangle> triangles(order.Patch.Triangles.size());
    std::vector<std::uint32_t> border;
    vtkMTTriangleCodec::Decode(order.Steps.data(), order.Steps.size(), order.Names.data(), order.Names.size(),
      order.Patch.GetNumberOfWedges(), triangles, this->Bases, border);
    this->Bases = order.WedgePoints.empty() ? this->Bases : ToPoints(this->Bases, order.WedgePoints);
    this->BorderOrder = vtkMTIdCodec::GetBorderOrder(border, order.WedgePoints, order.PointOfStream.size());
    vtkMTIdCodec::AppendOthers(this->BorderOrder, order.PointOfStream.size());
  }
};

std::vector<vtkMTIdCodec::Identity> GetIdentities(
  const vtkMTPatchOrder& order, const std::vector<std::uint32_t>& borderOrder)
{
  std::vector<vtkMTIdCodec::Identity> identities;
  for (const std::uint32_t point : borderOrder)
  {
    const std::uint32_t place = order.PointOfStream[point];
    if (place < order.Patch.Ids.size())
    {
      identities.push_back({ point, order.Patch.Ids[place] });
    }
  }
  return identities;
}

vtkMTPoint GetCorner(const std::vector<vtkMTPoint>& points)
{
  vtkMTPoint corner{ 0, 0, 0 };
  for (int axis = 0; axis < 3 && !points.empty(); ++axis)
  {
    corner[axis] = (*std::min_element(points.begin(), points.end(),
      [axis](const vtkMTPoint& a, const vtkMTPoint& b) { return a[axis] < b[axis]; }))[axis];
  }
  return corner;
}

bool IsRecordRight(const Record& record, std::uint64_t size, std::string& error)
{
  // Eight triangles take a byte of the side stream at least, 32 points three.
  const bool isPossible = record.Shift <= vtkMTPositionCodec::MaximumShift && record.HasTable <= 1 &&
    record.Reserved == 0 && (record.HasTable != 0 || record.Wedges == record.Points) &&
    record.SharedPoints <= record.Points && record.StoredSideSize <= size - sizeof(PackedGeometryRecord) &&
    vtkMTByteCodec::IsPlausible(record.StoredSideSize, record.SideSize) && record.Triangles / 8 <= record.SideSize &&
    record.Points / 16 <= record.SideSize && (record.HasTable == 0 || record.Wedges <= record.SideSize);
  error = isPossible ? error : "has an impossible header";
  return isPossible;
}

// What the side stream says, in stream order.
struct Side
{
  std::vector<vtkMTTriangle> Triangles;
  vtkMTPositionCodec::Bases Bases; // of wedges
  std::vector<std::uint32_t> WedgePoints;
  std::vector<vtkMTIdCodec::Identity> Identities;
  vtkMTPositionCodec::Source Positions{};

  // bits: what follows the side stream.
  bool Read(SideReader& side, const Record& record, const unsigned char* bits, std::uint64_t bitsSize)
  {
    std::uint64_t stepsSize = 0;
    std::uint64_t namesSize = 0;
    const unsigned char* steps = side.Get(stepsSize) ? side.GetBytes(stepsSize) : nullptr;
    const unsigned char* names = steps && side.Get(namesSize) ? side.GetBytes(namesSize) : nullptr;
    std::vector<std::uint32_t> border;
    this->Triangles.resize(record.Triangles);
    if (!names ||
      !vtkMTTriangleCodec::Decode(steps, static_cast<std::size_t>(stepsSize), names,
        static_cast<std::size_t>(namesSize), record.Wedges, this->Triangles, this->Bases, border) ||
      (record.HasTable != 0 && !ReadWedges(side, record, this->WedgePoints)))
    {
      return false;
    }
    std::vector<std::uint32_t> order = vtkMTIdCodec::GetBorderOrder(border, this->WedgePoints, record.Points);
    if (!vtkMTIdCodec::Read(side, order, record.Points, record.SharedPoints, this->Identities))
    {
      return false;
    }
    this->Positions.Shift = record.Shift;
    this->Positions.Coarse = side.GetBytes(record.Shift > 0 ? (std::uint64_t(record.Points) + 7) / 8 : 0);
    this->Positions.Parameters = side.GetBytes(vtkMTPositionCodec::GetNumberOfBlocks(record.Points));
    std::uint64_t xSize = 0;
    std::uint64_t ySize = 0;
    if (!this->Positions.Coarse || !this->Positions.Parameters || !side.Get(xSize) || !side.Get(ySize) ||
      !side.IsAtEnd() || xSize > bitsSize || ySize > bitsSize - xSize)
    {
      return false;
    }
    this->Positions.BitsSize = { static_cast<std::size_t>(xSize), static_cast<std::size_t>(ySize),
      static_cast<std::size_t>(bitsSize - xSize - ySize) };
    this->Positions.Bits = { bits, bits + xSize, bits + xSize + ySize };
    return true;
  }
};

void Place(Side& side, const std::vector<vtkMTPoint>& streamPoints, vtkMTPatch& patch)
{
  std::vector<unsigned char> isShared(streamPoints.size(), 0);
  for (const vtkMTIdCodec::Identity& identity : side.Identities)
  {
    isShared[identity.Point] = 1;
  }
  const std::vector<std::uint32_t> pointOfStream = vtkMTPatchOrder::PlacePoints(isShared);
  const std::vector<std::uint32_t> wedgeOfStream = vtkMTPatchOrder::PlaceWedges(side.WedgePoints, pointOfStream);
  patch.Ids.resize(side.Identities.size());
  for (const vtkMTIdCodec::Identity& identity : side.Identities)
  {
    patch.Ids[pointOfStream[identity.Point]] = identity.Id;
  }
  patch.Points.resize(streamPoints.size());
  for (std::size_t i = 0; i < streamPoints.size(); ++i)
  {
    patch.Points[pointOfStream[i]] = streamPoints[i];
  }
  patch.WedgePoints.resize(side.WedgePoints.size());
  for (std::size_t w = 0; w < side.WedgePoints.size(); ++w)
  {
    patch.WedgePoints[wedgeOfStream[w]] = pointOfStream[side.WedgePoints[w]];
  }
  for (vtkMTTriangle& t : side.Triangles)
  {
    t = { wedgeOfStream[t[0]], wedgeOfStream[t[1]], wedgeOfStream[t[2]] };
  }
  patch.Triangles = std::move(side.Triangles);
}
}

namespace vtkMTPackedGeometry
{
bool Encode(const vtkMTPatchOrder& order, vtkMTFileFormat::Codec codec, std::vector<unsigned char>& bytes)
{
  std::vector<vtkMTPoint> streamPoints(order.PointOfStream.size());
  for (std::size_t i = 0; i < streamPoints.size(); ++i)
  {
    streamPoints[i] = order.Patch.Points[order.PointOfStream[i]];
  }
  const vtkMTPoint corner = GetCorner(streamPoints);
  const Known known(order);
  const vtkMTPositionCodec::Packed packed = vtkMTPositionCodec::Encode(streamPoints, known.Bases, corner);

  std::vector<unsigned char> side;
  Append(side, order.Steps.size());
  side.insert(side.end(), order.Steps.begin(), order.Steps.end());
  Append(side, order.Names.size());
  side.insert(side.end(), order.Names.begin(), order.Names.end());
  AppendWedges(order.WedgePoints, side);
  vtkMTIdCodec::Append(GetIdentities(order, known.BorderOrder), known.BorderOrder, side);
  side.insert(side.end(), packed.Coarse.begin(), packed.Coarse.end());
  side.insert(side.end(), packed.Parameters.begin(), packed.Parameters.end());
  Append(side, packed.Bits[0].size());
  Append(side, packed.Bits[1].size());

  const std::size_t begin = bytes.size();
  PackedGeometryRecord record{};
  bytes.resize(begin + sizeof(record));
  if (!vtkMTByteCodec::Compress(codec, side.data(), side.size(), bytes))
  {
    return false;
  }
  const std::size_t stored = bytes.size() - begin - sizeof(record);
  std::memcpy(record.Corner, corner.data(), sizeof(record.Corner));
  record.Shift = static_cast<std::uint8_t>(packed.Shift);
  record.HasTable = order.Patch.WedgePoints.empty() ? 0 : 1;
  record.SideSize = static_cast<std::uint32_t>(side.size());
  record.StoredSideSize = static_cast<std::uint32_t>(stored);
  std::memcpy(bytes.data() + begin, &record, sizeof(record));
  for (const std::vector<unsigned char>& bits : packed.Bits)
  {
    bytes.insert(bytes.end(), bits.begin(), bits.end());
  }
  return vtkMTByteCodec::IsPlausible(stored, side.size());
}

bool Decode(vtkMTFileFormat::Codec codec, const unsigned char* data, std::uint64_t size, const vtkMTArc& arc,
  vtkMTPatch& patch, std::string& error)
{
  PackedGeometryRecord stored;
  if (size < sizeof(stored))
  {
    error = "is too short";
    return false;
  }
  std::memcpy(&stored, data, sizeof(stored));
  const Record record(stored, arc);
  if (!IsRecordRight(record, size, error))
  {
    return false;
  }
  const std::uint64_t before = sizeof(stored) + record.StoredSideSize;
  std::vector<unsigned char> bytes(record.SideSize);
  Side side;
  SideReader reader(bytes.data(), bytes.size());
  if (!vtkMTByteCodec::Decompress(codec, data + sizeof(stored), record.StoredSideSize, bytes.data(), bytes.size()) ||
    !side.Read(reader, record, data + before, size - before))
  {
    error = "cannot be decompressed";
    return false;
  }
  std::vector<vtkMTPoint> points(record.Points);
  const vtkMTPoint corner{ record.Corner[0], record.Corner[1], record.Corner[2] };
  if (!side.WedgePoints.empty())
  {
    side.Bases = ToPoints(side.Bases, side.WedgePoints);
  }
  if (!vtkMTPositionCodec::Decode(side.Positions, side.Bases, corner, points))
  {
    error = "has positions of an impossible length";
    return false;
  }
  Place(side, points, patch);
  return true;
}
}
