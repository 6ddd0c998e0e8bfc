// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleTree.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

using namespace vtkMTVector;

namespace
{
constexpr std::uint32_t LeafSize = 4;
constexpr std::uint64_t LeastEffort = 64; // of a query, when the tree is exhausted

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

}

void vtkMTTriangleTree::MakeRuns()
{
  std::vector<vtkMTBoxRuns::Box> boxes(this->Surface.GetNumberOfTriangles());
  for (std::uint32_t t = 0; t < boxes.size(); ++t)
  {
    boxes[t] = vtkMTBoxRuns::GetBox(this->Surface, t, 0.0);
  }
  this->Runs.emplace(std::move(boxes));
}

void vtkMTTriangleTree::LookAtRuns(Query& query) const
{
  if (this->Surface.GetNumberOfTriangles() > 0)
  {
    this->Look(query, this->Runs->FindNear(query.Place));
  }
  constexpr double less = 1.0 - 1e-12; // for rounding
  this->Runs->HasTouched(
    vtkMTBoxRuns::GetBox({ query.Place, std::sqrt(query.Best2) }),
    [&](const vtkMTBoxRuns::Box& box) { return less * vtkMTBoxRuns::GetDistance2(box, query.Place) < query.Best2; },
    [&](std::uint32_t t)
    {
      this->Look(query, t);
      return false;
    });
}

void vtkMTTriangleTree::Build()
{
  const std::size_t count = this->Surface.GetNumberOfTriangles();
  std::vector<Vector> centroids(count);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    // Three times the centroid orders as well.
    centroids[t] =
      Add(Add(this->Surface.GetCorner(t, 0), this->Surface.GetCorner(t, 1)), this->Surface.GetCorner(t, 2));
  }
  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->Nodes.reserve(count);
  if (count > 0)
  {
    this->BuildNode(0, static_cast<std::uint32_t>(count), centroids);
  }
}

void vtkMTTriangleTree::BuildNode(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids)
{
  const std::size_t self = this->Nodes.size();
  this->Nodes.push_back({ EmptyBox(), begin, end - begin });
  std::array<double, 6> box = EmptyBox();
  std::array<double, 6> centroidBox = EmptyBox();
  for (std::uint32_t i = begin; i < end; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      Include(box, this->Surface.GetCorner(this->Order[i], c));
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
  this->BuildNode(begin, middle, centroids);
  this->Nodes[self].First = static_cast<std::uint32_t>(this->Nodes.size());
  this->BuildNode(middle, end, centroids);
}

bool vtkMTTriangleTree::IsFacing(const Query& query, std::uint32_t triangle) const
{
  return !query.Direction || Dot(this->Surface.GetNormal(triangle), *query.Direction) > 0.0;
}

void vtkMTTriangleTree::Look(Query& query, std::uint32_t triangle) const
{
  if (!this->IsFacing(query, triangle))
  {
    return;
  }
  const double distance2 = this->Surface.GetDistance2(query.Place, triangle, query.Best2);
  if (distance2 < query.Best2)
  {
    query.Best2 = distance2;
    query.Best = triangle;
  }
}

vtkMTTriangleTree::Hit vtkMTTriangleTree::Find(Query query, std::uint32_t guess)
{
  if (guess != None)
  {
    this->Look(query, guess);
  }
  if (this->Queries < QueriesWithoutTree)
  {
    ++this->Queries;
    if (!this->Runs)
    {
      this->MakeRuns();
    }
    this->LookAtRuns(query);
  }
  else
  {
    if (this->Nodes.empty())
    {
      this->Build();
    }
    this->Traverse(query);
  }
  return query.Best == None ? Hit() : this->Surface.Project(query.Place, query.Best);
}

void vtkMTTriangleTree::Traverse(Query& query)
{
  struct Entry
  {
    std::uint32_t Node;
    double Distance2;
  };
  std::array<Entry, 64> stack; // the tree is balanced: its depth is the logarithm of at most 2^32 triangles
  std::size_t size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = { 0, Distance2ToBox(this->Nodes[0].Box, query.Place) };
  }
  const std::uint64_t before = this->Effort;
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (entry.Distance2 >= query.Best2)
    {
      continue;
    }
    if (this->IsExhausted() && query.Best != None && this->Effort >= before + LeastEffort)
    {
      return;
    }
    const Node& node = this->Nodes[entry.Node];
    this->Effort += 1 + node.Count;
    for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
    {
      this->Look(query, this->Order[i]);
    }
    if (node.Count > 0)
    {
      continue;
    }
    Entry near{ entry.Node + 1, Distance2ToBox(this->Nodes[entry.Node + 1].Box, query.Place) };
    Entry far{ node.First, Distance2ToBox(this->Nodes[node.First].Box, query.Place) };
    if (far.Distance2 < near.Distance2)
    {
      std::swap(near, far);
    }
    stack[size++] = far;
    stack[size++] = near;
  }
}
