// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStructureCheck
 * @brief the checks of a model that need no input mesh
 *
 * All of them stop when progress returns false, and then return false.
 */
#ifndef vtkMTStructureCheck_h
#define vtkMTStructureCheck_h

#include "vtkMTValidate.h"
#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

class vtkMTPatchSource;

struct VTKMTVERIFICATION_EXPORT vtkMTStructureCheck
{
  /// Levels that a cut spans: from here on it tests something that one level alone does not.
  static constexpr std::uint32_t WideSpan = 3;

  /**
   * Adds four checks. "checksums": every block of the file is read. "graph": the DAG by itself. "patches": each patch
   * by itself and against its record. "nesting": errors and spheres fall along every arc, and the spheres hold the
   * patches' points; looked at here, not through the validator.
   */
  static bool TestParts(const vtkMTPatchSource& source, const vtkMTVerificationProgress& progress,
    std::vector<vtkMTVerificationCheck>& checks);

  /// "pasting": each fragment meets its surroundings along the same edges as its floor. Fills borders for the next
  /// check.
  static vtkMTVerificationCheck TestPasting(const vtkMTPatchSource& source, vtkMTValidate::Borders& borders);

  /**
   * Adds "conformity" of so many random cuts, at least half of which are wide where the model has such cuts (one whose
   * levels are one region each has none). spans gets how many cuts span 1, 2, 3 ... levels.
   */
  static bool TestConformity(const vtkMTPatchSource& source, const vtkMTValidate::Borders& borders, std::size_t cuts,
    std::uint32_t seed, const vtkMTVerificationProgress& progress, std::vector<vtkMTVerificationCheck>& checks,
    std::map<std::uint32_t, std::size_t>& spans);
};

#endif
