// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCellsOver.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace vtkMTVector;

namespace
{
using Place = vtkMTCellsOver::Place;

constexpr double LeastHeight = 1.0 / 64.0; // of a triangle, of its longest edge
constexpr double Turned = 1.0 / 1048576.0; // what is smaller as seen along the normal may be turned over by rounding
constexpr double Tolerance = 1e-9;
constexpr double Strip = 1e-13; // what is nearer to an edge goes with what is beside it
constexpr int MostSteps = 64;   // to the triangle over the middle
constexpr int MostCorners = 12; // where rounding makes every corner cross an edge

// Twice the area of a triangle as seen along the normal, of that of the one that is seen from.
double GetArea(const Place& a, const Place& b, const Place& c)
{
  return (b.Weight1 - a.Weight1) * (c.Weight2 - a.Weight2) - (b.Weight2 - a.Weight2) * (c.Weight1 - a.Weight1);
}

// Square of how far a place is from corner 0, about.
double GetWay2(const Place& a)
{
  return a.Weight1 * a.Weight1 + a.Weight2 * a.Weight2;
}

// The three edges of the triangle that a place is outside of, as bits.
int FindOutside(const Place& a, double tolerance)
{
  return (a.Weight1 + a.Weight2 > 1.0 + tolerance ? 1 : 0) | (a.Weight1 < -tolerance ? 2 : 0) |
    (a.Weight2 < -tolerance ? 4 : 0);
}

// A line, by how far inside a place is.
struct Line
{
  double AtOrigin;
  double By1;
  double By2;

  double GetInside(const Place& a) const { return this->AtOrigin + this->By1 * a.Weight1 + this->By2 * a.Weight2; }
};
constexpr std::array<Line, 3> OwnEdges{ { { 1.0, -1.0, -1.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };

// Inside is to the left.
Line MakeLine(const Place& a, const Place& b)
{
  const double x = b.Weight1 - a.Weight1;
  const double y = b.Weight2 - a.Weight2;
  return { y * a.Weight1 - x * a.Weight2, -y, x };
}

// Whether a polygon is but a strip along an edge, or part of that.
bool IsStrip(const Place* corners, int count)
{
  Place most = corners[0];
  double most0 = OwnEdges[0].GetInside(corners[0]);
  for (int i = 1; i < count; ++i)
  {
    most.Weight1 = std::max(most.Weight1, corners[i].Weight1);
    most.Weight2 = std::max(most.Weight2, corners[i].Weight2);
    most0 = std::max(most0, OwnEdges[0].GetInside(corners[i]));
  }
  return most0 <= Strip || most.Weight1 <= Strip || most.Weight2 <= Strip;
}

// What is left of a convex polygon inside a line; returns the number of corners.
int Clip(const Place* from, int count, const Line& line, Place* to)
{
  int kept = 0;
  const Place* before = from + count - 1;
  double insideBefore = line.GetInside(*before);
  for (int i = 0; i < count && kept + 2 <= MostCorners; ++i)
  {
    const Place& here = from[i];
    const double inside = line.GetInside(here);
    if ((inside < 0.0) != (insideBefore < 0.0))
    {
      const double t = insideBefore / (insideBefore - inside);
      to[kept++] = { before->Weight1 + (here.Weight1 - before->Weight1) * t,
        before->Weight2 + (here.Weight2 - before->Weight2) * t, before->Height + (here.Height - before->Height) * t };
    }
    if (!(inside < 0.0))
    {
      to[kept++] = here;
    }
    before = &here;
    insideBefore = inside;
  }
  return kept;
}
}

//------------------------------------------------------------------------------
bool vtkMTCellsOver::SetPlane(std::uint32_t triangle)
{
  this->Origin = this->From.GetCorner(triangle, 0);
  this->Edge1 = Subtract(this->From.GetCorner(triangle, 1), this->Origin);
  this->Edge2 = Subtract(this->From.GetCorner(triangle, 2), this->Origin);
  const Vector third = Subtract(this->Edge2, this->Edge1);
  const double longest2 = std::max({ Dot(this->Edge1, this->Edge1), Dot(this->Edge2, this->Edge2), Dot(third, third) });
  const Vector cross = vtkMTVector::Cross(this->Edge1, this->Edge2);
  const double area2 = Dot(cross, cross);
  if (!(area2 > LeastHeight * LeastHeight * longest2 * longest2))
  {
    return false;
  }
  this->Normal = Scale(cross, 1.0 / std::sqrt(area2));
  this->Gradient1 = Scale(vtkMTVector::Cross(this->Edge2, cross), 1.0 / area2);
  this->Gradient2 = Scale(vtkMTVector::Cross(cross, this->Edge1), 1.0 / area2);
  return true;
}

//------------------------------------------------------------------------------
inline vtkMTCellsOver::Place vtkMTCellsOver::See(const Vector& x) const
{
  const Vector way = Subtract(x, this->Origin);
  return { Dot(way, this->Gradient1), Dot(way, this->Gradient2), Dot(way, this->Normal) };
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTCellsOver::Begin(std::uint32_t triangle, std::uint32_t guess)
{
  this->Stack.clear();
  if (!this->SetPlane(triangle))
  {
    return guess;
  }
  this->Middle = { 1.0 / 3.0, 1.0 / 3.0, 0.0 };
  std::uint32_t here = 3 * guess; // come to across this half-edge
  std::array<Place, 3> corners{ this->See(this->To.GetPlace(here)), this->See(this->To.GetPlace(here + 1)),
    this->See(this->To.GetPlace(here + 2)) };
  for (int step = 0; step < MostSteps; ++step)
  {
    const std::uint32_t next = vtkMTSurface::Next(here);
    const std::uint32_t previous = vtkMTSurface::Previous(here);
    std::uint32_t exit = None;
    if (GetArea(corners[1], corners[2], this->Middle) < 0.0)
    {
      exit = next;
      corners = { corners[2], corners[1], corners[0] };
    }
    else if (GetArea(corners[2], corners[0], this->Middle) < 0.0)
    {
      exit = previous;
      corners = { corners[0], corners[2], corners[1] };
    }
    else if (step == 0 && GetArea(corners[0], corners[1], this->Middle) < 0.0)
    {
      exit = here;
      corners = { corners[1], corners[0], corners[2] };
    }
    const std::uint32_t opposite = exit == None ? None : this->To.GetOpposite(exit);
    if (exit == None)
    {
      this->BeginAt(here, corners);
      return here / 3;
    }
    if (opposite == None)
    {
      this->BeginAtPart(exit, { corners[1], corners[0], corners[2] });
      return here / 3;
    }
    here = opposite;
    corners[2] = this->See(this->To.GetPlace(vtkMTSurface::Previous(here)));
  }
  return here / 3;
}

//------------------------------------------------------------------------------
void vtkMTCellsOver::BeginAt(std::uint32_t h, const std::array<Place, 3>& corners)
{
  this->Stack.push_back({ h, corners[0], corners[1] });
}

//------------------------------------------------------------------------------
// Where a triangle at the border lies over a part alone, all is seen from the middle of that.
void vtkMTCellsOver::BeginAtPart(std::uint32_t h, const std::array<Place, 3>& corners)
{
  this->Cells.clear();
  this->Corners.clear();
  this->AddCell(
    h / 3, corners, FindOutside(corners[0], 0.0) | FindOutside(corners[1], 0.0) | FindOutside(corners[2], 0.0));
  if (this->Cells.empty())
  {
    return;
  }
  this->Middle = { 0.0, 0.0, 0.0 };
  const double share = 1.0 / static_cast<double>(this->Corners.size());
  for (const Place& corner : this->Corners)
  {
    this->Middle.Weight1 += share * corner.Weight1;
    this->Middle.Weight2 += share * corner.Weight2;
  }
  this->BeginAt(h, corners);
}

//------------------------------------------------------------------------------
bool vtkMTCellsOver::Split()
{
  if (this->Stack.empty())
  {
    return false;
  }
  this->Cells.clear();
  this->Corners.clear();
  if (this->MetBy.empty() || this->Question == None)
  {
    this->MetBy.assign(this->To.GetNumberOfTriangles(), 0);
    this->Question = 0;
  }
  this->MetBy[this->Stack.back().Halfedge / 3] = ++this->Question;
  this->Met = 0;
  while (!this->Stack.empty())
  {
    const Entry entry = this->Stack.back();
    this->Stack.pop_back();
    if (!this->Visit(entry))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTCellsOver::Visit(const Entry& entry)
{
  const std::uint32_t next = vtkMTSurface::Next(entry.Halfedge);
  const std::uint32_t previous = vtkMTSurface::Previous(entry.Halfedge);
  const Place third = this->See(this->To.GetPlace(previous));
  const double scale2 = 1.0 + GetWay2(entry.Begin) + GetWay2(entry.End) + GetWay2(third);
  if (!(GetArea(entry.Begin, entry.End, third) > Turned * scale2) || ++this->Met > MostTriangles)
  {
    return false;
  }
  this->AddCell(entry.Halfedge / 3, { entry.Begin, entry.End, third },
    FindOutside(entry.Begin, 0.0) | FindOutside(entry.End, 0.0) | FindOutside(third, 0.0));
  this->GoOn(entry.Halfedge, entry.Begin, entry.End);
  this->GoOn(next, entry.End, third);
  this->GoOn(previous, third, entry.Begin);
  return true;
}

//------------------------------------------------------------------------------
// To the triangle behind an edge, where that may cross the triangle that is looked at.
void vtkMTCellsOver::GoOn(std::uint32_t h, const Place& begin, const Place& end)
{
  const std::uint32_t opposite = this->To.GetOpposite(h);
  if (opposite != None && this->MetBy[opposite / 3] == this->Question)
  {
    return;
  }
  const double tolerance = Tolerance * (1.0 + GetWay2(begin) + GetWay2(end));
  const int atBegin = FindOutside(begin, tolerance);
  const int atEnd = FindOutside(end, tolerance);
  if ((atBegin & atEnd) != 0)
  {
    return;
  }
  if (atBegin != 0 && atEnd != 0)
  {
    // Where all corners are on one side of the edge, that passes by.
    const double x = end.Weight1 - begin.Weight1;
    const double y = end.Weight2 - begin.Weight2;
    const double side = y * begin.Weight1 - x * begin.Weight2;
    const auto [least, most] = std::minmax({ side, side - y, side + x });
    if (least > tolerance || most < -tolerance)
    {
      return;
    }
  }
  if (opposite == None)
  {
    this->AddBeyond(h / 3, begin, end);
    return;
  }
  this->MetBy[opposite / 3] = this->Question;
  this->Stack.push_back({ opposite, end, begin });
}

//------------------------------------------------------------------------------
// What lies beyond a border edge as seen from the middle, which something lies over: every place that nothing lies over
// is beyond one, where the way from the middle to it leaves what is covered.
void vtkMTCellsOver::AddBeyond(std::uint32_t triangle, const Place& begin, const Place& end)
{
  if (!(GetArea(begin, end, this->Middle) > 0.0))
  {
    return;
  }
  const std::array<Line, 3> lines{ MakeLine(end, begin), MakeLine(this->Middle, begin), MakeLine(end, this->Middle) };
  std::array<Place, MostCorners> one{ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } } };
  std::array<Place, MostCorners> other;
  Place* from = one.data();
  Place* to = other.data();
  int count = 3;
  for (int i = 0; i < 3 && count > 0; ++i)
  {
    count = Clip(from, count, lines[i], to);
    std::swap(from, to);
  }
  if (count > 0 && !IsStrip(from, count))
  {
    this->PutCell(triangle, from, count, std::numeric_limits<double>::infinity());
  }
}

//------------------------------------------------------------------------------
void vtkMTCellsOver::PutCell(std::uint32_t triangle, const Place* corners, int count, double height)
{
  this->Cells.push_back(
    { triangle, static_cast<std::uint32_t>(this->Corners.size()), static_cast<std::uint32_t>(count), height });
  this->Corners.insert(this->Corners.end(), corners, corners + count);
}

//------------------------------------------------------------------------------
void vtkMTCellsOver::AddCell(std::uint32_t triangle, const std::array<Place, 3>& corners, int outside)
{
  std::array<Place, MostCorners> one;
  std::array<Place, MostCorners> other;
  std::copy(corners.begin(), corners.end(), one.begin());
  Place* from = one.data();
  Place* to = other.data();
  int count = 3;
  for (int edge = 0; edge < 3 && count > 0; ++edge)
  {
    if ((outside & (1 << edge)) != 0)
    {
      count = Clip(from, count, OwnEdges[edge], to);
      std::swap(from, to);
    }
  }
  if (count == 0 || (outside != 0 && IsStrip(from, count)))
  {
    return;
  }
  double height = 0.0;
  for (int i = 0; i < count; ++i)
  {
    height = std::max(height, std::abs(from[i].Height));
  }
  this->PutCell(triangle, from, count, height);
}

//------------------------------------------------------------------------------
void vtkMTCellsOver::GetShape(const Cell& cell, vtkMTPiece& shape) const
{
  shape.Count = 0;
  for (std::uint32_t i = cell.First; i < cell.First + cell.Count; ++i)
  {
    const Place& place = this->Corners[i];
    shape.Append(Add(this->Origin, Add(Scale(this->Edge1, place.Weight1), Scale(this->Edge2, place.Weight2))));
  }
}
