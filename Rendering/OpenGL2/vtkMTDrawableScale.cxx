// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDrawableScale.h"

#include <algorithm>
#include <cmath>
#include <sstream>

std::string vtkMTDrawableScale::FindProblem(const double bounds[6])
{
  double largest = 0.0;
  double size = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    largest = std::max(largest, std::abs(bounds[i]));
    size = std::max(size, std::abs(bounds[i] - bounds[i - i % 2]));
  }
  std::ostringstream text;
  if (largest > LargestCoordinate)
  {
    text << "its coordinates are up to " << largest << ", and VTK draws none beyond " << LargestCoordinate
         << ", since its cameras' matrices are in single precision";
  }
  else if (size < LeastSize)
  {
    text << "it is " << size << " in size, and VTK draws nothing below " << LeastSize
         << ", since its cameras come no nearer than 1e-20";
  }
  return text.str();
}
