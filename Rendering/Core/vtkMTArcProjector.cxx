// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArcProjector.h"

namespace
{
// Many times the relative rounding error of a sum of four products, one of which is itself such a sum.
constexpr double Rounding = 2e-14;

// No coordinate in steps is farther from 0.
constexpr double LargestCoordinate = 2147483648.0;

// A linear form of eye space as one of steps.
struct Form
{
  std::array<double, 4> Value{ 0, 0, 0, 0 };
  double Slack = 0.0;  // more than rounding changes its values by
  double Growth = 0.0; // sum of the absolute values of its slopes, per model unit

  Form(const std::array<double, 4>& eye, const vtkMTLattice& lattice, const vtkMTView& view)
  {
    double size = std::abs(eye[3]);
    this->Value[3] = eye[3];
    for (int j = 0; j < 4; ++j)
    {
      double slope = 0.0;
      double slopeSize = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double term = eye[k] * view.ModelToEye[4 * k + j];
        slope += term;
        slopeSize += std::abs(term);
      }
      const double origin = j < 3 ? lattice.Step * static_cast<double>(lattice.Origin[j]) : 1.0;
      this->Value[3] += slope * origin;
      size += slopeSize * (std::abs(origin) + (j < 3 ? lattice.Step * LargestCoordinate : 0.0));
      if (j < 3)
      {
        this->Value[j] = lattice.Step * slope;
        this->Growth += std::abs(slope);
      }
    }
    this->Slack = Rounding * size;
  }
};
}

vtkMTArcProjector::vtkMTArcProjector(const vtkMTLattice& lattice, const vtkMTView& view)
  : Step(lattice.Step)
  , Stretch(view.Stretch)
  , RadiusStretch(view.Stretch * lattice.Step)
  , Near(view.Near)
  , PixelsPerUnit(view.PixelsPerUnit)
  , CornerCosine(1.0 / std::sqrt(1.0 + view.HalfSize[0] * view.HalfSize[0] + view.HalfSize[1] * view.HalfSize[1]))
  , Parallel(view.ParallelProjection)
{
  // Left and right, bottom and top, near, far.
  const double x = view.HalfSize[0];
  const double y = view.HalfSize[1];
  const double slope = this->Parallel ? 0.0 : -1.0;
  const double constant = this->Parallel ? 1.0 : 0.0;
  const std::array<double, 4> planes[Planes] = { { 1, 0, slope * x, constant * x }, { -1, 0, slope * x, constant * x },
    { 0, 1, slope * y, constant * y }, { 0, -1, slope * y, constant * y }, { 0, 0, -1, -view.Near },
    { 0, 0, 1, view.Far } };
  for (int i = 0; i < Planes; ++i)
  {
    const Form form(planes[i], lattice, view);
    const double value = form.Value[3] + form.Slack;
    if (!(form.Growth > 0.0))
    {
      // Nothing that is drawn comes nearer to this plane.
      this->Constant[i] = value < 0.0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::max();
      continue;
    }
    this->Constant[i] = value / form.Growth;
    for (int j = 0; j < 3; ++j)
    {
      this->Slope[j][i] = form.Value[j] / form.Growth;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    std::array<double, 4> row{ 0, 0, 0, 0 };
    row[i] = 1.0;
    const Form form(row, lattice, view);
    std::copy(form.Value.begin(), form.Value.end(), this->ToEye.begin() + 4 * i);
    this->Slack = std::max(this->Slack, form.Slack);
  }
}

vtkMTArcProjector::Depth vtkMTArcProjector::GetDepth(const Box& box) const
{
  if (this->Parallel)
  {
    return { 0.0, 1.0 };
  }
  const std::array<double, 12>& m = this->ToEye;
  const std::array<double, 3>& c = box.Center;
  const double x = m[0] * c[0] + m[1] * c[1] + m[2] * c[2] + m[3];
  const double y = m[4] * c[0] + m[5] * c[1] + m[6] * c[2] + m[7];
  const double z = -(m[8] * c[0] + m[9] * c[1] + m[10] * c[2] + m[11]);
  const double r = box.GetRadius() * this->RadiusStretch + this->Slack;
  Depth depth{ std::max(this->Near, z - r), this->CornerCosine };
  // The largest angle off the axis is the smaller one of the view's corner and of the sphere's far side, which is the
  // sum of its centre's angle and of half the angle under which it is seen.
  const double square = x * x + y * y;
  const double distanceSquare = square + z * z;
  if (r * r < distanceSquare && z > 0.0)
  {
    const double along = std::sqrt((distanceSquare - r * r) / distanceSquare);
    const double cosine = (z * along - std::sqrt(square / distanceSquare) * r) / std::sqrt(distanceSquare);
    depth.Cosine = std::max(depth.Cosine, cosine - Rounding);
  }
  return depth;
}

double vtkMTArcProjector::GetPixelError(const Depth& depth, double error) const
{
  if (!(error > 0.0))
  {
    return 0.0;
  }
  const double e = error * this->Stretch;
  if (this->Parallel)
  {
    return e * this->PixelsPerUnit;
  }
  if (!(depth.Nearest - e > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  return e * this->PixelsPerUnit / ((depth.Nearest - e) * depth.Cosine) * (1.0 + Rounding);
}
