// SPDX-License-Identifier: BSD-3-Clause
// Which format a mesh file is of. Not installed.
#ifndef vtkMTMeshFormat_h
#define vtkMTMeshFormat_h

#include <string>
#include <string_view>

namespace vtkMTMeshFormat
{
enum FormatType
{
  Unknown,
  Ply,
  Stl,
  Obj,
  Off,
  Xml,    ///< VTK's
  Legacy, ///< VTK's
  Gltf,
  Glb,
  Points ///< a format of points alone
};

/// By what the file begins with, where that is unmistakable, or else by the ending of its name.
FormatType Find(std::string_view begin, const std::string& path);

/// In lower case, without ".gz".
std::string GetEnding(const std::string& path);
}

#endif
