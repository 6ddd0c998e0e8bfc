// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFrame.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

vtkMTUploader::~vtkMTUploader() = default;

vtkMTFrame::vtkMTFrame() = default;
vtkMTFrame::~vtkMTFrame() = default;

bool vtkMTFrame::SetSource(
  const std::shared_ptr<const vtkMTPatchSource>& source, const vtkMTPatchLoader::Settings& loader)
{
  if (!this->Cuts.SetSource(source))
  {
    return false;
  }
  this->Cut.reset();
  this->Renderers.clear();
  this->Failures.clear();
  this->FinestTriangles = source ? source->GetKnownGraph().GetNumberOfFinestTriangles() : 0;
  this->GraphFailed = false;
  this->Cache = source ? std::make_unique<vtkMTPatchCache>(source, vtkMTPatchCache::DefaultLimit, loader) : nullptr;
  return true;
}

const vtkMTGraph& vtkMTFrame::GetGraph() const
{
  return this->GetSource()->GetKnownGraph();
}

const vtkMTFrame::Result& vtkMTFrame::Update(
  Key renderer, const std::vector<vtkMTView>& views, const Settings& settings, vtkMTUploader& uploader)
{
  this->Current = &this->Renderers[renderer];
  this->Uploader = &uploader;
  this->Begin(*this->Current, settings);
  do
  {
    this->FindCut(renderer, views, settings);
  } while (!this->UploadCut());
  this->Cuts.Post(*this->Cache);
  return *this->Cut;
}

void vtkMTFrame::Forget(Key renderer)
{
  this->Renderers.erase(renderer);
  this->Cuts.Forget(renderer, this->Cache.get());
}

std::vector<std::string> vtkMTFrame::TakeFailures()
{
  return std::exchange(this->Failures, {});
}

//------------------------------------------------------------------------------
// What is to be drawn

void vtkMTFrame::Begin(Renderer& renderer, const Settings& settings)
{
  renderer.Uploader = this->Uploader;
  this->LessTriangles = 0;
  this->CoarsestOnly = false;
  this->Cache->SetArrays(this->Uploader->GetArrays());
  const vtkMTGraph& graph = this->GetGraph();
  const vtkMTNode& source = graph.Nodes[graph.GetSource()];
  const vtkMTUploader::Cost cost = this->Uploader->GetCost();
  std::uint64_t coarsest = graph.GetNumberOfRootTriangles() * cost.BytesPerTriangle;
  for (std::uint32_t i = 0; i < source.OutCount; ++i)
  {
    coarsest += std::uint64_t(graph.Arcs[source.FirstOut + i].Wedges) * cost.BytesPerVertex;
  }
  this->Limit = std::max(settings.GraphicsMemoryLimit, coarsest);
  if (!settings.Advance)
  {
    return;
  }
  renderer.Before = renderer.Time;
  renderer.Time = ++this->Time;
  this->Wait = settings.Cut.Wait;
  if (this->Cache->GetLimit() != settings.PatchMemoryLimit)
  {
    this->Cache->SetLimit(settings.PatchMemoryLimit);
    this->Cache->Retry();
  }
  this->Cache->Collect();
  this->NoteFailures();
}

// Those that share the uploader with the current one and have drawn since its last frame.
std::vector<const vtkMTFrame::Renderer*> vtkMTFrame::GetOthers() const
{
  std::vector<const Renderer*> others;
  for (const auto& each : this->Renderers)
  {
    const Renderer& other = each.second;
    if (&other != this->Current && other.Uploader == this->Uploader && other.Drawn &&
      other.Time > this->Current->Before)
    {
      others.push_back(&other);
    }
  }
  return others;
}

vtkMTCutFollower::Settings vtkMTFrame::GetCutSettings(const Settings& settings) const
{
  vtkMTCutFollower::Settings result = settings.Cut;
  const vtkMTUploader::Cost cost = this->Uploader->GetCost();
  result.BytesPerVertex = cost.BytesPerVertex;
  result.BytesPerTriangle = cost.BytesPerTriangle;
  // What is left of the limit is for gaps between patches, and for the copies while buffers grow.
  result.ByteLimit = this->Limit / 4 * 3 / (1 + this->GetOthers().size());
  if (this->LessTriangles > 0 && (result.TriangleLimit == 0 || this->LessTriangles < result.TriangleLimit))
  {
    result.TriangleLimit = this->LessTriangles;
  }
  result.Wait = this->Wait;
  if (this->CoarsestOnly)
  {
    result.PixelError = std::numeric_limits<double>::infinity();
    result.TimeLimit = 0.0;
  }
  if (this->Wait)
  {
    result.TimeLimit = 0.0;
    result.UploadBudget = 0;
    result.Prefetch = result.Prefetch && settings.MoreFrames;
  }
  return result;
}

void vtkMTFrame::FindCut(Key renderer, const std::vector<vtkMTView>& views, const Settings& settings)
{
  vtkMTRendererCuts::Frame frame;
  frame.Views = views;
  frame.Settings = this->GetCutSettings(settings);
  // A frozen cut that does not fit cannot stay.
  frame.Freeze = settings.Freeze && this->LessTriangles == 0;
  frame.Advance = settings.Advance;
  frame.IsUploaded = [this](std::uint32_t arc) { return this->Uploader->IsUploaded(arc); };
  this->Cut = this->Cuts.Update(renderer, frame, *this->Cache);
  if (this->Wait && !frame.Freeze && !this->Cut->Converged && !this->GetGraph().IsWhole())
  {
    this->GetSource()->GetGraph();
    this->NoteFailures();
    this->Cut = this->Cuts.Update(renderer, frame, *this->Cache);
  }
  this->Current->Drawn = this->Cut;
}

//------------------------------------------------------------------------------
// How it gets to the GPU

vtkMTFrame::State vtkMTFrame::GetState() const
{
  return { this->Cut, this->Uploader, this->Uploader->GetChanges(), this->Limit };
}

// False where another cut is to be found.
bool vtkMTFrame::UploadCut()
{
  // Nothing has been dropped since, so what the frame draws is still what was used last.
  if (this->GetState() == this->Current->AllThere)
  {
    return true;
  }
  this->BeginUpload();
  bool complete = true;
  for (std::size_t i = 0; i < this->Cut->Arcs.size(); ++i)
  {
    if (!this->BringPatch(i, complete))
    {
      return false;
    }
  }
  this->UploadEarlyPatches();
  const bool uploaded = this->IsUploaded();
  if (complete && !uploaded && this->DrawLess())
  {
    return false;
  }
  this->Current->AllThere = this->Cut->OnTarget && uploaded ? this->GetState() : State();
  return complete;
}

// Says to the uploader what the frame draws. What of that is on the GPU is used before anything else, so that no room
// is made for one patch of the frame by dropping another.
void vtkMTFrame::BeginUpload()
{
  std::vector<std::uint32_t> drawn = this->Cut->Arcs;
  if (!this->Cut->Early.empty())
  {
    drawn.insert(drawn.end(), this->Cut->Early.begin(), this->Cut->Early.end());
    std::sort(drawn.begin(), drawn.end());
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  }
  std::vector<std::uint32_t> kept;
  for (const Renderer* other : this->GetOthers())
  {
    std::vector<std::uint32_t> all;
    std::set_union(
      kept.begin(), kept.end(), other->Drawn->Arcs.begin(), other->Drawn->Arcs.end(), std::back_inserter(all));
    kept.swap(all);
  }
  std::vector<std::uint32_t> rest;
  std::set_difference(kept.begin(), kept.end(), drawn.begin(), drawn.end(), std::back_inserter(rest));
  this->Uploader->Begin(drawn, rest, this->Limit);
}

// One patch of the cut. False where another cut is to be found at once; complete becomes false where one is to be found
// when all others are there.
bool vtkMTFrame::BringPatch(std::size_t index, bool& complete)
{
  const std::uint32_t arc = this->Cut->Arcs[index];
  if (!this->Uploader->Reserve(arc))
  {
    return !this->DrawLess();
  }
  if (this->Uploader->IsUploaded(arc))
  {
    return true;
  }
  const std::shared_ptr<const vtkMTPatch> patch = this->FetchPatch(index);
  if (!patch && !this->Cache->IsFailed(arc) && !this->IsWaitedFor(arc))
  {
    // It was there when the cut was found: the uploader has dropped it since, or more of it is wanted now.
    this->Uploader->Drop(arc);
    this->Cuts.Invalidate();
    return false;
  }
  if (!patch || !this->Uploader->Upload(arc, *patch))
  {
    this->Uploader->Drop(arc);
    complete = !this->GiveUp(arc) && complete;
  }
  return true;
}

// The coarsest patches always are.
bool vtkMTFrame::IsWaitedFor(std::uint32_t arc) const
{
  return this->Wait || this->GetGraph().Arcs[arc].From == this->GetGraph().GetSource();
}

// The patch of an arc of the cut. Where it is waited for, all that is waited for and missing is loaded at once, as far
// as memory goes.
std::shared_ptr<const vtkMTPatch> vtkMTFrame::FetchPatch(std::size_t index)
{
  const std::vector<std::uint32_t>& arcs = this->Cut->Arcs;
  if (!this->Cache->Has(arcs[index]) && this->IsWaitedFor(arcs[index]))
  {
    std::vector<std::uint32_t> missing;
    std::copy_if(arcs.begin() + static_cast<std::ptrdiff_t>(index), arcs.end(), std::back_inserter(missing),
      [this](std::uint32_t arc)
      { return this->IsWaitedFor(arc) && !this->Cache->Has(arc) && !this->Uploader->IsUploaded(arc); });
    this->Cache->Request(missing);
    this->Cuts.PostAgain();
  }
  return this->Cache->Get(arcs[index]);
}

void vtkMTFrame::UploadEarlyPatches()
{
  for (const std::uint32_t arc : this->Cut->Early)
  {
    const std::shared_ptr<const vtkMTPatch> patch =
      this->Uploader->Reserve(arc) && !this->Uploader->IsUploaded(arc) ? this->Cache->Get(arc) : nullptr;
    if (patch && !this->Uploader->Upload(arc, *patch))
    {
      this->Uploader->Drop(arc);
    }
  }
}

// Whether all of the cut is on the GPU: the uploader may have dropped everything while patches were being added.
bool vtkMTFrame::IsUploaded() const
{
  return std::all_of(this->Cut->Arcs.begin(), this->Cut->Arcs.end(),
    [this](std::uint32_t arc) { return this->Uploader->IsUploaded(arc) || this->Cuts.IsUnreadable(arc); });
}

// The patches of the cut leave more gaps on the GPU than the limit on bytes allows for. The second time with fewer of
// them; the first time the gaps may have been closed by dropping everything. Cuts that a limit does not make small
// enough, because the coarsest one has more triangles, give way to that one, which always has room. False where it is
// the one that is drawn.
bool vtkMTFrame::DrawLess()
{
  if (this->Cut->NodesRefined == 0 || this->CoarsestOnly)
  {
    return false;
  }
  const std::uint64_t now = std::max<std::uint64_t>(this->Cut->Triangles, 2);
  this->CoarsestOnly = this->LessTriangles > 0 && now > this->LessTriangles;
  this->LessTriangles = this->LessTriangles == 0 ? now : now - std::max<std::uint64_t>(now / 8, 1);
  return true;
}

//------------------------------------------------------------------------------
// What cannot be drawn

// Takes the patch for one that cannot be read. True when that is news, so that another cut is needed.
bool vtkMTFrame::GiveUp(std::uint32_t arc)
{
  const bool news = this->Cuts.MarkUnreadable(arc);
  this->NoteFailures();
  return news;
}

void vtkMTFrame::NoteFailures()
{
  const std::string lost = this->GraphFailed ? std::string() : this->GetSource()->GetGraphError();
  if (!lost.empty())
  {
    this->GraphFailed = true;
    this->Failures.push_back(lost);
  }
  const std::string name = this->GetSource()->GetName() + ": ";
  for (const vtkMTPatchCache::Failure& failure : this->Cache->TakeFailures())
  {
    this->Cuts.MarkUnreadable(failure.Arc);
    this->Failures.push_back((failure.What.compare(0, name.size(), name) == 0 ? "" : name) + failure.What);
  }
}
