// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeasuringFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
vtkMTRealBounds::vtkMTRealBounds()
{
  this->Minimum.fill(std::numeric_limits<double>::infinity());
  this->Maximum.fill(-std::numeric_limits<double>::infinity());
}

void vtkMTRealBounds::Add(const vtkMTRealPoint& x)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Minimum[axis] = std::min(this->Minimum[axis], x[axis]);
    this->Maximum[axis] = std::max(this->Maximum[axis], x[axis]);
  }
}

void vtkMTRealBounds::Add(const vtkMTRealBounds& other)
{
  this->Add(other.Minimum);
  this->Add(other.Maximum);
}

double vtkMTRealBounds::GetDiagonal() const
{
  return this->IsEmpty() ? 0.0
                         : std::hypot(this->Maximum[0] - this->Minimum[0], this->Maximum[1] - this->Minimum[1],
                             this->Maximum[2] - this->Minimum[2]);
}

//------------------------------------------------------------------------------
vtkMTMeasuringFrame vtkMTMeasuringFrame::FromBounds(const vtkMTRealBounds& bounds)
{
  vtkMTMeasuringFrame frame;
  if (bounds.IsEmpty())
  {
    return frame;
  }
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.Center[axis] = 0.5 * bounds.Minimum[axis] + 0.5 * bounds.Maximum[axis];
    half = std::max(half, 0.5 * bounds.Maximum[axis] - 0.5 * bounds.Minimum[axis]);
  }
  if (half > 0.0)
  {
    // A power of two at least as large as half the longest side; clamped so that its inverse is finite.
    frame.Scale = std::ldexp(1.0, std::clamp(-(std::ilogb(half) + 1), -1020, 1020));
  }
  return frame;
}

vtkMTRealPoint vtkMTMeasuringFrame::ToLocal(const vtkMTRealPoint& x) const
{
  return { (x[0] - this->Center[0]) * this->Scale, (x[1] - this->Center[1]) * this->Scale,
    (x[2] - this->Center[2]) * this->Scale };
}

vtkMTRealPoint vtkMTMeasuringFrame::ToModelPoint(const vtkMTRealPoint& local) const
{
  return { local[0] / this->Scale + this->Center[0], local[1] / this->Scale + this->Center[1],
    local[2] / this->Scale + this->Center[2] };
}
