// SPDX-License-Identifier: BSD-3-Clause
// Shares of a cut, as the ranks of a parallel program draw them.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkImageData.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPlane.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <vector>

namespace
{
struct ShareScene
{
  ShareScene()
    : Scene(this->Mapper)
  {
    vtkNew<vtkMultiTriangulation> input;
    input->SetSource(MTGridModel().Make());
    this->Mapper->SetInputData(input);
    this->Mapper->SetPixelError(0.2);
    this->Scene.Renderer->ResetCamera();
  }

  vtkNew<vtkMultiTriangulationMapper> Mapper;
  MTScene Scene;
};
}

//------------------------------------------------------------------------------
TEST(MapperShares, AreTheCutWithNoPatchTwice)
{
  ShareScene scene;
  scene.Scene.Render();
  const std::vector<std::uint32_t> cut = scene.Mapper->GetDrawnArcs();
  const vtkIdType triangles = scene.Mapper->GetNumberOfTriangles();
  for (const int count : { 2, 3, 7 })
  {
    std::vector<std::uint32_t> all;
    vtkIdType sum = 0;
    vtkIdType largest = 0;
    for (int share = 0; share < count; ++share)
    {
      scene.Mapper->SetDrawnShare(share, count);
      scene.Scene.Render();
      const std::vector<std::uint32_t> own = scene.Mapper->GetDrawnArcs();
      all.insert(all.end(), own.begin(), own.end());
      sum += scene.Mapper->GetNumberOfTriangles();
      largest = std::max(largest, scene.Mapper->GetNumberOfTriangles());
    }
    EXPECT_EQ(all, cut) << count;
    EXPECT_EQ(sum, triangles) << count;
    EXPECT_LT(largest * count, triangles + triangles / 2) << count;
    std::cout << count << " shares of " << triangles << " triangles, the largest of " << largest << "\n";
  }
}

//------------------------------------------------------------------------------
TEST(MapperShares, PicturesPutTogetherAreThePictureOfAll)
{
  ShareScene scene;
  scene.Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const vtkSmartPointer<vtkImageData> whole = scene.Scene.Render();
  auto sum = vtkSmartPointer<vtkImageData>::New();
  sum->DeepCopy(whole);
  auto* bytes = static_cast<unsigned char*>(sum->GetScalarPointer());
  const vtkIdType size = sum->GetNumberOfPoints() * sum->GetNumberOfScalarComponents();
  std::fill_n(bytes, size, static_cast<unsigned char>(0));
  for (const int share : { 0, 1 })
  {
    scene.Mapper->SetDrawnShare(share, 2);
    const vtkSmartPointer<vtkImageData> part = scene.Scene.Render();
    const auto* own = static_cast<const unsigned char*>(part->GetScalarPointer());
    std::transform(bytes, bytes + size, own, bytes, [](unsigned char a, unsigned char b) { return std::max(a, b); });
  }
  // A height field seen from above: nothing is in front of anything.
  EXPECT_EQ(MTDifference::Compare(sum, whole).Pixels, 0u);
}

//------------------------------------------------------------------------------
// As ranks draw what lies on their side of a plane.
TEST(MapperShares, PatchesThatAPlaneTakesAwayAreNotDrawnAndTwoSidesAreThePictureOfAll)
{
  ShareScene scene;
  scene.Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const vtkSmartPointer<vtkImageData> whole = scene.Scene.Render();
  const vtkIdType all = scene.Mapper->GetNumberOfTriangles();
  auto sum = vtkSmartPointer<vtkImageData>::New();
  sum->DeepCopy(whole);
  auto* bytes = static_cast<unsigned char*>(sum->GetScalarPointer());
  const vtkIdType size = sum->GetNumberOfPoints() * sum->GetNumberOfScalarComponents();
  std::fill_n(bytes, size, static_cast<unsigned char>(0));
  vtkIdType drawn = 0;
  for (const double side : { -1.0, 1.0 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.437, 0.5, 0.0);
    plane->SetNormal(side, 0.3 * side, 0.0);
    scene.Mapper->RemoveAllClippingPlanes();
    scene.Mapper->AddClippingPlane(plane);
    const vtkSmartPointer<vtkImageData> part = scene.Scene.Render();
    const auto* own = static_cast<const unsigned char*>(part->GetScalarPointer());
    std::transform(bytes, bytes + size, own, bytes, [](unsigned char a, unsigned char b) { return std::max(a, b); });
    std::cout << scene.Mapper->GetNumberOfTriangles() << " of " << all << " triangles on one side\n";
    EXPECT_LT(scene.Mapper->GetNumberOfTriangles(), 4 * all / 5);
    drawn += scene.Mapper->GetNumberOfTriangles();
  }
  EXPECT_EQ(MTDifference::Compare(sum, whole).Pixels, 0u);
  EXPECT_GE(drawn, all);
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTriangles(), all);
}

//------------------------------------------------------------------------------
TEST(MapperShares, TheOneAfterTheLastIsEmptyAndOthersAreClamped)
{
  ShareScene scene;
  scene.Mapper->SetDrawnShare(2, 2);
  scene.Scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTriangles(), 0);
  EXPECT_TRUE(scene.Mapper->GetDrawnArcs().empty());
  scene.Mapper->SetDrawnShare(-3, 0);
  EXPECT_EQ(scene.Mapper->GetDrawnShare()[0], 0);
  EXPECT_EQ(scene.Mapper->GetDrawnShare()[1], 1);
  scene.Mapper->SetDrawnShare(9, 4);
  EXPECT_EQ(scene.Mapper->GetDrawnShare()[0], 4);
  scene.Scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfPatches(), 0);
}
