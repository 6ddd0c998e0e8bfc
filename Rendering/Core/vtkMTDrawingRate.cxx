// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDrawingRate.h"

#include <algorithm>
#include <cmath>

namespace
{
// A rate is not learnt from frames of so few triangles: they say what the window costs.
constexpr std::uint64_t FewTriangles = 1000;

// Four steps to the double, downwards.
double RoundDown(double x)
{
  return x > 1.0 ? std::exp2(std::floor(4.0 * std::log2(x)) / 4.0) : x;
}
}

void vtkMTDrawingRate::EndFrame(std::uint64_t triangles)
{
  if (triangles > FewTriangles && this->Seconds > 0.0)
  {
    const double rate = static_cast<double>(triangles) / this->Seconds;
    this->Measured = this->Measured > 0.0 ? 0.75 * this->Measured + 0.25 * rate : rate;
  }
  this->Seconds = 0.0;
}

std::uint64_t vtkMTDrawingRate::GetTriangles(double seconds, std::uint64_t all) const
{
  const double rate = this->GetRate();
  const double triangles = this->Given > 0.0 ? rate * seconds : RoundDown(rate * seconds);
  // More than there are is no limit, lest a rate that flickers ask for a new cut.
  const bool limits = rate > 0.0 && triangles < static_cast<double>(all);
  return limits ? std::max<std::uint64_t>(static_cast<std::uint64_t>(triangles), 1) : 0;
}
