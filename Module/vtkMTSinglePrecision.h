// SPDX-License-Identifier: BSD-3-Clause
// Rounding to single precision that really takes place. Not installed.
#ifndef vtkMTSinglePrecision_h
#define vtkMTSinglePrecision_h

namespace vtkMTSinglePrecision
{
/**
 * x rounded to single precision. GCC 12.2 at -O2 turns static_cast<double>(static_cast<float>(x)) of neighbouring
 * values into nothing (its vectoriser of straight-line code loses both conversions); it may not do so with a volatile.
 */
inline double Round(double x)
{
  volatile float single = static_cast<float>(x);
  return single;
}

/// Whether single precision holds x; whatever is not finite, it does.
inline bool Holds(double x)
{
  return x != x || Round(x) == x;
}
}

#endif
