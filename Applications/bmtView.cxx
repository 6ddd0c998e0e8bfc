// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace
{
const char* const Keys = "f       freeze the cut, or let it follow the camera again\n"
                         "l p d   colour by level, by patch, by deviation (blue none, red all that is allowed)\n"
                         "n       colours of the data again\n"
                         "+ -     halve or double the pixel error\n"
                         "w s     wireframe, surface\n"
                         "r       see the whole model\n"
                         "h       show or hide these keys\n"
                         "q       quit";

// The line of figures is drawn in a layer of its own, after the model: its figures are those of the frame in which it
// is seen.
class Figures
{
public:
  explicit Figures(bmtScene& scene)
    : Scene(scene)
  {
    scene.Window->SetNumberOfLayers(2);
    this->Overlay->SetLayer(1);
    this->Overlay->InteractiveOff();
    this->Text->GetTextProperty()->SetFontSize(15);
    this->Text->GetTextProperty()->SetFontFamilyToCourier();
    this->Text->SetPosition(10, 10);
    this->Overlay->AddActor2D(this->Text);
    scene.Window->AddRenderer(this->Overlay);
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Figures*>(self)->Update(); });
    scene.Renderer->AddObserver(vtkCommand::EndEvent, this->Command);
  }

  ~Figures() { this->Scene.Renderer->RemoveObserver(this->Command); }

  bool ShowKeys = false;

private:
  void Update()
  {
    vtkMultiTriangulationMapper* mapper = this->Scene.Mapper;
    char line[300];
    std::snprintf(line, sizeof(line),
      "%lld triangles  %lld patches  error %.2f of %.2f pixels  cut %.1f ms  frame %.1f ms%s",
      static_cast<long long>(mapper->GetNumberOfTriangles()), static_cast<long long>(mapper->GetNumberOfPatches()),
      mapper->GetAchievedPixelError(), mapper->GetPixelError(), 1e3 * mapper->GetCutTime(),
      1e3 * this->Scene.Renderer->GetLastRenderTimeInSeconds(), mapper->GetFreezeCut() ? "  FROZEN" : "");
    this->Text->SetInput((std::string(line) + (this->ShowKeys ? std::string("\n") + Keys : "  (h: keys)")).c_str());
  }

  bmtScene& Scene;
  vtkNew<vtkRenderer> Overlay;
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkCallbackCommand> Command;
};

class Style : public vtkInteractorStyleTrackballCamera
{
public:
  static Style* New();
  vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera);

  void SetUp(bmtScene* scene, Figures* figures, const std::string& colorBy)
  {
    this->Scene = scene;
    this->Shown = figures;
    this->DataColors = colorBy == "level" || colorBy == "patch" || colorBy == "error" ? "" : colorBy;
  }

  void OnChar() override
  {
    if (this->HandleKey(this->Interactor->GetKeyCode()))
    {
      this->Interactor->Render();
    }
    else
    {
      this->Superclass::OnChar(); // r, w, s, q and the rest of VTK's keys
    }
  }

  void OnTimer() override
  {
    this->Superclass::OnTimer();
    if (bmtIsInterrupted())
    {
      this->Interactor->TerminateApp();
    }
  }

private:
  bool HandleKey(char key)
  {
    vtkMultiTriangulationMapper* mapper = this->Scene->Mapper;
    switch (key)
    {
      case 'f':
        mapper->SetFreezeCut(!mapper->GetFreezeCut());
        return true;
      case 'l':
      case 'p':
      case 'd':
        this->Scene->SetColorBy(key == 'l' ? "level" : key == 'p' ? "patch" : "error");
        return true;
      case 'n':
        this->Scene->SetColorBy(this->DataColors);
        return true;
      case '+':
      case '=':
        mapper->SetPixelError(std::max(0.5 * mapper->GetPixelError(), 0.01));
        return true;
      case '-':
        mapper->SetPixelError(std::min(2.0 * mapper->GetPixelError(), 1000.0));
        return true;
      case 'h':
        this->Shown->ShowKeys = !this->Shown->ShowKeys;
        return true;
      default:
        return false;
    }
  }

  bmtScene* Scene = nullptr;
  Figures* Shown = nullptr;
  std::string DataColors;
};
vtkStandardNewMacro(Style);

bmtJson View(const bmtSceneOptions& options)
{
  bmtScene scene(options);
  scene.RequireDisplay();
  Figures figures(scene);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  vtkNew<Style> style;
  style->SetUp(&scene, &figures, options.ColorBy);
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  interactor->CreateRepeatingTimer(200); // looks whether Ctrl-C was pressed
  scene.Window->Render();
  if (!bmtIsInterrupted())
  {
    interactor->Start();
  }
  bmtThrowIfInterrupted();
  bmtJson result = scene.DescribeFrame();
  interactor->SetRenderWindow(nullptr);
  return result;
}
}

void bmtAddView(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<bmtSceneOptions>();
  CLI::App* command = app.add_subcommand("view", "Look at a Multi-Triangulation in a window");
  command->footer(
    std::string(
      "Turn with the left mouse button, move with the middle one, zoom with the right one or the wheel. Keys:\n") +
    Keys + "\nThe figures of the last frame are printed at the end.");
  bmtAddSceneOptions(*command, *options);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, View(*options));
        return bmtExit::Success;
      };
    });
}
