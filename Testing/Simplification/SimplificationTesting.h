// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the simplification tests share: floors, locks, and the checks that every fragment must pass.
 */
#ifndef SimplificationTesting_h
#define SimplificationTesting_h

#include "MTTestMeshes.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTPatch.h"
#include "vtkMTSimplifier.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace SimplificationTesting
{
using MTTestMeshes::Corners;
using MTTestMeshes::Place;
using Edge = std::pair<std::uint32_t, std::uint32_t>; // directed, of points
using Locks = std::vector<unsigned char>;

inline const std::array<int, 4> AllModes = { vtkMTEdgeCollapse::FAST, vtkMTEdgeCollapse::BEST,
  vtkMTEdgeCollapse::LINDSTROM_TURK, vtkMTEdgeCollapse::GARLAND_HECKBERT };

/// A floor without wedges; its places are multiplied by steps and rounded.
vtkMTPatch MakeFloor(const std::vector<Place>& places, const std::vector<Corners>& triangles, double steps = 1 << 20);
vtkMTPatch MakeFloor(vtkPolyData* mesh, double steps = 1 << 20);

/// A grid of columns x rows points on [0, 1] x [0, 1] with height amplitude times a smooth function.
vtkMTPatch MakeGrid(int columns, int rows, double amplitude = 0.1, double steps = 1 << 20);

/// Part of the unit icosphere of 20 * 4^subdivisions triangles displaced by eight octaves of noise: the triangles
/// nearest to a direction. Its open border is where the rest of the sphere would be.
vtkMTPatch MakeFractalCap(int subdivisions, std::size_t triangles, int direction);

/// Improved Perlin noise (Perlin 2002), with a permutation made here.
double Noise(double x, double y, double z);

/// 1 for the points on edges that have one triangle.
Locks LockBorder(const vtkMTPatch& floor);
Locks LockNothing(const vtkMTPatch& floor);

/// The mesh that a result is, with wedges; identity (Ids) left out.
vtkMTPatch ToPatch(const vtkMTSimplification& result);

/// How often each directed edge occurs, triangles with a repeated point left out.
std::map<Edge, int> CountEdges(const vtkMTPatch& mesh);
/// Edges with one triangle; directed as in that triangle.
std::vector<Edge> FindBorder(const vtkMTPatch& mesh);
bool IsClosedManifold(const vtkMTPatch& mesh);
std::size_t CountComponents(const vtkMTPatch& mesh);
/// Triangles whose corners are on one line.
std::size_t CountFlatTriangles(const vtkMTPatch& mesh);

struct Outcome
{
  bool Ok = false;
  std::string Error;
  vtkMTSimplification Result;
};
Outcome Simplify(const vtkMTPatch& floor, const Locks& locked, std::size_t target, int mode = vtkMTEdgeCollapse::FAST);

/**
 * Everything that must hold whatever the floor: indices in range, wedges belong to their points, origins all different,
 * locked points in place and all there when used, edges between locked points with one triangle still there with their
 * direction, the multiplicity of every edge between fixed points (locked or non-manifold ones) as in the floor, no edge
 * with more triangles than two elsewhere, no border that was none. Gives the first thing that is wrong, or nothing.
 */
std::string FindFault(const vtkMTPatch& floor, const Locks& locked, const vtkMTSimplification& result);

/// Two-sided distance by sampling both meshes' points and random places, in lattice steps.
struct Distance
{
  double Rms = 0.0;
  double Max = 0.0;
};
Distance Measure(const vtkMTPatch& a, const vtkMTPatch& b, std::size_t samples = 8000);

/// Processor time of this thread in seconds.
double GetThreadSeconds();
}

#endif
