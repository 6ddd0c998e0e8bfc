// SPDX-License-Identifier: BSD-3-Clause
/**
 * Small meshes for tests, every one made by a function of a few parameters and a seed, the same on every machine up to
 * the rounding of the mathematical functions.
 *
 *   closed manifolds: Icosphere, FractalSphere, Torus, CadBox, ManyComponents
 *   open ones: Terrain, CoincidentSheets
 *   non-manifold: BowTie (open), ClosedBowTie, Fin
 *   points that are not shared: SphereSoup (weldable), RandomSoup (not)
 *   wedges: SeamSphere (texture coordinates), HardEdgeBox (normals)
 *   cells that are no triangles: Quads, Strips, Polygons
 *   bad content: Dirty
 */
#ifndef MTTestMeshes_h
#define MTTestMeshes_h

// What tests need to look at a mesh comes with it.
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace MTTestMeshes
{
using Mesh = vtkSmartPointer<vtkPolyData>;
using Place = std::array<double, 3>;
using Corners = std::array<vtkIdType, 3>;

//------------------------------------------------------------------------------
/// SplitMix64: the standard library's distributions differ between implementations.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Next()
  {
    std::uint64_t z = (this->State += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double Uniform() { return static_cast<double>(this->Next() >> 11) * 0x1p-53; }
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  std::uint64_t Below(std::uint64_t limit) { return this->Next() % limit; }

private:
  std::uint64_t State;
};

//------------------------------------------------------------------------------
Mesh Make(const std::vector<Place>& places, const std::vector<Corners>& triangles, int type = VTK_FLOAT);

//------------------------------------------------------------------------------
/// A smooth pseudo-random function of space with values around [-1, 1].
double Bumps(const Place& p, std::uint64_t seed);

//------------------------------------------------------------------------------
/// Twelve points and twenty triangles, split `subdivisions` times: 20 * 4^subdivisions triangles, on the unit sphere.
void MakeIcosphere(int subdivisions, std::vector<Place>& places, std::vector<Corners>& triangles);

//------------------------------------------------------------------------------
Mesh Icosphere(int subdivisions);

//------------------------------------------------------------------------------
/// A closed sphere with bumps on many scales: 20 * 4^subdivisions triangles.
Mesh FractalSphere(int subdivisions, std::uint64_t seed = 1);

//------------------------------------------------------------------------------
/// Triangles of a grid of columns x rows points, 2 (columns - 1) (rows - 1), counter-clockwise in (column, row).
std::vector<Corners> GridTriangles(int columns, int rows, vtkIdType first = 0);

//------------------------------------------------------------------------------
/// An open height field on [0, 1] x [0, 1]; with holes, one triangle in twenty and some square patches are missing.
Mesh Terrain(int columns, int rows, std::uint64_t seed = 1, bool holes = false);

//------------------------------------------------------------------------------
/// A closed torus of 2 * around * across triangles, radii 1 and 0.4.
Mesh Torus(int around, int across);

//------------------------------------------------------------------------------
/// size x size grids, corner to corner along the diagonal: `count` sheets, each sharing one point with the next.
Mesh BowTie(int size, int count = 2);

//------------------------------------------------------------------------------
/// Two closed spheres that share one point: every edge has two triangles, the shared point two fans.
Mesh ClosedBowTie(int subdivisions);

//------------------------------------------------------------------------------
/// A flat size x size grid with a third sheet standing on its middle line: edges with three triangles. size is odd.
Mesh Fin(int size);

//------------------------------------------------------------------------------
/// The same triangles, each with three points of its own, as STL files have them.
Mesh Soup(vtkPolyData* mesh);

//------------------------------------------------------------------------------
Mesh SphereSoup(int subdivisions);

//------------------------------------------------------------------------------
/// Random small triangles in the unit cube that have nothing to do with each other.
Mesh RandomSoup(int count, std::uint64_t seed = 1, double size = 0.1);

//------------------------------------------------------------------------------
/// count small closed spheres of 20 * 4^subdivisions triangles each, of random sizes, at random places.
Mesh ManyComponents(int count, int subdivisions = 0, std::uint64_t seed = 1);

//------------------------------------------------------------------------------
/// Sheets of size x size points that lie exactly on each other and share nothing; all wind the same way.
Mesh CoincidentSheets(int size, int sheets = 2);

//------------------------------------------------------------------------------
Mesh CadBox(int cells, std::uint64_t seed = 1);

//------------------------------------------------------------------------------
Mesh HardEdgeBox(int cells, std::uint64_t seed = 1);

//------------------------------------------------------------------------------
/// A closed sphere with texture coordinates: the seam's points come twice, the poles' once per sector, bit for bit the
/// same places. 2 * around * (down - 1) triangles.
Mesh SeamSphere(int around, int down);

//------------------------------------------------------------------------------
/// The terrain's surface as quads.
Mesh Quads(int columns, int rows);

//------------------------------------------------------------------------------
/// The terrain's surface as triangle strips, one per row of cells.
Mesh Strips(int columns, int rows);

//------------------------------------------------------------------------------
/// A row of flat polygons: `count` times a concave "L" of six points (area 3) and a square of four (area 1).
Mesh Polygons(int count);

//------------------------------------------------------------------------------
/// What Dirty put into its mesh.
struct Dirt
{
  vtkIdType Sound = 0;
  vtkIdType RepeatedPoint = 0; ///< a triangle with the same point twice
  vtkIdType Flat = 0;          ///< three different points on a line
  vtkIdType NotFinite = 0;     ///< a point with NaN or infinity
  vtkIdType OutOfRange = 0;    ///< a point that does not exist
  vtkIdType Duplicate = 0;     ///< the same triangle once more
};

/// A terrain of size x size points with every kind of bad triangle added, `each` times.
Mesh Dirty(int size, int each, Dirt* dirt = nullptr, bool outOfRange = true);

//------------------------------------------------------------------------------
/// Nothing but triangles that repeat a point.
Mesh OnlyDegenerate(int count);

//------------------------------------------------------------------------------
/**
 * Adds arrays of many kinds to any mesh. Points: "elevation" (double, active scalars: the place's z), "colour"
 * (unsigned char, 3 components), "label" (int: x below or above the middle), "tensor" (float, 9 components with names
 * on the first two), "ids" (vtkIdType, global ids). Cells: "face" (vtkIdType: the cell's number), "weight" (float),
 * "flag" (short).
 */
void AddArrays(vtkPolyData* mesh);

//------------------------------------------------------------------------------
struct EdgeFigures
{
  vtkIdType Open = 0;    ///< edges with one triangle
  vtkIdType Inner = 0;   ///< with two, in opposite directions
  vtkIdType Crowded = 0; ///< all others
};

/// Edges of a mesh of triangles by the points' indices, or by their places when byPlace.
EdgeFigures CountEdges(vtkPolyData* mesh, bool byPlace = false);
}

#endif
