// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPalette
 * @brief colours that show a cut's structure
 */
#ifndef vtkMTPalette_h
#define vtkMTPalette_h

#include <array>
#include <cstdint>

struct vtkMTPalette
{
  using Color = std::array<unsigned char, 4>;

  /// Ten hues, neighbouring levels far apart; level 0 is green.
  static Color ForLevel(std::uint32_t level);
  /// A hue of its own for each patch, as far as 8 bits go.
  static Color ForPatch(std::uint32_t arc);
  /// From blue (no error) over white (half the threshold) to red (at or above it).
  static Color ForError(double error, double threshold);
};

#endif
