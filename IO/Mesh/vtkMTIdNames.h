// SPDX-License-Identifier: BSD-3-Clause
// What the ids of an array are the names of. Not installed.
#ifndef vtkMTIdNames_h
#define vtkMTIdNames_h

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkVariant.h"

#include <string>
#include <vector>

namespace vtkMTIdNames
{
/// Names of the ids 0, 1, 2 ..., as annotations of the array's lookup table, which has a colour for each.
inline void Set(vtkDataArray* ids, const std::vector<std::string>& names)
{
  const vtkNew<vtkLookupTable> table;
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(names.size()));
  table->SetRange(0.0, static_cast<double>(names.size()) - 1.0);
  table->Build();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    table->SetAnnotation(vtkVariant(static_cast<double>(i)), names[i]);
  }
  ids->SetLookupTable(table);
}
}

#endif
