// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportReference
 * @brief a mesh that others are measured against: how far, and how differently turned, are they
 *
 * Samples, spread over both surfaces by area, look for the nearest place of the other surface, in both directions. The
 * largest distance is looked for further: at all vertices, and from the samples that are farthest away by climbing
 * within their triangles. It is a lower bound of the true one. The angles are those between the normals of a sample's
 * triangle and of the triangle that is nearest to it. Everything is the same in every run, to the last digit.
 */
#ifndef MTReportReference_h
#define MTReportReference_h

#include "vtkMTMeasuringFrame.h"
#include "vtkMTSampledSurface.h"

#include <cstddef>
#include <memory>

class vtkMTClosestPoint;
class vtkPolyData;

/// Both directions weigh the same in means.
struct MTReportDeviation
{
  double RootMeanSquare = 0.0; ///< distance, model units
  double Maximum = 0.0;        ///< model units
  double NormalMean = 0.0;     ///< degrees
  double Normal95 = 0.0;       ///< degrees: 95 per cent of the samples are within it
};

class MTReportReference
{
public:
  /// mesh: triangles. Throws std::runtime_error where there are none.
  explicit MTReportReference(vtkPolyData* mesh);
  ~MTReportReference();
  MTReportReference(const MTReportReference&) = delete;
  MTReportReference& operator=(const MTReportReference&) = delete;

  /// Of the bounding box, model units.
  double GetDiagonal() const { return this->Diagonal; }
  std::size_t GetNumberOfTriangles() const { return this->Surface.Triangles.size(); }

  /// samples: on each surface.
  MTReportDeviation Measure(vtkPolyData* approximation, std::size_t samples) const;

private:
  double Diagonal = 0.0;
  vtkMTMeasuringFrame Frame;
  vtkMTSampledSurface Surface; // in the frame's coordinates
  std::unique_ptr<vtkMTClosestPoint> Places;
};

#endif
