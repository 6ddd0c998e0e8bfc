// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTuples
 * @brief chosen tuples of a column, in another order
 *
 * A patch's columns are taken apart and put in order whenever it is split or encoded. Tuples of 4, 8 and 12 bytes, the
 * usual ones, are copied by an instruction or two each.
 */
#ifndef vtkMTTuples_h
#define vtkMTTuples_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTTuples
{
  /// The tuples with these numbers; nothing of an empty column.
  static vtkMTColumn Gather(const vtkMTColumn& column, std::size_t tupleSize, const std::vector<std::uint32_t>& tuples);
};

#endif
