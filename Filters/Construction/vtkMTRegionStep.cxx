// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegionStep.h"

#include "vtkMTAssembler.h"
#include "vtkMTAttributeTransfer.h"
#include "vtkMTCoarsePoints.h"
#include "vtkMTDeviation.h"
#include "vtkMTDirectDeviation.h"
#include "vtkMTMadeNormals.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTPointNormals.h"
#include "vtkMTRoundUp.h"
#include "vtkMTShadingNormals.h"
#include "vtkMTSimplifier.h"
#include "vtkMTStageTimes.h"
#include "vtkMTSurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
bool IsLocked(const std::vector<std::uint64_t>& lockedIds, std::uint64_t id)
{
  return id != vtkMTAssembler::NoId && std::binary_search(lockedIds.begin(), lockedIds.end(), id);
}

// BMT section 3.2, condition 3: whether every edge of the region's border was on the border of a finer region already,
// so that nothing of the border could be simplified for two levels. An edge is on the border when one triangle of the
// floor uses it and triangles outside use both of its ends; it was on a finer one when both ends were shared before the
// floor's level was split.
bool HasBorderOfFinerRegions(
  const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::uint32_t floorLevel)
{
  struct Edge
  {
    std::uint32_t Low;
    std::uint32_t High;
    bool operator<(const Edge& other) const { return Low != other.Low ? Low < other.Low : High < other.High; }
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = floor.GetPointsOfTriangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t a = p[c];
      const std::uint32_t b = p[(c + 1) % 3];
      if (locked[a] && locked[b])
      {
        edges.push_back({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto isOld = [&](std::uint32_t p) { return !vtkMTPatchSplitter::WasMadeOnLevel(floor.Ids[p], floorLevel); };
  bool hasBorder = false;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto end = std::upper_bound(edge, edges.end(), *edge);
    if (end - edge == 1)
    {
      hasBorder = true;
      if (!isOld(edge->Low) || !isOld(edge->High))
      {
        return false;
      }
    }
    edge = end;
  }
  return hasBorder;
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
  for (std::uint32_t& heir : simplification.Heirs)
  {
    heir = heir == vtkMTSimplification::NoHeir ? heir : newIndex[heir];
  }
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

// Without triangles on failure, with a message in error. The patches are consumed.
vtkMTCertifiedMesh vtkMTRegionStep::Assemble(
  std::vector<vtkMTCertifiedMesh>& patches, const std::vector<vtkMTArrayInfo>& arrays, std::string& error)
{
  vtkMTCertifiedMesh floor;
  vtkMTAssembler assembler(arrays);
  for (vtkMTCertifiedMesh& patch : patches)
  {
    if (!assembler.Add(patch.Mesh))
    {
      error = assembler.GetError();
      return vtkMTCertifiedMesh();
    }
    floor.Deviations.insert(floor.Deviations.end(), patch.Deviations.begin(), patch.Deviations.end());
    floor.ValueDeviations.insert(
      floor.ValueDeviations.end(), patch.ValueDeviations.begin(), patch.ValueDeviations.end());
    patch = vtkMTCertifiedMesh();
  }
  floor.Mesh = assembler.TakeMesh();
  return floor;
}

bool vtkMTRegionStep::Run(std::vector<vtkMTCertifiedMesh>& floorPatches, const Context& context, std::string& error)
{
  vtkMTCertifiedMesh certifiedFloor = Assemble(floorPatches, *context.Arrays, error);
  const vtkMTPatch& floor = certifiedFloor.Mesh;
  if (floor.Triangles.empty())
  {
    error = error.empty() ? "the patches of a region have no triangles" : error;
    return false;
  }
  this->FloorTriangles = floor.Triangles.size();
  std::vector<unsigned char> locked(floor.Points.size());
  for (std::size_t p = 0; p < locked.size(); ++p)
  {
    locked[p] = IsLocked(*context.LockedIds, floor.Ids[p]) ? 1 : 0;
  }
  this->HasFullySharedBorder = HasBorderOfFinerRegions(floor, locked, context.FloorLevel);
  vtkMTSimplification simplification;
  const auto target =
    std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(floor.Triangles.size()) / context.Reduction));
  {
    const vtkMTStageTimes::Scope simplify(vtkMTStageTimes::Simplify);
    if (!context.Simplifier->Simplify(floor, locked, target, simplification, error))
    {
      return false;
    }
  }
  const vtkMTStageTimes::Scope certify(vtkMTStageTimes::Certify);
  this->Fragment.Mesh = MakeFragment(simplification, locked, floor);
  if (!this->Certify(certifiedFloor, simplification, context, error))
  {
    return false;
  }
  if (this->Fragment.Mesh.Triangles.size() > target)
  {
    this->Blocked = std::move(simplification.Blocked);
  }
  return true;
}

// Bounds the fragment's deviation, rounds its points, and gives it the floor's attributes, normals among them, whose
// deviation is bounded by what the distance's bound rests on. Rounding moves points and their normals alike.
bool vtkMTRegionStep::Certify(
  vtkMTCertifiedMesh& certifiedFloor, vtkMTSimplification& simplification, const Context& context, std::string& error)
{
  const vtkMTPatch& floor = certifiedFloor.Mesh;
  vtkMTPatch& mesh = this->Fragment.Mesh;
  const vtkMTDeviation::Relation relation{ std::move(simplification.Heirs), std::move(certifiedFloor.Deviations) };
  const bool certifiesValues = context.CertifiedArrays && !context.CertifiedArrays->empty();
  const vtkMTPoint origin = GetMiddle(floor);
  const vtkMTSurface floorSurface(floor, origin, vtkMTSurface::Planes::MadeWhenAsked);
  const vtkMTSurface fragmentSurface(mesh, origin);
  vtkMTDeviation::Findings findings;
  findings.KeepPairs = context.CertifyNormals || certifiesValues;
  this->Error = vtkMTDeviation::Between(floorSurface, fragmentSurface, relation, findings).UpperBound;
  if (context.LevelsBelow > 1 &&
    !this->ImproveByFinerLevel(
      { floorSurface, relation.FloorDeviations }, fragmentSurface, origin, context, findings.Deviations, error))
  {
    return false;
  }
  this->EdgeLength = mesh.GetMeanEdgeLength();
  this->RoundPoints(findings.Deviations);
  simplification.Points = mesh.Points;
  const std::vector<vtkMTArrayInfo>& arrays = *context.Arrays;
  vtkMTAttributeTransfer::Run({ floor, floorSurface, fragmentSurface, simplification, findings }, arrays, mesh);
  this->RenewNormals(context);
  if (context.CertifyNormals)
  {
    this->CertifyNormals(floor, floorSurface, fragmentSurface, relation, context, findings);
  }
  if (certifiesValues)
  {
    this->CertifyValues(certifiedFloor, floorSurface, fragmentSurface, context, findings.Pairs);
  }
  this->Fragment.Deviations = std::move(findings.Deviations);
  return true;
}

bool vtkMTRegionStep::ImproveByFinerLevel(const vtkMTDirectDeviation::Mesh& floor, const vtkMTSurface& fragment,
  const vtkMTPoint& origin, const Context& context, std::vector<vtkMTTriangleDeviation>& deviations, std::string& error)
{
  const auto collect = [&](const vtkMTDirectDeviation::Neighbourhood& near, std::size_t levelsBelow,
                         vtkMTDirectDeviation::FinerPart& part, std::string& why)
  { return context.CollectFiner(near, levelsBelow, origin, part, why); };
  const vtkMTDirectDeviation::Aim aim{ context.LevelsBelow,
    vtkMTDirectDeviation::GetLooseness(context.FloorLevel + 1, context.LevelsBelow) };
  if (!vtkMTDirectDeviation::Improve(floor, fragment, origin, aim, collect, deviations, error))
  {
    return false;
  }
  this->Error = 0.0;
  for (const vtkMTTriangleDeviation& deviation : deviations)
  {
    this->Error = std::max({ this->Error, double(deviation.ToInput), double(deviation.FromInput) });
  }
  return true;
}

// Normals that were made follow from the triangles on every level, except at points that other regions keep as well.
void vtkMTRegionStep::RenewNormals(const Context& context)
{
  std::size_t column = 0;
  for (const vtkMTArrayInfo& array : *context.Arrays)
  {
    if (vtkMTMadeNormals::AreIn(array))
    {
      vtkMTPointNormals::Renew(this->Fragment.Mesh, context.HasSmoothNormals, vtkMTMadeNormals::GetBits(array),
        this->Fragment.Mesh.PointColumns[column]);
    }
    column += array.Association == vtkMTArrayInfo::Point ? 1 : 0;
  }
}

void vtkMTRegionStep::CertifyNormals(const vtkMTPatch& floor, const vtkMTSurface& floorSurface,
  const vtkMTSurface& fragmentSurface, const vtkMTDeviation::Relation& relation, const Context& context,
  vtkMTDeviation::Findings& findings)
{
  const vtkMTShadingNormals shading(*context.Arrays);
  const std::vector<std::array<float, 3>> floorNormals = shading.Get(floor);
  const std::vector<std::array<float, 3>> normals = shading.Get(this->Fragment.Mesh);
  this->NormalDeviation = vtkMTNormalDeviation::Add(
    { floorSurface, floorNormals }, { fragmentSurface, normals }, { relation.FloorDeviations }, findings);
}

// Moving a point by rounding moves its value with it: the partners stay the same.
void vtkMTRegionStep::CertifyValues(const vtkMTCertifiedMesh& floor, const vtkMTSurface& floorSurface,
  const vtkMTSurface& fragmentSurface, const Context& context, const std::vector<vtkMTDeviation::Pair>& pairs)
{
  const std::size_t arrays = context.CertifiedArrays->size();
  const std::size_t triangles = this->Fragment.Mesh.Triangles.size();
  this->Fragment.ValueDeviations.resize(triangles * arrays);
  this->ValueDeviations.assign(arrays, 0.0);
  for (std::size_t a = 0; a < arrays; ++a)
  {
    std::vector<vtkMTValueDeviation> known;
    for (std::size_t i = a; i < floor.ValueDeviations.size(); i += arrays)
    {
      known.push_back(floor.ValueDeviations[i]);
    }
    const std::size_t array = (*context.CertifiedArrays)[a];
    const std::vector<vtkMTValueDeviation> found =
      vtkMTValueDeviation::Add({ floorSurface, vtkMTValueDeviation::Get(floor.Mesh, *context.Arrays, array) },
        { fragmentSurface, vtkMTValueDeviation::Get(this->Fragment.Mesh, *context.Arrays, array) }, known, pairs);
    for (std::size_t t = 0; t < triangles; ++t)
    {
      this->Fragment.ValueDeviations[t * arrays + a] = found[t];
      this->ValueDeviations[a] = std::max({ this->ValueDeviations[a], found[t].ToInput, found[t].FromInput });
    }
  }
}

void vtkMTRegionStep::RoundPoints(std::vector<vtkMTTriangleDeviation>& deviations)
{
  const double way =
    vtkMTCoarsePoints::Round(this->Fragment.Mesh, vtkMTCoarsePoints::ChooseShift(this->Error, this->EdgeLength));
  // A bound in double precision is a bound still after one more rounding up.
  const auto add = [](double sum) { return vtkMTRoundUp::GetNext(static_cast<float>(sum)); };
  for (std::size_t t = 0; t < deviations.size() && way > 0.0; ++t)
  {
    vtkMTTriangleDeviation& deviation = deviations[t];
    deviation.ToInput = add(deviation.ToInput + way);
    deviation.FromInput = add(deviation.FromInput + way);
    this->Error = std::max({ this->Error, double(deviation.ToInput), double(deviation.FromInput) });
  }
}
