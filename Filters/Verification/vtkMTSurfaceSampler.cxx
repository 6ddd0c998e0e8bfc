// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSurfaceSampler.h"

#include <algorithm>
#include <cmath>

namespace
{
// Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014): the finaliser of SplitMix64.
std::uint64_t Mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// A uniform number in [0, 1) for each pair.
double Uniform(std::uint64_t seed, std::uint64_t index)
{
  return static_cast<double>(Mix(Mix(seed) + index) >> 11) * 0x1p-53;
}

vtkMTRealPoint PointInTriangle(
  const vtkMTSampledSurface& surface, std::uint32_t triangle, const std::array<double, 3>& weights)
{
  const vtkMTTriangle& t = surface.Triangles[triangle];
  vtkMTRealPoint x{ 0.0, 0.0, 0.0 };
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] += weights[corner] * surface.Points[t[corner]][axis];
    }
  }
  return x;
}
}

vtkMTSurfaceSampler::vtkMTSurfaceSampler(const vtkMTSampledSurface& surface, std::size_t count, std::uint64_t seed)
  : Surface(surface)
  , Areas(surface.Triangles.size() + 1, 0.0)
  , Count(count)
  , Seed(seed)
{
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    this->Areas[i + 1] = this->Areas[i] + surface.GetArea(i);
  }
  if (!(this->Areas.back() > 0.0))
  {
    this->Count = 0;
  }
}

vtkMTSurfaceSampler::Samples vtkMTSurfaceSampler::Take(std::size_t first, std::size_t last) const
{
  Samples samples;
  last = std::min(last, this->Count);
  for (std::size_t k = first; k < last; ++k)
  {
    const double at = (static_cast<double>(k) + Uniform(this->Seed, 3 * k)) / static_cast<double>(this->Count);
    // The triangle in whose share of the area the place falls; never one without area.
    const auto above = std::upper_bound(this->Areas.begin() + 1, this->Areas.end() - 1, at * this->Areas.back());
    const auto triangle = static_cast<std::uint32_t>(above - this->Areas.begin() - 1);
    const double root = std::sqrt(Uniform(this->Seed, 3 * k + 1));
    const double v = Uniform(this->Seed, 3 * k + 2);
    samples.Points.push_back(PointInTriangle(this->Surface, triangle, { 1.0 - root, root * (1.0 - v), root * v }));
    samples.Weights.push_back({ root * (1.0 - v), root * v });
    samples.Triangles.push_back(triangle);
  }
  return samples;
}
