// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCellRegions
 * @brief a partition into the cells of a family, some of them replaced by those of finer ones
 *
 * What strategies make whose regions are known in closed form. A point's cell of the first family is looked up; if it
 * has been replaced, its cell of the family that replaces it is looked up, and so on. Cells of a finer family that lie
 * in several replaced cells are one region. Points whose cells hold no barycentre go to the nearest seed.
 */
#ifndef vtkMTCellRegions_h
#define vtkMTCellRegions_h

#include "vtkMTCellFamilies.h"
#include "vtkMTPartition.h"
#include "vtkMTSeedPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

class vtkMTCellRegions : public vtkMTPartition
{
public:
  using Point = std::array<double, 3>;

  vtkMTCellRegions(std::unique_ptr<const vtkMTCellFamilies> families, int firstFamily);
  ~vtkMTCellRegions() override;

  /// Counts all barycentres and replaces cells until the bound holds. False when the scan failed.
  bool Fill(vtkMTBarycentreScan& scan, double target);

  std::uint32_t GetNumberOfRegions() const override;
  std::uint32_t Locate(const Point& x) const override;
  Point GetSeed(std::uint32_t region) const override;

private:
  using Cell = vtkMTCellFamilies::Cell;

  struct Entry
  {
    int Replacement = vtkMTCellFamilies::None; // a family
    std::uint32_t Region = 0;
    std::size_t Count = 0;
    Point Lo = { 0.0, 0.0, 0.0 };
    Point Hi = { 0.0, 0.0, 0.0 };
  };
  using Table = std::unordered_map<Cell, Entry, vtkMTRegularFamily::Hash>;

  bool Count(vtkMTBarycentreScan& scan);
  void Add(const Point& x);
  bool Replace(double target);
  void Number();

  const std::unique_ptr<const vtkMTCellFamilies> Families;
  const int FirstFamily;
  Table Cells;
  vtkMTSeedPartition Nearest; // of the regions' seeds
};

#endif
