// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemorySpoolStore
 * @brief a store whose spools are in memory, for meshes that fit
 *
 * Nothing outlives the process: Commit has no effect. Spools grow in blocks of 1 MiB, without copying,
 * and give up those of which everything was forgotten.
 */
#ifndef vtkMTMemorySpoolStore_h
#define vtkMTMemorySpoolStore_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

class VTKMTCORE_EXPORT vtkMTMemorySpoolStore : public vtkMTSpoolStore
{
public:
  vtkMTMemorySpoolStore();
  ~vtkMTMemorySpoolStore() override;

  std::unique_ptr<vtkMTSpool> Create(std::string& error) override;
  std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) override;
  std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) override;
  void Remove(const std::string& name) override;
  bool IsLasting() const override { return false; }
  bool Commit(const std::vector<unsigned char>& state, std::string& error) override;
  bool Restore(std::vector<unsigned char>& state, std::string& error) override;
  void Clear() override;
  std::uint64_t GetSize() const override;
  std::uint64_t GetLargestSize() const override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
