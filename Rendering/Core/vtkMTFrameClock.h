// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFrameClock
 * @brief a window's frames: how long they take, and how many triangles each actor may draw in the next one
 *
 * All models that are drawn in a window share the time of its frames, with whatever else is drawn there. A frame runs
 * from Begin to End. In between, every actor asks once what it may draw (Allow), naming its share of the time, and says
 * what it drew (Draw). The triangles of a frame are vtkMTDrawingRate's, divided by the shares of those that draw
 * triangles; what one actor leaves, because it needs no more, goes to those that do. Shares and leavings are those of
 * the frame before.
 *
 * It has no clock of its own: whoever calls it says what time it is.
 */
#ifndef vtkMTFrameClock_h
#define vtkMTFrameClock_h

#include "vtkMTDrawingRate.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstdint>

class VTKMTRENDERINGCORE_EXPORT vtkMTFrameClock
{
public:
  /// What a frame was.
  struct Frame
  {
    std::uint64_t Triangles = 0;
    double Seconds = 0.0; ///< from Begin to End
    double Wanted = 0.0;
    bool Counts = false; ///< whether it says anything about others: some actor drew, and none called Discard
  };

  ///@{
  /// A frame begins, ends; the time is in seconds, from any origin on. A frame that begins before the last one has
  /// ended takes its place.
  void Begin(double time);
  Frame End(double time);
  ///@}
  bool IsInFrame() const { return this->InFrame; }
  double GetBegin() const { return this->Time; }

  /// This frame is not like others.
  void Discard() { this->Now.Discarded = true; }

  /// Triangles that an actor may draw, which is allotted a share, 0 to 1, of the seconds that the frame may take; 0 is
  /// no limit, while nothing is known.
  std::uint64_t Allow(double share, double wanted);
  /// What it drew then; WantsMore: fewer than it would have without a limit.
  void Draw(double share, std::uint64_t triangles, bool wantsMore);

  /// A frame's figures are known. Other than in End, since a GPU says later what it needed.
  void Learn(const Frame& frame);

  const vtkMTDrawingRate& GetRate() const { return this->Rate; }

private:
  // Of the actors of a frame.
  struct Sums
  {
    double Shares = 0.0;
    double WantingShares = 0.0; // of those that would draw more
    double Left = 0.0;          // triangles that others left, of All
    double All = 0.0;
    std::uint64_t Triangles = 0;
    double Wanted = 0.0;
    bool Drew = false;
    bool Discarded = false;
  };

  double GetFairPart(double share) const;

  vtkMTDrawingRate Rate;
  Sums Now;
  Sums Before;
  double Time = 0.0;
  bool InFrame = false;
};

#endif
