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

// How often the clipping begins anew where the model's triangles lead nowhere.
constexpr std::size_t StartsLimit = 8;

// What rounding may make of a flat triangle, as a share of its polygon.
constexpr double FlatShare = 1e-9;

// The same for all copies of a triangle in one turn.
std::uint64_t GetKey(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector* corners[3] = { &a, &b, &c };
  std::rotate(corners, std::min_element(corners, corners + 3, [](const Vector* x, const Vector* y) { return *x < *y; }),
    corners + 3);
  std::uint64_t key = 0;
  for (const Vector* corner : corners)
  {
    for (double x : *corner)
    {
      key = (key + std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
      key ^= key >> 29;
    }
  }
  return key;
}

}

// The first ear from the start on that is a triangle of the model, a flat one when there is no other; -1 when there is
// none.
int vtkMTVerifyPolygons::FindEarOfModel(const std::vector<Corner>& corners, std::size_t start, Choice choice) const
{
  const std::size_t n = corners.size();
  for (const bool isFlatAllowed : { false, true })
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      const std::size_t i = (start + k) % n;
      if (this->IsOfModel(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n], choice) &&
        vtkMTVerifyEars::IsEar(corners, i, isFlatAllowed))
      {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

// A model has no triangle with two corners at one place, though the polygon may have such corners.
bool vtkMTVerifyPolygons::IsOfModel(const Corner& a, const Corner& b, const Corner& c, Choice choice) const
{
  const auto isThere = [&](const vtkMTRealPoint& x, const vtkMTRealPoint& y, const vtkMTRealPoint& z)
  {
    const std::size_t copies = this->CountTriangles(x, y, z);
    return copies > 0 && (!choice.IsUnusedOnly || copies > this->GetUses(x, y, z));
  };
  return vtkMTVerifyEars::IsSamePlace(a, b) || vtkMTVerifyEars::IsSamePlace(b, c) ||
    vtkMTVerifyEars::IsSamePlace(c, a) || isThere(a.Place, b.Place, c.Place) ||
    (choice.IsTurnedAllowed && isThere(a.Place, c.Place, b.Place));
}

std::size_t vtkMTVerifyPolygons::GetUses(
  const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const
{
  const auto found = this->Uses.find(GetKey(a, b, c));
  return found == this->Uses.end() ? 0 : found->second;
}

// The face has these triangles of the model: they are no other one's.
void vtkMTVerifyPolygons::Use(const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c)
{
  const bool isTurned =
    this->CountTriangles(a, b, c) <= this->GetUses(a, b, c) && this->CountTriangles(a, c, b) > this->GetUses(a, c, b);
  ++this->Uses[isTurned ? GetKey(a, c, b) : GetKey(a, b, c)];
}

// Any order of the ears of one triangulation gives its triangles. Where several polygons lie on each other, ears of
// several triangulations may be mixed until nothing fits; another start mixes them otherwise.
bool vtkMTVerifyPolygons::ClipAsModel(
  const Polygon& polygon, std::size_t start, Choice choice, std::vector<vtkMTTriangle>& triangles) const
{
  std::vector<Corner> corners = polygon.Corners;
  triangles.clear();
  while (corners.size() > 3)
  {
    const int ear = this->FindEarOfModel(corners, start, choice);
    if (ear < 0)
    {
      return false;
    }
    vtkMTVerifyEars::Cut(corners, static_cast<std::size_t>(ear), triangles);
    start = static_cast<std::size_t>(ear);
  }
  triangles.push_back({ corners[0].Point, corners[1].Point, corners[2].Point });
  return this->IsOfModel(corners[0], corners[1], corners[2], choice) &&
    vtkMTVerifyEars::GetTurn(corners[0], corners[1], corners[2]) >= -FlatShare * polygon.Area;
}

// Whether the model has all triangles of another split of the polygon too. Then another face lies there.
bool vtkMTVerifyPolygons::HasOtherSplit(const Polygon& polygon, std::vector<vtkMTTriangle> triangles) const
{
  const auto sort = [](vtkMTTriangle triangle)
  {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  };
  std::transform(triangles.begin(), triangles.end(), triangles.begin(), sort);
  std::sort(triangles.begin(), triangles.end());
  const std::vector<Corner>& corners = polygon.Corners;
  const std::size_t n = corners.size();
  std::size_t starts = 0;
  std::vector<vtkMTTriangle> other;
  for (std::size_t i = 0; i < n && starts < StartsLimit; ++i)
  {
    const Corner& a = corners[(i + n - 1) % n];
    const Corner& c = corners[(i + 1) % n];
    const vtkMTTriangle ear = sort({ a.Point, corners[i].Point, c.Point });
    if (!std::binary_search(triangles.begin(), triangles.end(), ear) && this->IsOfModel(a, corners[i], c, Choice()) &&
      vtkMTVerifyEars::IsEar(corners, i, false))
    {
      ++starts;
      if (this->ClipAsModel(polygon, i, Choice(), other))
      {
        return true;
      }
    }
  }
  return false;
}

bool vtkMTVerifyPolygons::ClipAsModel(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles) const
{
  const Choice choices[] = { { true, false }, { true, true }, { false, false }, { false, true } };
  for (const Choice& choice : choices)
  {
    for (std::size_t start = 0; start < std::min(polygon.Corners.size(), StartsLimit); ++start)
    {
      if (this->ClipAsModel(polygon, start, choice, triangles))
      {
        return true;
      }
    }
  }
  return false;
}

bool vtkMTVerifyPolygons::Clip(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles, bool& isOfModel) const
{
  isOfModel = this->CountTriangles && this->ClipAsModel(polygon, triangles);
  if (isOfModel)
  {
    return true;
  }
  std::vector<Corner> corners = polygon.Corners;
  triangles.clear();
  std::size_t start = 0;
  while (corners.size() > 3)
  {
    int ear = this->CountTriangles ? this->FindEarOfModel(corners, start, { false, true }) : -1;
    ear = ear < 0 ? vtkMTVerifyEars::FindShortestEar(corners, false) : ear;
    ear = ear < 0 ? vtkMTVerifyEars::FindShortestEar(corners, true) : ear;
    if (ear < 0)
    {
      return false;
    }
    start = static_cast<std::size_t>(ear);
    vtkMTVerifyEars::Cut(corners, start, triangles);
  }
  triangles.push_back({ corners[0].Point, corners[1].Point, corners[2].Point });
  return vtkMTVerifyEars::GetTurn(corners[0], corners[1], corners[2]) >= -FlatShare * polygon.Area;
}

void vtkMTVerifyPolygons::AddTriangle(
  const vtkMTTriangle& triangle, vtkIdType cell, double slack, bool isMixed, vtkMTSampledSurface& surface)
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
  surface.Mixed.push_back(isMixed ? 1 : 0);
}

void vtkMTVerifyPolygons::AddPolygon(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface)
{
  const Polygon polygon = vtkMTVerifyEars::Project(ids, surface);
  std::vector<vtkMTTriangle> triangles;
  bool isOfModel = false;
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
  const bool isMixed = isOfModel && this->HasOtherSplit(polygon, triangles);
  const std::int64_t degenerate = surface.Degenerate;
  const std::size_t before = surface.Triangles.size();
  for (const vtkMTTriangle& triangle : triangles)
  {
    this->AddTriangle(triangle, cell, slack, isMixed, surface);
    if (isOfModel)
    {
      this->Use(surface.Points[triangle[0]], surface.Points[triangle[1]], surface.Points[triangle[2]]);
    }
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

template <class Add>
void vtkMTVerifyPolygons::VisitFaces(vtkPolyData* mesh, const Add& add)
{
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

void vtkMTVerifyPolygons::AddFace(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface)
{
  const auto triangles = static_cast<std::int64_t>(ids.size()) - 2;
  const auto count = static_cast<vtkIdType>(surface.Points.size());
  const auto isNone = [&](vtkIdType id) { return id < 0 || id >= count; };
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
      cell, 0.0, false, surface);
  }
}

void vtkMTVerifyPolygons::Split(vtkPolyData* mesh, vtkMTSampledSurface& surface)
{
  surface = vtkMTSampledSurface();
  surface.Points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, surface.Points[static_cast<std::size_t>(i)].data());
  }
  bool hasPolygons = false;
  VisitFaces(mesh, [&](const std::vector<vtkIdType>& ids, vtkIdType) { hasPolygons = hasPolygons || ids.size() > 3; });
  if (this->CountTriangles && hasPolygons) // what is a triangle already has no choice, so it goes first
  {
    VisitFaces(mesh,
      [&](const std::vector<vtkIdType>& ids, vtkIdType)
      {
        const auto isThere = [&](vtkIdType id) { return id >= 0 && id < mesh->GetNumberOfPoints(); };
        if (ids.size() == 3 && std::all_of(ids.begin(), ids.end(), isThere))
        {
          const std::vector<Vector>& x = surface.Points;
          this->Use(x[static_cast<std::size_t>(ids[0])], x[static_cast<std::size_t>(ids[1])],
            x[static_cast<std::size_t>(ids[2])]);
        }
      });
  }
  VisitFaces(mesh, [&](const std::vector<vtkIdType>& ids, vtkIdType cell) { this->AddFace(ids, cell, surface); });
}
