// SPDX-License-Identifier: BSD-3-Clause
/**
 * Upper bounds in single precision: what is rounded is never below what it was. In line and without a call of the C
 * library, for it is done for every triangle.
 */
#ifndef vtkMTRoundUp_h
#define vtkMTRoundUp_h

#include <cstdint>
#include <cstring>

namespace vtkMTRoundUp
{
/// The float after a value that is zero or above and finite.
inline float GetNext(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  ++bits; // floats above zero are in the order of their bits
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// The least float that is no smaller; of values from zero on.
inline float ToFloat(double value)
{
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) < value ? GetNext(rounded) : rounded;
}
}

#endif
