// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutKeeper.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRendererView.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>

namespace
{
bool IsSame(const vtkMTExtraction::Settings& a, const vtkMTExtraction::Settings& b)
{
  return a.PixelError == b.PixelError && a.TriangleBudget == b.TriangleBudget && a.ErrorChoice == b.ErrorChoice &&
    a.FrustumCulling == b.FrustumCulling;
}
}

bool vtkMTCutKeeper::SetSource(const std::shared_ptr<const vtkMTPatchSource>& source)
{
  if (source == this->Source)
  {
    return false;
  }
  this->Source = source;
  this->All.clear();
  this->Last.reset();
  this->Resident.assign(source ? source->GetGraph().Arcs.size() : 0, 1);
  this->ReadableRevision = 0;
  return true;
}

vtkMTCutKeeper::Kept& vtkMTCutKeeper::Find(vtkRenderer* renderer)
{
  this->All.remove_if([](const Kept& kept) { return kept.Renderer == nullptr; });
  auto found = std::find_if(
    this->All.begin(), this->All.end(), [renderer](const Kept& kept) { return kept.Renderer == renderer; });
  if (found == this->All.end())
  {
    found = this->All.emplace(this->All.end());
    found->Renderer = renderer;
  }
  return *found;
}

const vtkMTExtraction::Result& vtkMTCutKeeper::Update(
  vtkRenderer* renderer, const vtkMTView& view, const vtkMTExtraction::Settings& settings, bool freeze)
{
  Kept& kept = this->Find(renderer);
  // A patch that turns out unreadable would leave a hole in a frozen cut.
  const bool keepCut = freeze && kept.Result && kept.Readable == this->ReadableRevision;
  if (!kept.Result || kept.Frozen != keepCut || kept.Readable != this->ReadableRevision ||
    !IsSame(kept.Settings, settings) || !vtkMTRendererView::IsSame(kept.View, view))
  {
    const auto start = std::chrono::steady_clock::now();
    vtkMTExtraction::Input input;
    input.Graph = &this->Source->GetGraph();
    input.View = &view;
    input.Resident = this->ReadableRevision > 0 ? &this->Resident : nullptr;
    kept.Result = std::make_shared<vtkMTExtraction::Result>(
      keepCut ? this->Extraction.View(kept.Result->Cut, input, settings) : this->Extraction.Extract(input, settings));
    kept.View = view;
    kept.Settings = settings;
    kept.Frozen = keepCut;
    kept.Readable = this->ReadableRevision;
    this->CutTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  this->Last = kept.Result;
  return *kept.Result;
}

bool vtkMTCutKeeper::MarkUnreadable(std::uint32_t arc)
{
  if (!this->Resident[arc])
  {
    return false;
  }
  this->Resident[arc] = 0;
  ++this->ReadableRevision;
  return true;
}
