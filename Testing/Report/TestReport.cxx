// SPDX-License-Identifier: BSD-3-Clause
// What the report measures with is right where the answer is known.
#include "MTReportChart.h"
#include "MTReportPage.h"
#include "MTReportPicture.h"
#include "MTReportReference.h"
#include "MTReportTable.h"
#include "MTReportTimes.h"
#include "MTTestMeshes.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace
{
// A square of two triangles, at this height, rising along x by the slope.
MTTestMeshes::Mesh MakeSquare(double height, double slope = 0.0)
{
  return MTTestMeshes::Make({ { 0, 0, height }, { 1, 0, height + slope }, { 1, 1, height + slope }, { 0, 1, height } },
    { { 0, 1, 2 }, { 0, 2, 3 } }, VTK_DOUBLE);
}

// Two squares, one above the other.
MTTestMeshes::Mesh MakeSheets(double low, double high)
{
  return MTTestMeshes::Make({ { 0, 0, low }, { 1, 0, low }, { 1, 1, low }, { 0, 1, low }, { 0, 0, high },
                              { 1, 0, high }, { 1, 1, high }, { 0, 1, high } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } }, VTK_DOUBLE);
}

MTReportPicture TakePicture(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  const auto& background = MTReportPicture::Background;
  renderer->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(120, 100);
  window->AddRenderer(renderer);
  window->Render();
  return MTReportPicture(window);
}
}

TEST(ReportReference, AShiftedSquareIsItsShiftAway)
{
  const MTReportReference reference(MakeSquare(0.0));
  const MTReportDeviation deviation = reference.Measure(MakeSquare(0.125), 1000);
  std::cout << "RMS " << deviation.RootMeanSquare << ", maximum " << deviation.Maximum << ", normals "
            << deviation.NormalMean << " degrees\n";
  EXPECT_DOUBLE_EQ(deviation.RootMeanSquare, 0.125);
  EXPECT_DOUBLE_EQ(deviation.Maximum, 0.125);
  EXPECT_NEAR(deviation.NormalMean, 0.0, 1e-5);
}

TEST(ReportReference, ATiltedSquareIsTurnedByItsAngle)
{
  const MTReportDeviation deviation = MTReportReference(MakeSquare(0.0)).Measure(MakeSquare(0.0, 0.1), 1000);
  const double angle = std::atan(0.1) * 180.0 / 3.14159265358979323846;
  std::cout << deviation.NormalMean << " and " << deviation.Normal95 << " of " << angle << " degrees\n";
  EXPECT_NEAR(deviation.NormalMean, angle, 1e-6);
  EXPECT_NEAR(deviation.Normal95, angle, 1e-6);
}

TEST(ReportReference, TheFarthestPlaceWithinATriangleIsClimbedTo)
{
  // A square from the lower sheet to the upper one: its corners are on them, half way it is 1 from both, and no corner
  // of the sheets is as far from it.
  const MTReportDeviation deviation = MTReportReference(MakeSheets(-1.0, 1.0)).Measure(MakeSquare(-1.0, 2.0), 20);
  std::cout << "maximum " << deviation.Maximum << " of 1\n";
  EXPECT_GT(deviation.Maximum, 0.995);
  EXPECT_LE(deviation.Maximum, 1.0);
}

TEST(ReportReference, FiguresAreTheSameAgain)
{
  const auto mesh = MTTestMeshes::FractalSphere(4);
  const auto other = MTTestMeshes::FractalSphere(3);
  const MTReportDeviation first = MTReportReference(mesh).Measure(other, 5000);
  const MTReportDeviation second = MTReportReference(mesh).Measure(other, 5000);
  EXPECT_EQ(first.RootMeanSquare, second.RootMeanSquare);
  EXPECT_EQ(first.Maximum, second.Maximum);
  EXPECT_EQ(first.NormalMean, second.NormalMean);
  EXPECT_EQ(first.Normal95, second.Normal95);
}

TEST(ReportPicture, ADifferenceIsThatOfTheModelsPixels)
{
  const MTReportPicture square = TakePicture(MakeSquare(0.0));
  const MTReportDifference none = square.Compare(square);
  EXPECT_EQ(none.Largest, 0.0);
  EXPECT_EQ(none.Outline, 0.0);
  EXPECT_DOUBLE_EQ(none.Similarity, 1.0);
  const MTReportDifference tilted = square.Compare(TakePicture(MakeSquare(0.0, 1.0)));
  std::cout << "RMS " << tilted.RootMeanSquare << ", above 20 " << tilted.ShareAbove20 << ", SSIM " << tilted.Similarity
            << ", outline " << tilted.Outline << "\n";
  EXPECT_GT(tilted.ShareAbove20, 0.5);
  EXPECT_LT(tilted.Similarity, 0.99);
  EXPECT_GT(tilted.Outline, 2.0);
}

TEST(ReportTimes, MedianAndSpreadAreThoseOfTheNumbers)
{
  MTReportTimes times;
  for (const double seconds : { 3.0, 1.0, 2.0 })
  {
    times.Add(seconds);
  }
  EXPECT_EQ(times.GetMedian(), 2.0);
  EXPECT_EQ(times.GetSpread(), 100.0);
}

TEST(ReportTable, ARowOfAnotherLengthIsRefused)
{
  MTReportTable table("name", "caption", { { "a", "" }, { "b", "%" } });
  EXPECT_THROW(table.AddRow({ 1.0 }), std::logic_error);
  table.AddRow({ "x", 0.25 });
  EXPECT_EQ(table.ToMarkdown(), "| a | b [%] |\n|---|---|\n| x | 0.25 |\n");
}

TEST(ReportSection, AChartWithoutPointsIsAText)
{
  const std::string folder = MT_TEST_OUTPUT_DIRECTORY;
  MTReportSection section("title", folder);
  MTReportChart chart("report-test-chart", "Nothing", { "x", true }, { "y", true });
  chart.AddPoint("zero", 1.0, 0.0); // not shown on a logarithmic axis
  section.AddChart(chart);
  EXPECT_NE(section.GetMarkdown().find("nothing to draw"), std::string::npos);
  chart.AddPoint("one", 1.0, 1.0);
  chart.AddPoint("one", 2.0, 10.0);
  section.AddChart(chart);
  vtkNew<vtkPNGReader> reader;
  const std::string file = folder + "/report-test-chart.png";
  EXPECT_NE(reader->CanReadFile(file.c_str()), 0);
  std::filesystem::remove(file);
}
