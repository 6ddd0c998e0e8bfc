// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTWholeRanges.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiTriangulation.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
// A range that the array has found and would give again.
struct RangeKeys
{
  vtkInformationInformationVectorKey* PerComponent;
  vtkInformationDoubleVectorKey* Component;
  vtkInformationDoubleVectorKey* Magnitude;
};

void Widen(double range[2], const double whole[2])
{
  range[0] = std::min(range[0], whole[0]);
  range[1] = std::max(range[1], whole[1]);
}

// The range is asked for first, so that the array has all of the keys and only the values change.
void AnnounceRange(vtkDataArray* array, int component, const double whole[2], bool finite, const RangeKeys& keys)
{
  double range[2];
  if (finite)
  {
    array->GetFiniteRange(range, component);
  }
  else
  {
    array->GetRange(range, component);
  }
  Widen(range, whole);
  vtkInformation* info = array->GetInformation();
  if (component < 0)
  {
    info->Set(keys.Magnitude, range, 2);
  }
  else if (vtkInformationVector* components = info->Get(keys.PerComponent))
  {
    components->GetInformationObject(component)->Set(keys.Component, range, 2);
  }
}

void AnnounceArray(const vtkMultiTriangulation& model, vtkDataArray* array, int association)
{
  const RangeKeys all{ vtkAbstractArray::PER_COMPONENT(), vtkDataArray::COMPONENT_RANGE(),
    vtkDataArray::L2_NORM_RANGE() };
  const RangeKeys finite{ vtkAbstractArray::PER_FINITE_COMPONENT(), vtkDataArray::COMPONENT_RANGE(),
    vtkDataArray::L2_NORM_FINITE_RANGE() };
  for (int component = -1; component < array->GetNumberOfComponents(); ++component)
  {
    double whole[2];
    if (model.GetArrayRange(array->GetName(), association, component, whole))
    {
      AnnounceRange(array, component, whole, false, all);
      AnnounceRange(array, component, whole, true, finite);
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkMTWholeRanges::Announce(vtkMultiTriangulation& model)
{
  vtkDataSetAttributes* attributes[2] = { model.GetPointData(), model.GetCellData() };
  const int associations[2] = { vtkDataObject::POINT, vtkDataObject::CELL };
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int i = 0; i < attributes[kind]->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes[kind]->GetArray(i);
      if (array && array->GetName())
      {
        AnnounceArray(model, array, associations[kind]);
      }
    }
  }
}
