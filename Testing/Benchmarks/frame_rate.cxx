// SPDX-License-Identifier: BSD-3-Clause
// Whether frames take the time that a window's DesiredUpdateRate asks for:
//   frame_rate MODEL [--rates R,R,...] [--frames N] [--size WIDTH HEIGHT] [--pixel-error E] [--on-screen] [--finish]
//              [--others TRIANGLES] [--json]
// The camera goes around the model, in a plain loop of Render without an interactor, a window for each rate (default 5,
// 10, 30 and 60 frames per second). A frame's time runs from one call of Render to the next one, with the camera's
// move, or, with --finish, until OpenGL is done, which a loop that shows frames does not wait for. The first third of
// the frames (default 150) is left out of the figures: rates are the inverse of the median, of the quickest and the
// slowest tenth. --others: a polydata sphere of so many triangles is drawn beside the model. "outside drawing" is
// what the mapper does besides its draw calls: cut, uploads, bookkeeping. "without" is the rate of the coarsest cut, so
// the most that could be asked for.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationReader.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string Model;
  std::vector<double> Rates{ 5.0, 10.0, 30.0, 60.0 };
  int Frames = 150;
  int Size[2] = { 1024, 768 };
  double PixelError = 0.0;
  bool OnScreen = false;
  bool Finish = false;
  int Others = 0;
  bool Json = false;
};

std::vector<double> GetNumbers(const char* text)
{
  std::vector<double> numbers;
  char* end = nullptr;
  for (double number = std::strtod(text, &end); end != text; number = std::strtod(text, &end))
  {
    numbers.push_back(number);
    text = *end == ',' ? end + 1 : end;
  }
  return numbers;
}

bool Parse(int argc, char** argv, Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const auto next = [&]() { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--rates")
    {
      options.Rates = GetNumbers(next());
    }
    else if (word == "--frames")
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
    else if (word == "--others")
    {
      options.Others = std::atoi(next());
    }
    else if (word == "--on-screen" || word == "--finish" || word == "--json")
    {
      (word == "--json" ? options.Json : word == "--finish" ? options.Finish : options.OnScreen) = true;
    }
    else
    {
      options.Model = word;
    }
  }
  const bool positive = std::all_of(options.Rates.begin(), options.Rates.end(), [](double r) { return r > 0.0; });
  return !options.Model.empty() && positive && options.Frames >= 30 && options.Size[0] > 0 && options.Size[1] > 0;
}

struct Scene
{
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkPolyDataMapper> OtherMapper;
  vtkNew<vtkActor> OtherActor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;

  Scene(vtkMultiTriangulationReader* reader, const Options& options)
  {
    this->Mapper->SetInputConnection(reader->GetOutputPort());
    this->Mapper->SetPixelError(options.PixelError);
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    if (options.Others > 0)
    {
      const int resolution = std::max(static_cast<int>(std::sqrt(0.5 * options.Others)), 4);
      const double* bounds = this->Actor->GetBounds();
      this->Sphere->SetThetaResolution(resolution);
      this->Sphere->SetPhiResolution(resolution);
      this->Sphere->SetRadius(0.3 * (bounds[1] - bounds[0]));
      this->Sphere->SetCenter(bounds[1] + 0.3 * (bounds[1] - bounds[0]), bounds[2], bounds[4]);
      this->OtherMapper->SetInputConnection(this->Sphere->GetOutputPort());
      this->OtherActor->SetMapper(this->OtherMapper);
      this->Renderer->AddActor(this->OtherActor);
    }
    this->Window->SetOffScreenRendering(options.OnScreen ? 0 : 1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(options.Size[0], options.Size[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
  }
};

double GetShare(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Frames' seconds and triangles, without the first third.
struct Flight
{
  std::vector<double> Seconds;
  std::vector<double> Triangles;
  std::vector<double> Overhead; // seconds of the mapper besides draw calls

  Flight(Scene& scene, const Options& options)
  {
    auto last = std::chrono::steady_clock::now();
    for (int frame = 0; frame < options.Frames; ++frame)
    {
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      scene.Renderer->ResetCameraClippingRange();
      scene.Window->Render();
      if (options.Finish)
      {
        scene.Window->WaitForCompletion();
      }
      const auto now = std::chrono::steady_clock::now();
      if (frame >= options.Frames / 3)
      {
        this->Seconds.push_back(std::chrono::duration<double>(now - last).count());
        this->Triangles.push_back(static_cast<double>(scene.Mapper->GetNumberOfTriangles()));
        this->Overhead.push_back(scene.Mapper->GetOverheadTime());
      }
      last = now;
    }
    scene.Window->WaitForCompletion();
  }
};

double GetMostRate(vtkMultiTriangulationReader* reader, const Options& options)
{
  Scene scene(reader, options);
  scene.Mapper->SetTriangleLimit(1);
  return 1.0 / GetShare(Flight(scene, options).Seconds, 0.5);
}

void Measure(vtkMultiTriangulationReader* reader, const Options& options, double asked, double most)
{
  Scene scene(reader, options);
  scene.Window->SetDesiredUpdateRate(asked);
  const Flight flight(scene, options);
  const char* format = options.Json
    ? "{\"asked\": %g, \"median\": %.2f, \"slowest_tenth\": %.2f, \"quickest_tenth\": %.2f, \"ratio\": %.3f, "
      "\"triangles\": %.0f, \"outside_drawing_ms\": %.2f, \"without\": %.1f}\n"
    : "asked %4g frames/s: median %6.2f, slowest tenth %6.2f, quickest tenth %6.2f, ratio %.3f; %9.0f triangles; "
      "outside drawing %.2f ms; without %.1f frames/s\n";
  const double median = 1.0 / GetShare(flight.Seconds, 0.5);
  std::printf(format, asked, median, 1.0 / GetShare(flight.Seconds, 0.9), 1.0 / GetShare(flight.Seconds, 0.1),
    median / asked, GetShare(flight.Triangles, 0.5), 1e3 * GetShare(flight.Overhead, 0.5), most);
}
}

int main(int argc, char** argv)
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::fprintf(stderr,
      "usage: frame_rate MODEL [--rates R,R,...] [--frames N] [--size WIDTH HEIGHT] [--pixel-error E] [--on-screen] "
      "[--finish] [--others TRIANGLES] [--json]\n");
    return 2;
  }
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(options.Model.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    return 1;
  }
  const double most = GetMostRate(reader, options);
  for (const double rate : options.Rates)
  {
    Measure(reader, options, rate, most);
  }
  return 0;
}
