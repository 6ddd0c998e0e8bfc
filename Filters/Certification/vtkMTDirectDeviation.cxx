// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDirectDeviation.h"

#include "vtkMTDirectImprover.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
constexpr std::size_t Probes = 16; // triangles by which the largest true deviation is found
// Of a fragment, until what is near one part is small enough. Where sums are so large that everything is near every
// triangle, as of thousands of components that lie apart, halving does not help.
constexpr int MostHalvings = 6;
using Ball = vtkMTBoxRuns::Ball;
using Deviations = vtkMTDirectDeviation::Deviations;
using Improver = vtkMTDirectImprover;

// What all but so many triangles have at most, and what the largest has.
double FindLargest(const Deviations& deviations, std::size_t but)
{
  std::vector<double> known(deviations.size());
  std::transform(deviations.begin(), deviations.end(), known.begin(), Improver::GetLarger);
  const auto place = known.begin() + static_cast<std::ptrdiff_t>(std::min(but, known.size() - 1));
  std::nth_element(known.begin(), place, known.end(), std::greater<>());
  return *place;
}

// A fragment beside finer meshes.
class Passes
{
public:
  Passes(const vtkMTDirectDeviation::Mesh& floor, const vtkMTSurface& fragment, const vtkMTPoint& origin,
    const vtkMTDirectDeviation::Collect& collect, Deviations& known)
    : Floor(floor)
    , Fragment(fragment)
    , Origin(origin)
    , Collect(collect)
    , Known(known)
  {
  }

  bool Run(const vtkMTDirectDeviation::Aim& aim, std::string& error)
  {
    this->State.Loose = aim.Looseness;
    this->LeastFloor = aim.LeastFloor;
    if (!this->Probe(aim.LevelsBelow, error))
    {
      return false;
    }
    // Most sums need not be held against the finest mesh: a coarser one makes them small enough, at less effort.
    constexpr std::size_t near = vtkMTDirectDeviation::NearLevels;
    return (aim.LevelsBelow <= near || this->Improve(near, false, error)) &&
      this->Improve(aim.LevelsBelow, true, error);
  }

private:
  using Use = std::function<void(Improver&, const Improver::Range&)>;

  // Finds the largest true deviation by the triangles with the largest sums to the input.
  bool Probe(std::size_t levelsBelow, std::string& error)
  {
    Deviations toInput = this->Known;
    for (vtkMTTriangleDeviation& deviation : toInput)
    {
      deviation.FromInput = 0.0f;
    }
    this->Least = std::nextafter(FindLargest(toInput, Probes), 0.0); // several may have the same
    const auto probe = [this](Improver& improver, const Improver::Range& range)
    {
      improver.ImproveToInput(range, this->Least);
      this->State = improver.GetState();
    };
    return this->ForParts(levelsBelow, toInput, probe, error);
  }

  // Of the triangles that have more than what is near enough.
  bool Improve(std::size_t levelsBelow, bool isLast, std::string& error)
  {
    this->Least = this->State.Loose * this->State.TrueDeviation;
    if (!(this->Least > 0.0) || this->Least >= FindLargest(this->Known, 0))
    {
      return true;
    }
    this->State.IsLast = isLast;
    const auto improve = [this](Improver& improver, const Improver::Range& range)
    {
      improver.ImproveToInput(range, 0.0);
      improver.ImproveFromInput(range);
      if (this->State.IsLast)
      {
        this->State = improver.GetState();
        this->Least = this->State.Loose * this->State.TrueDeviation;
      }
    };
    return this->ForParts(levelsBelow, this->Known, improve, error);
  }

  // Does something with the triangles of which `known` is more than least, beside a finer mesh; part by part where what
  // is near of that would be too large.
  bool ForParts(std::size_t levelsBelow, const Deviations& known, const Use& use, std::string& error)
  {
    struct Part
    {
      Improver::Range Of;
      int Halvings;
    };
    std::vector<Part> parts{ { { 0, static_cast<std::uint32_t>(known.size()) }, 0 } };
    while (!parts.empty())
    {
      const auto [range, halvings] = parts.back();
      parts.pop_back();
      vtkMTDirectDeviation::FinerPart part;
      part.Most =
        vtkMTDirectDeviation::MostPerTriangle * std::max(this->LeastFloor, this->Floor.Surface.GetNumberOfTriangles());
      if (!this->Collect({ { this->Fragment, known }, range, this->Least }, levelsBelow, part, error))
      {
        return false;
      }
      const bool isTooLarge = part.Mesh.Triangles.size() > part.Most;
      if (isTooLarge && range.End - range.First > 1 && halvings < MostHalvings)
      {
        const std::uint32_t middle = range.First + (range.End - range.First) / 2;
        parts.push_back({ { middle, range.End }, halvings + 1 });
        parts.push_back({ { range.First, middle }, halvings + 1 });
      }
      else if (!isTooLarge && !part.Mesh.Triangles.empty())
      {
        const vtkMTSurface surface(part.Mesh, this->Origin, vtkMTSurface::Planes::MadeWhenAsked);
        Improver improver(
          { this->Floor, this->FloorBoxes }, this->Fragment, { surface, part.Known }, this->State, this->Known);
        use(improver, range);
      }
    }
    return true;
  }

  const vtkMTDirectDeviation::Mesh Floor;
  std::optional<vtkMTBoxRuns> FloorBoxes; // around each triangle and what stands on it
  const vtkMTSurface& Fragment;
  const vtkMTPoint& Origin;
  const vtkMTDirectDeviation::Collect& Collect;
  Deviations& Known;
  Improver::State State{ 1.0 };
  double Least = 0.0; // of what is known of triangles that are looked at
  std::size_t LeastFloor = 0;
};
}

//------------------------------------------------------------------------------
vtkMTBoxRuns::Ball vtkMTDirectDeviation::GetBall(
  const vtkMTSurface::Vector& a, const vtkMTSurface::Vector& b, const vtkMTSurface::Vector& c, double wider)
{
  Ball ball;
  double diagonal2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const auto [low, high] = std::minmax({ a[i], b[i], c[i] });
    ball.Middle[i] = 0.5 * (low + high);
    diagonal2 += (high - low) * (high - low);
  }
  ball.Radius = 0.5 * std::sqrt(diagonal2) + wider;
  return ball;
}

//------------------------------------------------------------------------------
vtkMTDirectDeviation::Neighbourhood::Neighbourhood(const Mesh& fragment, const Range& range, double least)
  : Fragment(fragment)
{
  std::vector<vtkMTBoxRuns::Box> boxes;
  for (std::uint32_t t = range.First; t < range.End; ++t)
  {
    const double known = vtkMTDirectImprover::GetLarger(fragment.Known[t]);
    if (known > least)
    {
      this->Triangles.push_back(t);
      boxes.push_back(vtkMTBoxRuns::GetBox(fragment.Surface, t, known));
    }
  }
  this->Boxes.emplace(std::move(boxes));
}

//------------------------------------------------------------------------------
bool vtkMTDirectDeviation::Neighbourhood::Touches(const Ball& ball) const
{
  const auto touches = [&](const vtkMTBoxRuns::Box& box) { return vtkMTBoxRuns::Touch(box, ball); };
  const auto accept = [&](std::uint32_t i)
  {
    const std::uint32_t t = this->Triangles[i];
    this->Last = i;
    return vtkMTDirectImprover::IsWithin(
      this->Fragment.Surface, t, ball.Middle, ball.Radius + vtkMTDirectImprover::GetLarger(this->Fragment.Known[t]));
  };
  const bool isNearLast =
    this->Last < this->Triangles.size() && touches(this->Boxes->GetBox(this->Last)) && accept(this->Last);
  return isNearLast || this->Boxes->HasTouched(vtkMTBoxRuns::GetBox(ball), touches, accept);
}

//------------------------------------------------------------------------------
bool vtkMTDirectDeviation::Improve(const Mesh& floor, const vtkMTSurface& fragment, const vtkMTPoint& origin,
  const Aim& aim, const Collect& collect, Deviations& deviations, std::string& error)
{
  return Passes(floor, fragment, origin, collect, deviations).Run(aim, error);
}
