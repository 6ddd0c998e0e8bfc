// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewExtractSelection.h"

#include "vtkExtractSelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTReplica.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationRepresentation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

vtkStandardNewMacro(vtkMTParaViewExtractSelection);

namespace
{
bool IsOfValues(vtkSelection* selection)
{
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    if (selection->GetNode(i)->GetContentType() != vtkSelectionNode::VALUES)
    {
      return false;
    }
  }
  return selection->GetNumberOfNodes() > 0;
}
}

//------------------------------------------------------------------------------
vtkMTParaViewExtractSelection::vtkMTParaViewExtractSelection() = default;

//------------------------------------------------------------------------------
vtkMTParaViewExtractSelection::~vtkMTParaViewExtractSelection() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewExtractSelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkMTParaViewExtractSelection::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestData(request, inputVector, outputVector))
  {
    return 0;
  }
  auto* model = vtkMultiTriangulation::SafeDownCast(vtkDataObject::GetData(inputVector[0]));
  vtkSelection* selection = vtkSelection::GetData(inputVector[1]);
  if (!model || !selection || !IsOfValues(selection) || vtkMTReplica::Is(model))
  {
    return 1;
  }
  auto* representation = vtkMultiTriangulationRepresentation::FindShowing(*model);
  vtkPolyData* cut = representation ? representation->GetDrawnMesh() : nullptr;
  if (cut)
  {
    vtkNew<vtkExtractSelection> extract;
    extract->SetInputDataObject(0, cut);
    extract->SetInputDataObject(1, selection);
    extract->Update();
    vtkDataObject::GetData(outputVector)->ShallowCopy(extract->GetOutputDataObject(0));
  }
  return 1;
}
