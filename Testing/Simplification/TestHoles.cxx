// SPDX-License-Identifier: BSD-3-Clause
// A hole keeps three edges at the least; when that is what stands in the way of the target, small ones are closed.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace SimplificationTesting;

namespace
{
// A grid of cells x cells quads; every third quad of every third row is missing.
vtkMTPatch MakePiercedGrid(int cells, std::size_t& holes)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      places.push_back({ double(i) / cells, double(j) / cells, 0.001 * ((i * 7 + j * 13) % 11) });
    }
  }
  holes = 0;
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      if (i % 3 == 1 && j % 3 == 1)
      {
        ++holes;
        continue;
      }
      const vtkIdType a = j * (cells + 1) + i;
      const vtkIdType c = a + cells + 1;
      triangles.push_back({ a, a + 1, c + 1 });
      triangles.push_back({ a, c + 1, c });
    }
  }
  return MakeFloor(places, triangles);
}

vtkMTSimplification Simplify(const vtkMTPatch& floor, const Locks& locks, std::size_t target, double bound, int mode)
{
  vtkNew<vtkMTEdgeCollapse> collapse;
  collapse->SetMode(mode);
  collapse->SetComponentBound(bound);
  vtkMTSimplification result;
  std::string error;
  EXPECT_TRUE(collapse->Simplify(floor, locks, target, result, error)) << error;
  return result;
}
}

TEST(Holes, SmallHolesDoNotStandInTheWayOfTheTarget)
{
  std::size_t holes = 0;
  const vtkMTPatch floor = MakePiercedGrid(60, holes);
  const std::size_t target = 200;
  for (const int mode : AllModes)
  {
    const vtkMTSimplification closed = Simplify(floor, LockNothing(floor), target, 0.125, mode);
    const vtkMTSimplification open = Simplify(floor, LockNothing(floor), target, 0.0, mode);
    std::printf("mode %d: %zu triangles with %zu holes; %zu when they may be closed, %zu when not\n", mode,
      floor.Triangles.size(), holes, closed.Triangles.size(), open.Triangles.size());
    EXPECT_LE(closed.Triangles.size(), target);
    EXPECT_GT(open.Triangles.size(), 2 * target);
  }
}

TEST(Holes, HolesStayWhereTheTargetIsReachedWithThem)
{
  std::size_t holes = 0;
  const vtkMTPatch floor = MakePiercedGrid(30, holes);
  const vtkMTSimplification result =
    Simplify(floor, LockNothing(floor), floor.Triangles.size() * 3 / 4, 0.125, vtkMTEdgeCollapse::FAST);
  // Three edges for each hole, and the outer border.
  EXPECT_GE(FindBorder(ToPatch(result)).size(), 3 * holes);
}

TEST(Holes, HolesThatOutsideTrianglesMayTouchStay)
{
  std::size_t holes = 0;
  const vtkMTPatch floor = MakePiercedGrid(30, holes);
  const Locks locks = LockBorder(floor);
  const vtkMTSimplification result = Simplify(floor, locks, 10, 0.125, vtkMTEdgeCollapse::FAST);
  EXPECT_EQ(FindBorder(ToPatch(result)).size(), FindBorder(floor).size());
}

TEST(Holes, AnIsolatedTriangleGetsNoTwin)
{
  const vtkMTPatch floor =
    MakeFloor({ { 0, 0, 0 }, { 0.01, 0, 0 }, { 0, 0.01, 0 }, { 1, 1, 1 }, { 0.99, 1, 1 }, { 1, 0.99, 1 } },
      { { 0, 1, 2 }, { 3, 4, 5 } });
  const vtkMTSimplification result = Simplify(floor, LockNothing(floor), 1, 0.125, vtkMTEdgeCollapse::FAST);
  EXPECT_LE(result.Triangles.size(), 2u);
}
