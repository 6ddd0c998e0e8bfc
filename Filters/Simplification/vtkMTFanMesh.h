// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFanMesh
 * @brief any triangle mesh as an oriented manifold: its points split into fans, its edges paired
 *
 * A half-edge structure takes oriented manifolds only, and CGAL's add_face rejects the other triangles without a word.
 * Here every triangle stays: two triangles are neighbours across an edge when the edge belongs to exactly these two and
 * they run along it in opposite directions; the triangles around a point that are connected through such edges are a
 * fan; every fan becomes a vertex of its own, which remembers its point. Splitting may leave just two of the triangles
 * of a fin at an edge between two fans: these are paired too. A point with several fans must keep its place, so that
 * all of them can be assembled again at the end: its vertices are locked. Since an edge that cannot be paired always
 * has several fans at both ends, all non-manifold places are locked.
 *
 * Triangles with two corners at the same point are left out. Two triangles with the same three points are never paired
 * with each other: that keeps every closed fan at three triangles or more and the mesh a simplicial complex.
 *
 * Corner c = 3 t + k is corner k of triangle t; edge c runs from corner c to the next corner of its triangle.
 */
#ifndef vtkMTFanMesh_h
#define vtkMTFanMesh_h

#include "vtkMTHalfedgePairs.h"
#include "vtkMTPatch.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTFanMesh
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  enum LockType : unsigned char
  {
    Free = 0,
    Outside = 1,    ///< the caller locked the point
    NonManifold = 2 ///< the point has several fans
  };

  std::vector<std::uint32_t> Vertex;   ///< [3 t] the vertex of each corner
  std::vector<std::uint32_t> Wedge;    ///< [3 t] the floor's wedge of each corner; empty where points have one each
  std::vector<std::uint32_t> Opposite; ///< [3 t] the edge that each edge is paired with, or None at a border
  std::vector<std::uint32_t> Point;    ///< [v] the floor's point of each vertex
  std::vector<std::uint32_t> WedgeOf;  ///< [v] the floor's wedge of a corner of each vertex
  std::vector<unsigned char> Lock;     ///< [v] LockType bits
  bool Seams = false;                  ///< whether the wedges differ across any paired edge

  std::size_t GetNumberOfTriangles() const { return this->Vertex.size() / 3; }
  std::size_t GetNumberOfVertices() const { return this->Point.size(); }

  static std::uint32_t Next(std::uint32_t corner) { return vtkMTHalfedgePairs::Next(corner); }
  static std::uint32_t Previous(std::uint32_t corner) { return vtkMTHalfedgePairs::Previous(corner); }

  /// False, with the reason, when an index is out of range.
  bool Build(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::string& error);

private:
  bool TakeTriangles(const vtkMTPatch& floor, std::string& error);
  void PairEqual(std::vector<std::uint32_t>& edges);
  void SplitIntoFans(std::size_t points, const std::vector<unsigned char>& locked);
  void WalkFan(std::uint32_t corner, std::uint32_t vertex, std::vector<std::uint32_t>& vertexOfCorner) const;
  void PairAgain();
  void TakeWedges(const vtkMTPatch& floor);
  void FindSeams();
};

#endif
