// SPDX-License-Identifier: BSD-3-Clause
// Previews of streams: few clusters however large the mesh is, near to it, and the mesh itself where it is small.
#include "vtkMTFractalSphere.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTStreamPreview.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
bool Always()
{
  return true;
}

void ExpectBounds(vtkPolyData* mesh, const std::array<double, 6>& bounds, double tolerance)
{
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(mesh->GetBounds()[i], bounds[i], tolerance) << i;
  }
}
}

TEST(StreamPreview, AMeshOfFewerPointsThanTheLimitIsDrawnAsItIs)
{
  vtkMTFractalSphere sphere(20480);
  vtkMTStreamPreview preview(20000);
  std::string error;
  ASSERT_TRUE(preview.Read(sphere, Always, error)) << error;
  EXPECT_EQ(preview.GetNumberOfClusters(), sphere.GetNumberOfPoints());
  EXPECT_EQ(preview.GetNumberOfTriangles(), sphere.GetNumberOfTriangles());
  vtkNew<vtkPolyData> mesh;
  preview.Make(mesh);
  ASSERT_TRUE(sphere.Rewind());
  vtkMTTriangleStream::PointBlock block;
  ASSERT_TRUE(sphere.NextPoints(block));
  double largest = 0.0;
  for (std::size_t i = 0; i < block.Points.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(mesh->GetPoint(static_cast<vtkIdType>(i))[c] - block.Points[i][c]));
    }
  }
  std::cout << largest << " off\n";
  EXPECT_LT(largest, 1e-14);
}

TEST(StreamPreview, StaysWithinItsLimitAndNearTheMesh)
{
  vtkMTFractalSphere sphere(327680);
  vtkMTStreamPreview whole(1000000);
  std::string error;
  ASSERT_TRUE(whole.Read(sphere, Always, error)) << error;
  vtkNew<vtkPolyData> reference;
  whole.Make(reference);
  std::array<double, 6> bounds;
  reference->GetBounds(bounds.data());
  for (const std::size_t limit : { 10000, 500, 8, 0 })
  {
    vtkMTStreamPreview preview(limit);
    ASSERT_TRUE(preview.Read(sphere, Always, error)) << error;
    std::cout << limit << ": " << preview.GetNumberOfClusters() << " clusters, " << preview.GetNumberOfTriangles()
              << " triangles\n";
    EXPECT_LE(preview.GetNumberOfClusters(), std::max<std::size_t>(limit, 8));
    EXPECT_GT(preview.GetNumberOfClusters(), limit / 10);
    if (limit >= 500)
    {
      EXPECT_GT(preview.GetNumberOfTriangles(), preview.GetNumberOfClusters());
      vtkNew<vtkPolyData> mesh;
      preview.Make(mesh);
      ExpectBounds(mesh, bounds, limit == 500 ? 0.3 : 0.1);
      EXPECT_EQ(mesh->GetNumberOfPolys(), static_cast<vtkIdType>(preview.GetNumberOfTriangles()));
    }
  }
}

TEST(StreamPreview, PointsAreSeenBeforeTheFirstTriangle)
{
  vtkMTFractalSphere sphere(20480);
  vtkMTStreamPreview preview;
  std::string error;
  EXPECT_FALSE(preview.Read(
    sphere, [] { return false; }, error));
  EXPECT_EQ(error, "") << "it was ended";
  EXPECT_EQ(preview.GetNumberOfTriangles(), 0u);
  vtkNew<vtkPolyData> mesh;
  preview.Make(mesh);
  EXPECT_GT(mesh->GetNumberOfVerts(), 100);
  EXPECT_EQ(mesh->GetNumberOfVerts(), mesh->GetNumberOfPoints());
}

TEST(StreamPreview, PointsThatAreNotFiniteAndIdsThatAreNoneAreLeftOut)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<double>::max();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& x : std::vector<std::array<double, 3>>{ { nan, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 },
         { 0, 1, 0 }, { huge, -huge, 0 }, { 1, 1, 0 }, { 0, 0, std::numeric_limits<double>::infinity() } })
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const std::array<vtkIdType, 3>& t : std::vector<std::array<vtkIdType, 3>>{
         { 0, 1, 2 }, { 1, 2, 3 }, { 2, 3, 1 }, { 1, 3, 2 }, { 2, 2, 3 }, { 6, 5, 4 }, { 1, 4, 5 } })
  {
    cells->InsertNextCell({ t[0], t[1], t[2] });
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  vtkMTPolyDataStream stream(mesh);
  vtkMTStreamPreview preview;
  std::string error;
  ASSERT_TRUE(preview.Read(stream, Always, error)) << error;
  EXPECT_LE(preview.GetNumberOfClusters(), 5u);
  vtkNew<vtkPolyData> output;
  preview.Make(output);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_TRUE(std::isfinite(output->GetPoint(i)[0]) && std::isfinite(output->GetPoint(i)[2]));
  }
}
