// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCoarsePoints.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace vtkMTVector;

namespace
{
constexpr double LeastCosine = 0.9;
constexpr double MostSine2 = 0.18; // squared, of an angle whose cosine is above that

// The triangles around each point.
class Fans
{
public:
  explicit Fans(const vtkMTPatch& mesh)
    : First(mesh.Points.size() + 1, 0)
    , Triangles(3 * mesh.Triangles.size())
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (std::uint32_t p : mesh.GetPointsOfTriangle(t))
      {
        ++this->First[p + std::size_t(1)];
      }
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    std::vector<std::uint32_t> next(this->First.begin(), this->First.end() - 1);
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (std::uint32_t p : mesh.GetPointsOfTriangle(t))
      {
        this->Triangles[next[p]++] = t;
      }
    }
  }
  const std::uint32_t* Begin(std::uint32_t point) const { return this->Triangles.data() + this->First[point]; }
  const std::uint32_t* End(std::uint32_t point) const { return this->Triangles.data() + this->First[point + 1]; }

private:
  std::vector<std::uint32_t> First;
  std::vector<std::uint32_t> Triangles;
};

Vector Difference(const vtkMTPoint& a, const vtkMTPoint& b)
{
  return { static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1], static_cast<double>(a[2]) - b[2] };
}

// Of a triangle with one corner at a place and the other two in order.
Vector GetNormal(const vtkMTPoint& place, const vtkMTPoint& next, const vtkMTPoint& previous)
{
  return Cross(Difference(next, place), Difference(previous, place));
}

// Moving a corner adds the product of the way and the opposite edge to the normal; mostly that is too small to turn it.
bool MayMove(const vtkMTPatch& mesh, const Fans& fans, std::uint32_t point, const vtkMTPoint& place)
{
  const Vector way = Difference(place, mesh.Points[point]);
  const double way2 = Dot(way, way);
  return std::all_of(fans.Begin(point), fans.End(point),
    [&](std::uint32_t t)
    {
      const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
      const int c = points[0] == point ? 0 : (points[1] == point ? 1 : 2);
      const vtkMTPoint& next = mesh.Points[points[c == 2 ? 0 : c + 1]];
      const vtkMTPoint& previous = mesh.Points[points[c == 0 ? 2 : c - 1]];
      const Vector before = GetNormal(mesh.Points[point], next, previous);
      const Vector opposite = Difference(previous, next);
      if (way2 * Dot(opposite, opposite) < MostSine2 * Dot(before, before))
      {
        return true;
      }
      const Vector after = GetNormal(place, next, previous);
      return Dot(before, after) >= LeastCosine * Norm(before) * Norm(after) &&
        (Norm(after) > 0.0 || !(Norm(before) > 0.0));
    });
}

bool RoundPoint(const vtkMTPoint& from, unsigned shift, vtkMTPoint& to)
{
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t rounded =
      ((std::int64_t(from[i]) + (std::int64_t(1) << (shift - 1))) >> shift) * (std::int64_t(1) << shift);
    if (rounded > std::numeric_limits<std::int32_t>::max())
    {
      return false;
    }
    to[i] = static_cast<std::int32_t>(rounded);
  }
  return to != from;
}
}

unsigned vtkMTCoarsePoints::ChooseShift(double error, double edgeLength)
{
  // Rounding to multiples of m moves a point by sqrt(3)/2 m at most.
  const double way = std::min(ShareOfError * error, ShareOfEdgeLength * edgeLength) * 2.0 / std::sqrt(3.0);
  if (!(way >= 2.0))
  {
    return 0;
  }
  int exponent = 0;
  std::frexp(way, &exponent); // 2^(exponent - 1) <= way
  return std::min(static_cast<unsigned>(exponent - 1), MaximumShift);
}

double vtkMTCoarsePoints::Round(vtkMTPatch& fragment, unsigned shift)
{
  if (shift == 0)
  {
    return 0.0;
  }
  const Fans fans(fragment);
  double longest = 0.0;
  for (std::uint32_t p = static_cast<std::uint32_t>(fragment.Ids.size()); p < fragment.Points.size(); ++p)
  {
    vtkMTPoint place;
    if (RoundPoint(fragment.Points[p], shift, place) && MayMove(fragment, fans, p, place))
    {
      longest = std::max(longest, Norm(Difference(place, fragment.Points[p])));
      fragment.Points[p] = place;
    }
  }
  return longest;
}
