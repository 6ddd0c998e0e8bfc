// SPDX-License-Identifier: BSD-3-Clause
// The overlay's traces: the edges of the floor on their way over the fragment.
#include "vtkMTOverlay.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
// Longer ways than these are taken for a trace that has lost its way; its triangles are bounded otherwise.
constexpr int MaximumSteps = 32;
constexpr int MaximumTurns = 32;

// A trace arrives at this share of its edge: beyond, rounding decides which triangles around the end are met.
constexpr double Arrival = 1.0 - 1e-9;
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

  // Projecting back and forth brings the partners nearer together.
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
    this->Crossings.push_back(
      { h, { atPoints ? distance : vtkMTOverlay::AboveZero(distance), floorPoint, fragmentPoint } });
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
