// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArcRecord.h"

#include "vtkMTPatch.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <limits>
#include <vector>

using namespace vtkMTVector;

namespace
{
// The mean of the triangles' directions and the widest angle to it. A degenerate triangle has no direction and is never
// seen. Gives the mean edge length, as vtkMTPatch::GetMeanEdgeLength does.
double SetCone(const vtkMTPatch& patch, vtkMTArc& arc)
{
  // Of a product of two edges' coordinates, which are exact, and of their difference.
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  struct Normal
  {
    Vector Direction;
    double Slack; // how far rounding may have turned it: much for slivers
  };
  std::vector<Normal> normals;
  normals.reserve(patch.Triangles.size());
  Vector sum{ 0.0, 0.0, 0.0 };
  double edges = 0.0;
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    std::array<Vector, 3> x;
    for (int c = 0; c < 3; ++c)
    {
      const vtkMTPoint& k = patch.Points[p[c]];
      x[c] = { static_cast<double>(k[0]), static_cast<double>(k[1]), static_cast<double>(k[2]) };
    }
    const Vector u = Subtract(x[1], x[0]);
    const Vector v = Subtract(x[2], x[0]);
    const std::array<double, 3> sides{ Norm(u), Norm(Subtract(x[2], x[1])), Norm(v) };
    edges = edges + sides[0] + sides[1] + sides[2];
    const Vector normal = Cross(u, v);
    const double length = Norm(normal);
    if (length > 0.0)
    {
      normals.push_back({ Scale(normal, 1.0 / length), rounding * sides[0] * sides[2] / length });
      sum = Add(sum, normals.back().Direction);
    }
  }
  const double mean = patch.Triangles.empty() ? 0.0 : edges / (3.0 * static_cast<double>(patch.Triangles.size()));
  const double length = Norm(sum);
  if (!(length > 0.0))
  {
    return mean;
  }
  const Vector axis = Scale(sum, 1.0 / length);
  double cosine = 1.0;
  for (const Normal& normal : normals)
  {
    cosine = std::min(cosine, Dot(normal.Direction, axis) - normal.Slack);
  }
  if (!(cosine > 0.0))
  {
    return mean; // culls nothing
  }
  for (int i = 0; i < 3; ++i)
  {
    arc.ConeAxis[i] = static_cast<float>(axis[i]);
  }
  arc.ConeCosine = static_cast<float>(cosine - 1e-6); // covers the rounding of axis and cosine to single precision
  return mean;
}
}

vtkMTArc vtkMTMakeArcRecord(const vtkMTPatch& patch, double step)
{
  vtkMTArc arc;
  arc.Triangles = static_cast<std::uint32_t>(patch.Triangles.size());
  arc.Points = static_cast<std::uint32_t>(patch.Points.size());
  arc.Wedges = static_cast<std::uint32_t>(patch.GetNumberOfWedges());
  arc.SharedPoints = static_cast<std::uint32_t>(patch.Ids.size());
  arc.Box = patch.GetBox();
  arc.MeanEdgeLength =
    static_cast<float>(std::min(SetCone(patch, arc) * step, static_cast<double>(std::numeric_limits<float>::max())));
  return arc;
}
