// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerification
 * @brief the sequence of checks behind vtkMultiTriangulationVerifier, as plain data in and plain data out
 *
 * First the model by itself (vtkMTStructureCheck). When all of it is sound, and an input is given, this is read another
 * way than the builder's (vtkMTVerifyInput) and held against the finest level (vtkMTInputComparison); then the
 * certified errors (vtkMTErrorSampling), and angles (vtkMTNormalSampling) and deviations of values (vtkMTValueSampling)
 * where the model has them: for every level, and for some random cuts. An input that cannot be read another way is read
 * by the opener for the errors alone, and the check "input_reading" says so; it has tested nothing then. A model that
 * is not sound has no cuts and distances that would mean anything, so its input is not even opened.
 */
#ifndef vtkMTVerification_h
#define vtkMTVerification_h

#include "vtkMTErrorSampling.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyInput.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTJointSampling;
class vtkMTPatchSource;
class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerification
{
public:
  /// Opens the input when it is needed. Null on failure, with the reason in error.
  using InputOpener = std::function<std::unique_ptr<vtkMTTriangleStream>(std::string& error)>;

  struct Settings
  {
    std::size_t Cuts = 100;
    std::size_t Samples = 500000;
    std::uint32_t Seed = 1;
    std::string InputName = "the input mesh"; ///< in messages
  };

  /// What the model is held against: a mesh, or files, or what the opener opens; files that cannot be read another way
  /// than the builder's are left to it too.
  struct Input
  {
    vtkPolyData* Mesh = nullptr;
    vtkMTVerifyInput::Options Files;
    InputOpener Open;

    bool IsEmpty() const { return !this->Mesh && this->Files.Paths.empty() && !this->Open; }
  };

  struct Result
  {
    std::vector<vtkMTVerificationCheck> Checks;
    std::map<std::uint32_t, std::size_t> Spans; ///< random cuts by the number of levels that they span
    bool IsCertified = false;                   ///< whether errors were tested; what follows is of them
    std::map<std::uint32_t, vtkMTErrorSampling::Tightness> Tightness; ///< by level
    std::uint64_t MeasuredCuts = 0;
    double Tolerance = 0.0;
    std::uint64_t SkippedValues = 0;               ///< samples of values that are not finite
    std::vector<vtkMTVerifyInput::Source> Sources; ///< of the input: how each file was read
    double CoordinateAllowance = 0.0; ///< what coordinates of the finest level may differ by, and what follows from it
    double AreaAllowance = 0.0;
    double VolumeAllowance = 0.0;
    std::int64_t NonFinite = 0; ///< triangles of the input that were left out, by reason
    std::int64_t OutOfRange = 0;
    std::int64_t Degenerate = 0;
    std::int64_t FarOutliers = 0;

    bool IsOk() const;
  };

  vtkMTVerification(const vtkMTPatchSource& source, const Settings& settings, vtkMTVerificationProgress progress);

  /// False when the checks could not be made, which error says, and when progress stopped them; then error is empty.
  bool Run(const Input& input, std::string& error);
  const Result& GetResult() const { return this->Checked; }

private:
  bool TestStructure();
  bool TestInput(const Input& input, std::string& error);
  bool ReadInput(const Input& input, vtkMTSampledSurface& surface, std::string& error);
  bool Compare(vtkPolyData* mesh, double rounding, vtkMTSampledSurface& surface, std::string& error);
  bool OpenInput(const InputOpener& open, vtkMTSampledSurface& surface, std::string& error);
  bool TestErrors(vtkMTSampledSurface&& surface, std::string& error);
  bool TestJointly(std::string& error);
  bool TestJointly(vtkMTJointSampling& sampling, std::string& error);
  vtkMTVerificationProgress NextStep();

  const vtkMTPatchSource& Source;
  const Settings Setting;
  const vtkMTVerificationProgress Progress;
  double Steps = 2.0; // of about equal time, to show progress by
  double Step = 0.0;
  Result Checked;
};

#endif
