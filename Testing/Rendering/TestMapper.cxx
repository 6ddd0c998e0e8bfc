// SPDX-License-Identifier: BSD-3-Clause
// What vtkMultiTriangulationMapper promises beyond the pixels of one frame.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
// Close above one corner, most of the model out of sight.
void LookClosely(MTScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.1, -0.15, 0.25);
  camera->SetFocalPoint(0.25, 0.2, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCameraClippingRange();
}

// The welded mesh of the mapper's last cut, drawn by VTK in the same view.
MTDifference CompareWithPolyDataMapper(vtkMultiTriangulationMapper* mapper, MTScene& scene, vtkImageData* picture)
{
  vtkNew<vtkPolyData> mesh;
  mapper->GetCut(mesh);
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  reference->vtkMapper::ShallowCopy(mapper);
  MTScene plain(reference, scene.Window->GetSize()[0], scene.Window->GetSize()[1]);
  plain.Actor->SetProperty(scene.Actor->GetProperty());
  plain.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  return MTDifference::Compare(picture, plain.Render());
}

// A source that fails where it is told to.
class FailingSource : public vtkMTPatchSource
{
public:
  explicit FailingSource(std::shared_ptr<const vtkMTPatchSource> source)
    : Source(std::move(source))
  {
  }
  const vtkMTGraph& GetGraph() const override { return this->Source->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    if (this->Broken.count(arc))
    {
      error = "block " + std::to_string(arc) + " is broken";
      return false;
    }
    const bool read = this->Source->ReadPatch(arc, arrays, patch, error);
    if (this->Truncated.count(arc))
    {
      patch.Triangles.resize(patch.Triangles.size() / 2);
    }
    return read;
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Source->GetPatchSize(arc); }
  std::string GetName() const override { return "failing.bmt"; }

  std::set<std::uint32_t> Broken;
  std::set<std::uint32_t> Truncated;

private:
  std::shared_ptr<const vtkMTPatchSource> Source;
};

// The messages of a vtkObject's error events, which then do not go to the terminal.
class Errors
{
public:
  explicit Errors(vtkObject* object)
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Messages.emplace_back(static_cast<const char*>(text)); });
    object->AddObserver(vtkCommand::ErrorEvent, this->Callback);
  }
  std::vector<std::string> Messages;

private:
  vtkNew<vtkCallbackCommand> Callback;
};

TEST(Mapper, RefinesMoreWhereTheCameraIsNear)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide(0.2);
  scene.Render();
  const vtkIdType far = mapper->GetNumberOfTriangles();
  scene.Renderer->GetActiveCamera()->Zoom(5.0);
  scene.Render();
  const vtkIdType near = mapper->GetNumberOfTriangles();
  std::cout << "far " << far << " triangles, near " << near << "\n";
  EXPECT_LT(2 * far, near);
}

TEST(Mapper, KeepsThePixelErrorItPromises)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  vtkIdType last = VTK_ID_MAX;
  for (const double error : { 0.25, 0.5, 1.0, 2.0, 4.0, 8.0 })
  {
    mapper->SetPixelError(error);
    scene.Render();
    std::cout << "at " << error << ": " << mapper->GetNumberOfTriangles() << " triangles, achieved "
              << mapper->GetAchievedPixelError() << "\n";
    EXPECT_TRUE(mapper->GetConverged());
    EXPECT_LE(mapper->GetAchievedPixelError(), error);
    EXPECT_LE(mapper->GetNumberOfTriangles(), last);
    last = mapper->GetNumberOfTriangles();
  }
}

TEST(Mapper, NeverDrawsMoreTrianglesThanTheBudget)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  for (const vtkIdType budget : { 1000, 3000, 7777, 20000 })
  {
    mapper->SetTriangleLimit(budget);
    scene.Render();
    std::cout << "budget " << budget << ": " << mapper->GetNumberOfTriangles() << " triangles in "
              << mapper->GetNumberOfPatches() << " patches, achieved " << mapper->GetAchievedPixelError() << "\n";
    EXPECT_LE(mapper->GetNumberOfTriangles(), budget);
    EXPECT_FALSE(mapper->GetConverged());
  }
}

TEST(Mapper, CullingChangesNoPixel)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  LookClosely(scene);
  const auto culled = scene.Render();
  const vtkIdType drawn = mapper->GetNumberOfPatches();
  EXPECT_GT(mapper->GetNumberOfCulledPatches(), 0);
  mapper->FrustumCullingOff();
  const auto all = scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCulledPatches(), 0);
  EXPECT_GT(mapper->GetNumberOfPatches(), drawn);
  const MTDifference difference = MTDifference::Compare(culled, all);
  std::cout << drawn << " of " << mapper->GetNumberOfPatches() << " patches with culling; " << difference << "\n";
  EXPECT_EQ(difference.Pixels, 0u);
}

TEST(Mapper, FrozenCutStaysWhileTheCameraMoves)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  LookClosely(scene);
  scene.Render();
  const vtkIdType refined = mapper->GetNumberOfRefinedNodes();
  mapper->FreezeCutOn();
  scene.LookFromTheSide();
  const auto picture = scene.Render();
  EXPECT_EQ(mapper->GetNumberOfRefinedNodes(), refined);
  const MTDifference difference = CompareWithPolyDataMapper(mapper, scene, picture);
  std::cout << difference << "\n";
  EXPECT_LE(difference.ClearlyOff, 5u);
  mapper->FreezeCutOff();
  scene.Render();
  EXPECT_NE(mapper->GetNumberOfRefinedNodes(), refined);
}

TEST(Mapper, UnevenCutsHaveNoCracks)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  mapper->ScalarVisibilityOff();
  MTScene scene(mapper);
  LookClosely(scene);
  scene.Render();
  mapper->FreezeCutOn();
  scene.Renderer->ResetCamera();
  scene.Renderer->GetActiveCamera()->SetPosition(0.5, 0.5, 3.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.5, 0.0);
  scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
  scene.Renderer->GetActiveCamera()->Zoom(3.0); // the model fills the window
  scene.Renderer->ResetCameraClippingRange();
  scene.Renderer->SetBackground(1.0, 0.0, 1.0);
  scene.Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  const auto picture = scene.Render();
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  int background = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    background += pixels->GetTypedComponent(i, 0) > 10;
  }
  std::set<std::uint32_t> levels;
  vtkNew<vtkPolyData> mesh;
  mapper->GetCut(mesh);
  std::cout << mapper->GetNumberOfPatches() << " patches, " << mesh->GetNumberOfCells() << " triangles, " << background
            << " background pixels\n";
  EXPECT_EQ(background, 0);
}

TEST(Mapper, LookupTableChangeReadsNothingAndUploadsColorsOnly)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto before = scene.Render();
  const vtkIdType reads = mapper->GetNumberOfReads();
  const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
  vtkLookupTable::SafeDownCast(mapper->GetLookupTable())->SetHueRange(0.3, 0.8);
  const auto after = scene.Render();
  const vtkIdType bytes = mapper->GetNumberOfUploadedBytes() - uploaded;
  std::cout << bytes << " bytes uploaded for " << mapper->GetNumberOfTriangles() << " triangles\n";
  EXPECT_GT(MTDifference::Compare(before, after).ClearlyOff, 1000u);
  EXPECT_EQ(mapper->GetNumberOfReads(), reads);
  EXPECT_LT(bytes, 4 * mapper->GetNumberOfTriangles());
  EXPECT_LE(CompareWithPolyDataMapper(mapper, scene, after).ClearlyOff, 5u);
}

TEST(Mapper, StillViewUploadsNothingInTheNextFrame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto first = scene.Render();
  const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
  const auto second = scene.Render();
  EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded);
  EXPECT_EQ(MTDifference::Compare(first, second).Pixels, 0u);
}

TEST(Mapper, ArrayChangesShowInTheNextFrame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  const auto check = [&](const std::string& what)
  {
    const auto picture = scene.Render();
    const MTDifference difference = CompareWithPolyDataMapper(mapper, scene, picture);
    std::cout << what << ": " << difference << "\n";
    EXPECT_LE(difference.ClearlyOff, 5u) << what;
  };
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("TCoords");
  check("point array");
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("Block");
  mapper->SetScalarRange(0.0, 63.0);
  check("cell array");
  mapper->SetScalarRange(20.0, 40.0);
  check("range");
  mapper->SetScalarModeToDefault();
  mapper->SetScalarRange(-0.1, 0.1);
  check("default scalars");
  mapper->InterpolateScalarsBeforeMappingOn();
  check("texture");
  mapper->ScalarVisibilityOff();
  check("none");
  scene.Actor->GetProperty()->SetInterpolationToFlat();
  check("flat");
  scene.Actor->GetProperty()->SetInterpolationToPhong();
  check("phong");
}

TEST(Mapper, SecondWindowShowsTheSame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene first(mapper);
  MTScene second(mapper);
  first.LookFromTheSide();
  second.LookFromTheSide();
  const auto a = first.Render();
  const auto b = second.Render();
  const auto c = first.Render();
  EXPECT_EQ(MTDifference::Compare(a, b).Pixels, 0u);
  EXPECT_EQ(MTDifference::Compare(a, c).Pixels, 0u);
}

TEST(Mapper, TwoRenderersHaveTheirOwnCuts)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AddActor(scene.Actor);
  scene.Window->AddRenderer(other);
  LookClosely(scene);
  other->ResetCamera();
  other->GetActiveCamera()->Zoom(0.1);
  scene.Render();
  const vtkIdType farther = mapper->GetNumberOfTriangles();
  scene.Window->RemoveRenderer(other);
  scene.Render();
  EXPECT_GT(mapper->GetNumberOfTriangles(), farther);
}

TEST(Mapper, DrawsAgainAfterReleasingGraphicsResources)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto before = scene.Render();
  EXPECT_GT(mapper->GetGraphicsMemory(), 0);
  mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(mapper->GetGraphicsMemory(), 0);
  const auto after = scene.Render();
  EXPECT_EQ(MTDifference::Compare(before, after).Pixels, 0u);
}

TEST(Mapper, OutlivesItsWindow)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  {
    MTScene scene(mapper);
    scene.LookFromTheSide();
    scene.Render();
  }
  EXPECT_EQ(mapper->GetGraphicsMemory(), 0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  EXPECT_GT(mapper->GetGraphicsMemory(), 0);
}

TEST(Mapper, WindowOutlivesIt)
{
  auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  scene.Actor->SetMapper(nullptr);
  scene.Mapper = nullptr;
  mapper = nullptr;
  scene.Render();
}

TEST(Mapper, PlainPolyDataIsDrawnAsEver)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  const auto mapper = MTGridModel::MakeMapper(sphere->GetOutput(), 0.8);
  MTScene scene(mapper);
  const auto picture = scene.Render();
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(sphere->GetOutput());
  MTScene plain(reference);
  EXPECT_EQ(MTDifference::Compare(picture, plain.Render()).Pixels, 0u);
}

TEST(Mapper, InputMayChangeBetweenModelsAndPolyData)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  const auto input = MTGridModel().MakeData();
  const auto mapper = MTGridModel::MakeMapper(input, 0.8);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("Block");
  mapper->SetScalarRange(0.0, 63.0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto first = scene.Render();
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  for (int i = 0; i < 2; ++i)
  {
    mapper->SetInputData(mesh);
    EXPECT_LE(MTDifference::Compare(scene.Render(), first).ClearlyOff, 5u);
    mapper->SetInputData(sphere->GetOutput());
    EXPECT_GT(MTDifference::Compare(scene.Render(), first).ClearlyOff, 1000u);
    mapper->SetInputData(input);
    EXPECT_EQ(MTDifference::Compare(scene.Render(), first).Pixels, 0u);
  }
}

TEST(Mapper, UnreadablePatchLeavesTheCoarserOneAndIsNamedOnce)
{
  const auto source = std::make_shared<FailingSource>(MTGridModel().Make());
  const vtkMTGraph& graph = source->GetGraph();
  source->Broken.insert(static_cast<std::uint32_t>(graph.Arcs.size() - 3));
  source->Truncated.insert(static_cast<std::uint32_t>(graph.Arcs.size() / 2));
  vtkNew<vtkMultiTriangulation> input;
  ASSERT_TRUE(input->SetSource(source));
  const auto mapper = MTGridModel::MakeMapper(input, 0.0);
  Errors errors(mapper);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto picture = scene.Render();
  ASSERT_EQ(errors.Messages.size(), 2u);
  for (const std::string& message : errors.Messages)
  {
    std::cout << message;
    EXPECT_NE(message.find("failing.bmt"), std::string::npos);
  }
  EXPECT_FALSE(mapper->GetConverged());
  const MTDifference difference = CompareWithPolyDataMapper(mapper, scene, picture);
  std::cout << difference << "\n";
  EXPECT_LE(difference.ClearlyOff, 5u);
  scene.Render();
  EXPECT_EQ(errors.Messages.size(), 2u);
}

TEST(Mapper, BoundsAreTheModelsAndNotTheCoarsestCuts)
{
  const auto input = MTGridModel().MakeData();
  const auto mapper = MTGridModel::MakeMapper(input, 0.8);
  double bounds[6];
  input->GetSource()->GetGraph().GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(mapper->GetBounds()[i], bounds[i]);
  }
}

TEST(Mapper, ShallowCopyDrawsTheSame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  mapper->SetTriangleLimit(5000);
  mapper->SetColorByToLevel();
  vtkNew<vtkMultiTriangulationMapper> copy;
  copy->ShallowCopy(mapper);
  MTScene a(mapper);
  MTScene b(copy);
  a.LookFromTheSide();
  b.LookFromTheSide();
  EXPECT_EQ(MTDifference::Compare(a.Render(), b.Render()).Pixels, 0u);
  EXPECT_EQ(mapper->GetNumberOfTriangles(), copy->GetNumberOfTriangles());
}

TEST(Mapper, SmallMemoryLimitDrawsTheSame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto picture = scene.Render();
  const auto small = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  small->SetPatchMemoryLimit(100000);
  MTScene other(small);
  other.LookFromTheSide();
  EXPECT_EQ(MTDifference::Compare(other.Render(), picture).Pixels, 0u);
  std::cout << small->GetPatchMemory() << " of " << mapper->GetPatchMemory() << " bytes kept\n";
  EXPECT_LE(small->GetPatchMemory(), 100000);
  EXPECT_GT(mapper->GetPatchMemory(), 100000);
}

TEST(Mapper, StereoShowsBothEyesOneCut)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  LookClosely(scene);
  scene.Window->StereoRenderOn();
  scene.Window->SetStereoTypeToAnaglyph();
  const auto picture = scene.Render();
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  reference->SetScalarRange(mapper->GetScalarRange());
  MTScene plain(reference);
  LookClosely(plain);
  plain.Window->StereoRenderOn();
  plain.Window->SetStereoTypeToAnaglyph();
  const MTDifference difference = MTDifference::Compare(picture, plain.Render());
  std::cout << difference << "\n";
  EXPECT_GT(difference.Drawn, 10000u);
  EXPECT_LE(difference.ClearlyOff, 9u);
}

TEST(Mapper, TilesOfALargePictureFitTogether)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  mapper->SetPixelError(0.0); // the same cut in every tile
  vtkNew<vtkPolyData> mesh;
  vtkSmartPointer<vtkImageData> pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPolyDataMapper> reference;
    reference->SetInputData(mesh);
    reference->SetScalarRange(mapper->GetScalarRange());
    MTScene scene(i == 0 ? static_cast<vtkMapper*>(mapper) : reference);
    scene.LookFromTheSide();
    scene.Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(scene.Window);
    filter->SetScale(3);
    filter->Update();
    pictures[i] = filter->GetOutput();
    if (i == 0)
    {
      ASSERT_TRUE(mapper->GetCut(mesh));
    }
  }
  const MTDifference difference = MTDifference::Compare(pictures[0], pictures[1]);
  std::cout << difference << "\n";
  EXPECT_GT(difference.Drawn, 100000u);
  EXPECT_LE(difference.ClearlyOff, difference.Drawn / 10000);
}

TEST(Mapper, FlyThroughKeepsPixelsRightWhilePatchesComeAndGo)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  std::size_t worst = 0;
  vtkIdType memory = 0;
  for (int step = 0; step <= 24; ++step)
  {
    const double t = step / 24.0;
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.1 + 0.8 * t, -1.5 + 2.0 * t, 1.2 - 1.0 * std::sin(3.14 * t));
    camera->SetFocalPoint(0.5, 0.5 + 0.3 * t, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCameraClippingRange();
    const auto picture = scene.Render();
    worst = std::max(worst, CompareWithPolyDataMapper(mapper, scene, picture).ClearlyOff);
    memory = std::max(memory, mapper->GetGraphicsMemory());
  }
  std::cout << "at worst " << worst << " pixels clearly off, " << memory << " bytes on the GPU\n";
  EXPECT_LE(worst, 5u);
}

TEST(Mapper, ColorByMatchesItsBaselines)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 1.5);
  MTScene scene(mapper);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  LookClosely(scene);
  scene.Render();
  mapper->FreezeCutOn();
  scene.Renderer->GetActiveCamera()->SetPosition(-0.7, -1.3, 1.6);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.5, -0.1);
  scene.Renderer->GetActiveCamera()->Zoom(1.1);
  scene.Renderer->ResetCameraClippingRange();
  const std::pair<int, const char*> modes[] = { { vtkMultiTriangulationMapper::LEVEL, "GridByLevel" },
    { vtkMultiTriangulationMapper::PATCH, "GridByPatch" },
    { vtkMultiTriangulationMapper::ERROR_IN_PIXELS, "GridByError" } };
  for (const auto& mode : modes)
  {
    mapper->SetColorBy(mode.first);
    std::string reason;
    EXPECT_TRUE(MTMatchesBaseline(scene.Render(), mode.second, reason)) << reason;
  }
  mapper->SetColorByToNone();
  std::string reason;
  EXPECT_TRUE(MTMatchesBaseline(scene.Render(), "GridByElevation", reason)) << reason;
}
}
