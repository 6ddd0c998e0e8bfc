// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTView.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Several times the relative rounding error of a product of a matrix and a point.
constexpr double Rounding = 2e-15;

//------------------------------------------------------------------------------
// No coordinate that ToEye gives is farther than this from the exact one.
double GetRoundingOfToEye(const std::array<double, 16>& m, const std::array<double, 3>& x)
{
  double largest = 0.0;
  for (int row = 0; row < 3; ++row)
  {
    largest = std::max(largest,
      std::abs(m[4 * row] * x[0]) + std::abs(m[4 * row + 1] * x[1]) + std::abs(m[4 * row + 2] * x[2]) +
        std::abs(m[4 * row + 3]));
  }
  return Rounding * largest;
}

//------------------------------------------------------------------------------
// How far the point (eye space) lies outside each of the frustum's planes: left and right, bottom and top, near, far.
std::array<double, 6> GetDistancesOutside(const vtkMTView& view, const std::array<double, 3>& eye)
{
  const double depth = -eye[2];
  std::array<double, 6> outside;
  for (int i = 0; i < 2; ++i)
  {
    const double half = view.HalfSize[i];
    const double limit = view.ParallelProjection ? half : half * depth;
    const double scale = view.ParallelProjection ? 1.0 : 1.0 / std::sqrt(1.0 + half * half);
    outside[2 * i] = (-eye[i] - limit) * scale;
    outside[2 * i + 1] = (eye[i] - limit) * scale;
  }
  outside[4] = view.Near - depth;
  outside[5] = depth - view.Far;
  return outside;
}

//------------------------------------------------------------------------------
// Of a symmetric matrix, by Jacobi's rotations in cyclic order; each sweep squares what is left off the diagonal.
double GetLargestEigenvalue(double (&a)[3][3])
{
  constexpr int Sweeps = 12;
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int q = p + 1; q < 3; ++q)
      {
        if (a[p][q] == 0.0)
        {
          continue;
        }
        const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1.0 / std::hypot(t, 1.0);
        const double s = t * c;
        const int r = 3 - p - q;
        const double rp = a[r][p];
        const double rq = a[r][q];
        a[p][p] -= t * a[p][q];
        a[q][q] += t * a[p][q];
        a[p][q] = a[q][p] = 0.0;
        a[r][p] = a[p][r] = c * rp - s * rq;
        a[r][q] = a[q][r] = s * rp + c * rq;
      }
    }
  }
  return std::max({ a[0][0], a[1][1], a[2][2] });
}
}

//------------------------------------------------------------------------------
vtkMTView vtkMTView::FromProjection(const std::array<double, 16>& modelToEye, const double projection[16],
  const std::array<int, 2>& size, const double range[2])
{
  // A little more than what the planes say: the rasteriser rounds, and culling must not.
  constexpr double margin = 1e-6;
  vtkMTView view;
  view.ModelToEye = modelToEye;
  view.UpdateStretch();
  view.ParallelProjection = projection[15] != 0.0;
  view.PixelsPerUnit = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = std::abs(projection[5 * i]);
    const double shift = std::abs(projection[4 * i + (view.ParallelProjection ? 3 : 2)]);
    view.HalfSize[i] = (1.0 + shift) / scale;
    view.PixelsPerUnit = std::max(view.PixelsPerUnit, 0.5 * scale * size[i]);
  }
  view.Near = range[0] * (1.0 - margin);
  view.Far = range[1] * (1.0 + margin);
  return view;
}

//------------------------------------------------------------------------------
void vtkMTView::UpdateStretch()
{
  double largest = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    largest = i % 4 == 3 ? largest : std::max(largest, std::abs(this->ModelToEye[i]));
  }
  if (!(largest > 0.0))
  {
    this->Stretch = 0.0;
    return;
  }
  // The largest eigenvalue of A^T A, scaled so that squares neither overflow nor vanish.
  double gram[3][3] = {};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        gram[i][j] += (this->ModelToEye[4 * k + i] / largest) * (this->ModelToEye[4 * k + j] / largest);
      }
    }
  }
  this->Stretch = largest * std::sqrt(std::max(GetLargestEigenvalue(gram), 0.0)) * (1.0 + 1e-12);
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkMTView::ToEye(const std::array<double, 3>& x) const
{
  const std::array<double, 16>& m = this->ModelToEye;
  return { m[0] * x[0] + m[1] * x[1] + m[2] * x[2] + m[3], m[4] * x[0] + m[5] * x[1] + m[6] * x[2] + m[7],
    m[8] * x[0] + m[9] * x[1] + m[10] * x[2] + m[11] };
}

//------------------------------------------------------------------------------
double vtkMTView::GetPixelError(const std::array<double, 3>& center, double radius, double error) const
{
  if (!(error > 0.0))
  {
    return 0.0;
  }
  const double e = error * this->Stretch;
  if (this->ParallelProjection)
  {
    return e * this->PixelsPerUnit;
  }
  const std::array<double, 3> eye = this->ToEye(center);
  const double r = radius * this->Stretch + GetRoundingOfToEye(this->ModelToEye, center);
  const double nearest = std::max(this->Near, -eye[2] - r);
  if (!(nearest - e > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  // The cosine of the largest angle off the axis: the smaller one of the view's corner and of the sphere's far side,
  // which is the sum of its centre's angle and of half the angle under which it is seen.
  const double square = eye[0] * eye[0] + eye[1] * eye[1];
  const double distance = std::sqrt(square + eye[2] * eye[2]);
  double cosine = 1.0 / std::sqrt(1.0 + this->HalfSize[0] * this->HalfSize[0] + this->HalfSize[1] * this->HalfSize[1]);
  if (r < distance && eye[2] < 0.0)
  {
    const double across = r / distance;
    const double along = std::sqrt((1.0 - across) * (1.0 + across));
    cosine = std::max(cosine, (-eye[2] * along - std::sqrt(square) * across) / distance - Rounding);
  }
  return e * this->PixelsPerUnit / ((nearest - e) * cosine) * (1.0 + 4.0 * Rounding);
}

//------------------------------------------------------------------------------
bool vtkMTView::IsSphereVisible(const std::array<double, 3>& center, double radius) const
{
  const double r = (radius * this->Stretch) * (1.0 + Rounding) + GetRoundingOfToEye(this->ModelToEye, center);
  const std::array<double, 6> outside = GetDistancesOutside(*this, this->ToEye(center));
  return std::none_of(outside.begin(), outside.end(), [r](double distance) { return distance > r; });
}

//------------------------------------------------------------------------------
bool vtkMTView::IsBoxVisible(const double bounds[6]) const
{
  if (bounds[0] > bounds[1] || bounds[2] > bounds[3] || bounds[4] > bounds[5])
  {
    return false;
  }
  std::array<double, 6> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<double, 3> x{ bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)] };
    const std::array<double, 6> outside = GetDistancesOutside(*this, this->ToEye(x));
    const double rounding = GetRoundingOfToEye(this->ModelToEye, x);
    for (int i = 0; i < 6; ++i)
    {
      least[i] = std::min(least[i], outside[i] - rounding);
    }
  }
  return std::none_of(least.begin(), least.end(), [](double distance) { return distance > 0.0; });
}
