// SPDX-License-Identifier: BSD-3-Clause
// What drawing a cut costs beside one vtkPolyDataMapper with the same triangles in one polydata:
//   draw_cost MODEL [--frames N] [--size WIDTH HEIGHT] [--pixel-error E] [--json]
// Both mappers are in one window; only one of them is visible in a frame, turn by turn, while the camera goes around
// the model. The cut is that of the first view and is frozen, so both draw the same triangles. A frame's time runs from
// the call of Render until OpenGL is done; "outside drawing" is what our mapper does in a frame besides its draw calls.
// In the state "still" the camera stays where it is. Medians of N frames each (default 60), for several states of the
// actor; the CPU time of all threads too, which says more where the CPU draws and has other work to do.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string Model;
  int Frames = 60;
  int Size[2] = { 1024, 768 };
  double PixelError = 1.0;
  bool Json = false;
};

bool Parse(int argc, char** argv, Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const auto next = [&]() { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--frames")
    {
      options.Frames = std::atoi(next());
    }
    else if (word == "--size")
    {
      options.Size[0] = std::atoi(next());
      options.Size[1] = std::atoi(next());
    }
    else if (word == "--pixel-error")
    {
      options.PixelError = std::atof(next());
    }
    else if (word == "--json")
    {
      options.Json = true;
    }
    else
    {
      options.Model = word;
    }
  }
  return !options.Model.empty() && options.Frames > 0 && options.Size[0] > 0 && options.Size[1] > 0;
}

double GetMedian(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

struct State
{
  const char* Name;
  std::function<void(vtkMapper*, vtkActor*)> Apply;
  bool Still = false; // the camera does not move
};

std::vector<State> GetStates(vtkPolyData* mesh)
{
  std::vector<State> states;
  states.push_back({ "smooth", [](vtkMapper* mapper, vtkActor*) { mapper->ScalarVisibilityOff(); } });
  states.push_back({ "still", [](vtkMapper*, vtkActor*) {}, true });
  states.push_back({ "flat", [](vtkMapper*, vtkActor* actor) { actor->GetProperty()->SetInterpolationToFlat(); } });
  states.push_back({ "edges",
    [](vtkMapper*, vtkActor* actor)
    {
      actor->GetProperty()->SetInterpolationToPhong();
      actor->GetProperty()->EdgeVisibilityOn();
    } });
  const auto add = [&](const char* state, vtkFieldData* data, bool cells)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName())
      {
        const std::string name = array->GetName();
        double range[2];
        array->GetRange(range, 0);
        states.push_back({ state,
          [=](vtkMapper* mapper, vtkActor* actor)
          {
            actor->GetProperty()->EdgeVisibilityOff();
            mapper->ScalarVisibilityOn();
            cells ? mapper->SetScalarModeToUseCellFieldData() : mapper->SetScalarModeToUsePointFieldData();
            mapper->SelectColorArray(name.c_str());
            mapper->SetScalarRange(range[0], range[1]);
          } });
        return;
      }
    }
  };
  add("point scalars", mesh->GetPointData(), false);
  add("cell scalars", mesh->GetCellData(), true);
  return states;
}

double GetCpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Of frames; seconds.
struct Times
{
  std::vector<double> Wall;
  std::vector<double> Cpu;
  std::vector<double> Outside; // what our mapper does besides drawing

  void Draw(vtkRenderWindow* window)
  {
    const double cpu = GetCpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    window->Render();
    window->WaitForCompletion();
    this->Wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    this->Cpu.push_back(GetCpuSeconds() - cpu);
  }
};

struct Scene
{
  vtkNew<vtkMultiTriangulationMapper> Ours;
  vtkNew<vtkPolyDataMapper> Theirs;
  vtkNew<vtkActor> Actors[2];
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void Report(const char* state, vtkMultiTriangulationMapper* mapper, const Times times[2], bool json)
{
  const double ours = 1e3 * GetMedian(times[0].Wall);
  const double theirs = 1e3 * GetMedian(times[1].Wall);
  const double cpu = 1e3 * GetMedian(times[0].Cpu);
  const double theirCpu = 1e3 * GetMedian(times[1].Cpu);
  const double outside = 1e3 * GetMedian(times[0].Outside);
  const char* format = json
    ? "{\"state\": \"%s\", \"triangles\": %lld, \"patches\": %lld, \"mapper_ms\": %.3f, \"polydata_mapper_ms\": %.3f, "
      "\"ratio\": %.3f, \"mapper_cpu_ms\": %.3f, \"polydata_mapper_cpu_ms\": %.3f, \"cpu_ratio\": %.3f, "
      "\"outside_drawing_ms\": %.3f}\n"
    : "%-14s %9lld triangles %6lld patches: %8.2f ms, vtkPolyDataMapper %8.2f ms, ratio %.3f; CPU %8.2f and %8.2f ms, "
      "ratio %.3f; outside drawing %.3f ms\n";
  std::printf(format, state, static_cast<long long>(mapper->GetNumberOfTriangles()),
    static_cast<long long>(mapper->GetNumberOfPatches()), ours, theirs, ours / theirs, cpu, theirCpu, cpu / theirCpu,
    outside);
}

void Measure(Scene& scene, const State& state, const Options& options)
{
  state.Apply(scene.Ours, scene.Actors[0]);
  state.Apply(scene.Theirs, scene.Actors[1]);
  Times times[2];
  constexpr int WarmUp = 3;
  for (int frame = -WarmUp; frame < options.Frames; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(state.Still ? 0.0 : 7.0);
    scene.Renderer->ResetCameraClippingRange();
    if (frame == 0)
    {
      times[0] = times[1] = Times();
    }
    for (int turn = 0; turn < 2; ++turn)
    {
      const int who = (frame + turn) & 1;
      scene.Actors[who]->VisibilityOn();
      scene.Actors[1 - who]->VisibilityOff();
      times[who].Draw(scene.Window);
      if (who == 0)
      {
        times[0].Outside.push_back(scene.Ours->GetOverheadTime());
      }
    }
  }
  Report(state.Name, scene.Ours, times, options.Json);
}
}

int main(int argc, char** argv)
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::fprintf(stderr, "usage: draw_cost MODEL [--frames N] [--size WIDTH HEIGHT] [--pixel-error E] [--json]\n");
    return 2;
  }
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(options.Model.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    return 1;
  }

  Scene scene;
  scene.Ours->SetInputConnection(reader->GetOutputPort());
  scene.Ours->SetPixelError(options.PixelError);
  scene.Ours->ScalarVisibilityOff();
  scene.Actors[0]->SetMapper(scene.Ours);
  scene.Actors[1]->SetMapper(scene.Theirs);
  scene.Renderer->AddActor(scene.Actors[0]);
  scene.Window->SetOffScreenRendering(1);
  scene.Window->SetMultiSamples(0);
  scene.Window->SetSize(options.Size);
  scene.Window->AddRenderer(scene.Renderer);
  scene.Renderer->ResetCamera();
  scene.Window->Render();
  scene.Ours->FreezeCutOn();
  vtkNew<vtkPolyData> mesh;
  if (!scene.Ours->GetCut(mesh))
  {
    return 1;
  }
  scene.Theirs->SetInputData(mesh);
  scene.Renderer->AddActor(scene.Actors[1]);
  for (const State& state : GetStates(mesh))
  {
    Measure(scene, state, options);
  }
  return 0;
}
