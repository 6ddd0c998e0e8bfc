// SPDX-License-Identifier: BSD-3-Clause
// How pieces are split.
#include "vtkMTPieceBound.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <limits>

using namespace vtkMTVector;

namespace
{
// What is split off at a corner must be so much of the piece's diagonal; places on its sides are found to so much of
// them.
constexpr double LeastPart = 1.0 / 16.0;
constexpr double LeastStep = 1.0 / 2048.0;

std::uint32_t GetTriangle(std::uint32_t halfedge)
{
  return halfedge == vtkMTSurface::None ? halfedge : halfedge / 3;
}
}

// Splits the piece along the edges of the guessed triangle, seen along its normal. What lies outside an edge belongs to
// the triangle behind that edge, as a guess. False when the piece is not partly over the triangle, or has too many
// corners.
bool vtkMTPieceBound::CutAlong(const Entry& entry)
{
  const Vector normal = this->To.GetNormal(entry.Guess);
  if (!(Dot(normal, normal) > 0.0) || entry.Shape.Count + 3 > Piece::Capacity)
  {
    return false;
  }
  const std::size_t before = this->Stack.size();
  Piece rest = entry.Shape;
  for (int e = 0; e < 3; ++e)
  {
    const Vector& a = this->To.GetCorner(entry.Guess, e);
    const Vector inward = Cross(normal, Subtract(this->To.GetCorner(entry.Guess, (e + 1) % 3), a));
    Piece inside;
    Piece outside;
    if (rest.Split(a, inward, this->Slack, inside, outside))
    {
      this->Push(
        outside, entry.Best, GetTriangle(this->To.GetOpposite(3 * entry.Guess + static_cast<std::uint32_t>(e))));
      rest = inside;
    }
    else if (inside.Count == 0)
    {
      this->Stack.resize(before); // nothing of it is over the triangle
      return false;
    }
  }
  if (this->Stack.size() == before)
  {
    return false; // all of it is
  }
  this->Push(rest, entry.Best, entry.Guess);
  return true;
}

void vtkMTPieceBound::Push(const Piece& shape, const Match& best, std::uint32_t guess)
{
  this->Stack.emplace_back();
  Entry& entry = this->Stack.back();
  entry.Shape = shape;
  entry.Best = best;
  entry.Guess = guess;
  entry.IsNearest = false;
}

// By what is near its corners, else in halves.
void vtkMTPieceBound::Divide(Entry& entry)
{
  double trueHere = 0.0;
  std::array<double, Piece::Capacity> trueAt;
  std::array<std::uint32_t, Piece::Capacity> nearest;
  for (int i = 0; i < entry.Shape.Count && !this->IsElsewhere; ++i)
  {
    nearest[i] = entry.Guess;
    trueAt[i] = this->VisitPlace(entry.Shape.Corners[i], entry.Shape.Triangle, nearest[i]);
    trueHere = std::max(trueHere, trueAt[i]);
  }
  if (this->GivesUp(entry, trueHere) || this->Accept(entry, trueHere))
  {
    return;
  }
  if (!this->IsElsewhere)
  {
    const Piece::Diagonal longest = entry.Shape.GetDiagonal();
    for (const int corner : { longest.From, longest.To })
    {
      if (this->SplitOffWithinReach(entry, corner, nearest[corner], this->GetEnough(trueAt[corner])))
      {
        return;
      }
    }
  }
  ++this->Halvings;
  Piece one;
  Piece other;
  if (entry.Shape.Halve(this->Slack, one, other))
  {
    this->Push(one, entry.Best, entry.Guess);
    this->Push(other, entry.Best, entry.Guess);
    return;
  }
  this->CreditPiece(entry); // too small to be split
}

// Splits off what is near enough to the triangle nearest to a corner: distances to one triangle are convex, so that is
// all between corners and places on the sides which are near enough. False where that is little of the piece.
bool vtkMTPieceBound::SplitOffWithinReach(const Entry& entry, int corner, std::uint32_t nearest, double reach)
{
  const Piece& piece = entry.Shape;
  const double distance = reach - this->Before[piece.Triangle] - this->After[nearest] - this->Slack;
  const double distance2 = distance * distance;
  vtkMTSurface::Triangle made;
  const vtkMTSurface::Triangle& to = this->To.GetTriangle(nearest, made);
  const auto isWithin = [&](const Vector& x)
  { return distance > 0.0 && vtkMTSurface::GetDistance2(x, to, std::numeric_limits<double>::infinity()) <= distance2; };
  if (!isWithin(piece.Corners[corner]))
  {
    return false;
  }
  const auto wrap = [&](int i) { return (i + piece.Count) % piece.Count; };
  Piece::Chord chord{ corner, 1, {}, {} };
  while (chord.Count < piece.Count && isWithin(piece.Corners[wrap(chord.First + chord.Count)]))
  {
    ++chord.Count;
  }
  while (chord.Count < piece.Count && isWithin(piece.Corners[wrap(chord.First - 1)]))
  {
    chord.First = wrap(chord.First - 1);
    ++chord.Count;
  }
  if (chord.Count == piece.Count)
  {
    this->CreditBy(entry, piece, nearest);
    return true;
  }
  const auto findLast = [&](int from, int to)
  {
    double last = 0.0;
    for (double step = 0.5; step > LeastStep; step *= 0.5)
    {
      last += isWithin(Lerp(piece.Corners[from], piece.Corners[to], last + step)) ? step : 0.0;
    }
    return Lerp(piece.Corners[from], piece.Corners[to], last);
  };
  const int end = wrap(chord.First + chord.Count - 1);
  chord.Before = findLast(chord.First, wrap(chord.First - 1));
  chord.After = findLast(end, wrap(end + 1));
  // Along a side of the piece there may be nothing more within reach: then what is left is the piece once more.
  const auto [less, more] = std::minmax(
    { Norm(Subtract(chord.Before, piece.Corners[chord.First])), Norm(Subtract(chord.After, piece.Corners[end])) });
  const double toMiddle = Norm(Subtract(Lerp(chord.Before, chord.After, 0.5), piece.Corners[corner]));
  const double way = chord.Count > 1 ? more : less > 0.0 ? toMiddle : 0.0;
  Piece part;
  Piece rest;
  if (way * way < LeastPart * LeastPart * piece.GetDiagonal().Length2 || !piece.SplitOff(chord, part, rest))
  {
    return false;
  }
  this->CreditBy(entry, part, nearest);
  this->Push(rest, entry.Best, nearest);
  return true;
}

// A part of a piece, held against one triangle more.
void vtkMTPieceBound::CreditBy(const Entry& whole, const Piece& part, std::uint32_t s)
{
  Entry entry{ part, whole.Best, s, false };
  this->Improve(entry, s);
  this->CreditPiece(entry);
}
