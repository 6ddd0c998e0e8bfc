// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPalette.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkMTPalette::Color FromHue(double hue, double saturation, double value)
{
  const auto channel = [hue, saturation, value](double shift)
  {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    const double c = value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    return static_cast<unsigned char>(std::lround(255.0 * c));
  };
  return { channel(5.0), channel(3.0), channel(1.0), 255 };
}
}

vtkMTPalette::Color vtkMTPalette::ForLevel(std::uint32_t level)
{
  // A third of the wheel and a little more each time: ten steps before a hue comes near an earlier one.
  const double hue = std::fmod(1.0 / 3.0 + level * 0.3, 1.0);
  return FromHue(hue, 0.65, 0.95);
}

vtkMTPalette::Color vtkMTPalette::ForPatch(std::uint32_t arc)
{
  // Multiples of the golden ratio spread evenly over the wheel, however many there are.
  const double hue = std::fmod(arc * 0.6180339887498949, 1.0);
  const double shade = 0.70 + 0.30 * std::fmod(arc * 0.7548776662466927, 1.0);
  return FromHue(hue, 0.55, shade);
}

vtkMTPalette::Color vtkMTPalette::ForError(double error, double threshold)
{
  const double ratio = threshold > 0.0 ? std::clamp(error / threshold, 0.0, 1.0) : (error > 0.0 ? 1.0 : 0.0);
  const double away = std::abs(2.0 * ratio - 1.0);
  const auto faded = static_cast<unsigned char>(std::lround(255.0 * (1.0 - 0.8 * away)));
  return ratio < 0.5 ? Color{ faded, faded, 255, 255 } : Color{ 255, faded, faded, 255 };
}
