// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemoryLimit.h"

bool vtkMTMemoryLimit::Reserve(std::size_t bytes)
{
  std::size_t used = this->Used;
  do
  {
    const std::size_t limit = this->Limit;
    if (bytes > limit || used > limit - bytes)
    {
      return false;
    }
  } while (!this->Used.compare_exchange_weak(used, used + bytes));
  std::size_t most = this->MostUsed;
  while (most < used + bytes && !this->MostUsed.compare_exchange_weak(most, used + bytes))
  {
  }
  return true;
}
