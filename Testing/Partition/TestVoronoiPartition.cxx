// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"
#include "vtkMTArrayScan.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace MTPartitionTest;

TEST(VoronoiPartition, TimeOfBuildIsMeasured)
{
  const Points barycentres = MakeFractalSphere(7).GetBarycentres();
  vtkMTArrayScan scan(barycentres);
  for (const int placement : { vtkMTVoronoiPartition::ALONG_CURVE, vtkMTVoronoiPartition::RADIUS_SCAN })
  {
    vtkNew<vtkMTVoronoiPartition> strategy;
    strategy->SetSeedPlacement(placement);
    for (const double target : { 100.0, 1000.0, 4000.0 })
    {
      const double begin = GetSeconds();
      const auto partition = strategy->Build(scan, target, 0);
      const double seconds = GetSeconds() - begin;
      ASSERT_TRUE(partition);
      std::cout << "  " << strategy->GetSettings() << ", target " << target << ": "
                << 1e6 * seconds / static_cast<double>(barycentres.size())
                << " microseconds of processor time per triangle\n";
      Print("", Measure(*partition, barycentres, target));
    }
  }
}
