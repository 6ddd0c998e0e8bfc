// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFarthestPlaces.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr double FirstStep = 0.5; // of the way to a corner
constexpr double LastStep = 4e-3;
constexpr int MostRounds = 64; // climbs end long before
constexpr std::uint32_t NoTriangle = vtkMTClosestPoint::NoTriangle;

// The farthest of each group.
vtkMTFarthestPlaces::Places Choose(
  const vtkMTFarthestPlaces::Places& places, const vtkMTFarthestPlaces::Group& group, std::size_t count)
{
  struct Entry
  {
    std::uint32_t Group;
    std::size_t Place;
  };
  std::vector<Entry> order;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].Triangle != NoTriangle && places[i].Nearest != NoTriangle)
    {
      order.push_back({ group(places[i]), i });
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&](const Entry& a, const Entry& b)
    { return a.Group != b.Group ? a.Group < b.Group : places[a.Place].Distance > places[b.Place].Distance; });
  std::size_t groups = order.empty() ? 0 : 1;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    groups += order[i].Group != order[i - 1].Group ? 1 : 0;
  }
  const std::size_t ofEach = std::max<std::size_t>(1, count / std::max<std::size_t>(1, groups));
  vtkMTFarthestPlaces::Places chosen;
  for (std::size_t i = 0, first = 0; i < order.size(); ++i)
  {
    first = order[i].Group == order[first].Group ? first : i;
    if (i - first < ofEach)
    {
      chosen.push_back(places[order[i].Place]);
    }
  }
  return chosen;
}
}

//------------------------------------------------------------------------------
bool vtkMTFarthestPlaces::Measure(const std::vector<vtkMTRealPoint>& points,
  const std::vector<std::uint32_t>& triangles, Places& places, const Progress& progress) const
{
  std::vector<double> distances;
  std::vector<std::uint32_t> nearest;
  if (!this->Other.Measure(points, distances, &nearest, progress))
  {
    return false;
  }
  places.clear();
  places.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    places.push_back({ points[i], triangles.empty() ? NoTriangle : triangles[i], distances[i], nearest[i] });
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFarthestPlaces::Climb(
  const Places& places, const Group& group, std::size_t count, Places& climbed, const Progress& progress) const
{
  climbed = Choose(places, group, count);
  std::vector<double> steps(climbed.size(), FirstStep);
  std::vector<std::size_t> climbing(climbed.size());
  std::iota(climbing.begin(), climbing.end(), std::size_t(0));
  for (int round = 0; round < MostRounds && !climbing.empty(); ++round)
  {
    const auto advance = [&](double share) { return progress((round + share) / MostRounds); };
    if (!this->Step(climbed, climbing, steps, advance))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// One step of all that climb still.
bool vtkMTFarthestPlaces::Step(
  Places& places, std::vector<std::size_t>& climbing, std::vector<double>& steps, const Progress& progress) const
{
  std::vector<vtkMTRealPoint> tried;
  tried.reserve(3 * climbing.size());
  for (const std::size_t i : climbing)
  {
    for (const std::uint32_t corner : this->Surface.Triangles[places[i].Triangle])
    {
      vtkMTRealPoint next = places[i].Point;
      for (int axis = 0; axis < 3; ++axis)
      {
        next[axis] += steps[i] * (this->Surface.Points[corner][axis] - next[axis]);
      }
      tried.push_back(next);
    }
  }
  std::vector<double> distances;
  std::vector<std::uint32_t> nearest;
  if (!this->Other.Measure(tried, distances, &nearest, progress))
  {
    return false;
  }
  std::size_t left = 0;
  for (std::size_t k = 0; k < climbing.size(); ++k)
  {
    const std::size_t i = climbing[k];
    const auto first = distances.begin() + static_cast<std::ptrdiff_t>(3 * k);
    const auto best = static_cast<std::size_t>(std::max_element(first, first + 3) - distances.begin());
    if (distances[best] > places[i].Distance)
    {
      places[i] = { tried[best], places[i].Triangle, distances[best], nearest[best] };
    }
    else
    {
      steps[i] *= 0.5;
    }
    if (steps[i] > LastStep)
    {
      climbing[left++] = i;
    }
  }
  climbing.resize(left);
  return true;
}
