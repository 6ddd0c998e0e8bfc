// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLabelCheck
 * @brief labels never mix: coarse levels hold no label that the finest level does not hold
 *
 * Labels are arrays whose values are resampled as the nearest one, and arrays of one whole number with at most 256
 * different values, unless the model's settings name these as values to be interpolated (setting "values").
 */
#ifndef vtkMTLabelCheck_h
#define vtkMTLabelCheck_h

#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkMTPatchSource;

class VTKMTVERIFICATION_EXPORT vtkMTLabelCheck
{
public:
  /// The check "labels". False when a patch cannot be read, which error says, and when progress stopped it; then error
  /// is empty.
  static bool Test(const vtkMTPatchSource& source, const vtkMTVerificationProgress& progress,
    vtkMTVerificationCheck& check, std::string& error);
};

#endif
