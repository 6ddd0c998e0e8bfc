// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewCutFilter.h"

#include "vtkCamera.h"
#include "vtkDataArraySelection.h"
#include "vtkImplicitFunction.h"
#include "vtkMTReplica.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMTParaViewCutFilter);

//------------------------------------------------------------------------------
vtkMTParaViewCutFilter::vtkMTParaViewCutFilter()
  : ChosenError(VTK_DOUBLE_MAX)
{
}

//------------------------------------------------------------------------------
vtkMTParaViewCutFilter::~vtkMTParaViewCutFilter() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "UseRegion: " << this->UseRegion << "\n";
}

//------------------------------------------------------------------------------
// The superclass compares with what it has, so that calling it again is no change.
void vtkMTParaViewCutFilter::Choose()
{
  switch (this->ChosenMode)
  {
    case BY_TRIANGLES:
      this->Superclass::SetTriangleLimit(this->ChosenLimit);
      break;
    case BY_LEVEL:
      this->Superclass::SetLevel(this->ChosenLevel);
      break;
    case BY_VIEW:
    {
      // All that is in front of the camera, whatever it is looking at.
      const double distance = this->ViewCamera->GetDistance();
      this->ViewCamera->SetClippingRange(1e-6 * distance, 1e6 * distance);
      this->Superclass::SetView(this->ViewCamera, this->ImageSize[0], this->ImageSize[1]);
      break;
    }
    default:
      this->Superclass::SetError(this->ChosenError);
      break;
  }
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetMode(int mode)
{
  this->ChosenMode = std::clamp(mode, static_cast<int>(BY_ERROR), static_cast<int>(BY_VIEW));
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetError(double error)
{
  this->ChosenError = error;
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetTriangleLimit(vtkIdType limit)
{
  this->ChosenLimit = limit;
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetLevel(int level)
{
  this->ChosenLevel = level;
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraPosition(double x, double y, double z)
{
  this->ViewCamera->SetPosition(x, y, z);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraFocalPoint(double x, double y, double z)
{
  this->ViewCamera->SetFocalPoint(x, y, z);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraViewUp(double x, double y, double z)
{
  this->ViewCamera->SetViewUp(x, y, z);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraViewAngle(double degrees)
{
  this->ViewCamera->SetViewAngle(degrees);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraParallelProjection(bool on)
{
  this->ViewCamera->SetParallelProjection(on);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCameraParallelScale(double scale)
{
  this->ViewCamera->SetParallelScale(scale);
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetImageSize(int width, int height)
{
  this->ImageSize[0] = width;
  this->ImageSize[1] = height;
  this->Choose();
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetUseRegion(bool on)
{
  this->UseRegion = on;
  this->Superclass::SetRegion(on ? this->RegionFunction.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetRegionFunction(vtkImplicitFunction* function)
{
  this->RegionFunction = function;
  this->SetUseRegion(this->UseRegion);
}

//------------------------------------------------------------------------------
int vtkMTParaViewCutFilter::GetNumberOfPointArrays()
{
  return this->GetPointArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkMTParaViewCutFilter::GetPointArrayName(int index)
{
  return this->GetPointArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkMTParaViewCutFilter::GetPointArrayStatus(const char* name)
{
  return this->GetPointArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetPointArrayStatus(const char* name, int status)
{
  this->GetPointArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkMTParaViewCutFilter::GetNumberOfCellArrays()
{
  return this->GetCellArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkMTParaViewCutFilter::GetCellArrayName(int index)
{
  return this->GetCellArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkMTParaViewCutFilter::GetCellArrayStatus(const char* name)
{
  return this->GetCellArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkMTParaViewCutFilter::SetCellArrayStatus(const char* name, int status)
{
  this->GetCellArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkMTParaViewCutFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkMTReplica::MakeEmpty(inputVector, outputVector)
    ? 1
    : this->Superclass::RequestData(request, inputVector, outputVector);
}
