// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCellBarycentres
 * @brief barycentres of the cells of a vtkPolyData, and a scan over them that reports progress
 *
 * A cell's barycentre is the mean of its points, whatever it is: a vertex, a line, a polygon, a strip. Cells without
 * points have one that is not a number.
 */
#ifndef vtkMTCellBarycentres_h
#define vtkMTCellBarycentres_h

#include "vtkMTPartition.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkIdTypeArray;
class vtkMTPartitionStrategy;
class vtkPolyData;

class vtkMTCellBarycentres
{
public:
  using Point = std::array<double, 3>;
  /// Told the share of the work that is done; false to stop.
  using Progress = std::function<bool(double)>;

  /// In the order of the cell ids: vertices, lines, polygons, strips.
  static std::vector<Point> Make(vtkPolyData* mesh);

  /// How many of the barycentres are not finite.
  static std::size_t CountNotFinite(const std::vector<Point>& barycentres);

  /**
   * The strategy's partition of the barycentres. Progress is told after each scan; as nobody knows how many scans a
   * strategy will make, it halves what is left each time. Null when progress asked to stop.
   */
  static std::unique_ptr<vtkMTPartition> Build(const vtkMTPartitionStrategy& strategy,
    const std::vector<Point>& barycentres, double target, int level, const Progress& progress);

  /// The regions of the barycentres, as an array of that name.
  static vtkSmartPointer<vtkIdTypeArray> MakeRegionArray(
    const vtkMTPartition& partition, const std::vector<Point>& barycentres, const std::string& name);
};

#endif
