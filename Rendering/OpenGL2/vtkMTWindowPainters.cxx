// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTWindowPainters.h"

#include "vtkMTTrianglePainter.h"
#include "vtkMTWindowClock.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <functional>

// Told when a window's context goes. VTK 9.1 does not install the class that its own objects register with a window for
// that; a texture object has one, so this is a texture without a picture.
class vtkMTWindowPainters::Watch : public vtkTextureObject
{
public:
  static Watch* New();
  vtkTypeMacro(Watch, vtkTextureObject);

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    // The superclass calls this method again with the window's context current, if it is not.
    auto* renderWindow = vtkRenderWindow::SafeDownCast(window);
    if (this->OnRelease && renderWindow && renderWindow->IsCurrent())
    {
      this->OnRelease();
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

  std::function<void()> OnRelease;

protected:
  Watch() = default;
  ~Watch() override = default;

private:
  Watch(const Watch&) = delete;
  void operator=(const Watch&) = delete;
};

vtkStandardNewMacro(vtkMTWindowPainters::Watch);

struct vtkMTWindowPainters::Entry
{
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkMTTrianglePainter Painter;
  vtkOpenGLRenderTimer Timer;
  std::shared_ptr<vtkMTWindowClock> Clock;
  vtkNew<Watch> Context;

  Entry()
  {
    this->Context->OnRelease = [this]
    {
      this->Painter.ReleaseGraphicsResources();
      this->Timer.ReleaseGraphicsResources();
      if (this->Clock)
      {
        this->Clock->ReleaseGraphicsResources();
        this->Clock = nullptr;
      }
      this->Window = nullptr;
    };
  }

  void Release()
  {
    if (vtkRenderWindow* window = this->Window)
    {
      this->Context->ReleaseGraphicsResources(window);
    }
  }
};

vtkMTWindowPainters::vtkMTWindowPainters() = default;

vtkMTWindowPainters::~vtkMTWindowPainters()
{
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    entry->Release();
  }
}

// An entry whose window is gone holds nothing and serves the next one.
vtkMTWindowPainters::Entry& vtkMTWindowPainters::Find(vtkRenderWindow* window)
{
  const auto find = [this](const vtkRenderWindow* wanted)
  {
    return std::find_if(this->Entries.begin(), this->Entries.end(),
      [wanted](const std::unique_ptr<Entry>& entry) { return entry->Window == wanted; });
  };
  auto found = find(window);
  if (found == this->Entries.end())
  {
    found = find(nullptr);
  }
  if (found == this->Entries.end())
  {
    found = this->Entries.insert(this->Entries.end(), std::make_unique<Entry>());
  }
  Entry& entry = **found;
  if (entry.Window != window)
  {
    entry.Window = window;
    entry.Clock = vtkMTWindowClock::Get(window);
    entry.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  }
  return entry;
}

vtkMTTrianglePainter& vtkMTWindowPainters::Use(vtkRenderWindow* window)
{
  return this->Find(window).Painter;
}

vtkOpenGLRenderTimer& vtkMTWindowPainters::GetTimer(vtkRenderWindow* window)
{
  return this->Find(window).Timer;
}

const std::shared_ptr<vtkMTWindowClock>& vtkMTWindowPainters::GetClock(vtkRenderWindow* window)
{
  return this->Find(window).Clock;
}

std::uint64_t vtkMTWindowPainters::Share(vtkRenderWindow* window, std::uint64_t limit)
{
  Entry& mine = this->Find(window);
  const auto others = std::count_if(this->Entries.begin(), this->Entries.end(),
    [&mine](const std::unique_ptr<Entry>& entry)
    { return entry.get() != &mine && entry->Painter.GetArena().GetBytes() > 0; });
  const std::uint64_t share = limit / (1 + static_cast<std::uint64_t>(others));
  std::uint64_t bytes = 0;
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    if (entry.get() != &mine)
    {
      if (entry->Painter.GetArena().GetBytes() > share)
      {
        entry->Release();
      }
      bytes += entry->Painter.GetArena().GetBytes();
    }
  }
  mine.Painter.GetArena().SetBytesElsewhere(bytes);
  return share;
}

void vtkMTWindowPainters::Clear()
{
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    entry->Painter.Clear();
  }
}

void vtkMTWindowPainters::Release(vtkWindow* window)
{
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    if (window && entry->Window == window)
    {
      entry->Release();
    }
  }
}

std::uint64_t vtkMTWindowPainters::GetBytes() const
{
  std::uint64_t bytes = 0;
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    bytes += entry->Painter.GetArena().GetBytes();
  }
  return bytes;
}

std::uint64_t vtkMTWindowPainters::GetMostBytes() const
{
  std::uint64_t most = 0;
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    most = std::max(most, entry->Painter.GetArena().GetMostBytes());
  }
  return most;
}

std::uint64_t vtkMTWindowPainters::GetNumberOfUploadedBytes() const
{
  std::uint64_t bytes = 0;
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    bytes += entry->Painter.GetArena().GetNumberOfUploadedBytes();
  }
  return bytes;
}
