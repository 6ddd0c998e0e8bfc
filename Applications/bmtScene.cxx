// SPDX-License-Identifier: BSD-3-Clause
#include "bmtScene.h"

#include "bmtModel.h"

#include "vtkMTCameraPathFile.h"
#include "vtkMTDisplay.h"
#include "vtkMTFrameFigures.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace
{
using Mapper = vtkMultiTriangulationMapper;
// WIDTHxHEIGHT into two numbers; a message for CLI11 when it is something else.
std::string ParseSize(const std::string& text, std::array<int, 2>& size)
{
  int used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &size[0], &size[1], &used) == 2 && text[used] == '\0' && size[0] > 0 &&
    size[1] > 0 && size[0] <= 16384 && size[1] <= 16384)
  {
    return "";
  }
  return "'" + text + "' is no size such as 1024x768";
}

}

void bmtAddSceneOptions(CLI::App& command, bmtSceneOptions& options)
{
  command
    .add_option_function<std::string>(
      "--size",
      [&options](const std::string& text)
      {
        const std::string problem = ParseSize(text, options.Size);
        if (!problem.empty())
        {
          throw CLI::ValidationError("--size", problem);
        }
      },
      "Size of the picture in pixels, as WIDTHxHEIGHT")
    ->default_str("1024x768")
    ->type_name("WxH");
  command
    .add_option("--camera", options.Camera,
      "Position, focal point and view up: px,py,pz,fx,fy,fz,ux,uy,uz; without it the whole model is seen")
    ->delimiter(',')
    ->expected(9)
    ->type_name("FLOAT,...");
  command.add_option("--view-angle", options.ViewAngle, "Vertical view angle in degrees")
    ->check(CLI::Range(0.001, 179.0))
    ->capture_default_str();
  command
    .add_option(
      "--pixel-error", options.PixelError, "How far the picture of the surface may be from the input's, in pixels")
    ->check(CLI::Range(0.0, 1e9))
    ->capture_default_str();
  command.add_option("--metric", options.Metric, "The error: distance (certified), edges (mean length) or normals")
    ->check(CLI::IsMember({ "distance", "edges", "normals" }))
    ->capture_default_str();
  command.add_option("--budget", options.Budget, "Triangles drawn at most; 0: no limit")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command.add_option("--color-by", options.ColorBy, "level, patch, error, or the name of a point or cell array");
  command.add_option(
    "--texture", options.Texture, "An image (PNG, JPEG) for the whole mesh, by its texture coordinates");
}

bmtScene::bmtScene(const bmtSceneOptions& options)
  : Options(options)
{
  vtkMTCameraView view;
  const std::vector<double>& c = options.Camera;
  if (!c.empty())
  {
    view.Position = { c[0], c[1], c[2] };
    view.FocalPoint = { c[3], c[4], c[5] };
    view.ViewUp = { c[6], c[7], c[8] };
  }
  view.ViewAngle = options.ViewAngle;
  if (const std::string problem = view.FindProblem(); !problem.empty())
  {
    throw bmtError("--camera: " + problem);
  }
  this->Models = std::make_unique<vtkMTScene>(this->Renderer, view, !c.empty());
  this->Renderer->SetBackground(0.32, 0.34, 0.43);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetSize(options.Size[0], options.Size[1]);
  this->Window->SetWindowName("bmt");
}

void bmtScene::RequireDisplay() const
{
  if (const std::string problem = vtkMTDisplay::FindProblem(this->Window); !problem.empty())
  {
    throw bmtError(problem + "; without a screen run it as xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" bmt ...");
  }
}

void bmtScene::ShowModel(std::size_t item, const std::string& path)
{
  if (std::string error; !this->Models->ShowModel(item, bmtOpenModel(path), path, this->Options.Texture, error))
  {
    throw bmtError(error);
  }
  Mapper* mapper = this->Models->GetItems()[item]->Mapper;
  mapper->SetPixelError(this->Options.PixelError);
  const int other = this->Options.Metric == "edges" ? Mapper::EDGE_LENGTH : Mapper::DISTANCE;
  mapper->SetErrorMetric(this->Options.Metric == "normals" ? Mapper::NORMAL_DEVIATION : other);
  mapper->SetTriangleLimit(this->Options.Budget);
}

void bmtScene::RequireColors(const std::string& name)
{
  vtkMTColorSelector colors;
  colors.SetRenderer(this->Renderer);
  if (!colors.Select(name))
  {
    throw bmtError("--color-by " + name + ": no such array; there are " + colors.DescribeNames());
  }
}

bmtJson bmtScene::DescribeFrame() const
{
  const vtkMTFrameFigures figures = vtkMTFrameFigures::Find(this->Renderer);
  bmtJson json;
  json["triangles"] = figures.Triangles;
  json["patches"] = figures.Patches;
  json["culled_patches"] = figures.CulledPatches;
  json["pixel_error"] = figures.PixelError; // null where it has no bound
  json["converged"] = figures.IsConverged;
  json["cut_ms"] = 1e3 * figures.CutTime;
  json["texture_problems"] = bmtJson::array();
  for (const auto& item : this->Models->GetItems())
  {
    for (const std::string& problem : item->GetTextureProblems())
    {
      json["texture_problems"].push_back(problem);
    }
  }
  return json;
}
