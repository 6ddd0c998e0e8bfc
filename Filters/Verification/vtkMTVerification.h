// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerification
 * @brief the sequence of checks behind vtkMultiTriangulationVerifier, as plain data in and plain data out
 *
 * First the model by itself (vtkMTStructureCheck). When all of it is sound, and an input is given, the certified errors
 * (vtkMTErrorSampling): for every level, and for some random cuts. A model that is not sound has no cuts and distances
 * that would mean anything, so its input is not even opened.
 */
#ifndef vtkMTVerification_h
#define vtkMTVerification_h

#include "vtkMTErrorSampling.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTPatchSource;

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

  struct Result
  {
    std::vector<vtkMTVerificationCheck> Checks;
    std::map<std::uint32_t, std::size_t> Spans; ///< random cuts by the number of levels that they span
    bool IsCertified = false;                   ///< whether errors were tested; what follows is of them
    std::map<std::uint32_t, vtkMTErrorSampling::Tightness> Tightness; ///< by level
    std::uint64_t MeasuredCuts = 0;
    double Tolerance = 0.0;
    std::int64_t NonFinite = 0; ///< triangles of the input that were left out, by reason
    std::int64_t OutOfRange = 0;
    std::int64_t Degenerate = 0;
    std::int64_t FarOutliers = 0;

    bool IsOk() const;
  };

  vtkMTVerification(const vtkMTPatchSource& source, const Settings& settings, vtkMTVerificationProgress progress);

  /// False when the checks could not be made, which error says, and when progress stopped them; then error is empty.
  bool Run(const InputOpener& openInput, std::string& error);
  const Result& GetResult() const { return this->Checked; }

private:
  bool TestStructure();
  bool TestErrors(const InputOpener& openInput, std::string& error);
  vtkMTVerificationProgress NextStep();

  const vtkMTPatchSource& Source;
  const Settings Setting;
  const vtkMTVerificationProgress Progress;
  double Steps = 2.0; // of about equal time, to show progress by
  double Step = 0.0;
  Result Checked;
};

#endif
