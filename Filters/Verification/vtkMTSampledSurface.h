// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSampledSurface
 * @brief a triangle surface as the verification sees it
 *
 * The verification shares no code with the builder: it has its own surface, sampling and closest point search. What it
 * shares with it, where the input is given as a triangle stream, is where the diagonals of polygons run.
 */
#ifndef vtkMTSampledSurface_h
#define vtkMTSampledSurface_h

#include "vtkMTMeasuringFrame.h"
#include "vtkMTPatch.h"              // For vtkMTTriangle
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkMTGraph;
struct vtkMTLattice;
class vtkMTTriangleStream;

struct VTKMTVERIFICATION_EXPORT vtkMTSampledSurface
{
  std::vector<vtkMTRealPoint> Points;
  std::vector<vtkMTTriangle> Triangles;
  std::vector<vtkIdType> Cells;     ///< of each triangle, where the surface is made of cells; else empty
  std::vector<double> Slack;        ///< of each triangle, see vtkMTVerifyPolygons; empty: none has any
  std::vector<unsigned char> Mixed; ///< of each triangle, likewise
  double Rounding = 0.0;            ///< what its coordinates may be off by, where they are calculated; model units
  std::int64_t NonFinite = 0;       ///< triangles left out because a corner is NaN or infinite
  std::int64_t OutOfRange = 0;      ///< triangles left out because an index is
  std::int64_t FarOutliers = 0;     ///< triangles left out because the model says that it lacks what is so far away
  std::int64_t Degenerate = 0;      ///< triangles left out because two corners are at one place: no surface

  /**
   * The stream's triangles, without those that are no surface. False on failure, which is explained in error, and when
   * goOn, which is asked after every block, returns false; then error is as it was. That no triangle is left is a
   * failure.
   */
  bool Read(vtkMTTriangleStream& stream, const std::function<bool()>& goOn, std::string& error);

  /// The builder leaves out what is far outside of everything else, where the graph's input report says so. What that
  /// is shows here by itself: it lies at least one extent outside of the model.
  void LeaveOutFar(const vtkMTGraph& graph);

  /// Adds a patch, its points in the coordinates of the frame.
  void Append(const vtkMTPatch& patch, const vtkMTLattice& lattice, const vtkMTMeasuringFrame& frame);

  vtkMTRealBounds GetBounds() const;
  void Transform(const vtkMTMeasuringFrame& frame);
  /// The points that triangles use, each once, in order.
  std::vector<vtkMTRealPoint> GetUsedPoints() const;
  double GetArea(std::size_t triangle) const;
};

#endif
