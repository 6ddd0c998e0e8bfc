// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLevelStep
 * @brief what the two steps of a level have in common: settings, sink, state and how they fail
 *
 * One step replaces fragments by patches (vtkMTSplitStep), the other one patches by fragments (vtkMTSimplifyStep).
 * The level loop takes turns.
 */
#ifndef vtkMTLevelStep_h
#define vtkMTLevelStep_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTOrderedWork.h"
#include "vtkMTPatchSink.h"
#include "vtkMTSequenceState.h"
#include "vtkMTStageTimes.h"

#include <memory>
#include <string>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTLevelStep
{
public:
  vtkMTLevelStep(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, vtkMTSequenceState& state);
  virtual ~vtkMTLevelStep();

  /// False with a message in GetError.
  virtual bool Run() = 0;

  const std::string& GetError() const { return this->Error; }
  bool WasAborted() const { return this->Aborted; }

protected:
  using Bytes = std::vector<unsigned char>;

  /// A patch on its way to the sink.
  struct PatchToWrite
  {
    vtkMTArc Arc;
    std::unique_ptr<vtkMTPatchSink::PreparedPatch> Patch;
  };

  bool Fail(const std::string& error);
  /// Reports progress; false when the work is to stop.
  bool Continue(const char* step, std::uint64_t triangles);
  /// All keys of the spool, within so much memory (0: no limit); perByte: bytes that a byte of its records takes.
  struct Room
  {
    std::uint64_t Memory;
    double PerByte;
  };
  bool ForAll(const vtkMTRecordSpool& spool, std::size_t keys, const Room& room, const vtkMTOrderedWork::Work& work,
    const vtkMTOrderedWork::Work& take);
  std::size_t GetNumberOfSlots() const { return vtkMTOrderedWork::GetNumberOfSlots(this->Options.Threads); }

  ///@{
  /// By any thread: the fragment's mesh; what the sink makes of a patch. By one thread: the arc and its patch.
  bool TakeFragment(std::size_t fragment, vtkMTCertifiedMesh& mesh, bool& isEmpty, std::string& error) const;
  bool PreparePatch(vtkMTCertifiedMesh&& patch, PatchToWrite& result, std::string& error) const;
  bool WritePatch(PatchToWrite&& patch, std::uint32_t fromNode, std::uint32_t toNode, std::string& error);
  ///@}

  const vtkMTBuildSettings& Options;
  vtkMTPatchSink& Sink;
  vtkMTSequenceState& State;
  std::string Error;

private:
  bool CheckLargest(const vtkMTRecordSpool& spool, std::size_t keys);

  bool Aborted = false;
};

#endif
