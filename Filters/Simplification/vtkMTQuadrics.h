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
 */
#ifndef vtkMTQuadrics_h
#define vtkMTQuadrics_h

#include "vtkMTCollapseRegion.h"

#include <array>
#include <vector>

class vtkMTQuadrics
{
public:
  using Vector = vtkMTCollapseRegion::Vector;
  using Rule = vtkMTCollapseRegion::Rule;

  struct Proposal
  {
    Vector Place;
    double Cost;
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
  double GetCost(std::uint32_t h, const Vector& place) const;

private:
  // A symmetric matrix (xx xy xz yy yz zz), a vector and a number: x' A x + 2 b' x + c.
  struct Quadric
  {
    std::array<double, 6> A{};
    std::array<double, 3> B{};
    double C = 0.0;

    void AddPlane(const std::array<double, 4>& g);
    double Evaluate(const Vector& p) const;
    double GetTrace() const { return this->A[0] + this->A[3] + this->A[5]; }
  };
  // A plane times the square root of its weight: its outer product is the quadric.
  using Plane = std::array<double, 4>;

  void MakePlane(std::uint32_t h);
  void MakeQuadric(std::uint32_t v);
  void AddCurvePlanes(std::uint32_t v, Quadric& q) const;
  Quadric GetSum(std::uint32_t h) const;
  double GetCost(const Quadric& q, std::uint32_t h, const Vector& place) const;
  static Vector Minimize(const Quadric& q, const Vector& middle);

  const vtkMTCollapseRegion& R;
  std::vector<Plane> Planes;     // [faces]
  std::vector<Quadric> Quadrics; // [vertices]
};

#endif
