// SPDX-License-Identifier: BSD-3-Clause
// What the ids of an array are the names of. Not installed.
#ifndef vtkMTIdNames_h
#define vtkMTIdNames_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <array>
#include <string>
#include <vector>

namespace vtkMTIdNames
{
using Color = std::array<double, 3>;

/// A table with the names of ids as annotations, and a colour for each; without colors such as differ. Without values
/// the ids are 0, 1, 2 ...
inline vtkSmartPointer<vtkLookupTable> MakeTable(
  const std::vector<std::string>& names, const std::vector<Color>& colors = {}, const std::vector<double>& values = {})
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  const vtkNew<vtkDoubleArray> ids;
  const vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    ids->InsertNextValue(values.empty() ? static_cast<double>(i) : values[i]);
    labels->InsertNextValue(names[i]);
  }
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(names.size()));
  const double* range = ids->GetRange();
  table->SetRange(range[0], range[1]);
  table->Build();
  for (std::size_t i = 0; i < colors.size() && i < names.size(); ++i)
  {
    table->SetTableValue(static_cast<vtkIdType>(i), colors[i][0], colors[i][1], colors[i][2]);
  }
  table->SetAnnotations(ids, labels); // all at once: one by one the time is quadratic
  return table;
}

inline void Set(vtkDataArray* ids, const std::vector<std::string>& names, const std::vector<Color>& colors = {})
{
  ids->SetLookupTable(MakeTable(names, colors));
}
}

#endif
