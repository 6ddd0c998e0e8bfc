// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPointNormals.h"

#include "vtkMTVector.h"

using namespace vtkMTVector;

namespace
{
Vector Difference(const vtkMTPoint& a, const vtkMTPoint& b)
{
  return { static_cast<double>(a[0]) - static_cast<double>(b[0]), static_cast<double>(a[1]) - static_cast<double>(b[1]),
    static_cast<double>(a[2]) - static_cast<double>(b[2]) };
}
}

bool vtkMTPointNormals::GetTerms(
  const vtkMTPatch& mesh, std::size_t triangle, std::array<std::array<double, 3>, 3>& terms)
{
  const vtkMTTriangle p = mesh.GetPointsOfTriangle(triangle);
  const std::array<const vtkMTPoint*, 3> x{ &mesh.Points[p[0]], &mesh.Points[p[1]], &mesh.Points[p[2]] };
  const Vector normal = Cross(Difference(*x[1], *x[0]), Difference(*x[2], *x[0]));
  const double twiceArea = Norm(normal);
  if (!(twiceArea > 0.0))
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    const Vector u = Difference(*x[(c + 1) % 3], *x[c]);
    const Vector v = Difference(*x[(c + 2) % 3], *x[c]);
    const double angle = std::atan2(twiceArea, Dot(u, v));
    terms[c] = Scale(normal, angle / twiceArea);
  }
  return true;
}

std::array<float, 3> vtkMTPointNormals::GetDirection(const std::array<double, 3>& sum)
{
  const double length = Norm(sum);
  const Vector unit = length > 0.0 ? Scale(sum, 1.0 / length) : Vector{ 0.0, 0.0, 1.0 };
  return { static_cast<float>(unit[0]), static_cast<float>(unit[1]), static_cast<float>(unit[2]) };
}

std::vector<std::array<float, 3>> vtkMTPointNormals::Compute(const vtkMTPatch& mesh)
{
  std::vector<Vector> sums(mesh.Points.size(), Vector{ 0.0, 0.0, 0.0 });
  std::array<Vector, 3> terms;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    const bool hasTerms = GetTerms(mesh, t, terms);
    for (std::size_t c = 0; hasTerms && c < 3; ++c)
    {
      sums[p[c]] = Add(sums[p[c]], terms[c]);
    }
  }
  std::vector<std::array<float, 3>> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    normals[i] = GetDirection(sums[i]);
  }
  return normals;
}
