// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSurfaceSampler
 * @brief points on a surface, area weighted and stratified
 *
 * Sample k of n lies at a random place of the k-th n-th of the surface's area, so every part of the surface gets its
 * share to within one sample. Random numbers are a function of seed and k, so samples do not depend on threads.
 */
#ifndef vtkMTSurfaceSampler_h
#define vtkMTSurfaceSampler_h

#include "vtkMTSampledSurface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTSurfaceSampler
{
public:
  struct Samples
  {
    std::vector<vtkMTRealPoint> Points;
    std::vector<std::uint32_t> Triangles;       ///< of each point
    std::vector<std::array<double, 2>> Weights; ///< of its triangle's second and third corner
  };

  /// The surface must outlive this object.
  vtkMTSurfaceSampler(const vtkMTSampledSurface& surface, std::size_t count, std::uint64_t seed);

  /// 0 when the surface has no area.
  std::size_t GetNumberOfSamples() const { return this->Count; }
  /// The samples first .. last-1.
  Samples Take(std::size_t first, std::size_t last) const;

private:
  const vtkMTSampledSurface& Surface;
  std::vector<double> Areas; // sums over the first i triangles
  std::size_t Count;
  std::uint64_t Seed;
};

#endif
