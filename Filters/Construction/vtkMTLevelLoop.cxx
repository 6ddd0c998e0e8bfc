// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLevelLoop.h"

#include "vtkMTCheckpoint.h"
#include "vtkMTFinishStep.h"
#include "vtkMTPatchSink.h"
#include "vtkMTSequenceState.h"
#include "vtkMTSimplifyStep.h"
#include "vtkMTSplitStep.h"
#include "vtkMTTrimHeap.h"

namespace
{
constexpr std::uint32_t MaximumLevels = 60; // identities have room for 61
}

class vtkMTLevelLoop::Internals
{
public:
  Internals(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, const std::string& identity)
    : Options(settings)
    , Sink(sink)
    , Identity(identity)
  {
  }

  bool Run(vtkMTSequenceState& state)
  {
    this->State = &state;
    if (state.Level == 0 && state.Stage == vtkMTSequenceState::HasFragments && !this->Commit())
    {
      return false;
    }
    while (state.Stage == vtkMTSequenceState::HasPatches || !this->IsFinished())
    {
      const bool done = state.Stage == vtkMTSequenceState::HasFragments
        ? this->RunStep(vtkMTSplitStep(this->Options, this->Sink, state))
        : this->RunStep(vtkMTSimplifyStep(this->Options, this->Sink, state));
      if (!done || !this->Commit())
      {
        return false;
      }
    }
    return this->RunStep(vtkMTFinishStep(this->Options, this->Sink, state));
  }

  std::string Error;
  bool Aborted = false;
  bool HasCommitted = false;

private:
  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  bool RunStep(vtkMTLevelStep&& step)
  {
    const vtkMTTrimHeap trim(this->Options.MemoryLimit);
    const bool done = step.Run();
    this->Aborted = step.WasAborted();
    return done || this->Fail(step.GetError());
  }

  bool Commit()
  {
    const vtkMTStageTimes::Scope write(this->Options.Times, vtkMTStageTimes::Write);
    vtkMTCheckpoint checkpoint;
    if (!this->Options.Store->IsLasting() || !this->Sink.Save(checkpoint.Sink))
    {
      return this->Sink.GetError().empty() || this->Fail(this->Sink.GetError());
    }
    checkpoint.Identity = this->Identity;
    this->State->Save(checkpoint.State);
    this->HasCommitted = checkpoint.Write(*this->Options.Store, this->Error) || this->HasCommitted;
    return this->Error.empty();
  }

  bool IsFinished() const
  {
    const auto& counts = this->State->LevelElements;
    const std::uint32_t level = this->State->Level;
    if (this->State->NodeOfFragment.size() <= 1 && counts.back() <= this->Options.PatchTriangles)
    {
      return true;
    }
    const auto isStuck = [&counts](std::size_t i)
    { return static_cast<double>(counts[i]) > 0.9 * static_cast<double>(counts[i - 1]); };
    return (level >= 2 && isStuck(level) && isStuck(level - 1)) || level >= MaximumLevels;
  }

  const vtkMTBuildSettings Options;
  vtkMTPatchSink& Sink;
  const std::string Identity;
  vtkMTSequenceState* State = nullptr;
};

vtkMTLevelLoop::vtkMTLevelLoop(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, const std::string& identity)
  : Implementation(std::make_unique<Internals>(settings, sink, identity))
{
}

vtkMTLevelLoop::~vtkMTLevelLoop() = default;

bool vtkMTLevelLoop::Run(vtkMTSequenceState& state)
{
  return this->Implementation->Run(state);
}

const std::string& vtkMTLevelLoop::GetError() const
{
  return this->Implementation->Error;
}

bool vtkMTLevelLoop::WasAborted() const
{
  return this->Implementation->Aborted;
}

bool vtkMTLevelLoop::HasCheckpoint() const
{
  return this->Implementation->HasCommitted;
}
