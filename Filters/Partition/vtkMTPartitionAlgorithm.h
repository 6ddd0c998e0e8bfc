// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPartitionAlgorithm
 * @brief what the filters that give the cells of a vtkPolyData their regions have in common
 *
 * A strategy places the regions; a cell goes by its barycentre, the mean of its points; polygons, strips, lines and
 * vertices are cells like triangles. The output is the input with cell arrays of the subclass; it is empty when the
 * filter is aborted or fails, and a failure is an error event with an error code.
 */
#ifndef vtkMTPartitionAlgorithm_h
#define vtkMTPartitionAlgorithm_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For members

#include <array>  // For helpers
#include <memory> // For helpers
#include <vector> // For helpers

class vtkMTPartition;
class vtkMTPartitionStrategy;

class VTKMTPARTITION_EXPORT vtkMTPartitionAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkMTPartitionAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How regions are placed. Default: vtkMTVoronoiPartition. A null pointer is an error of the filter.
  void SetPartitionStrategy(vtkMTPartitionStrategy* strategy);
  vtkMTPartitionStrategy* GetPartitionStrategy();
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkMTPartitionAlgorithm();
  ~vtkMTPartitionAlgorithm() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  using Barycentres = std::vector<std::array<double, 3>>;

  /// Forgets what the last execution counted.
  virtual void Reset() = 0;
  /// Adds the arrays to the output, which holds the input's cells. False when aborted.
  virtual bool AddRegions(const Barycentres& barycentres, vtkPolyData* output) = 0;
  /// One partition, while the filter's progress goes from one value to the other. Null when aborted.
  std::unique_ptr<vtkMTPartition> Partition(
    const Barycentres& barycentres, double target, int level, double progress, double progressAfter);

private:
  vtkMTPartitionAlgorithm(const vtkMTPartitionAlgorithm&) = delete;
  void operator=(const vtkMTPartitionAlgorithm&) = delete;

  bool CountAndAddRegions(vtkPolyData* output);

  vtkSmartPointer<vtkMTPartitionStrategy> PartitionStrategy;
};

#endif
