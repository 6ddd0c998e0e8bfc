// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRadiusScan.h"

#include "vtkMTBarycentreSample.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t NoSeed = std::numeric_limits<std::uint32_t>::max();

// Cube coordinates stay whole numbers in double: no overflow, whatever the radius is compared to the coordinates.
std::uint64_t Hash(const std::array<double, 3>& cube)
{
  std::uint64_t hash = 0;
  for (const double coordinate : cube)
  {
    // Adding 0 makes -0 and 0 the same.
    const double place = coordinate + 0.0;
    std::uint64_t bits;
    static_assert(sizeof(bits) == sizeof(place), "double has 64 bits");
    std::copy_n(reinterpret_cast<const unsigned char*>(&place), sizeof(bits), reinterpret_cast<unsigned char*>(&bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

double GetExtent(const std::vector<vtkMTRadiusScan::Point>& points)
{
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto bounds = std::minmax_element(
      points.begin(), points.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    extent = std::max(extent, (*bounds.second)[axis] - (*bounds.first)[axis]);
  }
  return extent;
}
}

vtkMTRadiusScan::vtkMTRadiusScan(double radius, int level)
  : Radius(radius)
  , Salt(vtkMTBarycentreSample::Hash(static_cast<std::uint64_t>(level)))
{
}

bool vtkMTRadiusScan::IsPassedOver()
{
  return vtkMTBarycentreSample::Hash(this->Salt ^ this->Added++) % 2 != 0;
}

bool vtkMTRadiusScan::HasSeedWithin(const Point& x, std::uint64_t cube) const
{
  const auto latest = this->Latest.find(cube);
  for (std::uint32_t i = latest == this->Latest.end() ? NoSeed : latest->second; i != NoSeed; i = this->Next[i])
  {
    const Point& seed = this->Seeds[i];
    const double dx = seed[0] - x[0];
    const double dy = seed[1] - x[1];
    const double dz = seed[2] - x[2];
    if (dx * dx + dy * dy + dz * dz <= this->Radius * this->Radius)
    {
      return true;
    }
  }
  return false;
}

void vtkMTRadiusScan::Add(const Point& x)
{
  if (this->IsPassedOver())
  {
    return;
  }
  std::array<double, 3> cube;
  std::array<double, 3> neighbour; // on the side of the cube to which the point is nearer
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = x[axis] / (2.0 * this->Radius);
    cube[axis] = std::floor(place);
    neighbour[axis] = place - cube[axis] < 0.5 ? cube[axis] - 1.0 : cube[axis] + 1.0;
  }
  const std::uint64_t home = Hash(cube);
  if (this->HasSeedWithin(x, home))
  {
    return;
  }
  for (int corner = 1; corner < 8; ++corner)
  {
    const std::array<double, 3> other = { (corner & 1) ? neighbour[0] : cube[0], (corner & 2) ? neighbour[1] : cube[1],
      (corner & 4) ? neighbour[2] : cube[2] };
    if (this->HasSeedWithin(x, Hash(other)))
    {
      return;
    }
  }
  const std::uint32_t index = static_cast<std::uint32_t>(this->Seeds.size());
  const auto place = this->Latest.try_emplace(home, NoSeed).first;
  this->Seeds.push_back(x);
  this->Next.push_back(place->second);
  place->second = index;
}

std::size_t vtkMTRadiusScan::CountSeeds(const std::vector<Point>& sample, double radius, int level, std::size_t enough)
{
  vtkMTRadiusScan scan(radius, level);
  for (const Point& point : sample)
  {
    scan.Add(point);
    if (scan.Seeds.size() > enough)
    {
      break;
    }
  }
  return scan.Seeds.size();
}

double vtkMTRadiusScan::FindRadius(const std::vector<Point>& sample, std::size_t wanted, int level)
{
  const double extent = GetExtent(sample);
  if (!(extent > 0.0))
  {
    return 1.0;
  }
  // On a surface the number of seeds goes with the inverse square of the radius: steps are equal in the logarithm.
  double low = std::log2(extent) - 40.0;
  double high = std::log2(extent) + 1.0;
  const std::size_t tolerance = wanted / 50;
  double middle = high;
  for (int step = 0; step < 40; ++step)
  {
    middle = 0.5 * (low + high);
    const std::size_t seeds = CountSeeds(sample, std::exp2(middle), level, wanted + tolerance);
    if (seeds + tolerance >= wanted && seeds <= wanted + tolerance)
    {
      break;
    }
    (seeds > wanted ? low : high) = middle;
  }
  return std::exp2(middle);
}

bool vtkMTRadiusScan::PlaceSeeds(
  vtkMTBarycentreScan& scan, const std::vector<Point>& sample, std::size_t wanted, int level, std::vector<Point>& seeds)
{
  vtkMTRadiusScan placement(FindRadius(sample, wanted, level), level);
  const bool ok = scan.Scan(
    [&placement](const Point* barycentres, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (vtkMTBarycentreSample::IsFinite(barycentres[i]))
        {
          placement.Add(barycentres[i]);
        }
      }
    });
  seeds = placement.Seeds;
  if (seeds.empty() && !sample.empty())
  {
    seeds.push_back(sample[0]); // all were passed over
  }
  return ok;
}
