// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLatticeChoice
 * @brief the coarsest lattice on which no point of an input moves by more than a precision
 */
#ifndef vtkMTLatticeChoice_h
#define vtkMTLatticeChoice_h

#include "vtkMTBuildingModule.h" // For export macro

class vtkMTTriangleStream;
struct vtkMTBuildError;

struct VTKMTBUILDING_EXPORT vtkMTLatticeChoice
{
  /// Reads all points for their bounds. precision, in model units, is above 0. False when there is none, or on failure.
  static bool FindBits(vtkMTTriangleStream& input, double precision, int& bits, vtkMTBuildError& error);
};

#endif
