// SPDX-License-Identifier: BSD-3-Clause
// The VTK sources over the generators: the streams' triangles, settings, progress and abort.
#include "vtkMTFractalSphere.h"
#include "vtkMTFractalSphereSource.h"
#include "vtkMTPlane.h"
#include "vtkMTPlaneSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace
{
// How many points and triangles of the polydata are not the stream's, by value and order.
vtkIdType CountDifferent(vtkMTTriangleStream& stream, vtkPolyData* mesh)
{
  EXPECT_EQ(static_cast<std::uint64_t>(mesh->GetNumberOfPoints()), stream.GetNumberOfPoints());
  EXPECT_EQ(static_cast<std::uint64_t>(mesh->GetNumberOfPolys()), stream.GetNumberOfTriangles());
  EXPECT_EQ(mesh->GetNumberOfCells(), mesh->GetNumberOfPolys());
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_TRUE(stream.Rewind());
  vtkIdType different = 0;
  vtkIdType next = 0;
  vtkMTTriangleStream::PointBlock points;
  while (stream.NextPoints(points) && !points.Points.empty())
  {
    for (const auto& point : points.Points)
    {
      double p[3];
      mesh->GetPoint(next++, p);
      different += !std::equal(p, p + 3, point.begin());
    }
  }
  EXPECT_EQ(next, mesh->GetNumberOfPoints());
  next = 0;
  vtkMTTriangleStream::TriangleBlock triangles;
  while (stream.NextTriangles(triangles) && !triangles.Triangles.empty())
  {
    for (const auto& triangle : triangles.Triangles)
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      mesh->GetPolys()->GetCellAtId(next++, count, corners);
      different += count != 3 ||
        !std::equal(corners, corners + 3, triangle.begin(),
          [](vtkIdType a, std::uint64_t b) { return static_cast<std::uint64_t>(a) == b; });
    }
  }
  EXPECT_EQ(next, mesh->GetNumberOfPolys());
  return different;
}

struct Watch
{
  std::vector<double> Seen;
  double AbortAt = 2.0;
  int Errors = 0;
  vtkNew<vtkCallbackCommand> Command;

  explicit Watch(vtkAlgorithm* algorithm)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject* caller, unsigned long event, void* data, void*)
      {
        auto* self = static_cast<Watch*>(data);
        if (event == vtkCommand::ErrorEvent)
        {
          ++self->Errors;
          return;
        }
        auto* source = static_cast<vtkAlgorithm*>(caller);
        self->Seen.push_back(source->GetProgress());
        source->SetAbortExecute(self->Seen.back() >= self->AbortAt);
      });
    algorithm->AddObserver(vtkCommand::ProgressEvent, this->Command);
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
};

template <class Source>
void ExpectProgressAndAbort()
{
  vtkNew<Source> source;
  source->SetNumberOfTriangles(300000);
  Watch watch(source);
  source->Update();
  EXPECT_TRUE(std::is_sorted(watch.Seen.begin(), watch.Seen.end()));
  EXPECT_DOUBLE_EQ(watch.Seen.back(), 1.0);
  EXPECT_GT(watch.Seen.size(), 10u);
  const vtkIdType whole = source->GetOutput()->GetNumberOfPolys();
  EXPECT_GT(whole, 100000);
  for (const double at : { 0.1, 0.7 }) // among the points, among the triangles
  {
    watch.AbortAt = at;
    source->Modified();
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0) << at;
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0) << at;
  }
  watch.AbortAt = 2.0;
  source->Modified();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), whole) << "nothing is left of an abort";
  EXPECT_EQ(watch.Errors, 0) << "an abort is no error";
}
}

TEST(Sources, GiveTheTrianglesOfTheirStreams)
{
  for (const auto& [triangles, seed] :
    std::vector<std::pair<vtkIdType, std::uint64_t>>{ { 1, 0 }, { 1000, 0 }, { 20000, 7 }, { 81920, 0 } })
  {
    vtkNew<vtkMTFractalSphereSource> sphere;
    sphere->SetNumberOfTriangles(triangles);
    sphere->SetSeed(static_cast<vtkIdType>(seed));
    sphere->Update();
    vtkMTFractalSphere stream(static_cast<std::uint64_t>(triangles), seed);
    EXPECT_EQ(CountDifferent(stream, sphere->GetOutput()), 0) << triangles;
    vtkNew<vtkMTPlaneSource> plane;
    plane->SetNumberOfTriangles(triangles);
    plane->Update();
    vtkMTPlane flat(static_cast<std::uint64_t>(triangles));
    EXPECT_EQ(CountDifferent(flat, plane->GetOutput()), 0) << triangles;
    std::cout << triangles << " wanted: " << sphere->GetOutput()->GetNumberOfPolys() << " and "
              << plane->GetOutput()->GetNumberOfPolys() << "\n";
  }
}

TEST(Sources, HaveTheDefaultsAndRangesThatTheirHeadersSay)
{
  vtkNew<vtkMTFractalSphereSource> sphere;
  EXPECT_EQ(sphere->GetNumberOfTriangles(), 81920);
  EXPECT_EQ(sphere->GetSeed(), 0);
  sphere->SetNumberOfTriangles(-5);
  EXPECT_EQ(sphere->GetNumberOfTriangles(), 1);
  sphere->SetNumberOfTriangles(vtkIdType(1) << 40);
  EXPECT_EQ(sphere->GetNumberOfTriangles(), 4294967295);
  vtkNew<vtkMTPlaneSource> plane;
  EXPECT_EQ(plane->GetNumberOfTriangles(), 20000);
  plane->SetNumberOfTriangles(0);
  EXPECT_EQ(plane->GetNumberOfTriangles(), 1);
  plane->Update();
  EXPECT_EQ(plane->GetOutput()->GetNumberOfPolys(), 2);
}

TEST(Sources, ReportProgressAndCanBeAborted)
{
  ExpectProgressAndAbort<vtkMTFractalSphereSource>();
  ExpectProgressAndAbort<vtkMTPlaneSource>();
}
