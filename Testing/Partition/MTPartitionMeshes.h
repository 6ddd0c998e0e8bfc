// SPDX-License-Identifier: BSD-3-Clause
// Meshes for the tests of partitions: generated ones, and those of the data folder.
#ifndef MTPartitionMeshes_h
#define MTPartitionMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace MTPartitionTest
{
using Point = std::array<double, 3>;
using Points = std::vector<Point>;

struct Mesh
{
  Points Vertices;
  std::vector<std::array<std::uint32_t, 3>> Triangles;

  Points GetBarycentres() const;
  vtkSmartPointer<vtkPolyData> GetPolyData() const;
};

/// Icosphere of 20 * 4^subdivisions triangles, each vertex moved radially by Perlin noise of eight octaves.
Mesh MakeFractalSphere(int subdivisions);

/// Terrain over [0, 1]^2 of 2 n^2 triangles.
Mesh MakeTerrain(int n);

/// A scene like CAD: half of the triangles on balls whose size goes from 1 to 1e-6, the rest on a few large plates.
Mesh MakeUnevenScene();

/// Barycentres without a mesh: `count` points in the unit cube, evenly.
Points MakeCloud(std::size_t count, unsigned seed);

/// Barycentres on a helix whose spacing shrinks geometrically, over a range of 1e12.
Points MakeShrinkingHelix(std::size_t count);

/// Files of the data folder that VTK's readers of polydata take, in alphabetical order; none when the folder is not
/// there.
std::vector<std::string> GetDataFiles();

/// The file's polygons and strips as triangles, points with equal coordinates welded on request; empty when there are
/// none.
Mesh ReadMesh(const std::string& path, bool weld);
}

#endif
