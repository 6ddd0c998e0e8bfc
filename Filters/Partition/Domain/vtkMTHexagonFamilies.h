// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTHexagonFamilies
 * @brief hexagons around the points of triangle lattices, each of which is a third of the next finer one: dual sqrt-3
 *
 * BMT section 4.2.1, figure 7: the next finer lattice has the corners of the hexagons as well, so it has three times
 * the points at 1 / sqrt(3) of the distance, and is turned by 30 degrees. A hexagon's border runs from the middle to
 * the middle of finer hexagons: nothing of it is a border of the finer family.
 *
 * A lattice point is known by its weights on the corners of a triangle of the base mesh, in whole numbers that sum up
 * to n = 3^m for family 2 m, and to 3 n for family 2 m + 1, where all three leave the same remainder by 3. In a
 * triangle of the even lattice the nearest point is the corner with the largest weight, or for the odd lattice the
 * middle where no weight is above 2/3.
 *
 * On a sphere the base mesh is an icosahedron. Corners with the weight 0 count for nothing, so points on its edges and
 * corners are the same from all sides: regions fold over edges, and at the 12 corners they are pentagons. Family 2 m
 * has 10 * 9^m + 2 cells. Before them come the 4 that are around corners of a tetrahedron, and the whole.
 *
 * In a plane the lattice goes on without end in both directions; one point of all families is at 0.27 of the longer
 * side and 0.31 of the other, and family 0 has a hexagon of the rectangle's area. Points outside the rectangle are no
 * seeds: their cells are their neighbours', so families have 3 times the cells of the one before in the mean.
 */
#ifndef vtkMTHexagonFamilies_h
#define vtkMTHexagonFamilies_h

#include "vtkMTDomainFamilies.h"

#include <cstdint>

class vtkMTHexagonFamilies : public vtkMTDomainFamilies
{
public:
  vtkMTHexagonFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel);
  ~vtkMTHexagonFamilies() override;

  int GetCoarsest() const override { return this->GetDomain().IsPlane() ? 0 : -2; }
  int GetFinest() const override { return 30; }
  double GetNumberOfCells(int family) const override;

protected:
  void LocateInDomain(int family, const Point& x, Cell& cell) const override;

private:
  using Place = std::array<std::int64_t, 3>;
  using Place2D = std::array<double, 2>;

  void LocateInPlane(int family, const Point& x, Cell& cell) const;
  void LocateOnSphere(int family, const Point& x, Cell& cell) const;
  Place2D GetPoint(int family, const Place& place) const;
  bool IsInside(const Place2D& point) const;
  void MoveInside(int family, const Place2D& x, Place& place) const;

  ///@{
  /// Of the rectangle, in distances of family 0, from the point that all lattices have.
  Place2D Lo{ 0.0, 0.0 };
  Place2D Hi{ 0.0, 0.0 };
  ///@}
};

#endif
