// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCollapseMesh
 * @brief an oriented triangle manifold with border, in flat arrays, whose edges can be collapsed
 *
 * Half-edges come in pairs, one for each direction of an edge: h and h ^ 1 are opposite. A half-edge knows its target,
 * its face (None along a border) and its neighbours around the face or along the border. What is removed stays in the
 * arrays: an edge without targets, a face or vertex without a half-edge. Indices never change.
 *
 * Where seams run, half-edge h carries the wedge of the corner at its target in its face.
 *
 * The number of edges of each vertex is kept, so that what goes around vertices can leave out those that have too many.
 */
#ifndef vtkMTCollapseMesh_h
#define vtkMTCollapseMesh_h

#include "vtkMTVector.h"

#include <cstdint>
#include <vector>

class vtkMTFanMesh;

class vtkMTCollapseMesh
{
public:
  using Vector = vtkMTVector::Vector;
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  struct Halfedge
  {
    std::uint32_t Target = None;
    std::uint32_t Next = None;
    std::uint32_t Previous = None;
    std::uint32_t Face = None;
  };

  /// Where a vertex lies, and so much that a register of four numbers is loaded at once.
  struct alignas(32) Place
  {
    Vector At;
    double Unused;
  };

  std::vector<Halfedge> Halfedges;     ///< [2 edges]
  std::vector<std::uint32_t> Wedges;   ///< [2 edges] empty without seams
  std::vector<std::uint32_t> Faces;    ///< [faces] a half-edge of each
  std::vector<std::uint32_t> Outs;     ///< [vertices] a half-edge that starts from each
  std::vector<Place> Places;           ///< [vertices]
  std::vector<std::uint32_t> Valences; ///< [vertices] numbers of edges

  /// Takes over the fans; Places are left for the caller to fill.
  explicit vtkMTCollapseMesh(const vtkMTFanMesh& fans);

  std::uint32_t GetNumberOfEdges() const { return static_cast<std::uint32_t>(this->Halfedges.size() / 2); }
  bool IsEdge(std::uint32_t edge) const { return this->Halfedges[2 * edge].Target != None; }
  bool IsFace(std::uint32_t face) const { return this->Faces[face] != None; }

  std::uint32_t GetTarget(std::uint32_t h) const { return this->Halfedges[h].Target; }
  std::uint32_t GetSource(std::uint32_t h) const { return this->Halfedges[h ^ 1].Target; }
  std::uint32_t GetNext(std::uint32_t h) const { return this->Halfedges[h].Next; }
  std::uint32_t GetPrevious(std::uint32_t h) const { return this->Halfedges[h].Previous; }
  std::uint32_t GetFace(std::uint32_t h) const { return this->Halfedges[h].Face; }
  bool IsBorder(std::uint32_t h) const { return this->Halfedges[h].Face == None; }
  bool IsBorderEdge(std::uint32_t h) const { return this->IsBorder(h) || this->IsBorder(h ^ 1); }
  bool IsBorderVertex(std::uint32_t vertex) const;
  std::uint32_t GetValence(std::uint32_t vertex) const { return this->Valences[vertex]; }
  /// Of the vertex that is left when the edge is collapsed.
  std::uint32_t GetMergedValence(std::uint32_t h) const
  {
    return this->GetValence(this->GetSource(h)) + this->GetValence(this->GetTarget(h)) - 2 -
      (this->IsBorder(h) ? 0 : 1) - (this->IsBorder(h ^ 1) ? 0 : 1);
  }
  /// The next half-edge out of the same vertex, counter-clockwise.
  std::uint32_t GetNextOut(std::uint32_t h) const { return this->Halfedges[h].Previous ^ 1; }
  const Vector& GetPlace(std::uint32_t vertex) const { return this->Places[vertex].At; }

  void Link(std::uint32_t h, std::uint32_t next)
  {
    this->Halfedges[h].Next = next;
    this->Halfedges[next].Previous = h;
  }

  /**
   * Merges the source of h into its target. The edge, its triangles, and in each triangle the edge at the source, are
   * removed; wedges are left as they are. Only where the link condition holds.
   */
  void Collapse(std::uint32_t h);
  /// Before the edge is collapsed, by Collapse or by someone else: the valences afterwards.
  void UpdateValences(std::uint32_t h);
  /// Closes a border of three edges with a triangle.
  void FillHole(std::uint32_t h);
  /// Whether every index is what it says, in the whole mesh.
  bool IsValid() const;

private:
  void RemoveSide(std::uint32_t side, std::uint32_t dying, std::uint32_t heir);
  void LinkBorders(const vtkMTFanMesh& fans, const std::uint32_t* halfedges, const std::vector<std::uint32_t>& borders);
};

#endif
