// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRandomCut
 * @brief random cuts of a DAG for property tests and verification, the same ones for the same seed on every machine
 *
 * Three kinds take turns. Even indices refine a few random patches of the finest level with all that they depend on, so
 * the cut spans many levels (three at least, where a few attempts find such a cut). Odd ones refine every node whose
 * error is above a random threshold, or walk at random by single refinements and coarsenings.
 */
#ifndef vtkMTRandomCut_h
#define vtkMTRandomCut_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTCut.h"

#include <cstddef>
#include <cstdint>

class vtkMTGraph;

struct VTKMTCORE_EXPORT vtkMTRandomCut
{
  /// The cut number `index` of the sequence that belongs to the seed. The graph must be valid.
  static vtkMTCut Make(const vtkMTGraph& graph, std::uint32_t seed, std::size_t index);

  /// How many levels the cut's patches have between the finest and the coarsest one, both counted; 0 when it is empty.
  static std::uint32_t GetLevelSpan(const vtkMTGraph& graph, const vtkMTCut& cut);
};

#endif
