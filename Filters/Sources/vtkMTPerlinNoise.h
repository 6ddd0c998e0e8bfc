// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPerlinNoise
 * @brief improved Perlin noise
 *
 * Gradient noise as in K. Perlin, "Improving Noise", SIGGRAPH 2002: a gradient of one of twelve directions at each
 * point of the integer lattice, chosen by a permutation of 0..255 applied to x, y and z in turn, blended with 6t^5 -
 * 15t^4 + 10t^3. It is 0 at every lattice point, lies in [-1, 1] and repeats with period 256 along each axis.
 *
 * Seed 0 (the default) uses the paper's permutation; any other seed shuffles it (Fisher and Yates, driven by the 64-bit
 * Mersenne twister), the same on every machine.
 */
#ifndef vtkMTPerlinNoise_h
#define vtkMTPerlinNoise_h

#include "vtkMTSourcesModule.h" // For export macro

#include <array>
#include <cstdint>

class VTKMTSOURCES_EXPORT vtkMTPerlinNoise
{
public:
  explicit vtkMTPerlinNoise(std::uint64_t seed = 0);

  double Evaluate(double x, double y, double z) const;

private:
  double Gradient(int hash, double x, double y, double z) const;

  std::array<std::uint8_t, 512> Permutation; // twice the same, so that sums of two need no reduction
};

#endif
