// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStageTimes.h"

#include <ctime>

namespace
{
thread_local vtkMTStageTimes::Scope* Innermost = nullptr;

std::int64_t ReadClock(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}
}

const char* vtkMTStageTimes::GetName(StageType stage)
{
  static const char* const names[NumberOfStages] = { "read", "seed", "sort", "assemble", "simplify", "certify",
    "encode", "write" };
  return names[stage];
}

vtkMTStageTimes::Scope::Scope(vtkMTStageTimes* times, StageType stage, bool forAllThreads)
  : Outer(Innermost)
  , Times(times)
  , Stage(stage)
  , IsForAllThreads(forAllThreads)
{
  if (this->Outer)
  {
    this->Outer->Charge();
  }
  Innermost = this;
  this->Begin();
}

vtkMTStageTimes::Scope::Scope(StageType stage)
  : Scope(Innermost ? Innermost->Times : nullptr, stage)
{
}

vtkMTStageTimes::Scope::~Scope()
{
  this->Charge();
  Innermost = this->Outer;
  if (this->Outer)
  {
    this->Outer->Begin();
  }
}

void vtkMTStageTimes::Scope::Begin()
{
  if (this->Times)
  {
    this->CpuBegin = ReadClock(this->IsForAllThreads ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_THREAD_CPUTIME_ID);
    this->WallBegin = ReadClock(CLOCK_MONOTONIC);
  }
}

void vtkMTStageTimes::Scope::Charge()
{
  if (this->Times)
  {
    const std::int64_t now = ReadClock(this->IsForAllThreads ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_THREAD_CPUTIME_ID);
    this->Times->Cpu[this->Stage] += now - this->CpuBegin;
    this->Times->Wall[this->Stage] += ReadClock(CLOCK_MONOTONIC) - this->WallBegin;
  }
}
