// SPDX-License-Identifier: BSD-3-Clause
// Camera paths: their file, and the flight through their views.
#include "MTIOTest.h"

#include "vtkCamera.h"
#include "vtkMTCameraPath.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using View = std::array<double, 11>;

View Get(vtkCamera* camera)
{
  View view{};
  camera->GetPosition(view.data());
  camera->GetFocalPoint(view.data() + 3);
  camera->GetViewUp(view.data() + 6);
  view[9] = camera->GetViewAngle();
  view[10] = camera->GetParallelProjection() ? camera->GetParallelScale() : 0.0;
  return view;
}

void Look(vtkCamera* camera, double x, double y, double z)
{
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
}

// Around the origin at distance 10, a view every second.
void MakeCircle(vtkMTCameraPath* path, int views, double degreesBetween)
{
  vtkNew<vtkCamera> camera;
  for (int i = 0; i < views; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(degreesBetween * i);
    Look(camera, 10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0);
    ASSERT_TRUE(path->AddView(i, camera)) << path->GetErrorMessage();
  }
}

class CameraPath : public testing::Test
{
protected:
  std::string Path(const std::string& name) const { return this->Folder / name; }

  // What reading such a file says.
  std::string GetProblem(const std::string& text)
  {
    MTIOTest::WriteFile(this->Path("path.csv"), text);
    vtkNew<vtkMTCameraPath> path;
    EXPECT_FALSE(path->Read(this->Path("path.csv").c_str()));
    return path->GetErrorMessage();
  }

  MTIOTest::Folder Folder;
};
}

TEST_F(CameraPath, IsReadBackBitForBitInAnyLocale)
{
  vtkNew<vtkMTCameraPath> path;
  vtkNew<vtkCamera> camera;
  std::array<View, 3> views;
  for (int i = 0; i < 3; ++i)
  {
    camera->SetPosition(1.0 / 3.0 + i, 5e6 + 0.1 * i, -1e-300);
    camera->SetFocalPoint(0.1, 0.2, 0.3 - i);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(30.0 / 7.0 + i);
    camera->SetParallelProjection(i == 1);
    camera->SetParallelScale(12.3);
    ASSERT_TRUE(path->AddView(0.1 * i, camera));
    views[i] = Get(camera);
  }
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  ASSERT_TRUE(path->Write(this->Path("path.csv").c_str())) << path->GetErrorMessage();
  vtkNew<vtkMTCameraPath> again;
  ASSERT_TRUE(again->Read(this->Path("path.csv").c_str())) << again->GetErrorMessage();
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(again->GetNumberOfViews(), 3);
  EXPECT_EQ(again->GetLastTime(), 0.2);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(again->GetView(0.1 * i, camera));
    EXPECT_EQ(Get(camera), views[i]) << i;
  }
}

TEST_F(CameraPath, FilesThatAreWrongAreRefusedWithLineAndColumn)
{
  const std::string header = "time,px,py,pz,fx,fy,fz,ux,uy,uz,view_angle,parallel_scale\n";
  const std::string good = "0,0,0,10,0,0,0,0,1,0,30,0\n";
  const auto expect = [this](const std::string& text, const std::string& place, const std::string& what)
  {
    const std::string problem = this->GetProblem(text);
    EXPECT_NE(problem.find("path.csv" + place), std::string::npos) << problem;
    EXPECT_NE(problem.find(what), std::string::npos) << problem;
  };
  expect("", "", "no views");
  expect(header, "", "no views");
  expect("x,y\n", ":1:", "begins with time,px");
  expect(header + good + "1,0,0,10,0,0,0,0,1,0,30\n", ":3:", "11 values instead of 12");
  expect(header + good + "1,0,0,ten,0,0,0,0,1,0,30,0\n", ":3:", "column pz: 'ten'");
  expect(header + good + "1,0,0,nan,0,0,0,0,1,0,30,0\n", ":3:", "column pz: 'nan' is no finite number");
  expect(header + good + "1,0,0,1e999,0,0,0,0,1,0,30,0\n", ":3:", "column pz");
  expect(header + "# a comment\n\n" + good + good, ":5:", "times must increase");
  expect(header + "0,0,0,0,0,0,0,0,1,0,30,0\n", ":2:", "must differ");
  expect(header + "0,0,0,10,0,0,0,0,0,1,30,0\n", ":2:", "must not point along");
  expect(header + "0,0,0,10,0,0,0,0,1,0,180,0\n", ":2:", "view angle");
  expect(header + "0,0,0,10,0,0,0,0,1,0,30,-1\n", ":2:", "parallel scale");

  vtkNew<vtkMTCameraPath> path;
  MakeCircle(path, 3, 30.0);
  EXPECT_FALSE(path->Read(this->Path("none.csv").c_str()));
  EXPECT_NE(path->GetErrorMessage().find("none.csv: cannot be opened: No such file"), std::string::npos)
    << path->GetErrorMessage();
  EXPECT_FALSE(path->Write(this->Path("nowhere/path.csv").c_str()));
  EXPECT_NE(path->GetErrorMessage().find("nowhere/path.csv"), std::string::npos) << path->GetErrorMessage();
  EXPECT_EQ(path->GetNumberOfViews(), 3) << "it is as it was";
}

TEST_F(CameraPath, TurnsOnAnArcAndSmoothly)
{
  vtkNew<vtkMTCameraPath> path;
  MakeCircle(path, 5, 60.0);
  vtkNew<vtkCamera> camera;
  constexpr int Steps = 400;
  std::array<std::array<double, 3>, Steps + 1> positions;
  double nearest = 10.0;
  double farthest = 10.0;
  for (int i = 0; i <= Steps; ++i)
  {
    ASSERT_TRUE(path->GetView(4.0 * i / Steps, camera));
    camera->GetPosition(positions[i].data());
    nearest = std::min(nearest, camera->GetDistance());
    farthest = std::max(farthest, camera->GetDistance());
    EXPECT_NEAR(positions[i][2], 0.0, 1e-9) << "it stays in the plane of the views";
  }
  // The change of the step from frame to frame: in a path with corners it would be as large as a step at each view.
  double largestStep = 0.0;
  double largestChange = 0.0;
  for (int i = 1; i < Steps; ++i)
  {
    double change[3];
    for (int c = 0; c < 3; ++c)
    {
      change[c] = positions[i + 1][c] - 2.0 * positions[i][c] + positions[i - 1][c];
    }
    largestChange = std::max(largestChange, vtkMath::Norm(change));
    largestStep =
      std::max(largestStep, std::sqrt(vtkMath::Distance2BetweenPoints(positions[i].data(), positions[i + 1].data())));
  }
  std::cout << "distance " << nearest << " to " << farthest << ", step " << largestStep << ", change " << largestChange
            << "\n";
  EXPECT_NEAR(nearest, 10.0, 1e-6);
  EXPECT_NEAR(farthest, 10.0, 1e-6);
  EXPECT_GT(largestStep, 0.05);
  EXPECT_LT(largestChange, 0.1 * largestStep);
}

TEST_F(CameraPath, ZoomsEvenly)
{
  vtkNew<vtkMTCameraPath> path;
  vtkNew<vtkCamera> camera;
  for (int i = 0; i < 4; ++i)
  {
    Look(camera, std::pow(10.0, i), 0.0, 0.0);
    ASSERT_TRUE(path->AddView(i, camera));
  }
  ASSERT_TRUE(path->GetView(1.5, camera));
  EXPECT_NEAR(camera->GetDistance(), std::pow(10.0, 1.5), 1e-6);
}

TEST_F(CameraPath, TimesOutsideAreClampedAndNonsenseIsRefused)
{
  vtkNew<vtkMTCameraPath> path;
  vtkNew<vtkCamera> camera;
  Look(camera, 5.0, 0.0, 0.0);
  const View before = Get(camera);
  EXPECT_FALSE(path->GetView(0.0, camera)) << "there are no views";
  EXPECT_EQ(Get(camera), before);
  MakeCircle(path, 3, 90.0);
  EXPECT_FALSE(path->GetView(std::numeric_limits<double>::quiet_NaN(), camera));
  EXPECT_EQ(Get(camera), before);
  ASSERT_TRUE(path->GetView(-5.0, camera));
  EXPECT_EQ(camera->GetPosition()[0], 10.0);
  ASSERT_TRUE(path->GetView(1e9, camera));
  EXPECT_EQ(camera->GetPosition()[0], 10.0 * std::cos(vtkMath::Pi()));

  EXPECT_FALSE(path->AddView(2.0, camera)) << "the last view has that time";
  EXPECT_FALSE(path->AddView(std::numeric_limits<double>::infinity(), camera));
  EXPECT_FALSE(path->AddView(3.0, nullptr));
  Look(camera, 0.0, 0.0, 5.0); // view up points along the view
  EXPECT_FALSE(path->AddView(3.0, camera));
  EXPECT_NE(path->GetErrorMessage().find("must differ"), std::string::npos) << path->GetErrorMessage();
  EXPECT_EQ(path->GetNumberOfViews(), 3);
  path->RemoveAllViews();
  EXPECT_EQ(path->GetNumberOfViews(), 0);
}
