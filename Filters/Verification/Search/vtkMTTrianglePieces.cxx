// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTrianglePieces.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double SizesPerThreshold = 4.0;
constexpr std::size_t MostPiecesPerTriangle = 3;

double GetDistance2(const vtkMTRealPoint& a, const vtkMTRealPoint& b)
{
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// The corner at which the longest edge begins.
int FindLongest(const vtkMTRealPoint (&p)[3], double& length2)
{
  const double lengths2[3] = { GetDistance2(p[0], p[1]), GetDistance2(p[1], p[2]), GetDistance2(p[2], p[0]) };
  const int longest = static_cast<int>(std::max_element(lengths2, lengths2 + 3) - lengths2);
  length2 = lengths2[longest];
  return longest;
}
}

vtkMTTrianglePieces::vtkMTTrianglePieces(const vtkMTSampledSurface& surface)
  : Surface(surface)
  , Axes(vtkMTPrincipalAxes::Best(surface))
  , Whole(surface.Triangles.size())
{
  const double longest = this->GetLongest();
  double threshold = SizesPerThreshold * this->GetMeanSize();
  // Surfaces without area have no size to go by.
  threshold = std::max(threshold, longest / static_cast<double>(1 << 20));
  if (!(threshold > 0.0) || threshold >= longest)
  {
    return;
  }
  while (this->CountDivisions(threshold) > (MostPiecesPerTriangle - 1) * this->Surface.Triangles.size())
  {
    threshold *= 2.0;
  }
  this->Divide(threshold);
}

double vtkMTTrianglePieces::GetMeanSize() const
{
  double sum = 0.0;
  for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    sum += std::sqrt(2.0 * this->Surface.GetArea(t));
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, this->Surface.Triangles.size()));
}

double vtkMTTrianglePieces::GetLongest() const
{
  double longest2 = 0.0;
  for (std::uint32_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    double length2 = 0.0;
    FindLongest(this->GetCorners(t).P, length2);
    longest2 = std::max(longest2, length2);
  }
  return std::sqrt(longest2);
}

template <typename Visitor>
void vtkMTTrianglePieces::VisitParts(const Corners& corners, double threshold2, Visitor&& visitor)
{
  std::vector<Corners> stack{ corners };
  while (!stack.empty())
  {
    const Corners c = stack.back();
    stack.pop_back();
    double length2 = 0.0;
    const int i = FindLongest(c.P, length2);
    if (!(length2 > threshold2))
    {
      if (!visitor(c))
      {
        return;
      }
      continue;
    }
    const vtkMTRealPoint& a = c.P[i];
    const vtkMTRealPoint& b = c.P[(i + 1) % 3];
    const vtkMTRealPoint& opposite = c.P[(i + 2) % 3];
    const vtkMTRealPoint middle = { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
    stack.push_back({ { middle, b, opposite } });
    stack.push_back({ { a, middle, opposite } });
  }
}

// How many pieces more than triangles; no farther than is too many.
std::size_t vtkMTTrianglePieces::CountDivisions(double threshold) const
{
  const std::size_t most = (MostPiecesPerTriangle - 1) * this->Surface.Triangles.size();
  std::size_t parts = 0;
  std::size_t triangles = 0;
  for (; triangles < this->Surface.Triangles.size() && parts <= most + triangles; ++triangles)
  {
    VisitParts(this->GetCorners(static_cast<std::uint32_t>(triangles)), threshold * threshold,
      [&](const Corners&) { return ++parts <= most + triangles + 1; });
  }
  return parts - triangles;
}

void vtkMTTrianglePieces::Divide(double threshold)
{
  const double threshold2 = threshold * threshold;
  this->IsDivided.assign(this->Surface.Triangles.size(), false);
  for (std::uint32_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    const Corners corners = this->GetCorners(t);
    double length2 = 0.0;
    FindLongest(corners.P, length2);
    if (!(length2 > threshold2))
    {
      continue;
    }
    this->IsDivided[t] = true;
    VisitParts(corners, threshold2,
      [&](const Corners& part)
      {
        this->Parts.push_back(part);
        this->PartOwners.push_back(t);
        return true;
      });
  }
}

std::vector<std::uint32_t> vtkMTTrianglePieces::List() const
{
  std::vector<std::uint32_t> pieces;
  pieces.reserve(this->Whole + this->Parts.size());
  for (std::uint32_t t = 0; t < this->Whole; ++t)
  {
    if (this->IsDivided.empty() || !this->IsDivided[t])
    {
      pieces.push_back(t);
    }
  }
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    pieces.push_back(static_cast<std::uint32_t>(this->Whole + i));
  }
  return pieces;
}

std::uint32_t vtkMTTrianglePieces::GetTriangle(std::uint32_t piece) const
{
  return piece < this->Whole ? piece : this->PartOwners[piece - this->Whole];
}

vtkMTTrianglePieces::Corners vtkMTTrianglePieces::GetCorners(std::uint32_t piece) const
{
  if (piece >= this->Whole)
  {
    return this->Parts[piece - this->Whole];
  }
  const vtkMTTriangle& t = this->Surface.Triangles[piece];
  return { { this->Axes.Apply(this->Surface.Points[t[0]]), this->Axes.Apply(this->Surface.Points[t[1]]),
    this->Axes.Apply(this->Surface.Points[t[2]]) } };
}

vtkMTRealBounds vtkMTTrianglePieces::GetBounds(std::uint32_t piece) const
{
  vtkMTRealBounds bounds;
  for (const vtkMTRealPoint& p : this->GetCorners(piece).P)
  {
    bounds.Add(p);
  }
  if (piece >= this->Whole || !this->Axes.IsNone())
  {
    // What is turned, and the middles of edges, are rounded: what lies between the boxes must not be missed.
    for (int axis = 0; axis < 3; ++axis)
    {
      const double most = std::max(std::abs(bounds.Minimum[axis]), std::abs(bounds.Maximum[axis]));
      bounds.Minimum[axis] -= 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, most);
      bounds.Maximum[axis] += 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, most);
    }
  }
  return bounds;
}

vtkMTRealPoint vtkMTTrianglePieces::GetBarycentre(std::uint32_t piece) const
{
  const Corners c = this->GetCorners(piece);
  return { c.P[0][0] + c.P[1][0] + c.P[2][0], c.P[0][1] + c.P[1][1] + c.P[2][1], c.P[0][2] + c.P[1][2] + c.P[2][2] };
}

bool vtkMTTrianglePieces::AreEqual(std::uint32_t a, std::uint32_t b) const
{
  const auto haveSameCorners = [this](std::uint32_t i, std::uint32_t j)
  {
    const Corners p = this->GetCorners(i);
    const Corners q = this->GetCorners(j);
    return std::equal(p.P, p.P + 3, q.P);
  };
  return haveSameCorners(a, b) && haveSameCorners(this->GetTriangle(a), this->GetTriangle(b));
}
