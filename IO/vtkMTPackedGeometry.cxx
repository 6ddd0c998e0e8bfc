// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPackedGeometry.h"

#include "vtkMTByteCodec.h"
#include "vtkMTGraph.h"
#include "vtkMTNumberCode.h"
#include "vtkMTPatchOrder.h"
#include "vtkMTPositionCodec.h"
#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace
{
using vtkMTFileFormat::PackedGeometryRecord;

using SideReader = vtkMTNumberCode::Reader;
using vtkMTNumberCode::Append;

//------------------------------------------------------------------------------
// Which points can be shared
void AppendShared(const vtkMTPatchOrder& order, std::vector<unsigned char>& side)
{
  const std::size_t begin = side.size();
  side.resize(begin + (order.PointOfStream.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < order.PointOfStream.size(); ++i)
  {
    if (order.PointOfStream[i] < order.Patch.Ids.size())
    {
      side[begin + i / 8] |= static_cast<unsigned char>(1u << (i % 8));
    }
  }
}

bool ReadShared(SideReader& side, const PackedGeometryRecord& record, std::vector<unsigned char>& isShared)
{
  const unsigned char* bits = side.GetBytes((std::uint64_t(record.Points) + 7) / 8);
  if (!bits)
  {
    return false;
  }
  isShared.resize(record.Points);
  std::uint32_t shared = 0;
  for (std::size_t i = 0; i < isShared.size(); ++i)
  {
    isShared[i] = bits[i / 8] >> (i % 8) & 1;
    shared += isShared[i];
  }
  return shared == record.SharedPoints;
}

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

bool ReadWedges(SideReader& side, const PackedGeometryRecord& record, std::vector<std::uint32_t>& wedgePoints)
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
// Identities: the high halves are few (a level and a region), so each one is said once; the low half is said as the
// difference to the one before with the same high half.
void AppendIds(const vtkMTPatchOrder& order, std::vector<unsigned char>& side)
{
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> highs;
  for (std::uint64_t id : order.Patch.Ids)
  {
    const auto high = static_cast<std::uint32_t>(id >> 32);
    if (number.emplace(high, static_cast<std::uint32_t>(highs.size())).second)
    {
      highs.push_back(high);
    }
  }
  Append(side, highs.size());
  for (std::uint32_t high : highs)
  {
    Append(side, high);
  }
  std::vector<std::uint32_t> before(highs.size(), 0);
  for (std::uint64_t id : order.Patch.Ids)
  {
    const std::uint32_t high = number[static_cast<std::uint32_t>(id >> 32)];
    const auto low = static_cast<std::uint32_t>(id);
    Append(side, high);
    Append(side, vtkMTNumberCode::ToZigzag(low - before[high]));
    before[high] = low;
  }
}

bool ReadIds(SideReader& side, const PackedGeometryRecord& record, std::vector<std::uint64_t>& ids)
{
  std::uint64_t count = 0;
  if (!side.Get(count) || count > record.SharedPoints)
  {
    return false;
  }
  std::vector<std::uint64_t> highs(static_cast<std::size_t>(count));
  for (std::uint64_t& high : highs)
  {
    if (!side.Get(high) || high > 0xffffffffu)
    {
      return false;
    }
  }
  std::vector<std::uint32_t> before(highs.size(), 0);
  ids.reserve(record.SharedPoints);
  for (std::uint32_t i = 0; i < record.SharedPoints; ++i)
  {
    std::uint64_t high = 0;
    std::uint64_t code = 0;
    if (!side.Get(high) || !side.Get(code) || high >= count || code > 0xffffffffu)
    {
      return false;
    }
    before[high] += vtkMTNumberCode::FromZigzag(static_cast<std::uint32_t>(code));
    ids.push_back(highs[high] << 32 | before[high]);
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

// What the decoder will know of every point.
vtkMTPositionCodec::Bases GetBases(const vtkMTPatchOrder& order)
{
  vtkMTPositionCodec::Bases bases;
  std::vector<vtkMTTriangle> triangles(order.Patch.Triangles.size());
  vtkMTTriangleCodec::Decode(order.Steps.data(), order.Steps.size(), order.Names.data(), order.Names.size(),
    order.Patch.GetNumberOfWedges(), triangles, bases);
  return order.WedgePoints.empty() ? bases : ToPoints(bases, order.WedgePoints);
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

bool IsRecordRight(const PackedGeometryRecord& record, const vtkMTArc& arc, std::uint64_t size, std::string& error)
{
  if (record.Points != arc.Points || record.Wedges != arc.Wedges || record.Triangles != arc.Triangles ||
    record.SharedPoints != arc.SharedPoints)
  {
    error = "does not have the numbers of points, wedges and triangles that its arc announces";
    return false;
  }
  // Five triangles take a byte of the side stream at least, 16 points three.
  const bool isPossible = record.Shift <= vtkMTPositionCodec::MaximumShift && record.HasTable <= 1 &&
    record.Reserved == 0 && (record.HasTable != 0 || record.Wedges == record.Points) &&
    record.SharedPoints <= record.Points && record.StoredSideSize <= size - sizeof(record) &&
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
  std::vector<unsigned char> IsShared;
  std::vector<std::uint64_t> Ids;
  vtkMTPositionCodec::Source Positions{};

  bool Read(SideReader& side, const PackedGeometryRecord& record)
  {
    std::uint64_t stepsSize = 0;
    std::uint64_t namesSize = 0;
    const unsigned char* steps = side.Get(stepsSize) ? side.GetBytes(stepsSize) : nullptr;
    const unsigned char* names = steps && side.Get(namesSize) ? side.GetBytes(namesSize) : nullptr;
    if (!names || !ReadShared(side, record, this->IsShared) ||
      (record.HasTable != 0 && !ReadWedges(side, record, this->WedgePoints)) || !ReadIds(side, record, this->Ids))
    {
      return false;
    }
    this->Positions.Shift = record.Shift;
    this->Positions.Coarse = side.GetBytes(record.Shift > 0 ? (std::uint64_t(record.Points) + 7) / 8 : 0);
    this->Positions.Widths = side.GetBytes(vtkMTPositionCodec::GetNumberOfBlocks(record.Points));
    this->Triangles.resize(record.Triangles);
    return this->Positions.Coarse && this->Positions.Widths && side.IsAtEnd() &&
      vtkMTTriangleCodec::Decode(steps, static_cast<std::size_t>(stepsSize), names, static_cast<std::size_t>(namesSize),
        record.Wedges, this->Triangles, this->Bases);
  }
};

void Place(Side& side, const std::vector<vtkMTPoint>& streamPoints, vtkMTPatch& patch)
{
  const std::vector<std::uint32_t> pointOfStream = vtkMTPatchOrder::PlacePoints(side.IsShared);
  const std::vector<std::uint32_t> wedgeOfStream = vtkMTPatchOrder::PlaceWedges(side.WedgePoints, pointOfStream);
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
  patch.Ids = std::move(side.Ids);
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
  const vtkMTPositionCodec::Packed packed = vtkMTPositionCodec::Encode(streamPoints, GetBases(order), corner);

  std::vector<unsigned char> side;
  Append(side, order.Steps.size());
  side.insert(side.end(), order.Steps.begin(), order.Steps.end());
  Append(side, order.Names.size());
  side.insert(side.end(), order.Names.begin(), order.Names.end());
  AppendShared(order, side);
  AppendWedges(order.WedgePoints, side);
  AppendIds(order, side);
  side.insert(side.end(), packed.Coarse.begin(), packed.Coarse.end());
  side.insert(side.end(), packed.Widths.begin(), packed.Widths.end());

  const std::size_t begin = bytes.size();
  PackedGeometryRecord record{};
  bytes.resize(begin + sizeof(record));
  if (!vtkMTByteCodec::Compress(codec, side.data(), side.size(), bytes))
  {
    return false;
  }
  const std::size_t stored = bytes.size() - begin - sizeof(record);
  record.Points = static_cast<std::uint32_t>(order.Patch.Points.size());
  record.Wedges = static_cast<std::uint32_t>(order.Patch.GetNumberOfWedges());
  record.Triangles = static_cast<std::uint32_t>(order.Patch.Triangles.size());
  record.SharedPoints = static_cast<std::uint32_t>(order.Patch.Ids.size());
  std::memcpy(record.Corner, corner.data(), sizeof(record.Corner));
  record.Shift = static_cast<std::uint8_t>(packed.Shift);
  record.HasTable = order.Patch.WedgePoints.empty() ? 0 : 1;
  record.SideSize = static_cast<std::uint32_t>(side.size());
  record.StoredSideSize = static_cast<std::uint32_t>(stored);
  std::memcpy(bytes.data() + begin, &record, sizeof(record));
  bytes.insert(bytes.end(), packed.Bits.begin(), packed.Bits.end());
  return vtkMTByteCodec::IsPlausible(stored, side.size());
}

bool Decode(vtkMTFileFormat::Codec codec, const unsigned char* data, std::uint64_t size, const vtkMTArc& arc,
  vtkMTPatch& patch, std::string& error)
{
  PackedGeometryRecord record;
  if (size < sizeof(record))
  {
    error = "is too short";
    return false;
  }
  std::memcpy(&record, data, sizeof(record));
  if (!IsRecordRight(record, arc, size, error))
  {
    return false;
  }
  std::vector<unsigned char> bytes(record.SideSize);
  Side side;
  SideReader reader(bytes.data(), bytes.size());
  if (!vtkMTByteCodec::Decompress(codec, data + sizeof(record), record.StoredSideSize, bytes.data(), bytes.size()) ||
    !side.Read(reader, record))
  {
    error = "cannot be decompressed";
    return false;
  }
  const std::uint64_t before = sizeof(record) + record.StoredSideSize;
  side.Positions.Bits = data + before;
  side.Positions.BitsSize = static_cast<std::size_t>(size - before);
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
