// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemorySpool
 * @brief a spool that keeps its patches in memory
 */
#ifndef vtkMTMemorySpool_h
#define vtkMTMemorySpool_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTSpool.h"

class VTKMTCORE_EXPORT vtkMTMemorySpool : public vtkMTSpool
{
public:
  bool Reset(std::size_t keys) override;
  bool Put(std::size_t key, vtkMTPatch&& patch) override;
  bool Take(std::size_t key, std::vector<vtkMTPatch>& patches) override;

private:
  std::vector<std::vector<vtkMTPatch>> Bins;
};

#endif
