// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererCuts.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRendererView.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace
{
// Clocks are not compared: they do not change what is asked for. Nor are bytes, see FitsAsWell.
bool IsSame(const vtkMTCutFollower::Settings& a, const vtkMTCutFollower::Settings& b)
{
  return a.PixelError == b.PixelError && a.TriangleLimit == b.TriangleLimit && a.TimeLimit == b.TimeLimit &&
    a.ErrorMetric == b.ErrorMetric && a.FrustumCulling == b.FrustumCulling && a.FacingCulling == b.FacingCulling &&
    a.UploadBudget == b.UploadBudget && a.Prefetch == b.Prefetch && a.Wait == b.Wait;
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
  this->Gone.clear();
  this->Last.reset();
  this->Resident.assign(source ? source->GetGraph().Arcs.size() : 0, 1);
  this->ReadableRevision = 0;
  return true;
}

vtkMTRendererCuts::Kept& vtkMTRendererCuts::Find(vtkRenderer* renderer)
{
  for (const Kept& kept : this->All)
  {
    if (kept.Renderer == nullptr)
    {
      this->Gone.push_back(kept.Follower.get());
    }
  }
  this->All.remove_if([](const Kept& kept) { return kept.Renderer == nullptr; });
  auto found = std::find_if(
    this->All.begin(), this->All.end(), [renderer](const Kept& kept) { return kept.Renderer == renderer; });
  if (found == this->All.end())
  {
    found = this->All.emplace(this->All.end());
    found->Renderer = renderer;
    found->Follower = std::make_unique<vtkMTCutFollower>();
    // The address may be that of a view that is no more.
    this->Gone.erase(std::remove(this->Gone.begin(), this->Gone.end(), found->Follower.get()), this->Gone.end());
  }
  return *found;
}

const vtkMTCutFollower::Result& vtkMTRendererCuts::Update(
  vtkRenderer* renderer, const Frame& frame, const vtkMTPatchCache& cache)
{
  Kept& kept = this->Find(renderer);
  // A patch that turns out unreadable would leave a hole in a frozen cut.
  const bool keepCut = frame.Freeze && kept.Result && kept.Readable == this->ReadableRevision;
  const bool same = kept.Result && kept.Frozen == keepCut && kept.Readable == this->ReadableRevision &&
    IsSame(kept.Settings, frame.Settings) && vtkMTRendererView::IsSame(kept.View, frame.View) &&
    FitsAsWell(this->Source->GetGraph(), *kept.Result, kept.Settings, frame.Settings);
  const bool settled = kept.Frozen || (kept.Result && kept.Result->OnTarget);
  if (!same || (frame.Advance && !settled))
  {
    this->Compute(kept, frame, keepCut, cache);
  }
  this->Last = kept.Result;
  return *kept.Result;
}

void vtkMTRendererCuts::Compute(Kept& kept, const Frame& frame, bool keepCut, const vtkMTPatchCache& cache)
{
  const auto start = std::chrono::steady_clock::now();
  vtkMTCutFollower::Input input;
  input.Graph = &this->Source->GetGraph();
  input.View = &frame.View;
  input.Resident = this->ReadableRevision > 0 ? &this->Resident : nullptr;
  input.GetState = [&](std::uint32_t arc)
  {
    return frame.IsUploaded(arc) ? vtkMTCutFollower::Uploaded
      : cache.Has(arc)           ? vtkMTCutFollower::Loaded
                                 : vtkMTCutFollower::Absent;
  };
  if (keepCut)
  {
    auto seen = std::make_shared<vtkMTCutFollower::Result>(kept.Follower->View(input, frame.Settings));
    seen->Wants = kept.Result->Wants;
    kept.Result = std::move(seen);
  }
  else
  {
    kept.Result = std::make_shared<vtkMTCutFollower::Result>(kept.Follower->Update(input, frame.Settings));
  }
  ++this->Searches;
  kept.Posted = false;
  kept.View = frame.View;
  kept.Settings = frame.Settings;
  kept.Frozen = keepCut;
  kept.Readable = this->ReadableRevision;
  this->CutTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void vtkMTRendererCuts::Post(vtkMTPatchCache& cache)
{
  for (const void* view : this->Gone)
  {
    cache.Forget(view);
  }
  this->Gone.clear();
  for (Kept& kept : this->All)
  {
    if (kept.Result && !kept.Posted)
    {
      kept.Posted = true;
      cache.SetWants(kept.Follower.get(), kept.Result->Wants);
    }
  }
}

void vtkMTRendererCuts::Invalidate()
{
  for (Kept& kept : this->All)
  {
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
