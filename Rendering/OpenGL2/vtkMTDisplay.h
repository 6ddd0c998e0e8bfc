// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDisplay
 * @brief whether a window of VTK's kind can be opened here
 *
 * VTK's window for X aborts the process when there is no display. Whoever has a better answer asks before the first
 * Render.
 */
#ifndef vtkMTDisplay_h
#define vtkMTDisplay_h

#include "vtkMTRenderingOpenGL2Module.h" // For export macro

#include <string>

class vtkRenderWindow;

struct VTKMTRENDERINGOPENGL2_EXPORT vtkMTDisplay
{
  /// Nothing where the window can be opened; otherwise why it cannot.
  static std::string FindProblem(vtkRenderWindow* window);
};

#endif
