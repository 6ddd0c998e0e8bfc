// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinerLevels.h"

#include "vtkMTBytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);
constexpr std::size_t GroupLength = 8; // triangles that are taken together, as neighbours in order are in space
using Small = std::uint16_t;
constexpr std::int64_t LargestSmall = std::numeric_limits<Small>::max();

// A patch's shape in its record: points relative to its corner, and indices, each in two bytes where that is enough.
struct Header
{
  vtkMTPoint Corner;
  std::uint32_t HasSmallPoints;
  std::uint32_t HasSmallIndices;
};
// The ball around some triangles and what stands on them, relative to the corner.
struct Group
{
  std::array<float, 3> Middle;
  float Radius;
};

vtkMTSurface::Vector GetPlace(const vtkMTPoint& point, const vtkMTPoint& origin)
{
  return { double(point[0]) - origin[0], double(point[1]) - origin[1], double(point[2]) - origin[2] };
}

// Around a patch's points.
vtkMTBallGrid::Ball GetBall(const vtkMTBox& box, const vtkMTPoint& origin, double wider)
{
  const vtkMTSurface::Vector low = GetPlace({ box[0], box[2], box[4] }, origin);
  return vtkMTDirectDeviation::GetBall(low, low, GetPlace({ box[1], box[3], box[5] }, origin), wider);
}

// Rounded so that nothing is left out: single precision is within 2^-23 of coordinates that are below 2^32 in size.
Group MakeGroup(const vtkMTBox& box, const vtkMTPoint& corner, double wider)
{
  const vtkMTBallGrid::Ball ball = GetBall(box, corner, wider);
  Group group;
  double largest = ball.Radius;
  for (int i = 0; i < 3; ++i)
  {
    group.Middle[i] = static_cast<float>(ball.Middle[i]);
    largest = std::max(largest, std::abs(ball.Middle[i]));
  }
  group.Radius = static_cast<float>(ball.Radius + largest * 1e-6);
  return group;
}

template <typename Value>
void PutSmall(vtkMTBytes::Writer& writer, const std::vector<std::array<Value, 3>>& values, bool isSmall)
{
  if (!isSmall)
  {
    writer.PutList(values);
    return;
  }
  std::vector<std::array<Small, 3>> converted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      converted[i][c] = static_cast<Small>(values[i][c]);
    }
  }
  writer.PutList(converted);
}

// A list of three numbers each as it was put.
struct Triples
{
  std::vector<std::array<Small, 3>> SmallOnes;
  std::vector<std::array<std::uint32_t, 3>> Large;

  void Take(vtkMTBytes::Reader& reader, bool isSmall)
  {
    isSmall ? reader.TakeList(this->SmallOnes) : reader.TakeList(this->Large);
  }
  std::size_t GetSize() const { return std::max(this->SmallOnes.size(), this->Large.size()); }
  std::array<std::uint32_t, 3> Get(std::size_t i) const
  {
    if (this->SmallOnes.empty())
    {
      return this->Large[i];
    }
    const std::array<Small, 3>& small = this->SmallOnes[i];
    return { small[0], small[1], small[2] };
  }
};
}

//------------------------------------------------------------------------------
void vtkMTFinerLevels::Encode(const vtkMTCertifiedMesh& patch, Bytes& bytes)
{
  const vtkMTPatch& mesh = patch.Mesh;
  const vtkMTBox box = mesh.GetBox();
  const Header header{ { box[0], box[2], box[4] },
    std::int64_t(box[1]) - box[0] <= LargestSmall && std::int64_t(box[3]) - box[2] <= LargestSmall &&
      std::int64_t(box[5]) - box[4] <= LargestSmall,
    mesh.Points.size() <= static_cast<std::size_t>(LargestSmall) };
  std::vector<std::array<std::uint32_t, 3>> points(mesh.Points.size());
  std::vector<vtkMTTriangle> triangles(mesh.Triangles.size());
  std::vector<float> known;
  std::vector<Group> groups;
  bool isZero = true;
  for (std::size_t first = 0; first < triangles.size(); first += GroupLength)
  {
    vtkMTBox around{ box[1], box[0], box[3], box[2], box[5], box[4] };
    float wider = 0.0f;
    for (std::size_t t = first; t < std::min(first + GroupLength, triangles.size()); ++t)
    {
      triangles[t] = mesh.GetPointsOfTriangle(t);
      known.push_back(patch.Deviations[t].ToInput);
      known.push_back(patch.Deviations[t].FromInput);
      wider = std::max(wider, patch.Deviations[t].FromInput);
      isZero = isZero && patch.Deviations[t].ToInput == 0.0f && patch.Deviations[t].FromInput == 0.0f;
      for (const std::uint32_t p : triangles[t])
      {
        for (int i = 0; i < 3; ++i)
        {
          const std::int32_t x = mesh.Points[p][i];
          around[2 * i] = std::min(around[2 * i], x);
          around[2 * i + 1] = std::max(around[2 * i + 1], x);
          points[p][i] = static_cast<std::uint32_t>(x) - static_cast<std::uint32_t>(header.Corner[i]);
        }
      }
    }
    groups.push_back(MakeGroup(around, header.Corner, wider));
  }
  bytes.clear();
  vtkMTBytes::Writer writer(bytes);
  writer.Put(header);
  writer.PutList(groups);
  PutSmall(writer, points, header.HasSmallPoints);
  PutSmall(writer, triangles, header.HasSmallIndices);
  writer.PutList(isZero ? std::vector<float>() : known);
}

//------------------------------------------------------------------------------
// The groups of a record that are near.
bool vtkMTFinerLevels::Append(const Bytes& record, const vtkMTDirectDeviation::Neighbourhood& near,
  const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part, std::string& error)
{
  vtkMTBytes::Reader reader(record);
  const auto header = reader.Take<Header>();
  std::vector<Group> groups;
  Triples offsets;
  Triples triangles;
  std::vector<float> known;
  reader.TakeList(groups);
  offsets.Take(reader, header.HasSmallPoints);
  triangles.Take(reader, header.HasSmallIndices);
  reader.TakeList(known);
  const std::size_t count = triangles.GetSize();
  if (!reader.IsSound() || !reader.IsAtEnd() || groups.size() != (count + GroupLength - 1) / GroupLength)
  {
    error = "temporary data does not hold the mesh that was written";
    return false;
  }
  const vtkMTSurface::Vector corner = GetPlace(header.Corner, origin);
  std::vector<std::uint32_t> newIndex(offsets.GetSize(), None);
  const auto getNewIndex = [&](std::uint32_t p)
  {
    if (newIndex[p] == None)
    {
      newIndex[p] = static_cast<std::uint32_t>(part.Mesh.Points.size());
      const std::array<std::uint32_t, 3> offset = offsets.Get(p);
      vtkMTPoint point;
      for (int i = 0; i < 3; ++i)
      {
        point[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(header.Corner[i]) + offset[i]);
      }
      part.Mesh.Points.push_back(point);
    }
    return newIndex[p];
  };
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const std::array<float, 3>& middle = groups[g].Middle;
    if (!near.Touches({ { corner[0] + middle[0], corner[1] + middle[1], corner[2] + middle[2] }, groups[g].Radius }))
    {
      continue;
    }
    for (std::size_t t = GroupLength * g; t < std::min(GroupLength * (g + 1), count); ++t)
    {
      const std::array<std::uint32_t, 3> p = triangles.Get(t);
      part.Mesh.Triangles.push_back({ getNewIndex(p[0]), getNewIndex(p[1]), getNewIndex(p[2]) });
      part.Known.push_back({ known.empty() ? 0.0f : known[2 * t], known.empty() ? 0.0f : known[2 * t + 1], 0, 0 });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFinerLevels::Begin(vtkMTSpoolStore& store, std::uint32_t level, std::size_t regions, std::string& error)
{
  this->Levels.emplace_back();
  this->Levels.back().Number = level;
  return this->Levels.back().Records.Begin(store, GetName(level), regions, error);
}

//------------------------------------------------------------------------------
bool vtkMTFinerLevels::Put(std::size_t region, const Bytes& patch, std::string& error)
{
  return this->Levels.back().Records.Put(region, patch.data(), patch.size(), error);
}

//------------------------------------------------------------------------------
bool vtkMTFinerLevels::Seal(const vtkMTBuildState& state, std::uint64_t firstArc, std::string& error)
{
  Level& level = this->Levels.back();
  level.FirstArc = firstArc;
  level.EndArc = state.Arcs.size();
  ListArcs(state, true, level);
  return level.Records.Seal(error);
}

//------------------------------------------------------------------------------
// The region of the next partition that an arc leaves: as soon as all of its level are simplified, it is a node.
std::uint32_t vtkMTFinerLevels::GetRegion(
  const vtkMTBuildState& state, const vtkMTBuildState::ArcRecord& arc, bool hasRegions)
{
  return hasRegions ? arc.FromNode : state.Nodes[arc.FromNode].Region;
}

//------------------------------------------------------------------------------
void vtkMTFinerLevels::ListArcs(const vtkMTBuildState& state, bool hasRegions, Level& level)
{
  std::vector<std::uint32_t> next(level.Records.GetNumberOfKeys() + 1, 0);
  for (std::uint64_t a = level.FirstArc; a < level.EndArc; ++a)
  {
    ++next[GetRegion(state, state.Arcs[a], hasRegions) + 1];
  }
  for (std::size_t region = 1; region < next.size(); ++region)
  {
    next[region] += next[region - 1];
  }
  level.First = next;
  level.Arcs.resize(next.back());
  for (std::uint64_t a = level.FirstArc; a < level.EndArc; ++a)
  {
    level.Arcs[next[GetRegion(state, state.Arcs[a], hasRegions)]++] = static_cast<std::uint32_t>(a);
  }
}

//------------------------------------------------------------------------------
void vtkMTFinerLevels::Keep(std::size_t levels)
{
  while (this->Levels.size() > levels)
  {
    this->Levels.front().Records.Remove();
    this->Levels.pop_front();
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTFinerLevels::FindRegionsBelow(
  const vtkMTBuildState& state, std::uint32_t region, std::size_t bottom) const
{
  std::vector<std::uint32_t> regions{ region };
  for (std::size_t i = this->Levels.size() - 1; i > bottom; --i)
  {
    const Level& level = this->Levels[i];
    std::vector<std::uint32_t> below;
    for (const std::uint32_t r : regions)
    {
      for (std::uint32_t k = level.First[r]; k < level.First[r + 1]; ++k)
      {
        below.push_back(state.Nodes[state.Arcs[level.Arcs[k]].ToNode].Region);
      }
    }
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    regions = std::move(below);
  }
  return regions;
}

//------------------------------------------------------------------------------
bool vtkMTFinerLevels::Collect(const vtkMTBuildState& state, const Place& place,
  const vtkMTDirectDeviation::Neighbourhood& near, const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part,
  std::string& error) const
{
  const std::size_t bottom = this->Levels.size() - std::min(place.LevelsBelow, this->Levels.size());
  const Level& finest = this->Levels[bottom];
  // Nothing that stands on a patch's triangles is farther from it than the error of its node.
  const auto touches = [&](std::uint32_t a)
  {
    const vtkMTBuildState::ArcRecord& arc = state.Arcs[a];
    const double wider = arc.ToNode == None ? 0.0 : state.Nodes[arc.ToNode].Error;
    return near.Touches(GetBall(arc.Arc.Box, origin, wider));
  };
  std::vector<Bytes> records;
  for (const std::uint32_t r : this->FindRegionsBelow(state, place.Region, bottom))
  {
    const auto first = finest.Arcs.begin() + finest.First[r];
    const auto end = finest.Arcs.begin() + finest.First[r + 1];
    if (std::none_of(first, end, touches))
    {
      continue;
    }
    if (!finest.Records.Take(r, records, error))
    {
      return false;
    }
    for (std::size_t k = 0; k < records.size() && part.Mesh.Triangles.size() <= part.Most; ++k)
    {
      if (touches(first[static_cast<std::ptrdiff_t>(k)]) && !Append(records[k], near, origin, part, error))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMTFinerLevels::Save(Bytes& bytes) const
{
  vtkMTBytes::Writer writer(bytes);
  writer.Put<std::uint64_t>(this->Levels.size());
  for (const Level& level : this->Levels)
  {
    writer.Put(level.Number);
    writer.Put(level.FirstArc);
    writer.Put(level.EndArc);
    Bytes records;
    level.Records.Save(records);
    writer.PutList(records);
  }
}

//------------------------------------------------------------------------------
bool vtkMTFinerLevels::Open(
  vtkMTSpoolStore& store, const vtkMTBuildState& state, bool isLastInRegions, const Bytes& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  const auto count = reader.Take<std::uint64_t>();
  this->Levels.clear();
  for (std::uint64_t i = 0; i < count && reader.IsSound(); ++i)
  {
    this->Levels.emplace_back();
    Level& level = this->Levels.back();
    level.Number = reader.Take<std::uint32_t>();
    level.FirstArc = reader.Take<std::uint64_t>();
    level.EndArc = reader.Take<std::uint64_t>();
    Bytes records;
    reader.TakeList(records);
    if (!reader.IsSound() || level.EndArc > state.Arcs.size() || level.FirstArc > level.EndArc ||
      !level.Records.Open(store, GetName(level.Number), records, error))
    {
      error = error.empty() ? "the checkpoint does not hold what was kept" : error;
      return false;
    }
    ListArcs(state, isLastInRegions && i + 1 == count, level);
  }
  return reader.IsSound() && reader.IsAtEnd();
}
