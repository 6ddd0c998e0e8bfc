// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchStore
 * @brief a Multi-Triangulation in memory: a patch sink while it is built, a patch source from then on
 */
#ifndef vtkMTPatchStore_h
#define vtkMTPatchStore_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTGraph.h"
#include "vtkMTPatchSink.h"
#include "vtkMTPatchSource.h"

class VTKMTCORE_EXPORT vtkMTPatchStore
  : public vtkMTPatchSource
  , public vtkMTPatchSink
{
public:
  bool Begin(const std::vector<vtkMTArrayInfo>& arrays) override;
  bool WritePatch(vtkMTPatch&& patch) override;
  bool WriteBlob(std::vector<unsigned char>&& bytes) override;
  bool Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc) override;
  void Abandon() override;

  const vtkMTGraph& GetGraph() const override { return this->Graph; }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override;
  bool ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const override;
  std::uint64_t GetPatchSize(std::uint32_t arc) const override;
  std::string GetName() const override { return "memory"; }

  /// For tests: the graph and the patches (in arc order) may be changed to see a check fail.
  vtkMTGraph& GetMutableGraph() { return this->Graph; }
  std::vector<vtkMTPatch>& GetMutablePatches() { return this->Patches; }

private:
  vtkMTGraph Graph;
  std::vector<vtkMTPatch> Patches; // in the order of writing until Finish, in arc order after
  std::vector<std::vector<unsigned char>> Blobs;
};

#endif
