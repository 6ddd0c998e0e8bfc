// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMTCutIds.h"
#include "vtkMTCutMesh.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTRendererView.h"
#include "vtkMTSetMacros.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkMultiTriangulation* GetModel(vtkDataObject* input)
{
  vtkMultiTriangulation* model = vtkMultiTriangulation::SafeDownCast(input);
  return model && model->GetSource() && !model->GetSource()->GetKnownGraph().IsEmpty() ? model : nullptr;
}
}

vtkStandardNewMacro(vtkMultiTriangulationMapper);
vtkMTCxxSetClampMacro(vtkMultiTriangulationMapper, PixelError, 0.0, 1e9);
vtkMTCxxSetClampMacro(vtkMultiTriangulationMapper, ValueError, 0.0, 1e300);
vtkMTCxxSetClampMacro(vtkMultiTriangulationMapper, CutTimeLimit, 0.0, 1e9);
vtkMTCxxSetClampMacro(vtkMultiTriangulationMapper, DrawingRate, 0.0, 1e15);

//------------------------------------------------------------------------------
vtkMultiTriangulationMapper::vtkMultiTriangulationMapper()
  : Implementation(std::make_unique<Internals>())
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  this->Implementation->Template->SetPoints(points);
}

//------------------------------------------------------------------------------
vtkMultiTriangulationMapper::~vtkMultiTriangulationMapper()
{
  // The superclass's destructor would release its own resources only.
  this->vtkMultiTriangulationMapper::ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "TriangleLimit: " << this->TriangleLimit << "\n";
  constexpr const char* metrics[] = { "Distance", "EdgeLength", "NormalDeviation", "Value" };
  os << indent << "ErrorMetric: " << metrics[this->ErrorMetric] << "\n";
  os << indent << "ErrorMetricArray: " << this->ErrorMetricArray << "\n";
  os << indent << "ValueError: " << this->ValueError << "\n";
  os << indent << "FrustumCulling: " << this->FrustumCulling << "\n";
  os << indent << "FacingCulling: " << this->FacingCulling << "\n";
  os << indent << "WaitForConvergence: " << this->WaitForConvergence << "\n";
  os << indent << "UploadLimit: " << this->UploadLimit << "\n";
  os << indent << "CutTimeLimit: " << this->CutTimeLimit << "\n";
  os << indent << "Prefetch: " << this->Prefetch << "\n";
  os << indent << "NumberOfLoaderThreads: " << this->NumberOfLoaderThreads << "\n";
  os << indent << "FreezeCut: " << this->FreezeCut << "\n";
  os << indent << "ColorBy: " << this->ColorBy << "\n";
  const double* low = this->ElevationLowPoint;
  const double* high = this->ElevationHighPoint;
  os << indent << "ElevationLowPoint: " << low[0] << ", " << low[1] << ", " << low[2] << "\n";
  os << indent << "ElevationHighPoint: " << high[0] << ", " << high[1] << ", " << high[2] << "\n";
  os << indent << "ElevationRange: " << this->ElevationRange[0] << ", " << this->ElevationRange[1] << "\n";
  os << indent << "PatchMemoryLimit: " << this->PatchMemoryLimit << "\n";
  os << indent << "GraphicsMemoryLimit: " << this->GraphicsMemoryLimit << "\n";
  os << indent << "DrawingRate: " << this->DrawingRate << "\n";
  os << indent << "DrawnShare: " << this->DrawnShare[0] << " of " << this->DrawnShare[1] << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NumberOfCulledPatches: " << this->NumberOfCulledPatches << "\n";
  os << indent << "NumberOfCulledTriangles: " << this->NumberOfCulledTriangles << "\n";
  os << indent << "NumberOfFacingAwayPatches: " << this->NumberOfFacingAwayPatches << "\n";
  os << indent << "NumberOfFacingAwayTriangles: " << this->NumberOfFacingAwayTriangles << "\n";
  os << indent << "Loading: " << this->Loading << "\n";
  os << indent << "NumberOfRefinedNodes: " << this->NumberOfRefinedNodes << "\n";
  os << indent << "AchievedPixelError: " << this->AchievedPixelError << "\n";
  os << indent << "Converged: " << this->Converged << "\n";
  os << indent << "CutTime: " << this->CutTime << "\n";
  os << indent << "FrameTime: " << this->FrameTime << "\n";
  os << indent << "OverheadTime: " << this->OverheadTime << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkMultiTriangulationMapper::SafeDownCast(mapper))
  {
    this->SetPixelError(other->GetPixelError());
    this->SetTriangleLimit(other->GetTriangleLimit());
    this->SetErrorMetric(other->GetErrorMetric());
    this->SetErrorMetricArray(other->GetErrorMetricArray());
    this->SetValueError(other->GetValueError());
    this->SetFrustumCulling(other->GetFrustumCulling());
    this->SetFacingCulling(other->GetFacingCulling());
    this->SetWaitForConvergence(other->GetWaitForConvergence());
    this->SetUploadLimit(other->GetUploadLimit());
    this->SetCutTimeLimit(other->GetCutTimeLimit());
    this->SetPrefetch(other->GetPrefetch());
    this->SetNumberOfLoaderThreads(other->GetNumberOfLoaderThreads());
    this->SetFreezeCut(other->GetFreezeCut());
    this->SetColorBy(other->GetColorBy());
    this->RemoveTextureMappings();
    for (const vtkMTPatchStreams::CellTexture& texture : other->Implementation->CellTextures)
    {
      this->MapTextureToMaterial(texture.Name.c_str(), texture.Material, texture.Part);
    }
    std::copy_n(other->ElevationLowPoint, 3, this->ElevationLowPoint);
    std::copy_n(other->ElevationHighPoint, 3, this->ElevationHighPoint);
    std::copy_n(other->ElevationRange, 2, this->ElevationRange);
    this->SetPatchMemoryLimit(other->GetPatchMemoryLimit());
    this->SetGraphicsMemoryLimit(other->GetGraphicsMemoryLimit());
    this->SetDrawingRate(other->GetDrawingRate());
    this->SetDrawnShare(other->DrawnShare[0], other->DrawnShare[1]);
  }
  if (auto* other = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetPointIdArrayName(other->GetPointIdArrayName());
    this->SetCompositeIdArrayName(other->GetCompositeIdArrayName());
    this->SetProcessIdArrayName(other->GetProcessIdArrayName());
    this->SetCellIdArrayName(other->GetCellIdArrayName());
  }
  // Not the superclass's: in VTK 9.1 it warns of its own use of deprecated methods, and does no more than the above.
  this->vtkPolyDataMapper::ShallowCopy(mapper); // NOLINT(bugprone-parent-virtual-call)
}

//------------------------------------------------------------------------------
// VTK gives a mapper the resources of one window at a time, and takes them when another window draws it. Then, and when
// the superclass releases what it has in whatever window drew last, the patches stay.
void vtkMultiTriangulationMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->Implementation->KeepsPatches = true;
  this->Superclass::RenderPiece(renderer, actor);
  this->Implementation->KeepsPatches = false;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  const bool keepsPatches = this->Implementation->KeepsPatches;
  if (!keepsPatches)
  {
    this->Implementation->Painters.Release(window);
  }
  this->Implementation->CellTextureBuffer->ReleaseGraphicsResources(window);
  this->Implementation->KeepsPatches = true;
  this->Superclass::ReleaseGraphicsResources(window);
  this->Implementation->KeepsPatches = keepsPatches;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::HasPatches()
{
  return GetModel(this->GetInput()) != nullptr;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationMapper::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ComputeBounds()
{
  if (this->HasPatches())
  {
    vtkMultiTriangulation* model = GetModel(this->GetInput());
    vtkMTPlacement placement;
    model->GetFrame(placement.Matrix.data());
    placement.ToObject(this->Implementation->GetBounds(model->GetSource()).data(), this->Bounds);
    return;
  }
  this->Superclass::ComputeBounds();
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetGraphicsMemory()
{
  return static_cast<vtkIdType>(this->Implementation->Painters.GetBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetMostGraphicsMemory()
{
  return static_cast<vtkIdType>(this->Implementation->Painters.GetMostBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetNumberOfUploadedBytes()
{
  return static_cast<vtkIdType>(this->Implementation->Painters.GetNumberOfUploadedBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetPatchMemory()
{
  const vtkMTPatchCache* cache = this->Implementation->Frame.GetCache();
  return cache ? static_cast<vtkIdType>(cache->GetBytes()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetMostPatchMemory()
{
  const vtkMTPatchCache* cache = this->Implementation->Frame.GetCache();
  return cache ? static_cast<vtkIdType>(cache->GetMostUsedBytes()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetNumberOfReads()
{
  const vtkMTPatchCache* cache = this->Implementation->Frame.GetCache();
  return cache ? static_cast<vtkIdType>(cache->GetNumberOfReads()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetNumberOfCuts()
{
  return static_cast<vtkIdType>(this->Implementation->Frame.GetNumberOfCuts());
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetLongestLock()
{
  const vtkMTPatchCache* cache = this->Implementation->Frame.GetCache();
  return cache ? cache->GetLoader().GetLongestLock() : 0.0;
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetCurrentDrawingRate()
{
  const std::shared_ptr<vtkMTWindowClock> clock = this->Implementation->Clock.lock();
  const double measured = clock ? clock->GetRate() : 0.0;
  return this->DrawingRate > 0.0 ? this->DrawingRate : measured;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkMTPatch> vtkMultiTriangulationMapper::GetPatchInMemory(std::uint32_t arc) const
{
  const vtkMTPatchCache* cache = this->Implementation->Frame.GetCache();
  return cache ? cache->Get(arc) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::GetCut(vtkPolyData* output, bool findInputIds)
{
  const vtkMTFrame& frame = this->Implementation->Frame;
  if (!frame.GetLast())
  {
    vtkErrorMacro("Nothing has been drawn yet, so there is no cut.");
    return false;
  }
  std::string error;
  vtkMTCutMesh mesh;
  mesh.Arcs = frame.GetLast()->Cut.GetArcs();
  mesh.Placement = &this->Implementation->Placement;
  if (!mesh.Make(*frame.GetSource(), output, error) ||
    (findInputIds && !vtkMTCutIds::Fill(*frame.GetSource(), mesh.Arcs, mesh.Placement, output, {}, error)))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMultiTriangulationMapper::GetDrawnArcs() const
{
  const vtkMTFrame::Result* last = this->Implementation->Frame.GetLast();
  const bool shares = last && this->Implementation->DrawsShare;
  return shares ? this->Implementation->Share : last ? last->Arcs : std::vector<std::uint32_t>();
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetDistanceToInput() const
{
  return this->Implementation->GetLargest(this->GetDrawnArcs(), &vtkMTGraph::GetDistanceToInput);
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetDistanceFromInput() const
{
  return this->Implementation->GetLargest(this->GetDrawnArcs(), &vtkMTGraph::GetDistanceFromInput);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::FollowInput()
{
  Internals& self = *this->Implementation;
  vtkMultiTriangulation* model = GetModel(this->GetInput());
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  if (model)
  {
    model->GetFrame(self.Placement.Matrix.data());
  }
  vtkMTPatchLoader::Settings loader;
  loader.Threads = this->NumberOfLoaderThreads;
  if (self.Frame.SetSource(source, loader))
  {
    self.Cut = nullptr;
    self.Painters.Clear();
    self.ColorState.Clear();
  }
  if (self.DrewPatches != (source != nullptr))
  {
    self.DrewPatches = source != nullptr;
    this->ForgetBuffers();
  }
}

//------------------------------------------------------------------------------
// The superclass and this class keep different things in the same places.
void vtkMultiTriangulationMapper::ForgetBuffers()
{
  this->VBOBuildState.Clear();
  this->IBOBuildState.Clear();
  this->CellTextureBuildState.Clear();
  for (vtkTextureObject** texture : { &this->CellScalarTexture, &this->CellNormalTexture })
  {
    if (*texture)
    {
      (*texture)->Delete();
      *texture = nullptr;
    }
  }
  for (vtkOpenGLBufferObject** buffer : { &this->CellScalarBuffer, &this->CellNormalBuffer })
  {
    if (*buffer)
    {
      (*buffer)->Delete();
      *buffer = nullptr;
    }
  }
  // This map may have been emptied without forgetting what it was built for; so it is built for something else.
  vtkPolyData* other = this->Implementation->Template;
  vtkCellArray* cells[4] = { other->GetVerts(), other->GetLines(), other->GetPolys(), other->GetStrips() };
  this->CellCellMap->Update(cells, VTK_SURFACE, other->GetPoints());
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Implementation->FrameStart = std::chrono::steady_clock::now();
  this->FollowInput();
  if (this->HasPatches())
  {
    this->CurrentInput = this->Implementation->Template;
  }
  this->Superclass::RenderPieceStart(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateCameraShiftScale(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::UpdateCameraShiftScale(renderer, actor);
  }
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    return this->Superclass::GetNeedToRebuildBufferObjects(renderer, actor);
  }
  this->TempState.Clear();
  this->TempState.Append(actor->GetProperty()->GetMTime(), "property mtime");
  this->TempState.Append(this->GetInput()->GetMTime(), "input mtime");
  this->TempState.Append(actor->GetTexture() ? actor->GetTexture()->GetMTime() : 0, "texture mtime");
  const bool changed = this->VBOBuildState != this->TempState || this->VBOBuildTime < this->GetMTime();
  this->VBOBuildState = this->TempState;
  return changed;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::UpdateBufferObjects(renderer, actor);
    return;
  }
  this->Implementation->Painter = &this->Implementation->Painters.Use(renderer->GetRenderWindow());
  if (this->GetNeedToRebuildBufferObjects(renderer, actor))
  {
    this->BuildBufferObjects(renderer, actor);
  }
  this->UpdateFrame(renderer, actor);
  this->UpdateCellTextures(renderer);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::BuildBufferObjects(renderer, actor);
    return;
  }
  vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  const int representation = actor->GetProperty()->GetRepresentation();
  plan.Edges = representation == VTK_WIREFRAME;
  plan.PrimitivesPerTriangle = representation == VTK_SURFACE ? 1 : 3;
  plan.ShortIndices = this->Implementation->Graph().GetFigures().LargestWedges <= 65536;
  this->WarnOfForeignArrays();
  this->PlanColors();
  this->PlanAttributes(actor);
  this->PlanCellTextures(actor);
  this->UpdateColorRevision();
  this->BuildTemplate(renderer);
  this->VBOBuildTime.Modified();
}
