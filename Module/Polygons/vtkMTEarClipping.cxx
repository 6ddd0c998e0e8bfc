// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTEarClipping.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Point = vtkMTPlaneOrientation::Point;
using Triangle = vtkMTEarClipping::Triangle;

constexpr std::uint32_t LargestWithoutGrid = 48;

// Whether the way from the corner `at` of a triangle to `to` leads between those to its other corners.
bool LeadsBetween(const Point& at, const Point& right, const Point& left, const Point& to)
{
  return vtkMTPlaneOrientation::Of(at, right, to) > 0.0 && vtkMTPlaneOrientation::Of(at, left, to) < 0.0;
}

// Below the x axis, or on it to the left.
bool IsInLowerHalf(const Point& from, const Point& to)
{
  return to[1] < from[1] || (to[1] == from[1] && to[0] < from[0]);
}
}

//------------------------------------------------------------------------------
void vtkMTEarClipping::Link()
{
  this->Count = static_cast<std::uint32_t>(this->Outline->Points.size());
  this->Next.resize(this->Count);
  this->Previous.resize(this->Count);
  this->Alive.assign(this->Count, 1);
  this->Head = 0;
  for (std::uint32_t i = 0; i < this->Count; ++i)
  {
    this->Next[i] = i + 1 < this->Count ? i + 1 : 0;
    this->Previous[this->Next[i]] = i;
  }
}

void vtkMTEarClipping::MakeGrid()
{
  const std::vector<Point>& points = this->Outline->Points;
  this->GridSize = 0;
  if (this->Count <= LargestWithoutGrid)
  {
    return;
  }
  this->GridSize = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(this->Count)));
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto range = std::minmax_element(
      points.begin(), points.end(), [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    const double extent = (*range.second)[axis] - (*range.first)[axis];
    this->GridOrigin[axis] = (*range.first)[axis];
    this->GridScale[axis] = extent > 0.0 ? this->GridSize / extent : 0.0;
  }
  const auto getCell = [&](const Point& point)
  {
    std::uint32_t cell[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      const double place = (point[axis] - this->GridOrigin[axis]) * this->GridScale[axis];
      cell[axis] = std::min(static_cast<std::uint32_t>(std::max(place, 0.0)), this->GridSize - 1);
    }
    return cell[1] * this->GridSize + cell[0];
  };
  this->CellBegins.assign(this->GridSize * this->GridSize + 1, 0);
  this->CellCorners.resize(this->Count);
  for (const Point& point : points)
  {
    ++this->CellBegins[getCell(point) + 1];
  }
  for (std::size_t cell = 1; cell < this->CellBegins.size(); ++cell)
  {
    this->CellBegins[cell] += this->CellBegins[cell - 1];
  }
  std::vector<std::uint32_t> ends = this->CellBegins;
  for (std::uint32_t i = 0; i < this->Count; ++i)
  {
    this->CellCorners[ends[getCell(points[i])]++] = i;
  }
}

//------------------------------------------------------------------------------
// Twice the area of the corner's triangle; positive where the outline turns to the left.
double vtkMTEarClipping::GetTurn(std::uint32_t corner) const
{
  const std::vector<Point>& points = this->Outline->Points;
  return vtkMTPlaneOrientation::Of(points[this->Previous[corner]], points[corner], points[this->Next[corner]]);
}

// A corner where the outline turns back on itself, or stays where it is.
bool vtkMTEarClipping::IsSpike(std::uint32_t corner) const
{
  constexpr double smallestSine = 1e-9;
  const Point& at = this->Outline->Points[corner];
  const Point& previous = this->Outline->Points[this->Previous[corner]];
  const Point& next = this->Outline->Points[this->Next[corner]];
  const double a[2] = { previous[0] - at[0], previous[1] - at[1] };
  const double b[2] = { next[0] - at[0], next[1] - at[1] };
  const double cosine = a[0] * b[0] + a[1] * b[1];
  const double sine = a[0] * b[1] - a[1] * b[0];
  return at == previous || at == next || (cosine > 0.0 && std::abs(sine) <= smallestSine * cosine);
}

// They enclose nothing; without them the rules for corners hold.
void vtkMTEarClipping::RemoveSpikes(std::vector<Triangle>& triangles)
{
  std::vector<std::uint32_t> looked;
  for (std::uint32_t i = this->Count; i > 0; --i)
  {
    looked.push_back(i - 1);
  }
  while (!looked.empty() && this->Count > 3)
  {
    const std::uint32_t corner = looked.back();
    looked.pop_back();
    if (this->Alive[corner] && this->IsSpike(corner))
    {
      looked.push_back(this->Next[corner]);
      looked.push_back(this->Previous[corner]);
      this->Remove(corner, triangles);
    }
  }
}

// How often the direction of the edges passes that of the x axis.
void vtkMTEarClipping::CountTurns()
{
  const std::vector<Point>& points = this->Outline->Points;
  this->Turns = 0;
  std::uint32_t corner = this->Head;
  for (std::uint32_t i = 0; i < this->Count; ++i, corner = this->Next[corner])
  {
    const bool before = IsInLowerHalf(points[this->Previous[corner]], points[corner]);
    const bool after = IsInLowerHalf(points[corner], points[this->Next[corner]]);
    const double turn = this->GetTurn(corner);
    this->Turns += before && !after && turn > 0.0 ? 1 : 0;
    this->Turns -= !before && after && turn < 0.0 ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
// As vtkPolygon has it, to the last bit.
double vtkMTEarClipping::GetMeasure(std::uint32_t corner) const
{
  const auto& places = this->Outline->Places;
  const vtkMTVector::Vector a = vtkMTVector::Subtract(places[corner], places[this->Previous[corner]]);
  const vtkMTVector::Vector b = vtkMTVector::Subtract(places[this->Next[corner]], places[corner]);
  const vtkMTVector::Vector c = vtkMTVector::Subtract(places[this->Previous[corner]], places[this->Next[corner]]);
  const double area = vtkMTVector::Dot(vtkMTVector::Cross(a, b), this->Outline->Normal);
  const double perimeter = vtkMTVector::Norm(a) + vtkMTVector::Norm(b) + vtkMTVector::Norm(c);
  return area > 0.0 ? perimeter * perimeter / area : std::numeric_limits<double>::max();
}

void vtkMTEarClipping::Enqueue(std::uint32_t corner)
{
  if (this->GetTurn(corner) > 0.0)
  {
    this->Queue->Insert(this->GetMeasure(corner), corner);
  }
}

void vtkMTEarClipping::FillQueue()
{
  this->Queue->Reset();
  std::uint32_t corner = this->Head;
  for (std::uint32_t i = 0; i < this->Count; ++i, corner = this->Next[corner])
  {
    this->Enqueue(corner);
  }
}

void vtkMTEarClipping::Remove(std::uint32_t corner, std::vector<Triangle>& triangles)
{
  const std::uint32_t previous = this->Previous[corner];
  const std::uint32_t next = this->Next[corner];
  triangles.push_back({ corner, next, previous });
  this->Alive[corner] = 0;
  this->Next[previous] = next;
  this->Previous[next] = previous;
  this->Head = this->Head == corner ? next : this->Head;
  --this->Count;
}

// Of a corner that is not in the queue; its neighbours get new places there.
void vtkMTEarClipping::ClipCorner(std::uint32_t corner, std::vector<Triangle>& triangles)
{
  const std::uint32_t previous = this->Previous[corner];
  const std::uint32_t next = this->Next[corner];
  this->Remove(corner, triangles);
  this->Queue->DeleteId(previous);
  this->Queue->DeleteId(next);
  this->Enqueue(previous);
  this->Enqueue(next);
}

//------------------------------------------------------------------------------
// Calls visit(corner) for the corners that may lie in the ear's triangle, until one is true.
template <typename Visit>
bool vtkMTEarClipping::AnyOfCornersNear(std::uint32_t ear, const Visit& visit) const
{
  if (this->GridSize == 0)
  {
    const std::uint32_t end = this->Previous[ear];
    std::uint32_t corner = this->Next[this->Next[ear]];
    while (corner != end && !visit(corner))
    {
      corner = this->Next[corner];
    }
    return corner != end;
  }
  std::uint32_t cells[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto [least, most] = std::minmax({ this->Outline->Points[this->Previous[ear]][axis],
      this->Outline->Points[ear][axis], this->Outline->Points[this->Next[ear]][axis] });
    const double scale = this->GridScale[axis];
    cells[axis][0] = static_cast<std::uint32_t>(std::max((least - this->GridOrigin[axis]) * scale, 0.0));
    cells[axis][1] =
      std::min(static_cast<std::uint32_t>(std::max((most - this->GridOrigin[axis]) * scale, 0.0)), this->GridSize - 1);
  }
  for (std::uint32_t row = cells[1][0]; row <= cells[1][1]; ++row)
  {
    const auto begin = this->CellCorners.begin() + this->CellBegins[row * this->GridSize + cells[0][0]];
    const auto end = this->CellCorners.begin() + this->CellBegins[row * this->GridSize + cells[0][1] + 1];
    const auto isHit = [&](std::uint32_t corner)
    {
      return this->Alive[corner] && corner != ear && corner != this->Previous[ear] && corner != this->Next[ear] &&
        visit(corner);
    };
    if (std::any_of(begin, end, isHit))
    {
      return true;
    }
  }
  return false;
}

// Whether the outline enters the ear's triangle at this corner.
bool vtkMTEarClipping::BlocksEar(std::uint32_t corner, std::uint32_t ear, Rule rule) const
{
  const std::vector<Point>& points = this->Outline->Points;
  const Point& a = points[this->Previous[ear]];
  const Point& b = points[ear];
  const Point& c = points[this->Next[ear]];
  const Point& p = points[corner];
  const double sides[3] = { vtkMTPlaneOrientation::Of(a, b, p), vtkMTPlaneOrientation::Of(b, c, p),
    vtkMTPlaneOrientation::Of(c, a, p) };
  if (sides[0] < 0.0 || sides[1] < 0.0 || sides[2] < 0.0)
  {
    return false;
  }
  const auto entersWith = [&](std::uint32_t neighbor)
  {
    const Point& to = points[neighbor];
    return p == a ? LeadsBetween(a, b, c, to)
      : p == b    ? LeadsBetween(b, c, a, to)
      : p == c    ? LeadsBetween(c, a, b, to)
                  : (sides[0] > 0.0 || vtkMTPlaneOrientation::Of(a, b, to) > 0.0) &&
        (sides[1] > 0.0 || vtkMTPlaneOrientation::Of(b, c, to) > 0.0) &&
        (sides[2] > 0.0 || vtkMTPlaneOrientation::Of(c, a, to) > 0.0);
  };
  const bool touches = rule == Rule::Clear && sides[2] == 0.0 && p != a && p != c;
  return touches || entersWith(this->Next[corner]) || entersWith(this->Previous[corner]);
}

// Whether the winding number of what is left is one there.
bool vtkMTEarClipping::IsInside(const Point& point) const
{
  int winding = 0;
  std::uint32_t corner = this->Head;
  for (std::uint32_t i = 0; i < this->Count; ++i, corner = this->Next[corner])
  {
    const Point& from = this->Outline->Points[corner];
    const Point& to = this->Outline->Points[this->Next[corner]];
    const bool isUp = from[1] <= point[1] && to[1] > point[1];
    const bool isDown = from[1] > point[1] && to[1] <= point[1];
    winding += isUp && vtkMTPlaneOrientation::Of(from, to, point) > 0.0 ? 1 : 0;
    winding -= isDown && vtkMTPlaneOrientation::Of(from, to, point) < 0.0 ? 1 : 0;
  }
  return winding == 1;
}

bool vtkMTEarClipping::IsEar(std::uint32_t corner, Rule rule) const
{
  const Point& a = this->Outline->Points[this->Previous[corner]];
  const Point& b = this->Outline->Points[corner];
  const Point& c = this->Outline->Points[this->Next[corner]];
  bool isShared = false;
  const bool isBlocked = this->AnyOfCornersNear(corner,
    [&](std::uint32_t other)
    {
      isShared = isShared || this->Outline->Points[other] == b;
      return this->BlocksEar(other, corner, rule);
    });
  return !isBlocked && (!isShared || this->IsInside({ (a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0 }));
}

//------------------------------------------------------------------------------
bool vtkMTEarClipping::ClipFlat(std::vector<Triangle>& triangles)
{
  std::uint32_t corner = this->Head;
  for (std::uint32_t i = 0; i < this->Count; ++i, corner = this->Next[corner])
  {
    if (this->GetTurn(corner) == 0.0)
    {
      this->Remove(corner, triangles);
      return true;
    }
  }
  return false;
}

bool vtkMTEarClipping::Clip(const vtkMTOutline& outline, std::vector<Triangle>& triangles)
{
  this->Outline = &outline;
  this->Link();
  this->MakeGrid();
  this->RemoveSpikes(triangles);
  this->CountTurns();
  Rule rule = Rule::Clear;
  bool isNew = false; // since the queue was filled
  for (this->FillQueue(); this->Count > 3;)
  {
    const vtkIdType candidates = this->Queue->GetNumberOfItems();
    if (candidates == 0)
    {
      if (!isNew && rule == Rule::Touching && !this->ClipFlat(triangles))
      {
        return false;
      }
      rule = !isNew && rule == Rule::Clear ? Rule::Touching : Rule::Clear;
      isNew = false;
      this->FillQueue();
      continue;
    }
    const bool isConvex = candidates == static_cast<vtkIdType>(this->Count) && this->TurnsOnce();
    const auto corner = static_cast<std::uint32_t>(this->Queue->Pop());
    if (isConvex || this->IsEar(corner, rule))
    {
      this->ClipCorner(corner, triangles);
      isNew = true;
      if (rule == Rule::Touching)
      {
        this->Queue->Reset(); // ears that touch nothing come first again
      }
    }
  }
  const vtkIdType last = this->Queue->Pop();
  this->Remove(last < 0 ? this->Head : static_cast<std::uint32_t>(last), triangles);
  return true;
}

std::vector<std::uint32_t> vtkMTEarClipping::GetLeft() const
{
  std::vector<std::uint32_t> left;
  std::uint32_t corner = this->Head;
  for (std::uint32_t i = 0; i < this->Count; ++i, corner = this->Next[corner])
  {
    left.push_back(corner);
  }
  return left;
}

void vtkMTEarClipping::ClipAnyway(std::size_t left, std::vector<Triangle>& triangles)
{
  for (this->FillQueue(); this->Count > left;)
  {
    const vtkIdType best = this->Queue->Pop();
    this->ClipCorner(best < 0 ? this->Head : static_cast<std::uint32_t>(best), triangles);
  }
}
