// SPDX-License-Identifier: BSD-3-Clause
/**
 * Four doubles that a processor handles at once; not installed.
 *
 * Vectors are an extension of GCC and Clang. Each lane is what the same operations on single numbers give, to the last
 * bit and on every processor, as nothing is contracted. What uses them is compiled twice (MT_FOR_WIDE_PROCESSORS), and
 * the processor's own is taken when the program starts. Everything here is inlined into that.
 */
#ifndef vtkMTWide_h
#define vtkMTWide_h

#include "Processor/vtkMTWideProcessors.h"

#include <cstdint>

// Lanes of two vectors, of which the second one's are counted from 4.
#if defined(__clang__) || __GNUC__ >= 12
#define MT_PICK_LANES(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define MT_PICK_LANES(a, b, i, j, k, l) __builtin_shuffle(a, b, vtkMTWide::Mask{ i, j, k, l })
#endif

namespace vtkMTWide
{
using Wide = double __attribute__((vector_size(32)));
using Mask = std::int64_t __attribute__((vector_size(32))); // of each lane, all bits or none

///@{
/// From and to what is aligned to 32 bytes.
using InMemory = double __attribute__((vector_size(32), may_alias));
[[gnu::always_inline]] inline const InMemory& Load(const double* numbers)
{
  return *reinterpret_cast<const InMemory*>(numbers);
}
[[gnu::always_inline]] inline void Store(double* numbers, const Wide& values)
{
  *reinterpret_cast<InMemory*>(numbers) = values;
}
///@}

/// Lane i of vector k becomes lane k of vector i.
[[gnu::always_inline]] inline void Transpose(Wide& a, Wide& b, Wide& c, Wide& d)
{
  const Wide ab02 = MT_PICK_LANES(a, b, 0, 4, 2, 6);
  const Wide ab13 = MT_PICK_LANES(a, b, 1, 5, 3, 7);
  const Wide cd02 = MT_PICK_LANES(c, d, 0, 4, 2, 6);
  const Wide cd13 = MT_PICK_LANES(c, d, 1, 5, 3, 7);
  a = MT_PICK_LANES(ab02, cd02, 0, 1, 4, 5);
  b = MT_PICK_LANES(ab13, cd13, 0, 1, 4, 5);
  c = MT_PICK_LANES(ab02, cd02, 2, 3, 6, 7);
  d = MT_PICK_LANES(ab13, cd13, 2, 3, 6, 7);
}

/// Four vectors of space.
struct Wide3
{
  Wide X;
  Wide Y;
  Wide Z;
};

[[gnu::always_inline]] inline void Gather(
  const double* a, const double* b, const double* c, const double* d, Wide3& result)
{
  result.X = Load(a);
  result.Y = Load(b);
  result.Z = Load(c);
  Wide unused = Load(d);
  Transpose(result.X, result.Y, result.Z, unused);
}

[[gnu::always_inline]] inline void Subtract(const Wide3& a, const Wide3& b, Wide3& result)
{
  result.X = a.X - b.X;
  result.Y = a.Y - b.Y;
  result.Z = a.Z - b.Z;
}
[[gnu::always_inline]] inline void Cross(const Wide3& a, const Wide3& b, Wide3& result)
{
  result.X = a.Y * b.Z - a.Z * b.Y;
  result.Y = a.Z * b.X - a.X * b.Z;
  result.Z = a.X * b.Y - a.Y * b.X;
}
[[gnu::always_inline]] inline void Dot(const Wide3& a, const Wide3& b, Wide& result)
{
  result = a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
}

#endif
