// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegularRegions
 * @brief the partition that vtkMTRegularPartition makes: cells of a family, some replaced by finer ones
 *
 * A point's cell of the first family is looked up; if it has been replaced, its cell of the family that replaces it is
 * looked up, and so on. Cells of a finer family that lie in several replaced cells are one region. Points whose cells
 * hold no barycentre go to the nearest seed.
 */
#ifndef vtkMTRegularRegions_h
#define vtkMTRegularRegions_h

#include "vtkMTPartition.h"
#include "vtkMTRegularFamily.h"
#include "vtkMTSeedPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

class vtkMTRegularRegions : public vtkMTPartition
{
public:
  using Point = std::array<double, 3>;

  /// Counts all barycentres and replaces cells until the bound holds. Families up to lastFamily are used.
  vtkMTRegularRegions(int family, int lastFamily);
  ~vtkMTRegularRegions() override;

  /// False when the scan failed.
  bool Fill(vtkMTBarycentreScan& scan, double target);

  std::uint32_t GetNumberOfRegions() const override;
  std::uint32_t Locate(const Point& x) const override;
  Point GetSeed(std::uint32_t region) const override;

private:
  static constexpr int NotReplaced = std::numeric_limits<int>::max();

  struct Entry
  {
    int Replacement = NotReplaced; // a family
    std::uint32_t Region = 0;
    std::size_t Count = 0;
    Point Lo = { 0.0, 0.0, 0.0 };
    Point Hi = { 0.0, 0.0, 0.0 };
  };
  using Table = std::unordered_map<vtkMTRegularFamily::Cell, Entry, vtkMTRegularFamily::Hash>;

  bool Count(vtkMTBarycentreScan& scan);
  void Add(const Point& x);
  bool Replace(double target);
  int GetReplacement(const vtkMTRegularFamily::Cell& cell, const Entry& entry) const;
  void Number();

  const vtkMTRegularFamily& GetFamily(int family) const
  {
    return this->Families[static_cast<std::size_t>(family - this->FirstFamily)];
  }

  int FirstFamily;
  std::vector<vtkMTRegularFamily> Families; // from the first to the last
  Table Cells;
  vtkMTSeedPartition Nearest; // of the regions' seeds
};

#endif
