// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMMultiTriangulationRepresentationProxy.h"

#include "vtkMTFigureInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIdTypeVectorProperty.h"
#include "vtkSMIntVectorProperty.h"

vtkStandardNewMacro(vtkSMMultiTriangulationRepresentationProxy);

namespace
{
template <class Vector, class Value>
void Inform(vtkSMProxy* proxy, const char* name, Value value)
{
  if (auto* property = Vector::SafeDownCast(proxy->GetProperty(name)))
  {
    property->SetElements(&value, 1);
  }
}
}

//------------------------------------------------------------------------------
vtkSMMultiTriangulationRepresentationProxy::vtkSMMultiTriangulationRepresentationProxy() = default;

//------------------------------------------------------------------------------
vtkSMMultiTriangulationRepresentationProxy::~vtkSMMultiTriangulationRepresentationProxy() = default;

//------------------------------------------------------------------------------
void vtkSMMultiTriangulationRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkSMMultiTriangulationRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->Superclass::UpdatePropertyInformationInternal(property);
  if ((property && !property->GetInformationOnly()) || !this->ObjectsCreated)
  {
    return;
  }
  vtkNew<vtkMTFigureInformation> all;
  this->GatherInformation(all); // false with a server, where it was gathered, too
  Inform<vtkSMIdTypeVectorProperty>(this, "NumberOfTriangles", static_cast<vtkIdType>(all->GetNumberOfTriangles()));
  Inform<vtkSMIdTypeVectorProperty>(this, "LargestShare", static_cast<vtkIdType>(all->GetLargestShare()));
  Inform<vtkSMIdTypeVectorProperty>(this, "NumberOfPatches", static_cast<vtkIdType>(all->GetNumberOfPatches()));
  Inform<vtkSMDoubleVectorProperty>(this, "AchievedPixelError", all->GetAchievedPixelError());
  Inform<vtkSMIntVectorProperty>(this, "Converged", all->GetConverged());
  Inform<vtkSMIntVectorProperty>(this, "Loading", all->GetLoading());
  Inform<vtkSMDoubleVectorProperty>(this, "FrameTime", all->GetFrameTime());
  Inform<vtkSMIdTypeVectorProperty>(this, "GraphicsMemory", static_cast<vtkIdType>(all->GetGraphicsMemory()));
  Inform<vtkSMIdTypeVectorProperty>(this, "PatchMemory", static_cast<vtkIdType>(all->GetPatchMemory()));
}
