// SPDX-License-Identifier: BSD-3-Clause
// vtkMTValidate: a patch or a mesh by itself.
#include "vtkMTValidate.h"

#include "vtkMTGraph.h"
#include "vtkMTValidateExpect.h"

#include <algorithm>
#include <cmath>

namespace
{
using Result = vtkMTValidate::Result;
using vtkMTValidateExpect::Expect;
using vtkMTValidateExpect::Text;

//------------------------------------------------------------------------------
// Which columns arrays of the finest level alone may have: in a patch of that level, in another one, in a mesh.
enum class Place
{
  Finest,
  Coarse,
  Anywhere
};

void CheckColumns(const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays, Place place,
  const std::string& name, Result& result)
{
  std::size_t next[2] = { 0, 0 };
  for (const vtkMTArrayInfo& array : arrays)
  {
    const bool cell = array.Association == vtkMTArrayInfo::Cell;
    const std::vector<vtkMTColumn>& columns = cell ? mesh.CellColumns : mesh.PointColumns;
    const std::size_t tuples = cell ? mesh.Triangles.size() : mesh.GetNumberOfWedges();
    const std::size_t index = next[cell]++;
    const std::size_t size = index < columns.size() ? columns[index].size() : 0;
    const bool mayBeEmpty =
      array.IsFinestOnly() && (place != Place::Finest || array.Role == vtkMTArrayInfo::ExactPoints);
    Expect(result, "patch",
      array.GetTupleSize() > 0 && ((mayBeEmpty && size == 0) || size == tuples * array.GetTupleSize()), name,
      ": the array ", array.Name, " has ", size, " bytes for ", tuples, " tuples of ", array.GetTupleSize());
    Expect(result, "patch", !array.IsFinestOnly() || place != Place::Coarse || size == 0, name, ": the array ",
      array.Name, ", which only the finest level has, has ", size, " bytes");
  }
  Expect(result, "patch", mesh.PointColumns.size() == next[0] && mesh.CellColumns.size() == next[1], name, " has ",
    mesh.PointColumns.size(), " point and ", mesh.CellColumns.size(), " cell arrays, the model ", next[0], " and ",
    next[1]);
}

//------------------------------------------------------------------------------
// Indices in range, no triangle with a repeated point. False when an index is out of range.
bool CheckTriangles(const vtkMTPatch& mesh, const std::string& name, Result& result)
{
  const std::size_t wedges = mesh.GetNumberOfWedges();
  bool ok = true;
  for (std::size_t w = 0; w < mesh.WedgePoints.size(); ++w)
  {
    ok = Expect(result, "patch", mesh.WedgePoints[w] < mesh.Points.size(), name, ": wedge ", w, " is of point ",
           mesh.WedgePoints[w], " of ", mesh.Points.size()) &&
      ok;
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle& triangle = mesh.Triangles[t];
    ok = Expect(result, "patch", triangle[0] < wedges && triangle[1] < wedges && triangle[2] < wedges, name,
           ": triangle ", t, " has a wedge that does not exist") &&
      ok;
  }
  for (std::size_t t = 0; ok && t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    Expect(result, "patch", p[0] != p[1] && p[1] != p[2] && p[2] != p[0], name, ": triangle ", t, " repeats a point");
  }
  return ok;
}

//------------------------------------------------------------------------------
void CheckIds(const vtkMTPatch& patch, const std::string& name, Result& result)
{
  Expect(result, "patch", patch.Ids.size() <= patch.Points.size(), name, " has more ids than points");
  std::vector<std::uint64_t> ids = patch.Ids;
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  Expect(result, "patch", twice == ids.end(), name, ": the id ", twice == ids.end() ? 0 : *twice, " occurs twice");
}

//------------------------------------------------------------------------------
void CheckRecord(const vtkMTArc& arc, const vtkMTPatch& patch, const std::string& name, Result& result)
{
  Expect(result, "patch",
    arc.Triangles == patch.Triangles.size() && arc.Points == patch.Points.size() &&
      arc.Wedges == patch.GetNumberOfWedges() && arc.SharedPoints == patch.Ids.size(),
    name, " has ", patch.Triangles.size(), " triangles, ", patch.Points.size(), " points, ", patch.GetNumberOfWedges(),
    " wedges, ", patch.Ids.size(), " shared points; its record says ", arc.Triangles, ", ", arc.Points, ", ",
    arc.Wedges, ", ", arc.SharedPoints);
  Expect(result, "patch", arc.Kind == patch.Kind, name, " is of another kind than its record says");
  Expect(result, "patch", arc.Kind != vtkMTPatchKind::Triangles || arc.Box == patch.GetBox(), name,
    ": the box of its record is not that of its triangles");
}

//------------------------------------------------------------------------------
// Every normal lies in the cone, as far as single precision tells.
void CheckCone(const vtkMTArc& arc, const vtkMTPatch& patch, const std::string& name, Result& result)
{
  constexpr double tolerance = 1e-5;
  for (std::size_t t = 0; arc.ConeCosine > 0.0f && t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    double u[3];
    double v[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = static_cast<double>(patch.Points[p[1]][i]) - patch.Points[p[0]][i];
      v[i] = static_cast<double>(patch.Points[p[2]][i]) - patch.Points[p[0]][i];
    }
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double dot = n[0] * arc.ConeAxis[0] + n[1] * arc.ConeAxis[1] + n[2] * arc.ConeAxis[2];
    Expect(result, "patch", dot >= (arc.ConeCosine - tolerance) * length, name, ": the normal of triangle ", t,
      " is outside the cone");
  }
}
}

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::Mesh(const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays)
{
  Result result;
  CheckTriangles(mesh, "mesh", result);
  CheckColumns(mesh, arrays, Place::Anywhere, "mesh", result);
  return result;
}

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::Patch(const vtkMTGraph& graph, std::uint32_t arc, const vtkMTPatch& patch)
{
  Result result;
  const std::string name = Text("patch ", arc);
  CheckIds(patch, name, result);
  CheckColumns(patch, graph.Arrays, graph.IsFinest(arc) ? Place::Finest : Place::Coarse, name, result);
  switch (graph.Arcs[arc].Kind)
  {
    case vtkMTPatchKind::Triangles:
      if (CheckTriangles(patch, name, result))
      {
        CheckRecord(graph.Arcs[arc], patch, name, result);
        CheckCone(graph.Arcs[arc], patch, name, result);
      }
      break;
    default: // what has no triangles has no normals either
      CheckRecord(graph.Arcs[arc], patch, name, result);
      break;
  }
  return result;
}
