// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSeedBound.h"

#include "vtkMTBarycentreSample.h"
#include "vtkMTHilbertOrder.h"
#include "vtkMTLocateBlock.h"
#include "vtkMTPartitionStrategy.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// By the same sum as vtkMTSeedPartition: two points whose distance is rounded to zero cannot be told apart by a seed.
bool Coincide(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const double dx = a[0] - b[0];
  const double dy = a[1] - b[1];
  const double dz = a[2] - b[2];
  return dx * dx + dy * dy + dz * dz == 0.0;
}
}

vtkMTSeedBound::vtkMTSeedBound(vtkMTBarycentreScan& scan, double target, int samplesPerRegion, int level)
  : Scan(scan)
  , Target(target)
  , SamplesPerRegion(samplesPerRegion)
  , Level(level)
{
}

template <typename Visitor>
bool vtkMTSeedBound::Visit(const vtkMTSeedPartition& partition, Visitor&& visitor)
{
  return this->Scan.Scan(
    [&](const Point* barycentres, std::size_t count)
    {
      this->Regions.resize(std::max(count, this->Regions.size()));
      vtkMTLocateBlock::Locate(partition, barycentres, count, this->Regions.data());
      for (std::size_t i = 0; i < count; ++i)
      {
        if (vtkMTBarycentreSample::IsFinite(barycentres[i]))
        {
          visitor(this->Regions[i], barycentres[i]);
        }
      }
    });
}

bool vtkMTSeedBound::Count(const vtkMTSeedPartition& partition)
{
  this->Loads.assign(partition.GetNumberOfRegions(), Load());
  return this->Visit(partition, [&](std::uint32_t region, const Point&) { ++this->Loads[region].All; });
}

bool vtkMTSeedBound::MarkLarge()
{
  bool any = false;
  for (Load& load : this->Loads)
  {
    if (static_cast<double>(load.All) > vtkMTPartitionStrategy::MaximumOverload * this->Target)
    {
      load.Stride = vtkMTBarycentreSample::GetStride(this->Target, this->SamplesPerRegion);
      any = true;
    }
  }
  return any;
}

bool vtkMTSeedBound::Gather(const vtkMTSeedPartition& partition)
{
  const std::vector<Point>& seeds = partition.GetSeeds();
  return this->Visit(partition,
    [&](std::uint32_t region, const Point& x)
    {
      Load& load = this->Loads[region];
      if (load.Stride == 0)
      {
        return;
      }
      if (Coincide(x, seeds[region]))
      {
        ++load.AtSeed;
      }
      else if (vtkMTBarycentreSample::IsTaken(load.Seen++, load.Stride))
      {
        load.Sample.push_back(x);
      }
    });
}

// Large regions whose barycentres nearly all coincide with the seed stay as they are.
bool vtkMTSeedBound::KeepOverfull()
{
  bool any = false;
  for (Load& load : this->Loads)
  {
    const bool isOverfull = load.Stride > 0 && static_cast<double>(load.All - load.AtSeed) > this->Target;
    load.Stride = isOverfull ? load.Stride : 0;
    any = any || isOverfull;
  }
  return any;
}

std::vector<vtkMTSeedBound::Point> vtkMTSeedBound::AddSeeds(const vtkMTSeedPartition& partition) const
{
  std::vector<Point> result;
  for (std::size_t region = 0; region < this->Loads.size(); ++region)
  {
    const Load& load = this->Loads[region];
    result.push_back(partition.GetSeeds()[region]);
    if (load.Stride == 0)
    {
      continue;
    }
    // One less than the region's share, as its own seed stays.
    const double wanted = std::max(1.0, std::round(static_cast<double>(load.All - load.AtSeed) / this->Target) - 1.0);
    const std::size_t chunks = std::min(static_cast<std::size_t>(wanted), load.Sample.size());
    const std::vector<std::uint32_t> order = vtkMTHilbertOrder::Sort(load.Sample, this->Level);
    const std::size_t first = result.size();
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      const std::size_t begin = vtkMTHilbertOrder::GetChunkBegin(order.size(), chunks, chunk);
      const std::size_t end = vtkMTHilbertOrder::GetChunkBegin(order.size(), chunks, chunk + 1);
      const Point& seed = load.Sample[order[(begin + end) / 2]];
      // Coincident barycentres follow one another on the curve: one seed is enough for them.
      if (result.size() == first || !Coincide(result.back(), seed))
      {
        result.push_back(seed);
      }
    }
  }
  return result;
}

std::vector<vtkMTSeedBound::Point> vtkMTSeedBound::RemoveEmpty(const vtkMTSeedPartition& partition) const
{
  std::vector<Point> result;
  for (std::size_t region = 0; region < this->Loads.size(); ++region)
  {
    if (this->Loads[region].All > 0)
    {
      result.push_back(partition.GetSeeds()[region]);
    }
  }
  return result;
}

std::unique_ptr<vtkMTPartition> vtkMTSeedBound::Hold(std::vector<Point> seeds)
{
  for (;;)
  {
    auto partition = std::make_unique<vtkMTSeedPartition>(std::move(seeds));
    if (!this->Count(*partition))
    {
      return nullptr;
    }
    const bool hasLarge = this->MarkLarge();
    if (hasLarge && !this->Gather(*partition))
    {
      return nullptr;
    }
    if (!hasLarge || !this->KeepOverfull())
    {
      seeds = this->RemoveEmpty(*partition);
      const bool same = seeds.empty() || seeds.size() == partition->GetSeeds().size();
      return same ? std::move(partition) : std::make_unique<vtkMTSeedPartition>(std::move(seeds));
    }
    seeds = this->AddSeeds(*partition);
  }
}
