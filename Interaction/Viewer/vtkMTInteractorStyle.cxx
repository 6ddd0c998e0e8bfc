// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInteractorStyle.h"

#include "vtkCommand.h"
#include "vtkMTCameraPathFile.h"
#include "vtkMTInteractorStyleInternals.h"
#include "vtkMTScreenshot.h"
#include "vtkMTSetMacros.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double RecordingStep = 1.0 / 60.0; // seconds between two views at least
constexpr double Pause = 0.1;                // after so many seconds without a new view the camera has been still

bool IsSameView(vtkCamera* a, vtkCamera* b)
{
  const vtkMTCameraView first = vtkMTCameraView::Get(0.0, a);
  const vtkMTCameraView second = vtkMTCameraView::Get(0.0, b);
  return first.Position == second.Position && first.FocalPoint == second.FocalPoint && first.ViewUp == second.ViewUp &&
    first.ViewAngle == second.ViewAngle && first.ParallelScale == second.ParallelScale;
}
}

vtkStandardNewMacro(vtkMTInteractorStyle);
vtkMTCxxSetClampMacro(vtkMTInteractorStyle, FrameRate, 1.0, 240.0);

//------------------------------------------------------------------------------
vtkMTInteractorStyle::vtkMTInteractorStyle()
  : Implementation(std::make_unique<Internals>(this))
{
  this->Implementation->FrameCommand->SetClientData(this);
  this->Implementation->FrameCommand->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<vtkMTInteractorStyle*>(self)->OnFrame(); });
}

//------------------------------------------------------------------------------
vtkMTInteractorStyle::~vtkMTInteractorStyle()
{
  this->SetRenderer(nullptr);
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->GetRenderer() << "\n";
  os << indent << "ShowFigures: " << this->GetShowFigures() << "\n";
  os << indent << "ShowKeys: " << this->ShowKeys << "\n";
  os << indent << "ShowScalarBar: " << this->GetShowScalarBar() << "\n";
  os << indent << "Status: " << this->Status << "\n";
  os << indent << "Message: " << this->Message << "\n";
  os << indent << "ColorBy: " << this->GetColorBy() << "\n";
  os << indent << "ScreenshotPrefix: " << this->ScreenshotPrefix << "\n";
  os << indent << "PathPrefix: " << this->PathPrefix << "\n";
  os << indent << "FrameRate: " << this->FrameRate << "\n";
  os << indent << "Recording: " << this->GetRecording() << "\n";
  os << indent << "Playing: " << this->GetPlaying() << "\n";
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::SetRenderer(vtkRenderer* renderer)
{
  Internals& self = *this->Implementation;
  if (self.Renderer == renderer)
  {
    return;
  }
  if (self.Renderer)
  {
    self.Renderer->RemoveObserver(self.FrameCommand);
  }
  self.Renderer = renderer;
  self.Colors.SetRenderer(renderer);
  self.Overlay.SetRenderer(renderer);
  this->SetDefaultRenderer(renderer); // the pointer may be over the figures
  this->SetCurrentRenderer(renderer);
  if (renderer)
  {
    renderer->AddObserver(vtkCommand::EndEvent, self.FrameCommand);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkMTInteractorStyle::GetRenderer()
{
  return this->Implementation->Renderer;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::SetShowFigures(bool on)
{
  this->Implementation->Overlay.ShowFigures = on;
  this->Modified();
}

bool vtkMTInteractorStyle::GetShowFigures()
{
  return this->Implementation->Overlay.ShowFigures;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::SetShowScalarBar(bool on)
{
  this->Implementation->Overlay.ShowScalarBar = on;
  this->Modified();
}

bool vtkMTInteractorStyle::GetShowScalarBar()
{
  return this->Implementation->Overlay.ShowScalarBar;
}

//------------------------------------------------------------------------------
bool vtkMTInteractorStyle::SetColorBy(const char* name)
{
  return this->Implementation->Colors.Select(name ? name : "");
}

const char* vtkMTInteractorStyle::GetColorBy()
{
  return this->Implementation->Colors.GetSelected().c_str();
}

void vtkMTInteractorStyle::ColorsChanged()
{
  this->Implementation->Colors.Apply();
}

//------------------------------------------------------------------------------
int vtkMTInteractorStyle::GetNumberOfColorArrays()
{
  return static_cast<int>(this->Implementation->Colors.GetNames().size());
}

std::string vtkMTInteractorStyle::GetColorArrayName(int index)
{
  const std::vector<std::string> names = this->Implementation->Colors.GetNames();
  return index >= 0 && index < static_cast<int>(names.size()) ? names[index] : "";
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::SetScreenshotPrefix(const char* prefix)
{
  if (prefix && *prefix && this->ScreenshotPrefix != prefix)
  {
    this->ScreenshotPrefix = prefix;
    this->Modified();
  }
}

void vtkMTInteractorStyle::SetPathPrefix(const char* prefix)
{
  if (prefix && *prefix && this->PathPrefix != prefix)
  {
    this->PathPrefix = prefix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::TakeScreenshot()
{
  vtkRenderer* renderer = this->GetRenderer();
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  std::string error = "there is no window";
  std::string path = window ? vtkMTScreenshot::WriteNext(window, this->ScreenshotPrefix, error) : "";
  this->Message = path.empty() ? error : "picture in " + path;
  return path;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::SetCameraPath(vtkMTCameraPath* path)
{
  if (path && path != this->Implementation->Path)
  {
    this->StopPlaying();
    this->Implementation->Path = path;
    this->Modified();
  }
}

vtkMTCameraPath* vtkMTInteractorStyle::GetCameraPath()
{
  return this->Implementation->Path;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::StartRecording()
{
  Internals& self = *this->Implementation;
  if (!self.Renderer)
  {
    return;
  }
  this->StopPlaying();
  self.Path = vtkSmartPointer<vtkMTCameraPath>::New();
  self.Start = Internals::Clock::now();
  self.IsRecording = self.Path->AddView(0.0, self.Renderer->GetActiveCamera());
  self.LastView->DeepCopy(self.Renderer->GetActiveCamera());
  this->Message = self.Path->GetErrorMessage();
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::StopRecording()
{
  Internals& self = *this->Implementation;
  if (!std::exchange(self.IsRecording, false))
  {
    return "";
  }
  vtkCamera* camera = self.Renderer ? self.Renderer->GetActiveCamera() : self.LastView.Get();
  if (!IsSameView(camera, self.LastView)) // it came too soon after the view before
  {
    self.Path->AddView(std::max(self.GetElapsed(), self.Path->GetLastTime() + RecordingStep), camera);
  }
  if (self.Path->GetNumberOfViews() < 2)
  {
    this->Message = "nothing was recorded: the camera has not moved";
    return "";
  }
  return this->WritePath();
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::WritePath()
{
  vtkMTCameraPath* views = this->Implementation->Path;
  if (views->GetNumberOfViews() == 0)
  {
    this->Message = "the camera path is empty";
    return "";
  }
  std::string error;
  std::string path = vtkMTScreenshot::ReserveNext(this->PathPrefix, ".csv", error);
  if (!path.empty() && !views->Write(path.c_str()))
  {
    error = views->GetErrorMessage();
    std::remove(path.c_str());
    path.clear();
  }
  this->Message = path.empty() ? error : "camera path in " + path;
  return path;
}

//------------------------------------------------------------------------------
bool vtkMTInteractorStyle::GetRecording() const
{
  return this->Implementation->IsRecording;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::OnFrame()
{
  Internals& self = *this->Implementation;
  if (!self.IsRecording || !self.Renderer)
  {
    return;
  }
  vtkCamera* camera = self.Renderer->GetActiveCamera();
  const double now = self.GetElapsed();
  const double last = self.Path->GetLastTime();
  if (now - last < RecordingStep || IsSameView(camera, self.LastView))
  {
    return;
  }
  if (now - last > Pause) // or else the camera would creep through the pause
  {
    self.Path->AddView(now - 2.0 * RecordingStep, self.LastView);
  }
  self.Path->AddView(now, camera);
  self.LastView->DeepCopy(camera);
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::StartPlaying()
{
  Internals& self = *this->Implementation;
  if (self.IsRecording || !self.Renderer || self.Path->GetNumberOfViews() == 0)
  {
    this->Message = self.IsRecording ? this->Message : "there is no camera path to play";
    return;
  }
  this->StopPlaying();
  self.IsPlaying = true;
  self.Start = Internals::Clock::now();
  if (this->Interactor)
  {
    self.Timer = this->Interactor->CreateRepeatingTimer(std::max(1, static_cast<int>(1e3 / this->FrameRate)));
    this->Interactor->GetRenderWindow()->SetDesiredUpdateRate(this->Interactor->GetDesiredUpdateRate());
  }
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::StopPlaying()
{
  Internals& self = *this->Implementation;
  if (std::exchange(self.IsPlaying, false) && this->Interactor)
  {
    this->Interactor->DestroyTimer(self.Timer);
    this->Interactor->GetRenderWindow()->SetDesiredUpdateRate(this->Interactor->GetStillUpdateRate());
  }
}

//------------------------------------------------------------------------------
bool vtkMTInteractorStyle::GetPlaying() const
{
  return this->Implementation->IsPlaying;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Play()
{
  Internals& self = *this->Implementation;
  const double time = self.Path->GetFirstTime() + self.GetElapsed();
  const bool isLast = time >= self.Path->GetLastTime();
  if (this->State != VTKIS_NONE || !self.Renderer || isLast)
  {
    this->StopPlaying(); // at the end, or a mouse button has taken the camera over
  }
  if (this->State == VTKIS_NONE && self.Renderer)
  {
    self.Path->GetView(time, self.Renderer->GetActiveCamera());
    self.Renderer->ResetCameraClippingRange();
    this->RenderAll();
  }
}

//------------------------------------------------------------------------------
int vtkMTInteractorStyle::RenderPath(const char* prefix)
{
  Internals& self = *this->Implementation;
  vtkRenderer* renderer = self.Renderer;
  if (!renderer || self.IsRecording || self.Path->GetNumberOfViews() == 0)
  {
    return 0;
  }
  const double first = self.Path->GetFirstTime();
  const double last = self.Path->GetLastTime();
  const double steps = std::ceil((last - first) * this->FrameRate - 1e-6);
  self.IsPlaying = true;
  self.Start = Internals::Clock::now();
  int frames = 0;
  while (self.IsPlaying && frames <= steps)
  {
    self.Path->GetView(std::min(first + frames / this->FrameRate, last), renderer->GetActiveCamera());
    renderer->ResetCameraClippingRange();
    this->RenderAll();
    ++frames;
    std::string error;
    if (prefix && *prefix && vtkMTScreenshot::WriteNext(renderer->GetRenderWindow(), prefix, error).empty())
    {
      this->Message = error;
      frames = -1;
      break;
    }
    this->InvokeEvent(vtkCommand::AbortCheckEvent);
  }
  self.IsPlaying = false;
  return frames;
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::OnTimer()
{
  this->Superclass::OnTimer();
  if (this->Implementation->IsPlaying)
  {
    this->Play();
  }
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::RenderAll()
{
  vtkRenderer* renderer = this->GetRenderer();
  if (this->Interactor && this->Interactor->GetInitialized())
  {
    this->Interactor->Render();
  }
  else if (renderer && renderer->GetRenderWindow())
  {
    renderer->GetRenderWindow()->Render();
  }
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::GetOverlayText()
{
  return this->Implementation->Overlay.GetText();
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::GetTextBelowFigures() const
{
  const Internals& self = *this->Implementation;
  std::string text = this->Status;
  const auto add = [&text](const std::string& line) { text += (text.empty() ? "" : "\n") + line; };
  if (!this->Message.empty())
  {
    add(this->Message);
  }
  if (self.IsRecording || self.IsPlaying)
  {
    char line[80];
    std::snprintf(line, sizeof(line), "%s %.1f s, %d views", self.IsRecording ? "RECORDING" : "PLAYING",
      self.GetElapsed(), self.Path->GetNumberOfViews());
    add(line);
  }
  if (this->ShowKeys)
  {
    add(GetKeys());
  }
  else if (self.Overlay.ShowFigures)
  {
    add("h: keys");
  }
  return text;
}
