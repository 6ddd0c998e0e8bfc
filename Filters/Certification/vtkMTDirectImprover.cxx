// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDirectImprover.h"

#include "vtkMTRoundUp.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Balls to look at per triangle of both meshes: many times what surfaces need. Of meshes that are stretched a million
// times every ball is near all others; sums stand then.
constexpr std::size_t EffortPerTriangle = 64;

constexpr double LeastHeight = 0.25; // of a triangle that is not sharp, of its longest edge
using Ball = vtkMTBoxRuns::Ball;

std::vector<vtkMTBoxRuns::Box> GetBoxes(const vtkMTDirectDeviation::Mesh& mesh, double wider)
{
  std::vector<vtkMTBoxRuns::Box> boxes(mesh.Surface.GetNumberOfTriangles());
  for (std::uint32_t t = 0; t < boxes.size(); ++t)
  {
    boxes[t] = vtkMTBoxRuns::GetBox(mesh.Surface, t, mesh.Known[t].FromInput + wider);
  }
  return boxes;
}

// A triangle and how far from it places are, at least.
class Target
{
public:
  Target(const vtkMTSurface& surface, std::uint32_t triangle)
    : Shape(surface.GetTriangle(triangle, this->Made))
  {
    for (int e = 0; e < 3; ++e)
    {
      this->Lengths[e] =
        vtkMTVector::Norm(vtkMTVector::Subtract(this->Shape.Corners[(e + 1) % 3], this->Shape.Corners[e]));
    }
    const double longest = std::max({ this->Lengths[0], this->Lengths[1], this->Lengths[2] });
    this->IsSharp = this->Shape.TwiceArea < LeastHeight * longest * longest;
  }

  // Whether a place is so near, or a bit more at corners. Most are not, by the plane or by the line along an edge
  // alone.
  bool IsWithin(const vtkMTSurface::Vector& x, double reach) const
  {
    const double most = reach * (1.0 + 1e-9) + std::numeric_limits<double>::min();
    const vtkMTSurface::Vector way = vtkMTVector::Subtract(x, this->Shape.Corners[0]);
    const double area0 = vtkMTVector::Dot(way, this->Shape.Inward0);
    const double area2 = vtkMTVector::Dot(way, this->Shape.Inward2);
    const double area1 = this->Shape.TwiceArea - area0 - area2;
    if (this->Shape.TwiceArea > 0.0 &&
      (std::abs(vtkMTVector::Dot(way, this->Shape.Normal)) > most || area0 < -most * this->Lengths[0] ||
        area1 < -most * this->Lengths[1] || area2 < -most * this->Lengths[2]))
    {
      return false;
    }
    return !this->IsSharp || vtkMTSurface::GetDistance2(x, this->Shape, 2.0 * most * most) <= reach * reach;
  }

private:
  vtkMTSurface::Triangle Made;
  const vtkMTSurface::Triangle& Shape;
  std::array<double, 3> Lengths; // of its edges
  bool IsSharp;
};

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
  const FloorOf& floor, const vtkMTSurface& fragment, const Mesh& finer, const State& state, Deviations& known)
  : Floor(floor)
  , Fragment(fragment)
  , Finer(finer)
  , Known(known)
  , Sought(state)
  , Slack(std::ldexp(std::max(fragment.GetExtent(), finer.Surface.GetExtent()), -40))
  , Up(fragment, finer.Surface, this->Slack, this->UpResult)
  , Down(finer.Surface, fragment, this->Slack, this->DownResult)
  , FinerBoxes(GetBoxes(finer, this->Slack))
  , Budget(vtkMTDeviation::PiecesPerTriangle * (fragment.GetNumberOfTriangles() + finer.Surface.GetNumberOfTriangles()))
  , MostEffort(EffortPerTriangle * (fragment.GetNumberOfTriangles() + finer.Surface.GetNumberOfTriangles()))
{
  this->UpResult.LowerBound = state.TrueDeviation;
  // What is split anyway may as well have a bound that does not decide again.
  this->Up.Share = state.IsLast ? 1.0 : state.Loose;
  this->Up.IsTrial = !state.IsLast;
  this->Up.IsOneSided = true;
  this->Down.Share = state.Loose;
  this->Down.IsTrial = !state.IsLast;
  for (std::size_t s = 0; s < finer.Known.size(); ++s)
  {
    this->Up.After[s] = finer.Known[s].ToInput;
    this->Down.Before[s] = finer.Known[s].FromInput;
  }
  this->Down.IsElsewhere = [this](const Vector& x, double radius) {
    return !this->IsExhausted() && !this->IsNearFloor({ x, this->Reach + radius });
  };
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
    const std::uint32_t over = this->FindOver(t);
    if (over != None)
    {
      this->Searched = t;
      this->HasCandidates = false;
      this->Up.BoundNear(t, over, None, this->Budget);
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
    this->FindCandidates(t, known);
    const double bound = this->BoundCandidates(t, known, isBound);
    if (this->Sought.IsLast)
    {
      this->Sought.Kept = std::max(this->Sought.Kept, std::min(bound, known));
    }
    if (bound < known)
    {
      handedOn.push_back(t);
      for (const Candidate& candidate : this->Candidates)
      {
        isHanded[candidate.Triangle] = 1;
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
// The finer triangles that, with what stands on them, are so near to t.
void vtkMTDirectImprover::FindCandidates(std::uint32_t t, double known)
{
  this->Candidates.clear();
  const Target target(this->Fragment, t);
  const vtkMTBoxRuns::Box around = vtkMTBoxRuns::GetBox(this->Fragment, t, known);
  this->FinerBoxes.HasTouched(
    around, [&](const vtkMTBoxRuns::Box& box) { return vtkMTBoxRuns::Touch(around, box); },
    [&](std::uint32_t s)
    {
      ++this->Effort;
      const Ball ball = this->GetBallOfFiner(s);
      if (target.IsWithin(ball.Middle, known + ball.Radius))
      {
        this->Candidates.push_back({ ball, s });
      }
      return false;
    });
}

//------------------------------------------------------------------------------
// Around the box of a finer triangle, and what stands on that.
Ball vtkMTDirectImprover::GetBallOfFiner(std::uint32_t s) const
{
  const double wider = this->Finer.Known[s].FromInput + this->Slack;
  const vtkMTBoxRuns::Box& box = this->FinerBoxes.GetBox(s);
  Ball ball;
  double half2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    ball.Middle[i] = 0.5 * (box.Low[i] + box.High[i]);
    const double half = 0.5 * (box.High[i] - box.Low[i]) - wider;
    half2 += half * half;
  }
  ball.Radius = std::sqrt(half2) + wider;
  return ball;
}

//------------------------------------------------------------------------------
// A finer triangle about as near to the middle of t as the input is: from there the way is not far.
std::uint32_t vtkMTDirectImprover::FindOver(std::uint32_t t) const
{
  const Ball ball{ GetBall(this->Fragment, t, 0.0).Middle, this->Known[t].ToInput };
  std::uint32_t over = None;
  this->FinerBoxes.HasTouched(
    vtkMTBoxRuns::GetBox(ball), [&](const vtkMTBoxRuns::Box& box) { return vtkMTBoxRuns::Touch(box, ball); },
    [&](std::uint32_t s)
    {
      over = s;
      return true;
    });
  return over;
}

//------------------------------------------------------------------------------
// The nearest of the candidates, or the guess; without either something near. Where looking has taken too long already,
// the guess: it then tells nothing of the truth, and the triangle is given up.
vtkMTSurface::Hit vtkMTDirectImprover::FindNearest(const Vector& x, const vtkMTSurface::Hit& guess)
{
  const auto getAny = [&] { return this->Finer.Surface.Project(x, this->FinerBoxes.FindNear(x)); };
  if (this->IsExhausted())
  {
    this->Up.IsTrial = true;
    return guess.Triangle == None ? getAny() : guess;
  }
  if (!this->HasCandidates)
  {
    this->FindCandidates(this->Searched, this->Known[this->Searched].ToInput);
    this->HasCandidates = true;
  }
  std::uint32_t nearest = guess.Triangle;
  double nearest2 = guess.Distance2;
  Ball here{ x, std::sqrt(nearest2) };
  this->Effort += this->Candidates.size();
  for (const auto& [ball, s] : this->Candidates)
  {
    if (!vtkMTBoxRuns::Touch(here, ball))
    {
      continue;
    }
    const double distance2 = this->Finer.Surface.GetDistance2(x, s, nearest2);
    if (distance2 < nearest2)
    {
      nearest = s;
      nearest2 = distance2;
      here.Radius = std::sqrt(distance2);
    }
  }
  if (nearest == None)
  {
    return getAny();
  }
  return nearest == guess.Triangle ? guess : this->Finer.Surface.Project(x, nearest);
}

//------------------------------------------------------------------------------
// The largest of the candidates' bounds, or the first that is found to be known or more.
double vtkMTDirectImprover::BoundCandidates(std::uint32_t t, double known, std::vector<unsigned char>& isBound)
{
  double bound = 0.0;
  for (const Candidate& candidate : this->Candidates)
  {
    bound = std::max(bound, isBound[candidate.Triangle] ? this->Down.GetBoundOfTriangle()[candidate.Triangle] : 0.0);
  }
  this->LastOver = None;
  for (std::size_t i = 0; i < this->Candidates.size() && bound < known; ++i)
  {
    const std::uint32_t s = this->Candidates[i].Triangle;
    if (!isBound[s])
    {
      isBound[s] = 1;
      this->BoundCandidate(s, t);
      bound = std::max(bound, this->Down.GetBoundOfTriangle()[s]);
    }
  }
  return bound;
}

//------------------------------------------------------------------------------
// What s is truly away says nothing of the fragment, as long as s may be another region's.
void vtkMTDirectImprover::BoundCandidate(std::uint32_t s, std::uint32_t t)
{
  this->DownResult.LowerBound = this->UpResult.LowerBound;
  this->Reach = this->Finer.Known[s].FromInput + this->Slack;
  this->LastOver = this->Down.BoundNear(s, t, this->LastOver, this->Budget);
}

//------------------------------------------------------------------------------
// Whether a ball may hold a point of the input that stands on the floor.
bool vtkMTDirectImprover::IsNearFloor(const Ball& ball)
{
  if (!this->Floor.Boxes)
  {
    this->Floor.Boxes.emplace(GetBoxes(this->Floor.Triangles, 0.0));
  }
  const auto isNear = [&](std::uint32_t f)
  {
    ++this->Effort;
    this->LastNearFloor = f;
    const double reach = ball.Radius + this->Floor.Triangles.Known[f].FromInput;
    return IsWithin(this->Floor.Triangles.Surface, f, ball.Middle, reach);
  };
  const auto touches = [&](const vtkMTBoxRuns::Box& box) { return vtkMTBoxRuns::Touch(box, ball); };
  return (touches(this->Floor.Boxes->GetBox(this->LastNearFloor)) && isNear(this->LastNearFloor)) ||
    this->Floor.Boxes->HasTouched(vtkMTBoxRuns::GetBox(ball), touches, isNear);
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
