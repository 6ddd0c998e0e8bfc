// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFarthestPlaces
 * @brief from samples of a surface to the places that are farthest from another one
 *
 * Samples find the largest distance nearly, and the fewer of them there are the less. So those that are farthest away
 * climb: each by steps towards the corners of its triangle, the best of the three where one leads farther, and half as
 * long a step where none does. What is found is a place of the surface at that distance; there may be a farther one.
 *
 * All places climb together, so that their queries run in parallel. Results do not depend on the number of threads.
 */
#ifndef vtkMTFarthestPlaces_h
#define vtkMTFarthestPlaces_h

#include "vtkMTClosestPoint.h"
#include "vtkMTSampledSurface.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTFarthestPlaces
{
public:
  struct Place
  {
    vtkMTRealPoint Point;
    std::uint32_t Triangle; ///< of the surface, which the point is in; NoTriangle: not known, it does not climb
    double Distance;        ///< to the other surface
    std::uint32_t Nearest;  ///< triangle of the other surface
  };
  using Places = std::vector<Place>;
  using Progress = vtkMTClosestPoint::Progress;

  /// Both surfaces must outlive this object.
  vtkMTFarthestPlaces(const vtkMTSampledSurface& surface, const vtkMTClosestPoint& other)
    : Surface(surface)
    , Other(other)
  {
  }

  /// Points of the surface as places; triangles: of each, or empty. False when progress stopped it, here and below.
  bool Measure(const std::vector<vtkMTRealPoint>& points, const std::vector<std::uint32_t>& triangles, Places& places,
    const Progress& progress) const;

  /// Where the farthest places climb to: about count of them, as many of each group, and at least one.
  using Group = std::function<std::uint32_t(const Place& place)>;
  bool Climb(
    const Places& places, const Group& group, std::size_t count, Places& climbed, const Progress& progress) const;

private:
  bool Step(
    Places& places, std::vector<std::size_t>& climbing, std::vector<double>& steps, const Progress& progress) const;

  const vtkMTSampledSurface& Surface;
  const vtkMTClosestPoint& Other;
};

#endif
