// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTKdRegions.h"

#include "vtkMTBarycentreSample.h"
#include "vtkMTRelease.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTKdRegions::vtkMTKdRegions(std::size_t capacity, double lowerShare)
  : Capacity(std::max<std::size_t>(capacity, 1))
  , LowerShare(lowerShare)
  , Nodes(1)
  , Contents(1)
{
  this->Contents[0].Capacity = this->Capacity;
}

vtkMTKdRegions::~vtkMTKdRegions() = default;

//------------------------------------------------------------------------------
void vtkMTKdRegions::Box::Add(const Point& x)
{
  if (this->Count++ == 0)
  {
    this->Lo = this->Hi = x;
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Lo[axis] = std::min(this->Lo[axis], x[axis]);
    this->Hi[axis] = std::max(this->Hi[axis], x[axis]);
  }
}

std::size_t vtkMTKdRegions::Box::GetLongestAxis() const
{
  const Point sides{ this->Hi[0] - this->Lo[0], this->Hi[1] - this->Lo[1], this->Hi[2] - this->Lo[2] };
  return static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTKdRegions::FindLeaf(const Point& x) const
{
  std::uint32_t node = 0;
  while (this->Nodes[node].Axis != Leaf)
  {
    const Node& parent = this->Nodes[node];
    node = parent.Index + (x[parent.Axis] < parent.Plane ? 0 : 1);
  }
  return node;
}

std::uint32_t vtkMTKdRegions::Locate(const Point& x) const
{
  return vtkMTBarycentreSample::IsFinite(x) ? this->Nodes[this->FindLeaf(x)].Index : 0;
}

//------------------------------------------------------------------------------
void vtkMTKdRegions::Insert(const Point& x)
{
  const std::uint32_t leaf = this->FindLeaf(x);
  Points& points = this->Contents[this->Nodes[leaf].Index];
  points.All.push_back(x);
  if (points.All.size() > points.Capacity)
  {
    this->DividePoints(leaf);
  }
}

//------------------------------------------------------------------------------
// The first of the two children, both of them leaves.
std::uint32_t vtkMTKdRegions::Divide(std::uint32_t leaf, std::size_t axis, double plane)
{
  const auto first = static_cast<std::uint32_t>(this->Nodes.size());
  this->Nodes.resize(this->Nodes.size() + 2);
  this->Nodes[leaf] = { plane, static_cast<std::uint32_t>(axis), first };
  return first;
}

//------------------------------------------------------------------------------
void vtkMTKdRegions::DividePoints(std::uint32_t leaf)
{
  const std::uint32_t contents = this->Nodes[leaf].Index;
  std::vector<Point> points;
  points.swap(this->Contents[contents].All);
  Box box;
  std::for_each(points.begin(), points.end(), [&box](const Point& x) { box.Add(x); });
  const std::size_t axis = box.GetLongestAxis();
  if (!(box.Lo[axis] < box.Hi[axis]))
  {
    // All at one place: it is looked at again when it has as many more.
    this->Contents[contents].Capacity = 2 * points.size();
    this->Contents[contents].All.swap(points);
    return;
  }
  const auto rank = static_cast<std::ptrdiff_t>(this->LowerShare * static_cast<double>(points.size()));
  const auto isLess = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
  std::nth_element(points.begin(), points.begin() + rank, points.end(), isLess);
  double plane = points[static_cast<std::size_t>(rank)][axis];
  if (plane == box.Lo[axis])
  {
    // Nothing is below it: the next place that is above.
    plane = box.Hi[axis];
    for (const Point& x : points)
    {
      plane = x[axis] > box.Lo[axis] ? std::min(plane, x[axis]) : plane;
    }
  }
  const std::uint32_t first = this->Divide(leaf, axis, plane);
  const auto middle =
    std::partition(points.begin(), points.end(), [axis, plane](const Point& x) { return x[axis] < plane; });
  this->Nodes[first].Index = contents;
  this->Nodes[first + 1].Index = static_cast<std::uint32_t>(this->Contents.size());
  this->Contents.emplace_back();
  this->Contents[contents].All.assign(points.begin(), middle);
  this->Contents.back().All.assign(middle, points.end());
  for (const std::uint32_t part : { contents, this->Nodes[first + 1].Index })
  {
    this->Contents[part].Capacity = std::max(this->Capacity, this->Contents[part].All.size());
  }
}

//------------------------------------------------------------------------------
// The first child's leaves before the second one's.
void vtkMTKdRegions::Number()
{
  std::uint32_t regions = 0;
  std::vector<std::uint32_t> stack{ 0 };
  while (!stack.empty())
  {
    Node& node = this->Nodes[stack.back()];
    stack.pop_back();
    if (node.Axis == Leaf)
    {
      node.Index = regions++;
      continue;
    }
    stack.push_back(node.Index + 1);
    stack.push_back(node.Index);
  }
  this->Seeds.assign(regions, Point{ 0.0, 0.0, 0.0 });
}

//------------------------------------------------------------------------------
bool vtkMTKdRegions::Finish(vtkMTBarycentreScan& scan, std::size_t most)
{
  vtkMTRelease(this->Contents);
  std::vector<Box> boxes; // by region
  bool isDivided = true;
  while (isDivided)
  {
    this->Number();
    boxes.assign(this->Seeds.size(), Box());
    const bool done = scan.Scan(
      [&](const Point* points, std::size_t count)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          if (vtkMTBarycentreSample::IsFinite(points[i]))
          {
            boxes[this->Nodes[this->FindLeaf(points[i])].Index].Add(points[i]);
          }
        }
      });
    if (!done)
    {
      return false;
    }
    isDivided = false;
    for (std::uint32_t node = static_cast<std::uint32_t>(this->Nodes.size()); node-- > 0;)
    {
      if (this->Nodes[node].Axis != Leaf)
      {
        continue;
      }
      const Box& box = boxes[this->Nodes[node].Index];
      const std::size_t axis = box.GetLongestAxis();
      if (box.Count > most && box.Lo[axis] < box.Hi[axis])
      {
        // Above the least and not above the largest, however near they are.
        const double plane = 0.5 * box.Lo[axis] + 0.5 * box.Hi[axis];
        this->Divide(node, axis, plane > box.Lo[axis] ? plane : box.Hi[axis]);
        isDivided = true;
      }
    }
  }
  // The middle of what a region holds is on the same side of all planes.
  for (std::size_t region = 0; region < boxes.size(); ++region)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double lo = boxes[region].Lo[axis];
      const double hi = boxes[region].Hi[axis];
      this->Seeds[region][axis] = std::clamp(0.5 * lo + 0.5 * hi, lo, hi);
    }
  }
  return true;
}
