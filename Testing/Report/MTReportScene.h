// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportScene
 * @brief a window off screen with one actor, drawn along a flight: what frames cost, and what they show
 */
#ifndef MTReportScene_h
#define MTReportScene_h

#include "MTReportPicture.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

class FlightPath;
class vtkProp;

class MTReportScene
{
public:
  MTReportScene(const std::array<int, 2>& size, vtkProp* actor);

  void Look(const FlightPath& path, int frame);
  /// Draws and waits for OpenGL; CPU seconds of all threads.
  double Draw();
  MTReportPicture GetPicture() { return MTReportPicture(this->Window); }
  vtkRenderWindow* GetWindow() { return this->Window; }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

#endif
