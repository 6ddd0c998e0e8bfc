// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDrawingRate
 * @brief how many triangles can be drawn in the time that a frame has
 *
 * Measured over the frames before, the last ones counting most, or given. Of a measured rate the triangles are rounded
 * down to quarters of a power of two, so that a rate that flickers gives the same cut.
 */
#ifndef vtkMTDrawingRate_h
#define vtkMTDrawingRate_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstdint>

class VTKMTRENDERINGCORE_EXPORT vtkMTDrawingRate
{
public:
  /// Triangles per second that hold instead of what is measured; 0, the default, is none.
  void SetGiven(double rate) { this->Given = rate; }

  /// Seconds that a pass of the present frame took to draw.
  void AddSeconds(double seconds) { this->Seconds += seconds; }
  /// The present frame is over; in each of its passes it drew so many triangles.
  void EndFrame(std::uint64_t triangles);

  /// Triangles per second, given or measured; 0 while nothing has been measured.
  double GetRate() const { return this->Given > 0.0 ? this->Given : this->Measured; }

  /// Triangles that can be drawn in so many seconds. 0 is no limit: nothing is known, or there are not more than `all`.
  std::uint64_t GetTriangles(double seconds, std::uint64_t all) const;

private:
  double Given = 0.0;
  double Measured = 0.0;
  double Seconds = 0.0;
};

#endif
