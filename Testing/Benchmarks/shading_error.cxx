// SPDX-License-Identifier: BSD-3-Clause
// Pictures of cuts of equally many triangles, chosen by each error metric, beside those of the finest level:
//   shading_error MODEL [MODEL ...] [--views N] [--elevation DEGREES] [--size WIDTH HEIGHT] [--pixels E ...]
// Each model is seen whole, from N sides (4). For every number of triangles - what the certified distance draws at 1
// pixel, the mean edge length at E pixels (8 6 4 3) - each metric gets the pixel error at which it draws about as many,
// in the mean over the views, and its pixels that are off by more than 20 of 255 are counted. The last table is of 1
// pixel. Markdown. Needs a display: CMake/with-display shading_error ...
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTTargetCut.h"
#include "vtkMTView.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::vector<std::string> Models;
  std::vector<double> Pixels{ 8.0, 6.0, 4.0, 3.0 };
  std::array<int, 2> Size{ 1024, 768 };
  int Views = 4;
  double Elevation = 25.0;
};

bool Parse(int argc, char** argv, Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const auto next = [&]() { return i + 1 < argc ? std::atof(argv[++i]) : 0.0; };
    if (word == "--views")
    {
      options.Views = static_cast<int>(next());
    }
    else if (word == "--elevation")
    {
      options.Elevation = next();
    }
    else if (word == "--size")
    {
      options.Size[0] = static_cast<int>(next());
      options.Size[1] = static_cast<int>(next());
    }
    else if (word == "--pixels")
    {
      options.Pixels.clear();
      while (i + 1 < argc && std::atof(argv[i + 1]) > 0.0)
      {
        options.Pixels.push_back(next());
      }
    }
    else
    {
      options.Models.push_back(word);
    }
  }
  return !options.Models.empty() && options.Views > 0 && options.Size[0] > 0 && options.Size[1] > 0;
}

struct Metric
{
  const char* Name;
  vtkMTTargetCut::ErrorMetricType Type;
};
constexpr Metric Metrics[] = { { "distance", vtkMTTargetCut::Distance }, { "edge length", vtkMTTargetCut::EdgeLength },
  { "normal deviation", vtkMTTargetCut::NormalDeviation } };

struct Picture
{
  double Triangles = 0.0;
  double Off = 0.0; // share of pixels
};

class Comparison
{
public:
  Comparison(const Options& options, std::shared_ptr<vtkMTFileSource> source)
    : Setting(options)
    , Source(std::move(source))
  {
    this->Source->GetGraph().GetBounds(this->Bounds.data());
    this->Model->SetSource(this->Source);
    this->Mapper->SetInputData(this->Model);
    this->Mapper->ScalarVisibilityOff();
    this->Mapper->SetWaitForConvergence(vtkMultiTriangulationMapper::WAIT_ALWAYS);
    this->Mapper->SetPatchMemoryLimit(4000000000);
    this->Mapper->SetGraphicsMemoryLimit(4000000000);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.0, 0.0, 1.0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(options.Size[0], options.Size[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Mapper->SetPixelError(0.0);
    for (int view = 0; view < options.Views; ++view)
    {
      this->Look(view);
      this->Wanted.push_back(this->Draw());
      this->Views.push_back(this->GetView());
    }
  }

  // The mean over the views.
  double CountTriangles(vtkMTTargetCut::ErrorMetricType metric, double pixels)
  {
    double triangles = 0.0;
    for (const vtkMTView& view : this->Views)
    {
      vtkMTTargetCut::Input input;
      input.Graph = &this->Source->GetGraph();
      input.Views = { view };
      vtkMTTargetCut::Settings settings;
      settings.PixelError = pixels;
      settings.ErrorMetric = metric;
      triangles += static_cast<double>(this->Target.Extract(input, settings).Triangles);
    }
    return triangles / this->Setting.Views;
  }

  double FindPixels(vtkMTTargetCut::ErrorMetricType metric, double triangles)
  {
    double fine = 1e-6;
    double coarse = 1e6;
    for (int i = 0; i < 40; ++i)
    {
      const double middle = std::sqrt(fine * coarse);
      (this->CountTriangles(metric, middle) > triangles ? fine : coarse) = middle;
    }
    const auto getGap = [&](double pixels) { return std::abs(this->CountTriangles(metric, pixels) - triangles); };
    return getGap(fine) < getGap(coarse) ? fine : coarse;
  }

  Picture Compare(vtkMTTargetCut::ErrorMetricType metric, double pixels)
  {
    this->Mapper->SetErrorMetric(metric);
    this->Mapper->SetPixelError(pixels);
    Picture picture;
    double drawn = 0.0;
    double off = 0.0;
    for (int view = 0; view < this->Setting.Views; ++view)
    {
      this->Look(view);
      const auto pixelsOfCut = this->Draw();
      picture.Triangles += static_cast<double>(this->Mapper->GetNumberOfTriangles()) / this->Setting.Views;
      for (vtkIdType i = 0; i < pixelsOfCut->GetNumberOfTuples(); ++i)
      {
        drawn += IsModel(pixelsOfCut, i) || IsModel(this->Wanted[view], i) ? 1.0 : 0.0;
        off += GetDifference(pixelsOfCut, this->Wanted[view], i) > 20 ? 1.0 : 0.0;
      }
    }
    picture.Off = off / std::max(drawn, 1.0);
    return picture;
  }

private:
  void Look(int view)
  {
    constexpr double degree = 0.017453292519943295;
    const double turn = 360.0 * degree * view / this->Setting.Views + 0.3;
    const double up = this->Setting.Elevation * degree;
    double center[3];
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      center[i] = 0.5 * (this->Bounds[2 * i] + this->Bounds[2 * i + 1]);
      square += std::pow(this->Bounds[2 * i + 1] - this->Bounds[2 * i], 2);
    }
    const double distance = 0.5 * std::sqrt(square) / std::sin(15.0 * degree);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(center);
    camera->SetPosition(center[0] + distance * std::cos(turn) * std::cos(up),
      center[1] + distance * std::sin(turn) * std::cos(up), center[2] + distance * std::sin(up));
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange(this->Bounds.data());
  }

  vtkMTView GetView()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    std::array<double, 16> modelToEye;
    std::copy_n(camera->GetModelViewTransformMatrix()->GetData(), 16, modelToEye.begin());
    const double aspect = double(this->Setting.Size[0]) / this->Setting.Size[1];
    return vtkMTView::FromProjection(modelToEye, camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0)->GetData(),
      this->Setting.Size, camera->GetClippingRange());
  }

  vtkSmartPointer<vtkUnsignedCharArray> Draw()
  {
    this->Window->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Window->GetPixelData(0, 0, this->Setting.Size[0] - 1, this->Setting.Size[1] - 1, 1, pixels);
    return pixels;
  }

  static bool IsModel(vtkUnsignedCharArray* pixels, vtkIdType i)
  {
    return pixels->GetTypedComponent(i, 0) != 0 || pixels->GetTypedComponent(i, 1) != 0 ||
      pixels->GetTypedComponent(i, 2) != 255;
  }

  static int GetDifference(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b, vtkIdType i)
  {
    int largest = 0;
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(int(a->GetTypedComponent(i, c)) - int(b->GetTypedComponent(i, c))));
    }
    return largest;
  }

  const Options& Setting;
  std::shared_ptr<vtkMTFileSource> Source;
  std::array<double, 6> Bounds{};
  std::vector<vtkSmartPointer<vtkUnsignedCharArray>> Wanted;
  std::vector<vtkMTView> Views;
  vtkMTTargetCut Target;
  vtkNew<vtkMultiTriangulation> Model;
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void Print(const std::string& name, const Options& options, Comparison& comparison)
{
  std::vector<double> targets{ comparison.CountTriangles(vtkMTTargetCut::Distance, 1.0) };
  for (const double pixels : options.Pixels)
  {
    targets.push_back(comparison.CountTriangles(vtkMTTargetCut::EdgeLength, pixels));
  }
  std::sort(targets.begin(), targets.end());
  std::printf("\n%s: pixels off by more than 20, at as many triangles\n\n| triangles | distance | edge length | normal "
              "deviation |\n|---|---|---|---|\n",
    name.c_str());
  for (const double target : targets)
  {
    std::printf("| %.0f |", target);
    for (const Metric& metric : Metrics)
    {
      const Picture picture = comparison.Compare(metric.Type, comparison.FindPixels(metric.Type, target));
      std::printf(" %.2f %% (%.0f) |", 100.0 * picture.Off, picture.Triangles);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\nAt 1 pixel:\n\n| metric | triangles | off by more than 20 |\n|---|---|---|\n");
  for (const Metric& metric : Metrics)
  {
    const Picture picture = comparison.Compare(metric.Type, 1.0);
    std::printf("| %s | %.0f | %.2f %% |\n", metric.Name, picture.Triangles, 100.0 * picture.Off);
  }
  std::fflush(stdout);
}
}

int main(int argc, char** argv)
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::fprintf(stderr,
      "usage: shading_error MODEL [MODEL ...] [--views N] [--elevation DEGREES] [--size W H] "
      "[--pixels E ...]\n");
    return 1;
  }
  for (const std::string& name : options.Models)
  {
    const auto source = std::make_shared<vtkMTFileSource>();
    std::string error;
    if (!source->Open(name, error))
    {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), error.c_str());
      return 1;
    }
    Comparison comparison(options, source);
    Print(name, options, comparison);
  }
  return 0;
}
