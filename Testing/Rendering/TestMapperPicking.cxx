// SPDX-License-Identifier: BSD-3-Clause
// Picking gives the input's ids, on any level.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationLocator.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
class PickingWith : public ::testing::TestWithParam<int>
{
};

TEST_P(PickingWith, HardwareSelectorGivesInputCells)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MTGridModel().MakeData());
  mapper->SetPixelError(2.0);
  mapper->ScalarVisibilityOff();
  MTScene scene(mapper);
  scene.Actor->GetProperty()->SetRepresentation(GetParam());
  scene.LookFromTheSide();
  scene.Render();
  const unsigned int area[4] = { 100, 120, 160, 150 };
  const std::set<vtkIdType> ids = scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, area);

  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  reference->ScalarVisibilityOff();
  MTScene plain(reference);
  plain.Actor->GetProperty()->SetRepresentation(GetParam());
  plain.LookFromTheSide();
  plain.Render();
  auto* input = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("CellIds"));
  std::set<vtkIdType> expected;
  for (const vtkIdType cell : plain.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, area))
  {
    expected.insert(input->GetValue(cell));
  }
  std::vector<vtkIdType> different;
  std::set_symmetric_difference(
    ids.begin(), ids.end(), expected.begin(), expected.end(), std::back_inserter(different));
  std::cout << ids.size() << " input cells selected, " << different.size() << " of them not the reference's\n";
  EXPECT_GT(ids.size(), 50u);
  // Which of two lines of equal depth is seen depends on the order of the triangles.
  EXPECT_LE(different.size(), GetParam() == VTK_SURFACE ? 0 : ids.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(Representations, PickingWith, ::testing::Values(VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS));

TEST(Picking, HardwareSelectorGivesTheNamedPointIds)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MTGridModel().MakeData());
  mapper->SetPixelError(2.0);
  mapper->SetPointIdArrayName("Color"); // its first component is the column of the point, from 0 to 255
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  const unsigned int left[4] = { 40, 120, 80, 150 };
  const unsigned int right[4] = { 220, 120, 260, 150 };
  const std::set<vtkIdType> lefts = scene.Select(vtkDataObject::FIELD_ASSOCIATION_POINTS, left);
  const std::set<vtkIdType> rights = scene.Select(vtkDataObject::FIELD_ASSOCIATION_POINTS, right);
  ASSERT_FALSE(lefts.empty());
  ASSERT_FALSE(rights.empty());
  std::cout << "left " << *lefts.begin() << " to " << *lefts.rbegin() << ", right " << *rights.begin() << " to "
            << *rights.rbegin() << "\n";
  EXPECT_LT(*lefts.rbegin(), *rights.begin());
  EXPECT_LE(*rights.rbegin(), 255);
}

TEST(Picking, PictureIsTheSameAfterASelection)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MTGridModel().MakeData());
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto before = scene.Render();
  const unsigned int area[4] = { 0, 0, 299, 299 };
  scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, area);
  scene.Select(vtkDataObject::FIELD_ASSOCIATION_POINTS, area);
  EXPECT_EQ(MTDifference::Compare(scene.Render(), before).Pixels, 0u);
}

TEST(Picking, CellPickerFindsInputCellsThroughTheCoarsestCut)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MTGridModel().MakeData());
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  vtkNew<vtkCellPicker> picker;
  ASSERT_EQ(picker->Pick(150, 150, 0.0, scene.Renderer), 1);
  auto* ids = vtkIdTypeArray::SafeDownCast(picker->GetDataSet()->GetCellData()->GetArray("CellIds"));
  ASSERT_NE(ids, nullptr);
  const vtkIdType cell = ids->GetValue(picker->GetCellId());
  std::cout << "cell " << cell << " at " << picker->GetPickPosition()[0] << ", " << picker->GetPickPosition()[1]
            << "\n";
  EXPECT_GE(cell, 0);
  EXPECT_LT(cell, 2 * 128 * 128);
}

// The id of the cell that the picker finds under a pixel's centre, or -1.
vtkIdType PickCell(vtkCellPicker* picker, MTScene& scene, int x, int y)
{
  return picker->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer) ? picker->GetCellId() : -1;
}

TEST(Picking, CellPickerWithTheLocatorFindsTheDrawnTrianglesInputCells)
{
  for (const double pixelError : { 0.0, 2.0 })
  {
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(MTGridModel().MakeData());
    mapper->SetPixelError(pixelError);
    MTScene scene(mapper);
    scene.Actor->SetScale(1.0, 1.5, 0.8);
    scene.Actor->RotateZ(15.0);
    scene.LookFromTheSide();
    scene.Render();
    vtkNew<vtkMultiTriangulationLocator> locator;
    locator->SetMapper(mapper);
    vtkNew<vtkCellPicker> picker;
    picker->AddLocator(locator);
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    selector->SetArea(0, 0, 299, 299);
    ASSERT_TRUE(selector->CaptureBuffers());
    int picked = 0;
    int same = 0;
    double farthest = 0.0;
    for (unsigned int y = 20; y < 290; y += 15)
    {
      for (unsigned int x = 20; x < 290; x += 15)
      {
        const unsigned int pixel[2] = { x, y };
        const vtkHardwareSelector::PixelInformation info = selector->GetPixelInformation(pixel);
        const vtkIdType cell = PickCell(picker, scene, static_cast<int>(x), static_cast<int>(y));
        EXPECT_EQ(cell >= 0, info.Valid) << x << ", " << y;
        if (cell < 0 || !info.Valid)
        {
          continue;
        }
        ++picked;
        same += cell == info.AttributeID;
        const double* place = picker->GetMapperPosition();
        farthest = std::max(farthest, std::abs(place[2] - MTGridModel::GetHeight(place[0], place[1])));
        EXPECT_GT(picker->GetMapperNormal()[2], 0.0);
      }
    }
    std::cout << "at " << pixelError << ": " << picked << " picked, " << same
              << " as the hardware selector, positions within " << farthest << " of the surface\n";
    EXPECT_GT(picked, 80);
    EXPECT_GE(same, picked - 1 - picked / 50); // on an edge either triangle is right
    EXPECT_LT(farthest, pixelError > 0.0 ? 0.02 : 0.002);
  }
}

TEST(Picking, LocatorSeesNothingBeforeTheFirstFrameAndHonoursClippingPlanes)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MTGridModel().MakeData());
  MTScene scene(mapper);
  scene.LookFromTheSide();
  vtkNew<vtkMultiTriangulationLocator> locator;
  vtkNew<vtkCellPicker> picker;
  picker->AddLocator(locator);
  locator->SetMapper(mapper);
  EXPECT_EQ(PickCell(picker, scene, 150, 150), -1);
  scene.Render();
  EXPECT_GE(PickCell(picker, scene, 150, 150), 0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.9, 0.5, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  mapper->AddClippingPlane(plane);
  scene.Render();
  EXPECT_EQ(PickCell(picker, scene, 150, 150), -1);
}

// Counts what is read with whom.
class CountedSource : public vtkMTPatchSource
{
public:
  explicit CountedSource(std::shared_ptr<const vtkMTPatchSource> model)
    : Model(std::move(model))
  {
  }
  const vtkMTGraph& GetGraph() const override { return this->Model->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    ++this->Reads;
    return this->Model->ReadPatch(arc, arrays, patch, error);
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Model->GetPatchSize(arc); }
  std::string GetName() const override { return "counted"; }

  mutable std::atomic<int> Reads{ 0 };

private:
  std::shared_ptr<const vtkMTPatchSource> Model;
};

TEST(Picking, LocatorReadsOnlyTheIdsOfThePatchThatIsHit)
{
  const auto source = std::make_shared<CountedSource>(MTGridModel().Make());
  vtkNew<vtkMultiTriangulation> input;
  input->SetSource(source);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(input);
  mapper->SetPixelError(0.0);
  mapper->ScalarVisibilityOff();
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  vtkNew<vtkMultiTriangulationLocator> locator;
  locator->SetMapper(mapper);
  vtkNew<vtkCellPicker> picker;
  picker->AddLocator(locator);
  const vtkIdType loaded = mapper->GetNumberOfReads();
  const int before = source->Reads;
  EXPECT_GE(PickCell(picker, scene, 150, 150), 0);
  std::cout << source->Reads - before << " patches read for a pick in " << mapper->GetNumberOfPatches() << "\n";
  EXPECT_LE(source->Reads - before, 1);
  EXPECT_EQ(mapper->GetNumberOfReads(), loaded); // nothing is asked of the loader

  // With no room in main memory, patches are on the GPU alone: what lies under the cursor is read.
  const vtkIdType cell = PickCell(picker, scene, 150, 150);
  mapper->SetPatchMemoryLimit(1);
  scene.Render();
  const int again = source->Reads;
  EXPECT_EQ(PickCell(picker, scene, 150, 150), cell);
  std::cout << source->Reads - again << " where none is in main memory\n";
  EXPECT_GT(source->Reads - again, 0);
  EXPECT_LE(source->Reads - again, 4); // those whose boxes the line meets, and the ids of the one that is hit
}
}
