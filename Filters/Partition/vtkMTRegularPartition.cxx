// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegularPartition.h"

#include "vtkMTBarycentreSample.h"
#include "vtkMTCellFamilies.h"
#include "vtkMTCellRegions.h"
#include "vtkMTRelease.h"
#include "vtkMTSeedPartition.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMTRegularPartition);

namespace
{
using Points = std::vector<std::array<double, 3>>;

// The coarsest cell size whose face or edge centres give at least the wanted number of regions.
int FindExponent(const vtkMTCellFamilies& families, const Points& points, vtkMTRegularFamily::SeedType type,
  double wanted, int smallest)
{
  int low = smallest;
  int high = std::min(smallest + 54, vtkMTRegularFamily::LargestExponent);
  while (low < high)
  {
    const int middle = low + (high - low + 1) / 2;
    const int family = vtkMTRegularFamily::GetFamilyOf(middle, type);
    if (families.CountCells(points, family, wanted) >= wanted)
    {
      low = middle;
    }
    else
    {
      high = middle - 1;
    }
  }
  return low;
}

int ChooseFamily(const vtkMTCellFamilies& families, const Points& points, double wanted, int level, int smallest)
{
  const vtkMTRegularFamily::SeedType between = level % 2 != 0 ? vtkMTRegularFamily::Faces : vtkMTRegularFamily::Edges;
  const int exponent = FindExponent(families, points, between, wanted, smallest);
  const int candidates[] = { vtkMTRegularFamily::GetFamilyOf(exponent + 1, between),
    vtkMTRegularFamily::GetFamilyOf(exponent + 1, vtkMTRegularFamily::Cubes),
    vtkMTRegularFamily::GetFamilyOf(exponent, vtkMTRegularFamily::Cubes),
    vtkMTRegularFamily::GetFamilyOf(exponent, between) };
  int best = candidates[3];
  double bestPenalty = std::numeric_limits<double>::infinity();
  for (const int family : candidates)
  {
    const double regions = families.CountCells(points, family);
    // Half an octave in favour of faces and edges, which alternate: cubes must not follow upon the same cubes.
    const double penalty = std::abs(std::log2(regions / wanted)) +
      (vtkMTRegularFamily(family).GetType() == vtkMTRegularFamily::Cubes ? 0.5 : 0.0);
    if (penalty < bestPenalty)
    {
      best = family;
      bestPenalty = penalty;
    }
  }
  return best;
}
}

vtkMTRegularPartition::vtkMTRegularPartition() = default;

vtkMTRegularPartition::~vtkMTRegularPartition() = default;

std::unique_ptr<vtkMTPartition> vtkMTRegularPartition::Build(vtkMTBarycentreScan& scan, double target, int level) const
{
  target = target > 1.0 ? target : 1.0;
  vtkMTBarycentreSample sample;
  if (!sample.Take(scan, vtkMTBarycentreSample::GetStride(target, this->SamplesPerRegion)))
  {
    return nullptr;
  }
  if (static_cast<double>(sample.Count) <= target)
  {
    return std::make_unique<vtkMTSeedPartition>(Points{ sample.Mean });
  }
  const int smallest = vtkMTRegularFamily::GetSmallestExponent(sample.Largest);
  const double wanted = static_cast<double>(sample.Count) / target;
  const int largest = std::min(smallest + 55, vtkMTRegularFamily::LargestExponent + 1);
  auto families =
    std::make_unique<vtkMTRegularFamilies>(vtkMTRegularFamily::GetFamilyOf(largest, vtkMTRegularFamily::Cubes),
      vtkMTRegularFamily::GetFamilyOf(smallest, vtkMTRegularFamily::Edges));
  const int family = ChooseFamily(*families, sample.Points, wanted, level, smallest);
  vtkMTRelease(sample.Points);
  auto regions = std::make_unique<vtkMTCellRegions>(std::move(families), family);
  if (!regions->Fill(scan, target))
  {
    return nullptr;
  }
  return regions;
}

std::string vtkMTRegularPartition::GetSettings() const
{
  return std::string(this->GetStrategyName()) + " samples=" + std::to_string(this->SamplesPerRegion);
}

void vtkMTRegularPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerRegion: " << this->SamplesPerRegion << "\n";
}
