// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBorderOrder
 * @brief the points on the border of a part of a mesh, one after the other along it
 *
 * New identities are numbered in this order. A patch of a file stores the identities of its shared points along
 * its border as well: those that were made together follow each other there, and a whole run takes a few bytes. An
 * edge is on the border when an odd number of the part's triangles use it, so every border is made of closed walks,
 * whatever the mesh and its orientation are. A walk begins at its point of the least index and goes on to the neighbour
 * of the least index that was not met yet.
 *
 * Where nothing is known of the mesh's edges, most of them are passed over unseen: every use of an edge is added, bit
 * by bit, to both of its points, so what is used an even number of times leaves nothing behind. The edges of points
 * that have nothing left are not looked at. Bits are those of a hash of the other point. Should hashes ever add up to
 * nothing by themselves, an edge is missed, and identities run in another order, which is as good.
 */
#ifndef vtkMTBorderOrder_h
#define vtkMTBorderOrder_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

struct vtkMTHalfedgePairs;

class VTKMTCONSTRUCTION_EXPORT vtkMTBorderOrder
{
public:
  ///@{
  /// The border of the whole mesh; every point of it once.
  static std::vector<std::uint32_t> Find(const vtkMTPatch& mesh);
  static std::vector<std::uint32_t> Find(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs);
  ///@}

  /// For the borders of several parts of a mesh, which must outlive it.
  explicit vtkMTBorderOrder(const vtkMTPatch& mesh);
  /// The border of the given triangles of the mesh; every point of it once.
  std::vector<std::uint32_t> Find(const std::vector<std::uint32_t>& triangles);

private:
  void FindOddEdges(const std::vector<std::uint32_t>& triangles, std::vector<std::uint64_t>& edges);

  const vtkMTPatch& Mesh;
  std::vector<std::uint64_t> Hashes; // of the points
  std::vector<std::uint64_t> Left;   // of the uses of each point's edges; none between calls
};

#endif
