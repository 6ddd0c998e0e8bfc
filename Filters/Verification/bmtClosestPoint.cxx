// SPDX-License-Identifier: BSD-3-Clause
#include "bmtClosestPoint.h"

#include "bmtCommon.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t LeafSize = 6;
// Queries of one block share hints; fixed, so that results cannot depend on how blocks go to threads.
constexpr std::size_t BlockSize = 512;
constexpr std::size_t BlocksPerTurn = 512;

bmtPoint Subtract(const bmtPoint& a, const bmtPoint& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const bmtPoint& a, const bmtPoint& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// a - t * b
bmtPoint SubtractScaled(const bmtPoint& a, double t, const bmtPoint& b)
{
  return { a[0] - t * b[0], a[1] - t * b[1], a[2] - t * b[2] };
}

// p and q are relative to one end of the segment, q is its other end.
double SegmentDistance2(const bmtPoint& p, const bmtPoint& q)
{
  const double length2 = Dot(q, q);
  const double t = length2 > 0.0 ? std::clamp(Dot(p, q) / length2, 0.0, 1.0) : 0.0;
  const bmtPoint rest = SubtractScaled(p, t, q);
  return Dot(rest, rest);
}

// Whether the place t on the longest edge and s across it lies inside a triangle whose third corner is at (tc, 1).
bool IsInside(double t, double s, double tc)
{
  if (s < 0.0 || t < 0.0 || t > 1.0)
  {
    return false;
  }
  return t <= tc ? t >= s * tc : 1.0 - t >= s * (1.0 - tc);
}

double BoxDistance2(const bmtPoint& x, const bmtBounds& box)
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double d = std::max({ box.Minimum[axis] - x[axis], x[axis] - box.Maximum[axis], 0.0 });
    sum += d * d;
  }
  return sum;
}
}

bmtClosestPoint::bmtClosestPoint(const bmtSurface& surface)
  : Surface(surface)
  , Pieces(surface)
  , Order(Pieces.List())
{
  while ((this->Order.size() >> this->Depth) > LeafSize)
  {
    ++this->Depth;
  }
  this->Boxes.resize((std::size_t(2) << this->Depth) - 1);
  this->Split();
  this->Fit();
}

// Where the triangles of a node begin in Order; those of the next node are behind them.
std::size_t bmtClosestPoint::Begin(int depth, std::size_t node) const
{
  return (this->Order.size() * node) >> depth;
}

int bmtClosestPoint::GetLongestAxis(const std::uint32_t* first, const std::uint32_t* last) const
{
  bmtBounds bounds;
  for (const std::uint32_t* i = first; i != last; ++i)
  {
    bounds.Add(
      { this->Pieces.GetBarycentre(*i, 0), this->Pieces.GetBarycentre(*i, 1), this->Pieces.GetBarycentre(*i, 2) });
  }
  const bmtPoint size = Subtract(bounds.Maximum, bounds.Minimum);
  return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
}

void bmtClosestPoint::Split()
{
  for (int depth = 0; depth < this->Depth; ++depth)
  {
    vtkSMPTools::For(0, vtkIdType(1) << depth,
      [this, depth](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType node = begin; node < end; ++node)
        {
          std::uint32_t* first = this->Order.data() + this->Begin(depth, node);
          std::uint32_t* last = this->Order.data() + this->Begin(depth, node + 1);
          std::uint32_t* middle = this->Order.data() + this->Begin(depth + 1, 2 * node + 1);
          const int axis = this->GetLongestAxis(first, last);
          std::nth_element(first, middle, last,
            [this, axis](std::uint32_t a, std::uint32_t b)
            {
              const double xa = this->Pieces.GetBarycentre(a, axis);
              const double xb = this->Pieces.GetBarycentre(b, axis);
              return xa != xb ? xa < xb : a < b;
            });
        }
      });
  }
}

void bmtClosestPoint::Fit()
{
  const std::size_t firstLeaf = (std::size_t(1) << this->Depth) - 1;
  vtkSMPTools::For(0, vtkIdType(1) << this->Depth,
    [this, firstLeaf](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType leaf = begin; leaf < end; ++leaf)
      {
        if (this->IsCopyOfPreviousLeaf(static_cast<std::size_t>(leaf)))
        {
          continue; // an empty box is infinitely far away
        }
        for (std::size_t i = this->Begin(this->Depth, leaf); i < this->Begin(this->Depth, leaf + 1); ++i)
        {
          this->Boxes[firstLeaf + leaf].Add(this->Pieces.GetBounds(this->Order[i]));
        }
      }
    });
  for (std::size_t node = firstLeaf; node-- > 0;)
  {
    for (std::size_t child : { 2 * node + 1, 2 * node + 2 })
    {
      if (!this->Boxes[child].IsEmpty())
      {
        this->Boxes[node].Add(this->Boxes[child]);
      }
    }
  }
}

// Thousands of equal triangles have one barycentre, so that no box tells them apart: they lie together in Order, in
// ascending order of leaves, and the first leaf of them stands for all.
bool bmtClosestPoint::IsCopyOfPreviousLeaf(std::size_t leaf) const
{
  if (leaf == 0)
  {
    return false;
  }
  const std::uint32_t first = this->Order[this->Begin(this->Depth, leaf - 1)];
  const auto isCopy = [&](std::uint32_t piece) { return this->Pieces.AreEqual(piece, first); };
  return std::all_of(this->Order.begin() + static_cast<std::ptrdiff_t>(this->Begin(this->Depth, leaf - 1)),
    this->Order.begin() + static_cast<std::ptrdiff_t>(this->Begin(this->Depth, leaf + 1)), isCopy);
}

double bmtClosestPoint::GetDistance2(const bmtPoint& x, const bmtPoint& a, const bmtPoint& b, const bmtPoint& c)
{
  // Name the corners so that ab is the longest edge.
  const bmtPoint ab = Subtract(b, a);
  const bmtPoint bc = Subtract(c, b);
  const bmtPoint ca = Subtract(a, c);
  const double lengths[3] = { Dot(ab, ab), Dot(bc, bc), Dot(ca, ca) };
  const bmtPoint* corners[5] = { &a, &b, &c, &a, &b };
  const auto longest = std::max_element(lengths, lengths + 3) - lengths;
  const bmtPoint& origin = *corners[longest];

  const bmtPoint p = Subtract(x, origin);
  const bmtPoint e = Subtract(*corners[longest + 1], origin);
  const bmtPoint q = Subtract(*corners[longest + 2], origin);
  double best = std::min({ SegmentDistance2(p, e), SegmentDistance2(p, q),
    SegmentDistance2(Subtract(x, *corners[longest + 1]), Subtract(*corners[longest + 2], *corners[longest + 1])) });
  if (lengths[longest] <= 0.0)
  {
    return best;
  }
  // What is left of p and q across the edge; the triangle's plane is spanned by e and w.
  const double tp = Dot(p, e) / lengths[longest];
  const double tq = Dot(q, e) / lengths[longest];
  const bmtPoint r = SubtractScaled(p, tp, e);
  const bmtPoint w = SubtractScaled(q, tq, e);
  const double height2 = Dot(w, w);
  if (height2 > 0.0)
  {
    const double s = Dot(r, w) / height2;
    if (IsInside(tp, s, tq))
    {
      const bmtPoint rest = SubtractScaled(r, s, w);
      best = std::min(best, Dot(rest, rest));
    }
  }
  return best;
}

double bmtClosestPoint::GetTriangleDistance2(const bmtPoint& x, std::uint32_t triangle) const
{
  const bmtTriangle& t = this->Surface.Triangles[triangle];
  return GetDistance2(x, this->Surface.Points[t[0]], this->Surface.Points[t[1]], this->Surface.Points[t[2]]);
}

void bmtClosestPoint::SearchLeaf(const bmtPoint& x, std::size_t leaf, Result& best) const
{
  for (std::size_t i = this->Begin(this->Depth, leaf); i < this->Begin(this->Depth, leaf + 1); ++i)
  {
    const std::uint32_t triangle = this->Pieces.GetTriangle(this->Order[i]);
    const double distance2 = this->GetTriangleDistance2(x, triangle);
    if (distance2 < best.Distance2 || (distance2 == best.Distance2 && triangle < best.Triangle))
    {
      best = { distance2, triangle };
    }
  }
}

bmtClosestPoint::Result bmtClosestPoint::Find(const bmtPoint& x, std::uint32_t hint) const
{
  Result best;
  if (this->Order.empty())
  {
    return best;
  }
  if (hint != NoTriangle)
  {
    best = { this->GetTriangleDistance2(x, hint), hint };
  }
  const std::size_t firstLeaf = (std::size_t(1) << this->Depth) - 1;
  struct Entry
  {
    std::size_t Node;
    double Distance2;
  };
  Entry stack[128];
  int top = 0;
  const bmtPoint turned = this->Pieces.GetTurn().Apply(x);
  stack[top++] = { 0, BoxDistance2(turned, this->Boxes[0]) };
  while (top > 0)
  {
    const Entry entry = stack[--top];
    if (entry.Distance2 > best.Distance2)
    {
      continue;
    }
    if (entry.Node >= firstLeaf)
    {
      this->SearchLeaf(x, entry.Node - firstLeaf, best);
      continue;
    }
    Entry near = { 2 * entry.Node + 1, BoxDistance2(turned, this->Boxes[2 * entry.Node + 1]) };
    Entry far = { 2 * entry.Node + 2, BoxDistance2(turned, this->Boxes[2 * entry.Node + 2]) };
    if (far.Distance2 < near.Distance2)
    {
      std::swap(near, far);
    }
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

void bmtClosestPoint::Measure(const std::vector<bmtPoint>& points, std::vector<double>& distances,
  std::vector<std::uint32_t>* nearest, const char* progress) const
{
  distances.assign(points.size(), 0.0);
  if (nearest)
  {
    nearest->assign(points.size(), NoTriangle);
  }
  const auto measureBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end && !bmtIsInterrupted(); ++block)
    {
      std::uint32_t hint = NoTriangle;
      const std::size_t last = std::min<std::size_t>(points.size(), (block + 1) * BlockSize);
      for (std::size_t i = block * BlockSize; i < last; ++i)
      {
        const Result result = this->Find(points[i], hint);
        distances[i] = std::sqrt(result.Distance2);
        hint = result.Triangle;
        if (nearest)
        {
          (*nearest)[i] = result.Triangle;
        }
      }
    }
  };
  const std::size_t blocks = (points.size() + BlockSize - 1) / BlockSize;
  bmtProgress report(progress);
  for (std::size_t first = 0; first < blocks; first += BlocksPerTurn)
  {
    const std::size_t last = std::min(blocks, first + BlocksPerTurn);
    vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 4, measureBlocks);
    bmtThrowIfInterrupted();
    report.Update(static_cast<double>(last) / static_cast<double>(blocks));
  }
}
