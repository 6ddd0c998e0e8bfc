// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtSampling.h
 * @brief points on a surface, area weighted and stratified
 *
 * Sample k of n lies at a random place of the k-th n-th of the surface's area, so every part of the surface gets its
 * share to within one sample. Random numbers are a function of seed and k, so samples do not depend on threads.
 */
#ifndef bmtSampling_h
#define bmtSampling_h

#include "bmtSurface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct bmtSamples
{
  std::vector<bmtPoint> Points;
  std::vector<std::uint32_t> Triangles; ///< of each point
};

class bmtSampler
{
public:
  /// The surface must outlive this object.
  bmtSampler(const bmtSurface& surface, std::size_t count, std::uint64_t seed);

  /// 0 when the surface has no area.
  std::size_t GetCount() const { return this->Count; }
  /// The samples first .. last-1.
  bmtSamples Take(std::size_t first, std::size_t last) const;

private:
  const bmtSurface& Surface;
  std::vector<double> Areas; // of the first i triangles together
  std::size_t Count;
  std::uint64_t Seed;
};

/// A uniform number in [0, 1) for each pair.
double bmtUniform(std::uint64_t seed, std::uint64_t index);

#endif
