// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCollapseRegion
 * @brief one region while its edges are collapsed: its mesh, and what may become of its vertices
 *
 * Places. The region's box is moved to the origin and scaled by a power of two to about unit size, so that no quadric
 * loses digits to large coordinates. Both steps are exact: a lattice point and its place here are the same number.
 * New places are snapped to the lattice when they are proposed, so every check made here holds for the fragment as it
 * will be.
 *
 * Ranks say what may become of a vertex. A vertex may disappear into one of equal or higher rank, which then keeps its
 * place; two plain vertices, or two border vertices, meet at the best place for both. A border vertex moves along
 * border edges only, a seam vertex along seam edges only and only to the end of the edge, so that attributes stay what
 * they are.
 *
 * Wedges. Without seams each vertex has one wedge. With seams each half-edge h holds the wedge of the corner at its
 * target in its face; when a vertex disappears, its corners take wedges of the one that it disappears into, each from
 * its own side of the seam.
 */
#ifndef vtkMTCollapseRegion_h
#define vtkMTCollapseRegion_h

#include "vtkMTCollapseMesh.h"
#include "vtkMTFanMesh.h"
#include "vtkMTPatch.h"

#include <array>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct vtkMTSimplification;

class vtkMTCollapseRegion
{
public:
  using Vector = vtkMTVector::Vector;
  static constexpr std::uint32_t None = vtkMTCollapseMesh::None;

  enum RankType : unsigned char
  {
    Plain = 0,
    Border = 1, ///< on an open border that nothing outside shares
    Seam = 2,   ///< between exactly two seam edges
    Kept = 3    ///< locked, non-manifold, a junction or an end of seams, or among seams a hub
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

  /// Thrown when a region has taken more steps than it may.
  class StepLimitReached : public std::exception
  {
  public:
    const char* what() const noexcept override { return "the limit of steps was reached"; }
  };

  vtkMTCollapseRegion(const vtkMTPatch& floor, const vtkMTFanMesh& fans);
  vtkMTCollapseRegion(const vtkMTCollapseRegion&) = delete;
  void operator=(const vtkMTCollapseRegion&) = delete;

  vtkMTCollapseMesh Mesh;
  std::vector<VertexState> States; ///< [vertices]
  bool Seams = false;
  bool Split = false; ///< whether any point has several fans
  std::size_t Faces = 0;
  std::size_t Target = 0;
  std::uint64_t Steps = 0;
  std::uint64_t StepLimit = ~std::uint64_t(0);

  /// Of a triangle; as long as twice its area.
  const Vector& GetNormal(std::uint32_t face) const { return this->Normals[face].At; }

  /// Of the vertices as they are in the floor.
  const vtkMTBox& GetBox() const { return this->Box; }

  const VertexState& GetState(std::uint32_t v) const { return this->States[v]; }

  bool IsSeamEdge(std::uint32_t h) const;

  ///@{
  /// Hubs are vertices of more edges than HubValence. No collapse makes one or takes part in one, so that a collapse
  /// takes no more time than a bound: what goes around vertices goes around others only. A hub is one no longer when
  /// collapses around it have taken its edges.
  static constexpr std::uint32_t LargestValence = 512;
  std::uint32_t HubValence = LargestValence;
  bool IsHub(std::uint32_t v) const { return this->Mesh.GetValence(v) > this->HubValence; }
  bool MakesHub(std::uint32_t h) const { return this->Mesh.GetMergedValence(h) > this->HubValence; }
  /// Whether any vertex has more edges.
  bool HasVertexAbove(std::uint32_t valence) const;
  ///@}

  /// Counts a step; throws StepLimitReached.
  void Step()
  {
    if (++this->Steps > this->StepLimit)
    {
      throw StepLimitReached();
    }
  }

  Rule GetRule(std::uint32_t h) const
  {
    const unsigned char r0 = this->GetState(this->Mesh.GetSource(h)).Rank;
    const unsigned char r1 = this->GetState(this->Mesh.GetTarget(h)).Rank;
    return (r0 | r1) == Plain ? Rule::Free : this->GetRuleOfRanks(h, r0, r1);
  }

  ///@{
  /// The nearest lattice point's place: a number is added, and subtracted again.
  double GetMagic() const { return this->Magic; }
  Vector Snap(const Vector& p) const
  {
    const double m = this->Magic;
    return { (p[0] + m) - m, (p[1] + m) - m, (p[2] + m) - m };
  }
  ///@}

  /// Whether the mesh stays a manifold without twin triangles: the link condition, with care at borders and for closed
  /// parts.
  bool SatisfiesLink(std::uint32_t h) const;
  ///@{
  /// Reasons to refuse a collapse: it would join two locked vertices by a new edge, or make one that they have a
  /// border; it would join one vertex to two fans of the same point, which assembled again would give an edge with
  /// four triangles; it would turn a triangle by a right angle or more, or lay two neighbouring triangles back to back
  /// (within a degree). A triangle without area has no side and may turn.
  bool MakesChord(std::uint32_t h, Rule rule) const;
  bool MakesDoubleEdge(std::uint32_t h) const;
  bool SpoilsShape(std::uint32_t h, const Vector& place) const;
  ///@}

  /// Collapses the edge to the place, and gives the vertex that is left.
  std::uint32_t Collapse(std::uint32_t h, const Vector& place);
  ///@{
  /// The same around a collapse of the mesh by someone else, who may keep either of the two vertices.
  void BeginCollapse(std::uint32_t h, const Vector& place);
  void EndCollapse(std::uint32_t kept);
  ///@}

  /**
   * Closes holes of three edges between points that are free, with a bounding-box diagonal (in steps of the lattice) of
   * at most the given one, by a triangle each. Gives their number.
   */
  std::size_t CloseHoles(double maximumDiagonal);

  /// The fragment as it is now. Blocked and RemovedComponents are left alone.
  void Extract(vtkMTSimplification& result) const;
  /// Counts the edges left by what keeps them from collapsing. Where rules, topology and chords would let them, that is
  /// the shape ("fold"), or the limit of steps ("steps") when it was reached.
  void CountBlocked(std::map<std::string, std::int64_t>& blocked) const;

private:
  struct SavedCorner
  {
    std::uint32_t Link; // the triangle's half-edge opposite to the vertex
    std::uint32_t Apex;
    std::uint32_t Source;
    std::uint32_t Target;
  };
  // The triangles around a vertex, those of a run that were seen first and last.
  struct Run
  {
    std::uint32_t FirstA = None;
    std::uint32_t FirstB = None;
    std::uint32_t LastA = None;
    std::uint32_t LastB = None;
    Vector FirstNormal{ 0.0, 0.0, 0.0 };
    Vector LastNormal{ 0.0, 0.0, 0.0 };
    Vector ToLastB{ 0.0, 0.0, 0.0 }; // from the place
  };

  void FindBox(const vtkMTFanMesh& fans);
  void PlaceVertices(const vtkMTFanMesh& fans);
  void FillStates(const vtkMTFanMesh& fans);
  unsigned char ComputeRank(std::uint32_t v) const;
  void UpdateRanks(std::uint32_t kept);
  Rule GetRuleOfRanks(std::uint32_t h, unsigned char r0, unsigned char r1) const;
  bool CanSlide(std::uint32_t h) const;
  bool KeepsFirst(std::uint32_t h, Rule rule, const Vector& place) const;
  bool IsNextToOtherFan(std::uint32_t v, std::uint32_t fan) const;
  static bool IsTurned(const Vector& before, const Vector& after);
  bool FoldsAtLink(std::uint32_t h, std::uint32_t link, const Vector& normal) const;
  void FillNormals();
  void UpdateNormals(std::uint32_t v);
  void UpdateStates(std::uint32_t kept);
  void UpdateNormalsOfRing();
  bool IsTetrahedron(std::uint32_t h) const;
  void MarkNeighbours(std::uint32_t v) const;
  bool IsClosableHole(std::uint32_t h, double maximumDiagonal) const;
  void CloseHole(std::uint32_t h);
  const char* GetCause(std::uint32_t h) const;
  const char* GetCauseOfRanks(std::uint32_t h) const;
  std::uint32_t NoteCollapse(std::uint32_t h, const Vector& place);
  void SaveCorners(std::uint32_t removed);
  void SaveCorner(std::uint32_t out, std::uint32_t apex);
  void RestoreCorners();
  vtkMTPoint ToLattice(const Vector& p) const;
  // The result's numbers of what the floor has, or None.
  struct Extraction
  {
    std::vector<std::uint32_t> OfPoints;
    std::vector<std::uint32_t> OfWedges;
  };
  std::uint32_t ExtractWedge(
    std::uint32_t v, std::uint32_t wedge, Extraction& numbers, vtkMTSimplification& result) const;
  void ExtractHeirs(const std::vector<std::uint32_t>& pointMap, vtkMTSimplification& result) const;

  const vtkMTPatch& Floor;
  vtkMTBox Box;
  std::array<std::int64_t, 3> Origin{ 0, 0, 0 };
  double Scale = 1.0;                                  // lattice steps per unit here, a power of two
  double Magic = 0.0;                                  // adding and subtracting it rounds to the lattice
  std::vector<std::uint32_t> Parents;                  // [the floor's points] what each has been merged into, or itself
  std::unique_ptr<vtkMTCollapseMesh::Place[]> Normals; // [faces]
  std::vector<std::uint32_t> Ring;                     // half-edges of triangles, as many as fill fours
  // What SpoilsShape has found of an edge that may be collapsed.
  struct ForeseenNormal
  {
    Vector Normal;
    std::uint32_t Face;
  };
  struct
  {
    std::uint32_t Edge = None;
    Vector Place;
    std::vector<ForeseenNormal> Normals;
  } mutable Foreseen;
  VertexState Surviving;
  std::vector<SavedCorner> Saved;
  mutable std::vector<std::uint32_t> Marks; // [vertices] the neighbours of a vertex carry the present mark
  mutable std::uint32_t Mark = 0;
};

#endif
