// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBuildProgress.h"

#include <algorithm>
#include <cmath>

vtkMTBuildProgress::vtkMTBuildProgress(const std::vector<Share>& shares, double levels)
  : Shares(shares)
{
  this->Shares.push_back({ "", levels });
}

vtkMTBuildProgress::~vtkMTBuildProgress() = default;

double vtkMTBuildProgress::GetFractionOfInput(const vtkMTWorkSettings::ProgressReport& report) const
{
  for (std::size_t i = 0; i + 1 < this->Shares.size(); ++i)
  {
    if (report.Step == this->Shares[i].Step)
    {
      const double done =
        report.Expected > 0 ? static_cast<double>(report.Done) / static_cast<double>(report.Expected) : 0.0;
      const double begin = this->Shares[i].Begin;
      return begin + std::min(1.0, done) * (this->Shares[i + 1].Begin - begin);
    }
  }
  return 0.0;
}

void vtkMTBuildProgress::Update(const vtkMTWorkSettings::ProgressReport& report)
{
  const double levels = this->Shares.back().Begin;
  const double fraction =
    report.Level == 0 ? this->GetFractionOfInput(report) : levels + (1.0 - levels) * std::min(1.0, report.Fraction);
  this->Fraction = std::max(this->Fraction, fraction);
  if (this->Step != report.Step || this->Level != report.Level || report.Done < this->FirstDone)
  {
    this->Step = report.Step;
    this->Level = report.Level;
    this->FirstDone = report.Done;
    this->Begin = std::chrono::steady_clock::now();
  }
  this->Describe(report);
}

void vtkMTBuildProgress::Describe(const vtkMTWorkSettings::ProgressReport& report)
{
  this->Text = "level " + std::to_string(report.Level) + ", " + report.Step;
  if (report.Done == 0)
  {
    return;
  }
  this->Text += ": " + std::to_string(report.Done);
  this->Text += report.Expected > 0 ? " of " + std::to_string(report.Expected) : "";
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
  if (seconds > 0.5 && report.Done > this->FirstDone)
  {
    const double rate = static_cast<double>(report.Done - this->FirstDone) / seconds;
    this->Text += ", " + std::to_string(std::llround(rate)) + " per second";
  }
}
