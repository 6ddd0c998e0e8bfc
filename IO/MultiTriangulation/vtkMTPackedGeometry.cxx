// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPackedGeometry.h"

#include "vtkMTByteCodec.h"
#include "vtkMTDecodeScratch.h"
#include "vtkMTFill.h"
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
using vtkMTTriangleCodec::Basis;

constexpr std::size_t Slack = vtkMTRiceCode::Reader::Slack;

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
  wedgePoints.clear();
  if (record.HasTable == 0)
  {
    return true;
  }
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
const std::vector<Basis>& GetPointBases(vtkMTDecodeScratch& traversal)
{
  const std::vector<std::uint32_t>& wedgePoints = traversal.WedgePoints;
  if (wedgePoints.empty())
  {
    return traversal.Mesh.Bases;
  }
  const auto pointOf = [&wedgePoints](std::uint32_t w) { return w == vtkMTTriangleCodec::None ? w : wedgePoints[w]; };
  std::vector<Basis>& result = traversal.PointBases;
  result.clear();
  for (std::size_t w = 0; w < wedgePoints.size(); ++w)
  {
    if (wedgePoints[w] == result.size())
    {
      const Basis& ofWedge = traversal.Mesh.Bases[w];
      result.push_back({ pointOf(ofWedge.A), pointOf(ofWedge.B), pointOf(ofWedge.C) });
    }
  }
  return result;
}

// What the decoder will know once it has the triangles, from its mesh.
void Foresee(const vtkMTPatchOrder& order, vtkMTDecodeScratch& traversal)
{
  traversal.WedgePoints = order.WedgePoints;
  traversal.WedgeOfStream = vtkMTPatchOrder::PlaceWedges(order.WedgePoints, order.PointOfStream);
  vtkMTIdCodec::GetBorderOrder(
    traversal.Mesh.Border, order.WedgePoints, order.PointOfStream.size(), traversal.IsMarked, traversal.BorderOrder);
  vtkMTIdCodec::AppendOthers(traversal.BorderOrder, order.PointOfStream.size());
  traversal.IsKnown = true;
}

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
  // Eight triangles take one of the side bytes at least, 64 points three.
  const bool isPossible = record.Shift <= vtkMTPositionCodec::MaximumShift && record.HasTable <= 1 &&
    record.IsNear <= 1 && record.Reserved == 0 && (record.HasTable != 0 || record.Wedges == record.Points) &&
    record.SharedPoints <= record.Points && record.StoredSideSize <= size - sizeof(PackedGeometryRecord) &&
    vtkMTByteCodec::IsPlausible(record.StoredSideSize, record.SideSize) && record.Triangles / 8 <= record.SideSize &&
    record.Points / 32 <= record.SideSize && (record.HasTable == 0 || record.Wedges <= record.SideSize);
  error = isPossible ? error : "has an impossible header";
  return isPossible;
}

bool ReadTriangles(SideReader& side, const Record& record, vtkMTTriangleCodec::Decoded& mesh)
{
  std::uint64_t stepsSize = 0;
  std::uint64_t namesSize = 0;
  const unsigned char* steps = side.Get(stepsSize) ? side.GetBytes(stepsSize) : nullptr;
  const unsigned char* names = steps && side.Get(namesSize) ? side.GetBytes(namesSize) : nullptr;
  return names &&
    vtkMTTriangleCodec::Decode(steps, static_cast<std::size_t>(stepsSize), names, static_cast<std::size_t>(namesSize),
      record.Triangles, record.Wedges, mesh);
}

bool ReadIdentities(SideReader& side, const Record& record, vtkMTDecodeScratch& traversal)
{
  vtkMTIdCodec::GetBorderOrder(
    traversal.Mesh.Border, traversal.WedgePoints, record.Points, traversal.IsMarked, traversal.BorderOrder);
  return vtkMTIdCodec::Read(side, traversal.BorderOrder, record.Points, record.SharedPoints, traversal.Identities);
}

// bits: what follows the side bytes.
bool ReadPositions(SideReader& side, const Record& record, const unsigned char* bits, std::size_t bitsSize,
  vtkMTDecodeScratch& traversal)
{
  vtkMTPositionCodec::Source source{};
  source.Shift = record.Shift;
  source.IsNear = record.IsNear != 0;
  source.Coarse = side.GetBytes(record.Shift > 0 ? (std::uint64_t(record.Points) + 7) / 8 : 0);
  source.Parameters = source.Coarse ? side.GetBytes(3 * vtkMTRiceCode::GetNumberOfBlocks(record.Points)) : nullptr;
  std::uint64_t xSize = 0;
  std::uint64_t ySize = 0;
  if (!source.Parameters || !side.Get(xSize) || !side.Get(ySize) || !side.IsAtEnd() || xSize > bitsSize ||
    ySize > bitsSize)
  {
    return false;
  }
  source.UnarySizes = { static_cast<std::size_t>(xSize), static_cast<std::size_t>(ySize) };
  source.Bits = bits;
  source.BitsSize = bitsSize;
  const vtkMTPoint corner{ record.Corner[0], record.Corner[1], record.Corner[2] };
  return vtkMTPositionCodec::Decode(source, GetPointBases(traversal), corner, record.Points, traversal.Places);
}

//------------------------------------------------------------------------------
// From order of use to the patch. Shared points come first, then the others, both in order of use.
void PlacePoints(const Record& record, vtkMTDecodeScratch& traversal, vtkMTPatch& patch)
{
  std::vector<unsigned char>& isShared = traversal.IsMarked;
  isShared.assign(record.Points, 0);
  for (const vtkMTIdCodec::Identity& identity : traversal.Identities)
  {
    isShared[identity.Point] = 1;
  }
  std::vector<std::uint32_t>& place = traversal.PointOfStream;
  std::vector<std::uint32_t>& stream = traversal.StreamOfPoint;
  place.resize(record.Points);
  stream.resize(record.Points);
  std::uint32_t shared = 0;
  for (std::uint32_t i = 0; i < record.Points; ++i)
  {
    // Without a branch, as which way it goes cannot be predicted.
    const std::uint32_t mask = 0u - isShared[i];
    const std::uint32_t to = (shared & mask) | ((record.SharedPoints + i - shared) & ~mask);
    shared += isShared[i];
    place[i] = to;
    stream[to] = i;
  }
  vtkMTFill(patch.Points, record.Points,
    [from = stream.data(), places = traversal.Places.data() + 1](std::size_t i)
    {
      vtkMTPoint point;
      std::memcpy(point.data(), places + from[i], sizeof(point));
      return point;
    });
  patch.Ids.resize(record.SharedPoints);
  for (const vtkMTIdCodec::Identity& identity : traversal.Identities)
  {
    patch.Ids[place[identity.Point]] = identity.Id;
  }
}

void Place(const Record& record, vtkMTDecodeScratch& traversal, vtkMTPatch& patch)
{
  PlacePoints(record, traversal, patch);
  if (record.HasTable == 0)
  {
    traversal.WedgeOfStream.swap(traversal.PointOfStream);
  }
  else
  {
    traversal.WedgeOfStream = vtkMTPatchOrder::PlaceWedges(traversal.WedgePoints, traversal.PointOfStream);
    patch.WedgePoints.resize(record.Wedges);
    for (std::uint32_t w = 0; w < record.Wedges; ++w)
    {
      patch.WedgePoints[traversal.WedgeOfStream[w]] = traversal.PointOfStream[traversal.WedgePoints[w]];
    }
  }
  const std::uint32_t* const place = traversal.WedgeOfStream.data();
  const std::array<std::uint32_t, 4>* const triangles = traversal.Mesh.Triangles.data();
  vtkMTFill(patch.Triangles, record.Triangles,
    [place, triangles](std::size_t t) {
      return vtkMTTriangle{ place[triangles[t][0]], place[triangles[t][1]], place[triangles[t][2]] };
    });
}
}

namespace vtkMTPackedGeometry
{
bool Encode(const vtkMTPatchOrder& order, vtkMTFileFormat::Codec codec, std::vector<unsigned char>& bytes,
  vtkMTDecodeScratch& traversal)
{
  std::vector<vtkMTPoint> streamPoints(order.PointOfStream.size());
  for (std::size_t i = 0; i < streamPoints.size(); ++i)
  {
    streamPoints[i] = order.Patch.Points[order.PointOfStream[i]];
  }
  const vtkMTPoint corner = GetCorner(streamPoints);
  Foresee(order, traversal);
  const vtkMTPositionCodec::Packed packed = vtkMTPositionCodec::Encode(streamPoints, GetPointBases(traversal), corner);

  std::vector<unsigned char> side;
  Append(side, order.Steps.size());
  side.insert(side.end(), order.Steps.begin(), order.Steps.end());
  Append(side, order.Names.size());
  side.insert(side.end(), order.Names.begin(), order.Names.end());
  AppendWedges(order.WedgePoints, side);
  vtkMTIdCodec::Append(GetIdentities(order, traversal.BorderOrder), traversal.BorderOrder, side);
  side.insert(side.end(), packed.Coarse.begin(), packed.Coarse.end());
  for (const vtkMTRiceCode::Coded& axis : packed.Axes)
  {
    side.insert(side.end(), axis.Parameters.begin(), axis.Parameters.end());
  }
  Append(side, packed.Axes[0].Unary.size());
  Append(side, packed.Axes[1].Unary.size());

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
  record.IsNear = packed.IsNear ? 1 : 0;
  record.HasTable = order.Patch.WedgePoints.empty() ? 0 : 1;
  record.SideSize = static_cast<std::uint32_t>(side.size());
  record.StoredSideSize = static_cast<std::uint32_t>(stored);
  std::memcpy(bytes.data() + begin, &record, sizeof(record));
  for (const vtkMTRiceCode::Coded& axis : packed.Axes)
  {
    bytes.insert(bytes.end(), axis.Low.begin(), axis.Low.end());
  }
  for (const vtkMTRiceCode::Coded& axis : packed.Axes)
  {
    bytes.insert(bytes.end(), axis.Unary.begin(), axis.Unary.end());
  }
  return vtkMTByteCodec::IsPlausible(stored, side.size());
}

bool Decode(vtkMTFileFormat::Codec codec, const unsigned char* data, std::uint64_t size, const vtkMTArc& arc,
  vtkMTDecodeScratch& traversal, vtkMTPatch& patch, std::string& error)
{
  traversal.IsKnown = false;
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
  const std::size_t before = sizeof(stored) + record.StoredSideSize;
  const unsigned char* const bits = data + before;
  const std::size_t bitsSize = static_cast<std::size_t>(size) - before;
  std::vector<unsigned char>& bytes = traversal.Bytes;
  bytes.resize(record.SideSize + Slack); // for loads of a whole word
  SideReader side(bytes.data(), record.SideSize);
  if (!vtkMTByteCodec::Decompress(codec, data + sizeof(stored), record.StoredSideSize, bytes.data(), record.SideSize) ||
    !ReadTriangles(side, record, traversal.Mesh) || !ReadWedges(side, record, traversal.WedgePoints) ||
    !ReadIdentities(side, record, traversal) || !ReadPositions(side, record, bits, bitsSize, traversal))
  {
    error = "cannot be decompressed";
    return false;
  }
  Place(record, traversal, patch);
  traversal.IsKnown = true;
  return true;
}
}
