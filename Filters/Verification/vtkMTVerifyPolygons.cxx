// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyPolygons.h"

#include "vtkMTVector.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
// Clipping takes the square of the corners: larger polygons are left open.
constexpr std::size_t CornersLimit = 4000;

// What rounding may make of a flat triangle, as a share of its polygon.
constexpr double FlatShare = 1e-9;

double Length(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

template <class Corner>
double Turn(const Corner& a, const Corner& b, const Corner& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

template <class Corner>
bool IsSamePlace(const Corner& a, const Corner& b)
{
  return a.Place == b.Place;
}

template <class Corner>
bool IsBetween(const Corner& a, const Corner& b, const Corner& x)
{
  return (x.X - a.X) * (x.X - b.X) + (x.Y - a.Y) * (x.Y - b.Y) < 0.0;
}
}

bool vtkMTVerifyPolygons::IsEar(const std::vector<Corner>& corners, std::size_t index, bool isFlatAllowed)
{
  const std::size_t n = corners.size();
  const Corner& a = corners[(index + n - 1) % n];
  const Corner& b = corners[index];
  const Corner& c = corners[(index + 1) % n];
  const double turn = Turn(a, b, c);
  if (isFlatAllowed && turn == 0.0)
  {
    return true;
  }
  if (!(turn > 0.0))
  {
    return false;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Corner& x = corners[i];
    const Corner& y = corners[(i + 1) % n];
    const double side = Turn(c, a, x);
    if (!IsSamePlace(x, a) && !IsSamePlace(x, b) && !IsSamePlace(x, c))
    {
      const bool isInside = Turn(a, b, x) > 0.0 && Turn(b, c, x) > 0.0 && side > 0.0;
      if (isInside || (side == 0.0 && IsBetween(a, c, x)))
      {
        return false;
      }
    }
    const double otherSide = Turn(c, a, y);
    const bool isCrossing =
      ((side > 0.0 && otherSide < 0.0) || (side < 0.0 && otherSide > 0.0)) && Turn(x, y, a) * Turn(x, y, c) < 0.0;
    if (isCrossing)
    {
      return false;
    }
  }
  return true;
}

// Of the ears whose diagonal is wanted the one with the shortest; -1 when there is none.
int vtkMTVerifyPolygons::FindEar(const std::vector<Corner>& corners, const EdgeTest& isWanted, bool isFlatAllowed)
{
  const std::size_t n = corners.size();
  int best = -1;
  double shortest = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Corner& a = corners[(i + n - 1) % n];
    const Corner& c = corners[(i + 1) % n];
    const double length = Length(Subtract(a.Place, c.Place));
    if ((best < 0 || length < shortest) && (!isWanted || isWanted(a.Place, c.Place)) &&
      IsEar(corners, i, isFlatAllowed))
    {
      best = static_cast<int>(i);
      shortest = length;
      if (isWanted)
      {
        break; // the model's choice: any order of its ears gives the same triangles
      }
    }
  }
  return best;
}

bool vtkMTVerifyPolygons::Clip(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles, bool& isOfModel) const
{
  std::vector<Corner> corners = polygon.Corners;
  while (corners.size() > 3)
  {
    int ear = this->IsEdge ? FindEar(corners, this->IsEdge, false) : -1;
    isOfModel = isOfModel && ear >= 0;
    ear = ear < 0 ? FindEar(corners, nullptr, false) : ear;
    ear = ear < 0 ? FindEar(corners, nullptr, true) : ear;
    if (ear < 0)
    {
      return false;
    }
    const std::size_t n = corners.size();
    const auto i = static_cast<std::size_t>(ear);
    triangles.push_back({ corners[(i + n - 1) % n].Point, corners[i].Point, corners[(i + 1) % n].Point });
    corners.erase(corners.begin() + ear);
  }
  triangles.push_back({ corners[0].Point, corners[1].Point, corners[2].Point });
  return Turn(corners[0], corners[1], corners[2]) >= -FlatShare * polygon.Area;
}

void vtkMTVerifyPolygons::AddTriangle(
  const vtkMTTriangle& triangle, vtkIdType cell, double slack, vtkMTSampledSurface& surface)
{
  for (int i = 0; i < 3; ++i)
  {
    if (surface.Points[triangle[i]] == surface.Points[triangle[(i + 1) % 3]])
    {
      ++surface.Degenerate;
      return;
    }
  }
  surface.Triangles.push_back(triangle);
  surface.Cells.push_back(cell);
  surface.Slack.push_back(slack);
}

// Into the plane of the area vector.
vtkMTVerifyPolygons::Polygon vtkMTVerifyPolygons::Project(
  const std::vector<vtkIdType>& ids, const vtkMTSampledSurface& surface)
{
  const std::size_t n = ids.size();
  Polygon polygon;
  Vector area{ 0.0, 0.0, 0.0 };
  Vector middle{ 0.0, 0.0, 0.0 };
  const Vector& first = surface.Points[static_cast<std::size_t>(ids[0])];
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto id = static_cast<std::uint32_t>(ids[i]);
    polygon.Corners.push_back({ id, surface.Points[id], 0.0, 0.0 });
    const Vector a = Subtract(surface.Points[id], first);
    const Vector term = Cross(a, Subtract(surface.Points[static_cast<std::size_t>(ids[(i + 1) % n])], first));
    for (int axis = 0; axis < 3; ++axis)
    {
      area[axis] += 0.5 * term[axis];
      middle[axis] += a[axis] / static_cast<double>(n);
    }
  }
  polygon.Area = Length(area);
  const Vector normal{ area[0] / polygon.Area, area[1] / polygon.Area, area[2] / polygon.Area };
  const auto isSmaller = [&](double x, double y) { return std::abs(x) < std::abs(y); };
  Vector u{ 0.0, 0.0, 0.0 };
  u[static_cast<std::size_t>(std::min_element(normal.begin(), normal.end(), isSmaller) - normal.begin())] = 1.0;
  u = Cross(normal, u);
  const double length = Length(u);
  u = { u[0] / length, u[1] / length, u[2] / length };
  const Vector v = Cross(normal, u);
  for (Corner& corner : polygon.Corners)
  {
    const Vector a = Subtract(Subtract(corner.Place, first), middle);
    corner.X = Dot(a, u);
    corner.Y = Dot(a, v);
    polygon.Thickness = std::max(polygon.Thickness, 2.0 * std::abs(Dot(a, normal)));
    polygon.Reach = std::max(polygon.Reach, 2.0 * Length(a));
  }
  return polygon;
}

void vtkMTVerifyPolygons::AddPolygon(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface)
{
  const Polygon polygon = Project(ids, surface);
  std::vector<vtkMTTriangle> triangles;
  bool isOfModel = true;
  const bool isSimple = polygon.Area > 0.0 && ids.size() <= CornersLimit && this->Clip(polygon, triangles, isOfModel);
  if (!isSimple)
  {
    ++this->Crossing;
    triangles.clear();
    for (std::size_t i = 1; i + 1 < ids.size(); ++i)
    {
      triangles.push_back({ polygon.Corners[0].Point, polygon.Corners[i].Point, polygon.Corners[i + 1].Point });
    }
    this->OpenTriangles += static_cast<std::int64_t>(ids.size());
  }
  const double slack = isSimple ? (isOfModel ? 0.0 : polygon.Thickness) : polygon.Reach;
  const std::int64_t degenerate = surface.Degenerate;
  const std::size_t before = surface.Triangles.size();
  for (const vtkMTTriangle& triangle : triangles)
  {
    this->AddTriangle(triangle, cell, slack, surface);
  }
  this->OpenTriangles += surface.Degenerate - degenerate;
  double sum = 0.0;
  for (std::size_t t = before; slack > 0.0 && t < surface.Triangles.size(); ++t)
  {
    sum += surface.GetArea(t);
  }
  this->OpenArea += isSimple ? 2.0 * std::max(0.0, sum - polygon.Area) * (slack > 0.0 ? 1.0 : 0.0) : 2.0 * sum;
  this->OpenVolume += slack * sum;
}

void vtkMTVerifyPolygons::Split(vtkPolyData* mesh, vtkMTSampledSurface& surface)
{
  surface = vtkMTSampledSurface();
  surface.Points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, surface.Points[static_cast<std::size_t>(i)].data());
  }
  const auto add = [&](const std::vector<vtkIdType>& ids, vtkIdType cell)
  {
    const auto triangles = static_cast<std::int64_t>(ids.size()) - 2;
    const auto isNone = [&](vtkIdType id) { return id < 0 || id >= mesh->GetNumberOfPoints(); };
    const auto isInfinite = [&](vtkIdType id)
    {
      const Vector& x = surface.Points[static_cast<std::size_t>(id)];
      return !std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]);
    };
    if (triangles < 1)
    {
      return;
    }
    const bool isMissing = std::any_of(ids.begin(), ids.end(), isNone);
    if (isMissing || std::any_of(ids.begin(), ids.end(), isInfinite))
    {
      (isMissing ? surface.OutOfRange : surface.NonFinite) += triangles;
      this->OpenTriangles += triangles - 1; // of a polygon the builder may keep what lies beside the corner
    }
    else if (triangles > 1)
    {
      this->AddPolygon(ids, cell, surface);
    }
    else
    {
      this->AddTriangle(
        { static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2]) },
        cell, 0.0, surface);
    }
  };
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); ++i, ++cell)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    add(std::vector<vtkIdType>(ids->begin(), ids->end()), cell);
  }
  for (vtkIdType i = 0; i < mesh->GetStrips()->GetNumberOfCells(); ++i, ++cell)
  {
    mesh->GetStrips()->GetCellAtId(i, ids);
    for (vtkIdType j = 2; j < ids->GetNumberOfIds(); ++j)
    {
      const vtkIdType odd = j % 2;
      add({ ids->GetId(j - 2), ids->GetId(j - 1 + odd), ids->GetId(j - odd) }, cell);
    }
  }
}
