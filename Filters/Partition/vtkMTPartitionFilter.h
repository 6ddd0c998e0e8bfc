// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPartitionFilter
 * @brief gives each cell of a vtkPolyData the region of a partition that it lies in
 *
 * One partition of the sequence that a Multi-Triangulation is built from (Cignoni et al., "Batched Multi
 * Triangulation", 2005, section 4), to be looked at or used by itself: for instance to divide a mesh for other
 * programs. A cell goes by its barycentre, the mean of its points; polygons, strips, lines and vertices are cells like
 * triangles.
 *
 * Output: the input with one more cell array, RegionArrayName, vtkIdType, one component; it becomes the active cell
 * scalars. Regions are numbered from 0 to one less than GetNumberOfRegions(), none of them empty. Cells without a
 * finite barycentre are in region 0, with a warning. An input without cells gives an empty array. When the filter is
 * aborted the output is empty.
 */
#ifndef vtkMTPartitionFilter_h
#define vtkMTPartitionFilter_h

#include "vtkMTPartitionAlgorithm.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <string> // For members

class VTKMTPARTITION_EXPORT vtkMTPartitionFilter : public vtkMTPartitionAlgorithm
{
public:
  static vtkMTPartitionFilter* New();
  vtkTypeMacro(vtkMTPartitionFilter, vtkMTPartitionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The wanted mean number of cells in a region; at most MaximumOverload times as many. Default 1000; clamped to [1,
  /// 1e12]; NaN is refused with an error.
  void SetTargetTriangles(double value);
  vtkGetMacro(TargetTriangles, double);
  ///@}

  ///@{
  /// Which partition of a sequence this is: partitions of successive levels have few borders in common. Default 0;
  /// clamped to [0, 1000].
  vtkSetClampMacro(Level, int, 0, 1000);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /// Name of the cell array. Default "Region".
  vtkSetStdStringFromCharMacro(RegionArrayName);
  vtkGetCharFromStdStringMacro(RegionArrayName);
  ///@}

  /// Regions of the last execution.
  vtkGetMacro(NumberOfRegions, vtkIdType);

protected:
  vtkMTPartitionFilter();
  ~vtkMTPartitionFilter() override;

  void Reset() override;
  bool AddRegions(const Barycentres& barycentres, vtkPolyData* output) override;

private:
  vtkMTPartitionFilter(const vtkMTPartitionFilter&) = delete;
  void operator=(const vtkMTPartitionFilter&) = delete;

  double TargetTriangles = 1000.0;
  int Level = 0;
  std::string RegionArrayName = "Region";
  vtkIdType NumberOfRegions = 0;
};

#endif
