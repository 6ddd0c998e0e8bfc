// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOrientation
 * @brief finds the triangles that run the other way round than their neighbours
 *
 * Files mix windings; a simplifier that needs oriented manifolds finds a border at every edge that both of its
 * triangles run along in the same direction. Every part of the mesh that is connected over edges of exactly two
 * triangles is looked at as one. Where it holds such an edge and can be oriented, the smaller number of its triangles
 * is to be reversed (on a tie the first triangle stays). A part that cannot be oriented, such as a Moebius strip,
 * stays as it is. Edges with more than two triangles connect nothing.
 *
 * The mesh comes in fragments. Within a fragment, connected triangles are one component: a component knows which of its
 * triangles agrees with its first one. A component that no other fragment can touch is settled at once. The others are
 * entries of a union-find with parity, joined over the edges whose ends are both shared with other fragments, which are
 * sorted externally: so memory goes with the number of fragments, not of triangles.
 */
#ifndef vtkMTOrientation_h
#define vtkMTOrientation_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"
#include "vtkMTRecordSort.h"

#include <cstdint>
#include <string>
#include <vector>

struct vtkMTHalfedgePairs;

class VTKMTCONSTRUCTION_EXPORT vtkMTOrientation
{
public:
  /// What is known of triangles that are connected.
  struct Component
  {
    std::uint32_t First = 0; ///< the smallest of the triangles' numbers
    std::uint32_t Triangles = 0;
    std::uint32_t Turned = 0; ///< those that disagree with the first one
    bool HasConflict = false; ///< whether there is an edge that both of its triangles run along alike
    bool IsOrientable = true;
    bool IsOpen = false; ///< whether it has edges that other fragments may have as well
  };

  /// A fragment by itself; made by any thread.
  struct VTKMTCONSTRUCTION_EXPORT Fragment
  {
    struct OpenEdge
    {
      std::uint32_t Low; ///< identities of the ends: the low halves of the shared points' ids
      std::uint32_t High;
      std::uint32_t Triangle;
      bool IsReversed; ///< whether it runs from High to Low
    };
    std::vector<Component> Components;
    std::vector<std::uint32_t> ComponentOf; ///< per triangle
    std::vector<unsigned char> IsTurned;    ///< per triangle, with respect to the component's first
    std::vector<OpenEdge> OpenEdges;

    /// numbers: of the triangles in the whole mesh, increasing. The mesh's first Ids.size() points are shared; pairs
    /// are those of its edges.
    void Run(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& numbers, const vtkMTHalfedgePairs& pairs);

  private:
    void Reach(std::uint32_t triangle, const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs,
      std::vector<std::uint32_t>& reached);
    void FindOpenEdges(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs);
  };

  /// memory: bytes, for sorting.
  vtkMTOrientation(vtkMTSpoolStore& store, std::size_t memory);

  ///@{
  /// All fragments, then Solve. Add gives every component of the fragment the number by which IsReversed knows it.
  /// False with a message in GetError.
  bool Add(const Fragment& fragment, std::vector<std::uint32_t>& components);
  bool Solve();
  ///@}

  /// Whether a triangle is to be reversed, by its component and whether it disagrees with the component's first
  /// triangle.
  bool IsReversed(std::uint32_t component, bool isTurned) const
  {
    const std::uint32_t what = component < LeaveAll ? this->Parts[component].Reverse : component;
    return what != LeaveAll && isTurned == (what == ReverseTurned);
  }
  ///@{
  /// In place of a number: what becomes of a component that is settled.
  static constexpr std::uint32_t LeaveAll = ~std::uint32_t(0) - 2;
  static constexpr std::uint32_t ReverseTurned = LeaveAll + 1; ///< those that disagree with the first one
  static constexpr std::uint32_t ReverseOthers = LeaveAll + 2; ///< those that agree with it
  ///@}

  std::uint64_t GetNumberOfReversedTriangles() const { return this->ReversedTriangles; }
  std::uint64_t GetNumberOfNonOrientableTriangles() const { return this->NonOrientableTriangles; }
  std::size_t GetMemorySize() const { return this->Parts.capacity() * sizeof(Part); }
  const std::string& GetError() const { return this->Error; }

private:
  struct Part
  {
    Component Own;
    std::uint32_t Parent;
    std::uint32_t Reverse; // LeaveAll, ReverseTurned or ReverseOthers
    bool Parity;           // with respect to the parent
  };

  std::uint32_t Find(std::uint32_t part, bool& parity);
  void Connect(std::uint32_t a, std::uint32_t b, bool differ, bool conflict);
  void Settle();
  std::uint32_t Count(const Component& component);

  vtkMTRecordSort Edges;
  std::vector<Part> Parts;
  std::uint64_t ReversedTriangles = 0;
  std::uint64_t NonOrientableTriangles = 0;
  std::string Error;
};

#endif
