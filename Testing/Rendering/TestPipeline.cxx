// SPDX-License-Identifier: BSD-3-Clause
// From a mesh through the builder to pictures.
#include "MTPicture.h"
#include "MTTestMeshes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{
vtkSmartPointer<vtkMultiTriangulation> Build(vtkPolyData* mesh, int patchTriangles)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(patchTriangles);
  builder->Update();
  return vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0));
}

void LookAtSphere(MTScene& scene, double distance)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(distance, 0.4 * distance, 0.3 * distance);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCameraClippingRange();
}

class Pipeline : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    Mesh = MTTestMeshes::FractalSphere(6); // 81,920 triangles
    MTTestMeshes::AddArrays(Mesh);
    Model = Build(Mesh, 300);
  }
  static void TearDownTestSuite()
  {
    Mesh = nullptr;
    Model = nullptr;
  }

  static vtkSmartPointer<vtkMultiTriangulationMapper> MakeMapper(double pixelError)
  {
    auto mapper = vtkSmartPointer<vtkMultiTriangulationMapper>::New();
    mapper->SetInputData(Model);
    mapper->SetPixelError(pixelError);
    mapper->ScalarVisibilityOff();
    return mapper;
  }

  static vtkSmartPointer<vtkPolyData> Mesh;
  static vtkSmartPointer<vtkMultiTriangulation> Model;
};

vtkSmartPointer<vtkPolyData> Pipeline::Mesh;
vtkSmartPointer<vtkMultiTriangulation> Pipeline::Model;

std::vector<char> GetMask(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  std::vector<char> mask;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    bool background = true;
    for (int c = 0; c < 3; ++c)
    {
      background = background && pixels->GetTypedComponent(i, c) == pixels->GetTypedComponent(0, c);
    }
    mask.push_back(!background);
  }
  return mask;
}

// How far, in pixels, a pixel that is drawn in `a` can be from the nearest one that is drawn in `b`.
double GetFarthest(const std::vector<char>& a, const std::vector<char>& b, int width)
{
  const int height = static_cast<int>(a.size()) / width;
  double farthest = 0.0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      if (!a[y * width + x] || b[y * width + x])
      {
        continue;
      }
      double nearest = 1e9;
      for (int v = std::max(0, y - 40); v < std::min(height, y + 41); ++v)
      {
        for (int u = std::max(0, x - 40); u < std::min(width, x + 41); ++u)
        {
          if (b[v * width + u])
          {
            nearest = std::min(nearest, std::hypot(u - x, v - y));
          }
        }
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

TEST_F(Pipeline, CutIsDrawnAsVtkDrawsItsTriangles)
{
  for (const double distance : { 8.0, 4.0, 2.0 })
  {
    const auto mapper = MakeMapper(1.0);
    MTScene scene(mapper);
    LookAtSphere(scene, distance);
    const auto picture = scene.Render();
    vtkNew<vtkPolyData> mesh;
    ASSERT_TRUE(mapper->GetCut(mesh));
    vtkNew<vtkPolyDataMapper> reference;
    reference->SetInputData(mesh);
    reference->ScalarVisibilityOff();
    MTScene plain(reference);
    LookAtSphere(plain, distance);
    const MTDifference difference = MTDifference::Compare(picture, plain.Render());
    std::cout << "distance " << distance << ": " << mapper->GetNumberOfTriangles() << " triangles in "
              << mapper->GetNumberOfPatches() << " patches, " << difference << "\n";
    EXPECT_LE(difference.ClearlyOff, 1 + difference.Drawn / 10000);
  }
}

TEST_F(Pipeline, SilhouetteStaysWithinThePixelErrorOfTheInputs)
{
  vtkNew<vtkPolyDataMapper> full;
  full->SetInputData(Mesh);
  full->ScalarVisibilityOff();
  MTScene reference(full);
  for (const double pixels : { 1.0, 3.0, 8.0 })
  {
    const auto mapper = MakeMapper(pixels);
    MTScene scene(mapper);
    LookAtSphere(scene, 5.0);
    LookAtSphere(reference, 5.0);
    const std::vector<char> ours = GetMask(scene.Render());
    const std::vector<char> theirs = GetMask(reference.Render());
    const double farthest = std::max(GetFarthest(ours, theirs, 300), GetFarthest(theirs, ours, 300));
    std::cout << "at " << pixels << ": " << mapper->GetNumberOfTriangles() << " triangles, achieved "
              << mapper->GetAchievedPixelError() << ", the silhouettes differ by " << farthest << " pixels\n";
    EXPECT_TRUE(mapper->GetConverged());
    EXPECT_LE(mapper->GetAchievedPixelError(), pixels);
    // A pixel is in or out by its centre.
    EXPECT_LE(farthest, mapper->GetAchievedPixelError() + std::sqrt(2.0));
  }
}

TEST_F(Pipeline, CostFollowsThePicture)
{
  const auto mapper = MakeMapper(1.0);
  MTScene scene(mapper);
  vtkIdType last = 0;
  for (const double distance : { 100.0, 30.0, 10.0, 3.0 })
  {
    LookAtSphere(scene, distance);
    scene.Render();
    std::cout << "distance " << distance << ": " << mapper->GetNumberOfTriangles() << " triangles, cut in "
              << 1e3 * mapper->GetCutTime() << " ms, frame in " << 1e3 * mapper->GetFrameTime() << " ms\n";
    EXPECT_GE(mapper->GetNumberOfTriangles(), last);
    last = mapper->GetNumberOfTriangles();
  }
  EXPECT_LT(mapper->GetNumberOfTriangles(), Mesh->GetNumberOfCells());
}

TEST_F(Pipeline, BudgetIsUsedAndNotExceeded)
{
  const vtkMTGraph& graph = Model->GetSource()->GetGraph();
  double mean = 0.0;
  for (const vtkMTArc& arc : graph.Arcs)
  {
    mean += static_cast<double>(arc.Triangles) / static_cast<double>(graph.Arcs.size());
  }
  const auto mapper = MakeMapper(0.0);
  MTScene scene(mapper);
  LookAtSphere(scene, 4.0);
  for (const double patches : { 50.0, 60.0, 80.0, 100.0, 150.0 })
  {
    const auto budget = static_cast<vtkIdType>(patches * mean) + 1;
    mapper->SetTriangleLimit(budget);
    scene.Render();
    std::cout << "budget " << budget << ": " << mapper->GetNumberOfTriangles() << "\n";
    EXPECT_LE(mapper->GetNumberOfTriangles(), budget);
    EXPECT_TRUE(mapper->GetConverged() || mapper->GetNumberOfTriangles() >= 0.9 * static_cast<double>(budget));
  }
}

TEST_F(Pipeline, PickedCellsLieUnderThePixel)
{
  const auto mapper = MakeMapper(2.0);
  MTScene scene(mapper);
  LookAtSphere(scene, 4.0);
  scene.Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  int tested = 0;
  for (int y = 60; y < 240; y += 30)
  {
    for (int x = 60; x < 240; x += 30)
    {
      selector->SetArea(x, y, x, y);
      const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
      if (selection->GetNumberOfNodes() == 0)
      {
        continue;
      }
      auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
      ASSERT_GT(ids->GetNumberOfValues(), 0);
      const vtkIdType cell = ids->GetValue(0);
      ASSERT_LT(cell, Mesh->GetNumberOfCells());
      double box[6];
      Mesh->GetCellBounds(cell, box);
      scene.Renderer->SetWorldPoint(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]), 1.0);
      scene.Renderer->WorldToDisplay();
      const double* display = scene.Renderer->GetDisplayPoint();
      // The nearest input cell of a triangle up to some 20 pixels wide.
      EXPECT_LT(std::hypot(display[0] - x, display[1] - y), 14.0);
      ++tested;
    }
  }
  std::cout << tested << " pixels picked\n";
  EXPECT_GT(tested, 20);
}

TEST_F(Pipeline, NormalsHaveNoSeamsBetweenPatches)
{
  // A smooth sphere: with normals that agree across patches, neighbouring pixels inside it differ little anywhere.
  const auto sphere = MTTestMeshes::Icosphere(5);
  const auto model = Build(sphere, 100);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(model);
  mapper->SetPixelError(0.0);
  MTScene scene(mapper);
  LookAtSphere(scene, 5.0);
  const auto picture = scene.Render();
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const std::vector<char> mask = GetMask(picture);
  int largest = 0;
  for (int y = 2; y < 298; ++y)
  {
    for (int x = 2; x < 298; ++x)
    {
      const int i = 300 * y + x;
      const bool inside = mask[i] && mask[i + 1] && mask[i + 2] && mask[i - 2] && mask[i + 600] && mask[i - 600];
      const int value = pixels->GetTypedComponent(i, 0);
      if (inside && value > 120) // at grazing angles the shading itself is steep
      {
        largest = std::max(largest, std::abs(value - pixels->GetTypedComponent(i + 1, 0)));
      }
    }
  }
  std::cout << mapper->GetNumberOfPatches() << " patches, the largest step between pixels is " << largest << "\n";
  EXPECT_GT(mapper->GetNumberOfPatches(), 30);
  EXPECT_LE(largest, 8);
}

TEST_F(Pipeline, TextureSeamsAreDrawnAsVtkDrawsThem)
{
  // Along the seam points have two texture coordinates each, 0 and 1: two wedges of one point.
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      pixel[0] = static_cast<unsigned char>(4 * i);
      pixel[1] = static_cast<unsigned char>(255 - 4 * j);
      pixel[2] = (i / 4 + j / 4) % 2 ? 220 : 30;
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(Build(MTTestMeshes::SeamSphere(128, 64), 200));
  MTScene scene(mapper);
  scene.Actor->SetTexture(texture);
  for (const double pixelError : { 0.0, 1.0, 4.0 })
  {
    mapper->SetPixelError(pixelError);
    LookAtSphere(scene, 4.0); // the seam runs down in front
    const auto picture = scene.Render();
    vtkNew<vtkPolyData> mesh;
    ASSERT_TRUE(mapper->GetCut(mesh));
    vtkNew<vtkPolyDataMapper> reference;
    reference->SetInputData(mesh);
    MTScene plain(reference);
    plain.Actor->SetTexture(texture);
    LookAtSphere(plain, 4.0);
    const MTDifference difference = MTDifference::Compare(picture, plain.Render());
    std::cout << "at " << pixelError << ": " << mapper->GetNumberOfTriangles() << " triangles, " << difference << "\n";
    EXPECT_GT(difference.Drawn, 10000u);
    EXPECT_LE(difference.ClearlyOff, 1 + difference.Drawn / 10000);
    MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/SeamSphere.png");
  }
}

// The whole way: a mesh, its partition, simplification, certification, a cut for a view from close by, its patches.
TEST_F(Pipeline, PicturesMatchTheirBaselines)
{
  const auto mapper = MakeMapper(1.0);
  MTScene scene(mapper);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  scene.Renderer->GetActiveCamera()->SetPosition(1.5, -0.6, 0.9);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.6, 0.0, 0.6);
  scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Render();
  mapper->FreezeCutOn();
  LookAtSphere(scene, 5.0);
  scene.Render();
  std::cout << mapper->GetNumberOfTriangles() << " triangles in " << mapper->GetNumberOfPatches() << " patches\n";
  const std::pair<int, const char*> modes[] = { { vtkMultiTriangulationMapper::LEVEL, "SphereByLevel" },
    { vtkMultiTriangulationMapper::PATCH, "SphereByPatch" }, { vtkMultiTriangulationMapper::NONE, "Sphere" } };
  for (const auto& mode : modes)
  {
    mapper->SetColorBy(mode.first);
    std::string reason;
    EXPECT_TRUE(MTMatchesBaseline(scene.Render(), mode.second, reason)) << reason;
  }
}
}
