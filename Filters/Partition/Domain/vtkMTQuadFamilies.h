// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTQuadFamilies
 * @brief the faces and the edges of a quadrangulation that is subdivided again and again
 *
 * BMT section 4.2.1, figure 6: seeds on the centres of squares, then on the mid-points of their edges, which gives
 * squares that are tilted by 45 degrees, then on the centres of the squares of half the size. The region of an edge has
 * a triangle of each of the two faces beside it. Every family has exactly twice the cells of the one before.
 *
 * A cell is known by the place of its element's middle on the base mesh, in whole numbers: on a sphere those of the
 * surface of a cube, of which an edge between two sides has the same place from both, so regions fold over the cube's
 * edges and corners without a case of their own. Directions are spread over a side of the cube so that equal angles
 * have nearly equal lengths. Before the cube's 6 sides there are 3 sectors around its diagonal, and the whole.
 *
 * In a plane the base is one quad, or a row of 2^p that are nearly squares; the p families before that are strips, with
 * borders that are moved by a quarter of a strip in every second one. An edge on the rectangle's border has one face
 * alone: two of them that follow upon one another along the border are one cell, with what they have in common a side
 * at corners and a point elsewhere.
 */
#ifndef vtkMTQuadFamilies_h
#define vtkMTQuadFamilies_h

#include "vtkMTDomainFamilies.h"

class vtkMTQuadFamilies : public vtkMTDomainFamilies
{
public:
  vtkMTQuadFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel);
  ~vtkMTQuadFamilies() override;

  int GetCoarsest() const override { return this->GetDomain().IsPlane() ? 0 : -2; }
  int GetFinest() const override { return 50; }
  double GetNumberOfCells(int family) const override;

protected:
  void LocateInDomain(int family, const Point& x, Cell& cell) const override;

private:
  void LocateInPlane(int family, const Point& x, Cell& cell) const;
  void LocateOnSphere(int family, const Point& x, Cell& cell) const;

  int RowExponent = 0; // p
};

#endif
