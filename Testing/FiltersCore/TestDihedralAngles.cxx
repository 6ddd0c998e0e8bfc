// SPDX-License-Identifier: BSD-3-Clause
// What the angles between triangles say of a mesh: which are CAD, whatever their number of triangles, and which are
// not.
#include "MTTestMeshes.h"

#include "vtkMTDihedralAngles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace
{
using MTTestMeshes::Random;

vtkMTDihedralAngles Measure(const vtkMTPatch& mesh)
{
  vtkMTDihedralAngles angles;
  angles.Add(mesh);
  std::printf("%zu triangles: %s\n", mesh.Triangles.size(), angles.Describe().c_str());
  return angles;
}

class Welder
{
public:
  std::uint32_t operator()(const vtkMTPoint& x)
  {
    const auto found = this->Known.insert({ x, static_cast<std::uint32_t>(this->Mesh.Points.size()) });
    if (found.second)
    {
      this->Mesh.Points.push_back(x);
    }
    return found.first->second;
  }
  vtkMTPatch Mesh;

private:
  std::map<vtkMTPoint, std::uint32_t> Known;
};

vtkMTPatch MakeCube(int cells)
{
  Welder weld;
  for (int side = 0; side < 6; ++side)
  {
    const auto at = [&](int u, int v)
    {
      vtkMTPoint x{};
      x[side % 3] = side < 3 ? 1000 * cells : 0;
      x[(side + 1) % 3] = 1000 * (side < 3 ? u : v);
      x[(side + 2) % 3] = 1000 * (side < 3 ? v : u);
      return weld(x);
    };
    for (int i = 0; i < cells; ++i)
    {
      for (int j = 0; j < cells; ++j)
      {
        weld.Mesh.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        weld.Mesh.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  return weld.Mesh;
}

// A square of cells of 1000 steps each, with random heights that are multiples of a step.
vtkMTPatch MakeTerrain(int cells, double roughness, int step)
{
  Random random(1);
  vtkMTPatch mesh;
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      // Sums of uniform numbers: few are large.
      const double height = roughness * 1000.0 * (random.Uniform() * random.Uniform() * random.Uniform());
      mesh.Points.push_back({ 1000 * i, 1000 * j, step * static_cast<int>(height / step) });
    }
  }
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      mesh.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

vtkMTPatch ToPatch(const std::vector<MTTestMeshes::Place>& places, const std::vector<MTTestMeshes::Corners>& triangles)
{
  vtkMTPatch mesh;
  for (const MTTestMeshes::Place& p : places)
  {
    vtkMTPoint x{};
    for (int i = 0; i < 3; ++i)
    {
      x[i] = static_cast<std::int32_t>(std::lround(1e6 * p[i]));
    }
    mesh.Points.push_back(x);
  }
  for (const MTTestMeshes::Corners& t : triangles)
  {
    mesh.Triangles.push_back(
      { static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]) });
  }
  return mesh;
}

vtkMTPatch MakeSphere(int levels)
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  MTTestMeshes::MakeIcosphere(levels, places, triangles);
  return ToPatch(places, triangles);
}
}

TEST(DihedralAngles, ACubeIsCadHoweverFine)
{
  for (const int cells : { 1, 2, 20, 150 })
  {
    EXPECT_TRUE(Measure(MakeCube(cells)).IsCad()) << cells;
  }
}

// The rim of its base is hard, and no edge of its side is flat.
TEST(DihedralAngles, AConeIsCad)
{
  for (const std::uint32_t sides : { 6u, 64u })
  {
    vtkMTPatch cone;
    cone.Points = { { 0, 0, 0 }, { 0, 0, 1000000 } };
    for (std::uint32_t i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / sides;
      const std::uint32_t next = 2 + (i + 1) % sides;
      cone.Points.push_back({ static_cast<std::int32_t>(std::lround(1e6 * std::cos(angle))),
        static_cast<std::int32_t>(std::lround(1e6 * std::sin(angle))), 0 });
      cone.Triangles.push_back({ 2 + i, next, 1 });
      cone.Triangles.push_back({ next, 2 + i, 0 });
    }
    EXPECT_TRUE(Measure(cone).IsCad()) << sides;
  }
}

TEST(DihedralAngles, ATetrahedronIsCadAndAnIcosahedronIsACoarseSphere)
{
  vtkMTPatch tetrahedron;
  tetrahedron.Points = { { 0, 0, 0 }, { 1000, 1000, 0 }, { 1000, 0, 1000 }, { 0, 1000, 1000 } };
  tetrahedron.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  EXPECT_TRUE(Measure(tetrahedron).IsCad());
  for (const int levels : { 0, 1, 2, 5 })
  {
    EXPECT_FALSE(Measure(MakeSphere(levels)).IsCad()) << levels;
  }
}

TEST(DihedralAngles, NoiseAndTerrainAreSmoothHoweverRough)
{
  for (const double roughness : { 0.1, 1.0, 3.0 })
  {
    for (const int step : { 1, 100 })
    {
      EXPECT_FALSE(Measure(MakeTerrain(200, roughness, step)).IsCad()) << roughness << ", " << step;
    }
  }
  const vtkMTDihedralAngles nothing;
  EXPECT_FALSE(nothing.IsCad());
}

TEST(DihedralAngles, FlatAndSharpEdgesTogetherAreCadAmongAnyOthers)
{
  vtkMTDihedralAngles angles = Measure(MakeTerrain(100, 1.0, 1));
  ASSERT_FALSE(angles.IsCad());
  const vtkMTDihedralAngles cube = Measure(MakeCube(2));
  for (int i = 0; i < 200; ++i)
  {
    angles.Add(cube);
  }
  std::printf("together: %s\n", angles.Describe().c_str());
  EXPECT_TRUE(angles.IsCad());
}

TEST(DihedralAngles, OrderHasNoInfluence)
{
  const vtkMTDihedralAngles a = Measure(MakeSphere(3));
  const vtkMTDihedralAngles b = Measure(MakeCube(7));
  vtkMTDihedralAngles ab = a;
  ab.Add(b);
  vtkMTDihedralAngles ba = b;
  ba.Add(a);
  EXPECT_EQ(ab.Describe(), ba.Describe());
  EXPECT_EQ(ab.GetLengths().Edges, a.GetLengths().Edges + b.GetLengths().Edges);
  EXPECT_EQ(ab.GetNumbers().Edges, 3u * (1280 + 588) / 2);
}
