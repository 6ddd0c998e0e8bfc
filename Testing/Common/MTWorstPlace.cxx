// SPDX-License-Identifier: BSD-3-Clause
#include "MTWorstPlace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace
{
using Place = MTWorstPlace::Place;
constexpr std::uint32_t LeafSize = 4;

template <class Real>
using Vector = std::array<Real, 3>;

template <class Real>
Real Dot(const Vector<Real>& a, const Vector<Real>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Vector<Real> Cross(const Vector<Real>& a, const Vector<Real>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <class Real>
Vector<Real> Minus(const Vector<Real>& a, const Vector<Real>& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

// Of the origin to the edge from a to b. Whatever the rounding of t, the place is one of the edge's.
template <class Real>
Real EdgeDistance2(const Vector<Real>& a, const Vector<Real>& b)
{
  const Vector<Real> along = Minus(b, a);
  const Real length2 = Dot(along, along);
  const Real t = length2 > 0 ? std::min(Real(1), std::max(Real(0), -Dot(a, along) / length2)) : Real(0);
  const Vector<Real> place = { a[0] + t * along[0], a[1] + t * along[1], a[2] + t * along[2] };
  return Dot(place, place);
}

// Of the origin: the edges, and the plane where the origin is over the interior.
template <class Real>
Real TriangleDistance2(const Vector<Real>& a, const Vector<Real>& b, const Vector<Real>& c)
{
  const Real edges = std::min({ EdgeDistance2(a, b), EdgeDistance2(b, c), EdgeDistance2(c, a) });
  const Vector<Real> normal = Cross(Minus(b, a), Minus(c, a));
  const Real normal2 = Dot(normal, normal);
  const auto isInside = [&normal](const Vector<Real>& p, const Vector<Real>& q)
  { return Dot(Cross(normal, Minus(q, p)), p) <= 0; };
  if (!(normal2 > 0) || !isInside(a, b) || !isInside(b, c) || !isInside(c, a))
  {
    return edges;
  }
  const Real height = Dot(normal, a);
  return std::min(edges, height * height / normal2);
}

double BoxDistance2(const Place& low, const Place& high, const Place& x)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double beyond = std::max({ low[i] - x[i], x[i] - high[i], 0.0 });
    sum += beyond * beyond;
  }
  return sum;
}

Place Mix(const MTWorstPlace::Surface& surface, std::size_t triangle, double u, double v)
{
  const auto& corners = surface.Triangles[triangle];
  Place x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = (1.0 - u - v) * surface.Points[corners[0]][i] + u * surface.Points[corners[1]][i] +
      v * surface.Points[corners[2]][i];
  }
  return x;
}
}

//------------------------------------------------------------------------------
MTWorstPlace::MTWorstPlace(const Surface& target)
  : Target(target)
  , Order(target.Triangles.size())
  , Centers(target.Triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  for (std::size_t t = 0; t < this->Centers.size(); ++t)
  {
    this->Centers[t] = Mix(this->Target, t, 1.0 / 3.0, 1.0 / 3.0);
  }
  if (!this->Order.empty())
  {
    this->Boxes.emplace_back();
    this->Split(0, 0, static_cast<std::uint32_t>(this->Order.size()));
  }
  this->Centers.clear();
}

//------------------------------------------------------------------------------
void MTWorstPlace::Split(std::uint32_t box, std::uint32_t first, std::uint32_t last)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Place low{ infinity, infinity, infinity };
  Place high{ -infinity, -infinity, -infinity };
  Place lowCenter = low;
  Place highCenter = high;
  for (std::uint32_t i = first; i < last; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const std::uint32_t p : this->Target.Triangles[this->Order[i]])
      {
        low[axis] = std::min(low[axis], this->Target.Points[p][axis]);
        high[axis] = std::max(high[axis], this->Target.Points[p][axis]);
      }
      lowCenter[axis] = std::min(lowCenter[axis], this->Centers[this->Order[i]][axis]);
      highCenter[axis] = std::max(highCenter[axis], this->Centers[this->Order[i]][axis]);
    }
  }
  this->Boxes[box].Low = low;
  this->Boxes[box].High = high;
  if (last - first <= LeafSize)
  {
    this->Boxes[box].First = first;
    this->Boxes[box].Count = last - first;
    return;
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = highCenter[i] - lowCenter[i] > highCenter[axis] - lowCenter[axis] ? i : axis;
  }
  const std::uint32_t middle = (first + last) / 2;
  std::nth_element(this->Order.begin() + first, this->Order.begin() + middle, this->Order.begin() + last,
    [this, axis](std::uint32_t a, std::uint32_t b)
    { return std::make_pair(this->Centers[a][axis], a) < std::make_pair(this->Centers[b][axis], b); });
  const auto child = static_cast<std::uint32_t>(this->Boxes.size());
  this->Boxes[box].First = child;
  this->Boxes.resize(this->Boxes.size() + 2);
  this->Split(child, first, middle);
  this->Split(child + 1, middle, last);
}

//------------------------------------------------------------------------------
template <class Real>
std::array<std::array<Real, 3>, 3> MTWorstPlace::GetCorners(std::uint32_t triangle, const Place& origin) const
{
  std::array<Vector<Real>, 3> corners;
  for (int c = 0; c < 3; ++c)
  {
    const Place& x = this->Target.Points[this->Target.Triangles[triangle][c]];
    corners[c] = { Real(x[0]) - Real(origin[0]), Real(x[1]) - Real(origin[1]), Real(x[2]) - Real(origin[2]) };
  }
  return corners;
}

//------------------------------------------------------------------------------
template <class Real>
Real MTWorstPlace::FindDistance2(const Place& place) const
{
  Real best = std::numeric_limits<Real>::infinity();
  std::array<std::pair<double, std::uint32_t>, 128> waiting;
  std::size_t count = 0;
  if (!this->Boxes.empty())
  {
    waiting[count++] = { 0.0, 0 };
  }
  // A box's distance is rounded; what it may be short by is of no consequence for a bound from below.
  while (count > 0)
  {
    const auto [distance2, index] = waiting[--count];
    const Box& box = this->Boxes[index];
    if (distance2 * (1.0 - 1e-12) > best)
    {
      continue;
    }
    for (std::uint32_t i = 0; i < box.Count; ++i)
    {
      const auto corners = this->GetCorners<Real>(this->Order[box.First + i], place);
      best = std::min(best, TriangleDistance2(corners[0], corners[1], corners[2]));
    }
    if (box.Count == 0)
    {
      const Box& left = this->Boxes[box.First];
      const Box& right = this->Boxes[box.First + 1];
      const std::pair<double, std::uint32_t> a{ BoxDistance2(left.Low, left.High, place), box.First };
      const std::pair<double, std::uint32_t> b{ BoxDistance2(right.Low, right.High, place), box.First + 1 };
      waiting[count++] = std::max(a, b);
      waiting[count++] = std::min(a, b);
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> MTWorstPlace::FindTriangles(const Place& place, double radius) const
{
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> waiting(this->Boxes.empty() ? 0 : 1, 0u);
  while (!waiting.empty())
  {
    const Box& box = this->Boxes[waiting.back()];
    waiting.pop_back();
    if (BoxDistance2(box.Low, box.High, place) > radius * radius)
    {
      continue;
    }
    for (std::uint32_t i = box.First; i < box.First + box.Count; ++i)
    {
      const auto corners = this->GetCorners<double>(this->Order[i], place);
      if (TriangleDistance2(corners[0], corners[1], corners[2]) <= radius * radius)
      {
        found.push_back(this->Order[i]);
      }
    }
    if (box.Count == 0)
    {
      waiting.push_back(box.First);
      waiting.push_back(box.First + 1);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
double MTWorstPlace::GetDistance(const Place& place) const
{
  return std::sqrt(this->FindDistance2<double>(place));
}

//------------------------------------------------------------------------------
double MTWorstPlace::GetPreciseDistance(const Place& place) const
{
  return static_cast<double>(std::sqrt(this->FindDistance2<long double>(place)));
}

//------------------------------------------------------------------------------
double MTWorstPlace::Climb(const Surface& from, std::size_t triangle) const
{
  // Begins where the best of a few places is; a step that leaves the triangle is taken to its border.
  double best = -1.0;
  double u = 1.0 / 3.0;
  double v = u;
  const auto attempt = [&](double newU, double newV)
  {
    newU = std::min(1.0, std::max(0.0, newU));
    newV = std::min(1.0 - newU, std::max(0.0, newV));
    const double distance = this->GetDistance(Mix(from, triangle, newU, newV));
    const bool isHigher = distance > best;
    if (isHigher)
    {
      best = distance;
      u = newU;
      v = newV;
    }
    return isHigher;
  };
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      attempt(0.25 * i, 0.25 * j);
    }
  }
  for (double step = 0.125; step > 1e-4;)
  {
    const double fromU = u;
    const double fromV = v;
    bool isHigher = false;
    for (const auto& [du, dv] : { std::pair<int, int>(1, 0), { -1, 0 }, { 0, 1 }, { 0, -1 }, { 1, -1 }, { -1, 1 } })
    {
      isHigher = attempt(fromU + step * du, fromV + step * dv) || isHigher;
    }
    step = isHigher ? step : 0.5 * step;
  }
  return this->GetPreciseDistance(Mix(from, triangle, u, v));
}

//------------------------------------------------------------------------------
std::vector<double> MTWorstPlace::Search(
  const Surface& from, std::size_t climbs, const std::vector<double>& allowed) const
{
  std::vector<double> atPoint(from.Points.size(), -1.0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> atEdge;
  std::vector<double> found(from.Triangles.size());
  for (std::size_t t = 0; t < found.size(); ++t)
  {
    found[t] = this->GetDistance(Mix(from, t, 1.0 / 3.0, 1.0 / 3.0));
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t p = from.Triangles[t][c];
      const std::uint32_t q = from.Triangles[t][(c + 1) % 3];
      atPoint[p] = atPoint[p] < 0.0 ? this->GetDistance(from.Points[p]) : atPoint[p];
      const auto edge = atEdge.insert({ std::minmax(p, q), 0.0 });
      if (edge.second)
      {
        const Place& x = from.Points[p];
        const Place& y = from.Points[q];
        edge.first->second =
          this->GetDistance({ x[0] + 0.5 * (y[0] - x[0]), x[1] + 0.5 * (y[1] - x[1]), x[2] + 0.5 * (y[2] - x[2]) });
      }
      found[t] = std::max({ found[t], atPoint[p], edge.first->second });
    }
  }
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  climbs = std::min(climbs, order.size());
  const auto getShare = [&](std::size_t t)
  { return allowed.empty() || allowed[t] <= 0.0 ? found[t] : found[t] / allowed[t]; };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(climbs), order.end(),
    [&](std::size_t a, std::size_t b) { return std::make_pair(getShare(b), a) < std::make_pair(getShare(a), b); });
  for (std::size_t i = 0; i < climbs; ++i)
  {
    found[order[i]] = std::max(found[order[i]], this->Climb(from, order[i]));
  }
  return found;
}
