// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLattice.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The smallest exponent of a positive double, subnormal ones included.
constexpr int SmallestExponent = -1074;

//------------------------------------------------------------------------------
// The least e with x <= 2^e.
int CeilLog2(double x)
{
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

//------------------------------------------------------------------------------
// The exponent of the distance between x and its neighbours in double precision.
int ResolutionLog2(double x)
{
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent - std::numeric_limits<double>::digits;
}

//------------------------------------------------------------------------------
bool IsUsable(const double bounds[6])
{
  for (int i = 0; i < 3; ++i)
  {
    if (!std::isfinite(bounds[2 * i]) || !std::isfinite(bounds[2 * i + 1]) || bounds[2 * i] > bounds[2 * i + 1])
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
vtkMTLattice vtkMTLattice::FromBounds(const double bounds[6], int bits)
{
  vtkMTLattice lattice;
  if (!IsUsable(bounds))
  {
    return lattice;
  }
  bits = std::clamp(bits, MinimumBits, MaximumBits);
  double halfSide = 0.0; // halves, because the side of a box may be beyond the largest double
  double farthest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    halfSide = std::max(halfSide, 0.5 * bounds[2 * i + 1] - 0.5 * bounds[2 * i]);
    farthest = std::max({ farthest, std::abs(bounds[2 * i]), std::abs(bounds[2 * i + 1]) });
  }
  int exponent = 0;
  if (farthest > 0.0)
  {
    exponent = std::max(ResolutionLog2(farthest), SmallestExponent);
    if (halfSide > 0.0)
    {
      exponent = std::max(exponent, CeilLog2(halfSide) + 1 - bits);
    }
  }
  lattice.Step = std::ldexp(1.0, exponent);
  for (int i = 0; i < 3; ++i)
  {
    // The origin is the middle, so that 2^31 steps fit into signed integers.
    const double middle = 0.5 * bounds[2 * i] + 0.5 * bounds[2 * i + 1];
    lattice.Origin[i] = static_cast<std::int64_t>(std::nearbyint(middle / lattice.Step));
  }
  lattice.MaximumShift = std::nextafter(0.5 * std::sqrt(3.0) * lattice.Step, std::numeric_limits<double>::infinity());
  return lattice;
}

//------------------------------------------------------------------------------
vtkMTPoint vtkMTLattice::Snap(const double x[3]) const
{
  constexpr double lowest = std::numeric_limits<std::int32_t>::min();
  constexpr double highest = std::numeric_limits<std::int32_t>::max();
  vtkMTPoint k;
  for (int i = 0; i < 3; ++i)
  {
    const double steps = std::nearbyint(x[i] / this->Step) - static_cast<double>(this->Origin[i]);
    // Written so that NaN gives the lowest value, which is defined behaviour.
    k[i] = static_cast<std::int32_t>(steps > lowest ? std::min(steps, highest) : lowest);
  }
  return k;
}

//------------------------------------------------------------------------------
void vtkMTLattice::ToWorld(const vtkMTBox& box, double bounds[6]) const
{
  if (box[0] > box[1] || box[2] > box[3] || box[4] > box[5])
  {
    vtkMath::UninitializeBounds(bounds);
    return;
  }
  const std::array<double, 3> low = this->ToWorld(vtkMTPoint{ box[0], box[2], box[4] });
  const std::array<double, 3> high = this->ToWorld(vtkMTPoint{ box[1], box[3], box[5] });
  for (int i = 0; i < 3; ++i)
  {
    bounds[2 * i] = low[i];
    bounds[2 * i + 1] = high[i];
  }
}
