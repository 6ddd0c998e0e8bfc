// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSplitter.h"

#include "vtkMTAssembler.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>

namespace
{
// A strip of n quads, a texture seam along its middle edge: points there have two wedges.
vtkMTPatch MakeStrip(std::uint32_t n, std::vector<vtkMTArrayInfo>& arrays)
{
  vtkMTPatch mesh;
  std::vector<float> u;
  for (std::uint32_t i = 0; i <= n; ++i)
  {
    for (int row = 0; row < 2; ++row)
    {
      mesh.Points.push_back({ static_cast<std::int32_t>(100 * i), 100 * row, 0 });
      mesh.WedgePoints.push_back(2 * i + static_cast<std::uint32_t>(row));
      u.push_back(static_cast<float>(i));
    }
  }
  const std::uint32_t seam = n / 2;
  for (std::uint32_t row = 0; row < 2; ++row)
  {
    mesh.WedgePoints.push_back(2 * seam + row);
    u.push_back(-1.0f);
  }
  const auto wedge = [&](std::uint32_t column, std::uint32_t row, bool right)
  { return column == seam && right ? 2 * (n + 1) + row : 2 * column + row; };
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const bool right = i >= seam;
    mesh.Triangles.push_back({ wedge(i, 0, right), wedge(i + 1, 0, false), wedge(i + 1, 1, false) });
    mesh.Triangles.push_back({ wedge(i, 0, right), wedge(i + 1, 1, false), wedge(i, 1, right) });
  }
  vtkMTColumn column(u.size() * sizeof(float));
  std::memcpy(column.data(), u.data(), column.size());
  mesh.PointColumns.push_back(column);
  arrays.resize(1);
  arrays[0].Name = "u";
  return mesh;
}

// Triangles as sets of places with attribute values: what must survive splitting and assembling.
std::multiset<std::vector<double>> Describe(const vtkMTPatch& mesh)
{
  std::multiset<std::vector<double>> result;
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    std::vector<double> description;
    for (std::uint32_t w : t)
    {
      const vtkMTPoint& p = mesh.Points[mesh.GetPointOfWedge(w)];
      float u;
      std::memcpy(&u, mesh.PointColumns[0].data() + w * sizeof(float), sizeof(float));
      description.insert(description.end(), { double(p[0]), double(p[1]), double(p[2]), double(u) });
    }
    result.insert(description);
  }
  return result;
}
}

TEST(PatchSplitter, AssemblingThePartsGivesTheFragmentBack)
{
  std::vector<vtkMTArrayInfo> arrays;
  const vtkMTPatch strip = MakeStrip(40, arrays);
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round)
  {
    std::vector<std::uint32_t> regions(strip.Triangles.size());
    for (std::uint32_t& region : regions)
    {
      region = random() % 4;
    }
    const vtkMTPatchSplitter split = vtkMTPatchSplitter::Split(strip, regions, 3, 17);
    vtkMTAssembler assembler(arrays);
    std::size_t triangles = 0;
    for (const auto& part : split.Parts)
    {
      EXPECT_TRUE(vtkMTValidate::Mesh(part.Patch, arrays).IsValid());
      EXPECT_EQ(
        part.Patch.Triangles.size(), static_cast<std::size_t>(std::count(regions.begin(), regions.end(), part.Region)));
      triangles += part.Patch.Triangles.size();
      ASSERT_TRUE(assembler.Add(part.Patch)) << assembler.GetError();
    }
    const vtkMTPatch mesh = assembler.TakeMesh();
    EXPECT_EQ(triangles, strip.Triangles.size());
    EXPECT_EQ(mesh.Points.size(), strip.Points.size());
    EXPECT_EQ(mesh.GetNumberOfWedges(), strip.GetNumberOfWedges());
    EXPECT_EQ(Describe(mesh), Describe(strip));
  }
}

TEST(PatchSplitter, PointsUsedByTwoRegionsAreLocked)
{
  std::vector<vtkMTArrayInfo> arrays;
  const vtkMTPatch strip = MakeStrip(4, arrays);
  const std::vector<std::uint32_t> regions{ 0, 0, 0, 0, 1, 1, 1, 1 };
  const vtkMTPatchSplitter split = vtkMTPatchSplitter::Split(strip, regions, 0, 0);
  const std::vector<std::uint64_t>& ids = split.Parts[0].Patch.Ids;
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(ids, split.Parts[1].Patch.Ids);
  const std::vector<std::pair<std::uint64_t, std::uint32_t>> expected{ { ids[0], 0 }, { ids[1], 0 }, { ids[0], 1 },
    { ids[1], 1 } };
  EXPECT_EQ(split.Uses, expected);
}

TEST(PatchSplitter, SharedPointsKeepTheirIdsAndSayWhoUsesThem)
{
  std::vector<vtkMTArrayInfo> arrays;
  vtkMTPatch strip = MakeStrip(4, arrays);
  strip.Ids = { 1001, 1002 }; // the first column
  const vtkMTPatchSplitter split = vtkMTPatchSplitter::Split(strip, { 5, 5, 5, 5, 7, 7, 7, 7 }, 2, 9);
  // The cut makes the middle column shared, beside the first one; the border comes to it at its upper point.
  const std::uint64_t made[2] = { vtkMTPatchSplitter::MakeId(2, 9, 1), vtkMTPatchSplitter::MakeId(2, 9, 0) };
  const std::vector<std::pair<std::uint64_t, std::uint32_t>> expected{ { 1001, 5 }, { 1002, 5 }, { made[0], 5 },
    { made[1], 5 }, { made[0], 7 }, { made[1], 7 } };
  EXPECT_EQ(split.Uses, expected);
  EXPECT_EQ(split.Parts[0].Patch.Ids[0], 1001u);
}

TEST(PatchSplitter, IdsDoNotMeet)
{
  std::set<std::uint64_t> ids;
  for (std::uint32_t level : { 0u, 1u, 59u })
  {
    for (std::uint32_t region : { 0u, 1u, vtkMTPatchSplitter::MaximumRegions - 1 })
    {
      for (std::uint32_t point : { 0u, 1u, 0xfffffffeu })
      {
        EXPECT_TRUE(ids.insert(vtkMTPatchSplitter::MakeId(level, region, point)).second);
      }
    }
  }
  EXPECT_TRUE(ids.insert(vtkMTPatchSplitter::MakeInputId(0)).second);
  EXPECT_TRUE(ids.insert(vtkMTPatchSplitter::MakeInputId(0xffffffffffULL)).second);
  EXPECT_EQ(ids.count(vtkMTAssembler::NoId), 0u);
}
