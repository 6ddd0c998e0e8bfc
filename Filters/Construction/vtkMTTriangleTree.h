// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleTree
 * @brief nearest-triangle queries on one region's mesh
 *
 * A bounding volume hierarchy with median splits along the longest side of the centroids' box, four triangles a leaf.
 * Coordinates are lattice steps relative to a common origin, so differences of corners are exact in double precision;
 * normals are computed in exact integers before they are scaled to unit length. A query may be given a triangle to
 * begin with: a good guess spares most of the traversal. Ties go to that triangle, else to the one that the traversal
 * meets first.
 *
 * Threads: queries are const and may run at once.
 */
#ifndef vtkMTTriangleTree_h
#define vtkMTTriangleTree_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTTriangleTree
{
public:
  using Vector = std::array<double, 3>;

  struct Hit
  {
    static constexpr std::uint32_t None = ~std::uint32_t(0);
    std::uint32_t Triangle = None;
    double Distance2 = std::numeric_limits<double>::infinity();
    Vector Place{ 0.0, 0.0, 0.0 };   ///< the nearest point of the triangle
    Vector Weights{ 1.0, 0.0, 0.0 }; ///< its barycentric coordinates
  };

  static constexpr std::uint32_t None = Hit::None;

  /// origin, in steps, is subtracted from all points, and from those that queries ask for.
  vtkMTTriangleTree(const vtkMTPatch& mesh, const vtkMTPoint& origin);

  /// The triangle nearest to x (relative to the origin); guess is a triangle to begin with, or None.
  Hit FindNearest(const Vector& x, std::uint32_t guess = None) const { return this->Find(x, nullptr, guess); }

  /// The nearest triangle among those whose normal has a positive dot product with the direction; None when there is
  /// none.
  Hit FindNearestFacing(const Vector& x, const Vector& direction, std::uint32_t guess = None) const
  {
    return this->Find(x, &direction, guess);
  }

  /// Distance from x to one triangle, and where.
  Hit Project(const Vector& x, std::uint32_t triangle) const;

  /// The squared distance alone; infinity, found early, when it is at least limit.
  double GetDistance2(const Vector& x, std::uint32_t triangle, double limit) const;

  const Vector& GetCorner(std::uint32_t triangle, int corner) const
  {
    return this->Triangles[triangle].Corners[corner];
  }
  /// Unit length; zero for a degenerate triangle.
  const Vector& GetNormal(std::uint32_t triangle) const { return this->Triangles[triangle].Normal; }
  /// The other triangle at the edge from corner `edge` to the next; None at borders and where more than two triangles
  /// meet.
  std::uint32_t GetNeighbor(std::uint32_t triangle, int edge) const { return this->Neighbors[3 * triangle + edge]; }
  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }

private:
  struct Triangle
  {
    std::array<Vector, 3> Corners;
    Vector Normal;
  };
  struct Node
  {
    std::array<double, 6> Box;
    std::uint32_t First; // leaf: first entry of Order; inner: index of the right child, the left one follows its parent
    std::uint32_t Count; // leaf: triangles; inner: 0
  };
  void Build(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids);
  void FindNeighbors(const vtkMTPatch& mesh);
  Hit Find(const Vector& x, const Vector* direction, std::uint32_t guess) const;

  std::vector<Triangle> Triangles;
  std::vector<std::uint32_t> Neighbors;
  std::vector<std::uint32_t> Order;
  std::vector<Node> Nodes;
};

#endif
