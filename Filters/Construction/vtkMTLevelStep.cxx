// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLevelStep.h"

#include "vtkMTArcRecord.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTRegionStep.h"

#include <algorithm>

vtkMTLevelStep::vtkMTLevelStep(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, vtkMTBuildState& state)
  : Options(settings)
  , Sink(sink)
  , State(state)
{
}

vtkMTLevelStep::~vtkMTLevelStep() = default;

bool vtkMTLevelStep::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool vtkMTLevelStep::Continue(const char* step, std::uint64_t triangles)
{
  // Every level halves, so all levels together have about twice the input's triangles.
  const double fraction =
    static_cast<double>(this->State.SimplifiedTriangles) / (2.0 * static_cast<double>(this->State.LevelTriangles[0]));
  this->Aborted = !this->Options.Report(
    { std::min(1.0, fraction), step, this->State.Level + 1, triangles, this->State.LevelTriangles[this->State.Level] });
  return !this->Aborted || this->Fail("aborted");
}

bool vtkMTLevelStep::ForAll(std::size_t count, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
{
  std::string error;
  if (vtkMTOrderedWork::Run(count, this->Options.Threads, work, take, error))
  {
    return true;
  }
  this->Error = error.empty() ? this->Error : error;
  return false;
}

bool vtkMTLevelStep::TakeFragment(std::size_t fragment, vtkMTPatch& mesh, bool& isEmpty, std::string& error) const
{
  std::vector<Bytes> records;
  if (!this->State.Fragments.Take(fragment, records, error))
  {
    return false;
  }
  isEmpty = records.empty();
  return isEmpty || vtkMTPatchRecord::Decode(records[0], mesh, error);
}

bool vtkMTLevelStep::PreparePatch(vtkMTPatch&& patch, PatchToWrite& result, std::string& error) const
{
  const vtkMTStageTimes::Scope encode(vtkMTStageTimes::Encode);
  vtkMTRegionStep::RemoveReach(patch);
  result.Arc = vtkMTMakeArcRecord(patch, this->State.Graph.Lattice.Step);
  result.Patch = this->Sink.Prepare(std::move(patch), error);
  return result.Patch != nullptr;
}

bool vtkMTLevelStep::WritePatch(PatchToWrite&& patch, std::uint32_t fromNode, std::uint32_t toNode, std::string& error)
{
  this->State.Arcs.push_back({ patch.Arc, fromNode, toNode });
  const bool written = this->Sink.WritePrepared(std::move(patch.Patch));
  error = written ? error : this->Sink.GetError();
  return written;
}
