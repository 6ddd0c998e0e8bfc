// SPDX-License-Identifier: BSD-3-Clause
#include "bmtInput.h"
#include "bmtScene.h"

#include "vtkMTBackgroundBuild.h"
#include "vtkMTCameraPath.h"
#include "vtkMTFileSource.h"
#include "vtkMTInteractorStyle.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <thread>

namespace
{
struct ViewOptions : bmtSceneOptions
{
  bmtInput Input; // its paths are the files, each of which is an input of its own
  std::string Output;
  std::string Path;
  double FrameRate = 30.0;
  std::string Frames;
  std::string Screenshots = "bmt";
  std::string Paths = "bmt-path";
  std::string Keys;
  bool OffScreen = false;
};

std::vector<vtkMTInputSettings> FindMeshes(const ViewOptions& options, std::vector<std::size_t>& places)
{
  std::vector<vtkMTInputSettings> meshes;
  for (std::size_t i = 0; i < options.Input.Paths.size(); ++i)
  {
    const std::string& path = options.Input.Paths[i];
    if (!std::filesystem::exists(path))
    {
      throw bmtError(path + ": there is no such file");
    }
    if (!vtkMTFileSource::CanRead(path))
    {
      meshes.push_back(options.Input);
      meshes.back().Paths = { path };
      places.push_back(i);
    }
  }
  if (!options.Output.empty() && meshes.size() != 1)
  {
    throw bmtError(
      "--output is the model of one mesh, but " + std::to_string(meshes.size()) + " of the files are meshes");
  }
  return meshes;
}

class Viewer
{
public:
  explicit Viewer(const ViewOptions& options)
    : Settings(options)
    , Scene(options)
  {
    const std::vector<vtkMTInputSettings> meshes = FindMeshes(options, this->Meshes);
    if (std::string error; !this->Build.Start(meshes, options.Output, error)) // before there are threads and a window
    {
      throw bmtError(error);
    }
    this->Scene.RequireDisplay();
    for (std::size_t i = 0; i < options.Input.Paths.size(); ++i)
    {
      this->Scene.Models->AddItem();
      if (std::find(this->Meshes.begin(), this->Meshes.end(), i) == this->Meshes.end())
      {
        this->Scene.ShowModel(i, options.Input.Paths[i]);
      }
    }
    if (!options.Path.empty() && !this->Path->Read(options.Path.c_str()))
    {
      throw bmtError(this->Path->GetErrorMessage());
    }
    this->Style->SetRenderer(this->Scene.Renderer);
    this->Style->SetCameraPath(this->Path);
    this->Style->SetFrameRate(options.FrameRate);
    this->Style->SetScreenshotPrefix(options.Screenshots.c_str());
    this->Style->SetPathPrefix(options.Paths.c_str());
    this->ApplyColors();
  }

  bmtJson Run()
  {
    this->Settings.OffScreen ? this->RunOffScreen() : this->RunWindow();
    bmtThrowIfInterrupted();
    if (!this->Failure.empty())
    {
      throw bmtError(this->Failure);
    }
    bmtJson result = this->Scene.DescribeFrame();
    result["files"] = this->Settings.Input.Paths;
    result["frames"] = this->Frames;
    return result;
  }

private:
  // What is asked for at the start; later the keys say.
  void ApplyColors()
  {
    if (this->IsColored)
    {
      this->Style->ColorsChanged();
      return;
    }
    this->IsColored = this->Style->SetColorBy(this->Settings.ColorBy.c_str());
    if (!this->IsColored && !this->Build.IsRunning())
    {
      this->Scene.RequireColors(this->Settings.ColorBy);
    }
  }

  void Take(const vtkMTBuildEvent& event)
  {
    const std::size_t item = this->Meshes[event.Index];
    const std::string name = std::filesystem::path(this->Settings.Input.Paths[item]).filename().string();
    switch (event.Kind)
    {
      case vtkMTBuildEvent::Preview:
        this->Scene.Models->ShowPreview(item, event.Mesh);
        break;
      case vtkMTBuildEvent::Model:
        this->State.clear();
        this->Scene.ShowModel(item, event.Text);
        this->ApplyColors();
        break;
      case vtkMTBuildEvent::Progress:
        this->State = name + ": " + event.Text;
        break;
      case vtkMTBuildEvent::Failure:
        this->State.clear();
        this->Failure += (this->Failure.empty() ? "" : "\n") + event.Text + bmtGetAdvice(event.Code);
    }
  }

  // What the background build has done since: into the picture. Then the keys that wait for all that is to be seen.
  void Poll()
  {
    const std::vector<vtkMTBuildEvent> events = this->Build.Poll();
    for (const vtkMTBuildEvent& event : events)
    {
      this->Take(event);
    }
    if (!events.empty())
    {
      const bool areBoth = !this->Failure.empty() && !this->State.empty();
      this->Style->SetStatus((this->Failure + (areBoth ? "\n" : "") + this->State).c_str());
      this->Scene.Window->Render();
    }
    if (!this->IsStarted && (this->Scene.Models->IsAllSeen() || !this->Build.IsRunning()))
    {
      this->IsStarted = true;
      for (const char key : this->Settings.Keys)
      {
        this->Style->PressKey(std::string(1, key).c_str());
      }
    }
  }

  void RunOffScreen()
  {
    this->Scene.Window->OffScreenRenderingOn();
    this->Scene.Window->Render();
    do
    {
      this->Poll();
      bmtThrowIfInterrupted();
      std::this_thread::sleep_for(std::chrono::milliseconds(this->Build.IsRunning() ? 20 : 0));
    } while (this->Build.IsRunning());
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback([](vtkObject* style, unsigned long, void*, void*)
      { bmtIsInterrupted() ? static_cast<vtkMTInteractorStyle*>(style)->StopPlaying() : void(); });
    this->Style->AddObserver(vtkCommand::AbortCheckEvent, command);
    this->Frames = this->Settings.Path.empty() ? 0 : this->Style->RenderPath(this->Settings.Frames.c_str());
    if (this->Frames < 0)
    {
      throw bmtError(this->Style->GetMessage());
    }
  }

  void RunWindow()
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(this->Scene.Window);
    interactor->SetInteractorStyle(this->Style);
    interactor->Initialize();
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<Viewer*>(self)->OnTimer(static_cast<vtkRenderWindowInteractor*>(caller)); });
    interactor->AddObserver(vtkCommand::TimerEvent, command);
    interactor->CreateRepeatingTimer(100); // looks whether Ctrl-C was pressed, and what has been built
    this->Scene.Window->Render();
    if (!this->Settings.Path.empty())
    {
      this->Style->StartPlaying();
    }
    interactor->Start();
    this->Style->StopPlaying();
    interactor->SetInteractorStyle(nullptr);
    interactor->SetRenderWindow(nullptr);
    if (this->Problem)
    {
      std::rethrow_exception(this->Problem); // which must not pass through VTK's event loop
    }
  }

  void OnTimer(vtkRenderWindowInteractor* interactor)
  {
    try
    {
      this->Poll();
    }
    catch (...)
    {
      this->Problem = std::current_exception();
    }
    if (bmtIsInterrupted() || this->Problem)
    {
      interactor->TerminateApp();
    }
  }

  const ViewOptions& Settings;
  std::vector<std::size_t> Meshes; // which of the files they are
  vtkMTBackgroundBuild Build;
  bmtScene Scene;
  vtkNew<vtkMTCameraPath> Path;
  vtkNew<vtkMTInteractorStyle> Style; // after the window that it writes into
  std::string State;                  // of the mesh that is being built
  std::string Failure;                // of those that cannot be
  bool IsColored = false;
  bool IsStarted = false;
  int Frames = 0;
  std::exception_ptr Problem;
};

void AddOptions(CLI::App& command, ViewOptions& options)
{
  command
    .add_option("FILE", options.Input.Paths, "Multi-Triangulation files, and meshes, which are built in the background")
    ->required();
  bmtAddSceneOptions(command, options);
  bmtAddInputOptions(command, options.Input);
  command.add_option("-o,--output", options.Output,
    "Of one mesh: keep the model here; a later call opens it at once, or goes on building. Without it: nothing is "
    "kept");
  CLI::Option* play = command.add_option("--play", options.Path, "A camera path to play (.csv)");
  command.add_option("--frame-rate", options.FrameRate, "Frames per second of playing")
    ->check(CLI::Range(1.0, 240.0))
    ->capture_default_str();
  CLI::Option* offScreen =
    command.add_flag("--off-screen", options.OffScreen, "No window: wait for models, play the path and end");
  command.add_option("--frames", options.Frames, "Off screen: every frame of the path as PREFIX-0001.png and so on")
    ->needs(play)
    ->needs(offScreen);
  command.add_option("--screenshots", options.Screenshots, "Screenshots are PREFIX-0001.png and so on")
    ->capture_default_str();
  command.add_option("--paths", options.Paths, "Recorded camera paths are PREFIX-0001.csv and so on")
    ->capture_default_str();
  command.add_option("--keys", options.Keys, "Keys to press as soon as something of every file is seen");
}
}

void bmtAddView(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "Look at Multi-Triangulations and meshes in a window");
  command->footer(
    "Turn with the left mouse button, move with the middle one, zoom with the right one or the wheel. Keys:\n" +
    vtkMTInteractorStyle::GetKeys() + "\nThe figures of the last frame are printed at the end.");
  AddOptions(*command, *options);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Viewer(*options).Run());
        return bmtExit::Success;
      };
    });
}
