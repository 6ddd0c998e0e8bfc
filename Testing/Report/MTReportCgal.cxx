// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportCgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Triangles that repeat a place have no area, and nothing that the others lack but an edge: left out.
Mesh MakeMesh(const MTWorstPlace::Surface& surface)
{
  std::vector<Kernel::Point_3> points;
  for (const MTWorstPlace::Place& x : surface.Points)
  {
    points.emplace_back(x[0], x[1], x[2]);
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& t : surface.Triangles)
  {
    if (!CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
    {
      triangles.push_back({ t[0], t[1], t[2] });
    }
  }
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}
}

MTReportCgal::Distance MTReportCgal::GetSymmetricDistance(
  const MTWorstPlace::Surface& a, const MTWorstPlace::Surface& b, double bound)
{
  const double found = CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(
    MakeMesh(a), MakeMesh(b), bound);
  return { std::max(0.0, found - bound), found + bound };
}
