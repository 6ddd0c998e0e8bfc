// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSampledSurface
 * @brief a triangle surface as the verification sees it
 *
 * The verification shares no code with the builder: it has its own surface, sampling and closest point search. What it
 * does share is the definition of the input: a triangle stream has triangulated polygons and strips already, because a
 * bent polygon is no surface before it is known where its diagonals run.
 */
#ifndef vtkMTSampledSurface_h
#define vtkMTSampledSurface_h

#include "vtkMTMeasuringFrame.h"
#include "vtkMTPatch.h"              // For vtkMTTriangle
#include "vtkMTVerificationModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkMTTriangleStream;

struct VTKMTVERIFICATION_EXPORT vtkMTSampledSurface
{
  std::vector<vtkMTRealPoint> Points;
  std::vector<vtkMTTriangle> Triangles;
  std::int64_t NonFinite = 0;   ///< triangles left out because a corner is NaN or infinite
  std::int64_t OutOfRange = 0;  ///< triangles left out because an index is
  std::int64_t FarOutliers = 0; ///< triangles left out because the model says that it lacks what is so far away
  std::int64_t Degenerate = 0;  ///< triangles left out because two corners are at one place: no surface

  /**
   * The stream's triangles, without those that are no surface. False on failure, which is explained in error, and when
   * goOn, which is asked after every block, returns false; then error is as it was. That no triangle is left is a
   * failure.
   */
  bool Read(vtkMTTriangleStream& stream, const std::function<bool()>& goOn, std::string& error);

  vtkMTRealBounds GetBounds() const;
  void Transform(const vtkMTMeasuringFrame& frame);
  /// The points that triangles use, each once, in order.
  std::vector<vtkMTRealPoint> GetUsedPoints() const;
  double GetArea(std::size_t triangle) const;
};

#endif
