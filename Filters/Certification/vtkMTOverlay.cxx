// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOverlay.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkMTVector;

namespace
{
// Loops that enclose more points than these are given up; their triangles are bounded otherwise.
constexpr int MaximumPulls = 12;

// And so are all that are left when so many crossings for each triangle were looked at for pulling: a hundred times
// what surfaces need, where no hub is met again and again.
constexpr std::size_t PullingPerTriangle = 256;
}

vtkMTOverlay::vtkMTOverlay(const vtkMTSurface& floor, const vtkMTSurface& fragment, const std::vector<Place>& places)
  : Floor(floor)
  , Fragment(fragment)
  , Places(places)
  , IsEnclosed(3 * fragment.GetNumberOfTriangles(), 0)
  , MostPulling(PullingPerTriangle * (floor.GetNumberOfTriangles() + fragment.GetNumberOfTriangles()))
{
  this->TraceEdges();
  this->FindCells();
}

void vtkMTOverlay::FindCells()
{
  const auto triangles = static_cast<std::uint32_t>(this->Floor.GetNumberOfTriangles());
  this->Cells.reserve(5 * this->Floor.GetNumberOfTriangles());
  this->FirstCell.resize(triangles + std::size_t(1));
  for (std::uint32_t t = 0; t < triangles; ++t)
  {
    const std::size_t first = this->Cells.size();
    this->FirstCell[t] = static_cast<std::uint32_t>(first);
    this->Loop.clear();
    if (!this->CollectLoop(t) || (!this->Loop.empty() && !this->PullAcross(t)))
    {
      this->Cells.resize(first);
    }
  }
  this->FirstCell[triangles] = static_cast<std::uint32_t>(this->Cells.size());
}

vtkMTOverlay::Corners vtkMTOverlay::Merge(const Corners& a, const Corners& b)
{
  return { std::max(a.Distance, b.Distance), a.FloorPoint == b.FloorPoint ? a.FloorPoint : None,
    a.FragmentPoint == b.FragmentPoint ? a.FragmentPoint : None };
}

void vtkMTOverlay::AddCell(std::uint32_t triangle, const Corners& corners)
{
  this->Cells.push_back({ triangle, corners.Distance, corners.FloorPoint == None, corners.FragmentPoint == None });
}

vtkMTOverlay::Corners vtkMTOverlay::MakeCorner(std::uint32_t floorPoint) const
{
  return { this->Places[floorPoint].Distance, floorPoint, this->Places[floorPoint].Point };
}

// Walks along the three traces. What is left of the loop are crossings that do not cancel.
bool vtkMTOverlay::CollectLoop(std::uint32_t triangle)
{
  this->Here = this->MakeCorner(this->Floor.GetPoint(3 * triangle));
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    const std::uint32_t opposite = this->Floor.GetOpposite(h);
    const bool isFirst = opposite > h;
    const Trace& trace = this->Traces[isFirst ? h : opposite];
    if (!trace.Arrives)
    {
      return false;
    }
    this->Here = Merge(this->Here, this->MakeCorner(this->Floor.GetPoint(h)));
    for (std::uint32_t i = 0; i < trace.Count; ++i)
    {
      if (isFirst)
      {
        const Crossing& crossing = this->Crossings[trace.First + i];
        this->Cross(crossing.Halfedge, crossing.Corner);
      }
      else
      {
        const Crossing& back = this->Crossings[trace.First + trace.Count - 1 - i];
        this->Cross(this->Fragment.GetOpposite(back.Halfedge), back.Corner);
      }
    }
  }
  if (this->Loop.empty())
  {
    this->AddCell(this->Places[this->Floor.GetPoint(3 * triangle)].Triangle, this->Here);
  }
  else
  {
    this->Loop[0].Cell = Merge(this->Loop[0].Cell, this->Here); // the loop ends in the cell that it began with
  }
  return true;
}

void vtkMTOverlay::Cross(std::uint32_t h, const Corners& corner)
{
  const Corners here = Merge(this->Here, corner);
  if (!this->Loop.empty() && h == this->Fragment.GetOpposite(this->Loop.back().Halfedge))
  {
    this->AddCell(h / 3, here);
    this->Here = Merge(this->Loop.back().Cell, corner);
    this->Loop.pop_back();
    return;
  }
  this->Loop.push_back({ h, here, corner });
  this->Here = corner;
}

// What is left of the loop runs, after a way out and the same way back, around points of the fragment. It is pulled
// across one after the other until nothing is left.
bool vtkMTOverlay::PullAcross(std::uint32_t triangle)
{
  std::size_t first = 0;
  std::size_t last = this->Loop.size() - 1;
  for (; first < last && this->Loop[last].Halfedge == this->Fragment.GetOpposite(this->Loop[first].Halfedge); --last)
  {
    this->AddCell(this->Loop[first].Halfedge / 3, Merge(this->Loop[first].Cell, this->Loop[last].Crossing));
    ++first;
    this->Loop[first].Cell = Merge(this->Loop[first].Cell, this->Loop[last].Cell);
  }
  this->Remainder.clear();
  for (std::size_t i = first; i <= last; ++i)
  {
    this->Remainder.push_back(this->Loop[i].Halfedge);
  }
  // Where the fragment has turned the triangle over, the loop runs clockwise.
  if (!this->PullTogether() && !this->PullTogetherReversed())
  {
    return false;
  }
  this->AddCellsAround(triangle, first, last);
  return true;
}

// The cells around the points that the loop was pulled across.
void vtkMTOverlay::AddCellsAround(std::uint32_t triangle, std::size_t first, std::size_t last)
{
  Corners inner = this->MakeInnerCorner(this->Enclosed[0], triangle);
  for (const std::uint32_t out : this->Enclosed)
  {
    inner = Merge(inner, this->MakeInnerCorner(out, triangle));
    std::uint32_t h = out;
    do
    {
      this->IsEnclosed[h] ^= 1;
      h = this->Fragment.TurnLeft(h);
    } while (h != out);
  }
  const bool isOne = this->Enclosed.size() == 1;
  Corners all = inner;
  for (std::size_t i = first; i <= last; ++i)
  {
    const Corners cell = Merge(this->Loop[i].Cell, inner);
    all = Merge(all, cell);
    if (isOne)
    {
      this->AddCell(this->Loop[i].Halfedge / 3, cell);
    }
  }
  if (isOne)
  {
    return;
  }
  // Of several points it is not known which corners the cells around them have: each may have all.
  for (const std::uint32_t out : this->Enclosed)
  {
    std::uint32_t h = out;
    do
    {
      this->AddCell(h / 3, all);
      h = this->Fragment.TurnLeft(h);
    } while (h != out);
  }
}

bool vtkMTOverlay::PullTogether()
{
  this->Enclosed.clear();
  this->Rim = this->Remainder;
  while (!this->Rim.empty())
  {
    this->Pulling += this->Rim.size();
    if (this->Enclosed.size() == MaximumPulls || this->Pulling > this->MostPulling || !this->PullAcrossPoint())
    {
      return false;
    }
  }
  return true;
}

bool vtkMTOverlay::PullTogetherReversed()
{
  std::reverse(this->Remainder.begin(), this->Remainder.end());
  for (std::uint32_t& h : this->Remainder)
  {
    h = this->Fragment.GetOpposite(h);
  }
  return this->PullTogether();
}

// A point of the fragment, given by a half-edge that starts from it, goes with the nearest place of a floor's triangle.
vtkMTOverlay::Corners vtkMTOverlay::MakeInnerCorner(std::uint32_t out, std::uint32_t triangle) const
{
  const Vector& x = this->Fragment.GetPlace(out);
  const std::uint32_t point = this->Fragment.GetPoint(out);
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    if (this->Floor.GetPlace(h) == x)
    {
      return { 0.0, this->Floor.GetPoint(h), point };
    }
  }
  const double distance2 = this->Floor.GetDistance2(x, triangle, std::numeric_limits<double>::infinity());
  return { AboveZero(std::sqrt(distance2)), None, point };
}

// Number of triangles around the point that a half-edge starts from; 0 at a border. Once for each fan of a hub.
std::size_t vtkMTOverlay::CountAround(std::uint32_t out)
{
  const bool isHub = this->Fragment.IsHub(this->Fragment.GetPoint(out));
  const auto known = isHub ? this->FansOfHubs.find(out) : this->FansOfHubs.end();
  if (known != this->FansOfHubs.end())
  {
    return known->second;
  }
  std::vector<std::uint32_t> fan;
  std::size_t count = 0;
  std::uint32_t h = out;
  for (; h != None && (count == 0 || h != out); h = this->Fragment.TurnLeft(h), ++count)
  {
    if (isHub)
    {
      fan.push_back(h);
    }
  }
  const std::size_t result = h == None ? 0 : count;
  for (h = isHub && h == None ? this->Fragment.TurnRight(out) : None; h != None; h = this->Fragment.TurnRight(h))
  {
    fan.push_back(h);
  }
  for (const std::uint32_t of : fan)
  {
    this->FansOfHubs[of] = result;
  }
  return result;
}

// Takes the point to the left of the loop around which pulling makes it shortest.
bool vtkMTOverlay::PullAcrossPoint()
{
  const std::size_t size = this->Rim.size();
  const auto leftOf = [this](std::size_t i) { return this->Fragment.GetPoint(vtkMTSurface::Next(this->Rim[i])); };
  std::size_t begin = 0; // of a run of crossings with the same point to the left
  while (begin < size && leftOf(begin) == leftOf((begin + size - 1) % size))
  {
    ++begin;
  }
  if (begin == size)
  {
    // All around one point, once.
    const std::uint32_t out = vtkMTSurface::Next(this->Rim[0]);
    this->Enclosed.push_back(out);
    this->Rim.clear();
    return this->CountAround(out) == size;
  }
  std::size_t bestBegin = size;
  std::size_t bestRun = 0;
  std::size_t bestAround = 0;
  std::ptrdiff_t bestGain = std::numeric_limits<std::ptrdiff_t>::min();
  for (std::size_t i = begin; i < begin + size;)
  {
    std::size_t run = 1;
    while (run < size && leftOf((i + run) % size) == leftOf(i % size))
    {
      ++run;
    }
    const std::size_t around = this->CountAround(vtkMTSurface::Next(this->Rim[i % size]));
    const auto gain = 2 * static_cast<std::ptrdiff_t>(run) - static_cast<std::ptrdiff_t>(around);
    if (around >= run && gain > bestGain)
    {
      bestBegin = i % size;
      bestRun = run;
      bestAround = around;
      bestGain = gain;
    }
    i += run;
  }
  if (bestBegin == size)
  {
    return false;
  }
  this->ReplaceRun(bestBegin, bestRun, bestAround - bestRun);
  return true;
}

// Replaces a run of crossings around a point to the left by the others around it.
void vtkMTOverlay::ReplaceRun(std::size_t begin, std::size_t run, std::size_t others)
{
  std::rotate(this->Rim.begin(), this->Rim.begin() + static_cast<std::ptrdiff_t>(begin), this->Rim.end());
  std::uint32_t out = vtkMTSurface::Next(this->Rim[0]);
  this->Enclosed.push_back(out);
  this->Rim.erase(this->Rim.begin(), this->Rim.begin() + static_cast<std::ptrdiff_t>(run));
  // The rest runs from behind the run to before it; its ends meet the new crossings.
  for (std::size_t i = 0; i < others; ++i)
  {
    if (!this->Rim.empty() && this->Rim.back() == this->Fragment.GetOpposite(out))
    {
      this->Rim.pop_back();
    }
    else
    {
      this->Rim.push_back(out);
    }
    out = this->Fragment.TurnRight(out);
  }
  std::size_t first = 0;
  while (this->Rim.size() > first + 1 && this->Rim.back() == this->Fragment.GetOpposite(this->Rim[first]))
  {
    this->Rim.pop_back();
    ++first;
  }
  this->Rim.erase(this->Rim.begin(), this->Rim.begin() + static_cast<std::ptrdiff_t>(first));
}

// Whether a floor's border edge is one of the fragment's: then its trace, which may turn around its ends, is that edge.
bool vtkMTOverlay::IsKeptBorder(std::uint32_t h, const Trace& trace) const
{
  const std::uint32_t a = this->Places[this->Floor.GetPoint(h)].Point;
  const std::uint32_t b = this->Places[this->Floor.GetPoint(vtkMTSurface::Next(h))].Point;
  if (this->Floor.GetOpposite(h) != None || a == None || b == None)
  {
    return false;
  }
  const std::uint32_t kept = this->Fragment.GetHalfedge(a);
  if (this->Fragment.GetOpposite(kept) != None || this->Fragment.GetPoint(vtkMTSurface::Next(kept)) != b)
  {
    return false;
  }
  bool atEnd = false;
  for (std::uint32_t i = trace.First; i < trace.First + trace.Count; ++i)
  {
    const std::uint32_t p = this->Fragment.GetPoint(this->Crossings[i].Halfedge);
    const std::uint32_t q = this->Fragment.GetPoint(vtkMTSurface::Next(this->Crossings[i].Halfedge));
    atEnd = atEnd || (p != a && q != a);
    if (atEnd && p != b && q != b)
    {
      return false;
    }
  }
  return true;
}

// Marks the triangles that the images of edges come through at which the part of the floor ends that is mapped.
std::vector<unsigned char> vtkMTOverlay::FindRims() const
{
  std::vector<unsigned char> isRim(this->Fragment.GetNumberOfTriangles(), 0);
  for (std::uint32_t h = 0; h < this->Traces.size(); ++h)
  {
    const std::uint32_t opposite = this->Floor.GetOpposite(h);
    if (!this->Closes(h / 3) || (opposite != None && this->Closes(opposite / 3)))
    {
      continue;
    }
    const Trace& trace = this->Traces[opposite > h ? h : opposite];
    if (this->IsKeptBorder(h, trace))
    {
      continue;
    }
    isRim[this->Places[this->Floor.GetPoint(h)].Triangle] = 1;
    isRim[this->Places[this->Floor.GetPoint(vtkMTSurface::Next(h))].Triangle] = 1;
    for (std::uint32_t i = trace.First; i < trace.First + trace.Count; ++i)
    {
      isRim[this->Crossings[i].Halfedge / 3] = 1;
      isRim[this->Fragment.GetOpposite(this->Crossings[i].Halfedge) / 3] = 1;
    }
  }
  return isRim;
}

std::vector<unsigned char> vtkMTOverlay::FindCovered() const
{
  const std::vector<unsigned char> isRim = this->FindRims();
  std::vector<unsigned char> isCovered(isRim.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t s = 0; s < isRim.size(); ++s)
  {
    const bool isWitness = this->IsEnclosed[3 * s] || this->IsEnclosed[3 * s + 1] || this->IsEnclosed[3 * s + 2];
    if (!isRim[s] && !isCovered[s] && isWitness)
    {
      isCovered[s] = 1;
      stack.push_back(s);
    }
    while (!stack.empty())
    {
      const std::uint32_t top = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * top; h < 3 * top + 3; ++h)
      {
        const std::uint32_t opposite = this->Fragment.GetOpposite(h);
        if (opposite != None && !isRim[opposite / 3] && !isCovered[opposite / 3])
        {
          isCovered[opposite / 3] = 1;
          stack.push_back(opposite / 3);
        }
      }
    }
  }
  return isCovered;
}
