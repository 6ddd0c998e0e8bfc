// SPDX-License-Identifier: BSD-3-Clause
/**
 * Stiff and extreme meshes: what makes simplification, partition and certification hard, each made by a function of
 * about how many triangles it is to have. MTStiffCases.h has the table of them that tests and report go through.
 */
#ifndef MTStiffMeshes_h
#define MTStiffMeshes_h

#include "MTTestMeshes.h"

namespace MTStiffMeshes
{
using MTTestMeshes::Corners;
using MTTestMeshes::Mesh;
using MTTestMeshes::Place;

/// Points and triangles while a mesh is made.
struct Parts
{
  std::vector<Place> Places;
  std::vector<Corners> Triangles;

  vtkIdType Add(double x, double y, double z);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c) { this->Triangles.push_back({ a, b, c }); }
  /// A grid of columns x rows points; function gives the place of (i, j).
  template <class Function>
  void AddGrid(int columns, int rows, const Function& function)
  {
    const auto first = static_cast<vtkIdType>(this->Places.size());
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        this->Places.push_back(function(i, j));
      }
    }
    const std::vector<Corners> triangles = MTTestMeshes::GridTriangles(columns, rows, first);
    this->Triangles.insert(this->Triangles.end(), triangles.begin(), triangles.end());
  }
  Mesh Make(int type = VTK_DOUBLE) const { return MTTestMeshes::Make(this->Places, this->Triangles, type); }
};

/// Columns, and rows, of a square grid of about so many triangles.
int GetSide(int triangles);

///@{
/// Every place of a mesh, changed. The result has coordinates of the same type.
Mesh Scale(const Mesh& mesh, double x, double y, double z);
Mesh Move(const Mesh& mesh, double x, double y, double z);
/// Turned about an axis that is parallel to nothing, then moved; in double precision.
Mesh TurnAndMove(const Mesh& mesh, double angle, const Place& offset);
///@}

///@{
/// Scales: a sphere with bumps, 20 * 4^k triangles, in double or single precision.
Mesh BumpySphere(int triangles, int type = VTK_DOUBLE);
/// A height field with relief of the given height on a square of unit size.
Mesh Relief(int triangles, double height);
/// Triangle areas over 12 orders of magnitude: cells grow by a constant factor along both axes, and so does the relief.
Mesh Graded(int triangles, double smallest);
/// The same in rings about a centre, which grow outwards: all triangles are well shaped.
Mesh GradedRings(int triangles, double smallest);
/// Triangles of that aspect: a wavy strip of rows that are that much closer than columns.
Mesh Slivers(int triangles, double aspect);
/// A ruled strip whose triangles are as long as the mesh.
Mesh Needles(int triangles);
///@}

///@{
/// Thin and sharp things.
/// Rows of teeth, thin in x, whose walls are rough or waved.
Mesh RoughComb(int triangles, int teeth);
Mesh WavedComb(int triangles, int teeth);
/// A closed plate, and two sheets, which are waved and lie that far apart.
Mesh ThinPlate(int triangles, double thickness, double waves);
Mesh ThinSheets(int triangles, double distance);
/// A sphere of which one vertex in twenty is pulled out, up to thirty radii.
Mesh Spikes(int triangles);
/// Cubes of a Menger sponge: 20^k of them.
Mesh Sponge(int triangles);
/// A sheet of paper that was folded along random planes: it crosses itself.
Mesh Crumpled(int triangles);
///@}

///@{
/// Flat and developable surfaces.
Mesh NoisyPlane(int triangles, double noise);
/// Exactly flat: z = 0.
Mesh Plane(int triangles);
/// Exactly flat, in no coordinate plane, and on the lattice.
Mesh SlopingPlane(int triangles);
Mesh Cylinder(int triangles);
Mesh Cone(int triangles);
/// Rings of points, a power of two on each, so that all four corners of each cell lie on a circle.
Mesh Rings(int triangles);
/// The same heights in steps: every cell's corners lie on a circle, and so do those of many cells.
Mesh Terraces(int triangles);
///@}

///@{
/// Topology.
Mesh Components(int triangles);
Mesh Tetrahedra(int triangles);
Mesh Fan(int triangles);
/// Two of them with one apex.
Mesh TwoFans(int triangles);
/// Closed: two apexes over one ring.
Mesh Spindle(int triangles);
/// Squares of which every other one is there, corner to corner.
Mesh Checkerboard(int triangles);
Mesh Moebius(int triangles);
Mesh Klein(int triangles);
/// Triangles around one barycentre.
Mesh Barycentres(int triangles);
/// Triangles at one edge, as a book's pages.
Mesh Pages(int triangles);
/// Blocks of cells that meet blocks of half the size without sharing the points in between.
Mesh TJunctions(int triangles);
///@}

///@{
/// Content.
Mesh FewTriangles(int triangles); ///< 0, 1 or 2
/// The same places with zeros of both signs.
Mesh SignedZeros(int triangles);
/// NaN and infinity among the coordinates of one point in a hundred.
Mesh NotFinite(int triangles);
///@}
}

#endif
