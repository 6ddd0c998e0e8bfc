// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDirectImprover.h"

#include "vtkMTRoundUp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Balls to look at per triangle of both meshes: many times what surfaces need. Of meshes that are stretched a million
// times every ball is near all others; sums stand then.
constexpr std::size_t EffortPerTriangle = 64;
using Ball = vtkMTBallGrid::Ball;

std::vector<Ball> GetBalls(const vtkMTDirectDeviation::Mesh& mesh, double wider)
{
  std::vector<Ball> balls(mesh.Surface.GetNumberOfTriangles());
  for (std::uint32_t t = 0; t < balls.size(); ++t)
  {
    balls[t] = vtkMTDirectImprover::GetBall(mesh.Surface, t, mesh.Known[t].FromInput + wider);
  }
  return balls;
}

// Around a triangle, and so much wider.
vtkMTBallGrid::Box GetBox(const vtkMTSurface& surface, std::uint32_t t, double wider)
{
  vtkMTBallGrid::Box box{ surface.GetCorner(t, 0), surface.GetCorner(t, 0), wider };
  for (int c = 1; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      box.Low[i] = std::min(box.Low[i], surface.GetCorner(t, c)[i]);
      box.High[i] = std::max(box.High[i], surface.GetCorner(t, c)[i]);
    }
  }
  return box;
}

// Triangles of a range of which more than limit is known, most first.
std::vector<std::uint32_t> SortAbove(const vtkMTDirectDeviation::Deviations& deviations,
  const vtkMTDirectDeviation::Range& range, float vtkMTTriangleDeviation::*direction, double limit)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t t = range.First; t < range.End; ++t)
  {
    if (deviations[t].*direction > limit)
    {
      order.push_back(t);
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return deviations[a].*direction > deviations[b].*direction; });
  return order;
}
}

//------------------------------------------------------------------------------
double vtkMTDirectImprover::GetLarger(const vtkMTTriangleDeviation& deviation)
{
  return std::max(deviation.ToInput, deviation.FromInput);
}

//------------------------------------------------------------------------------
Ball vtkMTDirectImprover::GetBall(const vtkMTSurface& surface, std::uint32_t t, double wider)
{
  return vtkMTDirectDeviation::GetBall(
    surface.GetCorner(t, 0), surface.GetCorner(t, 1), surface.GetCorner(t, 2), wider);
}

//------------------------------------------------------------------------------
bool vtkMTDirectImprover::IsWithin(const vtkMTSurface& surface, std::uint32_t t, const Vector& x, double reach)
{
  const double reach2 = reach * reach;
  const double limit = 2.0 * reach2 + std::numeric_limits<double>::min(); // farther need not be told exactly
  return surface.GetDistance2(x, t, limit) <= reach2;
}

//------------------------------------------------------------------------------
vtkMTDirectImprover::vtkMTDirectImprover(
  const Mesh& floor, const vtkMTSurface& fragment, const Mesh& finer, const State& state, Deviations& known)
  : Floor(floor)
  , Fragment(fragment)
  , Finer(finer)
  , Known(known)
  , Sought(state)
  , Slack(std::ldexp(std::max(fragment.GetExtent(), finer.Surface.GetExtent()), -40))
  , Up(fragment, finer.Surface, this->Slack, this->UpResult)
  , Down(finer.Surface, fragment, this->Slack, this->DownResult)
  , FinerBalls(GetBalls(finer, this->Slack))
  , Budget(vtkMTDeviation::PiecesPerTriangle * (fragment.GetNumberOfTriangles() + finer.Surface.GetNumberOfTriangles()))
  , MostEffort(EffortPerTriangle * (fragment.GetNumberOfTriangles() + finer.Surface.GetNumberOfTriangles()))
{
  this->UpResult.LowerBound = state.TrueDeviation;
  // What is split anyway may as well have a bound that does not decide again.
  this->Up.Share = state.IsLast ? 1.0 : state.Loose;
  this->Up.IsTrial = !state.IsLast;
  this->Down.Share = state.Loose;
  this->Down.IsTrial = !state.IsLast;
  for (std::size_t s = 0; s < finer.Known.size(); ++s)
  {
    this->Up.After[s] = finer.Known[s].ToInput;
    this->Down.Before[s] = finer.Known[s].FromInput;
  }
  this->Up.Search = [this](const Vector& x, const vtkMTSurface::Hit& guess) { return this->FindNearest(x, guess); };
}

//------------------------------------------------------------------------------
void vtkMTDirectImprover::ImproveToInput(const Range& range, double least)
{
  for (const std::uint32_t t :
    SortAbove(this->Known, range, &vtkMTTriangleDeviation::ToInput, std::max(least, this->GetLimit())))
  {
    float& known = this->Known[t].ToInput;
    if (known <= this->GetLimit() || this->IsExhausted())
    {
      break;
    }
    this->FindCandidates(t);
    if (!this->Candidates.empty())
    {
      this->Up.Bound(t, { None, None, None }, this->Budget);
      known = std::min(known, vtkMTRoundUp::ToFloat(this->Up.GetBoundOfTriangle()[t]));
    }
  }
  this->Sought.TrueDeviation = this->UpResult.LowerBound;
}

//------------------------------------------------------------------------------
void vtkMTDirectImprover::ImproveFromInput(const Range& range)
{
  std::vector<unsigned char> isBound(this->Finer.Surface.GetNumberOfTriangles(), 0);
  std::vector<std::uint32_t> handedOn;
  std::vector<unsigned char> isHanded(isBound.size(), 0);
  for (const std::uint32_t t : SortAbove(this->Known, range, &vtkMTTriangleDeviation::FromInput, this->GetLimit()))
  {
    const double known = this->Known[t].FromInput;
    if (known <= std::max(this->GetLimit(), this->Sought.Kept) || this->IsExhausted())
    {
      break;
    }
    this->FindCandidates(t);
    const double bound = this->BoundCandidates(t, isBound);
    if (this->Sought.IsLast)
    {
      this->Sought.Kept = std::max(this->Sought.Kept, std::min(bound, known));
    }
    if (bound < known)
    {
      handedOn.push_back(t);
      for (const std::uint32_t s : this->Candidates)
      {
        isHanded[s] = 1;
      }
    }
  }
  this->HandOn(handedOn, isHanded);
}

//------------------------------------------------------------------------------
double vtkMTDirectImprover::GetLimit() const
{
  return std::max(this->Sought.Loose * this->UpResult.LowerBound, 2.0 * this->Slack);
}

//------------------------------------------------------------------------------
// The finer triangles that are so near to t.
void vtkMTDirectImprover::FindCandidates(std::uint32_t t)
{
  const auto [place, isNew] = this->FoundBefore.try_emplace(t);
  if (!isNew)
  {
    this->Candidates = place->second;
    return;
  }
  const double known = GetLarger(this->Known[t]);
  this->Candidates.clear();
  this->FinerBalls.HasTouching(GetBox(this->Fragment, t, known),
    [&](std::uint32_t s)
    {
      ++this->Effort;
      const Ball& ball = this->FinerBalls.GetBall(s);
      if (IsWithin(this->Fragment, t, ball.Middle, known + ball.Radius))
      {
        this->Candidates.push_back(s);
      }
      return false;
    });
  place->second = this->Candidates;
}

//------------------------------------------------------------------------------
// The nearest of the candidates, or the guess.
vtkMTSurface::Hit vtkMTDirectImprover::FindNearest(const Vector& x, const vtkMTSurface::Hit& guess) const
{
  vtkMTSurface::Hit nearest = guess;
  Ball here{ x, std::sqrt(nearest.Distance2) };
  this->Effort += this->Candidates.size();
  for (const std::uint32_t s : this->Candidates)
  {
    if (vtkMTBallGrid::Touch(here, this->FinerBalls.GetBall(s)) &&
      this->Finer.Surface.GetDistance2(x, s, nearest.Distance2) < nearest.Distance2)
    {
      nearest = this->Finer.Surface.Project(x, s);
      here.Radius = std::sqrt(nearest.Distance2);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
// The largest of the candidates' bounds.
double vtkMTDirectImprover::BoundCandidates(std::uint32_t t, std::vector<unsigned char>& isBound)
{
  double bound = 0.0;
  for (const std::uint32_t s : this->Candidates)
  {
    if (!isBound[s])
    {
      isBound[s] = 1;
      this->BoundCandidate(s, t);
    }
    bound = std::max(bound, this->Down.GetBoundOfTriangle()[s]);
  }
  return bound;
}

//------------------------------------------------------------------------------
void vtkMTDirectImprover::BoundCandidate(std::uint32_t s, std::uint32_t t)
{
  const std::size_t credited = this->Down.GetCredited().size();
  const Vector& middle = this->FinerBalls.GetBall(s).Middle;
  vtkMTSurface::Hit below = this->Fragment.Project(middle, t);
  this->Fragment.Descend(middle, below);
  this->BoundAgain(s, below.Triangle);
  if (this->Down.GetBoundOfTriangle()[s] > this->GetLimit() && !this->IsExhausted())
  {
    this->Down.Forget(s, credited);
    const double reach = this->Finer.Known[s].FromInput + this->Slack;
    this->Down.IsElsewhere = [this, reach](const Vector& x, double radius) {
      return !this->IsNearFloor({ x, reach + radius });
    };
    this->BoundAgain(s, below.Triangle);
    this->Down.IsElsewhere = nullptr;
  }
}

//------------------------------------------------------------------------------
// What s is truly away says nothing of the fragment, as long as s may be another region's.
void vtkMTDirectImprover::BoundAgain(std::uint32_t s, std::uint32_t guess)
{
  this->DownResult.LowerBound = this->UpResult.LowerBound;
  this->Down.Bound(s, { guess, None, None }, this->Budget);
}

//------------------------------------------------------------------------------
// Whether a ball may hold a point of the input that stands on the floor.
bool vtkMTDirectImprover::IsNearFloor(const Ball& ball)
{
  if (!this->FloorBalls)
  {
    this->FloorBalls.emplace(GetBalls(this->Floor, 0.0));
  }
  return this->FloorBalls->HasTouching(ball,
    [&](std::uint32_t f)
    {
      ++this->Effort;
      return IsWithin(this->Floor.Surface, f, ball.Middle, ball.Radius + this->Floor.Known[f].FromInput);
    });
}

//------------------------------------------------------------------------------
// From these triangles of the fragment, whose points are on those of the finer mesh.
void vtkMTDirectImprover::HandOn(const std::vector<std::uint32_t>& handedOn, const std::vector<unsigned char>& isHanded)
{
  for (const std::uint32_t t : handedOn)
  {
    this->Known[t].FromInput = 0.0f;
  }
  for (const vtkMTPieceBound::Credited& piece : this->Down.GetCredited())
  {
    if (isHanded[piece.From])
    {
      float& known = this->Known[piece.To].FromInput;
      known = std::max(known, vtkMTRoundUp::ToFloat(this->Down.Before[piece.From] + piece.Distance));
    }
  }
}
