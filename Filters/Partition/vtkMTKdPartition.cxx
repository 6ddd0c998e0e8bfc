// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTKdPartition.h"

#include "vtkMTKdRegions.h"
#include "vtkMTStreamShuffle.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

vtkStandardNewMacro(vtkMTKdPartition);

vtkMTKdPartition::vtkMTKdPartition() = default;

vtkMTKdPartition::~vtkMTKdPartition() = default;

//------------------------------------------------------------------------------
std::unique_ptr<vtkMTPartition> vtkMTKdPartition::Build(vtkMTBarycentreScan& scan, double target, int level) const
{
  // Mean share of its capacity that a leaf holds where leaves are divided at a third or two thirds.
  constexpr double meanFilling = 0.6365;
  target = target > 1.0 ? target : 1.0;
  int stream = 0;
  while (stream < vtkMTStreamShuffle::MaximumStream && std::ldexp(target, -stream - 1) >= this->SamplesPerRegion)
  {
    ++stream;
  }
  vtkMTStreamShuffle shuffle;
  if (!shuffle.Take(scan, stream))
  {
    return nullptr;
  }
  const auto total = static_cast<double>(shuffle.Count);
  const double share = shuffle.Points.empty() ? 1.0 : static_cast<double>(shuffle.Points.size()) / total;
  const double capacity = total <= target ? total : std::max(std::ceil(share * target / meanFilling), 1.0);
  auto regions =
    std::make_unique<vtkMTKdRegions>(static_cast<std::size_t>(capacity), level % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0);
  std::for_each(shuffle.Points.begin(), shuffle.Points.end(), [&regions](const auto& x) { regions->Insert(x); });
  const double most = total <= target ? total : MaximumOverload * target;
  return regions->Finish(scan, static_cast<std::size_t>(most)) ? std::move(regions) : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkMTKdPartition::GetSettings() const
{
  return std::string(this->GetStrategyName()) + " samples=" + std::to_string(this->SamplesPerRegion);
}

void vtkMTKdPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerRegion: " << this->SamplesPerRegion << "\n";
}
