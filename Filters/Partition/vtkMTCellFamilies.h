// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCellFamilies
 * @brief ways to divide space into cells, finer and finer, in closed form: what vtkMTCellRegions makes regions of
 *
 * A family gives each point its cell. Where a cell of one family holds too much it is replaced by those of a finer one.
 * vtkMTRegularFamilies are the regular partitions of space; vtkMTDomainFamilies divide a plane or a sphere that the
 * mesh is seen from.
 */
#ifndef vtkMTCellFamilies_h
#define vtkMTCellFamilies_h

#include "vtkMTRegularFamily.h"

#include <cstddef>
#include <limits>
#include <vector>

class vtkMTCellFamilies
{
public:
  using Point = vtkMTRegularFamily::Point;
  using Cell = vtkMTRegularFamily::Cell;

  /// No family: the cell cannot be replaced.
  static constexpr int None = std::numeric_limits<int>::max();

  virtual ~vtkMTCellFamilies();

  /// The cell of a point. False where there is none.
  virtual bool Locate(int family, const Point& x, Cell& cell) const = 0;

  /// The finer family that is to divide a cell, or None. The cell's points have this box and are so many times what is
  /// wanted.
  virtual int GetReplacement(const Cell& cell, const Point& lo, const Point& hi, double excess) const = 0;

  /// The point that stands for a cell whose points have this box.
  virtual Point GetSeed(const Cell& cell, const Point& lo, const Point& hi) const = 0;

  /// How many cells hold one of the points at least; counts no further than `enough`.
  double CountCells(
    const std::vector<Point>& points, int family, double enough = std::numeric_limits<double>::infinity()) const;
};

/// The families of vtkMTRegularFamily from one to another.
class vtkMTRegularFamilies : public vtkMTCellFamilies
{
public:
  vtkMTRegularFamilies(int first, int last);
  ~vtkMTRegularFamilies() override;

  bool Locate(int family, const Point& x, Cell& cell) const override { return this->Get(family).Locate(x, cell); }
  int GetReplacement(const Cell& cell, const Point& lo, const Point& hi, double excess) const override;
  Point GetSeed(const Cell& cell, const Point& lo, const Point& hi) const override;

  /// The coarsest family of a type that divides something in a box. None where its corners coincide.
  int GetFitting(const Point& lo, const Point& hi, vtkMTRegularFamily::SeedType type) const;

private:
  const vtkMTRegularFamily& Get(int family) const
  {
    return this->Families[static_cast<std::size_t>(family - this->First)];
  }

  int First;
  int Last;
  std::vector<vtkMTRegularFamily> Families;
};

#endif
