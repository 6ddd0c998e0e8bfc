// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPieceBound.h"

#include "vtkMTDeviation.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
// A long triangle may cross thousands of others, and every one that is split off counts; the budget ends what does not.
constexpr int MaximumDepth = 4096;

// One triangle must not use up what the others need for a bound at all. Pieces that are split along triangles get
// somewhere; where two sheets are closer than the largest distance of all, the bound by either may stay just above it
// however small the halves are: after so many of them it will do, and a looser one the more there are.
double GetShare(std::size_t halvings, double share)
{
  constexpr std::size_t Tight = 512;
  constexpr double ToDouble = 1024.0;
  return halvings < Tight ? share
                          : vtkMTDeviation::Looseness * (1.0 + static_cast<double>(halvings - Tight) / ToDouble);
}
}

vtkMTPieceBound::vtkMTPieceBound(const vtkMTSurface& from, const vtkMTSurface& to, double slack, vtkMTDeviation& result)
  : Share(vtkMTDeviation::Share)
  , Before(from.GetNumberOfTriangles(), 0.0f)
  , After(to.GetNumberOfTriangles(), 0.0f)
  , From(from)
  , To(to)
  , Tree(to, vtkMTTriangleTree::GetEnoughEffort(to))
  , Over(from, to)
  , Slack(slack)
  , Result(result)
  , BoundOfTriangle(from.GetNumberOfTriangles(), 0.0)
  , BoundOnTriangle(to.GetNumberOfTriangles(), 0.0)
{
}

// Whether all corners of triangle t lie in the plane of triangle s, exactly: coordinates are integers below 2^33.
bool vtkMTPieceBound::IsCoplanar(std::uint32_t t, std::uint32_t s) const
{
  using Integer = __int128;
  const auto difference = [](const Vector& a, const Vector& b)
  {
    return std::array<Integer, 3>{ static_cast<std::int64_t>(a[0] - b[0]), static_cast<std::int64_t>(a[1] - b[1]),
      static_cast<std::int64_t>(a[2] - b[2]) };
  };
  const Vector& origin = this->To.GetCorner(s, 0);
  const auto u = difference(this->To.GetCorner(s, 1), origin);
  const auto v = difference(this->To.GetCorner(s, 2), origin);
  const std::array<Integer, 3> normal{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0] };
  for (int c = 0; c < 3; ++c)
  {
    const auto w = difference(this->From.GetCorner(t, c), origin);
    if (w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2] != 0)
    {
      return false;
    }
  }
  return true;
}

double vtkMTPieceBound::Visit(const Vector& x, std::uint32_t triangle, std::uint32_t& guess)
{
  const auto getTruth = [&](const vtkMTSurface::Hit& hit)
  {
    // What rounding may have added must not raise the lower bound.
    return std::max(0.0, std::sqrt(hit.Distance2) - this->Slack) + this->Before[triangle] + this->After[hit.Triangle];
  };
  vtkMTSurface::Hit hit;
  if (guess != None)
  {
    hit = this->To.Project(x, guess);
    this->To.Descend(x, hit);
  }
  // Walking down may end in a place that is not the nearest: only the nearest one may raise the lower bound. A trial
  // does not, and asks no more than whether anything is near enough.
  const double enough = this->IsTrial ? this->GetEnough(0.0) : this->Result.LowerBound;
  if (guess != None && this->IsTrial && !this->Search && getTruth(hit) > enough)
  {
    const double reach = enough - this->Before[triangle] + this->Slack;
    const vtkMTSurface::Hit within = reach > 0.0 ? this->Tree.FindWithin(x, reach * reach) : vtkMTSurface::Hit();
    hit = within.Triangle == None ? hit : within;
  }
  else if (guess == None || getTruth(hit) > enough)
  {
    hit = this->Search ? this->Search(x, hit) : this->Tree.FindNearest(x, guess == None ? None : hit.Triangle);
    if (!this->IsTrial && !this->Tree.IsExhausted())
    {
      this->Result.LowerBound = std::max(this->Result.LowerBound, getTruth(hit));
    }
  }
  guess = hit.Triangle;
  return getTruth(hit);
}

// The largest bound that need not be improved.
double vtkMTPieceBound::GetEnough(double trueHere) const
{
  return std::max({ GetShare(this->Halvings, this->Share) * this->Result.LowerBound,
    vtkMTDeviation::Looseness * trueHere, 2.0 * this->Slack });
}

void vtkMTPieceBound::Credit(std::uint32_t from, std::uint32_t to, double bound)
{
  this->BoundOfTriangle[from] = std::max(this->BoundOfTriangle[from], bound);
  this->BoundOnTriangle[to] = std::max(this->BoundOnTriangle[to], bound);
  this->Result.UpperBound = std::max(this->Result.UpperBound, bound);
}

double vtkMTPieceBound::Raise(double distance, std::uint32_t t, std::uint32_t s) const
{
  const bool isZero = distance <= this->Slack && this->IsCoplanar(t, s);
  return isZero ? 0.0 : distance + this->Slack;
}

vtkMTPieceBound::Entry vtkMTPieceBound::MakeWhole(std::uint32_t triangle) const
{
  Entry whole;
  whole.Shape.Triangle = triangle;
  for (int c = 0; c < 3; ++c)
  {
    whole.Shape.Append(this->From.GetCorner(triangle, c));
  }
  whole.Guess = None;
  whole.IsNearest = false;
  return whole;
}

std::uint32_t vtkMTPieceBound::BoundNear(
  std::uint32_t triangle, std::uint32_t guess, std::uint32_t nearer, std::size_t& budget)
{
  Entry whole = this->MakeWhole(triangle);
  whole.Guess = nearer == None ? None : this->Over.Begin(triangle, nearer);
  if (nearer == None || !this->Over.HasBegun())
  {
    whole.Guess = this->Over.Begin(triangle, guess);
  }
  const std::uint32_t over = this->Over.HasBegun() ? whole.Guess : None;
  this->Improve(whole, whole.Guess);
  if (!this->Accept(whole, 0.0))
  {
    this->BoundPieces(whole, budget);
  }
  return over;
}

void vtkMTPieceBound::Bound(std::uint32_t triangle, const std::array<std::uint32_t, 3>& guesses, std::size_t& budget)
{
  Entry whole = this->MakeWhole(triangle);
  for (int c = 0; c < 3 && !this->IsNearEnough(whole.Best.Bound); ++c)
  {
    if (guesses[c] != None)
    {
      this->Improve(whole, guesses[c]);
    }
  }
  if (whole.Best.Triangle == None)
  {
    // All triangles of a hub are nearest to it, and most of them far from the rest of this one.
    int corner = 0;
    while (corner < 2 && this->From.IsHub(this->From.GetPoint(3 * triangle + static_cast<std::uint32_t>(corner))))
    {
      ++corner;
    }
    std::uint32_t nearest = None;
    this->Visit(whole.Shape.Corners[corner], triangle, nearest);
    this->Improve(whole, nearest);
  }
  if (!this->Accept(whole, 0.0))
  {
    // From one triangle of a hub to the one that lies below it may be far, past all the others.
    whole.Guess = this->TouchesHub(whole.Best.Triangle) ? None : whole.Best.Triangle;
    if (whole.Guess != None)
    {
      this->Over.Begin(triangle, whole.Guess);
    }
    this->BoundPieces(whole, budget);
  }
}

bool vtkMTPieceBound::TouchesHub(std::uint32_t s) const
{
  return this->To.IsHub(this->To.GetPoint(3 * s)) || this->To.IsHub(this->To.GetPoint(3 * s + 1)) ||
    this->To.IsHub(this->To.GetPoint(3 * s + 2));
}

// Holds the piece against one triangle: its largest corner distance.
void vtkMTPieceBound::Improve(Entry& entry, std::uint32_t s) const
{
  const Piece& piece = entry.Shape;
  const double added = static_cast<double>(this->Before[piece.Triangle]) + this->After[s];
  const double limit = entry.Best.Bound - added;
  if (!(limit > 0.0))
  {
    return;
  }
  double distance2 = 0.0;
  vtkMTSurface::Triangle made;
  const vtkMTSurface::Triangle& to = this->To.GetTriangle(s, made);
  for (int i = 0; i < piece.Count && distance2 < limit * limit; ++i)
  {
    distance2 = std::max(distance2, vtkMTSurface::GetDistance2(piece.Corners[i], to, limit * limit));
  }
  const double distance = this->Raise(std::sqrt(distance2), piece.Triangle, s);
  if (added + distance < entry.Best.Bound)
  {
    entry.Best = { added + distance, s, distance };
  }
}

bool vtkMTPieceBound::Accept(const Entry& entry, double trueHere)
{
  if (!this->IsNearEnough(entry.Best.Bound, trueHere))
  {
    return false;
  }
  this->CreditPiece(entry);
  return true;
}

void vtkMTPieceBound::CreditPiece(const Entry& entry)
{
  this->Credit(entry.Shape.Triangle, entry.Best.Triangle, entry.Best.Bound);
  const Credited credited{ entry.Shape.Triangle, entry.Best.Triangle, entry.Best.Distance };
  if (!this->PiecesCredited.empty() && this->PiecesCredited.back().From == credited.From &&
    this->PiecesCredited.back().To == credited.To)
  {
    double& distance = this->PiecesCredited.back().Distance;
    distance = std::max(distance, credited.Distance);
    return;
  }
  this->PiecesCredited.push_back(credited);
}

void vtkMTPieceBound::BoundPieces(const Entry& whole, std::size_t& budget)
{
  this->Stack.clear();
  this->Halvings = 0;
  if (!this->BoundCells(whole, budget))
  {
    this->Stack.push_back(whole);
  }
  while (!this->Stack.empty())
  {
    Entry& entry = this->Current;
    entry = this->Stack.back();
    this->Stack.pop_back();
    if (budget == 0 || entry.Shape.Depth >= MaximumDepth)
    {
      this->Result.BudgetUsedUp = true;
      this->CreditPiece(entry);
      continue;
    }
    --budget;
    ++this->Result.Pieces;
    this->BoundPiece(entry);
  }
  this->Halvings = 0;
}

// By the triangles of the other mesh that lie over the whole; what is not near enough to its own one is left as pieces.
// False where none are known to lie over all of it.
bool vtkMTPieceBound::BoundCells(const Entry& whole, std::size_t& budget)
{
  const std::uint32_t triangle = whole.Shape.Triangle;
  if (whole.Guess == None || !this->Over.Split())
  {
    return false;
  }
  Entry& entry = this->Current;
  entry.Shape.Triangle = triangle;
  entry.Shape.Depth = 1;
  for (const vtkMTCellsOver::Cell& cell : this->Over.GetCells())
  {
    budget -= budget > 0 ? 1 : 0;
    ++this->Result.Pieces;
    const double byHeight =
      static_cast<double>(this->Before[triangle]) + this->After[cell.Triangle] + cell.Height + this->Slack;
    if (this->IsOneSided && byHeight <= this->BoundOfTriangle[triangle])
    {
      continue;
    }
    this->Over.GetShape(cell, entry.Shape);
    entry.Best = whole.Best;
    entry.Guess = cell.Triangle;
    entry.IsNearest = false;
    this->Improve(entry, cell.Triangle);
    if (!this->Accept(entry, 0.0))
    {
      this->Stack.push_back(entry);
    }
  }
  return true;
}

bool vtkMTPieceBound::IsLeftOut(const Piece& piece) const
{
  if (!this->IsElsewhere)
  {
    return false;
  }
  return this->IsElsewhere(piece.GetMiddle(), piece.GetRadius());
}

// What is known by a place on a triangle; nothing where it does not count.
double vtkMTPieceBound::VisitPlace(const Vector& x, std::uint32_t triangle, std::uint32_t& guess)
{
  const double lowerBound = this->Result.LowerBound;
  const double trueHere = this->Visit(x, triangle, guess);
  if (trueHere > lowerBound && this->IsElsewhere && this->IsElsewhere(x, 0.0))
  {
    this->Result.LowerBound = lowerBound;
    return 0.0;
  }
  return trueHere;
}

double vtkMTPieceBound::VisitMiddle(Entry& entry)
{
  entry.IsNearest = true;
  return this->VisitPlace(entry.Shape.GetMiddle(), entry.Shape.Triangle, entry.Guess);
}

bool vtkMTPieceBound::GivesUp(const Entry& entry, double trueHere)
{
  if (!this->IsTrial || this->IsNearEnough(trueHere))
  {
    return false;
  }
  this->BoundOfTriangle[entry.Shape.Triangle] = std::numeric_limits<double>::infinity();
  this->Stack.clear();
  return true;
}

void vtkMTPieceBound::BoundPiece(Entry& entry)
{
  double trueHere = 0.0;
  if (entry.Guess == vtkMTTriangleTree::None)
  {
    trueHere = this->VisitMiddle(entry);
  }
  this->Improve(entry, entry.Guess);
  if (this->Accept(entry, trueHere) || this->IsLeftOut(entry.Shape) || this->CutAlong(entry))
  {
    return;
  }
  if (!entry.IsNearest)
  {
    trueHere = this->VisitMiddle(entry);
    this->Improve(entry, entry.Guess);
    if (this->GivesUp(entry, trueHere) || this->Accept(entry, trueHere) || this->CutAlong(entry))
    {
      return;
    }
  }
  this->Divide(entry);
}
