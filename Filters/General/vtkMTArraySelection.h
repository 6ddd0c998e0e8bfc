// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArraySelection
 * @brief which of a model's arrays two vtkDataArraySelection let through
 *
 * Exact points, which become coordinates, always go through. What a selection does not know goes through, and the
 * selection knows it from then on.
 */
#ifndef vtkMTArraySelection_h
#define vtkMTArraySelection_h

#include "vtkMTArrayInfo.h"

#include <vector>

class vtkDataArraySelection;

struct vtkMTArraySelection
{
  /// One entry per array, as vtkMTPatchSource takes it.
  static std::vector<unsigned char> Choose(
    const std::vector<vtkMTArrayInfo>& arrays, vtkDataArraySelection* points, vtkDataArraySelection* cells);
};

#endif
