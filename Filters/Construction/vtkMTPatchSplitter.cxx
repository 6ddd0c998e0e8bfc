// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSplitter.h"

#include "Tuples/vtkMTTuples.h"
#include "vtkMTBorderOrder.h"
#include "vtkMTRadixSort.h"

#include <algorithm>
#include <numeric>

namespace
{
std::vector<vtkMTColumn> GatherAll(const std::vector<vtkMTColumn>& columns, const std::vector<std::size_t>& tupleSizes,
  const std::vector<std::uint32_t>& tuples)
{
  std::vector<vtkMTColumn> result;
  result.reserve(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    result.push_back(vtkMTTuples::Gather(columns[i], tupleSizes[i], tuples));
  }
  return result;
}

// The points and wedges that triangles use, each once; scratch, of wedges and then of points, has no None for these.
struct Corners
{
  std::vector<std::uint32_t> Points;
  std::vector<std::uint32_t> Wedges;

  void Forget(std::size_t wedgeCount, std::vector<std::uint32_t>& scratch) const
  {
    for (std::uint32_t w : this->Wedges)
    {
      scratch[w] = vtkMTPatchSplitter::None;
    }
    for (std::uint32_t p : this->Points)
    {
      scratch[wedgeCount + p] = vtkMTPatchSplitter::None;
    }
  }
};

Corners FindCorners(
  const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& scratch)
{
  Corners corners;
  const std::size_t wedgeCount = mesh.GetNumberOfWedges();
  const bool hasWedges = !mesh.WedgePoints.empty();
  for (std::uint32_t t : triangles)
  {
    for (std::uint32_t w : mesh.Triangles[t])
    {
      if (scratch[w] != vtkMTPatchSplitter::None)
      {
        continue;
      }
      scratch[w] = 0;
      if (!hasWedges)
      {
        scratch[wedgeCount + w] = 0;
        corners.Points.push_back(w);
        continue;
      }
      corners.Wedges.push_back(w);
      const std::uint32_t p = mesh.GetPointOfWedge(w);
      if (scratch[wedgeCount + p] == vtkMTPatchSplitter::None)
      {
        scratch[wedgeCount + p] = 0;
        corners.Points.push_back(p);
      }
    }
  }
  return corners;
}

// Shared ones first, else in increasing order. scratch knows them.
void SortPoints(const std::vector<unsigned char>& isShared, std::size_t wedgeCount,
  const std::vector<std::uint32_t>& scratch, std::vector<std::uint32_t>& points)
{
  const std::size_t all = isShared.size();
  if (points.size() < all / 32) // fewer than are worth looking at all others
  {
    std::sort(points.begin(), points.end());
    std::stable_partition(points.begin(), points.end(), [&isShared](std::uint32_t p) { return isShared[p] != 0; });
    return;
  }
  const std::uint32_t* isUsed = scratch.data() + wedgeCount;
  std::vector<std::uint32_t> others;
  others.reserve(points.size());
  points.clear();
  for (std::uint32_t p = 0; p < all; ++p)
  {
    if (isUsed[p] != vtkMTPatchSplitter::None)
    {
      (isShared[p] ? points : others).push_back(p);
    }
  }
  points.insert(points.end(), others.begin(), others.end());
}

std::vector<std::size_t> GetTupleSizes(const std::vector<vtkMTColumn>& columns, std::size_t tuples)
{
  std::vector<std::size_t> sizes;
  sizes.reserve(columns.size());
  for (const vtkMTColumn& column : columns)
  {
    sizes.push_back(tuples > 0 ? column.size() / tuples : 0);
  }
  return sizes;
}

// Triangles in order of region, each region's in increasing order.
struct Groups
{
  std::vector<std::uint32_t> Regions; // increasing
  std::vector<std::vector<std::uint32_t>> Triangles;

  explicit Groups(const std::vector<std::uint32_t>& regions)
    : Regions(FindRegions(regions))
    , Triangles(this->Regions.size())
  {
    std::uint32_t last = 0; // neighbours in the list are of one group as a rule
    for (std::uint32_t t = 0; t < regions.size(); ++t)
    {
      if (this->Regions[last] != regions[t])
      {
        const auto found = std::lower_bound(this->Regions.begin(), this->Regions.end(), regions[t]);
        last = static_cast<std::uint32_t>(found - this->Regions.begin());
      }
      this->Triangles[last].push_back(t);
    }
  }

private:
  static std::vector<std::uint32_t> FindRegions(const std::vector<std::uint32_t>& regions)
  {
    std::vector<std::uint32_t> found; // of each run
    for (const std::uint32_t region : regions)
    {
      if (found.empty() || found.back() != region)
      {
        found.push_back(region);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
};

// Which points are used by more than one group, beside those that the fragment shares already.
void FindShared(const vtkMTPatch& fragment, const Groups& groups, std::vector<unsigned char>& isShared)
{
  constexpr std::uint32_t none = vtkMTPatchSplitter::None;
  std::vector<std::uint32_t> lastUser(fragment.Points.size(), none);
  for (std::uint32_t g = 0; g < groups.Regions.size(); ++g)
  {
    for (const std::uint32_t t : groups.Triangles[g])
    {
      for (const std::uint32_t p : fragment.GetPointsOfTriangle(t))
      {
        if (lastUser[p] != g)
        {
          isShared[p] = isShared[p] || lastUser[p] != none ? 1 : 0;
          lastUser[p] = g;
        }
      }
    }
  }
}

// Identities of what became shared, numbered along the borders of the groups in their order.
std::vector<std::uint64_t> MakeIds(const vtkMTPatch& fragment, const Groups& groups,
  const std::vector<unsigned char>& isShared, std::uint32_t level, std::uint32_t region)
{
  std::vector<std::uint64_t> ids = fragment.Ids;
  ids.resize(fragment.Points.size(), 0);
  std::vector<unsigned char> isNew(fragment.Points.size());
  for (std::size_t p = fragment.Ids.size(); p < ids.size(); ++p)
  {
    isNew[p] = isShared[p];
  }
  std::uint32_t next = 0;
  const auto number = [&](std::uint32_t p)
  {
    if (isNew[p])
    {
      ids[p] = vtkMTPatchSplitter::MakeId(level, region, next++);
      isNew[p] = 0;
    }
  };
  vtkMTBorderOrder borders(fragment);
  for (const std::vector<std::uint32_t>& triangles : groups.Triangles)
  {
    const std::vector<std::uint32_t> border = borders.Find(triangles);
    std::for_each(border.begin(), border.end(), number);
  }
  for (std::uint32_t p = 0; p < ids.size(); ++p)
  {
    number(p); // where the groups meet in single points
  }
  return ids;
}
}

vtkMTPatch vtkMTPatchSplitter::Extract(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles,
  const std::vector<unsigned char>& isShared, const std::vector<std::uint64_t>& ids,
  const std::vector<std::size_t>& pointTupleSizes, const std::vector<std::size_t>& cellTupleSizes,
  std::vector<std::uint32_t>& scratch)
{
  vtkMTPatch patch;
  const std::size_t wedgeCount = mesh.GetNumberOfWedges();
  Corners corners = FindCorners(mesh, triangles, scratch);
  std::vector<std::uint32_t>& points = corners.Points;
  std::vector<std::uint32_t>& wedges = corners.Wedges;
  SortPoints(isShared, wedgeCount, scratch, points);
  patch.Points.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    scratch[wedgeCount + points[i]] = i;
    patch.Points.push_back(mesh.Points[points[i]]);
    if (isShared[points[i]])
    {
      patch.Ids.push_back(ids[points[i]]);
    }
  }
  const auto newPoint = [&](std::uint32_t w) { return scratch[wedgeCount + mesh.GetPointOfWedge(w)]; };
  if (mesh.WedgePoints.empty())
  {
    wedges = points;
  }
  else
  {
    std::vector<std::uint32_t> sortScratch;
    vtkMTRadixSort::Sort(wedges, sortScratch, [&](std::uint32_t w) { return (std::uint64_t(newPoint(w)) << 32) | w; });
  }
  for (std::uint32_t i = 0; i < wedges.size(); ++i)
  {
    scratch[wedges[i]] = i;
    if (wedges.size() != points.size())
    {
      patch.WedgePoints.push_back(newPoint(wedges[i]));
    }
  }
  patch.Triangles.reserve(triangles.size());
  for (std::uint32_t t : triangles)
  {
    const vtkMTTriangle& w = mesh.Triangles[t];
    patch.Triangles.push_back({ scratch[w[0]], scratch[w[1]], scratch[w[2]] });
  }
  patch.PointColumns = GatherAll(mesh.PointColumns, pointTupleSizes, wedges);
  patch.CellColumns = GatherAll(mesh.CellColumns, cellTupleSizes, triangles);
  corners.Forget(wedgeCount, scratch);
  return patch;
}

vtkMTPatchSplitter vtkMTPatchSplitter::Split(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& regions,
  std::uint32_t level, std::uint32_t fragmentRegion)
{
  vtkMTPatchSplitter result;
  Groups groups(regions);
  std::vector<unsigned char> isShared(fragment.Points.size(), 0);
  std::fill(isShared.begin(), isShared.begin() + static_cast<std::ptrdiff_t>(fragment.Ids.size()), 1);
  FindShared(fragment, groups, isShared);
  const std::vector<std::uint64_t> ids = MakeIds(fragment, groups, isShared, level, fragmentRegion);
  const auto pointTupleSizes = GetTupleSizes(fragment.PointColumns, fragment.GetNumberOfWedges());
  const auto cellTupleSizes = GetTupleSizes(fragment.CellColumns, fragment.Triangles.size());
  std::vector<std::uint32_t> scratch(fragment.GetNumberOfWedges() + fragment.Points.size(), None);
  for (std::size_t g = 0; g < groups.Regions.size(); ++g)
  {
    std::vector<std::uint32_t>& triangles = groups.Triangles[g];
    vtkMTPatch patch = Extract(fragment, triangles, isShared, ids, pointTupleSizes, cellTupleSizes, scratch);
    result.Parts.push_back({ groups.Regions[g], std::move(patch), std::move(triangles) });
    for (const std::uint64_t id : result.Parts.back().Patch.Ids)
    {
      result.Uses.emplace_back(id, groups.Regions[g]);
    }
  }
  return result;
}
