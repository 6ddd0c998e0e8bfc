// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDisplay.h"

#include "vtkRenderWindow.h"

#include <cstdlib>

#include <dlfcn.h>

std::string vtkMTDisplay::FindProblem(vtkRenderWindow* window)
{
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return ""; // VTK was built for something else than X
  }
  const char* name = std::getenv("DISPLAY");
  bool isThere = name && *name;
  // libX11 is loaded with VTK; it is asked by name, so that nothing of X is needed for building.
  if (void* library = isThere ? dlopen("libX11.so.6", RTLD_LAZY) : nullptr)
  {
    const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
    const auto close = reinterpret_cast<int (*)(void*)>(dlsym(library, "XCloseDisplay"));
    if (void* display = open && close ? open(name) : nullptr)
    {
      close(display);
    }
    else
    {
      isThere = false;
    }
  }
  return isThere ? "" : "no display: DISPLAY is '" + std::string(name ? name : "") + "' and cannot be opened";
}
