// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTScratchStore
 * @brief a store of nameless spools, files in a folder that no other process sees
 *
 * For what is needed while an input is read: nothing outlives the process, and nothing is left in the folder however
 * that ends. Named spools and checkpoints are what vtkMTFileSpoolStore is for: here they fail.
 */
#ifndef vtkMTScratchStore_h
#define vtkMTScratchStore_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

class VTKMTIOCORE_EXPORT vtkMTScratchStore : public vtkMTSpoolStore
{
public:
  /// folder: must exist when the first spool is made; empty: the current one.
  explicit vtkMTScratchStore(const std::string& folder);
  ~vtkMTScratchStore() override;

  std::unique_ptr<vtkMTSpool> Create(std::string& error) override;
  std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) override;
  std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) override;
  void Remove(const std::string&) override {}
  bool IsLasting() const override { return false; }
  bool Commit(const std::vector<unsigned char>&, std::string&) override { return true; }
  bool Restore(std::vector<unsigned char>& state, std::string& error) override;
  void Clear() override {}
  std::uint64_t GetSize() const override;
  std::uint64_t GetLargestSize() const override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
