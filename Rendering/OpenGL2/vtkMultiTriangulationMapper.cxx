// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
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
  return model && model->GetSource() && !model->GetSource()->GetGraph().IsEmpty() ? model : nullptr;
}
}

vtkStandardNewMacro(vtkMultiTriangulationMapper);
vtkMTCxxSetClampMacro(vtkMultiTriangulationMapper, PixelError, 0.0, 1e9);
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
  os << indent << "ErrorMetric: " << (this->ErrorMetric == DISTANCE ? "Distance" : "EdgeLength") << "\n";
  os << indent << "FrustumCulling: " << this->FrustumCulling << "\n";
  os << indent << "FacingCulling: " << this->FacingCulling << "\n";
  os << indent << "WaitForConvergence: " << this->WaitForConvergence << "\n";
  os << indent << "UploadLimit: " << this->UploadLimit << "\n";
  os << indent << "CutTimeLimit: " << this->CutTimeLimit << "\n";
  os << indent << "Prefetch: " << this->Prefetch << "\n";
  os << indent << "NumberOfLoaderThreads: " << this->NumberOfLoaderThreads << "\n";
  os << indent << "FreezeCut: " << this->FreezeCut << "\n";
  os << indent << "ColorBy: " << this->ColorBy << "\n";
  os << indent << "PatchMemoryLimit: " << this->PatchMemoryLimit << "\n";
  os << indent << "GraphicsMemoryLimit: " << this->GraphicsMemoryLimit << "\n";
  os << indent << "DrawingRate: " << this->DrawingRate << "\n";
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
    this->SetFrustumCulling(other->GetFrustumCulling());
    this->SetFacingCulling(other->GetFacingCulling());
    this->SetWaitForConvergence(other->GetWaitForConvergence());
    this->SetUploadLimit(other->GetUploadLimit());
    this->SetCutTimeLimit(other->GetCutTimeLimit());
    this->SetPrefetch(other->GetPrefetch());
    this->SetNumberOfLoaderThreads(other->GetNumberOfLoaderThreads());
    this->SetFreezeCut(other->GetFreezeCut());
    this->SetColorBy(other->GetColorBy());
    this->SetPatchMemoryLimit(other->GetPatchMemoryLimit());
    this->SetGraphicsMemoryLimit(other->GetGraphicsMemoryLimit());
    this->SetDrawingRate(other->GetDrawingRate());
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
void vtkMultiTriangulationMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // The superclass calls this method again with the window's context current, if it is not.
  auto* renderWindow = vtkRenderWindow::SafeDownCast(window);
  if (renderWindow && renderWindow->IsCurrent())
  {
    this->Implementation->Arena.ReleaseGraphicsResources();
    this->Implementation->Timer.ReleaseGraphicsResources();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::HasPatches()
{
  return GetModel(this->GetInput()) != nullptr;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ComputeBounds()
{
  if (this->HasPatches())
  {
    const std::array<double, 6>& bounds = this->GetModelBounds();
    std::copy(bounds.begin(), bounds.end(), this->Bounds);
    return;
  }
  this->Superclass::ComputeBounds();
}

//------------------------------------------------------------------------------
// Asked several times a frame, and to be found from all arcs.
const std::array<double, 6>& vtkMultiTriangulationMapper::GetModelBounds()
{
  Internals& self = *this->Implementation;
  const std::shared_ptr<const vtkMTPatchSource> source = GetModel(this->GetInput())->GetSource();
  if (self.BoundsSource.lock() != source)
  {
    self.BoundsSource = source;
    source->GetGraph().GetBounds(self.Bounds.data());
  }
  return self.Bounds;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::HasTranslucentPolygonalGeometry()
{
  return !(this->ColorBy != NONE && this->HasPatches()) && this->Superclass::HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetGraphicsMemory()
{
  return static_cast<vtkIdType>(this->Implementation->Arena.GetBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetMostGraphicsMemory()
{
  return static_cast<vtkIdType>(this->Implementation->Arena.GetMostBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetPatchMemory()
{
  return this->Implementation->Cache ? static_cast<vtkIdType>(this->Implementation->Cache->GetBytes()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetNumberOfReads()
{
  return this->Implementation->Cache ? static_cast<vtkIdType>(this->Implementation->Cache->GetNumberOfReads()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetNumberOfUploadedBytes()
{
  return static_cast<vtkIdType>(this->Implementation->Arena.GetNumberOfUploadedBytes());
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::GetCut(vtkPolyData* output)
{
  const vtkMTTargetCut::Result* last = this->Implementation->Keeper.GetLast();
  if (!last)
  {
    vtkErrorMacro("Nothing has been drawn yet, so there is no cut.");
    return false;
  }
  std::string error;
  if (!vtkMultiTriangulation::CutToPolyData(*this->Implementation->Keeper.GetSource(), last->Cut, output, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMultiTriangulationMapper::GetDrawnArcs() const
{
  const vtkMTTargetCut::Result* last = this->Implementation->Keeper.GetLast();
  return last ? last->Arcs : std::vector<std::uint32_t>();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::FollowInput()
{
  Internals& self = *this->Implementation;
  vtkMultiTriangulation* model = GetModel(this->GetInput());
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  if (self.Keeper.SetSource(source))
  {
    self.Cut = nullptr;
    self.Arena.Clear();
    self.Triangles = 0;
    for (std::size_t i = 0; source && i < source->GetGraph().Arcs.size(); ++i)
    {
      self.Triangles += source->GetGraph().Arcs[i].Triangles;
    }
    self.ColorState.Clear();
    vtkMTPatchLoader::Settings loader;
    loader.Threads = this->NumberOfLoaderThreads;
    self.Cache = source ? std::make_unique<vtkMTPatchCache>(source, vtkMTPatchCache::DefaultLimit, loader) : nullptr;
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
  if (this->GetNeedToRebuildBufferObjects(renderer, actor))
  {
    this->BuildBufferObjects(renderer, actor);
  }
  this->MeasureRate(actor);
  this->Implementation->Streams.Apply(this->Implementation->Plan, this->Implementation->Arena);
  this->Implementation->LessTriangles = 0;
  this->UpdateCache(renderer, actor);
  do
  {
    this->UpdateCut(renderer, actor);
  } while (!this->UpdatePatches());
  this->Implementation->Keeper.Post(*this->Implementation->Cache);
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
  const std::vector<vtkMTArc>& arcs = this->Implementation->Graph().Arcs;
  plan.ShortIndices = std::all_of(arcs.begin(), arcs.end(), [](const vtkMTArc& arc) { return arc.Wedges <= 65536; });
  this->PlanColors();
  this->PlanAttributes(actor);
  this->UpdateColorRevision();
  this->BuildTemplate(renderer);
  this->VBOBuildTime.Modified();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateCut(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Implementation;
  this->FillFrame(renderer, actor);
  self.View = self.Frame.View;
  const vtkMTTargetCut::Result* before = self.Keeper.GetLast();
  self.Cut = &self.Keeper.Update(renderer, self.Frame, *self.Cache);
  this->NumberOfCuts += self.Cut != before;
  this->UpdateOrigin(renderer, actor);

  this->NumberOfTriangles = static_cast<vtkIdType>(self.Cut->Triangles);
  this->NumberOfPatches = static_cast<vtkIdType>(self.Cut->Arcs.size());
  this->NumberOfCulledPatches = static_cast<vtkIdType>(self.Cut->ArcsCulled);
  this->NumberOfCulledTriangles = static_cast<vtkIdType>(self.Cut->TrianglesCulled);
  this->NumberOfFacingAwayPatches = static_cast<vtkIdType>(self.Cut->ArcsFacingAway);
  this->NumberOfFacingAwayTriangles = static_cast<vtkIdType>(self.Cut->TrianglesFacingAway);
  this->NumberOfRefinedNodes = static_cast<vtkIdType>(self.Cut->NodesRefined);
  this->Loading = !self.Cut->OnTarget;
  this->AchievedPixelError = self.Cut->PixelError;
  this->Converged = self.Cut->Converged;
  this->CutTime = self.Keeper.GetCutTime();
}

//------------------------------------------------------------------------------
// The lattice point inside the model's box that is nearest to what the camera looks at most closely: numbers near it
// are small.
void vtkMultiTriangulationMapper::UpdateOrigin(vtkRenderer* renderer, vtkActor* actor)
{
  const vtkMTGraph& graph = this->Implementation->Graph();
  vtkCamera* camera = renderer->GetActiveCamera();
  double place[4] = { 0.0, 0.0, 0.0, 1.0 };
  camera->GetParallelProjection() ? camera->GetFocalPoint(place) : camera->GetPosition(place);
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(actor->GetMatrix(), inverse);
  inverse->MultiplyPoint(place, place);
  const std::array<double, 6>& bounds = this->GetModelBounds();
  for (int i = 0; i < 3; ++i)
  {
    const bool finite = std::isfinite(place[i]);
    place[i] = std::clamp(finite ? place[i] : bounds[2 * i], bounds[2 * i], bounds[2 * i + 1]);
  }
  this->Implementation->Origin = graph.Lattice.Snap(place);
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::UpdatePatches()
{
  Internals& self = *this->Implementation;
  const vtkMTGraph& graph = self.Graph();
  if (this->IsAllThere())
  {
    return true;
  }
  this->BeginUpload();
  bool complete = true;
  for (std::size_t i = 0; i < self.Cut->Arcs.size(); ++i)
  {
    const std::uint32_t arc = self.Cut->Arcs[i];
    const vtkMTArc& record = graph.Arcs[arc];
    vtkMTPatchArena::Slot* slot = self.Arena.Use(arc, record.Wedges, record.Triangles);
    if (!slot && self.Cut->NodesRefined > 0)
    {
      this->DrawLess();
      return false;
    }
    if (!slot || !self.Streams.IsStale(self.Arena, *slot))
    {
      continue;
    }
    const std::shared_ptr<const vtkMTPatch> patch = this->FetchPatch(i);
    if (!patch && !self.Cache->IsFailed(arc) && !self.Wait && record.From != graph.GetSource())
    {
      // It was there when the cut was found: the arena has dropped it since, or more of it is wanted now.
      self.Arena.Drop(arc);
      self.Keeper.Invalidate();
      return false;
    }
    if (!patch || !this->UploadPatch(arc, *patch))
    {
      self.Arena.Drop(arc);
      complete = !this->GiveUp(arc) && complete;
    }
  }
  this->UploadEarlyPatches();
  if (complete && self.Cut->NodesRefined > 0 && !this->IsUploaded())
  {
    this->DrawLess();
    return false;
  }
  this->RememberUpload();
  return complete;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::UploadPatch(std::uint32_t arc, const vtkMTPatch& patch)
{
  Internals& self = *this->Implementation;
  const vtkMTArc& record = self.Graph().Arcs[arc];
  vtkMTPatchArena::Slot* slot = self.Arena.Use(arc, record.Wedges, record.Triangles);
  return slot &&
    self.Streams.Upload(self.Arena, *slot, self.Graph(), patch,
      [this](int array, const vtkMTPatch& each, std::vector<unsigned char>& bytes)
      { this->MapPatchScalars(array, each, bytes); });
}
