// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDomainPartition.h"

#include "Domain/vtkMTDomain.h"
#include "Domain/vtkMTDomainFamilies.h"
#include "vtkMTBarycentreSample.h"
#include "vtkMTCellRegions.h"
#include "vtkMTSeedPartition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
constexpr int SamplesPerRegion = 64;

// The family whose cells are nearest in number to what is wanted.
int ChooseFamily(const vtkMTDomainFamilies& families, const vtkMTBarycentreSample& sample, double wanted,
  double nominal, double reduction)
{
  // Cells that sampling misses do not count: whoever covers as much covers the domain.
  constexpr double covered = 2.0 / 3.0;
  constexpr int mostFiner = 12;
  // Sequences come upon a tie again on every level, with another rounding.
  constexpr double tie = 1e-9;
  const double base = families.GetNumberOfCells(1) / reduction;
  const double steps = std::floor(std::log(nominal / base) / std::log(reduction) + 0.5 + tie);
  const int nearest = static_cast<int>(std::clamp<double>(steps, families.GetCoarsest(), families.GetFinest()));
  const auto count = [&](int family, double enough)
  { return families.CountCells(sample.Points, vtkMTDomainFamilies::Offset + family, enough); };
  const double enough = covered * std::min(families.GetNumberOfCells(nearest), wanted);
  if (count(nearest, enough) >= enough)
  {
    return nearest;
  }
  int family = nearest;
  const int last = std::min(nearest + mostFiner, families.GetFinest());
  while (family < last && count(family, wanted / std::sqrt(reduction)) < wanted / std::sqrt(reduction))
  {
    ++family;
  }
  return family;
}
}

//------------------------------------------------------------------------------
vtkMTDomainPartition::vtkMTDomainPartition() = default;

vtkMTDomainPartition::~vtkMTDomainPartition() = default;

std::unique_ptr<vtkMTPartition> vtkMTDomainPartition::Build(vtkMTBarycentreScan& scan, double target, int level) const
{
  target = target > 1.0 ? target : 1.0;
  vtkMTBarycentreSample sample;
  if (!sample.Take(scan, vtkMTBarycentreSample::GetStride(target, SamplesPerRegion)))
  {
    return nullptr;
  }
  const auto triangles = static_cast<double>(sample.Count);
  if (triangles <= target)
  {
    return std::make_unique<vtkMTSeedPartition>(std::vector<vtkMTBarycentreSample::Point>{ sample.Mean });
  }
  const double nominal = scan.GetNominalTriangles() > 0.0 ? scan.GetNominalTriangles() : triangles;
  std::unique_ptr<vtkMTDomainFamilies> families;
  int family = 0;
  for (const bool isTurned : { false, true })
  {
    const vtkMTDomain domain(this->Domain, sample.Lo, sample.Hi, isTurned);
    families = this->MakeFamilies(domain, sample.Largest, level % 2 != 0);
    family = ChooseFamily(*families, sample, triangles / target, nominal / target, this->GetReduction());
    if (((family + level) % 2 != 0) == isTurned)
    {
      break;
    }
  }
  families->SetFirst(family);
  auto regions = std::make_unique<vtkMTCellRegions>(std::move(families), vtkMTDomainFamilies::Offset + family);
  return regions->Fill(scan, target) ? std::move(regions) : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkMTDomainPartition::GetSettings() const
{
  constexpr std::array<const char*, 3> names{ "automatic", "plane", "sphere" };
  return std::string(this->GetStrategyName()) + " domain=" + names[static_cast<std::size_t>(this->Domain)];
}

void vtkMTDomainPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
}
