// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinerLevels.h"

#include "vtkMTBytes.h"
#include "vtkMTFinerRecord.h"

#include <algorithm>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);
}

//------------------------------------------------------------------------------
void vtkMTFinerLevels::Encode(const vtkMTCertifiedMesh& patch, Bytes& bytes)
{
  vtkMTFinerRecord::Encode(patch.Mesh, patch.Deviations, bytes);
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
    return near.Touches(vtkMTFinerRecord::GetBall(arc.Arc.Box, origin, wider));
  };
  vtkMTBytes::Record record;
  for (const std::uint32_t r : this->FindRegionsBelow(state, place.Region, bottom))
  {
    const std::uint32_t first = finest.First[r];
    for (std::uint32_t k = first; k < finest.First[r + 1] && part.Mesh.Triangles.size() <= part.Most; ++k)
    {
      if (!touches(finest.Arcs[k]))
      {
        continue;
      }
      if (!finest.Records.Take(r, k - first, record, error))
      {
        return false;
      }
      if (!vtkMTFinerRecord::Append(record, near, origin, part))
      {
        error = "temporary data does not hold the mesh that was written";
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
