// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStitch.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// The surface of a tetrahedron, every triangle with points of its own.
void MakeSoup(Points& points, Triangles& triangles)
{
  const Points corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Triangles faces{ { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  for (const auto& face : faces)
  {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t corner : face)
    {
      points.push_back(corners[corner]);
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
}

std::size_t CountIdentities(const vtkMTStitch& stitch)
{
  return std::set<std::uint32_t>(stitch.Root.begin(), stitch.Root.end()).size();
}
}

TEST(Stitch, SoupOfClosedSurfaceBecomesOneSurface)
{
  Points points;
  Triangles triangles;
  MakeSoup(points, triangles);
  const vtkMTStitch stitch = vtkMTStitch::Run(points, triangles);
  EXPECT_EQ(CountIdentities(stitch), 4u);
  EXPECT_EQ(stitch.StitchedEdges, 6);
  EXPECT_EQ(stitch.StitchedPoints, 8);
}

TEST(Stitch, CoincidentSheetsStayApart)
{
  // Twice the same square, both wound alike: four triangles at the diagonal by place, two by index.
  const Points square{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  Points points = square;
  points.insert(points.end(), square.begin(), square.end());
  const Triangles triangles{ { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } };
  const vtkMTStitch stitch = vtkMTStitch::Run(points, triangles);
  EXPECT_EQ(CountIdentities(stitch), 8u);
  EXPECT_EQ(stitch.StitchedEdges, 0);
}

TEST(Stitch, EdgeWithThreeSheetsIsLeftAlone)
{
  // Three triangles that meet along one edge by place only.
  const Points points{ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 },
    { 0, 0, 1 }, { -1, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } };
  EXPECT_EQ(vtkMTStitch::Run(points, triangles).StitchedPoints, 0);
}

TEST(Stitch, PointsThatAreOnlyNearStayApart)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1e-300, 0, 0 }, { 0, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 3, 4, 5 } };
  EXPECT_EQ(vtkMTStitch::Run(points, triangles).StitchedPoints, 0);
}

TEST(Stitch, SharedIndexNeedsNoStitch)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 1, 0, 3 } };
  const vtkMTStitch stitch = vtkMTStitch::Run(points, triangles);
  EXPECT_EQ(stitch.StitchedEdges, 0);
  EXPECT_EQ(CountIdentities(stitch), 4u);
}

TEST(Stitch, EdgesOfDifferentPartsStayApart)
{
  Points points;
  Triangles triangles;
  MakeSoup(points, triangles);
  EXPECT_EQ(vtkMTStitch::Run(points, triangles, { 0, 1, 2, 3 }).StitchedEdges, 0);
  // Two triangles of each part: one edge in common for each pair.
  EXPECT_EQ(vtkMTStitch::Run(points, triangles, { 0, 0, 7, 7 }).StitchedEdges, 2);
  EXPECT_EQ(vtkMTStitch::Run(points, triangles, { 5, 5, 5, 5 }).StitchedEdges, 6);
}
