// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDeviation.h"

#include "vtkMTOverlay.h"
#include "vtkMTPieceBound.h"
#include "vtkMTRoundUp.h"
#include "vtkMTSurface.h"
#include "vtkMTTriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t None = vtkMTSurface::None;
using Place = vtkMTOverlay::Place;

// A triangle with the bound that it would have.
struct Doubtful
{
  double Bound;
  std::uint32_t Triangle;
  bool operator<(const Doubtful& other) const
  {
    return this->Bound != other.Bound ? this->Bound > other.Bound : this->Triangle < other.Triangle;
  }
};

class Certifier
{
public:
  Certifier(const vtkMTSurface& floor, const vtkMTSurface& fragment, vtkMTDeviation& result)
    : Floor(floor)
    , Fragment(fragment)
    , Result(result)
    , Slack(std::ldexp(std::max(floor.GetExtent(), fragment.GetExtent()), -40))
    , Down(floor, fragment, this->Slack, result)
    , Up(fragment, floor, this->Slack, result)
    , Places(floor.GetNumberOfPoints())
    , BoundByCells(fragment.GetNumberOfTriangles(), 0.0)
    , FloorTriangle(fragment.GetNumberOfTriangles(), None)
    , IsDownByCells(floor.GetNumberOfTriangles(), 0)
    , IsUpByCells(fragment.GetNumberOfTriangles(), 0)
    , Budget(vtkMTDeviation::PiecesPerTriangle * (floor.GetNumberOfTriangles() + fragment.GetNumberOfTriangles()))
  {
  }

  void Run(const vtkMTDeviation::Relation& relation, vtkMTDeviation::Findings& findings)
  {
    for (std::size_t t = 0; t < relation.FloorDeviations.size(); ++t)
    {
      this->Down.Before[t] = relation.FloorDeviations[t].FromInput;
      this->Up.After[t] = relation.FloorDeviations[t].ToInput;
    }
    this->PlacePoints(relation.Heirs);
    this->CheckFarthestPoint();
    vtkMTOverlay overlay(this->Floor, this->Fragment, this->Places);
    this->BoundFloor(overlay);
    this->BoundFragment(overlay.FindCovered());
    this->Gather(findings);
    if (findings.KeepPairs)
    {
      this->GatherPairs(overlay, findings.Pairs);
    }
  }

private:
  // Where the floor's points go on the fragment: near their heirs, else to the nearest triangle.
  void PlacePoints(const std::vector<std::uint32_t>& heirs)
  {
    for (std::uint32_t p = 0; p < this->Places.size(); ++p)
    {
      const std::uint32_t out = this->Floor.GetHalfedge(p);
      if (out == None)
      {
        continue;
      }
      const vtkMTSurface::Vector& x = this->Floor.GetPlace(out);
      const std::uint32_t heir = heirs.empty() ? None : heirs[p];
      const std::uint32_t near = heir == None ? None : this->Fragment.GetHalfedge(heir);
      Place& place = this->Places[p];
      if (near == None)
      {
        place = this->MakePlace(x, this->Down.FindNearest(x, None));
      }
      else if (this->Fragment.GetPlace(near) == x)
      {
        place = { near / 3, heir, 0.0, x };
      }
      else if (this->Fragment.IsHub(heir))
      {
        place = this->MakePlace(x, this->Down.FindNearest(x, near / 3));
      }
      else
      {
        place = this->MakePlace(x, this->Fragment.FindAround(x, near));
      }
    }
  }

  Place MakePlace(const vtkMTSurface::Vector& x, const vtkMTSurface::Hit& hit) const
  {
    for (int c = 0; c < 3; ++c)
    {
      if (this->Fragment.GetCorner(hit.Triangle, c) == x)
      {
        return { hit.Triangle, this->Fragment.GetPoint(3 * hit.Triangle + c), 0.0, x };
      }
    }
    return { hit.Triangle, None, std::sqrt(hit.Distance2), hit.Place };
  }

  // The lower bound to begin with: what is true at the point that is farthest, where that is not only far from where it
  // was looked for.
  void CheckFarthestPoint()
  {
    for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
    {
      std::uint32_t farthest = None;
      for (std::uint32_t p = 0; p < this->Places.size(); ++p)
      {
        if (this->Places[p].Triangle != None &&
          (farthest == None || this->GetDistanceFromPlace(p) > this->GetDistanceFromPlace(farthest)))
        {
          farthest = p;
        }
      }
      if (farthest == None)
      {
        return;
      }
      const std::uint32_t out = this->Floor.GetHalfedge(farthest);
      Place& place = this->Places[farthest];
      const double distance = this->GetDistanceFromPlace(farthest);
      std::uint32_t guess = place.Triangle;
      const double here = this->Down.Visit(this->Floor.GetPlace(out), out / 3, guess);
      if (distance <= vtkMTDeviation::Looseness * here || guess == place.Triangle)
      {
        return;
      }
      place = this->MakePlace(this->Floor.GetPlace(out), this->Fragment.Project(this->Floor.GetPlace(out), guess));
    }
  }

  double GetDistanceFromPlace(std::uint32_t p) const
  {
    return this->Places[p].Distance + this->Down.Before[this->Floor.GetHalfedge(p) / 3];
  }

  void BoundFloor(vtkMTOverlay& overlay)
  {
    std::vector<Doubtful> doubtful;
    for (std::uint32_t t = 0; t < this->Floor.GetNumberOfTriangles(); ++t)
    {
      const double bound = this->RaiseCells(t, overlay);
      if (this->IsAcceptable(bound))
      {
        this->CreditCells(t, overlay);
      }
      else
      {
        doubtful.push_back({ bound, t });
      }
    }
    std::sort(doubtful.begin(), doubtful.end());
    for (const Doubtful& entry : doubtful)
    {
      const std::uint32_t t = entry.Triangle;
      if (this->IsAcceptable(entry.Bound))
      {
        this->CreditCells(t, overlay);
        continue;
      }
      std::array<std::uint32_t, 3> guesses;
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        // Of a hub's triangles any one is as near to it as the others, and most are far from this one.
        const std::uint32_t p = this->Floor.GetPoint(3 * t + c);
        guesses[c] = this->Floor.IsHub(p) ? None : this->Places[p].Triangle;
      }
      ++this->Result.TrianglesByPieces;
      this->Down.Bound(t, guesses, this->Budget);
    }
  }

  // Rounds the cells' distances up, notes what they say of the fragment's triangles, and gives the bound of t.
  double RaiseCells(std::uint32_t t, vtkMTOverlay& overlay)
  {
    const std::uint32_t end = overlay.FirstCell[t + 1];
    double bound = overlay.FirstCell[t] < end ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::uint32_t c = overlay.FirstCell[t]; c < end; ++c)
    {
      vtkMTOverlay::Cell& cell = overlay.Cells[c];
      cell.Distance = cell.Distance > 0.0 ? this->Down.Raise(cell.Distance, t, cell.Triangle) : 0.0;
      if (cell.CoversFloor)
      {
        bound = std::max(bound, this->Down.Before[t] + cell.Distance);
      }
      if (cell.CoversFragment)
      {
        double& back = this->BoundByCells[cell.Triangle];
        back = std::max(back, this->Up.After[t] + cell.Distance);
        this->FloorTriangle[cell.Triangle] = t;
      }
    }
    return bound;
  }

  void CreditCells(std::uint32_t t, const vtkMTOverlay& overlay)
  {
    for (std::uint32_t c = overlay.FirstCell[t]; c < overlay.FirstCell[t + 1]; ++c)
    {
      const vtkMTOverlay::Cell& cell = overlay.Cells[c];
      if (cell.CoversFloor)
      {
        this->Down.Credit(t, cell.Triangle, this->Down.Before[t] + cell.Distance);
      }
    }
    this->IsDownByCells[t] = 1;
  }

  bool IsAcceptable(double bound) const
  {
    return bound <= std::max(vtkMTDeviation::Looseness * this->Result.LowerBound, 2.0 * this->Slack);
  }

  void BoundFragment(const std::vector<unsigned char>& isCovered)
  {
    std::vector<Doubtful> doubtful;
    for (std::uint32_t s = 0; s < this->Fragment.GetNumberOfTriangles(); ++s)
    {
      const bool isBound = isCovered[s] && this->FloorTriangle[s] != None;
      const double bound = isBound ? this->BoundByCells[s] : std::numeric_limits<double>::infinity();
      if (this->IsAcceptable(bound))
      {
        this->CreditFragment(s, bound);
      }
      else
      {
        doubtful.push_back({ bound, s });
      }
    }
    std::sort(doubtful.begin(), doubtful.end());
    for (const Doubtful& entry : doubtful)
    {
      const std::uint32_t s = entry.Triangle;
      if (this->IsAcceptable(entry.Bound))
      {
        this->CreditFragment(s, entry.Bound);
        continue;
      }
      ++this->Result.TrianglesByPieces;
      this->Up.Bound(s, { this->FloorTriangle[s], None, None }, this->Budget);
    }
  }

  void CreditFragment(std::uint32_t s, double bound)
  {
    this->Up.Credit(s, this->FloorTriangle[s], bound);
    this->IsUpByCells[s] = 1;
  }

  // What the bounds were taken of: cells, and where these were not good enough the pieces.
  void GatherPairs(const vtkMTOverlay& overlay, std::vector<vtkMTDeviation::Pair>& pairs) const
  {
    pairs.reserve(overlay.Cells.size() + this->Down.GetCredited().size() + this->Up.GetCredited().size());
    for (std::uint32_t t = 0; t < this->Floor.GetNumberOfTriangles(); ++t)
    {
      for (std::uint32_t c = overlay.FirstCell[t]; c < overlay.FirstCell[t + 1]; ++c)
      {
        const vtkMTOverlay::Cell& cell = overlay.Cells[c];
        const bool isDown = cell.CoversFloor && this->IsDownByCells[t];
        const bool isUp = cell.CoversFragment && this->IsUpByCells[cell.Triangle];
        if (isDown || isUp)
        {
          pairs.push_back({ t, cell.Triangle, vtkMTRoundUp::ToFloat(cell.Distance), isDown, isUp });
        }
      }
    }
    for (const vtkMTPieceBound::Credited& piece : this->Down.GetCredited())
    {
      pairs.push_back({ piece.From, piece.To, vtkMTRoundUp::ToFloat(piece.Distance), true, false });
    }
    for (const vtkMTPieceBound::Credited& piece : this->Up.GetCredited())
    {
      pairs.push_back({ piece.To, piece.From, vtkMTRoundUp::ToFloat(piece.Distance), false, true });
    }
  }

  void Gather(vtkMTDeviation::Findings& findings)
  {
    findings.Deviations.resize(this->Fragment.GetNumberOfTriangles());
    for (std::size_t s = 0; s < findings.Deviations.size(); ++s)
    {
      vtkMTTriangleDeviation& deviation = findings.Deviations[s];
      deviation.ToInput = vtkMTRoundUp::ToFloat(this->Up.GetBoundOfTriangle()[s]);
      deviation.FromInput = vtkMTRoundUp::ToFloat(this->Down.GetBoundOnTriangle()[s]);
      this->Result.UpperBound =
        std::max({ this->Result.UpperBound, double(deviation.ToInput), double(deviation.FromInput) });
    }
    findings.FloorTriangle = std::move(this->FloorTriangle);
    findings.Places.resize(this->Places.size());
    std::transform(this->Places.begin(), this->Places.end(), findings.Places.begin(),
      [](const Place& place) { return place.Triangle; });
  }

  static constexpr int MaximumAttempts = 8;

  const vtkMTSurface& Floor;
  const vtkMTSurface& Fragment;
  vtkMTDeviation& Result;
  const double Slack;
  vtkMTPieceBound Down;
  vtkMTPieceBound Up;
  std::vector<Place> Places;
  std::vector<double> BoundByCells;         // [fragment's triangles]
  std::vector<std::uint32_t> FloorTriangle; // [fragment's triangles] of one of its cells
  std::vector<unsigned char> IsDownByCells; // [floor's triangles] whether its cells gave its bound
  std::vector<unsigned char> IsUpByCells;   // [fragment's triangles] the same
  std::size_t Budget;
};
}

vtkMTDeviation vtkMTDeviation::Between(
  const vtkMTSurface& floor, const vtkMTSurface& fragment, const Relation& relation, Findings& findings)
{
  vtkMTDeviation result;
  Certifier(floor, fragment, result).Run(relation, findings);
  return result;
}
