// SPDX-License-Identifier: BSD-3-Clause
// The test meshes are what their names say: every other test stands on that.
#include "MTTestMeshes.h"

#include <gtest/gtest.h>

#include <iostream>

namespace
{
using namespace MTTestMeshes;

void ExpectClosed(vtkPolyData* mesh, const char* name, bool byPlace = false)
{
  const EdgeFigures edges = CountEdges(mesh, byPlace);
  std::cout << name << ": " << mesh->GetNumberOfPolys() << " triangles, " << mesh->GetNumberOfPoints() << " points, "
            << edges.Inner << " inner edges\n";
  EXPECT_GT(edges.Inner, 0) << name;
  EXPECT_EQ(edges.Open, 0) << name;
  EXPECT_EQ(edges.Crowded, 0) << name;
  EXPECT_EQ(2 * edges.Inner, 3 * mesh->GetNumberOfPolys()) << name;
}

double GetVolume(vtkPolyData* mesh)
{
  double volume = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids->GetId(i), p[i]);
    }
    double n[3];
    vtkMath::Cross(p[1], p[2], n);
    volume += vtkMath::Dot(p[0], n) / 6.0;
  }
  return volume;
}
}

TEST(TestMeshes, ClosedOnesAreClosedManifoldsAndWindOutward)
{
  const std::pair<const char*, Mesh> meshes[] = { { "Icosphere", Icosphere(3) }, { "FractalSphere", FractalSphere(3) },
    { "Torus", Torus(20, 12) }, { "CadBox", CadBox(9) }, { "ManyComponents", ManyComponents(30, 1) },
    { "ClosedBowTie", ClosedBowTie(2) } };
  for (const auto& mesh : meshes)
  {
    ExpectClosed(mesh.second, mesh.first);
    EXPECT_GT(GetVolume(mesh.second), 0.0) << mesh.first;
  }
  EXPECT_NEAR(GetVolume(CadBox(9)), 6.0, 1e-5);
}

TEST(TestMeshes, SeamsAndSoupsAreClosedByPlaceOnly)
{
  const std::pair<const char*, Mesh> meshes[] = { { "SeamSphere", SeamSphere(12, 8) },
    { "HardEdgeBox", HardEdgeBox(5) }, { "SphereSoup", SphereSoup(2) } };
  for (const auto& mesh : meshes)
  {
    ExpectClosed(mesh.second, mesh.first, true);
    EXPECT_GT(CountEdges(mesh.second).Open, 0) << mesh.first;
    EXPECT_GT(GetVolume(mesh.second), 0.0) << mesh.first;
  }
}

TEST(TestMeshes, NonManifoldOnesAreWhatTheySay)
{
  EXPECT_EQ(CountEdges(Fin(9)).Crowded, 8) << "the fin's foot";
  EXPECT_EQ(CountEdges(BowTie(5, 3)).Open, 3 * 16);
  EXPECT_EQ(BowTie(5, 3)->GetNumberOfPoints(), 3 * 25 - 2);
  EXPECT_EQ(ClosedBowTie(1)->GetNumberOfPoints(), 2 * Icosphere(1)->GetNumberOfPoints() - 1);
  EXPECT_EQ(CountEdges(RandomSoup(10)).Open, 30);
  const EdgeFigures sheets = CountEdges(CoincidentSheets(5), true);
  EXPECT_EQ(sheets.Crowded, sheets.Crowded + sheets.Inner + sheets.Open) << "every edge lies on another one";
}
