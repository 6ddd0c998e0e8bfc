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

#include <array>
#include <map>
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
  // x' A x + 2 b' x + c: the symmetric matrix A (xx xy xz yy yz zz), the vector b, the number c.
  struct Quadric
  {
    std::array<double, 10> V{};

    void Add(const Quadric& other)
    {
      for (std::size_t i = 0; i < 10; ++i)
      {
        this->V[i] += other.V[i];
      }
    }
    double Evaluate(const Vector& p) const;
    double GetTrace() const { return this->V[0] + this->V[3] + this->V[5]; }
  };

  static Quadric MakePlaneQuadric(const Vector& normal, const Vector& on);
  void MakeFaceQuadric(std::uint32_t h);
  void MakeQuadric(std::uint32_t v);
  bool IsStillGood(std::uint32_t v);
  void AddCurveQuadrics(std::uint32_t v, Quadric& q) const;
  Quadric GetSum(std::uint32_t h) const;
  double GetCost(const Quadric& q, std::uint32_t h, const Vector& place) const;
  static Vector Minimize(const Quadric& q, const Vector& middle);

  const vtkMTCollapseRegion& R;
  std::vector<Quadric> FaceQuadrics;                    // [faces]
  std::vector<Quadric> Quadrics;                        // [vertices]
  std::map<std::uint32_t, std::uint32_t> ChangesOfHubs; // since their quadrics were made
};

#endif
