// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTExactPoints
 * @brief the input's coordinates, bit for bit, as residuals against the lattice
 *
 * A model that was built to be exact has a point array of role ExactPoints on level 0: for each coordinate, how many
 * numbers of the input's type (float where all coordinates are floats, else double) lie between the lattice's place,
 * rounded to that type, and the input's coordinate. The bits of a number, read as an integer and ordered as the numbers
 * are, make this a difference of integers, so that signed zeros, denormals and numbers of any size come back as they
 * were. Patches of coarser levels have an empty column, and so has a mesh that was assembled from patches of several
 * levels: it lies on the lattice, or its borders would not match. What is drawn is always on the lattice.
 */
#ifndef vtkMTExactPoints_h
#define vtkMTExactPoints_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTExactPoints
{
  using Place = std::array<double, 3>;

  /// Three ints for floats, three long longs for doubles; the name is one that `others` do not have.
  static vtkMTArrayInfo MakeInfo(bool isSingle, const std::vector<vtkMTArrayInfo>& others);
  /// Whether the array is what MakeInfo makes, apart from its name.
  static bool IsSound(const vtkMTArrayInfo& info);
  /// Of a model's array: whether it is about floats.
  static bool IsSingle(const vtkMTArrayInfo& info);
  /// Whether the number is a float; so is every number that is not finite, as no point has one.
  static bool IsSingle(double x);

  /// Writes one tuple of the array.
  static void Encode(const vtkMTArrayInfo& info, const vtkMTLattice& lattice, const vtkMTPoint& point,
    const Place& exact, unsigned char* tuple);
  /// False when the place is farther from the point than any is that was put on the lattice.
  static bool Decode(const vtkMTArrayInfo& info, const vtkMTLattice& lattice, const vtkMTPoint& point,
    const unsigned char* tuple, Place& exact);
};

#endif
