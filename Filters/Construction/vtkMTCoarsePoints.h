// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCoarsePoints
 * @brief leaves a fragment's points no more bits than its error justifies
 *
 * A point of a coarse level is off by the fragment's error anyhow, so its low bits mean nothing, and they are most of
 * what a patch takes in a file. Points that no other region shares are rounded to multiples of a power of two, as far
 * as no triangle turns by more than about 25 degrees. When no point moves by more than r, every place of the fragment
 * moves by r at most, so certified distances grow by r in both directions.
 */
#ifndef vtkMTCoarsePoints_h
#define vtkMTCoarsePoints_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

struct VTKMTCONSTRUCTION_EXPORT vtkMTCoarsePoints
{
  /// A point moves at most by this share of the fragment's error, and of its mean edge length.
  static constexpr double ShareOfError = 1.0 / 32.0;
  static constexpr double ShareOfEdgeLength = 1.0 / 64.0;
  static constexpr unsigned MaximumShift = 24;

  /// The largest shift that keeps to these shares; error and length in steps. 0: nothing is to be rounded.
  static unsigned ChooseShift(double error, double edgeLength);

  /// Rounds the points from Ids.size() on to multiples of 2^shift. Gives the longest way that one moved, in steps.
  static double Round(vtkMTPatch& fragment, unsigned shift);
};

#endif
