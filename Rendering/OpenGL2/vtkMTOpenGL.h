// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of VTK's OpenGL. The functions of OpenGL come from the loader that VTK uses: GLEW
// up to VTK 9.3, GLAD from 9.4 on. Both come with the module RenderingOpenGL2, and their headers must come before any
// other that includes OpenGL's.
#ifndef vtkMTOpenGL_h
#define vtkMTOpenGL_h

#include "vtkVersion.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

/// Coordinates in the texture of the lookup table. From 9.3 on they do not share a name with a texture's own.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230610)
constexpr const char* vtkMTColorCoordinates = "colorTCoord";
#else
constexpr const char* vtkMTColorCoordinates = "tcoord";
#endif

#endif
