// SPDX-License-Identifier: BSD-3-Clause
// The few operations on three doubles that the filters need; not installed.
#ifndef vtkMTVector_h
#define vtkMTVector_h

#include <array>
#include <cmath>

namespace vtkMTVector
{
using Vector = std::array<double, 3>;

inline Vector Subtract(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Vector Add(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Vector Scale(const Vector& a, double s)
{
  return { a[0] * s, a[1] * s, a[2] * s };
}
inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
inline double Norm(const Vector& a)
{
  return std::sqrt(Dot(a, a));
}
/// Norm, also where squares would overflow or vanish; slower.
inline double Length(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}
/// a + (b - a) t
inline Vector Lerp(const Vector& a, const Vector& b, double t)
{
  return { a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t };
}
}

#endif
