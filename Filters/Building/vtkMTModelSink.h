// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTModelSink
 * @brief a patch sink in front of another one, for what a file gets beside the builder's patches
 */
#ifndef vtkMTModelSink_h
#define vtkMTModelSink_h

#include "vtkMTBuildInput.h"
#include "vtkMTBuildingModule.h" // For export macro
#include "vtkMTGraph.h"
#include "vtkMTPatchSink.h"

#include <memory>
#include <string>
#include <vector>

class VTKMTBUILDING_EXPORT vtkMTModelSink : public vtkMTPatchSink
{
public:
  /// The input's textures become blobs of the model, its frame and units the model's. identity: what tells the build
  /// from others, kept as the setting "build" by which a finished build is known again.
  vtkMTModelSink(vtkMTPatchSink& next, const vtkMTBuildInput::Result& input, const std::string& identity);

  bool Begin(const std::vector<vtkMTArrayInfo>& arrays) override;
  bool WritePatch(vtkMTPatch&& patch) override;
  std::unique_ptr<PreparedPatch> Prepare(vtkMTPatch&& patch, std::string& error) const override;
  bool WritePrepared(std::unique_ptr<PreparedPatch> patch) override;
  bool WriteBlob(std::vector<unsigned char>&& bytes) override;
  bool Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc) override;
  void Abandon() override { this->Next.Abandon(); }
  bool Save(std::vector<unsigned char>& state) override;
  bool Restore(const std::vector<vtkMTArrayInfo>& arrays, const std::vector<unsigned char>& state) override;

private:
  bool Pass(bool done);

  vtkMTPatchSink& Next;
  const vtkMTBuildInput::Result& Input;
  const std::string Identity;
};

#endif
