// SPDX-License-Identifier: BSD-3-Clause
// What bmt takes and gives: several inputs, terrain, volumes, glTF, drawings of the DAG.
#include "MTRunBmt.h"
#include "MTTestMeshes.h"

#include "vtkMTMeshReader.h"
#include "vtkMTMeshWriter.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataWriter.h"

#include <cmath>
#include <set>

class InputOutput : public MTBmtTest
{
protected:
  void Write(const std::string& name, vtkPolyData* mesh) const
  {
    std::string error;
    ASSERT_TRUE(vtkMTMeshWriter::Write(this->Path(name), mesh, error)) << error;
  }

  void ExpectVerified(const std::vector<std::string>& inputs, const std::vector<std::string>& options = {}) const
  {
    std::vector<std::string> call = { "verify", this->Path("out.bmt"), "--cuts", "20", "--samples", "5000" };
    for (const std::string& input : inputs)
    {
      call.insert(call.end(), { "--input", this->Path(input) });
    }
    call.insert(call.end(), options.begin(), options.end());
    const MTRun run = this->Bmt(call);
    EXPECT_EQ(run.Exit, 0) << run.Out << run.Err;
  }

  // 31 x 31 samples of one degree.
  void WriteTile(const std::string& name, int west, bool withVoid) const
  {
    std::string bytes;
    for (int row = 0; row < 31; ++row)
    {
      for (int column = 0; column < 31; ++column)
      {
        const bool isVoid = withVoid && row == 15 && column == 15;
        const double height = 500.0 + 300.0 * std::sin(0.2 * (30 * west + column)) * std::cos(0.3 * row);
        const auto value = static_cast<std::uint16_t>(isVoid ? -32768 : std::lround(height));
        bytes += static_cast<char>(value >> 8);
        bytes += static_cast<char>(value & 0xff);
      }
    }
    this->WriteFile(name, bytes);
  }
};

TEST_F(InputOutput, SeveralInputsAreOneModelWhosePartsStayApart)
{
  // Two halves of one sphere: alone they would be stitched along the cut.
  const auto sphere = MTTestMeshes::SphereSoup(3);
  std::vector<MTTestMeshes::Place> places[2];
  std::vector<MTTestMeshes::Corners> triangles[2];
  for (vtkIdType t = 0; t < sphere->GetNumberOfPolys(); ++t)
  {
    const std::size_t half = t % 2;
    vtkNew<vtkIdList> corners;
    sphere->GetCellPoints(t, corners);
    const auto first = static_cast<vtkIdType>(places[half].size());
    for (vtkIdType c = 0; c < 3; ++c)
    {
      places[half].emplace_back();
      sphere->GetPoint(corners->GetId(c), places[half].back().data());
    }
    triangles[half].push_back({ first, first + 1, first + 2 });
  }
  this->Write("a.ply", MTTestMeshes::Make(places[0], triangles[0]));
  this->Write("b.stl", MTTestMeshes::Make(places[1], triangles[1]));
  const nlohmann::json built = this->BmtJson(
    { "build", this->Path("a.ply"), this->Path("b.stl"), "-o", this->Path("out.bmt"), "--patch-triangles", "100" });
  EXPECT_EQ(built["triangles"], sphere->GetNumberOfPolys());
  EXPECT_EQ(built["parts"].size(), 2u);
  EXPECT_EQ(built["parts"][1]["cells"], triangles[1].size());
  this->ExpectVerified({ "a.ply", "b.stl" });

  this->BmtJson({ "extract", this->Path("out.bmt"), "-o", this->Path("out.vtp"), "--level", "0" });
  vtkNew<vtkPolyData> mesh;
  std::string error;
  ASSERT_TRUE(vtkMTMeshReader::Read(this->Path("out.vtp"), mesh, error)) << error;
  vtkDataArray* parts = mesh->GetCellData()->GetArray("PartId");
  ASSERT_NE(parts, nullptr);
  std::vector<std::set<int>> ofPoint(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  std::size_t ofB = 0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    const int part = static_cast<int>(parts->GetComponent(t, 0));
    ofB += part == 1 ? 1 : 0;
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(t, corners);
    for (vtkIdType c = 0; c < 3; ++c)
    {
      ofPoint[static_cast<std::size_t>(corners->GetId(c))].insert(part);
    }
  }
  EXPECT_EQ(ofB, triangles[1].size());
  for (const std::set<int>& of : ofPoint)
  {
    EXPECT_EQ(of.size(), 1u) << "a point of two parts";
  }
}

TEST_F(InputOutput, AllTilesAreOneTerrain)
{
  this->WriteTile("N45E006.hgt", 6, false);
  this->WriteTile("N45E007.hgt", 7, true);
  const nlohmann::json built = this->BmtJson({ "build", this->Path("N45E006.hgt"), this->Path("N45E007.hgt"), "-o",
    this->Path("out.bmt"), "--vertical-scale", "10", "--patch-triangles", "100" });
  EXPECT_EQ(built["triangles"], 2 * 60 * 30 - 4);
  EXPECT_EQ(built["input_report"]["terrain_voids"], 1);
  EXPECT_EQ(built["input_report"]["terrain_tiles"], 2);
  EXPECT_FALSE(built.contains("parts"));
  EXPECT_GT(built["bounds"][5], 5000.0);
  this->ExpectVerified({ "N45E006.hgt", "N45E007.hgt" }, { "--vertical-scale", "10" });
}

TEST_F(InputOutput, AVolumeNeedsAnIsovalue)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(30, 30, 30);
  volume->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 30 * 30 * 30; ++i)
  {
    volume->GetPointData()->GetScalars()->SetComponent(
      i, 0, std::hypot(i % 30 - 14.3, i / 30 % 30 - 14.6, i / 900 - 14.2));
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(volume);
  writer->SetFileName(this->Path("ball.vti").c_str());
  writer->Write();
  const MTRun run = this->Bmt({ "build", this->Path("ball.vti"), "-o", this->Path("out.bmt") });
  EXPECT_EQ(run.Exit, 1);
  EXPECT_NE(run.Err.find("--iso"), std::string::npos) << run.Err;
  const nlohmann::json built =
    this->BmtJson({ "build", this->Path("ball.vti"), "--iso", "11", "-o", this->Path("out.bmt") });
  EXPECT_GT(built["triangles"], 2000);
  this->ExpectVerified({ "ball.vti" }, { "--iso", "11" });
}

TEST_F(InputOutput, FarOutliersAreSaidAndVerified)
{
  const auto mesh = MTTestMeshes::FractalSphere(4);
  mesh->GetPoints()->SetPoint(700, 1e30, 0.0, 0.0);
  this->Write("far.ply", mesh);
  const MTRun run = this->Bmt({ "build", this->Path("far.ply"), "-o", this->Path("out.bmt"), "--json" });
  ASSERT_EQ(run.Exit, 0) << run.Err;
  EXPECT_NE(run.Err.find("bmt: 6 of 5120 triangles are far outliers"), std::string::npos) << run.Err;
  EXPECT_EQ(run.Json()["input_report"]["dropped_far_outlier"], 6);
  this->ExpectVerified({ "far.ply" });
  const nlohmann::json kept =
    this->BmtJson({ "build", this->Path("far.ply"), "-o", this->Path("out.bmt"), "--keep-far-outliers" });
  EXPECT_FALSE(kept["input_report"].contains("dropped_far_outlier"));
}

TEST_F(InputOutput, ACutCanBeWrittenAsGltf)
{
  this->MakeModel(5120);
  for (const char* name : { "cut.glb", "cut.gltf" })
  {
    const nlohmann::json cut =
      this->BmtJson({ "extract", this->Path("sphere.bmt"), "-o", this->Path(name), "--triangles", "2000" });
    vtkNew<vtkPolyData> mesh;
    std::string error;
    ASSERT_TRUE(vtkMTMeshReader::Read(this->Path(name), mesh, error)) << error;
    EXPECT_EQ(cut["triangles"], mesh->GetNumberOfPolys());
    EXPECT_EQ(cut["points"], mesh->GetNumberOfPoints());
    EXPECT_NE(mesh->GetPointData()->GetNormals(), nullptr);
    EXPECT_EQ(cut["dropped_arrays"], nlohmann::json::array({ "cell vtkMTInputCellIds" }));
  }
}

TEST_F(InputOutput, SmallDagsAreDrawn)
{
  this->MakeModel(5120);
  const nlohmann::json info = this->BmtJson({ "info", this->Path("sphere.bmt") });
  const MTRun dot = this->Bmt({ "info", "--dot", this->Path("sphere.bmt") });
  ASSERT_EQ(dot.Exit, 0) << dot.Err;
  EXPECT_EQ(dot.Out.rfind("digraph", 0), 0u);
  std::size_t arcs = 0;
  std::size_t nodes = 0;
  for (std::size_t at = 0; (at = dot.Out.find(" -> ", at)) != std::string::npos; ++at)
  {
    ++arcs;
  }
  for (std::size_t at = 0; (at = dot.Out.find("error", at)) != std::string::npos; ++at)
  {
    ++nodes;
  }
  EXPECT_EQ(arcs, info["patches"]);
  EXPECT_EQ(nodes, info["nodes"]);
  EXPECT_EQ(this->Bmt({ "info", "--dot", "--json", this->Path("sphere.bmt") }).Exit, 2);
  this->MakeModel(81920, 30);
  const MTRun large = this->Bmt({ "info", "--dot", this->Path("sphere.bmt") });
  EXPECT_EQ(large.Exit, 1);
  EXPECT_EQ(large.Out, "");
  EXPECT_NE(large.Err.find("at most 500"), std::string::npos) << large.Err;
}
