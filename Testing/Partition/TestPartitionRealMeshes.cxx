// SPDX-License-Identifier: BSD-3-Clause
// The bound on all meshes of the data folder, and what a crossing looks like on the larger ones.
#include "MTPartitionFigures.h"
#include "MTPartitionStrategies.h"
#include "vtkMTArrayScan.h"
#include "vtkMTSliverMerge.h"
#include "vtkObject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

using namespace MTPartitionTest;

namespace
{
class QuietReaders
{
public:
  QuietReaders() { vtkObject::SetGlobalWarningDisplay(false); } // malformed files are among them
  ~QuietReaders() { vtkObject::SetGlobalWarningDisplay(true); }
};

// The builder's situation: the triangles of each region of the first partition among those of the second.
Regions MergeInAllRegions(
  const Regions& first, Regions second, const vtkMTPartition& partition, const Points& barycentres, std::size_t minimum)
{
  std::vector<std::vector<std::size_t>> members(*std::max_element(first.begin(), first.end()) + std::size_t(1));
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    members[first[i]].push_back(i);
  }
  for (const auto& triangles : members)
  {
    Regions regions;
    Points places;
    for (const std::size_t i : triangles)
    {
      regions.push_back(second[i]);
      places.push_back(barycentres[i]);
    }
    vtkMTSliverMerge::MergeSlivers(partition, places, minimum, regions);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      second[triangles[i]] = regions[i];
    }
  }
  return second;
}

void PrintCrossing(const std::string& name, const Mesh& mesh, double target)
{
  const Points barycentres = mesh.GetBarycentres();
  for (const std::string& strategyName : GetStrategyNames())
  {
    const auto strategy = MakeStrategy(strategyName);
    vtkMTArrayScan scan(barycentres);
    const auto fine = strategy->Build(scan, target, 0);
    const auto coarse = strategy->Build(scan, strategy->GetReduction() * target, 1);
    ASSERT_TRUE(fine && coarse);
    const Regions first = LocateAll(*fine, barycentres);
    const Regions second = LocateAll(*coarse, barycentres);
    const Elements plain = MeasureCrossing(first, second);
    const double mean = static_cast<double>(first.size()) / static_cast<double>(plain.Count);
    const Regions merged =
      MergeInAllRegions(first, second, *coarse, barycentres, static_cast<std::size_t>(std::ceil(0.1 * mean)));
    const Elements without = MeasureCrossing(first, merged);
    std::cout << "  " << name << ", " << strategyName << ", target " << target << ": elements per region "
              << plain.PerRegion << ", of which slivers " << 100.0 * plain.Small << " %, " << without.PerRegion
              << " without; target over mean triangles of an element " << target / mean << ", "
              << target * static_cast<double>(without.Count) / static_cast<double>(first.size())
              << " without; shared borders " << 100.0 * CompareBorders(mesh, first, second).GetShare() << " %\n";
    if (plain.Small > 0.0) // squares and hexagons are split evenly
    {
      EXPECT_LT(without.Count, plain.Count);
    }
    else
    {
      EXPECT_EQ(without.Count, plain.Count);
    }
    EXPECT_LT(plain.PerRegion, 6.0);
  }
}
}

TEST(PartitionRealMeshes, NoRegionExceedsFourTimesTheTarget)
{
  const QuietReaders quiet;
  const std::vector<std::string> files = GetDataFiles();
  if (files.empty())
  {
    GTEST_SKIP() << "There is no data folder (MT_TEST_DATA, or ../shared/data beside the sources).";
  }
  std::size_t meshes = 0;
  std::map<std::string, double> largest;
  for (const std::string& file : files)
  {
    const Points barycentres = ReadMesh(file, false).GetBarycentres();
    meshes += barycentres.empty() ? 0 : 1;
    for (const std::string& name : GetStrategyNames())
    {
      for (const double target : { 100.0, 3000.0 })
      {
        vtkMTArrayScan scan(barycentres);
        const double begin = GetSeconds();
        const auto partition = MakeStrategy(name)->Build(scan, target, 0);
        const double seconds = GetSeconds() - begin;
        ASSERT_TRUE(partition) << file;
        const Figures figures = Measure(*partition, barycentres, target);
        EXPECT_EQ(figures.Overfull, 0u) << file << ", " << name << ", target " << target;
        EXPECT_TRUE(figures.Empty == 0 || barycentres.empty()) << file << ", " << name << ", target " << target;
        largest[name] = std::max(largest[name], figures.Largest);
        if (barycentres.size() > 500000)
        {
          Print(std::filesystem::path(file).filename().string() + ", " + name + ", target " +
              std::to_string(static_cast<int>(target)) + ", " + std::to_string(seconds) + " s",
            figures);
        }
      }
    }
  }
  std::cout << "  " << meshes << " meshes with triangles in " << files.size() << " files\n";
  for (const auto& item : largest)
  {
    std::cout << "  " << item.first << ": largest region " << item.second << " target\n";
  }
}

TEST(PartitionRealMeshes, ElementsOfACrossingAreMeasured)
{
  const QuietReaders quiet;
  PrintCrossing("fractal sphere", MakeFractalSphere(7), 1000.0);
  PrintCrossing("fractal sphere", MakeFractalSphere(7), 4000.0);
  const std::vector<std::string> files = GetDataFiles();
  for (const std::string& file : files)
  {
    const std::string name = std::filesystem::path(file).filename().string();
    if (name == "dragon_res2.ply" || name == "lucy_100k.ply" || name == "igea.vtp" || name == "kitchen_scene.vtp")
    {
      PrintCrossing(name, ReadMesh(file, true), 1000.0);
    }
  }
  if (files.empty())
  {
    std::cout << "  There is no data folder: measured on the generated mesh only.\n";
  }
}
