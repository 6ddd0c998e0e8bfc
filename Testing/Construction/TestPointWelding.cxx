// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTPointWelding.h"

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

struct Result
{
  std::vector<std::uint32_t> Root; // per point
  std::int64_t StitchedEdges;
  std::int64_t StitchedPoints;
};

// The triangles in blocks, one after the other.
Result StitchBlocks(
  const Points& points, const Triangles& triangles, std::size_t blocks, const std::vector<std::int32_t>& partIds)
{
  std::vector<vtkMTInputBlock> parts(blocks);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    vtkMTInputBlock& part = parts[t * blocks / triangles.size()];
    part.Triangles.push_back(triangles[t]);
    if (!partIds.empty())
    {
      const auto* id = reinterpret_cast<const unsigned char*>(&partIds[t]);
      part.Columns.resize(1);
      part.Columns[0].insert(part.Columns[0].end(), id, id + sizeof(partIds[t]));
    }
  }
  std::vector<int> users(points.size(), 0);
  for (vtkMTInputBlock& part : parts)
  {
    part.FindPoints();
    for (const std::uint32_t p : part.Points)
    {
      part.Places.push_back(points[p]);
      ++users[p];
    }
  }
  vtkMTMemorySpoolStore store;
  vtkMTPointWelding stitch(store, std::size_t(1) << 20);
  for (vtkMTInputBlock& part : parts)
  {
    for (const std::uint32_t p : part.Points)
    {
      part.IsOpen.push_back(users[p] > 1 ? 1 : 0);
    }
    EXPECT_TRUE(stitch.Add(part, vtkMTPointWelding::FindEdges(part), partIds.empty() ? -1 : 0)) << stitch.GetError();
  }
  EXPECT_TRUE(stitch.Finish()) << stitch.GetError();
  Result result;
  for (std::uint32_t p = 0; p < points.size(); ++p)
  {
    const std::uint32_t root = stitch.FindRoot(p);
    result.Root.push_back(root == vtkMTPointWelding::None ? p : root);
  }
  result.StitchedEdges = stitch.GetNumberOfStitchedEdges();
  result.StitchedPoints = stitch.GetNumberOfWeldedPoints();
  return result;
}

// The same for any number of blocks.
Result Stitch(const Points& points, const Triangles& triangles, const std::vector<std::int32_t>& partIds = {})
{
  const Result result = StitchBlocks(points, triangles, 1, partIds);
  for (std::size_t blocks = 2; blocks <= triangles.size(); ++blocks)
  {
    const Result other = StitchBlocks(points, triangles, blocks, partIds);
    EXPECT_EQ(result.Root, other.Root) << blocks << " blocks";
    EXPECT_EQ(result.StitchedEdges, other.StitchedEdges) << blocks << " blocks";
    EXPECT_EQ(result.StitchedPoints, other.StitchedPoints) << blocks << " blocks";
  }
  return result;
}

std::size_t CountIdentities(const Result& stitch)
{
  return std::set<std::uint32_t>(stitch.Root.begin(), stitch.Root.end()).size();
}
}

TEST(Stitch, SoupOfClosedSurfaceBecomesOneSurface)
{
  Points points;
  Triangles triangles;
  MakeSoup(points, triangles);
  const Result stitch = Stitch(points, triangles);
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
  const Result stitch = Stitch(points, triangles);
  EXPECT_EQ(CountIdentities(stitch), 8u);
  EXPECT_EQ(stitch.StitchedEdges, 0);
}

TEST(Stitch, EdgeWithThreeSheetsIsLeftAlone)
{
  // Three triangles that meet along one edge by place only.
  const Points points{ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 },
    { 0, 0, 1 }, { -1, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } };
  EXPECT_EQ(Stitch(points, triangles).StitchedPoints, 0);
}

TEST(Stitch, PointsThatAreOnlyNearStayApart)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1e-300, 0, 0 }, { 0, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 3, 4, 5 } };
  EXPECT_EQ(Stitch(points, triangles).StitchedPoints, 0);
}

TEST(Stitch, SharedIndexNeedsNoStitch)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 } };
  const Triangles triangles{ { 0, 1, 2 }, { 1, 0, 3 } };
  const Result stitch = Stitch(points, triangles);
  EXPECT_EQ(stitch.StitchedEdges, 0);
  EXPECT_EQ(CountIdentities(stitch), 4u);
}

TEST(Stitch, EdgesOfDifferentPartsStayApart)
{
  Points points;
  Triangles triangles;
  MakeSoup(points, triangles);
  EXPECT_EQ(Stitch(points, triangles, { 0, 1, 2, 3 }).StitchedEdges, 0);
  // Two triangles of each part: one edge in common for each pair.
  EXPECT_EQ(Stitch(points, triangles, { 0, 0, 7, 7 }).StitchedEdges, 2);
  EXPECT_EQ(Stitch(points, triangles, { 5, 5, 5, 5 }).StitchedEdges, 6);
}
