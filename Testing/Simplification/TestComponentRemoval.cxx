// SPDX-License-Identifier: BSD-3-Clause
// What cannot be collapsed any further is left out component by component, the smallest first, and counted.
#include "SimplificationTesting.h"

#include "vtkMTComponentRemoval.h"

#include <gtest/gtest.h>

#include <set>

using namespace SimplificationTesting;

namespace
{
// Tetrahedra of growing size in a row: component i has points 4 i to 4 i + 3.
vtkMTPatch MakeTetrahedra(int count)
{
  vtkMTPatch floor;
  for (int i = 0; i < count; ++i)
  {
    const auto first = static_cast<std::uint32_t>(floor.Points.size());
    const std::int32_t x = 100000 * i;
    const std::int32_t s = 100 * (1 + i);
    floor.Points.insert(floor.Points.end(), { { x, 0, 0 }, { x + s, 0, 0 }, { x, s, 0 }, { x, 0, s } });
    for (const vtkMTTriangle& t :
      { vtkMTTriangle{ 0, 2, 1 }, vtkMTTriangle{ 0, 1, 3 }, vtkMTTriangle{ 0, 3, 2 }, vtkMTTriangle{ 1, 2, 3 } })
    {
      floor.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  return floor;
}

std::set<std::uint32_t> GetComponents(const vtkMTSimplification& result)
{
  std::set<std::uint32_t> components;
  for (const std::uint32_t origin : result.PointOrigin)
  {
    components.insert(origin / 4);
  }
  return components;
}
}

TEST(ComponentRemoval, TheSmallestGoFirstUntilTheTargetIsReached)
{
  const vtkMTPatch floor = MakeTetrahedra(10);
  const Outcome outcome = Simplify(floor, LockNothing(floor), 22);
  ASSERT_TRUE(outcome.Ok);
  EXPECT_EQ(GetComponents(outcome.Result), (std::set<std::uint32_t>{ 5, 6, 7, 8, 9 }));
  EXPECT_EQ(outcome.Result.RemovedComponents, 5);
  EXPECT_EQ(outcome.Result.Blocked.at("component_triangles"), 20);
  EXPECT_EQ(outcome.Result.Blocked.at("topology"), 60); // the edges of tetrahedra
  EXPECT_EQ(FindFault(floor, LockNothing(floor), outcome.Result), "");
}

TEST(ComponentRemoval, TheLastComponentStays)
{
  const vtkMTPatch floor = MakeTetrahedra(6);
  const Outcome outcome = Simplify(floor, LockNothing(floor), 0);
  EXPECT_EQ(GetComponents(outcome.Result), std::set<std::uint32_t>{ 5 });
}

TEST(ComponentRemoval, ComponentsWithALockedPointStay)
{
  const vtkMTPatch floor = MakeTetrahedra(6);
  Locks locked = LockNothing(floor);
  locked[0] = locked[4 * 2 + 3] = 1;
  const Outcome outcome = Simplify(floor, locked, 0);
  EXPECT_EQ(GetComponents(outcome.Result), (std::set<std::uint32_t>{ 0, 2 }));
}

TEST(ComponentRemoval, LargeComponentsStay)
{
  const vtkMTPatch floor = MakeTetrahedra(6);
  vtkMTSimplification result = Simplify(floor, LockNothing(floor), 24).Result;
  vtkMTComponentRemoval removal;
  removal.MaximumDiagonal = 300.0 * 1.7321; // the third one's box
  removal.Remove(LockNothing(floor), 0, result);
  EXPECT_EQ(GetComponents(result), (std::set<std::uint32_t>{ 3, 4, 5 }));
  EXPECT_EQ(result.RemovedComponents, 3);

  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetComponentBound(0.0);
  std::string error;
  ASSERT_TRUE(simplifier->Simplify(floor, LockNothing(floor), 0, result, error));
  EXPECT_EQ(GetComponents(result).size(), 6u);
}

TEST(ComponentRemoval, EqualComponentsGoByIndex)
{
  vtkMTPatch floor = MakeTetrahedra(1);
  for (std::uint32_t i = 1; i < 8; ++i)
  {
    for (int p = 0; p < 4; ++p)
    {
      vtkMTPoint k = floor.Points[static_cast<std::size_t>(p)];
      k[1] += 10000 * static_cast<std::int32_t>(i);
      floor.Points.push_back(k);
    }
    for (int t = 0; t < 4; ++t)
    {
      vtkMTTriangle triangle = floor.Triangles[static_cast<std::size_t>(t)];
      floor.Triangles.push_back({ triangle[0] + 4 * i, triangle[1] + 4 * i, triangle[2] + 4 * i });
    }
  }
  const Outcome outcome = Simplify(floor, LockNothing(floor), 12);
  EXPECT_EQ(GetComponents(outcome.Result), (std::set<std::uint32_t>{ 5, 6, 7 }));
}

TEST(ComponentRemoval, AFanThatSharesAPointWithALargerPieceIsNoComponent)
{
  vtkMTPatch floor = MakeTetrahedra(2);
  for (vtkMTTriangle& t : floor.Triangles)
  {
    for (std::uint32_t& p : t)
    {
      p = p == 4 ? 0 : p; // the second one hangs on the first
    }
  }
  const Outcome outcome = Simplify(floor, LockNothing(floor), 0);
  EXPECT_EQ(outcome.Result.Triangles.size(), 8u);
  EXPECT_EQ(outcome.Result.RemovedComponents, 0);
}
