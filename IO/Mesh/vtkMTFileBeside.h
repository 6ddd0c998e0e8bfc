// SPDX-License-Identifier: BSD-3-Clause
// Files that a mesh names: textures and libraries of materials. Not installed.
#ifndef vtkMTFileBeside_h
#define vtkMTFileBeside_h

#include <string>

namespace vtkMTFileBeside
{
/**
 * Where the file may be: in the folder of the mesh or below it. Of a name that leads elsewhere (an absolute one, or one
 * with "..") and of one that leads to no file, the last component is looked for beside the mesh; where it is not there
 * either, one that differs in upper and lower case alone. Backslashes part folders too.
 */
std::string FindBeside(const std::string& mesh, std::string name);

bool IsFile(const std::string& path);
}

#endif
