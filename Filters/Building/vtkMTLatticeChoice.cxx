// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLatticeChoice.h"

#include "vtkMTBuildError.h"
#include "vtkMTLattice.h"
#include "vtkMTTriangleStream.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
// Of all points that are finite.
bool GetBounds(vtkMTTriangleStream& stream, std::array<double, 6>& bounds)
{
  constexpr double most = std::numeric_limits<double>::max();
  bounds = { most, -most, most, -most, most, -most };
  vtkMTTriangleStream::PointBlock block;
  bool good = stream.Rewind();
  while (good && (good = stream.NextPoints(block)) && !block.Points.empty())
  {
    for (const std::array<double, 3>& point : block.Points)
    {
      for (std::size_t i = 0; i < 3 && std::isfinite(point[0] + point[1] + point[2]); ++i)
      {
        bounds[2 * i] = std::min(bounds[2 * i], point[i]);
        bounds[2 * i + 1] = std::max(bounds[2 * i + 1], point[i]);
      }
    }
  }
  if (bounds[0] > bounds[1])
  {
    bounds = {};
  }
  return good;
}
}

bool vtkMTLatticeChoice::FindBits(vtkMTTriangleStream& input, double precision, int& bits, vtkMTBuildError& error)
{
  std::array<double, 6> bounds;
  if (!GetBounds(input, bounds))
  {
    return error.Fail(vtkErrorCode::FileFormatError, input.GetError());
  }
  for (bits = vtkMTLattice::MinimumBits; bits <= vtkMTLattice::MaximumBits; ++bits)
  {
    if (vtkMTLattice::FromBounds(bounds.data(), bits).MaximumShift <= precision)
    {
      return true;
    }
  }
  std::ostringstream message;
  message << "a precision of " << precision
          << " is finer than a lattice of 2^31 steps over this mesh resolves; the least is "
          << vtkMTLattice::FromBounds(bounds.data(), vtkMTLattice::MaximumBits).MaximumShift;
  return error.Fail(vtkMultiTriangulationFileBuilder::PrecisionError, message.str());
}
