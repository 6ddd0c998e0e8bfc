// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: what a frame asks for, what it waits for, and how patches get to the GPU.
#include "vtkActor.h"
#include "vtkMTRendererView.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <string>

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulationMapper::GetMostPatchMemory()
{
  return this->Implementation->Cache ? static_cast<vtkIdType>(this->Implementation->Cache->GetMostUsedBytes()) : 0;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkMTPatch> vtkMultiTriangulationMapper::GetPatchInMemory(std::uint32_t arc) const
{
  return this->Implementation->Cache ? this->Implementation->Cache->Get(arc) : nullptr;
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetLongestLock()
{
  return this->Implementation->Cache ? this->Implementation->Cache->GetLoader().GetLongestLock() : 0.0;
}

//------------------------------------------------------------------------------
// The renderer sets the estimate to 0 before the first pass. The passes of a selection must all see one cut, since what
// the first ones write is looked up after the last.
bool vtkMultiTriangulationMapper::IsNewFrame(vtkRenderer* renderer, vtkActor* actor)
{
  return actor->GetEstimatedRenderTime() == 0.0 && !renderer->GetSelector();
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::WaitsFor(vtkRenderer* renderer)
{
  constexpr double still = 0.01; // frames per second; interactors ask for 0.0001
  return this->FreezeCut || this->WaitForConvergence == WAIT_ALWAYS ||
    (this->WaitForConvergence == WAIT_WHEN_STILL && renderer->GetRenderWindow()->GetDesiredUpdateRate() < still);
}

//------------------------------------------------------------------------------
// Lines and points are drawn from whatever side they are seen. A frame that mirrors turns the triangles, and the cones
// that say what faces away are those of the lattice.
bool vtkMultiTriangulationMapper::LeavesOutWhatFacesAway(vtkRenderer* renderer, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return this->FacingCulling && property->GetBackfaceCulling() && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility() && !vtkMTRendererView::IsStereo(renderer) &&
    !this->Implementation->Placement.IsMirrored();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::FillFrame(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Implementation;
  vtkMTRendererCuts::Frame& frame = self.Frame;
  frame.View = vtkMTRendererView::Make(renderer, self.GetModelToWorld(actor).data());
  // A frozen cut that does not fit cannot stay.
  frame.Freeze = this->FreezeCut && self.LessTriangles == 0;
  frame.Advance = this->IsNewFrame(renderer, actor);
  frame.IsUploaded = [&self](std::uint32_t arc)
  {
    const vtkMTPatchArena::Slot* slot = self.Arena.Find(arc);
    return slot && !self.Streams.IsStale(self.Arena, *slot);
  };
  vtkMTCutFollower::Settings& settings = frame.Settings;
  settings.PixelError = this->PixelError;
  settings.TriangleLimit = this->GetTriangleLimitOfFrame(actor);
  // What is left of the limit is for gaps between patches, and for the copies while the arena grows.
  settings.ByteLimit = this->GetGraphicsLimit() / 4 * 3;
  settings.BytesPerVertex = static_cast<std::uint32_t>(self.Arena.GetBytesOf(1, 0));
  settings.BytesPerTriangle = static_cast<std::uint32_t>(self.Arena.GetBytesOf(0, 1));
  settings.ErrorMetric = this->ErrorMetric == EDGE_LENGTH ? vtkMTTargetCut::EdgeLength : vtkMTTargetCut::Distance;
  settings.FrustumCulling = this->FrustumCulling && !vtkMTRendererView::IsStereo(renderer);
  settings.FacingCulling = this->LeavesOutWhatFacesAway(renderer, actor);
  settings.Wait = self.Wait;
  settings.TimeLimit = self.Wait ? 0.0 : this->CutTimeLimit;
  settings.UploadBudget = self.Wait ? 0 : static_cast<std::uint64_t>(this->UploadLimit);
  settings.Prefetch = this->Prefetch && (!self.Wait || renderer->GetRenderWindow()->GetInteractor());
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateCache(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Implementation;
  self.Cache->SetArrays(self.Streams.GetArrays(self.Graph()));
  if (!this->IsNewFrame(renderer, actor))
  {
    return;
  }
  self.Wait = this->WaitsFor(renderer);
  if (self.Cache->GetLimit() != static_cast<std::size_t>(this->PatchMemoryLimit))
  {
    self.Cache->SetLimit(static_cast<std::size_t>(this->PatchMemoryLimit));
    self.Cache->Retry();
  }
  self.Cache->Collect();
  this->ReportFailures();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ReportFailures()
{
  Internals& self = *this->Implementation;
  for (const vtkMTPatchCache::Failure& failure : self.Cache->TakeFailures())
  {
    self.Keeper.MarkUnreadable(failure.Arc);
    const std::string name = self.Keeper.GetSource()->GetName() + ": ";
    vtkErrorMacro(<< (failure.What.compare(0, name.size(), name) == 0 ? "" : name) << failure.What);
  }
}

//------------------------------------------------------------------------------
// The patch of an arc of the cut. Where the frame waits, all that it lacks is loaded at once, as far as memory goes;
// the coarsest patches are always waited for.
std::shared_ptr<const vtkMTPatch> vtkMultiTriangulationMapper::FetchPatch(std::size_t index)
{
  Internals& self = *this->Implementation;
  const vtkMTGraph& graph = self.Graph();
  const std::vector<std::uint32_t>& arcs = self.Cut->Arcs;
  const auto waits = [&](std::uint32_t arc) { return self.Wait || graph.Arcs[arc].From == graph.GetSource(); };
  if (!self.Cache->Has(arcs[index]) && waits(arcs[index]))
  {
    std::vector<std::uint32_t> missing;
    for (std::size_t i = index; i < arcs.size(); ++i)
    {
      const vtkMTPatchArena::Slot* slot = self.Arena.Find(arcs[i]);
      if (waits(arcs[i]) && !self.Cache->Has(arcs[i]) && (!slot || self.Streams.IsStale(self.Arena, *slot)))
      {
        missing.push_back(arcs[i]);
      }
    }
    self.Cache->Request(missing);
  }
  return self.Cache->Get(arcs[index]);
}

//------------------------------------------------------------------------------
// Says to the arena what the frame draws. What of that is on the GPU is used before anything else, so that no room is
// made for one patch of the frame by dropping another.
void vtkMultiTriangulationMapper::BeginUpload()
{
  Internals& self = *this->Implementation;
  const vtkMTGraph& graph = self.Graph();
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  const auto touch = [&]()
  {
    vertices = 0;
    triangles = 0;
    for (const auto* arcs : { &self.Cut->Arcs, &self.Cut->Early })
    {
      for (const std::uint32_t arc : *arcs)
      {
        const vtkMTArc& record = graph.Arcs[arc];
        vertices += record.Wedges;
        triangles += record.Triangles;
        if (self.Arena.Find(arc))
        {
          self.Arena.Use(arc, record.Wedges, record.Triangles);
        }
      }
    }
  };
  touch();
  self.Arena.SetLimit(this->GetGraphicsLimit());
  self.Arena.BeginFrame(vertices, triangles);
  touch();
}

//------------------------------------------------------------------------------
// The patches of the cut leave more gaps in the arena than the limit on bytes allows for. The second time with fewer of
// them; the first time the gaps may have been closed by clearing it.
void vtkMultiTriangulationMapper::DrawLess()
{
  Internals& self = *this->Implementation;
  const std::uint64_t now = std::max<std::uint64_t>(self.Cut->Triangles, 2);
  self.LessTriangles = self.LessTriangles == 0 ? now : now - std::max<std::uint64_t>(now / 8, 1);
}

//------------------------------------------------------------------------------
// Whether all of the cut is on the GPU: the arena may have been cleared while patches were being added to it.
bool vtkMultiTriangulationMapper::IsUploaded()
{
  Internals& self = *this->Implementation;
  return std::all_of(self.Cut->Arcs.begin(), self.Cut->Arcs.end(),
    [&](std::uint32_t arc) { return self.Frame.IsUploaded(arc) || self.Keeper.IsUnreadable(arc); });
}

//------------------------------------------------------------------------------
// Whether nothing has changed since all of the cut was found to be on the GPU. Nothing has been dropped, so what the
// frame draws is still what was used last.
bool vtkMultiTriangulationMapper::IsAllThere()
{
  Internals& self = *this->Implementation;
  const Internals::Uploaded now{ self.Cut, self.Keeper.GetNumberOfSearches(), self.Arena.GetChanges(),
    this->GetGraphicsLimit() };
  return now == self.LastUpload;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::RememberUpload()
{
  Internals& self = *this->Implementation;
  self.LastUpload = Internals::Uploaded();
  if (self.Cut->OnTarget && this->IsUploaded())
  {
    self.LastUpload = { self.Cut, self.Keeper.GetNumberOfSearches(), self.Arena.GetChanges(),
      this->GetGraphicsLimit() };
  }
}

//------------------------------------------------------------------------------
// Takes the patch for one that cannot be had. True when that is news, so that another cut is needed.
bool vtkMultiTriangulationMapper::GiveUp(std::uint32_t arc)
{
  const bool news = this->Implementation->Keeper.MarkUnreadable(arc);
  this->ReportFailures();
  return news;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UploadEarlyPatches()
{
  Internals& self = *this->Implementation;
  for (const std::uint32_t arc : self.Cut->Early)
  {
    const vtkMTArc& record = self.Graph().Arcs[arc];
    vtkMTPatchArena::Slot* slot = self.Arena.Use(arc, record.Wedges, record.Triangles);
    const std::shared_ptr<const vtkMTPatch> patch =
      slot && self.Streams.IsStale(self.Arena, *slot) ? self.Cache->Get(arc) : nullptr;
    if (patch && !this->UploadPatch(arc, *patch))
    {
      self.Arena.Drop(arc);
    }
  }
}
