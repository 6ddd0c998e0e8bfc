// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTOrientation.h"
#include "vtkMTPatchSplitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>

namespace
{
// A closed torus of n x n quads, or a band whose ends are joined with a half turn.
vtkMTPatch MakeRing(std::uint32_t n, std::uint32_t across, bool isTwisted)
{
  vtkMTPatch mesh;
  const std::uint32_t rows = isTwisted ? across + 1 : across;
  const auto point = [=](std::uint32_t i, std::uint32_t j)
  {
    const bool isOver = i == n;
    j = isTwisted ? (isOver ? across - j : j) : j % across;
    return (isOver ? 0 : i) * rows + j;
  };
  for (std::uint32_t i = 0; i < n * rows; ++i)
  {
    mesh.Points.push_back({ static_cast<std::int32_t>(i), 0, 0 });
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    for (std::uint32_t j = 0; j < across; ++j)
    {
      mesh.Triangles.push_back({ point(i, j), point(i + 1, j), point(i + 1, j + 1) });
      mesh.Triangles.push_back({ point(i, j), point(i + 1, j + 1), point(i, j + 1) });
    }
  }
  return mesh;
}

void Append(vtkMTPatch& mesh, const vtkMTPatch& more)
{
  const auto first = static_cast<std::uint32_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), more.Points.begin(), more.Points.end());
  for (const vtkMTTriangle& t : more.Triangles)
  {
    mesh.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
}

void Turn(vtkMTPatch& mesh, std::uint32_t t)
{
  std::swap(mesh.Triangles[t][1], mesh.Triangles[t][2]);
}

struct Result
{
  std::vector<std::uint32_t> Reversed;
  std::uint64_t NonOrientableTriangles;
};

// The mesh in fragments: triangle t is in fragment regions[t].
Result Orient(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& regions, std::uint32_t count)
{
  std::vector<std::set<std::uint32_t>> users(mesh.Points.size());
  std::vector<std::vector<std::uint32_t>> triangles(count);
  for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    triangles[regions[t]].push_back(t);
    for (const std::uint32_t p : mesh.Triangles[t])
    {
      users[p].insert(regions[t]);
    }
  }
  std::vector<unsigned char> isShared;
  std::vector<std::uint64_t> ids;
  for (std::uint32_t p = 0; p < mesh.Points.size(); ++p)
  {
    isShared.push_back(users[p].size() > 1 ? 1 : 0);
    ids.push_back(vtkMTPatchSplitter::MakeInputId(p));
  }
  std::vector<std::uint32_t> scratch(2 * mesh.Points.size(), vtkMTPatchSplitter::None);
  vtkMTMemorySpoolStore store;
  vtkMTOrientation orientation(store, std::size_t(1) << 20);
  std::vector<vtkMTOrientation::Fragment> fragments(count);
  std::vector<std::vector<std::uint32_t>> components(count);
  for (std::uint32_t f = 0; f < count; ++f)
  {
    const vtkMTPatch part = vtkMTPatchSplitter::Extract(mesh, triangles[f], isShared, ids, {}, {}, scratch);
    fragments[f].Run(part, triangles[f], vtkMTHalfedgePairs(part));
    EXPECT_TRUE(orientation.Add(fragments[f], components[f]));
  }
  EXPECT_TRUE(orientation.Solve()) << orientation.GetError();
  Result result;
  for (std::uint32_t f = 0; f < count; ++f)
  {
    for (std::size_t i = 0; i < triangles[f].size(); ++i)
    {
      if (orientation.IsReversed(components[f][fragments[f].ComponentOf[i]], fragments[f].IsTurned[i] != 0))
      {
        result.Reversed.push_back(triangles[f][i]);
      }
    }
  }
  std::sort(result.Reversed.begin(), result.Reversed.end());
  EXPECT_EQ(result.Reversed.size(), orientation.GetNumberOfReversedTriangles());
  result.NonOrientableTriangles = orientation.GetNumberOfNonOrientableTriangles();
  return result;
}

// The same in one fragment, in runs and in fragments without any shape.
Result Orient(const vtkMTPatch& mesh)
{
  std::mt19937 random(9);
  const std::size_t count = mesh.Triangles.size();
  const Result result = Orient(mesh, std::vector<std::uint32_t>(count, 0), 1);
  for (std::uint32_t fragments = 2; fragments < 40; fragments = 2 * fragments + 1)
  {
    std::vector<std::uint32_t> runs;
    std::vector<std::uint32_t> shapeless;
    for (std::size_t t = 0; t < count; ++t)
    {
      runs.push_back(static_cast<std::uint32_t>(t * fragments / count));
      shapeless.push_back(random() % fragments);
    }
    for (const auto& regions : { runs, shapeless })
    {
      const Result other = Orient(mesh, regions, fragments);
      EXPECT_EQ(result.Reversed, other.Reversed) << fragments << " fragments";
      EXPECT_EQ(result.NonOrientableTriangles, other.NonOrientableTriangles) << fragments << " fragments";
    }
  }
  return result;
}

std::size_t CountConflicts(const vtkMTPatch& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      ++uses[{ t[c], t[(c + 1) % 3] }];
    }
  }
  std::size_t conflicts = 0;
  for (const auto& [edge, count] : uses)
  {
    conflicts += count > 1 ? 1 : 0;
  }
  return conflicts;
}
}

TEST(Orientation, OrientedMeshesStayAsTheyAre)
{
  const vtkMTPatch mesh = MakeRing(12, 9, false);
  ASSERT_EQ(CountConflicts(mesh), 0u);
  EXPECT_TRUE(Orient(mesh).Reversed.empty());
}

TEST(Orientation, ExactlyTheTurnedTrianglesAreFound)
{
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round)
  {
    vtkMTPatch mesh = MakeRing(12, 9, false);
    Append(mesh, MakeRing(7, 5, false));
    std::vector<std::uint32_t> turned;
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      if (random() % 100 < static_cast<unsigned>(round) % 30)
      {
        turned.push_back(t);
        Turn(mesh, t);
      }
    }
    const Result orientation = Orient(mesh);
    EXPECT_EQ(orientation.Reversed, turned);
    EXPECT_EQ(orientation.NonOrientableTriangles, 0u);
  }
}

TEST(Orientation, MostTrianglesKeepTheirWinding)
{
  std::mt19937 random(6);
  vtkMTPatch mesh = MakeRing(20, 20, false);
  for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (random() % 100 < 70)
    {
      Turn(mesh, t);
    }
  }
  const Result orientation = Orient(mesh);
  EXPECT_LT(orientation.Reversed.size(), mesh.Triangles.size() / 2);
  std::printf("%zu of %zu turned, %zu conflicts before\n", orientation.Reversed.size(), mesh.Triangles.size(),
    CountConflicts(mesh));
  for (std::uint32_t t : orientation.Reversed)
  {
    Turn(mesh, t);
  }
  EXPECT_EQ(CountConflicts(mesh), 0u);
}

TEST(Orientation, AMoebiusStripIsLeftAndItsNeighboursAreNot)
{
  vtkMTPatch mesh = MakeRing(15, 3, true);
  const std::size_t strip = mesh.Triangles.size();
  Append(mesh, MakeRing(8, 8, false));
  Turn(mesh, static_cast<std::uint32_t>(strip) + 4);
  const Result orientation = Orient(mesh);
  EXPECT_EQ(orientation.NonOrientableTriangles, strip);
  EXPECT_EQ(orientation.Reversed, std::vector<std::uint32_t>{ static_cast<std::uint32_t>(strip) + 4 });
}

TEST(Orientation, NothingIsConnectedOverEdgesOfThreeTriangles)
{
  // A fin on the edge 0 1 of two triangles: the edge says nothing about anybody's winding.
  vtkMTPatch mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  const Result orientation = Orient(mesh);
  EXPECT_TRUE(orientation.Reversed.empty());
  EXPECT_EQ(orientation.NonOrientableTriangles, 0u);
}
