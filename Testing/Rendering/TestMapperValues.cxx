// SPDX-License-Identifier: BSD-3-Clause
// Cuts by the certified deviation of an array's values.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
// The elevation is a coordinate, so it deviates by no more than the distance: the measure is true.
vtkSmartPointer<vtkMultiTriangulationMapper> MakeMapper(double pixelError)
{
  MTGridModel grid;
  grid.Cells = 256;
  const auto store = grid.Make();
  vtkMTGraph& graph = store->GetMutableGraph();
  vtkMTMeasure measure{ vtkMTMeasure::GetValueDeviationName("Elevation"), {} };
  for (const vtkMTNode& node : graph.Nodes)
  {
    measure.Values.push_back(node.Error);
  }
  measure.Values.back() = 0.0;
  graph.Measures.push_back(measure);
  vtkNew<vtkMultiTriangulation> input;
  input->SetSource(store);
  auto mapper = vtkSmartPointer<vtkMultiTriangulationMapper>::New();
  mapper->SetInputData(input);
  mapper->SetPixelError(pixelError);
  mapper->SetScalarRange(-0.15, 0.15);
  mapper->WaitForConvergenceOn();
  return mapper;
}

// Root mean square of the difference of two pictures, in grey levels.
double GetDifference(vtkImageData* a, vtkImageData* b)
{
  const auto* x = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* y = static_cast<const unsigned char*>(b->GetScalarPointer());
  const vtkIdType count = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  double sum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += (double(x[i]) - y[i]) * (double(x[i]) - y[i]);
  }
  return std::sqrt(sum / static_cast<double>(count));
}

TEST(MapperValues, ColoursComeNearerToThoseOfTheInputAsTheDeviationFalls)
{
  const auto full = MakeMapper(0.0);
  MTScene reference(full);
  reference.Actor->GetProperty()->LightingOff();
  const auto best = reference.Render();

  const auto mapper = MakeMapper(4.0);
  MTScene scene(mapper);
  scene.Actor->GetProperty()->LightingOff();
  const auto byDistance = scene.Render();
  const vtkIdType triangles = mapper->GetNumberOfTriangles();
  mapper->SetErrorMetricToValue();
  mapper->SetErrorMetricArray("Elevation");
  mapper->SetValueError(1e6);
  EXPECT_EQ(MTDifference::Compare(scene.Render(), byDistance).Pixels, 0u) << "nothing deviates by so much";
  EXPECT_EQ(mapper->GetNumberOfTriangles(), triangles);

  std::cout << "by distance: " << triangles << " triangles, RMS " << GetDifference(byDistance, best) << "\n";
  std::vector<vtkIdType> counts{ triangles };
  std::vector<double> differences{ GetDifference(byDistance, best) };
  for (const double deviation : { 0.01, 0.005, 0.002, 0.0 })
  {
    mapper->SetValueError(deviation);
    const auto picture = scene.Render();
    counts.push_back(mapper->GetNumberOfTriangles());
    differences.push_back(GetDifference(picture, best));
    std::cout << "deviation " << deviation << ": " << counts.back() << " triangles, RMS " << differences.back()
              << ", pixel error " << mapper->GetAchievedPixelError() << "\n";
    EXPECT_TRUE(mapper->GetConverged());
    EXPECT_LE(mapper->GetAchievedPixelError(), 4.0);
    EXPECT_GE(counts.back(), counts[counts.size() - 2]) << "no cut is kept from before";
    EXPECT_LE(differences.back(), differences[differences.size() - 2]);
  }
  EXPECT_GT(counts.back(), 4 * triangles);
  EXPECT_LT(differences.back(), 0.5 * differences.front());
  // What is smaller than PixelError is not refined for its values.
  EXPECT_LT(counts.back(), full->GetNumberOfTriangles());
  mapper->SetValueError(1e6);
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), triangles);
  mapper->SetErrorMetricArray("another");
  scene.Render();
  EXPECT_GT(mapper->GetNumberOfTriangles(), triangles) << "of which nothing is known";
}

TEST(MapperValues, ModelsWithoutTheMeasureAreDrawnByTheLargerOfDistanceAndEdges)
{
  const auto mapper = MakeMapper(4.0);
  MTScene scene(mapper);
  scene.Render();
  const vtkIdType byDistance = mapper->GetNumberOfTriangles();
  mapper->SetErrorMetricToEdgeLength();
  const auto byEdges = scene.Render();
  EXPECT_GT(mapper->GetNumberOfTriangles(), byDistance);
  mapper->SetErrorMetricToValue();
  mapper->SetValueError(1e6);
  for (const char* name : { "no such array", "Block", "", static_cast<const char*>(nullptr) })
  {
    mapper->SetErrorMetricArray(name);
    EXPECT_EQ(MTDifference::Compare(scene.Render(), byEdges).Pixels, 0u) << "edges are longer than errors here";
  }
}

TEST(MapperValues, SettingsAreClampedCopiedAndPrinted)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  EXPECT_STREQ(mapper->GetErrorMetricArray(), "");
  EXPECT_EQ(mapper->GetValueError(), 0.0);
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  mapper->AddObserver(vtkCommand::ErrorEvent, count);
  mapper->SetValueError(-1.0);
  EXPECT_EQ(mapper->GetValueError(), 0.0);
  mapper->SetValueError(0.25);
  mapper->SetValueError(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(mapper->GetValueError(), 0.25);
  EXPECT_EQ(errors, 1);
  mapper->SetErrorMetric(7);
  EXPECT_EQ(mapper->GetErrorMetric(), vtkMultiTriangulationMapper::VALUE);
  mapper->SetErrorMetricArray("thickness");
  vtkNew<vtkMultiTriangulationMapper> copy;
  copy->ShallowCopy(mapper);
  EXPECT_EQ(copy->GetErrorMetric(), vtkMultiTriangulationMapper::VALUE);
  EXPECT_STREQ(copy->GetErrorMetricArray(), "thickness");
  EXPECT_EQ(copy->GetValueError(), 0.25);
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetValueError(0.25);
  EXPECT_EQ(mapper->GetMTime(), before);
  std::ostringstream text;
  copy->Print(text);
  for (const char* line : { "ErrorMetric: Value", "ErrorMetricArray: thickness", "ValueError: 0.25" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
}
