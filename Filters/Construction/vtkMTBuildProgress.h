// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildProgress
 * @brief makes one fraction and one line of text of what the steps of a build report
 *
 * The steps of the input have fixed shares of the whole, measured on fractal spheres; the levels share the rest by
 * their triangles. The text says level, step, triangles and triangles per second.
 */
#ifndef vtkMTBuildProgress_h
#define vtkMTBuildProgress_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro

#include <chrono>
#include <string>

class VTKMTCONSTRUCTION_EXPORT vtkMTBuildProgress
{
public:
  void Update(const vtkMTBuildSettings::ProgressReport& report);
  double GetFraction() const { return this->Fraction; } ///< 0 to 1, never less than before
  const std::string& GetText() const { return this->Text; }

private:
  void Describe(const vtkMTBuildSettings::ProgressReport& report);

  double Fraction = 0.0;
  std::string Text;
  std::string Step;
  std::uint32_t Level = 0;
  std::uint64_t FirstTriangles = 0;
  std::chrono::steady_clock::time_point Begin; // of the step
};

#endif
