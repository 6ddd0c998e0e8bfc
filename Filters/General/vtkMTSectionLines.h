// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSectionLines
 * @brief where triangles change the sign of a function: one line each, closed by construction
 *
 * A corner is either negative or not, zero being not; so each triangle that has both has exactly two edges along which
 * the sign changes, and gives one line from one to the other. Points belong to edges, by the identity of their ends,
 * and are found from the negative end in all triangles. So wherever an edge has two triangles, the line goes on,
 * whatever the rounding; where the function is zero at a corner, some lines may have length 0. Lines run so that the
 * negative side is on their left, looked at from the front of the surface.
 */
#ifndef vtkMTSectionLines_h
#define vtkMTSectionLines_h

#include "vtkMTArrayInfo.h"
#include "vtkMTFiltersModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <vector>

class vtkImplicitFunction;
class vtkPolyData;

struct VTKMTFILTERS_EXPORT vtkMTSectionLines
{
  vtkImplicitFunction* Function = nullptr;
  /// What arrays are, so that ids and labels are taken from the nearer end and directions keep their length of 1.
  const std::vector<vtkMTArrayInfo>* Arrays = nullptr;
  std::function<bool(double)> Progress; ///< takes a fraction; false stops

  /// Triangles only. False when Progress stopped it.
  bool Make(vtkPolyData* mesh, vtkPolyData* output) const;
};

#endif
