// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildProgress
 * @brief makes one fraction and one line of text of what the steps of a build report
 *
 * The steps of the input (level 0) have fixed shares of the whole, which the builder knows; the levels have the rest,
 * by the fraction that they report. The text has level, step, how much of it is done and how much per second.
 */
#ifndef vtkMTBuildProgress_h
#define vtkMTBuildProgress_h

#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTWorkSettings.h"

#include <chrono>
#include <string>
#include <vector>

class VTKMTFILTERSCORE_EXPORT vtkMTBuildProgress
{
public:
  /// Where a step of the input begins in the whole, 0 to 1.
  struct Share
  {
    std::string Step;
    double Begin;
  };

  /// shares: in increasing order. levels: where the levels begin, behind all of them.
  vtkMTBuildProgress(const std::vector<Share>& shares, double levels);
  ~vtkMTBuildProgress();

  void Update(const vtkMTWorkSettings::ProgressReport& report);
  double GetFraction() const { return this->Fraction; } ///< 0 to 1, never less than before
  const std::string& GetText() const { return this->Text; }

private:
  double GetFractionOfInput(const vtkMTWorkSettings::ProgressReport& report) const;
  void Describe(const vtkMTWorkSettings::ProgressReport& report);

  std::vector<Share> Shares; // and the levels
  double Fraction = 0.0;
  std::string Text;
  std::string Step;
  std::uint32_t Level = 0;
  std::uint64_t FirstDone = 0;
  std::chrono::steady_clock::time_point Begin; // of the step
};

#endif
