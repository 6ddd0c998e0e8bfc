// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtStructure.h
 * @brief the checks of `bmt verify` that need no input mesh
 */
#ifndef bmtStructure_h
#define bmtStructure_h

#include "bmtCheck.h"

#include "vtkMTValidate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTPatchSource;

/**
 * "checksums": every block of the file is read. "graph": the DAG by itself. "patches": each patch by itself and against
 * its record. "nesting": errors and spheres fall along every arc, and the spheres hold the patches' points; looked at
 * here, not through the validator.
 */
std::vector<bmtCheck> bmtCheckStructure(const vtkMTPatchSource& source);

/// "pasting": each fragment meets its surroundings along the same edges as its floor. Fills borders for the next check.
bmtCheck bmtCheckPasting(const vtkMTPatchSource& source, vtkMTValidate::Borders& borders);

/**
 * "conformity" of `cuts` random cuts, at least half of which span three levels or more where the model has such cuts
 * (one whose levels are one region each has none). spans gets how many do, and how many cuts span 1, 2, 3 ... levels.
 */
bmtCheck bmtCheckConformity(const vtkMTPatchSource& source, const vtkMTValidate::Borders& borders, std::size_t cuts,
  std::uint32_t seed, bmtJson& spans);

#endif
