// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTClosestPoint.h"

#include "vtkMTVector.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
constexpr std::size_t LeafSize = 6;
// Queries of one block share hints; fixed, so that results cannot depend on how blocks go to threads.
constexpr std::size_t BlockSize = 512;
// Between two calls of progress: a tenth of a second or less, so that it also serves to stop.
constexpr std::size_t BlocksPerTurn = 128;

// a - t * b
vtkMTRealPoint SubtractScaled(const vtkMTRealPoint& a, double t, const vtkMTRealPoint& b)
{
  return { a[0] - t * b[0], a[1] - t * b[1], a[2] - t * b[2] };
}

// p and q are relative to one end of the segment, q is its other end.
double SegmentDistance2(const vtkMTRealPoint& p, const vtkMTRealPoint& q)
{
  const double length2 = Dot(q, q);
  const double t = length2 > 0.0 ? std::clamp(Dot(p, q) / length2, 0.0, 1.0) : 0.0;
  const vtkMTRealPoint rest = SubtractScaled(p, t, q);
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

double BoxDistance2(const vtkMTRealPoint& x, const vtkMTRealBounds& box)
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

vtkMTClosestPoint::vtkMTClosestPoint(const vtkMTSampledSurface& surface)
  : Surface(surface)
  , Pieces(surface)
  , Order(Pieces.List())
{
  while ((this->Order.size() >> this->Depth) > LeafSize)
  {
    ++this->Depth;
  }
  this->Boxes.resize((std::size_t(2) << this->Depth) - 1);
  Barycentres barycentres(this->Pieces.GetNumberOfPieces());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Order.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::uint32_t piece = this->Order[static_cast<std::size_t>(i)];
        const vtkMTRealPoint x = this->Pieces.GetBarycentre(piece);
        barycentres[piece] = { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) };
      }
    });
  this->Split(barycentres);
  this->Fit();
  this->FitOriented();
}

// Where the triangles of a node begin in Order; those of the next node are behind them.
std::size_t vtkMTClosestPoint::Begin(int depth, std::size_t node) const
{
  return (this->Order.size() * node) >> depth;
}

int vtkMTClosestPoint::GetLongestAxis(
  const Barycentres& barycentres, const std::uint32_t* first, const std::uint32_t* last)
{
  std::array<float, 3> low = barycentres[*first];
  std::array<float, 3> high = low;
  for (const std::uint32_t* i = first; i != last; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], barycentres[*i][axis]);
      high[axis] = std::max(high[axis], barycentres[*i][axis]);
    }
  }
  const float size[3] = { high[0] - low[0], high[1] - low[1], high[2] - low[2] };
  return static_cast<int>(std::max_element(size, size + 3) - size);
}

void vtkMTClosestPoint::Split(const Barycentres& barycentres)
{
  for (int depth = 0; depth < this->Depth; ++depth)
  {
    vtkSMPTools::For(0, vtkIdType(1) << depth,
      [&, depth](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType node = begin; node < end; ++node)
        {
          std::uint32_t* first = this->Order.data() + this->Begin(depth, node);
          std::uint32_t* last = this->Order.data() + this->Begin(depth, node + 1);
          std::uint32_t* middle = this->Order.data() + this->Begin(depth + 1, 2 * node + 1);
          const int axis = GetLongestAxis(barycentres, first, last);
          std::nth_element(first, middle, last,
            [&barycentres, axis](std::uint32_t a, std::uint32_t b)
            {
              const float xa = barycentres[a][axis];
              const float xb = barycentres[b][axis];
              return xa != xb ? xa < xb : a < b;
            });
        }
      });
  }
}

void vtkMTClosestPoint::Fit()
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

// Where there are no needles, straight boxes are all that is needed.
void vtkMTClosestPoint::FitOriented()
{
  if (!this->Pieces.HasNeedles())
  {
    return;
  }
  this->Oriented.Fit(this->Boxes,
    [this](std::size_t node, const std::function<void(const vtkMTRealPoint&)>& add)
    {
      int depth = 0;
      while ((std::size_t(2) << depth) - 1 <= node)
      {
        ++depth;
      }
      const std::size_t place = node + 1 - (std::size_t(1) << depth);
      for (std::size_t i = this->Begin(depth, place); i < this->Begin(depth, place + 1); ++i)
      {
        for (const vtkMTRealPoint& corner : this->Pieces.GetCorners(this->Order[i]).P)
        {
          add(corner);
        }
      }
    });
}

// Thousands of equal triangles have one barycentre, so that no box tells them apart: they lie together in Order, in
// ascending order of leaves, and the first leaf of them stands for all.
bool vtkMTClosestPoint::IsCopyOfPreviousLeaf(std::size_t leaf) const
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

double vtkMTClosestPoint::GetDistance2(
  const vtkMTRealPoint& x, const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c)
{
  // Name the corners so that ab is the longest edge.
  const vtkMTRealPoint ab = Subtract(b, a);
  const vtkMTRealPoint bc = Subtract(c, b);
  const vtkMTRealPoint ca = Subtract(a, c);
  const double lengths[3] = { Dot(ab, ab), Dot(bc, bc), Dot(ca, ca) };
  const vtkMTRealPoint* corners[5] = { &a, &b, &c, &a, &b };
  const auto longest = std::max_element(lengths, lengths + 3) - lengths;
  const vtkMTRealPoint& origin = *corners[longest];

  const vtkMTRealPoint p = Subtract(x, origin);
  const vtkMTRealPoint e = Subtract(*corners[longest + 1], origin);
  const vtkMTRealPoint q = Subtract(*corners[longest + 2], origin);
  double best = std::min({ SegmentDistance2(p, e), SegmentDistance2(p, q),
    SegmentDistance2(Subtract(x, *corners[longest + 1]), Subtract(*corners[longest + 2], *corners[longest + 1])) });
  if (lengths[longest] <= 0.0)
  {
    return best;
  }
  // What is left of p and q across the edge; the triangle's plane is spanned by e and w.
  const double tp = Dot(p, e) / lengths[longest];
  const double tq = Dot(q, e) / lengths[longest];
  const vtkMTRealPoint r = SubtractScaled(p, tp, e);
  const vtkMTRealPoint w = SubtractScaled(q, tq, e);
  const double height2 = Dot(w, w);
  if (height2 > 0.0)
  {
    const double s = Dot(r, w) / height2;
    if (IsInside(tp, s, tq))
    {
      const vtkMTRealPoint rest = SubtractScaled(r, s, w);
      best = std::min(best, Dot(rest, rest));
    }
  }
  return best;
}

double vtkMTClosestPoint::GetTriangleDistance2(const vtkMTRealPoint& x, std::uint32_t triangle) const
{
  const vtkMTTriangle& t = this->Surface.Triangles[triangle];
  return GetDistance2(x, this->Surface.Points[t[0]], this->Surface.Points[t[1]], this->Surface.Points[t[2]]);
}

void vtkMTClosestPoint::SearchLeaf(const vtkMTRealPoint& x, std::size_t leaf, Result& best) const
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

vtkMTClosestPoint::Result vtkMTClosestPoint::Find(const vtkMTRealPoint& x, std::uint32_t hint) const
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
  const vtkMTRealPoint turned = this->Pieces.GetAxes().Apply(x);
  const auto enter = [&](std::size_t node)
  {
    const double straight = BoxDistance2(turned, this->Boxes[node]);
    const bool isFar = straight > best.Distance2;
    return Entry{ node, isFar ? straight : std::max(straight, this->Oriented.GetDistance2(node, turned)) };
  };
  stack[top++] = enter(0);
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
    Entry near = enter(2 * entry.Node + 1);
    Entry far = enter(2 * entry.Node + 2);
    if (far.Distance2 < near.Distance2)
    {
      std::swap(near, far);
    }
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

void vtkMTClosestPoint::VisitWithin(
  const vtkMTRealPoint& x, double radius, const std::function<bool(std::uint32_t triangle)>& visit) const
{
  const std::size_t firstLeaf = (std::size_t(1) << this->Depth) - 1;
  const vtkMTRealPoint turned = this->Pieces.GetAxes().Apply(x);
  const double radius2 = radius * radius;
  std::vector<std::size_t> stack(this->Order.empty() ? 0 : 1, 0);
  while (!stack.empty())
  {
    const std::size_t node = stack.back();
    stack.pop_back();
    if (BoxDistance2(turned, this->Boxes[node]) > radius2)
    {
      continue;
    }
    if (node < firstLeaf)
    {
      stack.push_back(2 * node + 2);
      stack.push_back(2 * node + 1);
      continue;
    }
    const std::size_t end = this->Begin(this->Depth, node - firstLeaf + 1);
    for (std::size_t i = this->Begin(this->Depth, node - firstLeaf); i < end; ++i)
    {
      const std::uint32_t triangle = this->Pieces.GetTriangle(this->Order[i]);
      if (this->GetTriangleDistance2(x, triangle) <= radius2 && !visit(triangle))
      {
        return;
      }
    }
  }
}

bool vtkMTClosestPoint::Measure(const std::vector<vtkMTRealPoint>& points, std::vector<double>& distances,
  std::vector<std::uint32_t>* nearest, const Progress& progress) const
{
  distances.assign(points.size(), 0.0);
  if (nearest)
  {
    nearest->assign(points.size(), NoTriangle);
  }
  const auto measureBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
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
  for (std::size_t first = 0; first < blocks; first += BlocksPerTurn)
  {
    const std::size_t last = std::min(blocks, first + BlocksPerTurn);
    vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 4, measureBlocks);
    if (!progress(static_cast<double>(last) / static_cast<double>(blocks)))
    {
      return false;
    }
  }
  return true;
}
