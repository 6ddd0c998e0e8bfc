// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCollapseRegion
 * @brief one region while its edges are collapsed: CGAL's mesh, and what CGAL does not know about it
 *
 * Places. The region's box is moved to the origin and scaled by a power of two to about unit size, so that no quadric
 * loses digits to large coordinates. Both steps are exact: a lattice point and its place here are the same number.
 * New places are snapped to the lattice when they are proposed, so every check made here speaks of the fragment as it
 * will be.
 *
 * Ranks say what may become of a vertex. A vertex may disappear into one of equal or higher rank, which then keeps its
 * place; two plain vertices, or two border vertices, meet at the best place for both. A border vertex moves along
 * border edges only, a seam vertex along seam edges only and only to the end of the edge, so that attributes stay what
 * they are.
 *
 * Wedges. Without seams each vertex has one wedge. With seams each half-edge h holds the wedge of the corner at its
 * target in its face. CGAL keeps the half-edges opposite to the two collapsing vertices, so the corners of the
 * outer triangles are saved by these before a collapse and put back after it, whichever others CGAL has deleted.
 *
 * CGAL is included here and in the sources that include this header, and in no public header.
 */
#ifndef vtkMTCollapseRegion_h
#define vtkMTCollapseRegion_h

#include "vtkMTFanMesh.h"
#include "vtkMTPatch.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <vector>

struct vtkMTSimplification;

class vtkMTCollapseRegion
{
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;

  enum RankType : unsigned char
  {
    Plain = 0,
    Border = 1, ///< on an open border that nothing outside shares
    Seam = 2,   ///< between exactly two seam edges
    Kept = 3    ///< locked, non-manifold, or a junction or an end of seams
  };

  struct VertexState
  {
    std::uint32_t Point = 0; ///< the floor's point that lives on here
    std::uint32_t Wedge = 0; ///< its wedge; where there are seams, one of them
    unsigned char Rank = Plain;
    unsigned char Lock = vtkMTFanMesh::Free;
  };

  /// Where the vertex that an edge collapses into may lie.
  enum class Rule
  {
    Refused,
    First,  ///< at the place of v0, the half-edge's source
    Second, ///< at the place of v1
    Ends,   ///< at one of the two
    Free
  };

  /// Thrown from a cost or a stop predicate when a region has taken more steps than it may.
  class StepLimitReached : public std::exception
  {
  public:
    const char* what() const noexcept override { return "the limit of steps was reached"; }
  };

  vtkMTCollapseRegion(const vtkMTPatch& floor, const vtkMTFanMesh& fans);
  vtkMTCollapseRegion(const vtkMTCollapseRegion&) = delete;
  void operator=(const vtkMTCollapseRegion&) = delete;

  Mesh Surface;
  std::vector<VertexState> States;        ///< [vertices]
  std::vector<unsigned char> Constrained; ///< [edges] 1 where both ends are locked: such an edge stays
  bool Seams = false;
  bool Split = false; ///< whether any point has several fans
  std::size_t Faces = 0;
  std::size_t Target = 0;
  std::uint64_t Steps = 0;
  std::uint64_t StepLimit = ~std::uint64_t(0);

  const Point& GetPlace(Vertex v) const { return this->Surface.point(v); }
  const VertexState& GetState(Vertex v) const { return this->States[v.idx()]; }
  Halfedge GetOpposite(Halfedge h) const { return this->Surface.opposite(h); }
  /// The next half-edge out of the same vertex, counter-clockwise.
  Halfedge GetNextOut(Halfedge h) const { return this->Surface.opposite(this->Surface.prev(h)); }

  bool IsBorderEdge(Halfedge h) const
  {
    return this->Surface.is_border(h) || this->Surface.is_border(this->Surface.opposite(h));
  }
  bool IsSeamEdge(Halfedge h) const;

  /// Counts a step; throws StepLimitReached.
  void Step()
  {
    if (++this->Steps > this->StepLimit)
    {
      throw StepLimitReached();
    }
  }

  Rule GetRule(Halfedge h) const
  {
    const unsigned char r0 = this->GetState(this->Surface.source(h)).Rank;
    const unsigned char r1 = this->GetState(this->Surface.target(h)).Rank;
    return (r0 | r1) == Plain ? Rule::Free : this->GetRuleOfRanks(h, r0, r1);
  }

  /// The nearest lattice point's place.
  Point Snap(const Point& p) const
  {
    const double m = this->Magic;
    return Point((p.x() + m) - m, (p.y() + m) - m, (p.z() + m) - m);
  }

  /// Whether the vertex keeps its identity when the edge collapses to the place: true for v0, false for v1.
  bool KeepsFirst(Halfedge h, Rule rule, const Point& place) const;

  ///@{
  /// Reasons to refuse a collapse: it would join two locked vertices by a new edge, or make one that they have a
  /// border; it would join one vertex to two fans of the same point, which put together again would give an edge with
  /// four triangles; it would turn a triangle by a right angle or more. A triangle without area has no side and may
  /// turn.
  bool MakesChord(Halfedge h, Rule rule) const;
  bool MakesDoubleEdge(Halfedge h) const;
  bool TurnsTriangle(Halfedge h, const Point& place) const;
  ///@}
  /// Whether the mesh stays a manifold without twin triangles: the link condition, and what CGAL asks for besides at
  /// borders and for closed pieces.
  bool SatisfiesLink(Halfedge h) const;
  /// Whether two neighbouring triangles would lie back to back (within a degree) after the collapse.
  bool FoldsEdge(Halfedge h, const Point& place) const;
  /// Whether triangles p0 p1 p2 and p0 p2 p3 do not lie back to back.
  static bool AreUnfolded(const Point& p0, const Point& p1, const Point& p2, const Point& p3);

  ///@{
  /// Called before and after CGAL's collapse; kept is the vertex that CGAL kept, which is either of the two.
  void BeginCollapse(Halfedge h, const Point& place);
  void EndCollapse(Vertex kept);
  ///@}

  /**
   * Closes holes of three edges between points that are free, with a bounding-box diagonal (in steps of the lattice) of
   * at most the given one, by a triangle each. Gives their number.
   */
  std::size_t CloseHoles(double maximumDiagonal);

  /// The fragment as it is now. Blocked and RemovedComponents are left alone.
  void Extract(vtkMTSimplification& result) const;
  /// Counts the edges left by what keeps them from collapsing. Where rules, topology and chords would let them, that is
  /// the shape
  /// ("fold"), or the limit of steps ("steps") when it was reached.
  void CountBlocked(std::map<std::string, std::int64_t>& blocked) const;

private:
  struct SavedCorner
  {
    Halfedge Link; // the triangle's half-edge opposite to the vertex
    std::uint32_t Apex;
    std::uint32_t Source;
    std::uint32_t Target;
  };

  void PlaceOrigin();
  void BuildSurface(const vtkMTFanMesh& fans);
  void LinkBorders(const vtkMTFanMesh& fans, const std::vector<Halfedge>& halfedges);
  void FillStates(const vtkMTFanMesh& fans, const std::vector<Halfedge>& halfedges);
  unsigned char ComputeRank(Vertex v) const;
  bool IsClosableHole(Halfedge h, double maximumDiagonal) const;
  void CloseHole(Halfedge h);
  Rule GetRuleOfRanks(Halfedge h, unsigned char r0, unsigned char r1) const;
  bool CanSlide(Halfedge h) const;
  bool IsNextToOtherFan(Vertex v, Vertex fan) const;
  bool TurnsTriangleOf(Halfedge out, Halfedge end, const Point& place) const;
  bool FoldsAtLink(Halfedge h, Halfedge link, const Point& place) const;
  void MarkNeighbours(Vertex v) const;
  const char* GetCause(Halfedge h) const;
  const char* GetCauseOfRanks(Halfedge h) const;
  void SaveCorners(Halfedge h, bool keepsFirst);
  void SaveCorner(Halfedge out, std::uint32_t apex);
  void RestoreCorners(Vertex kept);
  vtkMTPoint ToLattice(const Point& p) const;
  void ExtractHeirs(const std::vector<std::uint32_t>& pointMap, vtkMTSimplification& result) const;

  const vtkMTPatch& Floor;
  std::array<std::int64_t, 3> Origin{ 0, 0, 0 };
  double Scale = 1.0;                        // lattice steps per unit here, a power of two
  double Magic = 0.0;                        // adding and subtracting it rounds to the lattice
  std::vector<std::uint32_t> HalfedgeWedges; // [half-edges] when there are seams
  std::vector<std::uint32_t> Parents;        // [the floor's points] what each has been merged into, or itself
  VertexState Surviving;
  std::vector<SavedCorner> Saved;
  mutable std::vector<std::uint32_t> Marks; // [vertices] the neighbours of a vertex carry the present mark
  mutable std::uint32_t Mark = 0;
};

#endif
