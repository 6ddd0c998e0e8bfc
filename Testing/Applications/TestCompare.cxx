// SPDX-License-Identifier: BSD-3-Clause
// `bmt compare`: distances that are known, and the same ones whatever the threads.
#include "MTRunBmt.h"
#include "MTTestMeshes.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cmath>
#include <iostream>

namespace
{
void WriteVtp(vtkPolyData* mesh, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(path.c_str());
  writer->Write();
}

vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, double x, double y, double z)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(x, y, z);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->SetTransform(transform);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}
}

using Compare = MTBmtTest;

TEST_F(Compare, ParallelSheetsAreAtTheirDistance)
{
  const auto sheet = MTTestMeshes::Terrain(40, 40);
  WriteVtp(sheet, this->Path("a.vtp"));
  WriteVtp(Moved(sheet, 0.0, 0.0, 0.0), this->Path("same.vtp"));
  const nlohmann::json same =
    this->BmtJson({ "compare", this->Path("a.vtp"), this->Path("same.vtp"), "--samples", "10000" });
  EXPECT_LT(same["max"].get<double>(), 1e-12);
  EXPECT_NEAR(same["diagonal"].get<double>(), sheet->GetLength(), 1e-6);

  this->BmtJson({ "generate", "plane", "--triangles", "200", "-o", this->Path("plane.ply") });
  const auto flat = MTTestMeshes::Make(
    { { 0, 0, 0.25 }, { 1, 0, 0.25 }, { 1, 1, 0.25 }, { 0, 1, 0.25 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  WriteVtp(flat, this->Path("raised.vtp"));
  const nlohmann::json raised =
    this->BmtJson({ "compare", this->Path("plane.ply"), this->Path("raised.vtp"), "--samples", "1000" });
  for (const char* name : { "max", "rms", "max_ab", "max_ba", "rms_ab", "rms_ba" })
  {
    EXPECT_NEAR(raised[name].get<double>(), 0.25, 1e-12) << name;
  }
  EXPECT_NEAR(raised["diagonal"].get<double>(), std::sqrt(2.0 + 0.0625), 1e-12);
}

TEST_F(Compare, TheTwoDirectionsAreToldApart)
{
  // A: the unit square. B: its left half. From A to B the distance grows to 1/2, from B to A it is 0.
  WriteVtp(MTTestMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }),
    this->Path("a.vtp"));
  WriteVtp(MTTestMeshes::Make({ { 0, 0, 0 }, { 0.5, 0, 0 }, { 0.5, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }),
    this->Path("b.vtp"));
  const nlohmann::json json =
    this->BmtJson({ "compare", this->Path("a.vtp"), this->Path("b.vtp"), "--samples", "100000" });
  EXPECT_NEAR(json["max_ab"].get<double>(), 0.5, 1e-12);
  EXPECT_LT(json["max_ba"].get<double>(), 1e-15);
  EXPECT_LT(json["rms_ba"].get<double>(), 1e-15);
  // The mean of d^2 over A: half of it is 0, the other half the mean of t^2 for t in [0, 1/2], 1/12.
  EXPECT_NEAR(json["rms_ab"].get<double>(), std::sqrt(1.0 / 24.0), 1e-3);
  EXPECT_NEAR(json["rms"].get<double>(), std::sqrt(0.5 / 24.0), 1e-3);
}

TEST_F(Compare, FarFromTheOriginNoDigitsAreLost)
{
  const auto sphere = MTTestMeshes::Icosphere(4);
  WriteVtp(Moved(sphere, 6378137.0, 4.5e6, -1e5), this->Path("a.vtp"));
  WriteVtp(Moved(sphere, 6378137.0 + 1e-4, 4.5e6, -1e5), this->Path("b.vtp"));
  const nlohmann::json json =
    this->BmtJson({ "compare", this->Path("a.vtp"), this->Path("b.vtp"), "--samples", "50000" });
  std::cout << json.dump() << "\n";
  EXPECT_NEAR(json["max"].get<double>(), 1e-4, 3e-9); // the coordinates themselves are rounded to 1e-9
}

TEST_F(Compare, FiguresDoNotDependOnThreads)
{
  this->MakeSphere(20480);
  this->BmtJson({ "generate", "fractal-sphere", "--triangles", "5120", "-o", this->Path("coarse.ply") });
  const std::vector<std::string> call = { "compare", this->Path("sphere.ply"), this->Path("coarse.ply"), "--samples",
    "100000", "--json" };
  MTRunOptions one;
  one.Environment = { "VTK_SMP_BACKEND_IN_USE=Sequential" };
  const MTRun alone = this->Bmt(call, one);
  const MTRun together = this->Bmt(call);
  EXPECT_EQ(alone.Exit, 0) << alone.Err;
  EXPECT_EQ(alone.Out, together.Out);
}

TEST_F(Compare, NonFiniteAndDegenerateTrianglesAreNoSurface)
{
  auto dirty = MTTestMeshes::Icosphere(3);
  const vtkIdType points = dirty->GetNumberOfPoints();
  dirty->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  dirty->GetPoints()->InsertNextPoint(50.0, 0.0, 0.0);
  dirty->GetPolys()->InsertNextCell({ vtkIdType(0), vtkIdType(1), points });
  dirty->GetPolys()->InsertNextCell({ points + 1, points + 1, vtkIdType(0) });
  WriteVtp(dirty, this->Path("dirty.vtp"));
  WriteVtp(MTTestMeshes::Icosphere(3), this->Path("clean.vtp"));
  const nlohmann::json json =
    this->BmtJson({ "compare", this->Path("dirty.vtp"), this->Path("clean.vtp"), "--samples", "1000" });
  EXPECT_LT(json["max"].get<double>(), 1e-12);
  EXPECT_LT(json["diagonal"].get<double>(), 4.0);
}
