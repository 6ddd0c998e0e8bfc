// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSurfaceDistance
 * @brief the two-sided distance between two surfaces, by sampling
 *
 * Distances go from area-weighted samples and from all vertices of one surface to the closest point of the other. The
 * maximum is over both; the mean square over the samples alone, and over the vertices where a surface has no area.
 * Results depend on the surfaces, the number of samples and the seed alone.
 */
#ifndef vtkMTSurfaceDistance_h
#define vtkMTSurfaceDistance_h

#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <cstdint>

struct VTKMTVERIFICATION_EXPORT vtkMTSurfaceDistance
{
  struct OneSided
  {
    double Maximum = 0.0;
    double RootMeanSquare = 0.0;
    std::size_t Samples = 0;
    std::size_t Vertices = 0;
  };

  OneSided FromAToB;
  OneSided FromBToA;
  double Maximum = 0.0;
  double RootMeanSquare = 0.0; ///< both directions weigh the same
  double Diagonal = 0.0;       ///< of the box around both

  /**
   * Measures, in model units. The surfaces must not be empty; they are moved to a frame of their own. False when
   * progress stopped it.
   */
  bool Measure(vtkMTSampledSurface& a, vtkMTSampledSurface& b, std::size_t samples, std::uint64_t seed,
    const vtkMTVerificationProgress& progress);
};

#endif
