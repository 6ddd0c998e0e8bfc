// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOverlay.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkMTVector;

namespace
{
// Longer ways than these are taken for a trace that has lost its way; its triangles are bounded otherwise.
constexpr int MaximumSteps = 32;
constexpr int MaximumTurns = 32;
constexpr int MaximumPulls = 12;

// A trace arrives at this share of its edge: beyond, rounding decides which triangles around the end are met.
constexpr double Arrival = 1.0 - 1e-9;

// Where partners are not corners on both sides, their distance may have been rounded to zero.
double AboveZero(double distance)
{
  return std::max(distance, std::numeric_limits<double>::min());
}
}

// One edge of the floor on its way over the fragment.
class vtkMTOverlay::Tracer
{
public:
  Tracer(vtkMTOverlay& overlay, std::uint32_t h)
    : Fragment(overlay.Fragment)
    , Crossings(overlay.Crossings)
    , BeginPoint(overlay.Floor.GetPoint(h))
    , EndPoint(overlay.Floor.GetPoint(vtkMTSurface::Next(h)))
    , Begin(overlay.Floor.GetPlace(h))
    , End(overlay.Floor.GetPlace(vtkMTSurface::Next(h)))
    , From(overlay.Places[BeginPoint])
    , To(overlay.Places[EndPoint])
  {
  }

  bool Run()
  {
    if (this->From.Triangle == None || this->To.Triangle == None)
    {
      return false;
    }
    std::uint32_t here = this->From.Triangle;
    if (here == this->To.Triangle)
    {
      return true;
    }
    const Vector own = Subtract(this->End, this->Begin);
    const double ownLength2 = Dot(own, own);
    this->InverseLength2 = ownLength2 > 0.0 ? 1.0 / ownLength2 : 0.0;
    this->Direction = Subtract(this->To.At, this->From.At);
    this->Length2 = Dot(this->Direction, this->Direction);
    const Vector up = Add(this->Fragment.GetNormal(here), this->Fragment.GetNormal(this->To.Triangle));
    this->Left = vtkMTVector::Cross(up, this->Direction);
    std::uint32_t entered = None;
    for (int step = 0; step < MaximumSteps; ++step)
    {
      if (!(this->Length2 > 0.0) || !this->Leave(here, entered))
      {
        return this->TurnToEnd(here);
      }
      entered = this->Fragment.GetOpposite(this->Crossings.back().Halfedge);
      if (entered == None)
      {
        return false;
      }
      here = entered / 3;
      if (here == this->To.Triangle)
      {
        return true;
      }
    }
    return false;
  }

private:
  // How far to the left of the line a corner is.
  double GetSide(std::uint32_t h) const { return Dot(Subtract(this->Fragment.GetPlace(h), this->From.At), this->Left); }

  // Crosses the edge over which the line leaves a triangle; false where the end comes first.
  bool Leave(std::uint32_t triangle, std::uint32_t entered)
  {
    std::uint32_t h = entered == None ? this->FindFirstExit(triangle) : this->FindExit(entered);
    if (this->Fragment.GetOpposite(h) == None)
    {
      h = this->FindDetour(h, entered);
      this->LookAt(h);
    }
    const double right = this->RightSide;
    const double left = this->LeftSide;
    const double width = left - right;
    const double share = width > 0.0 ? std::clamp(-right / width, 0.0, 1.0) : (-right < left ? 0.0 : 1.0);
    const Vector& p = this->Fragment.GetPlace(h);
    const Vector& q = this->Fragment.GetPlace(vtkMTSurface::Next(h));
    const Vector partner = share == 1.0 ? q : Lerp(p, q, share);
    const double along = Dot(Subtract(partner, this->From.At), this->Direction);
    if (along >= Arrival * this->Length2)
    {
      return false;
    }
    if (along > 0.0)
    {
      this->CrossBetween(h, partner);
    }
    else
    {
      this->AddCrossing(h, share, this->BeginPoint, Norm(Subtract(this->Begin, partner)));
    }
    return true;
  }

  // Projecting to and fro brings the partners nearer together.
  void CrossBetween(std::uint32_t h, Vector partner)
  {
    const Vector& p = this->Fragment.GetPlace(h);
    const Vector& q = this->Fragment.GetPlace(vtkMTSurface::Next(h));
    const double share = FindFoot(p, q, this->FindOwn(partner));
    partner = share == 1.0 ? q : Lerp(p, q, share);
    this->AddCrossing(h, share, None, Norm(Subtract(this->FindOwn(partner), partner)));
  }

  // The nearest place of the floor's edge.
  Vector FindOwn(const Vector& x) const
  {
    const Vector along = Subtract(this->End, this->Begin);
    const double share = Dot(Subtract(x, this->Begin), along) * this->InverseLength2;
    return Lerp(this->Begin, this->End, std::clamp(share, 0.0, 1.0));
  }

  // Where on a segment, from 0 to 1, the point nearest to x is.
  static double FindFoot(const Vector& p, const Vector& q, const Vector& x)
  {
    const Vector along = Subtract(q, p);
    const double length2 = Dot(along, along);
    return length2 > 0.0 ? std::clamp(Dot(Subtract(x, p), along) / length2, 0.0, 1.0) : 0.0;
  }

  void LookAt(std::uint32_t h)
  {
    this->RightSide = this->GetSide(h);
    this->LeftSide = this->GetSide(vtkMTSurface::Next(h));
  }

  // The half-edge from right to left. Where the line misses the triangle it passes by its nearest corner.
  std::uint32_t FindFirstExit(std::uint32_t triangle)
  {
    const std::uint32_t first = 3 * triangle;
    const std::array<double, 3> side{ this->GetSide(first), this->GetSide(first + 1), this->GetSide(first + 2) };
    std::array<bool, 3> isLeft{ side[0] > 0.0, side[1] > 0.0, side[2] > 0.0 };
    if (isLeft[0] == isLeft[1] && isLeft[1] == isLeft[2])
    {
      int nearest = std::abs(side[1]) < std::abs(side[0]) ? 1 : 0;
      nearest = std::abs(side[2]) < std::abs(side[nearest]) ? 2 : nearest;
      isLeft[nearest] = !isLeft[nearest];
    }
    const std::uint32_t e = !isLeft[0] && isLeft[1] ? 0 : (!isLeft[1] && isLeft[2] ? 1 : 2);
    this->RightSide = side[e];
    this->LeftSide = side[e == 2 ? 0 : e + 1];
    return first + e;
  }

  // Of a triangle that was entered across a half-edge from left to right; both ends of that have been looked at.
  std::uint32_t FindExit(std::uint32_t entered)
  {
    const std::uint32_t third = vtkMTSurface::Previous(entered);
    const double side = this->GetSide(third);
    (side > 0.0 ? this->LeftSide : this->RightSide) = side;
    return side > 0.0 ? vtkMTSurface::Next(entered) : third;
  }

  // The line would leave the fragment: the edge over which to go around that end of the border edge which lies ahead.
  std::uint32_t FindDetour(std::uint32_t h, std::uint32_t entered) const
  {
    const Vector border = Subtract(this->Fragment.GetPlace(vtkMTSurface::Next(h)), this->Fragment.GetPlace(h));
    const std::uint32_t aroundLeft = vtkMTSurface::Next(h);
    const std::uint32_t aroundRight = vtkMTSurface::Previous(h);
    const bool isLeftAhead = Dot(border, this->Direction) > 0.0;
    return (isLeftAhead || entered == aroundRight) && entered != aroundLeft ? aroundLeft : aroundRight;
  }

  // From a triangle near the end to the end's own, which has a point in common with it.
  bool TurnToEnd(std::uint32_t here)
  {
    for (std::uint32_t h = 3 * here; h < 3 * here + 3; ++h)
    {
      for (std::uint32_t k = 3 * this->To.Triangle; k < 3 * this->To.Triangle + 3; ++k)
      {
        if (this->Fragment.GetPoint(h) == this->Fragment.GetPoint(k) && this->Turn(h, k))
        {
          return true;
        }
      }
    }
    return here == this->To.Triangle;
  }

  // Around the point that both half-edges start from, by the shorter way.
  bool Turn(std::uint32_t from, std::uint32_t to)
  {
    int lefts = 0;
    std::uint32_t left = from;
    for (; left != to && left != None && lefts < MaximumTurns; ++lefts)
    {
      left = this->Fragment.TurnLeft(left);
    }
    int rights = 0;
    std::uint32_t right = from;
    for (; right != to && right != None && rights < MaximumTurns; ++rights)
    {
      right = this->Fragment.TurnRight(right);
    }
    if (left != to && right != to)
    {
      return false;
    }
    if (left == to && (right != to || lefts <= rights))
    {
      for (std::uint32_t h = from; h != to; h = this->Fragment.TurnLeft(h))
      {
        this->CrossAtEnd(vtkMTSurface::Previous(h));
      }
      return true;
    }
    for (std::uint32_t h = from; h != to; h = this->Fragment.TurnRight(h))
    {
      this->CrossAtEnd(h);
    }
    return true;
  }

  void CrossAtEnd(std::uint32_t h)
  {
    const Vector& p = this->Fragment.GetPlace(h);
    const Vector& q = this->Fragment.GetPlace(vtkMTSurface::Next(h));
    const double share = FindFoot(p, q, this->To.At);
    const Vector partner = share == 1.0 ? q : Lerp(p, q, share);
    this->AddCrossing(h, share, this->EndPoint, Norm(Subtract(this->End, partner)));
  }

  void AddCrossing(std::uint32_t h, double share, std::uint32_t floorPoint, double distance)
  {
    const std::uint32_t fragmentPoint = share == 0.0
      ? this->Fragment.GetPoint(h)
      : (share == 1.0 ? this->Fragment.GetPoint(vtkMTSurface::Next(h)) : None);
    const bool atPoints = floorPoint != None && fragmentPoint != None;
    this->Crossings.push_back({ h, { atPoints ? distance : AboveZero(distance), floorPoint, fragmentPoint } });
  }

  const vtkMTSurface& Fragment;
  std::vector<Crossing>& Crossings;
  const std::uint32_t BeginPoint; // of the edge
  const std::uint32_t EndPoint;
  const Vector& Begin;
  const Vector& End;
  const Place& From;
  const Place& To;
  Vector Direction;       // from place to place
  Vector Left;            // perpendicular to it, about in the fragment's surface
  double RightSide = 0.0; // where the half-edge that the line comes to begins and ends: how far to the left
  double LeftSide = 0.0;
  double Length2 = 0.0;
  double InverseLength2 = 0.0; // of the edge itself
};

vtkMTOverlay::vtkMTOverlay(const vtkMTSurface& floor, const vtkMTSurface& fragment, const std::vector<Place>& places)
  : Floor(floor)
  , Fragment(fragment)
  , Places(places)
  , IsEnclosed(3 * fragment.GetNumberOfTriangles(), 0)
{
  this->TraceEdges();
  this->FindCells();
}

void vtkMTOverlay::TraceEdges()
{
  this->Traces.resize(3 * this->Floor.GetNumberOfTriangles());
  this->Crossings.reserve(this->Traces.size());
  for (std::uint32_t h = 0; h < this->Traces.size(); ++h)
  {
    if (this->Floor.GetOpposite(h) > h) // None too
    {
      Trace& trace = this->Traces[h];
      trace.First = static_cast<std::uint32_t>(this->Crossings.size());
      trace.Arrives = Tracer(*this, h).Run();
      trace.Count = static_cast<std::uint32_t>(this->Crossings.size()) - trace.First;
    }
  }
}

void vtkMTOverlay::FindCells()
{
  const auto triangles = static_cast<std::uint32_t>(this->Floor.GetNumberOfTriangles());
  this->Cells.reserve(4 * this->Floor.GetNumberOfTriangles());
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
    if (this->Enclosed.size() == MaximumPulls || !this->PullAcrossPoint())
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

// Number of triangles around the point that a half-edge starts from; 0 at a border.
std::size_t vtkMTOverlay::CountAround(std::uint32_t out) const
{
  std::size_t count = 0;
  std::uint32_t h = out;
  do
  {
    h = this->Fragment.TurnLeft(h);
    ++count;
  } while (h != None && h != out);
  return h == None ? 0 : count;
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
