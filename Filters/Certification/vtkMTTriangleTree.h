// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleTree
 * @brief nearest-triangle queries on one region's mesh
 *
 * A bounding volume hierarchy with median splits along the longest side of the centroids' box, four triangles a leaf.
 * It is made when it pays: the first queries look at the boxes of runs of triangles instead (vtkMTBoxRuns), which cost
 * far less to make and do well as neighbours are mostly near in a patch's order. A query may be given a triangle to
 * begin with: a good guess spares most of the traversal. Ties go to that triangle, else to the one that is met first.
 *
 * Threads: a tree is asked by one thread at a time.
 */
#ifndef vtkMTTriangleTree_h
#define vtkMTTriangleTree_h

#include "vtkMTBoxRuns.h"
#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTSurface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTTriangleTree
{
public:
  using Vector = vtkMTSurface::Vector;
  using Hit = vtkMTSurface::Hit;
  static constexpr std::uint32_t None = vtkMTSurface::None;

  /// So many queries are answered without a tree.
  static constexpr int QueriesWithoutTree = 1024;

  static constexpr std::uint64_t Unlimited = ~std::uint64_t(0);
  /// Nodes and triangles to look at, all queries together: in proportion to the surface, and many times what surfaces
  /// need.
  static std::uint64_t GetEnoughEffort(const vtkMTSurface& surface)
  {
    return 1000 * std::max<std::uint64_t>(surface.GetNumberOfTriangles(), 1000);
  }

  /// The surface must outlive the tree. mostEffort: nodes and triangles, all queries together.
  explicit vtkMTTriangleTree(const vtkMTSurface& surface, std::uint64_t mostEffort = Unlimited)
    : Surface(surface)
    , MostEffort(mostEffort)
  {
  }

  /// The triangle nearest to x; guess is a triangle to begin with, or None.
  Hit FindNearest(const Vector& x, std::uint32_t guess = None) { return this->Find({ x, nullptr }, guess); }

  /// The nearest triangle whose squared distance is below a limit; None when there is none.
  Hit FindWithin(const Vector& x, double limit2) { return this->Find({ x, nullptr, None, limit2 }, None); }

  /// The nearest triangle among those whose normal has a positive dot product with the direction; None when there is
  /// none.
  Hit FindNearestFacing(const Vector& x, const Vector& direction, std::uint32_t guess = None)
  {
    return this->Find({ x, &direction }, guess);
  }

  /// Nodes and triangles that were looked at by way of the tree.
  std::uint64_t GetEffort() const { return this->Effort; }
  /// Whether the last answer and all that follow may be other triangles than the nearest.
  bool IsExhausted() const { return this->Effort > this->MostEffort; }

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
    std::uint32_t Best = None;
    double Best2 = std::numeric_limits<double>::infinity();
  };

  Hit Find(Query query, std::uint32_t guess);
  bool IsFacing(const Query& query, std::uint32_t triangle) const;
  void Look(Query& query, std::uint32_t triangle) const;
  void LookAtRuns(Query& query) const;
  void Traverse(Query& query);
  void MakeRuns();
  void Build();
  void BuildNode(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& centroids);

  const vtkMTSurface& Surface;
  const std::uint64_t MostEffort;
  int Queries = 0;
  std::uint64_t Effort = 0; // of all queries together
  std::optional<vtkMTBoxRuns> Runs;
  std::vector<std::uint32_t> Order;
  std::vector<Node> Nodes;
};

#endif
