// SPDX-License-Identifier: BSD-3-Clause
// Functions that begin with MT_FOR_WIDE_PROCESSORS are made twice, and the processor's own is taken when the program
// starts: with instructions for four doubles or eight floats at a time (AVX2) the results are the same to the last bit,
// as nothing is contracted. Other compilers and processors have the plain ones.
#ifndef vtkMTWideProcessors_h
#define vtkMTWideProcessors_h

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MT_FOR_WIDE_PROCESSORS __attribute__((target_clones("avx2", "default")))
#else
#define MT_FOR_WIDE_PROCESSORS
#endif

#endif
