// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleTree
 * @brief nearest-triangle queries on one region's mesh
 *
 * A bounding volume hierarchy with median splits along the longest side of the centroids' box, four triangles a leaf.
 * Coordinates are lattice steps relative to a common origin, so differences of corners are exact in double precision.
 * Ties go to the triangle that the traversal meets first, which depends on the mesh alone.
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

  /// origin, in steps, is subtracted from all points, and from those that queries ask for.
  vtkMTTriangleTree(const vtkMTPatch& mesh, const vtkMTPoint& origin);

  /// The triangle nearest to x (relative to the origin).
  Hit FindNearest(const Vector& x) const { return this->Find(x, nullptr); }

  /// The nearest triangle among those whose normal has a positive dot product with the direction; None when there is none.
  Hit FindNearestFacing(const Vector& x, const Vector& direction) const { return this->Find(x, &direction); }

  /// Distance from x to one triangle, and where.
  Hit Project(const Vector& x, std::uint32_t triangle) const;

  const Vector& GetCorner(std::uint32_t triangle, int corner) const { return this->Corners[triangle][corner]; }
  /// Not scaled to unit length: twice the area; zero for a degenerate triangle.
  const Vector& GetNormal(std::uint32_t triangle) const { return this->Normals[triangle]; }
  std::size_t GetNumberOfTriangles() const { return this->Corners.size(); }

private:
  struct Node
  {
    std::array<double, 6> Box;
    std::uint32_t First; // leaf: first entry of Order; inner: index of the right child, the left one follows its parent
    std::uint32_t Count; // leaf: triangles; inner: 0
  };
  void Build(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids);
  Hit Find(const Vector& x, const Vector* direction) const;
  void FindInLeaf(const Node& leaf, const Vector& x, const Vector* direction, Hit& best) const;

  std::vector<std::array<Vector, 3>> Corners;
  std::vector<Vector> Normals;
  std::vector<std::uint32_t> Order;
  std::vector<Node> Nodes;
};

#endif
