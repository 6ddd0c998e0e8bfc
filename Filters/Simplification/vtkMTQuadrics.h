// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTQuadrics
 * @brief memoryless quadrics: cost and place of a collapse from the triangles as they are now
 *
 * The quadric of a vertex is the sum, over the triangles around it, of area times squared distance to the triangle's
 * plane (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997). After a collapse the
 * quadrics of the kept vertex and of its neighbours are made anew from the triangles as they then are (Lindstrom and
 * Turk, "Evaluation of Memoryless Simplification", 1999), instead of adding up what has long been replaced. Along open
 * borders and seams, planes through the edge and perpendicular to the surface hold its shape. The place is the
 * quadric's minimum, drawn to the edge's midpoint by a small part of the trace, which settles directions in which the
 * surface is flat; a still smaller term of edge length puts the edges of flat parts in order and cures slivers.
 *
 * A hub's quadric (vtkMTCollapseRegion::IsHub), which no collapse of it waits for, is made anew once an eighth of its
 * triangles may have changed: every time would take time in proportion to the square of its triangles.
 */
#ifndef vtkMTQuadrics_h
#define vtkMTQuadrics_h

#include "vtkMTCollapseRegion.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

class vtkMTQuadrics
{
public:
  using Vector = vtkMTCollapseRegion::Vector;
  using Rule = vtkMTCollapseRegion::Rule;

  /// x' A x + 2 b' x + c: the symmetric matrix A (xx xy xz yy yz zz), the vector b, the number c; three registers of
  /// four.
  struct alignas(32) Quadric
  {
    double V[12];
  };
  /// The same of a vertex, and its place: what is asked for at once lies side by side.
  struct alignas(128) OfVertex
  {
    Quadric Sum;
    double Place[4];
  };
  struct Proposal
  {
    Vector Place;
    double Cost;
  };
  struct Request
  {
    std::uint32_t Halfedge;
    Rule ByRule;
  };
  /// Of four requests.
  struct alignas(32) Four
  {
    double Cost[4];
    double Place[3][4];
  };

  explicit vtkMTQuadrics(const vtkMTCollapseRegion& region)
    : R(region)
  {
  }

  /// All quadrics.
  void Initialize();
  /// Those that the collapse into this vertex has changed.
  void Update(std::uint32_t kept);

  /// The best place for a collapse under the rule, and what it costs; not for Rule::Refused.
  Proposal Propose(std::uint32_t h, Rule rule) const;
  /// The same for a multiple of four requests, four at a time.
  void Propose(const Request* requests, std::size_t count, Four* proposals) const;

private:
  static void AddPlane(const Vector& normal, const Vector& on, Quadric& q);
  void MakeFaceQuadrics();
  void MakeQuadrics();
  bool IsStillGood(std::uint32_t v);
  void AddCurveQuadrics(std::uint32_t v, Quadric& q) const;

  const vtkMTCollapseRegion& R;
  std::unique_ptr<Quadric[]> FaceQuadrics;              // [faces]
  std::unique_ptr<OfVertex[]> Quadrics;                 // [vertices]
  std::vector<std::uint32_t> List;                      // of what is made next
  std::map<std::uint32_t, std::uint32_t> ChangesOfHubs; // since their quadrics were made
};

#endif
