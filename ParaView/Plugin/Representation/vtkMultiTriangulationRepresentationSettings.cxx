// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationRepresentation: settings and figures of its mapper.
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationRepresentation.h"

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetPixelError(double pixels)
{
  this->PixelError = pixels;
  this->GetMultiTriangulationMapper()->SetPixelError(pixels);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetWaitForConvergence(int wait)
{
  this->WaitForConvergence = wait;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetDrawingRate(double trianglesPerSecond)
{
  this->DrawingRate = trianglesPerSecond;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetErrorMetric(int metric)
{
  this->GetMultiTriangulationMapper()->SetErrorMetric(metric);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetErrorMetricArray(const char* name)
{
  this->GetMultiTriangulationMapper()->SetErrorMetricArray(name);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetValueError(double deviation)
{
  this->GetMultiTriangulationMapper()->SetValueError(deviation);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetTriangleLimit(vtkIdType triangles)
{
  this->GetMultiTriangulationMapper()->SetTriangleLimit(triangles);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetUploadLimit(vtkIdType bytes)
{
  this->GetMultiTriangulationMapper()->SetUploadLimit(bytes);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetCutTimeLimit(double seconds)
{
  this->GetMultiTriangulationMapper()->SetCutTimeLimit(seconds);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetPrefetch(bool on)
{
  this->GetMultiTriangulationMapper()->SetPrefetch(on);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetNumberOfLoaderThreads(int threads)
{
  this->GetMultiTriangulationMapper()->SetNumberOfLoaderThreads(threads);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetFrustumCulling(bool on)
{
  this->GetMultiTriangulationMapper()->SetFrustumCulling(on);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetFacingCulling(bool on)
{
  this->GetMultiTriangulationMapper()->SetFacingCulling(on);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetFreezeCut(bool on)
{
  this->GetMultiTriangulationMapper()->SetFreezeCut(on);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetCutColoring(int colors)
{
  this->GetMultiTriangulationMapper()->SetColorBy(colors);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetPatchMemoryLimit(vtkIdType bytes)
{
  this->GetMultiTriangulationMapper()->SetPatchMemoryLimit(bytes);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetGraphicsMemoryLimit(vtkIdType bytes)
{
  this->GetMultiTriangulationMapper()->SetGraphicsMemoryLimit(bytes);
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationRepresentation::GetNumberOfTriangles()
{
  return this->GetMultiTriangulationMapper()->GetNumberOfTriangles();
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationRepresentation::GetNumberOfPatches()
{
  return this->GetMultiTriangulationMapper()->GetNumberOfPatches();
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationRepresentation::GetAchievedPixelError()
{
  return this->GetMultiTriangulationMapper()->GetAchievedPixelError();
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationRepresentation::GetConverged()
{
  return this->GetMultiTriangulationMapper()->GetConverged() ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationRepresentation::GetLoading()
{
  return this->GetMultiTriangulationMapper()->GetLoading() ? 1 : 0;
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationRepresentation::GetFrameTime()
{
  return this->GetMultiTriangulationMapper()->GetFrameTime();
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationRepresentation::GetGraphicsMemory()
{
  return this->GetMultiTriangulationMapper()->GetGraphicsMemory();
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationRepresentation::GetPatchMemory()
{
  return this->GetMultiTriangulationMapper()->GetPatchMemory();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetClip(bool on)
{
  this->Clips = on;
  this->SetPlanes();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetClipOrigin(double x, double y, double z)
{
  this->ClippingPlane->SetOrigin(x, y, z);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetClipNormal(double x, double y, double z)
{
  this->ClippingPlane->SetNormal(x, y, z);
}
