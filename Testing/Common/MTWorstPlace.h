// SPDX-License-Identifier: BSD-3-Clause
/**
 * The worst place: where a surface is farthest from another one, found by search.
 *
 * What is found is a place of the one surface and its distance to the other one, so it is a lower bound of the
 * one-sided deviation, and a certified error that is smaller is violated. Looked at are all vertices, the middle of
 * every edge, barycentres; then the triangles where most was found are climbed: steps along the triangle, halved where
 * none leads higher. It shares no code with Filters/Certification and Filters/Verification: a tree of boxes of its own,
 * distances to triangles from edges and interior apart (an edge's distance never fails, however thin the triangle).
 */
#ifndef MTWorstPlace_h
#define MTWorstPlace_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class MTWorstPlace
{
public:
  using Place = std::array<double, 3>;
  struct Surface
  {
    std::vector<Place> Points; // of about unit size about the origin
    std::vector<std::array<std::uint32_t, 3>> Triangles;
  };

  explicit MTWorstPlace(const Surface& target);

  /// Of a place to the target; infinite where that is empty.
  double GetDistance(const Place& place) const;
  /// The same in extended precision, for a place that decides.
  double GetPreciseDistance(const Place& place) const;

  /// The target's triangles that are no farther from a place than that.
  std::vector<std::uint32_t> FindTriangles(const Place& place, double radius) const;

  /**
   * For each triangle of `from` the largest distance that was found in it. Those `climbs` triangles are climbed in
   * which most was found over what is allowed there; allowed: for each triangle, empty: the same for all.
   */
  std::vector<double> Search(const Surface& from, std::size_t climbs, const std::vector<double>& allowed = {}) const;

private:
  struct Box
  {
    Place Low;
    Place High;
    std::uint32_t First = 0; // a leaf's triangles in Order, or the left child; the right one is the next
    std::uint32_t Count = 0; // 0: not a leaf
  };
  void Split(std::uint32_t box, std::uint32_t first, std::uint32_t last);
  template <class Real>
  std::array<std::array<Real, 3>, 3> GetCorners(std::uint32_t triangle, const Place& origin) const;
  template <class Real>
  Real FindDistance2(const Place& place) const;
  double Climb(const Surface& from, std::size_t triangle) const;

  const Surface Target;
  std::vector<std::uint32_t> Order;
  std::vector<Place> Centers; // while boxes are split
  std::vector<Box> Boxes;
};

#endif
