// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleTree
 * @brief nearest-triangle queries on one region's mesh
 *
 * A bounding volume hierarchy with median splits along the longest side of the centroids' box, four triangles a leaf.
 * It is made when it pays: the first few queries look at all triangles instead. A query may be given a triangle to
 * begin with: a good guess spares most of the traversal. Ties go to that triangle, else to the one that is met first.
 *
 * Threads: a tree is asked by one thread at a time.
 */
#ifndef vtkMTTriangleTree_h
#define vtkMTTriangleTree_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTSurface.h"

#include <array>
#include <cstdint>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTTriangleTree
{
public:
  using Vector = vtkMTSurface::Vector;
  using Hit = vtkMTSurface::Hit;
  static constexpr std::uint32_t None = vtkMTSurface::None;

  /// So many queries are answered without a tree.
  static constexpr int QueriesWithoutTree = 40;

  /// The surface must outlive the tree.
  explicit vtkMTTriangleTree(const vtkMTSurface& surface)
    : Surface(surface)
  {
  }

  /// The triangle nearest to x; guess is a triangle to begin with, or None.
  Hit FindNearest(const Vector& x, std::uint32_t guess = None) { return this->Find(x, nullptr, guess); }

  /// The nearest triangle among those whose normal has a positive dot product with the direction; None when there is
  /// none.
  Hit FindNearestFacing(const Vector& x, const Vector& direction, std::uint32_t guess = None)
  {
    return this->Find(x, &direction, guess);
  }

private:
  struct Node
  {
    std::array<double, 6> Box;
    std::uint32_t First; // leaf: first entry of Order; inner: index of the right child, the left one follows its parent
    std::uint32_t Count; // leaf: triangles; inner: 0
  };
  struct Query
  {
    const Vector& Place;
    const Vector* Direction;
    std::uint32_t Best;
    double Best2;
  };

  Hit Find(const Vector& x, const Vector* direction, std::uint32_t guess);
  bool IsFacing(const Query& query, std::uint32_t triangle) const;
  void Look(Query& query, std::uint32_t triangle) const;
  void Traverse(Query& query) const;
  void Build();
  void BuildNode(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids);

  const vtkMTSurface& Surface;
  int Queries = 0;
  std::vector<std::uint32_t> Order;
  std::vector<Node> Nodes;
};

#endif
