// SPDX-License-Identifier: BSD-3-Clause
// Lists of names as field data of a mesh. Not installed.
#ifndef vtkMTFieldNames_h
#define vtkMTFieldNames_h

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace vtkMTFieldNames
{
/// Nothing when there are no names, or no mesh.
inline void Add(vtkPolyData* mesh, const char* name, const std::vector<std::string>& values)
{
  if (!mesh || values.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> names;
  names->SetName(name);
  for (const std::string& value : values)
  {
    names->InsertNextValue(value);
  }
  mesh->GetFieldData()->AddArray(names);
}
}

#endif
