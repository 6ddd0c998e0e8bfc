// SPDX-License-Identifier: BSD-3-Clause
// The materials of Wavefront OBJ, from the libraries beside the mesh. Not installed.
#ifndef vtkMTObjMaterials_h
#define vtkMTObjMaterials_h

#include "vtkMTIdNames.h"

#include <map>
#include <string>
#include <vector>

class vtkMTByteSource;

class vtkMTObjMaterials
{
public:
  struct Material
  {
    bool HasColor = false;
    vtkMTIdNames::Color Color = { 0.8, 0.8, 0.8 }; ///< Kd, in 0 ... 1; without one the gray that renderers take
    std::string Image;                             ///< map_Kd
  };

  /// mesh: the path of the file that names the libraries. A name that does not lead to a file is taken for several,
  /// with blanks between them. Of materials of one name the first holds. problems: libraries that cannot be read.
  static std::map<std::string, Material> Read(
    const std::string& mesh, const std::vector<std::string>& libraries, std::vector<std::string>& problems);

  /// Names these ids of materials, in their colours where some have one.
  static void SetTable(
    vtkDataArray* ids, const std::vector<std::string>& names, const std::map<std::string, Material>& materials);
};

#endif
