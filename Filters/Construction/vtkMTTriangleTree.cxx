// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleTree.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <numeric>

using namespace vtkMTVector;

namespace
{
constexpr std::uint32_t LeafSize = 4;

void Include(std::array<double, 6>& box, const Vector& x)
{
  for (int i = 0; i < 3; ++i)
  {
    box[2 * i] = std::min(box[2 * i], x[i]);
    box[2 * i + 1] = std::max(box[2 * i + 1], x[i]);
  }
}

std::array<double, 6> EmptyBox()
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  return { inf, -inf, inf, -inf, inf, -inf };
}

int LongestSide(const std::array<double, 6>& box)
{
  const double side[3] = { box[1] - box[0], box[3] - box[2], box[5] - box[4] };
  const int yOrX = side[1] > side[0] ? 1 : 0;
  return side[2] > side[yOrX] ? 2 : yOrX;
}

double Distance2ToBox(const std::array<double, 6>& box, const Vector& x)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double outside = std::max({ box[2 * i] - x[i], x[i] - box[2 * i + 1], 0.0 });
    sum += outside * outside;
  }
  return sum;
}

// The nearest point of segment ab, as a parameter from 0 to 1.
double ProjectOnSegment(const Vector& x, const Vector& a, const Vector& b)
{
  const Vector ab = Subtract(b, a);
  const double length2 = Dot(ab, ab);
  return length2 > 0.0 ? std::clamp(Dot(Subtract(x, a), ab) / length2, 0.0, 1.0) : 0.0;
}

// Corners are integers, so the cross product is exact until it is rounded once, however thin the triangle.
Vector MakeNormal(const std::array<Vector, 3>& corners)
{
  using Integer = __int128;
  std::array<Integer, 3> u;
  std::array<Integer, 3> v;
  for (int i = 0; i < 3; ++i)
  {
    u[i] = static_cast<std::int64_t>(corners[1][i] - corners[0][i]);
    v[i] = static_cast<std::int64_t>(corners[2][i] - corners[0][i]);
  }
  const Vector normal{ static_cast<double>(u[1] * v[2] - u[2] * v[1]), static_cast<double>(u[2] * v[0] - u[0] * v[2]),
    static_cast<double>(u[0] * v[1] - u[1] * v[0]) };
  const double length = Norm(normal);
  return length > 0.0 ? Scale(normal, 1.0 / length) : Vector{ 0.0, 0.0, 0.0 };
}
}

vtkMTTriangleTree::vtkMTTriangleTree(const vtkMTPatch& mesh, const vtkMTPoint& origin)
{
  const std::size_t count = mesh.Triangles.size();
  this->Triangles.resize(count);
  std::vector<Vector> centroids(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
    auto& corners = this->Triangles[t].Corners;
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < 3; ++i)
      {
        corners[c][i] = static_cast<double>(mesh.Points[points[c]][i]) - static_cast<double>(origin[i]);
      }
    }
    this->Triangles[t].Normal = MakeNormal(corners);
    centroids[t] = Add(Add(corners[0], corners[1]), corners[2]); // three times the centroid orders as well
  }
  this->FindNeighbors(mesh);
  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->Nodes.reserve(count);
  if (count > 0)
  {
    this->Build(0, static_cast<std::uint32_t>(count), centroids);
  }
}

void vtkMTTriangleTree::FindNeighbors(const vtkMTPatch& mesh)
{
  struct Side
  {
    std::uint64_t Edge;
    std::uint32_t Index; // 3 triangle + edge
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.Triangles.size());
  for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const std::uint64_t a = p[e];
      const std::uint64_t b = p[(e + 1) % 3];
      sides.push_back({ (std::min(a, b) << 32) | std::max(a, b), 3 * t + e });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b) { return a.Edge != b.Edge ? a.Edge < b.Edge : a.Index < b.Index; });
  this->Neighbors.assign(sides.size(), None);
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].Edge == sides[i].Edge)
    {
      ++end;
    }
    if (end - i == 2)
    {
      this->Neighbors[sides[i].Index] = sides[i + 1].Index / 3;
      this->Neighbors[sides[i + 1].Index] = sides[i].Index / 3;
    }
    i = end;
  }
}

void vtkMTTriangleTree::Build(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids)
{
  const std::size_t self = this->Nodes.size();
  this->Nodes.push_back({ EmptyBox(), begin, end - begin });
  std::array<double, 6> box = EmptyBox();
  std::array<double, 6> centroidBox = EmptyBox();
  for (std::uint32_t i = begin; i < end; ++i)
  {
    for (const Vector& corner : this->Triangles[this->Order[i]].Corners)
    {
      Include(box, corner);
    }
    Include(centroidBox, centroids[this->Order[i]]);
  }
  this->Nodes[self].Box = box;
  if (end - begin <= LeafSize)
  {
    return;
  }
  const int axis = LongestSide(centroidBox);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle, this->Order.begin() + end,
    [&centroids, axis](std::uint32_t a, std::uint32_t b)
    { return centroids[a][axis] != centroids[b][axis] ? centroids[a][axis] < centroids[b][axis] : a < b; });
  this->Nodes[self].Count = 0;
  this->Build(begin, middle, centroids);
  this->Nodes[self].First = static_cast<std::uint32_t>(this->Nodes.size());
  this->Build(middle, end, centroids);
}

vtkMTTriangleTree::Hit vtkMTTriangleTree::Project(const Vector& x, std::uint32_t triangle) const
{
  const auto& [a, b, c] = this->Triangles[triangle].Corners;
  const Vector& n = this->Triangles[triangle].Normal;
  Hit hit;
  hit.Triangle = triangle;
  const Vector ax = Subtract(x, a);
  const Vector ab = Subtract(b, a);
  const Vector ac = Subtract(c, a);
  // Areas of the three triangles that x's projection makes with the edges, over that of the whole.
  const double area = Dot(Cross(ab, ac), n);
  const double v = Dot(Cross(ax, ac), n);
  const double w = Dot(Cross(ab, ax), n);
  const double u = area - v - w;
  if (area > 0.0 && u >= 0.0 && v >= 0.0 && w >= 0.0)
  {
    hit.Weights = { u / area, v / area, w / area };
    const double height = Dot(ax, n);
    hit.Place = Subtract(x, Scale(n, height));
    hit.Distance2 = height * height;
    return hit;
  }
  const std::array<const Vector*, 3> corners{ &a, &b, &c };
  for (int e = 0; e < 3; ++e)
  {
    const Vector& p = *corners[e];
    const Vector& q = *corners[(e + 1) % 3];
    const double t = ProjectOnSegment(x, p, q);
    const Vector place = Lerp(p, q, t);
    const Vector difference = Subtract(x, place);
    const double distance2 = Dot(difference, difference);
    if (distance2 < hit.Distance2)
    {
      hit.Distance2 = distance2;
      hit.Place = place;
      hit.Weights = { 0.0, 0.0, 0.0 };
      hit.Weights[e] = 1.0 - t;
      hit.Weights[(e + 1) % 3] = t;
    }
  }
  return hit;
}

double vtkMTTriangleTree::GetDistance2(const Vector& x, std::uint32_t triangle, double limit) const
{
  const Triangle& t = this->Triangles[triangle];
  const Vector ax = Subtract(x, t.Corners[0]);
  const double height = Dot(ax, t.Normal);
  if (height * height >= limit)
  {
    return std::numeric_limits<double>::infinity(); // the plane alone is too far
  }
  return this->Project(x, triangle).Distance2;
}

vtkMTTriangleTree::Hit vtkMTTriangleTree::Find(const Vector& x, const Vector* direction, std::uint32_t guess) const
{
  const auto isFacing = [this, direction](std::uint32_t triangle)
  { return !direction || Dot(this->Triangles[triangle].Normal, *direction) > 0.0; };
  double best2 = std::numeric_limits<double>::infinity();
  std::uint32_t best = None;
  if (guess != None && isFacing(guess))
  {
    best = guess;
    best2 = this->Project(x, guess).Distance2;
  }
  struct Entry
  {
    std::uint32_t Node;
    double Distance2;
  };
  std::array<Entry, 64> stack; // the tree is balanced: its depth is the logarithm of at most 2^32 triangles
  std::size_t size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = { 0, Distance2ToBox(this->Nodes[0].Box, x) };
  }
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (entry.Distance2 >= best2)
    {
      continue;
    }
    const Node& node = this->Nodes[entry.Node];
    for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
    {
      const std::uint32_t triangle = this->Order[i];
      const double distance2 =
        isFacing(triangle) ? this->GetDistance2(x, triangle, best2) : std::numeric_limits<double>::infinity();
      if (distance2 < best2)
      {
        best2 = distance2;
        best = triangle;
      }
    }
    if (node.Count > 0)
    {
      continue;
    }
    Entry near{ entry.Node + 1, Distance2ToBox(this->Nodes[entry.Node + 1].Box, x) };
    Entry far{ node.First, Distance2ToBox(this->Nodes[node.First].Box, x) };
    if (far.Distance2 < near.Distance2)
    {
      std::swap(near, far);
    }
    stack[size++] = far;
    stack[size++] = near;
  }
  return best == None ? Hit() : this->Project(x, best);
}
