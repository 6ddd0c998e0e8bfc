// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArraySelection.h"

#include "vtkDataArraySelection.h"

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkMTArraySelection::Choose(
  const std::vector<vtkMTArrayInfo>& arrays, vtkDataArraySelection* points, vtkDataArraySelection* cells)
{
  std::vector<unsigned char> chosen;
  for (const vtkMTArrayInfo& array : arrays)
  {
    if (array.Role == vtkMTArrayInfo::ExactPoints)
    {
      chosen.push_back(1);
      continue;
    }
    vtkDataArraySelection* selection = array.Association == vtkMTArrayInfo::Point ? points : cells;
    if (!selection->ArrayExists(array.Name.c_str()))
    {
      selection->AddArray(array.Name.c_str()); // which does not modify it
    }
    chosen.push_back(selection->ArrayIsEnabled(array.Name.c_str()) ? 1 : 0);
  }
  return chosen;
}
