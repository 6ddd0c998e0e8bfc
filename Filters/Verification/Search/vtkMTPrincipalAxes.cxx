// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPrincipalAxes.h"

#include "vtkMath.h"

#include <cmath>
#include <cstddef>

vtkMTPrincipalAxes vtkMTPrincipalAxes::Best(const vtkMTSampledSurface& surface)
{
  double a[3][3] = {};
  for (const vtkMTTriangle& t : surface.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkMTRealPoint& p = surface.Points[t[i]];
      const vtkMTRealPoint& q = surface.Points[t[(i + 1) % 3]];
      for (int row = 0; row < 3; ++row)
      {
        for (int column = 0; column < 3; ++column)
        {
          a[row][column] += (p[row] - q[row]) * (p[column] - q[column]);
        }
      }
    }
  }
  double v[3][3];
  double lengths[3];
  double* rowsOfA[3] = { a[0], a[1], a[2] };
  double* rowsOfV[3] = { v[0], v[1], v[2] };
  vtkMTPrincipalAxes principal;
  if (vtkMath::Jacobi(rowsOfA, lengths, rowsOfV) == 0)
  {
    return principal;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    principal.Axes[axis] = { v[0][axis], v[1][axis], v[2][axis] };
  }
  principal.None = false;
  return principal.GetBoxSurface(surface) < vtkMTPrincipalAxes().GetBoxSurface(surface) ? principal
                                                                                        : vtkMTPrincipalAxes();
}

vtkMTRealPoint vtkMTPrincipalAxes::Apply(const vtkMTRealPoint& x) const
{
  if (this->None)
  {
    return x;
  }
  vtkMTRealPoint turned;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkMTRealPoint& e = this->Axes[axis];
    turned[axis] = e[0] * x[0] + e[1] * x[1] + e[2] * x[2];
  }
  return turned;
}

double vtkMTPrincipalAxes::GetBoxSurface(const vtkMTSampledSurface& surface) const
{
  double sum = 0.0;
  for (const vtkMTTriangle& t : surface.Triangles)
  {
    vtkMTRealBounds box;
    for (const std::uint32_t point : t)
    {
      box.Add(this->Apply(surface.Points[point]));
    }
    const double x = box.Maximum[0] - box.Minimum[0];
    const double y = box.Maximum[1] - box.Minimum[1];
    const double z = box.Maximum[2] - box.Minimum[2];
    sum += x * y + y * z + z * x;
  }
  return sum;
}
