// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSurface
 * @brief a region's mesh as distances are asked of it: corners, planes and neighbours
 *
 * Coordinates are lattice steps relative to a common origin, so differences of corners are exact in double precision;
 * normals are computed in exact integers before they are scaled to unit length.
 *
 * Half-edge h = 3 t + e runs from corner e of triangle t to the next one; vtkMTHalfedgePairs says which are opposite.
 *
 * Searches that go from triangle to triangle are for what is near. A hub, a point of more than HubTriangles triangles,
 * is not looked around, and no way goes on for more than MostSteps triangles: a tree finds what is farther away.
 *
 * Threads: const and safe.
 */
#ifndef vtkMTSurface_h
#define vtkMTSurface_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTHalfedgePairs.h"
#include "vtkMTPatch.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTSurface
{
public:
  using Vector = std::array<double, 3>;
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  static constexpr std::uint32_t HubTriangles = 128;
  static constexpr int MostSteps = 64;

  /// A place on a triangle, and how far it is from where the question was asked.
  struct Hit
  {
    static constexpr std::uint32_t None = vtkMTSurface::None;
    std::uint32_t Triangle = None;
    double Distance2 = std::numeric_limits<double>::infinity();
    Vector Place{ 0.0, 0.0, 0.0 };
    Vector Weights{ 1.0, 0.0, 0.0 }; ///< the place's barycentric coordinates
  };

  /// A triangle with what distances from it need.
  struct Triangle
  {
    std::array<Vector, 3> Corners;
    Vector Normal; ///< unit length; zero for a degenerate triangle
    ///@{
    /// In the plane, at right angles to the edges from corner 0 and to corner 0, towards the triangle, as long as the
    /// edge: the product with x - corner 0 is twice the area of the triangle of that edge and x.
    Vector Inward0;
    Vector Inward2;
    ///@}
    double TwiceArea;
  };

  /// Whether planes are computed once, where most triangles are asked for distances, or each time.
  enum class Planes
  {
    Kept,
    MadeWhenAsked
  };
  /// origin, in steps, is subtracted from all points, and from those that queries ask for.
  vtkMTSurface(const vtkMTPatch& mesh, const vtkMTPoint& origin, Planes planes = Planes::Kept);

  std::size_t GetNumberOfTriangles() const { return this->Points.size() / 3; }
  std::size_t GetNumberOfPoints() const { return this->Halfedges.size(); }
  /// The largest coordinate, at least 1.
  double GetExtent() const { return this->Extent; }

  const Vector& GetCorner(std::uint32_t triangle, int corner) const
  {
    return this->Places[this->Points[3 * triangle + static_cast<std::uint32_t>(corner)]];
  }
  /// Unit length; zero for a degenerate triangle.
  Vector GetNormal(std::uint32_t triangle) const
  {
    Triangle made;
    return this->GetTriangle(triangle, made).Normal;
  }
  /// With room for it where planes are not kept.
  const Triangle& GetTriangle(std::uint32_t triangle, Triangle& made) const
  {
    if (!this->Triangles.empty())
    {
      return this->Triangles[triangle];
    }
    this->Make(triangle, made);
    return made;
  }

  static std::uint32_t Next(std::uint32_t h) { return vtkMTHalfedgePairs::Next(h); }
  static std::uint32_t Previous(std::uint32_t h) { return vtkMTHalfedgePairs::Previous(h); }
  /// The point that a half-edge starts from: its index, and its place.
  std::uint32_t GetPoint(std::uint32_t h) const { return this->Points[h]; }
  const Vector& GetPlace(std::uint32_t h) const { return this->Places[this->Points[h]]; }
  std::uint32_t GetOpposite(std::uint32_t h) const { return this->Opposites[h]; }
  /// A half-edge that starts from the point, one at a border where there is one; None when no triangle uses the point.
  std::uint32_t GetHalfedge(std::uint32_t point) const { return this->Halfedges[point]; }
  bool IsHub(std::uint32_t point) const { return !this->Hubs.empty() && this->Hubs[point]; }
  /// The half-edges that start from the same point, counter-clockwise and clockwise; None beyond a border.
  std::uint32_t TurnLeft(std::uint32_t h) const { return this->Opposites[Previous(h)]; }
  std::uint32_t TurnRight(std::uint32_t h) const
  {
    const std::uint32_t opposite = this->Opposites[h];
    return opposite == None ? None : Next(opposite);
  }

  /// Distance from x to one triangle, and where.
  Hit Project(const Vector& x, std::uint32_t triangle) const;
  /// The squared distance alone; infinity, found early, when it is at least limit.
  double GetDistance2(const Vector& x, std::uint32_t triangle, double limit) const;
  static double GetDistance2(const Vector& x, const Triangle& triangle, double limit);
  /// The nearest of the triangles around the point that h starts from, or what is nearer still across their edges. Of a
  /// hub it is h's own triangle.
  Hit FindAround(const Vector& x, std::uint32_t h) const;
  /// From a place on the surface to nearer ones in adjoining triangles, until none is nearer, or for MostSteps.
  void Descend(const Vector& x, Hit& hit) const;

private:
  struct Foot
  {
    double Distance2;
    int Edge; // the edge that it is on, -1 inside
    double Parameter;
  };

  void FindHalfedges(std::size_t points);
  void Make(std::uint32_t triangle, Triangle& made) const;
  static Foot FindFoot(const Vector& x, const Triangle& t, double limit);
  void LookAround(const Vector& x, std::uint32_t h, Hit& hit) const;

  std::vector<Vector> Places;      // of points
  std::vector<Triangle> Triangles; // none where planes are made when they are asked for
  std::vector<std::uint32_t> Points;
  std::vector<std::uint32_t> Opposites;
  std::vector<std::uint32_t> Halfedges;
  std::vector<bool> Hubs;
  double Extent = 1.0;
  bool IsSmall = true;
};

#endif
