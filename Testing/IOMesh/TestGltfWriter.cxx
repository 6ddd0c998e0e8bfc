// SPDX-License-Identifier: BSD-3-Clause
// glTF that is written and read again.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "vtkMTMeshReader.h"
#include "vtkMTMeshWriter.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

using namespace MTIOTest;

namespace
{
MTTestMeshes::Mesh MakeMesh(double offset)
{
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(2);
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGBA");
  colors->SetNumberOfComponents(4);
  vtkNew<vtkFloatArray> heat;
  heat->SetName("heat");
  vtkNew<vtkDoubleArray> precise;
  precise->SetName("precise");
  vtkNew<vtkIntArray> part;
  part->SetName("part");
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points->InsertNextPoint(offset + p[0], offset + p[1], p[2]);
    normals->InsertNextTuple(p);
    coordinates->InsertNextTuple2(0.25, static_cast<double>(i) / 256.0);
    colors->InsertNextTuple4(i % 256, 3, 200, 128);
    heat->InsertNextValue(0.5f * static_cast<float>(i));
    precise->InsertNextValue(0.1);
  }
  part->SetNumberOfValues(mesh->GetNumberOfCells());
  part->Fill(1);
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(coordinates);
  mesh->GetPointData()->SetScalars(colors);
  mesh->GetPointData()->AddArray(heat);
  mesh->GetPointData()->AddArray(precise);
  mesh->GetCellData()->AddArray(part);
  return mesh;
}

void ExpectRoundTrip(const std::string& name, double offset, double tolerance)
{
  const std::string path = (std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / name).string();
  const MTTestMeshes::Mesh mesh = MakeMesh(offset);
  std::string error;
  std::vector<std::string> dropped;
  ASSERT_TRUE(vtkMTMeshWriter::Write(path, mesh, error, &dropped)) << error;
  EXPECT_EQ(dropped, (std::vector<std::string>{ "point precise", "cell part" }));
  vtkNew<vtkPolyData> read;
  ASSERT_TRUE(vtkMTMeshReader::Read(path, read, error)) << error;
  ASSERT_EQ(read->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  ASSERT_EQ(read->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  ASSERT_NE(read->GetPointData()->GetNormals(), nullptr);
  ASSERT_NE(read->GetPointData()->GetTCoords(), nullptr);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    mesh->GetPoint(i, p);
    read->GetPoint(i, q);
    EXPECT_NEAR(p[0], q[0], tolerance) << i;
    EXPECT_NEAR(p[1], q[1], tolerance) << i;
    EXPECT_NEAR(p[2], q[2], tolerance) << i;
    EXPECT_EQ(read->GetPointData()->GetTCoords()->GetComponent(i, 1), static_cast<double>(i) / 256.0);
  }
  EXPECT_NEAR(read->GetPointData()->GetNormals()->GetComponent(5, 2),
    mesh->GetPointData()->GetNormals()->GetComponent(5, 2), 1e-6);
  std::filesystem::remove(path);
}
}

TEST(GltfWriter, WhatIsWrittenReadsBack)
{
  ExpectRoundTrip("round.glb", 0.0, 1e-7);
  ExpectRoundTrip("round.gltf", 0.0, 1e-7);
}

TEST(GltfWriter, PlacesFarFromTheOriginKeepTheirDigitsInTheFile)
{
  const std::string path = (std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "far.gltf").string();
  std::string error;
  ASSERT_TRUE(vtkMTMeshWriter::Write(path, MakeMesh(4.2e6), error)) << error;
  const Bytes bytes = ReadFile(path);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("\"translation\":[4200000.0,4200000.0,0.0]"), std::string::npos) << text.substr(0, 400);
  std::filesystem::remove(path);
  ExpectRoundTrip("far.glb", 4.2e6, 1e-7);
}

TEST(GltfWriter, AFailureLeavesTheEarlierFile)
{
  const std::string path = (std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "kept.glb").string();
  WriteFile(path, std::string("earlier"));
  vtkNew<vtkPolyData> empty;
  std::string error;
  EXPECT_FALSE(vtkMTMeshWriter::Write(path, empty, error));
  EXPECT_NE(error.find("kept.glb"), std::string::npos) << error;
  const Bytes bytes = ReadFile(path);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "earlier");
  std::filesystem::remove(path);
}
