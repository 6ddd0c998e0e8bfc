// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLevelStep.h"

#include "vtkMTArcRecord.h"
#include "vtkMTMemoryPlan.h"

#include <algorithm>

vtkMTLevelStep::vtkMTLevelStep(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, vtkMTSequenceState& state)
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
  // Every level is smaller by the reduction: with 2, all levels together have about twice the input's triangles.
  const double reduction = this->Options.Reduction;
  const double all = reduction / (reduction - 1.0) * static_cast<double>(this->State.LevelElements[0]);
  const double fraction = static_cast<double>(this->State.SimplifiedTriangles) / all;
  this->Aborted = !this->Options.Report(
    { std::min(1.0, fraction), step, this->State.Level + 1, triangles, this->State.LevelElements[this->State.Level] });
  return !this->Aborted || this->Fail("aborted");
}

bool vtkMTLevelStep::ForAll(const vtkMTRecordSpool& spool, std::size_t keys, const Room& room,
  const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
{
  vtkMTOrderedWork::Budget budget;
  budget.Memory = room.Memory;
  budget.Cost = [&spool, &room](std::size_t key)
  { return static_cast<std::uint64_t>(room.PerByte * static_cast<double>(spool.GetSize(key))); };
  if (!this->CheckLargest(spool, keys))
  {
    return false;
  }
  std::string error;
  if (vtkMTOrderedWork::Run(keys, this->Options.Threads, budget, work, take, error))
  {
    return true;
  }
  this->Error = error.empty() ? this->Error : error;
  return false;
}

// Simplifying needs the most: what is too large for that is found before it is split, so that one message says it all.
bool vtkMTLevelStep::CheckLargest(const vtkMTRecordSpool& spool, std::size_t keys)
{
  const std::uint64_t limit = this->Options.WorkMemory;
  std::uint64_t bytes = 0;
  for (std::size_t key = 0; key < keys && limit > 0; ++key)
  {
    bytes = std::max(bytes, spool.GetSize(key));
  }
  const double needed = this->Options.MemoryPerByteSimplified * static_cast<double>(bytes);
  // Fragments of the input are a fifth shorter than their patches; what regions need is estimated on the safe side.
  const bool isInput = this->State.Stage == vtkMTSequenceState::HasFragments && this->State.Level == 0;
  const auto wanted = static_cast<std::uint64_t>(needed * (isInput ? 1.25 : 0.95));
  return limit == 0 || wanted <= limit ||
    this->Fail("the largest region needs about " + vtkMTMemoryPlan::ToText(wanted) + " of memory where " +
      vtkMTMemoryPlan::ToText(limit) + " are left for it: raise the limit by " +
      vtkMTMemoryPlan::ToText(wanted - limit));
}

bool vtkMTLevelStep::TakeFragment(
  std::size_t fragment, vtkMTCertifiedMesh& mesh, bool& isEmpty, std::string& error) const
{
  std::vector<vtkMTBytes::Record> records;
  if (!this->State.Fragments.Take(fragment, records, error))
  {
    return false;
  }
  isEmpty = records.empty();
  return isEmpty || mesh.Decode(records[0], error);
}

bool vtkMTLevelStep::PreparePatch(vtkMTCertifiedMesh&& patch, PatchToWrite& result, std::string& error) const
{
  const vtkMTStageTimes::Scope encode(vtkMTStageTimes::Encode);
  result.Arc = vtkMTMakeArcRecord(patch.Mesh, this->State.Graph.Lattice.Step);
  result.Arc.ToInput = 0.0f;
  result.Arc.FromInput = 0.0f;
  for (const vtkMTTriangleDeviation& deviation : patch.Deviations)
  {
    result.Arc.ToInput = std::max(result.Arc.ToInput, deviation.ToInput);
    result.Arc.FromInput = std::max(result.Arc.FromInput, deviation.FromInput);
  }
  result.Patch = this->Sink.Prepare(std::move(patch.Mesh), error);
  return result.Patch != nullptr;
}

bool vtkMTLevelStep::WritePatch(PatchToWrite&& patch, std::uint32_t fromNode, std::uint32_t toNode, std::string& error)
{
  this->State.Arcs.push_back({ patch.Arc, fromNode, toNode });
  const bool written = this->Sink.WritePrepared(std::move(patch.Patch));
  error = written ? error : this->Sink.GetError();
  return written;
}
