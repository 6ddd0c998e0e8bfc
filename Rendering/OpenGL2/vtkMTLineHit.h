// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLineHit
 * @brief where a line first meets patches
 */
#ifndef vtkMTLineHit_h
#define vtkMTLineHit_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTPatchSource;

struct vtkMTLineHit
{
  using Place = std::array<double, 3>;

  double T = 0.0;                  ///< 0 at the line's begin, 1 at its end
  std::array<double, 2> Weights{}; ///< of the triangle's second and third corner
  std::array<Place, 3> Triangle{}; ///< model units
  vtkIdType InputCell = 0;         ///< 0 where the model keeps no ids

  /// False when the line meets none of the arcs' patches. Patches that cannot be read are passed by; error says which.
  bool Find(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs, const Place& begin,
    const Place& end, std::string& error);
};

#endif
