// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPartitionSequence
 * @brief gives each cell of a vtkPolyData its regions in a partition sequence, coarser and coarser
 *
 * The partition sequence Psi_0, Psi_1, ..., Psi_n of Cignoni et al., "Batched Multi Triangulation" (2005), section 4,
 * on one mesh: the target of Psi_i is FirstTarget times Growth to the power of i, and Psi_n is the first that is one
 * region, at the latest when the target is at least the number of cells. (In the construction of a Multi-Triangulation
 * the mesh gets coarser instead, and the target stays.) A cell goes by its barycentre, the mean of its points, whatever
 * kind of cell it is.
 *
 * Output: the input with one more cell array for each partition, named RegionArrayPrefix and its level (Region_0,
 * Region_1 and so on), vtkIdType, one component, so that each can be chosen for colouring, and any two of them for
 * vtkMTCrossing; Region_0 becomes the active cell scalars. Cells without a finite barycentre are in region 0 of all
 * partitions, with a warning. An input without cells gives no arrays. When the filter is aborted the output is empty.
 */
#ifndef vtkMTPartitionSequence_h
#define vtkMTPartitionSequence_h

#include "vtkMTPartitionAlgorithm.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <string> // For members

class VTKMTPARTITION_EXPORT vtkMTPartitionSequence : public vtkMTPartitionAlgorithm
{
public:
  static vtkMTPartitionSequence* New();
  vtkTypeMacro(vtkMTPartitionSequence, vtkMTPartitionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The wanted mean number of cells in a region of Psi_0. Default 1000; clamped to [1, 1e12]; NaN is refused with an
  /// error.
  void SetFirstTarget(double value);
  vtkGetMacro(FirstTarget, double);
  ///@}

  ///@{
  /// Ratio of the targets of successive partitions. Default 2; clamped to [1.1, 1024]; NaN is refused with an
  /// error.
  void SetGrowth(double value);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /// What the names of the cell arrays begin with. Default "Region_".
  vtkSetStdStringFromCharMacro(RegionArrayPrefix);
  vtkGetCharFromStdStringMacro(RegionArrayPrefix);
  ///@}

  /// Partitions of the last execution, n + 1.
  vtkGetMacro(NumberOfLevels, int);

protected:
  vtkMTPartitionSequence();
  ~vtkMTPartitionSequence() override;

  void Reset() override;
  bool AddRegions(const Barycentres& barycentres, vtkPolyData* output) override;

private:
  vtkMTPartitionSequence(const vtkMTPartitionSequence&) = delete;
  void operator=(const vtkMTPartitionSequence&) = delete;

  double FirstTarget = 1000.0;
  double Growth = 2.0;
  std::string RegionArrayPrefix = "Region_";
  int NumberOfLevels = 0;
};

#endif
