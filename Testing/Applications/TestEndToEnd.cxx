// SPDX-License-Identifier: BSD-3-Clause
// From a mesh to a file and back, through the command alone.
#include "MTRunBmt.h"

#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include <cmath>
#include <iostream>

namespace
{
template <class Reader>
vtkSmartPointer<vtkPolyData> Read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
}

vtkIdType CountOpenOrNonManifoldEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}
}

using EndToEnd = MTBmtTest;

TEST_F(EndToEnd, GenerateMakesTheNearestIcosphere)
{
  const nlohmann::json json =
    this->BmtJson({ "generate", "fractal-sphere", "--triangles", "6000", "-o", this->Path("a.ply"), "--seed", "3" });
  EXPECT_EQ(json["triangles"], 5120);
  EXPECT_EQ(json["points"], 2562);
  this->BmtJson({ "generate", "fractal-sphere", "--triangles", "5120", "-o", this->Path("b.ply"), "--seed", "3" });
  this->BmtJson({ "generate", "fractal-sphere", "--triangles", "5120", "-o", this->Path("c.ply"), "--seed", "4" });
  EXPECT_EQ(this->ReadFile("a.ply"), this->ReadFile("b.ply"));
  EXPECT_NE(this->ReadFile("a.ply"), this->ReadFile("c.ply"));
  const auto mesh = Read<vtkPLYReader>(this->Path("a.ply"));
  EXPECT_EQ(mesh->GetNumberOfPolys(), 5120);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(CountOpenOrNonManifoldEdges(mesh), 0);
}

TEST_F(EndToEnd, GenerateMakesAPlane)
{
  const nlohmann::json json =
    this->BmtJson({ "generate", "plane", "--triangles", "190", "-o", this->Path("plane.ply") });
  EXPECT_EQ(json["triangles"], 200);
  EXPECT_EQ(Read<vtkPLYReader>(this->Path("plane.ply"))->GetNumberOfPoints(), 121);
}

TEST_F(EndToEnd, InfoHasEveryFigureThatIsPromised)
{
  this->MakeModel(20480);
  const nlohmann::json info = this->BmtJson({ "info", this->Path("sphere.bmt") });
  for (const char* name :
    { "triangles", "stored_triangles", "nodes", "patches", "levels", "bytes", "bytes_per_triangle", "bounds", "arrays",
      "partition", "simplifier", "settings", "conditioning", "root_triangles", "blocked", "input_report" })
  {
    EXPECT_TRUE(info.contains(name)) << name;
  }
  for (const char* name : { "depth", "diameter_ratio", "fully_shared_borders" })
  {
    EXPECT_TRUE(info["conditioning"].contains(name)) << name;
  }
  EXPECT_EQ(info["triangles"], 20480);
  EXPECT_EQ(info["stored_triangles"], 20480);
  EXPECT_EQ(info["bytes"].get<std::uintmax_t>(), std::filesystem::file_size(this->Path("sphere.bmt")));
  EXPECT_DOUBLE_EQ(info["bytes_per_triangle"].get<double>(), info["bytes"].get<double>() / 20480.0);
  EXPECT_EQ(info["bounds"].size(), 6u);
  EXPECT_GE(info["levels"].get<int>(), 4);
  EXPECT_LE(info["root_triangles"].get<int>(), 2 * 200) << "two mean patches at the most on a closed manifold";
  EXPECT_EQ(info["partition"], "v");
  EXPECT_EQ(info["simplifier"], "fast");
  std::cout << info.dump(1) << "\n";
}

TEST_F(EndToEnd, ModelsOfEveryPartitionAndSimplifierAreValid)
{
  this->MakeSphere(5120);
  for (const std::string partition : { "v", "regular", "kd", "quad", "hexagon" })
  {
    for (const std::string simplifier : { "fast", "best", "lindstrom-turk", "garland-heckbert" })
    {
      const std::string model = this->Path(partition + "-" + simplifier + ".bmt");
      this->BmtJson({ "build", this->Path("sphere.ply"), "-o", model, "--partition", partition, "--simplifier",
        simplifier, "--patch-triangles", "100" });
      const MTRun run = this->Bmt(
        { "verify", model, "--input", this->Path("sphere.ply"), "--cuts", "40", "--samples", "20000", "--json" });
      EXPECT_EQ(run.Exit, 0) << partition << ", " << simplifier << ": " << run.Err;
      std::cout << partition << ", " << simplifier << ": " << run.Json()["certified_over_sampled"].dump() << "\n";
    }
  }
}

TEST_F(EndToEnd, OneAndTwoThreadsGiveTheSameBytes)
{
  this->MakeSphere(20480);
  for (const std::string partition : { "v", "regular", "kd", "quad", "hexagon" })
  {
    for (const std::string threads : { "1", "2" })
    {
      this->BmtJson({ "build", this->Path("sphere.ply"), "-o", this->Path(partition + threads), "--threads", threads,
        "--patch-triangles", "200", "--partition", partition });
    }
    EXPECT_TRUE(this->ReadFile(partition + "1") == this->ReadFile(partition + "2")) << partition;
  }
}

TEST_F(EndToEnd, ExtractedCutsAreWeldedClosedAndAsLargeAsAskedFor)
{
  this->MakeModel(81920);
  const nlohmann::json info = this->BmtJson({ "info", this->Path("sphere.bmt") });
  for (const int triangles : { 10000, 15000, 30000, 60000 })
  {
    const nlohmann::json json = this->BmtJson(
      { "extract", this->Path("sphere.bmt"), "-o", this->Path("cut.ply"), "--triangles", std::to_string(triangles) });
    const auto mesh = Read<vtkPLYReader>(this->Path("cut.ply"));
    EXPECT_EQ(mesh->GetNumberOfPolys(), json["triangles"].get<vtkIdType>());
    EXPECT_LE(mesh->GetNumberOfPolys(), triangles);
    EXPECT_GE(mesh->GetNumberOfPolys(), 0.9 * triangles);
    EXPECT_EQ(CountOpenOrNonManifoldEdges(mesh), 0);
    EXPECT_EQ(mesh->GetNumberOfPoints() - mesh->GetNumberOfPolys() / 2, 2) << "Euler: a sphere without spare points";
  }
  EXPECT_EQ(this->BmtJson({ "extract", this->Path("sphere.bmt"), "-o", this->Path("all.ply"), "--triangles",
              "1000000" })["triangles"],
    info["stored_triangles"]);
}

TEST_F(EndToEnd, ATargetBelowTheRootIsAnError)
{
  this->MakeModel(5120, 100);
  const nlohmann::json info = this->BmtJson({ "info", this->Path("sphere.bmt") });
  const int root = info["root_triangles"].get<int>();
  const MTRun below = this->Bmt(
    { "extract", this->Path("sphere.bmt"), "-o", this->Path("cut.ply"), "--triangles", std::to_string(root - 1) });
  EXPECT_EQ(below.Exit, 1);
  EXPECT_NE(below.Err.find(std::to_string(root)), std::string::npos)
    << "the message says what is possible: " << below.Err;
  EXPECT_FALSE(std::filesystem::exists(this->Path("cut.ply")));
  EXPECT_EQ(this->BmtJson({ "extract", this->Path("sphere.bmt"), "-o", this->Path("cut.ply"), "--triangles",
              std::to_string(root) })["triangles"],
    root);
}

TEST_F(EndToEnd, ACutByErrorKeepsItsErrorAndCoarserLevelsHaveLargerOnes)
{
  this->MakeModel(20480);
  double last = 1e300;
  for (const std::string error : { "0.05", "0.02", "0.005" })
  {
    const nlohmann::json cut =
      this->BmtJson({ "extract", this->Path("sphere.bmt"), "-o", this->Path("cut.vtp"), "--error", error });
    const nlohmann::json distance =
      this->BmtJson({ "compare", this->Path("cut.vtp"), this->Path("sphere.ply"), "--samples", "100000" });
    std::cout << error << ": " << cut["triangles"] << " triangles, certified " << cut["error"] << ", sampled "
              << distance["max"] << "\n";
    EXPECT_LE(cut["error"].get<double>(), std::stod(error));
    EXPECT_LE(distance["max"].get<double>(), cut["error"].get<double>() + 1e-12);
    EXPECT_LT(distance["max"].get<double>(), last);
    last = distance["max"].get<double>();
  }
  const int levels = this->BmtJson({ "info", this->Path("sphere.bmt") })["levels"].get<int>();
  std::int64_t triangles = 0;
  for (int level = levels - 1; level >= 0; --level)
  {
    const nlohmann::json cut = this->BmtJson(
      { "extract", this->Path("sphere.bmt"), "-o", this->Path("cut.stl"), "--level", std::to_string(level) });
    EXPECT_GT(cut["triangles"].get<std::int64_t>(), triangles) << "level 0 is the finest";
    triangles = cut["triangles"].get<std::int64_t>();
    EXPECT_EQ(Read<vtkSTLReader>(this->Path("cut.stl"))->GetNumberOfPolys(), triangles);
  }
  EXPECT_EQ(triangles, 20480);
  EXPECT_EQ(
    this->Bmt({ "extract", this->Path("sphere.bmt"), "-o", this->Path("no.stl"), "--level", std::to_string(levels) })
      .Exit,
    1);
}

TEST_F(EndToEnd, SeveralInputsAreBuiltAsOne)
{
  this->MakeSphere(5120);
  this->BmtJson({ "generate", "plane", "--triangles", "2000", "-o", this->Path("plane.ply") });
  const nlohmann::json built = this->BmtJson({ "build", this->Path("sphere.ply"), this->Path("plane.ply"), "-o",
    this->Path("both.bmt"), "--patch-triangles", "100" });
  const nlohmann::json plane =
    this->BmtJson({ "compare", this->Path("plane.ply"), this->Path("plane.ply"), "--samples", "10" });
  EXPECT_EQ(built["triangles"].get<int>(), 5120 + plane["triangles_a"].get<int>());
  const MTRun run = this->Bmt({ "verify", this->Path("both.bmt"), "--input", this->Path("sphere.ply"), "--input",
    this->Path("plane.ply"), "--cuts", "20", "--samples", "20000", "--json" });
  EXPECT_EQ(run.Exit, 0) << run.Out << run.Err;
}
