// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrientation.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>

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
  EXPECT_TRUE(vtkMTOrientation::Run(mesh).Reversed.empty());
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
    const vtkMTOrientation orientation = vtkMTOrientation::Run(mesh);
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
  const vtkMTOrientation orientation = vtkMTOrientation::Run(mesh);
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
  const vtkMTOrientation orientation = vtkMTOrientation::Run(mesh);
  EXPECT_EQ(orientation.NonOrientableTriangles, strip);
  EXPECT_EQ(orientation.Reversed, std::vector<std::uint32_t>{ static_cast<std::uint32_t>(strip) + 4 });
}

TEST(Orientation, NothingIsConnectedOverEdgesOfThreeTriangles)
{
  // A fin on the edge 0 1 of two triangles: the edge says nothing about anybody's winding.
  vtkMTPatch mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  const vtkMTOrientation orientation = vtkMTOrientation::Run(mesh);
  EXPECT_TRUE(orientation.Reversed.empty());
  EXPECT_EQ(orientation.NonOrientableTriangles, 0u);
}
