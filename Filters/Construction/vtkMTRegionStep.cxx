// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegionStep.h"

#include "vtkMTAssembler.h"
#include "vtkMTAttributeTransfer.h"
#include "vtkMTDeviation.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTSimplifier.h"
#include "vtkMTTriangleTree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace
{
bool IsLocked(const std::vector<std::uint64_t>& lockedIds, std::uint64_t id)
{
  return id != vtkMTAssembler::NoId && std::binary_search(lockedIds.begin(), lockedIds.end(), id);
}

// Whether the patch has an edge that was on the border of its finer region and is on the border of the coarser one again: such edges
// stay as they are for two levels.
bool SharesBorder(const vtkMTPatch& patch, const std::vector<std::uint64_t>& lockedIds, std::uint32_t floorLevel)
{
  std::vector<unsigned char> isOnBoth(patch.Points.size(), 0);
  for (std::size_t p = 0; p < patch.Ids.size(); ++p)
  {
    isOnBoth[p] =
      !vtkMTPatchSplitter::WasMadeOnLevel(patch.Ids[p], floorLevel) && IsLocked(lockedIds, patch.Ids[p]) ? 1 : 0;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t a = p[c];
      const std::uint32_t b = p[(c + 1) % 3];
      if (isOnBoth[a] && isOnBoth[b])
      {
        edges.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();)
  {
    const std::size_t end = std::upper_bound(edges.begin(), edges.end(), edges[i]) - edges.begin();
    if (end - i == 1)
    {
      return true;
    }
    i = end;
  }
  return false;
}

// The simplified mesh with locked points first, in the floor's order: only these are shared, and only they have ids.
vtkMTPatch MakeFragment(
  vtkMTSimplification& simplification, const std::vector<unsigned char>& locked, const vtkMTPatch& floor)
{
  const std::size_t count = simplification.Points.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const auto isShared = [&](std::uint32_t p) { return locked[simplification.PointOrigin[p]] != 0; };
  std::stable_partition(order.begin(), order.end(), isShared);
  std::vector<std::uint32_t> newIndex(count);
  vtkMTPatch fragment;
  std::vector<std::uint32_t> origin(count);
  std::vector<unsigned char> moved(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const std::uint32_t p = order[i];
    newIndex[p] = i;
    fragment.Points.push_back(simplification.Points[p]);
    origin[i] = simplification.PointOrigin[p];
    moved[i] = simplification.Moved[p];
    if (isShared(p))
    {
      fragment.Ids.push_back(floor.Ids[origin[i]]);
    }
  }
  // Wedges in order of point: where each point has one, wedge i is point i and nothing needs to be stored.
  std::vector<std::uint32_t> wedges(simplification.WedgePoints.size());
  std::iota(wedges.begin(), wedges.end(), 0u);
  std::stable_sort(wedges.begin(), wedges.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return newIndex[simplification.WedgePoints[a]] < newIndex[simplification.WedgePoints[b]]; });
  std::vector<std::uint32_t> newWedge(wedges.size());
  std::vector<std::uint32_t> wedgePoints(wedges.size());
  std::vector<std::uint32_t> wedgeOrigin(wedges.size());
  for (std::uint32_t i = 0; i < wedges.size(); ++i)
  {
    newWedge[wedges[i]] = i;
    wedgePoints[i] = newIndex[simplification.WedgePoints[wedges[i]]];
    wedgeOrigin[i] = simplification.WedgeOrigin[wedges[i]];
  }
  for (vtkMTTriangle& t : simplification.Triangles)
  {
    t = { newWedge[t[0]], newWedge[t[1]], newWedge[t[2]] };
  }
  simplification.Points = fragment.Points;
  simplification.PointOrigin = std::move(origin);
  simplification.Moved = std::move(moved);
  simplification.WedgePoints = wedgePoints;
  simplification.WedgeOrigin = std::move(wedgeOrigin);
  fragment.Triangles = simplification.Triangles;
  if (wedgePoints.size() != count)
  {
    fragment.WedgePoints = std::move(wedgePoints);
  }
  return fragment;
}

vtkMTPoint GetMiddle(const vtkMTPatch& mesh)
{
  const vtkMTBox box = mesh.GetBox();
  vtkMTPoint middle;
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = static_cast<std::int32_t>((std::int64_t(box[2 * i]) + box[2 * i + 1]) / 2);
  }
  return middle;
}
}

bool vtkMTRegionStep::Run(std::vector<vtkMTPatch>& floorPatches, const Context& context, std::string& error)
{
  vtkMTAssembler assembler(*context.Arrays);
  this->HasFullySharedBorder = !floorPatches.empty();
  for (vtkMTPatch& patch : floorPatches)
  {
    this->HasFullySharedBorder =
      this->HasFullySharedBorder && SharesBorder(patch, *context.LockedIds, context.FloorLevel);
    if (!assembler.Add(patch))
    {
      error = assembler.GetError();
      return false;
    }
    patch = vtkMTPatch();
  }
  const vtkMTPatch floor = assembler.TakeMesh();
  this->FloorTriangles = floor.Triangles.size();
  std::vector<unsigned char> locked(floor.Points.size());
  for (std::size_t p = 0; p < locked.size(); ++p)
  {
    locked[p] = IsLocked(*context.LockedIds, floor.Ids[p]) ? 1 : 0;
  }
  vtkMTSimplification simplification;
  const std::size_t target = std::max<std::size_t>(1, floor.Triangles.size() / 2);
  if (!context.Simplifier->Simplify(floor, locked, target, simplification, error))
  {
    return false;
  }
  this->Fragment = MakeFragment(simplification, locked, floor);
  const vtkMTPoint origin = GetMiddle(floor);
  const vtkMTTriangleTree floorTree(floor, origin);
  const vtkMTTriangleTree fragmentTree(this->Fragment, origin);
  this->StepError = vtkMTDeviation::Between(floor, floorTree, this->Fragment, fragmentTree, origin).UpperBound;
  this->EdgeLength = this->Fragment.GetMeanEdgeLength();
  vtkMTAttributeTransfer::Run(floor, floorTree, origin, simplification, *context.Arrays, this->Fragment);
  if (this->Fragment.Triangles.size() > target)
  {
    this->Blocked = std::move(simplification.Blocked);
  }
  return true;
}
