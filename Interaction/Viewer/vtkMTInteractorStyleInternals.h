// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMTInteractorStyleInternals.h
 * @brief what vtkMTInteractorStyle keeps, and the table of its keys
 */
#ifndef vtkMTInteractorStyleInternals_h
#define vtkMTInteractorStyleInternals_h

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkMTCameraPath.h"
#include "vtkMTColorSelector.h"
#include "vtkMTFigureOverlay.h"
#include "vtkMTInteractorStyle.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <vector>

struct vtkMTInteractorStyle::Internals
{
  using Clock = std::chrono::steady_clock;

  explicit Internals(vtkMTInteractorStyle* style)
    : Overlay(this->Colors, [style] { return style->GetTextBelowFigures(); })
  {
  }

  double GetElapsed() const { return std::chrono::duration<double>(Clock::now() - this->Start).count(); }

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkMTColorSelector Colors;
  vtkMTFigureOverlay Overlay; // after what it looks at
  vtkSmartPointer<vtkMTCameraPath> Path = vtkSmartPointer<vtkMTCameraPath>::New();
  vtkNew<vtkCallbackCommand> FrameCommand;
  Clock::time_point Start; // of the recording or the replay
  bool IsRecording = false;
  vtkNew<vtkCamera> LastView; // that was recorded
  bool IsPlaying = false;
  int Timer = 0; // of the replay
};

struct vtkMTInteractorStyle::Keys
{
  struct Key
  {
    const char* Name;  // as PressKey takes it
    const char* Shown; // in the list of keys; null where an entry before stands for it too
    const char* Text;
    void (*Do)(vtkMTInteractorStyle* self);
  };

  static const std::vector<Key> Table;

  static void Turn(vtkMTInteractorStyle* self, double right, double up);
  static void Pan(vtkMTInteractorStyle* self, double right, double up);
  static void Zoom(vtkMTInteractorStyle* self, double factor);
  static void Roll(vtkMTInteractorStyle* self, double degrees);
  static void LookAlong(vtkMTInteractorStyle* self, int axis, int side);
  static void Reset(vtkMTInteractorStyle* self);
  static void ScalePixelError(vtkMTInteractorStyle* self, double factor);
  static void ToggleFreeze(vtkMTInteractorStyle* self);
  static void ColorBy(vtkMTInteractorStyle* self, const char* name);
  static void NextArray(vtkMTInteractorStyle* self, int step);
  static void NextComponent(vtkMTInteractorStyle* self);
  static void ToggleTextures(vtkMTInteractorStyle* self);
  static void SetRepresentation(vtkMTInteractorStyle* self, int representation);
  static void ToggleEdges(vtkMTInteractorStyle* self);
  static void ToggleRecording(vtkMTInteractorStyle* self);
  static void TogglePlaying(vtkMTInteractorStyle* self);
  static void AddView(vtkMTInteractorStyle* self);
  static void WritePath(vtkMTInteractorStyle* self);
  static void ForgetPath(vtkMTInteractorStyle* self);
  static void Quit(vtkMTInteractorStyle* self);
};

#endif
