// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTWindowClock.h"

#include "vtkCallbackCommand.h"
#include "vtkMTFrameHeap.h"
#include "vtkMTOpenGL.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <utility>

namespace
{
// A GPU that is farther behind says no more when a frame began.
constexpr std::size_t MostWaiting = 8;

double GetTime()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What the GPU's clock says now, if it has one.
std::uint64_t GetGpuTime()
{
#ifdef GL_TIMESTAMP
  GLint64 time = 0;
  glGetInteger64v(GL_TIMESTAMP, &time);
  return static_cast<std::uint64_t>(time);
#else
  return 0;
#endif
}

// Windows may be drawn by different threads.
struct Registry
{
  std::mutex Mutex;
  std::map<vtkRenderWindow*, std::weak_ptr<vtkMTWindowClock>> Clocks;
};

Registry& GetRegistry()
{
  static Registry registry;
  return registry;
}
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkMTWindowClock> vtkMTWindowClock::Get(vtkRenderWindow* window)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  for (auto entry = registry.Clocks.begin(); entry != registry.Clocks.end();)
  {
    entry = entry->second.expired() ? registry.Clocks.erase(entry) : std::next(entry);
  }
  std::weak_ptr<vtkMTWindowClock>& known = registry.Clocks[window];
  std::shared_ptr<vtkMTWindowClock> clock = known.lock();
  if (!clock || clock->Window != window) // another window may have had the same address
  {
    clock.reset(new vtkMTWindowClock(window));
    known = clock;
  }
  return clock;
}

//------------------------------------------------------------------------------
vtkMTWindowClock::vtkMTWindowClock(vtkRenderWindow* window)
  : Window(window)
{
  vtkMTFrameHeap::Keep();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&vtkMTWindowClock::OnEvent);
  window->AddObserver(vtkCommand::StartEvent, this->Observer);
  window->AddObserver(vtkCommand::EndEvent, this->Observer);
}

//------------------------------------------------------------------------------
vtkMTWindowClock::~vtkMTWindowClock()
{
  if (vtkRenderWindow* window = this->Window)
  {
    window->RemoveObserver(this->Observer);
  }
}

//------------------------------------------------------------------------------
void vtkMTWindowClock::OnEvent(vtkObject* vtkNotUsed(window), unsigned long event, void* self, void* vtkNotUsed(data))
{
  auto* clock = static_cast<vtkMTWindowClock*>(self);
  if (event == vtkCommand::StartEvent)
  {
    clock->Current = Pending();
    clock->Frames.Begin(GetTime());
  }
  else
  {
    clock->End();
  }
}

//------------------------------------------------------------------------------
// At StartEvent the window's context need not be current, nor exist.
vtkMTFrameClock& vtkMTWindowClock::UseInFrame()
{
  if (this->Frames.IsInFrame() && !this->Current.Timer && vtkOpenGLRenderTimer::IsSupported())
  {
    this->BeginTimer();
  }
  return this->Frames;
}

//------------------------------------------------------------------------------
void vtkMTWindowClock::BeginTimer()
{
  this->Collect();
  this->Current.Timer = std::make_unique<vtkOpenGLRenderTimer>();
  this->Current.Timer->Start();
  const double sinceBegin = 1e9 * std::max(GetTime() - this->Frames.GetBegin(), 0.0);
  const std::uint64_t now = GetGpuTime();
  this->Current.Begin = now - std::min(now, static_cast<std::uint64_t>(sinceBegin));
}

//------------------------------------------------------------------------------
double vtkMTWindowClock::GetWanted() const
{
  double seconds = 0.0;
  vtkCollectionSimpleIterator iterator;
  vtkRendererCollection* renderers = this->Window->GetRenderers();
  renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(iterator))
  {
    seconds += renderer->GetAllocatedRenderTime();
  }
  return std::max(seconds, 1e-9);
}

//------------------------------------------------------------------------------
void vtkMTWindowClock::End()
{
  this->Current.Frame = this->Frames.End(GetTime());
  if (this->Window->GetAbortRender())
  {
    this->Current.Frame.Counts = false;
  }
  if (!this->Current.Timer)
  {
    this->Frames.Learn(this->Current.Frame);
    return;
  }
  if (!this->Window->IsCurrent())
  {
    // Another observer took the context away. Without it the timer can neither be read nor released here.
    this->Window->MakeCurrent();
  }
  this->Current.Timer->Stop();
  if (this->Waiting.size() >= MostWaiting)
  {
    this->Waiting.clear();
    this->GpuWasDone = 0;
  }
  this->Waiting.push_back(std::move(this->Current));
  this->Current = Pending();
}

//------------------------------------------------------------------------------
void vtkMTWindowClock::Collect()
{
  while (!this->Waiting.empty() && this->Waiting.front().Timer->Ready())
  {
    Pending& pending = this->Waiting.front();
    const std::uint64_t begin = std::max(pending.Begin, this->GpuWasDone);
    this->GpuWasDone = pending.Timer->GetStopTime();
    if (this->GpuWasDone > begin)
    {
      pending.Frame.Seconds = std::max(pending.Frame.Seconds, 1e-9 * static_cast<double>(this->GpuWasDone - begin));
    }
    this->Frames.Learn(pending.Frame);
    this->Waiting.pop_front();
  }
}

//------------------------------------------------------------------------------
void vtkMTWindowClock::ReleaseGraphicsResources()
{
  this->Waiting.clear();
  this->Current.Timer.reset();
  this->GpuWasDone = 0;
}
