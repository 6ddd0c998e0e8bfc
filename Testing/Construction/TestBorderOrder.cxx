// SPDX-License-Identifier: BSD-3-Clause
// Identities are numbered in the order in which files say them.
#include "MTTestMeshes.h"

#include "vtkMTBorderOrder.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

namespace
{
using MTTestMeshes::Random;

// A grid of points as a patch; its triangles in random order and, if asked for, each wound as it happens.
vtkMTPatch MakeGrid(Random& random, int columns, int rows, bool isMixed)
{
  vtkMTPatch mesh;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      mesh.Points.push_back({ i, j, 0 });
    }
  }
  for (const auto& t : MTTestMeshes::GridTriangles(columns, rows))
  {
    mesh.Triangles.push_back(
      { static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]) });
    if (isMixed && random.Below(2))
    {
      std::swap(mesh.Triangles.back()[1], mesh.Triangles.back()[2]);
    }
  }
  for (std::size_t i = mesh.Triangles.size(); i > 1; --i)
  {
    std::swap(mesh.Triangles[i - 1], mesh.Triangles[random.Below(i)]);
  }
  return mesh;
}

bool AreNeighbours(const vtkMTPoint& a, const vtkMTPoint& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) == 1;
}
}

TEST(BorderOrder, GoesRoundTheBorderOfAnyOrientation)
{
  Random random(3);
  for (const bool isMixed : { false, true })
  {
    const vtkMTPatch mesh = MakeGrid(random, 9, 6, isMixed);
    const std::vector<std::uint32_t> order = vtkMTBorderOrder::Find(mesh);
    ASSERT_EQ(order.size(), 2u * (8 + 5));
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      EXPECT_TRUE(AreNeighbours(mesh.Points[order[i]], mesh.Points[order[(i + 1) % order.size()]]));
    }
  }
}

TEST(BorderOrder, HasEveryPointOfARaggedBorderOnce)
{
  Random random(4);
  for (int round = 0; round < 50; ++round)
  {
    const vtkMTPatch mesh = MakeGrid(random, 12, 12, round % 2 == 0);
    std::vector<std::uint32_t> part;
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      if (random.Below(3) > 0)
      {
        part.push_back(t);
      }
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const std::uint32_t t : part)
    {
      for (int c = 0; c < 3; ++c)
      {
        ++uses[std::minmax(mesh.Triangles[t][c], mesh.Triangles[t][(c + 1) % 3])];
      }
    }
    std::set<std::uint32_t> expected;
    for (const auto& [edge, count] : uses)
    {
      if (count == 1)
      {
        expected.insert({ edge.first, edge.second });
      }
    }
    const std::vector<std::uint32_t> order = vtkMTBorderOrder(mesh).Find(part);
    EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()), expected);
    EXPECT_EQ(order.size(), expected.size());
  }
}

TEST(BorderOrder, NewIdentitiesAreDense)
{
  Random random(5);
  const vtkMTPatch mesh = MakeGrid(random, 20, 20, false);
  std::vector<std::uint32_t> regions;
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    regions.push_back(mesh.Points[t[0]][0] < 9 ? 3 : (mesh.Points[t[0]][1] < 11 ? 7 : 8));
  }
  const vtkMTPatchSplitter split = vtkMTPatchSplitter::Split(mesh, regions, 2, 5);
  std::set<std::uint64_t> ids;
  for (const auto& [id, region] : split.Uses)
  {
    ids.insert(id);
  }
  ASSERT_FALSE(ids.empty());
  EXPECT_EQ(*ids.begin(), vtkMTPatchSplitter::MakeId(2, 5, 0));
  EXPECT_EQ(*ids.rbegin(), vtkMTPatchSplitter::MakeId(2, 5, static_cast<std::uint32_t>(ids.size()) - 1));
}

// The whole builder, with an input whose points are in random order: neighbours along the border of a patch have
// identities that follow each other, but for the ends of the parts that it shares with different neighbours.
TEST(BorderOrder, IdentitiesOfAModelRunAlongTheBordersOfItsPatches)
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  MTTestMeshes::MakeIcosphere(5, places, triangles);
  Random random(6);
  std::vector<vtkIdType> number(places.size());
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    number[i] = static_cast<vtkIdType>(i);
    std::swap(number[i], number[random.Below(i + 1)]);
  }
  std::vector<MTTestMeshes::Place> shuffled(places.size());
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    shuffled[static_cast<std::size_t>(number[i])] = places[i];
  }
  for (auto& t : triangles)
  {
    for (auto& p : t)
    {
      p = number[static_cast<std::size_t>(p)];
    }
  }
  vtkMTPatchStore store;
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(200);
  vtkMTPolyDataStream stream(MTTestMeshes::Make(shuffled, triangles));
  ASSERT_TRUE(builder->Build(stream, store)) << builder->GetErrorMessage();
  std::size_t points = 0;
  std::size_t following = 0;
  for (std::uint32_t arc = 0; arc < store.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    ASSERT_TRUE(store.ReadPatch(arc, nullptr, patch, error)) << error;
    const std::vector<std::uint32_t> order = vtkMTBorderOrder::Find(patch);
    EXPECT_EQ(order.size(), patch.Ids.size());
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      const std::uint64_t step = patch.Ids[order[i]] - patch.Ids[order[i - 1]];
      ++points;
      following += step == 1 || step == ~std::uint64_t(0) ? 1 : 0;
    }
  }
  const double share = static_cast<double>(following) / static_cast<double>(points);
  std::printf("%zu shared points in patches, %.1f %% follow the one before along the border\n", points, 100.0 * share);
  EXPECT_GT(share, 0.75);
}
