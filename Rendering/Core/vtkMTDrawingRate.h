// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDrawingRate
 * @brief how many triangles a window can draw in the time that a frame has
 *
 * A controller: told how long whole frames took and how many triangles they had, it says how many the next one may
 * have. A frame costs something whatever is drawn (other actors, pixels, buffer swaps) and something for each triangle.
 * The latter comes from the last two limits and what frames took under each of them; while there has been one only, all
 * of the cost is taken to be the triangles'.
 *
 * The limit stays what it is while the median of the frames since it was set is near what is wanted: within four per
 * cent, and what the spread of the frames makes uncertain. So a still scene keeps its cut, a single slow frame changes
 * nothing, and a heavier scene is answered after a few.
 *
 * Frames that have no rate to keep, as they are drawn while the camera rests, may wait for patches; they are
 * learnt from only until there are others.
 *
 * It knows no clock: the same frames give the same limits.
 */
#ifndef vtkMTDrawingRate_h
#define vtkMTDrawingRate_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTRENDERINGCORE_EXPORT vtkMTDrawingRate
{
public:
  /// Frames that may take as many seconds or more have no rate to keep: an interactor that rests asks for 10,000.
  static constexpr double Unhurried = 100.0;

  /// A frame of so many triangles took so long, where so long was wanted. Without triangles it says nothing.
  void AddFrame(std::uint64_t triangles, double seconds, double wanted);

  /// Triangles that a frame may have that is to take so many seconds, 1 at least; 0 while nothing is known.
  std::uint64_t GetTriangles(double wanted);

  /// Triangles per second of whole frames, as they were drawn last; 0 while nothing is known.
  double GetRate() const { return this->Now.Seconds > 0.0 ? this->Now.Triangles / this->Now.Seconds : 0.0; }

private:
  struct Sample
  {
    double Triangles = 0.0;
    double Seconds = 0.0;
  };

  double GetTriangleSeconds() const;
  double Predict(double wanted) const;
  Sample GetMedian(std::size_t count) const;
  double GetSpread(double median) const;
  bool IsOff(std::size_t count) const;
  void AdjustLimit();
  void LearnFixedPart();
  void SetLimit(double wanted);

  double Wanted = 0.0;         // seconds; 0: no frame had a rate to keep yet
  double Limit = 0.0;          // triangles, for that
  double Fixed = 0.0;          // seconds of a frame without triangles
  double LastSpread = 0.0;     // under the limit before
  bool Settling = false;       // the next frame is the first under a new limit
  Sample Now;                  // median under this limit
  Sample Before;               // and under the one before
  std::vector<Sample> Samples; // frames under this limit, the last ones
};

#endif
