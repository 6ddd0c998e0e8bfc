// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStageTimes
 * @brief what a build spends its time with, by stage
 *
 * A Scope charges the time of the thread that makes it to a stage, until it ends or another one begins within it: so
 * every second is charged once. CPU time is the thread's; wall time is summed over threads, so that what it has more
 * than CPU time is waiting, for the disk as a rule; a thread that waits for the work of others charges nothing. Stages
 * that overlap are charged side by side, so all stages together may take longer than the clock says. Two clock readings
 * per scope: for units of work, not for loops.
 */
#ifndef vtkMTStageTimes_h
#define vtkMTStageTimes_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <array>
#include <atomic>
#include <cstdint>

class VTKMTFILTERSCORE_EXPORT vtkMTStageTimes
{
public:
  enum StageType
  {
    Read,     ///< the input's points and triangles
    Seed,     ///< barycentres, placing regions, finding triangles' regions
    Sort,     ///< external sorting, stitching, orientation, locks
    Assemble, ///< assembling fragments and floors, splitting into patches
    Simplify,
    Certify, ///< bounding the deviation, and carrying attributes over, which goes by what it found
    Encode,  ///< patches for the sink, fragments for the spools
    Write,   ///< spools, checkpoints and the file
    NumberOfStages
  };
  static const char* GetName(StageType stage);

  ///@{
  /// Seconds.
  double GetCpuSeconds(StageType stage) const { return 1e-9 * static_cast<double>(this->Cpu[stage]); }
  double GetWallSeconds(StageType stage) const { return 1e-9 * static_cast<double>(this->Wall[stage]); }
  ///@}

  ///@{
  /// By the clock, for all levels: what comes after the input has been read, sorted and stitched.
  void SetLevelSeconds(double seconds) { this->LevelSeconds = seconds; }
  double GetLevelSeconds() const { return this->LevelSeconds; }
  ///@}

  class VTKMTFILTERSCORE_EXPORT Scope
  {
  public:
    /// For the calling thread. times: null charges nothing, nor what is around. forAllThreads: CPU time of the process,
    /// while only this thread's parallel loops are at work.
    Scope(vtkMTStageTimes* times, StageType stage, bool forAllThreads = false);
    /// The same within another scope of this thread, for its times; does nothing without one.
    explicit Scope(StageType stage);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    void Begin();
    void Charge();

    Scope* const Outer;
    vtkMTStageTimes* const Times;
    const StageType Stage;
    const bool IsForAllThreads;
    std::int64_t CpuBegin = 0;
    std::int64_t WallBegin = 0;
  };

private:
  std::array<std::atomic<std::int64_t>, NumberOfStages> Cpu{}; // nanoseconds
  std::array<std::atomic<std::int64_t>, NumberOfStages> Wall{};
  double LevelSeconds = 0.0;
};

#endif
