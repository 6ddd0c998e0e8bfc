// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVoronoiPartition.h"

#include "vtkMTBarycentreSample.h"
#include "vtkMTRadiusScan.h"
#include "vtkMTRelease.h"
#include "vtkMTSeedBound.h"
#include "vtkMTSeedPartition.h"
#include "vtkMTSeedRelaxation.h"
#include "vtkMTSetMacros.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

vtkStandardNewMacro(vtkMTVoronoiPartition);
vtkMTCxxSetClampMacro(vtkMTVoronoiPartition, SmallRegion, 0.0, 0.9);

vtkMTVoronoiPartition::vtkMTVoronoiPartition() = default;

vtkMTVoronoiPartition::~vtkMTVoronoiPartition() = default;

std::unique_ptr<vtkMTPartition> vtkMTVoronoiPartition::Build(vtkMTBarycentreScan& scan, double target, int level) const
{
  target = target > 1.0 ? target : 1.0;
  const std::size_t stride = vtkMTBarycentreSample::GetStride(target, this->SamplesPerRegion);
  vtkMTBarycentreSample sample;
  if (!sample.Take(scan, stride))
  {
    return nullptr;
  }
  if (static_cast<double>(sample.Count) <= target)
  {
    return std::make_unique<vtkMTSeedPartition>(std::vector<std::array<double, 3>>{ sample.Mean });
  }
  const std::size_t wanted =
    std::max<std::size_t>(1, static_cast<std::size_t>(std::round(static_cast<double>(sample.Count) / target)));
  std::vector<std::array<double, 3>> seeds;
  if (this->SeedPlacement == ALONG_CURVE)
  {
    seeds = vtkMTSeedRelaxation::PlaceAlongCurve(sample.Points, wanted, level);
  }
  else if (!vtkMTRadiusScan::PlaceSeeds(scan, sample.Points, wanted, level, seeds))
  {
    return nullptr;
  }
  vtkMTSeedRelaxation relaxation;
  relaxation.PerRegion = target / static_cast<double>(stride);
  relaxation.SmallRegion = this->SmallRegion;
  relaxation.DivideLarge = this->SeedPlacement == ALONG_CURVE;
  relaxation.Level = level;
  for (int step = 0; step < this->LloydSteps; ++step)
  {
    seeds = relaxation.Step(sample.Points, std::move(seeds));
  }
  vtkMTRelease(sample.Points);
  return vtkMTSeedBound(scan, target, this->SamplesPerRegion, level).Hold(std::move(seeds));
}

std::string vtkMTVoronoiPartition::GetSettings() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << this->GetStrategyName() << " seeds=" << (this->SeedPlacement == ALONG_CURVE ? "curve" : "radius")
       << " lloyd=" << this->LloydSteps << " small=" << this->SmallRegion << " samples=" << this->SamplesPerRegion;
  return text.str();
}

void vtkMTVoronoiPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SeedPlacement: " << (this->SeedPlacement == ALONG_CURVE ? "AlongCurve" : "RadiusScan") << "\n";
  os << indent << "LloydSteps: " << this->LloydSteps << "\n";
  os << indent << "SmallRegion: " << this->SmallRegion << "\n";
  os << indent << "SamplesPerRegion: " << this->SamplesPerRegion << "\n";
}
