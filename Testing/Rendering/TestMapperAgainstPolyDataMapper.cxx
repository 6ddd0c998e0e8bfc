// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper draws the pixels that vtkPolyDataMapper draws for the very same triangles.
#include "MTMapperStates.h"
#include "MTPicture.h"

#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

#include <iostream>
#include <string>

namespace
{
class AgainstPolyDataMapper : public ::testing::TestWithParam<MTMapperState>
{
};

TEST_P(AgainstPolyDataMapper, DrawsTheSamePixels)
{
  const MTMapperState& state = GetParam();
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(state.Model.MakeData());
  mapper->SetPixelError(0.8);
  MTScene scene(mapper);
  state.Apply(scene);
  scene.LookFromTheSide();
  const auto picture = scene.Render();

  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  MTScene plain(reference);
  state.Apply(plain);
  plain.LookFromTheSide();
  const auto expected = plain.Render();

  const MTDifference difference = MTDifference::Compare(picture, expected);
  std::cout << state.Name << ": " << mapper->GetNumberOfTriangles() << " triangles in " << mapper->GetNumberOfPatches()
            << " patches, " << difference << "\n";
  MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + ".png");
  MTWritePicture(expected, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + "Expected.png");
  EXPECT_GT(mapper->GetNumberOfPatches(), 15); // planes take some away
  EXPECT_GT(difference.Drawn, 4000u);
  EXPECT_LE(static_cast<double>(difference.ClearlyOff), state.Allowed * static_cast<double>(difference.Drawn));
}

INSTANTIATE_TEST_SUITE_P(States, AgainstPolyDataMapper, ::testing::ValuesIn(MTMapperStates::GetAll()),
  [](const ::testing::TestParamInfo<MTMapperState>& info) { return info.param.Name; });
}
