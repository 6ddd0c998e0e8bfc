// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of VTK about JSON. Not installed. The headers of data arrays from VTK 9.4's
// beginnings (ParaView 5.13) bring along VTK's own copy of the library and make its namespace's name a macro: one
// program cannot include the system's copy beside it.
#ifndef vtkMTJson_h
#define vtkMTJson_h

#include "vtkVersion.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617)
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#endif
