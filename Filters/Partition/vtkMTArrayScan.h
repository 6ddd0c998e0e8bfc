// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArrayScan
 * @brief a scan over barycentres that are in memory
 *
 * What a partition strategy sees of a mesh whose barycentres are an array. The array is not copied: it must outlive the
 * scan and stay as it is while the scan runs.
 */
#ifndef vtkMTArrayScan_h
#define vtkMTArrayScan_h

#include "vtkMTPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <array>
#include <cstddef>
#include <vector>

class VTKMTPARTITION_EXPORT vtkMTArrayScan : public vtkMTBarycentreScan
{
public:
  explicit vtkMTArrayScan(const std::vector<std::array<double, 3>>& barycentres);
  ~vtkMTArrayScan() override;

  std::size_t GetNumberOfTriangles() const override;
  bool Scan(const Block& block) override;

private:
  const std::vector<std::array<double, 3>>& Barycentres;
};

#endif
