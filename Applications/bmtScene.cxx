// SPDX-License-Identifier: BSD-3-Clause
#include "bmtScene.h"

#include "bmtModel.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMTDisplay.h"
#include "vtkMTDrawableScale.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

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

std::string CheckCamera(const std::vector<double>& c)
{
  const double direction[3] = { c[3] - c[0], c[4] - c[1], c[5] - c[2] };
  double side[3];
  vtkMath::Cross(direction, &c[6], side);
  const bool isFinite = std::all_of(c.begin(), c.end(), [](double x) { return std::isfinite(x); });
  if (isFinite && vtkMath::Norm(side) > 1e-9 * vtkMath::Norm(direction) * vtkMath::Norm(&c[6]))
  {
    return "";
  }
  return "the camera's position, focal point and view up do not make a view; position and focal point must differ, and "
         "view up must not point along the view";
}
}

void bmtAddSceneOptions(CLI::App& command, bmtSceneOptions& options)
{
  bmtAddModelArgument(command, options.File);
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
{
  if (!this->Model->SetSource(bmtOpenModel(options.File)))
  {
    throw bmtError(options.File + ": its coarsest patches cannot be read; 'bmt verify' says more");
  }
  double bounds[6];
  this->Model->GetModelBounds(bounds);
  if (const std::string problem = vtkMTDrawableScale::FindProblem(bounds); !problem.empty())
  {
    throw bmtError(options.File + " cannot be drawn: " + problem);
  }
  this->Textures = vtkMTModelTextures::Read(*this->Model->GetSource());
  if (std::string error; !options.Texture.empty() && !this->Textures.ReplaceByFile(options.Texture, error))
  {
    throw bmtError(error);
  }
  this->Mapper->SetInputDataObject(this->Model);
  this->Mapper->SetPixelError(options.PixelError);
  const int other = options.Metric == "edges" ? Mapper::EDGE_LENGTH : Mapper::DISTANCE;
  this->Mapper->SetErrorMetric(options.Metric == "normals" ? Mapper::NORMAL_DEVIATION : other);
  this->Mapper->SetTriangleLimit(options.Budget);
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(0.32, 0.34, 0.43);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetSize(options.Size[0], options.Size[1]);
  this->Window->SetWindowName("bmt");
  this->SetColorBy(options.ColorBy);
  this->SetCamera(options);
}

void bmtScene::SetCamera(const bmtSceneOptions& options)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetViewAngle(options.ViewAngle);
  if (options.Camera.empty())
  {
    this->Renderer->ResetCamera();
    return;
  }
  const std::vector<double>& c = options.Camera;
  const std::string problem = CheckCamera(c);
  if (!problem.empty())
  {
    throw bmtError("--camera: " + problem);
  }
  camera->SetPosition(&c[0]);
  camera->SetFocalPoint(&c[3]);
  camera->SetViewUp(&c[6]);
  this->Renderer->ResetCameraClippingRange();
}

void bmtScene::RequireDisplay() const
{
  if (const std::string problem = vtkMTDisplay::FindProblem(this->Window); !problem.empty())
  {
    throw bmtError(problem + "; without a screen run it as xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" bmt ...");
  }
}

void bmtScene::SetColorBy(const std::string& what)
{
  static const std::map<std::string, int> cuts{ { "level", Mapper::LEVEL }, { "patch", Mapper::PATCH },
    { "error", Mapper::ERROR_IN_PIXELS } };
  const auto cut = cuts.find(what);
  this->Mapper->SetColorBy(cut == cuts.end() ? Mapper::NONE : cut->second);
  this->Mapper->ScalarVisibilityOff();
  this->Actor->GetProperty()->RemoveAllTextures();
  if (what.empty())
  {
    this->Mapper->SelectColors(); // those of the mesh; other values only when they are asked for
    for (const vtkMTModelTextures::Texture& each : this->Textures.Textures)
    {
      vtkNew<vtkTexture> texture;
      texture->SetInputData(each.Image);
      texture->InterpolateOn();
      texture->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
      this->Actor->GetProperty()->SetTexture(each.Name.c_str(), texture);
      this->Mapper->MapTextureToMaterial(each.Name.c_str(), each.Material, each.Part);
    }
  }
  else if (cut == cuts.end())
  {
    this->ColorByArray(what);
  }
}

void bmtScene::ColorByArray(const std::string& name)
{
  vtkDataArray* array = this->Model->GetPointData()->GetArray(name.c_str());
  this->Mapper->SetScalarModeToUsePointFieldData();
  if (!array)
  {
    array = this->Model->GetCellData()->GetArray(name.c_str());
    this->Mapper->SetScalarModeToUseCellFieldData();
  }
  if (!array)
  {
    std::string names = "level, patch, error";
    for (const vtkMTArrayInfo& each : this->Model->GetSource()->GetGraph().Arrays)
    {
      names += ", " + each.Name;
    }
    throw bmtError("--color-by " + name + ": no such array; there are " + names);
  }
  const int component = array->GetNumberOfComponents() > 1 ? -1 : 0;
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.667, 0.0); // blue is low
  table->SetVectorMode(component < 0 ? vtkScalarsToColors::MAGNITUDE : vtkScalarsToColors::COMPONENT);
  this->Mapper->SelectColorArray(name.c_str());
  this->Mapper->SetLookupTable(table);
  this->Mapper->SetScalarRange(array->GetRange(component));
  this->Mapper->ScalarVisibilityOn();
}

bmtJson bmtScene::DescribeFrame() const
{
  bmtJson json;
  json["triangles"] = this->Mapper->GetNumberOfTriangles();
  json["patches"] = this->Mapper->GetNumberOfPatches();
  json["culled_patches"] = this->Mapper->GetNumberOfCulledPatches();
  json["pixel_error"] = this->Mapper->GetAchievedPixelError(); // null where it has no bound
  json["converged"] = this->Mapper->GetConverged();
  json["cut_ms"] = 1e3 * this->Mapper->GetCutTime();
  json["texture_problems"] = this->Textures.Problems;
  return json;
}
