// SPDX-License-Identifier: BSD-3-Clause
/**
 * A Multi-Triangulation made by hand, without partition, simplifier or builder: a closed tube (a torus with bumps) of
 * rings of points. Regions are runs of rings; a step takes every second ring away, except those between two regions. So
 * it is a real one: conforming, closed, saturated, its errors certified (two triangulated quads are compared through
 * their bilinear patches), with point and cell arrays and a texture seam. For tests of all that takes a patch source.
 */
#ifndef MTTestModel_h
#define MTTestModel_h

#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMath.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

namespace MTTestModel
{
struct TubeOptions
{
  int Rings = 256;  ///< of the finest level
  int Across = 8;   ///< points of a ring
  int Regions = 16; ///< of the first step; halved from step to step down to 1
  double Scale = 1.0;
  std::array<double, 3> Offset{ 0.0, 0.0, 0.0 };
  bool Arrays = true; ///< "height" (float, active scalars), "uv" (float 2, active texture coordinates, with a seam) and
                      ///< the input's cell ids
};

//------------------------------------------------------------------------------
/// Fills the arc's counts, box, normal cone and edge length from its patch.
void FillRecord(const vtkMTPatch& patch, const vtkMTLattice& lattice, vtkMTArc& arc);

//------------------------------------------------------------------------------
/// Rings and Regions are powers of two, Rings at least 8 times Regions.
std::shared_ptr<vtkMTPatchStore> MakeTube(const TubeOptions& options = TubeOptions());
}

#endif
