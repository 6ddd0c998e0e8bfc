// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTWindowClock
 * @brief times a window's frames, for all mappers that draw in it
 *
 * A frame runs from the window's StartEvent to its EndEvent, so that everything drawn in it counts, and the swap of the
 * buffers. By then the GPU may still be at work: where OpenGL has timestamps (vtkOpenGLRenderTimer), a frame takes at
 * least until the GPU has done the last of its commands, from when the frame began or, if that is later, the GPU was
 * done with the frame before. No frame waits for them: it is learnt from when its timestamp has come, a frame or two
 * later.
 *
 * Frames that are not shown (selections) or were aborted do not count.
 *
 * The mappers share one object for each window. It goes with the last of them, and its observers with it; the window
 * may go first.
 */
#ifndef vtkMTWindowClock_h
#define vtkMTWindowClock_h

#include "vtkMTFrameClock.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <deque>
#include <memory>

class vtkCallbackCommand;
class vtkObject;
class vtkOpenGLRenderTimer;
class vtkRenderWindow;

class vtkMTWindowClock
{
public:
  /// The window's clock, made if need be.
  static std::shared_ptr<vtkMTWindowClock> Get(vtkRenderWindow* window);

  ~vtkMTWindowClock();
  vtkMTWindowClock(const vtkMTWindowClock&) = delete;
  vtkMTWindowClock& operator=(const vtkMTWindowClock&) = delete;

  /// What the actors of this frame ask and say. The context must be current at the first call in a frame.
  vtkMTFrameClock& UseInFrame();
  /// Seconds that the renderers of the window allow a frame: one by the window's DesiredUpdateRate, unless the
  /// renderers were told otherwise.
  double GetWanted() const;

  /// Triangles per second, measured; 0 while nothing is known.
  double GetRate() const { return this->Frames.GetRate().GetRate(); }

  /// The context must be current.
  void ReleaseGraphicsResources();

private:
  // A frame whose end the GPU has yet to say.
  struct Pending
  {
    vtkMTFrameClock::Frame Frame;
    std::unique_ptr<vtkOpenGLRenderTimer> Timer;
    std::uint64_t Begin = 0; // nanoseconds of the GPU's clock
  };

  explicit vtkMTWindowClock(vtkRenderWindow* window);
  static void OnEvent(vtkObject* window, unsigned long event, void* self, void* data);
  void BeginTimer();
  void End();
  void Collect();

  vtkWeakPointer<vtkRenderWindow> Window;
  vtkNew<vtkCallbackCommand> Observer;
  vtkMTFrameClock Frames;
  Pending Current;              // with a timer where an actor has been drawn in this frame and there are timers
  std::deque<Pending> Waiting;  // the oldest first
  std::uint64_t GpuWasDone = 0; // with the frame before; 0: not known
};

#endif
