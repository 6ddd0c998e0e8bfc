// SPDX-License-Identifier: BSD-3-Clause
// What is known of the world's frame in which a file's coordinates are. Not installed.
#ifndef vtkMTWorldFrame_h
#define vtkMTWorldFrame_h

#include <string>

struct vtkMTWorldFrame
{
  std::string Crs;   ///< its name ("RAS scanner", "LPS", "EPSG:32610", a PROJ string, WKT); empty where none is given
  std::string Units; ///< of its coordinates ("mm", "m"); empty where none are given
};

#endif
