// SPDX-License-Identifier: BSD-3-Clause
// vtkMTInteractorStyle: its keys.
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkMTCameraMoves.h"
#include "vtkMTInteractorStyle.h"
#include "vtkMTInteractorStyleInternals.h"
#include "vtkMTScreenshot.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cstdio>

namespace
{
constexpr double TurnStep = 5.0; // degrees
constexpr double PanStep = 0.05; // of the height of the view
constexpr double ZoomStep = 1.15;
constexpr double SecondsBetweenViews = 2.0;

template <class Do>
void ForAllProperties(vtkRenderer* renderer, const Do& doIt)
{
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    doIt(vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty());
  }
}

std::string GetShort(const char* name)
{
  const std::string keypad = name ? name : "";
  return keypad.compare(0, 3, "KP_") == 0 ? keypad.substr(3) : keypad;
}
}

//------------------------------------------------------------------------------
using Style = vtkMTInteractorStyle;
const std::vector<vtkMTInteractorStyle::Keys::Key> vtkMTInteractorStyle::Keys::Table = {
  { "Left", "arrows", "turn", [](Style* self) { Turn(self, TurnStep, 0.0); } },
  { "Right", nullptr, nullptr, [](Style* self) { Turn(self, -TurnStep, 0.0); } },
  { "Up", nullptr, nullptr, [](Style* self) { Turn(self, 0.0, -TurnStep); } },
  { "Down", nullptr, nullptr, [](Style* self) { Turn(self, 0.0, TurnStep); } },
  { "Shift+Left", "Shift arrows", "move", [](Style* self) { Pan(self, PanStep, 0.0); } },
  { "Shift+Right", nullptr, nullptr, [](Style* self) { Pan(self, -PanStep, 0.0); } },
  { "Shift+Up", nullptr, nullptr, [](Style* self) { Pan(self, 0.0, -PanStep); } },
  { "Shift+Down", nullptr, nullptr, [](Style* self) { Pan(self, 0.0, PanStep); } },
  { "Prior", "PgUp PgDn", "closer, farther; also i o, Ctrl up down", [](Style* self) { Zoom(self, ZoomStep); } },
  { "Next", nullptr, nullptr, [](Style* self) { Zoom(self, 1.0 / ZoomStep); } },
  { "i", nullptr, nullptr, [](Style* self) { Zoom(self, ZoomStep); } },
  { "o", nullptr, nullptr, [](Style* self) { Zoom(self, 1.0 / ZoomStep); } },
  { "Control+Up", nullptr, nullptr, [](Style* self) { Zoom(self, ZoomStep); } },
  { "Control+Down", nullptr, nullptr, [](Style* self) { Zoom(self, 1.0 / ZoomStep); } },
  { ",", ", .", "roll", [](Style* self) { Roll(self, TurnStep); } },
  { ".", nullptr, nullptr, [](Style* self) { Roll(self, -TurnStep); } },
  { "x", "x y z", "look along an axis; from its other end X Y Z", [](Style* self) { LookAlong(self, 0, 1); } },
  { "y", nullptr, nullptr, [](Style* self) { LookAlong(self, 1, 1); } },
  { "z", nullptr, nullptr, [](Style* self) { LookAlong(self, 2, 1); } },
  { "X", nullptr, nullptr, [](Style* self) { LookAlong(self, 0, -1); } },
  { "Y", nullptr, nullptr, [](Style* self) { LookAlong(self, 1, -1); } },
  { "Z", nullptr, nullptr, [](Style* self) { LookAlong(self, 2, -1); } },
  { "r", "r", "see everything", Reset },
  { "+", "+ -", "halve or double the pixel error", [](Style* self) { ScalePixelError(self, 0.5); } },
  { "=", nullptr, nullptr, [](Style* self) { ScalePixelError(self, 0.5); } },
  { "-", nullptr, nullptr, [](Style* self) { ScalePixelError(self, 2.0); } },
  { "f", "f", "freeze the cut, or let it follow the camera again", ToggleFreeze },
  { "l", "l p d", "colour by level, patch, deviation (blue none, red all that is allowed)",
    [](Style* self) { ColorBy(self, "level"); } },
  { "p", nullptr, nullptr, [](Style* self) { ColorBy(self, "patch"); } },
  { "d", nullptr, nullptr, [](Style* self) { ColorBy(self, "error"); } },
  { "c", "c C", "colour by the next array, the one before", [](Style* self) { NextArray(self, 1); } },
  { "C", nullptr, nullptr, [](Style* self) { NextArray(self, -1); } },
  { "j", "j", "the array's next component, or its magnitude", NextComponent },
  { "n", "n", "colours of the data again", [](Style* self) { ColorBy(self, ""); } },
  { "b", "b", "scalar bar on or off", [](Style* self) { self->SetShowScalarBar(!self->GetShowScalarBar()); } },
  { "t", "t", "textures on or off", ToggleTextures },
  { "w", "w s e", "wireframe, surface, edges on or off", [](Style* self) { SetRepresentation(self, VTK_WIREFRAME); } },
  { "s", nullptr, nullptr, [](Style* self) { SetRepresentation(self, VTK_SURFACE); } },
  { "e", nullptr, nullptr, ToggleEdges },
  { "g", "g, F12", "screenshot into a new file", [](Style* self) { self->TakeScreenshot(); } },
  { "F12", nullptr, nullptr, [](Style* self) { self->TakeScreenshot(); } },
  { "m", "m", "record the camera; again: stop, write the path", ToggleRecording },
  { "a", "a", "add this view to the camera path, 2 seconds after the last", AddView },
  { "k", "k u", "write the path into a new file, forget it", WritePath },
  { "u", nullptr, nullptr, ForgetPath },
  { " ", "space", "play the path, or stop", TogglePlaying },
  { "v", "v", "figures on or off", [](Style* self) { self->SetShowFigures(!self->GetShowFigures()); } },
  { "h", "h ? F1", "these keys on or off", [](Style* self) { self->SetShowKeys(!self->ShowKeys); } },
  { "?", nullptr, nullptr, [](Style* self) { self->SetShowKeys(!self->ShowKeys); } },
  { "F1", nullptr, nullptr, [](Style* self) { self->SetShowKeys(!self->ShowKeys); } },
  { "q", "q Esc", "quit", Quit },
  { "Escape", nullptr, nullptr, Quit },
};

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Keys::Turn(vtkMTInteractorStyle* self, double right, double up)
{
  self->StopPlaying();
  vtkMTCameraMoves::Turn(self->GetRenderer(), right, up);
}

void vtkMTInteractorStyle::Keys::Pan(vtkMTInteractorStyle* self, double right, double up)
{
  self->StopPlaying();
  vtkMTCameraMoves::Pan(self->GetRenderer(), right, up);
}

void vtkMTInteractorStyle::Keys::Zoom(vtkMTInteractorStyle* self, double factor)
{
  self->StopPlaying();
  vtkMTCameraMoves::Zoom(self->GetRenderer(), factor);
}

void vtkMTInteractorStyle::Keys::Roll(vtkMTInteractorStyle* self, double degrees)
{
  self->StopPlaying();
  vtkMTCameraMoves::Roll(self->GetRenderer(), degrees);
}

void vtkMTInteractorStyle::Keys::LookAlong(vtkMTInteractorStyle* self, int axis, int side)
{
  self->StopPlaying();
  vtkMTCameraMoves::LookAlong(self->GetRenderer(), axis, side);
}

void vtkMTInteractorStyle::Keys::Reset(vtkMTInteractorStyle* self)
{
  self->StopPlaying();
  self->GetRenderer()->ResetCamera();
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Keys::ScalePixelError(vtkMTInteractorStyle* self, double factor)
{
  for (const auto& [actor, mapper] : vtkMTColorSelector::FindModels(self->GetRenderer()))
  {
    mapper->SetPixelError(std::clamp(factor * mapper->GetPixelError(), 0.01, 1000.0));
  }
}

void vtkMTInteractorStyle::Keys::ToggleFreeze(vtkMTInteractorStyle* self)
{
  const auto models = vtkMTColorSelector::FindModels(self->GetRenderer());
  const bool isFrozen = !models.empty() && models.front().second->GetFreezeCut();
  std::for_each(models.begin(), models.end(), [isFrozen](const auto& model) { model.second->SetFreezeCut(!isFrozen); });
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Keys::ColorBy(vtkMTInteractorStyle* self, const char* name)
{
  self->Implementation->Colors.Select(name);
  self->Message.clear();
}

void vtkMTInteractorStyle::Keys::NextArray(vtkMTInteractorStyle* self, int step)
{
  vtkMTColorSelector& colors = self->Implementation->Colors;
  colors.SelectNext(step);
  self->Message = colors.GetSelected().empty() ? "colours of the data" : "coloured by " + colors.GetTitle();
}

void vtkMTInteractorStyle::Keys::NextComponent(vtkMTInteractorStyle* self)
{
  self->Implementation->Colors.SelectNextComponent();
}

void vtkMTInteractorStyle::Keys::ToggleTextures(vtkMTInteractorStyle* self)
{
  vtkMTColorSelector& colors = self->Implementation->Colors;
  colors.SetShowTextures(!colors.GetShowTextures());
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Keys::SetRepresentation(vtkMTInteractorStyle* self, int representation)
{
  ForAllProperties(
    self->GetRenderer(), [representation](vtkProperty* property) { property->SetRepresentation(representation); });
}

void vtkMTInteractorStyle::Keys::ToggleEdges(vtkMTInteractorStyle* self)
{
  ForAllProperties(
    self->GetRenderer(), [](vtkProperty* property) { property->SetEdgeVisibility(!property->GetEdgeVisibility()); });
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::Keys::ToggleRecording(vtkMTInteractorStyle* self)
{
  if (self->GetRecording())
  {
    self->StopRecording();
  }
  else
  {
    self->StartRecording();
  }
}

void vtkMTInteractorStyle::Keys::TogglePlaying(vtkMTInteractorStyle* self)
{
  if (self->GetPlaying())
  {
    self->StopPlaying();
  }
  else
  {
    self->StartPlaying();
  }
}

void vtkMTInteractorStyle::Keys::AddView(vtkMTInteractorStyle* self)
{
  vtkMTCameraPath* path = self->GetCameraPath();
  const double time = path->GetNumberOfViews() > 0 ? path->GetLastTime() + SecondsBetweenViews : 0.0;
  const bool isAdded = !self->GetRecording() && path->AddView(time, self->GetRenderer()->GetActiveCamera());
  self->Message = isAdded ? "the camera path has " + std::to_string(path->GetNumberOfViews()) + " views"
                          : "no view was added: " + path->GetErrorMessage();
}

void vtkMTInteractorStyle::Keys::WritePath(vtkMTInteractorStyle* self)
{
  self->WritePath();
}

void vtkMTInteractorStyle::Keys::ForgetPath(vtkMTInteractorStyle* self)
{
  self->StopPlaying();
  self->Implementation->IsRecording = false;
  self->Implementation->Path = vtkSmartPointer<vtkMTCameraPath>::New();
  self->Message = "the camera path is empty";
}

void vtkMTInteractorStyle::Keys::Quit(vtkMTInteractorStyle* self)
{
  if (self->Interactor)
  {
    self->Interactor->ExitCallback();
  }
}

//------------------------------------------------------------------------------
bool vtkMTInteractorStyle::PressKey(const char* key)
{
  const std::string name = key ? key : "";
  const auto found =
    std::find_if(Keys::Table.begin(), Keys::Table.end(), [&name](const Keys::Key& each) { return name == each.Name; });
  if (found == Keys::Table.end() || !this->GetRenderer())
  {
    return false;
  }
  found->Do(this);
  if (found->Do != &Keys::Quit)
  {
    this->RenderAll();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkMTInteractorStyle::GetKeys()
{
  std::string text;
  for (const Keys::Key& key : Keys::Table)
  {
    if (key.Shown)
    {
      char line[160];
      std::snprintf(line, sizeof(line), "%-12s %s", key.Shown, key.Text);
      text += (text.empty() ? "" : "\n") + std::string(line);
    }
  }
  return text;
}

//------------------------------------------------------------------------------
// Keys without a character, and those with a modifier.
void vtkMTInteractorStyle::OnKeyPress()
{
  const std::string name = GetShort(this->Interactor->GetKeySym());
  const std::string modifier = this->Interactor->GetControlKey() ? "Control+"
    : this->Interactor->GetShiftKey()                            ? "Shift+"
                                                                 : "";
  if (name.size() < 2 || !this->PressKey((modifier + name).c_str()))
  {
    this->Superclass::OnKeyPress();
  }
}

//------------------------------------------------------------------------------
void vtkMTInteractorStyle::OnChar()
{
  const char name[2] = { this->Interactor->GetKeyCode(), '\0' };
  if (!this->PressKey(name))
  {
    this->Superclass::OnChar();
  }
}
