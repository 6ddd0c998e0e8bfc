// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererCuts.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace
{
// Clocks are not compared: they do not change what is asked for. Nor are bytes, see FitsAsWell.
bool IsSame(const vtkMTCutFollower::Settings& a, const vtkMTCutFollower::Settings& b)
{
  return a.PixelError == b.PixelError && a.TriangleLimit == b.TriangleLimit && a.TimeLimit == b.TimeLimit &&
    a.ErrorMetric == b.ErrorMetric && a.ValueArray == b.ValueArray && a.ValueError == b.ValueError &&
    a.FrustumCulling == b.FrustumCulling && a.FacingCulling == b.FacingCulling && a.UploadBudget == b.UploadBudget &&
    a.Prefetch == b.Prefetch && a.Wait == b.Wait;
}

bool IsSame(const vtkMTView& a, const vtkMTView& b)
{
  return a.ModelToEye == b.ModelToEye && a.Stretch == b.Stretch && a.ParallelProjection == b.ParallelProjection &&
    a.PixelsPerUnit == b.PixelsPerUnit && a.HalfSize == b.HalfSize && a.Near == b.Near && a.Far == b.Far;
}

bool IsSame(const std::vector<vtkMTView>& a, const std::vector<vtkMTView>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const vtkMTView& one, const vtkMTView& other) { return IsSame(one, other); });
}

// Whether a cut is also what other sizes of vertices and triangles, or another budget of bytes, ask for.
bool FitsAsWell(const vtkMTGraph& graph, const vtkMTCutFollower::Result& result,
  const vtkMTCutFollower::Settings& before, const vtkMTCutFollower::Settings& now)
{
  if (before.ByteLimit == now.ByteLimit && before.BytesPerVertex == now.BytesPerVertex &&
    before.BytesPerTriangle == now.BytesPerTriangle)
  {
    return true;
  }
  std::uint64_t bytes = 0;
  for (const std::uint32_t arc : result.Arcs)
  {
    bytes += std::uint64_t(graph.Arcs[arc].Wedges) * now.BytesPerVertex +
      std::uint64_t(graph.Arcs[arc].Triangles) * now.BytesPerTriangle;
  }
  return result.Converged && (now.ByteLimit == 0 || bytes <= now.ByteLimit);
}
}

bool vtkMTRendererCuts::SetSource(const std::shared_ptr<const vtkMTPatchSource>& source)
{
  if (source == this->Source)
  {
    return false;
  }
  this->Source = source;
  this->All.clear();
  this->Last.reset();
  this->Resident.assign(source ? source->GetKnownGraph().Arcs.size() : 0, 1);
  this->ReadableRevision = 0;
  return true;
}

vtkMTRendererCuts::ResultPointer vtkMTRendererCuts::Update(
  Key renderer, const Frame& frame, const vtkMTPatchCache& cache)
{
  Kept& kept = this->All[renderer];
  // A patch that turns out unreadable would leave a hole in a frozen cut.
  const bool keepCut = frame.Freeze && kept.Result && kept.Readable == this->ReadableRevision;
  const bool same = kept.Result && kept.Frozen == keepCut && kept.Readable == this->ReadableRevision &&
    IsSame(kept.Settings, frame.Settings) && IsSame(kept.Views, frame.Views) &&
    FitsAsWell(this->Source->GetKnownGraph(), *kept.Result, kept.Settings, frame.Settings);
  const bool settled = kept.Frozen || (kept.Result && kept.Result->OnTarget);
  if (!same || (frame.Advance && !settled))
  {
    this->Compute(kept, frame, keepCut, cache);
  }
  this->Last = kept.Result;
  return kept.Result;
}

void vtkMTRendererCuts::Compute(Kept& kept, const Frame& frame, bool keepCut, const vtkMTPatchCache& cache)
{
  const auto start = std::chrono::steady_clock::now();
  vtkMTCutFollower::Input input;
  input.Graph = &this->Source->GetKnownGraph();
  const bool mayGrow = !input.Graph->IsWhole() && this->Source->GetGraphError().empty();
  input.Views = frame.Views;
  input.Resident = this->ReadableRevision > 0 ? &this->Resident : nullptr;
  input.GetState = [&](std::uint32_t arc)
  {
    return frame.IsUploaded(arc) ? vtkMTCutFollower::Uploaded
      : cache.Has(arc)           ? vtkMTCutFollower::Loaded
                                 : vtkMTCutFollower::Absent;
  };
  if (keepCut)
  {
    auto seen = std::make_shared<vtkMTCutFollower::Result>(kept.Follower.View(input, frame.Settings));
    seen->Wants = kept.Result->Wants;
    kept.Result = std::move(seen);
  }
  else
  {
    auto moved = std::make_shared<vtkMTCutFollower::Result>(kept.Follower.Update(input, frame.Settings));
    // What the view asks for may lie in what is not known yet.
    moved->OnTarget = moved->OnTarget && (moved->Converged || !mayGrow);
    kept.Result = std::move(moved);
  }
  ++this->Searches;
  kept.Posted = false;
  kept.Views = frame.Views;
  kept.Settings = frame.Settings;
  kept.Frozen = keepCut;
  kept.Readable = this->ReadableRevision;
  this->CutTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void vtkMTRendererCuts::Post(vtkMTPatchCache& cache)
{
  for (auto& [renderer, kept] : this->All)
  {
    if (kept.Result && !kept.Posted)
    {
      kept.Posted = true;
      cache.SetWants(renderer, kept.Result->Wants);
    }
  }
}

void vtkMTRendererCuts::PostAgain()
{
  for (auto& each : this->All)
  {
    each.second.Posted = false;
  }
}

void vtkMTRendererCuts::Forget(Key renderer, vtkMTPatchCache* cache)
{
  this->All.erase(renderer);
  if (cache)
  {
    cache->Forget(renderer);
  }
}

void vtkMTRendererCuts::Invalidate()
{
  for (auto& each : this->All)
  {
    Kept& kept = each.second;
    kept.Readable = kept.Result == this->Last ? ~std::uint64_t(0) : kept.Readable;
  }
}

bool vtkMTRendererCuts::MarkUnreadable(std::uint32_t arc)
{
  if (!this->Resident[arc])
  {
    return false;
  }
  this->Resident[arc] = 0;
  ++this->ReadableRevision;
  return true;
}
