// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTReplica.h"

#include "vtkCellData.h"
#include "vtkInformationVector.h"
#include "vtkMultiTriangulation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

//------------------------------------------------------------------------------
bool vtkMTReplica::Is(vtkDataObject* object)
{
  auto* model = vtkMultiTriangulation::SafeDownCast(object);
  return model && model->GetSource() && model->GetNumberOfPoints() == 0 && model->GetNumberOfPatches() > 0;
}

//------------------------------------------------------------------------------
bool vtkMTReplica::MakeEmpty(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!output || !vtkMTReplica::Is(input))
  {
    return false;
  }
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  output->SetPoints(points);
  output->GetPointData()->CopyAllocate(input->GetPointData());
  output->GetCellData()->CopyAllocate(input->GetCellData());
  return true;
}
