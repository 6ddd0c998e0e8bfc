// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSpool
 * @brief the builder's working store: patches put under a key (a region) and taken back by that key
 *
 * Between two levels of the construction every fragment, and then every patch, is put under the region that will
 * use it and taken once when that region is processed (BMT section 6). A spool may keep them in memory or on disk; what
 * Take gives does not depend on which.
 *
 * Threads: Put comes from one thread at a time; Take may be called from several threads for different keys.
 */
#ifndef vtkMTSpool_h
#define vtkMTSpool_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTSpool
{
public:
  virtual ~vtkMTSpool();

  /// Forgets everything and makes room for the keys 0 .. keys-1.
  virtual bool Reset(std::size_t keys) = 0;
  virtual bool Put(std::size_t key, vtkMTPatch&& patch) = 0;
  /// The key's patches in the order in which they were put; the spool may forget them.
  virtual bool Take(std::size_t key, std::vector<vtkMTPatch>& patches) = 0;

  const std::string& GetError() const { return this->Error; }

protected:
  std::string Error;
};

/// Makes the spools that a builder needs.
using vtkMTSpoolFactory = std::shared_ptr<vtkMTSpool> (*)();

#endif
