// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: what a frame asks for, and what became of it.
#include "vtkMTDrawableScale.h"
#include "vtkMTRendererView.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// The renderer sets the estimate to 0 before the first pass.
bool IsFirstPass(vtkActor* actor)
{
  return actor->GetEstimatedRenderTime() == 0.0;
}

// Lines and points are drawn from whatever side they are seen.
bool ShowsOneSideOnly(vtkProperty* property)
{
  return property->GetBackfaceCulling() && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility();
}

// Of two limits of which 0 is none.
std::uint64_t GetLower(std::uint64_t a, std::uint64_t b)
{
  return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}
}

//------------------------------------------------------------------------------
// By a margin that is larger than what the shader's single precision makes of places near a plane.
bool vtkMultiTriangulationMapper::Internals::IsClippedAway(const vtkMTBox& box) const
{
  constexpr double margin = 1e-5;
  const auto misses = [&box](const std::array<double, 4>& plane)
  {
    double highest = plane[3];
    double size = std::abs(plane[3]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double low = plane[k] * box[2 * k];
      const double high = plane[k] * box[2 * k + 1];
      highest += std::max(low, high);
      size += std::max(std::abs(low), std::abs(high));
    }
    return highest < -margin * size;
  };
  return std::any_of(this->Planes.begin(), this->Planes.end(), misses);
}

//------------------------------------------------------------------------------
// A patch is in the share that the middle of its triangles lies in, when those of all patches are put in a row.
void vtkMultiTriangulationMapper::Internals::TakeShare(const int share[2])
{
  this->DrawsShare = share[0] != 0 || share[1] != 1 || !this->Planes.empty();
  this->Share.clear();
  this->ShareTriangles = 0;
  const std::uint64_t all = std::max<std::uint64_t>(this->Cut->Triangles, 1);
  const auto count = static_cast<std::uint64_t>(share[1]);
  std::uint64_t before = 0;
  for (std::size_t i = 0; this->DrawsShare && i < this->Cut->Arcs.size(); ++i)
  {
    const vtkMTArc& arc = this->Graph().Arcs[this->Cut->Arcs[i]];
    const std::uint64_t triangles = arc.Triangles;
    const std::uint64_t own = std::min((2 * before + triangles) * count / (2 * all), count - 1);
    before += triangles;
    if (own == static_cast<std::uint64_t>(share[0]) && !this->IsClippedAway(arc.Box))
    {
      this->Share.push_back(this->Cut->Arcs[i]);
      this->ShareTriangles += triangles;
    }
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::SetDrawnShare(int share, int count)
{
  const int shares = std::max(count, 1);
  const int clamped = std::clamp(share, 0, shares);
  if (clamped != this->DrawnShare[0] || shares != this->DrawnShare[1])
  {
    this->DrawnShare[0] = clamped;
    this->DrawnShare[1] = shares;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::WaitsFor(vtkRenderer* renderer)
{
  constexpr double still = 0.01; // frames per second; interactors ask for 0.0001
  return this->FreezeCut || this->WaitForConvergence == WAIT_ALWAYS ||
    (this->WaitForConvergence == WAIT_WHEN_STILL && renderer->GetRenderWindow()->GetDesiredUpdateRate() < still);
}

//------------------------------------------------------------------------------
// 0 is no limit, and so is more than there are, lest a limit that flickers ask for a new cut.
std::uint64_t vtkMultiTriangulationMapper::GetTrianglesInTime(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Implementation;
  const std::shared_ptr<vtkMTWindowClock>& clock = self.Painters.GetClock(renderer->GetRenderWindow());
  self.Clock = clock;
  vtkMTFrameClock& frame = clock->UseInFrame();
  if (renderer->GetSelector())
  {
    frame.Discard();
  }
  const double seconds = actor->GetAllocatedRenderTime();
  const double wanted = clock->GetWanted();
  const auto measured = static_cast<double>(frame.Allow(seconds / wanted, wanted));
  const double triangles = this->DrawingRate > 0.0 ? std::max(this->DrawingRate * seconds, 1.0) : measured;
  return triangles < static_cast<double>(self.Frame.GetNumberOfFinestTriangles())
    ? static_cast<std::uint64_t>(triangles)
    : 0;
}

//------------------------------------------------------------------------------
// The passes of a selection must all see one cut, since what the first ones write is looked up after the last: none of
// them begins a frame.
void vtkMultiTriangulationMapper::UpdateFrame(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Implementation;
  self.Painter->Apply(self.Graph(), self.Plan, actor,
    [this](int array, const vtkMTPatch& patch, std::vector<unsigned char>& bytes)
    { this->MapPatchScalars(array, patch, bytes); });

  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkMTFrame::Settings settings;
  settings.Cut.PixelError = this->PixelError;
  settings.Cut.TriangleLimit =
    GetLower(static_cast<std::uint64_t>(this->TriangleLimit), this->GetTrianglesInTime(renderer, actor));
  settings.Cut.ErrorMetric = static_cast<vtkMTTargetCut::ErrorMetricType>(this->ErrorMetric);
  settings.Cut.ValueArray = this->ErrorMetricArray;
  settings.Cut.ValueError = this->ValueError;
  settings.Cut.FrustumCulling = this->FrustumCulling;
  // A frame that mirrors turns the triangles, and the cones that say what faces away are those of the lattice.
  settings.Cut.FacingCulling =
    this->FacingCulling && ShowsOneSideOnly(actor->GetProperty()) && !self.Placement.IsMirrored();
  settings.Cut.Wait = this->WaitsFor(renderer);
  settings.Cut.TimeLimit = this->CutTimeLimit;
  settings.Cut.UploadBudget = static_cast<std::uint64_t>(this->UploadLimit);
  settings.Cut.Prefetch = this->Prefetch;
  settings.MoreFrames = window->GetInteractor() != nullptr;
  settings.Freeze = this->FreezeCut;
  settings.Advance = IsFirstPass(actor) && !renderer->GetSelector();
  settings.PatchMemoryLimit = static_cast<std::size_t>(this->PatchMemoryLimit);
  settings.GraphicsMemoryLimit = self.Painters.Share(window, static_cast<std::uint64_t>(this->GraphicsMemoryLimit));

  const std::array<double, 16> modelToWorld = self.GetModelToWorld(actor);
  self.Views = vtkMTRendererView::Make(renderer, modelToWorld);
  self.Cut = &self.Frame.Update(self.GetKey(renderer, actor), self.Views, settings, *self.Painter);
  const std::array<double, 6>& bounds = self.GetBounds(self.Frame.GetSource());
  self.Origin = self.Graph().Lattice.Snap(vtkMTRendererView::GetNearest(renderer, modelToWorld, bounds).data());
  this->TakeClippingPlanes(actor);
  self.TakeShare(this->DrawnShare);
  this->TakeFigures();
  if (settings.Advance)
  {
    const std::shared_ptr<vtkMTWindowClock>& clock = self.Painters.GetClock(window);
    clock->UseInFrame().Draw(
      actor->GetAllocatedRenderTime() / clock->GetWanted(), self.Cut->Triangles, !self.Cut->Converged);
  }
  for (const std::string& failure : self.Frame.TakeFailures())
  {
    vtkErrorMacro(<< failure);
  }
  const std::string problem = vtkMTDrawableScale::FindProblem(actor->GetBounds());
  if (problem != self.ScaleProblem && !problem.empty())
  {
    vtkErrorMacro("The model cannot be drawn: " << problem << ".");
  }
  self.ScaleProblem = problem;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::TakeFigures()
{
  const Internals& self = *this->Implementation;
  this->NumberOfTriangles = static_cast<vtkIdType>(self.DrawsShare ? self.ShareTriangles : self.Cut->Triangles);
  this->NumberOfPatches = static_cast<vtkIdType>(self.GetDrawnArcs().size());
  this->NumberOfCulledPatches = static_cast<vtkIdType>(self.Cut->ArcsCulled);
  this->NumberOfCulledTriangles = static_cast<vtkIdType>(self.Cut->TrianglesCulled);
  this->NumberOfFacingAwayPatches = static_cast<vtkIdType>(self.Cut->ArcsFacingAway);
  this->NumberOfFacingAwayTriangles = static_cast<vtkIdType>(self.Cut->TrianglesFacingAway);
  this->NumberOfRefinedNodes = static_cast<vtkIdType>(self.Cut->NodesRefined);
  this->Loading = !self.Cut->OnTarget;
  this->AchievedPixelError = self.Cut->PixelError;
  this->Converged = self.Cut->Converged;
  this->CutTime = self.Frame.GetCutTime();
}
