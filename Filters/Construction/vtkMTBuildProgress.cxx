// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBuildProgress.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
// Where each step of the input begins; the last is where the levels do.
struct Share
{
  const char* Step;
  double Begin;
};
constexpr Share Shares[] = { { "reading points", 0.0 }, { "reading triangles", 0.02 }, { "sorting points", 0.04 },
  { "checking triangles", 0.06 }, { "looking for far outliers", 0.07 }, { "finding barycentres", 0.08 },
  { "placing regions", 0.11 }, { "sorting into regions", 0.13 }, { "making fragments", 0.17 },
  { "finishing fragments", 0.2 }, { "", 0.22 } };
constexpr double BeginOfLevels = 0.22;

double GetFractionOfInput(const vtkMTBuildSettings::ProgressReport& report)
{
  for (std::size_t i = 0; i + 1 < std::size(Shares); ++i)
  {
    if (std::string(report.Step) == Shares[i].Step)
    {
      const double done =
        report.OfTriangles > 0 ? static_cast<double>(report.Triangles) / static_cast<double>(report.OfTriangles) : 0.0;
      return Shares[i].Begin + std::min(1.0, done) * (Shares[i + 1].Begin - Shares[i].Begin);
    }
  }
  return 0.0;
}
}

void vtkMTBuildProgress::Update(const vtkMTBuildSettings::ProgressReport& report)
{
  const double fraction =
    report.Level == 0 ? GetFractionOfInput(report) : BeginOfLevels + (1.0 - BeginOfLevels) * report.Fraction;
  this->Fraction = std::max(this->Fraction, fraction);
  if (this->Step != report.Step || this->Level != report.Level || report.Triangles < this->FirstTriangles)
  {
    this->Step = report.Step;
    this->Level = report.Level;
    this->FirstTriangles = report.Triangles;
    this->Begin = std::chrono::steady_clock::now();
  }
  this->Describe(report);
}

void vtkMTBuildProgress::Describe(const vtkMTBuildSettings::ProgressReport& report)
{
  this->Text = "level " + std::to_string(report.Level) + ", " + report.Step;
  if (report.Triangles == 0)
  {
    return;
  }
  this->Text += ": " + std::to_string(report.Triangles);
  this->Text += report.OfTriangles > 0 ? " of " + std::to_string(report.OfTriangles) : "";
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
  if (seconds > 0.5 && report.Triangles > this->FirstTriangles)
  {
    const double rate = static_cast<double>(report.Triangles - this->FirstTriangles) / seconds;
    this->Text += ", " + std::to_string(std::llround(rate)) + " per second";
  }
}
