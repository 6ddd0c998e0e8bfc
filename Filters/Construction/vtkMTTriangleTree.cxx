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
}

vtkMTTriangleTree::vtkMTTriangleTree(const vtkMTPatch& mesh, const vtkMTPoint& origin)
{
  const std::size_t count = mesh.Triangles.size();
  this->Corners.resize(count);
  this->Normals.resize(count);
  std::vector<Vector> centroids(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
    auto& corners = this->Corners[t];
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < 3; ++i)
      {
        corners[c][i] = static_cast<double>(mesh.Points[points[c]][i]) - static_cast<double>(origin[i]);
      }
    }
    this->Normals[t] = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
    centroids[t] = Add(Add(corners[0], corners[1]), corners[2]); // three times the centroid orders as well
  }
  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->Nodes.reserve(count);
  if (count > 0)
  {
    this->Build(0, static_cast<std::uint32_t>(count), centroids);
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
    for (const Vector& corner : this->Corners[this->Order[i]])
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
  const auto& [a, b, c] = this->Corners[triangle];
  const Vector& n = this->Normals[triangle];
  Hit hit;
  hit.Triangle = triangle;
  const double area2 = Dot(n, n);
  if (area2 > 0.0)
  {
    // Signed areas of the three triangles that x's projection makes with the edges.
    const Vector ax = Subtract(x, a);
    const double v = Dot(Cross(ax, Subtract(c, a)), n);
    const double w = Dot(Cross(Subtract(b, a), ax), n);
    const double u = area2 - v - w;
    if (u >= 0.0 && v >= 0.0 && w >= 0.0)
    {
      hit.Weights = { u / area2, v / area2, w / area2 };
      const double height = Dot(ax, n) / area2;
      hit.Place = Subtract(x, Scale(n, height));
      hit.Distance2 = height * height * area2;
      return hit;
    }
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

void vtkMTTriangleTree::FindInLeaf(const Node& leaf, const Vector& x, const Vector* direction, Hit& best) const
{
  for (std::uint32_t i = leaf.First; i < leaf.First + leaf.Count; ++i)
  {
    const std::uint32_t triangle = this->Order[i];
    if (direction && !(Dot(this->Normals[triangle], *direction) > 0.0))
    {
      continue;
    }
    const Hit hit = this->Project(x, triangle);
    if (hit.Distance2 < best.Distance2)
    {
      best = hit;
    }
  }
}

vtkMTTriangleTree::Hit vtkMTTriangleTree::Find(const Vector& x, const Vector* direction) const
{
  Hit best;
  if (this->Nodes.empty())
  {
    return best;
  }
  struct Entry
  {
    std::uint32_t Node;
    double Distance2;
  };
  std::array<Entry, 64> stack; // the tree is balanced: its depth is the logarithm of at most 2^32 triangles
  std::size_t size = 0;
  stack[size++] = { 0, Distance2ToBox(this->Nodes[0].Box, x) };
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (entry.Distance2 >= best.Distance2)
    {
      continue;
    }
    const Node& node = this->Nodes[entry.Node];
    if (node.Count > 0)
    {
      this->FindInLeaf(node, x, direction, best);
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
  return best;
}
