// SPDX-License-Identifier: BSD-3-Clause
#include "bmtTurn.h"

#include "vtkMath.h"

#include <cmath>
#include <cstddef>

bmtTurn bmtTurn::Best(const bmtSurface& surface)
{
  double a[3][3] = {};
  for (const bmtTriangle& t : surface.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const bmtPoint& p = surface.Points[t[i]];
      const bmtPoint& q = surface.Points[t[(i + 1) % 3]];
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
  bmtTurn turn;
  if (vtkMath::Jacobi(rowsOfA, lengths, rowsOfV) == 0)
  {
    return turn;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    turn.Axes[axis] = { v[0][axis], v[1][axis], v[2][axis] };
  }
  turn.None = false;
  return turn.GetBoxSurface(surface) < bmtTurn().GetBoxSurface(surface) ? turn : bmtTurn();
}

bmtPoint bmtTurn::Apply(const bmtPoint& x) const
{
  if (this->None)
  {
    return x;
  }
  bmtPoint turned;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bmtPoint& e = this->Axes[axis];
    turned[axis] = e[0] * x[0] + e[1] * x[1] + e[2] * x[2];
  }
  return turned;
}

double bmtTurn::GetBoxSurface(const bmtSurface& surface) const
{
  double sum = 0.0;
  for (const bmtTriangle& t : surface.Triangles)
  {
    bmtBounds box;
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
