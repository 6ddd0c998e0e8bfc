// SPDX-License-Identifier: BSD-3-Clause
// For each format: a model is verified against the file that it was built from, and against files that differ in one
// way, as if the model had been read wrongly. Each difference must be found and reported.
#include "MTRunBmt.h"

#include "vtkMTMeshWriter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

namespace
{
// A closed surface without any symmetry, with colours of points and labels of cells.
vtkSmartPointer<vtkPolyData> MakeMesh()
{
  constexpr int Around = 24, Up = 12;
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  const auto add = [&](double x, double y, double z)
  {
    points->InsertNextPoint(x, y, z);
    const double color[3] = { 128 + 100 * std::sin(x), 128 + 90 * std::sin(2 * y), 200 - 20 * z };
    colors->InsertNextTuple3(std::floor(color[0]), std::floor(color[1]), std::floor(color[2]));
  };
  add(0.1, 0.0, -1.2);
  for (int j = 1; j < Up; ++j)
  {
    for (int i = 0; i < Around; ++i)
    {
      const double a = 2 * 3.14159265358979 * i / Around, b = 3.14159265358979 * (static_cast<double>(j) / Up - 0.5);
      const double r = 1 + 0.2 * std::sin(a + 0.3) + 0.1 * std::cos(3 * a) + 0.1 * std::sin(4 * b);
      add(
        r * std::cos(a) * std::cos(b), 1.3 * r * std::sin(a) * std::cos(b), 1.1 * r * std::sin(b) + 0.1 * std::cos(a));
    }
  }
  add(0.0, 0.1, 1.4);
  vtkNew<vtkCellArray> cells;
  const auto at = [](int j, int i) -> vtkIdType { return 1 + (j - 1) * Around + i % Around; };
  const vtkIdType top = points->GetNumberOfPoints() - 1;
  for (int i = 0; i < Around; ++i)
  {
    cells->InsertNextCell({ 0, at(1, i + 1), at(1, i) });
    for (int j = 1; j + 1 < Up; ++j)
    {
      cells->InsertNextCell({ at(j, i), at(j, i + 1), at(j + 1, i) });
      cells->InsertNextCell({ at(j, i + 1), at(j + 1, i + 1), at(j + 1, i) });
    }
    cells->InsertNextCell({ at(Up - 1, i), at(Up - 1, i + 1), top });
  }
  vtkNew<vtkIntArray> labels;
  labels->SetName("label");
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    labels->InsertNextValue(cell % 5 == 0 ? 7 : 200);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetScalars(colors);
  mesh->GetCellData()->AddArray(labels);
  return mesh;
}

void WriteObj(const std::string& path, vtkPolyData* mesh)
{
  std::ofstream file(path);
  file.precision(9);
  vtkDataArray* colors = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    file << "v " << x[0] << " " << x[1] << " " << x[2];
    for (int c = 0; colors && c < 3; ++c)
    {
      file << " " << colors->GetComponent(i, c) / 255.0;
    }
    file << "\n";
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    file << "f " << ids->GetId(0) + 1 << " " << ids->GetId(1) + 1 << " " << ids->GetId(2) + 1 << "\n";
  }
}

void Write(const std::string& path, vtkPolyData* mesh)
{
  std::string error;
  if (path.substr(path.size() - 4) == ".obj")
  {
    WriteObj(path, mesh);
  }
  else if (path.substr(path.size() - 4) == ".vtk")
  {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetInputData(mesh);
    writer->SetFileName(path.c_str());
    ASSERT_EQ(writer->Write(), 1);
  }
  else
  {
    ASSERT_TRUE(vtkMTMeshWriter::Write(path, mesh, error)) << error;
  }
}

using Edit = std::function<void(vtkPolyData*)>;

Edit Move(const std::function<void(double x[3])>& move)
{
  return [move](vtkPolyData* mesh)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double x[3];
      mesh->GetPoint(i, x);
      move(x);
      mesh->GetPoints()->SetPoint(i, x);
    }
  };
}

struct Difference
{
  const char* Name;
  const char* Check; // that must find it
  Edit Make;
};

const std::vector<Difference>& GetDifferences()
{
  static const std::vector<Difference> differences = {
    { "mirrored", "input_volume", Move([](double x[3]) { x[0] = -x[0]; }) },
    { "scaled", "input_bounds", Move([](double x[3]) { std::for_each(x, x + 3, [](double& c) { c *= 1.001; }); }) },
    { "shifted", "input_bounds", Move([](double x[3]) { x[1] += 0.001; }) },
    { "turned over", "input_volume",
      [](vtkPolyData* mesh)
      {
        mesh->BuildCells();
        for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
        {
          mesh->ReverseCell(cell);
        }
      } },
    { "a triangle less", "input_triangles",
      [](vtkPolyData* mesh)
      {
        mesh->BuildCells();
        mesh->DeleteCell(11);
        mesh->RemoveDeletedCells();
      } },
    { "other colours", "input_arrays",
      [](vtkPolyData* mesh) { mesh->GetPointData()->GetScalars()->SetComponent(9, 1, 3.0); } },
    { "labels mixed", "input_arrays",
      [](vtkPolyData* mesh)
      {
        vtkDataArray* labels = mesh->GetCellData()->GetArray("label");
        labels->SetTuple1(5, 200);
        labels->SetTuple1(6, 7);
      } },
  };
  return differences;
}
}

class VerifyFormats : public MTBmtTest
{
protected:
  MTRun Verify(const std::string& input) const
  {
    return this->Bmt(
      { "verify", this->Path("model.bmt"), "--input", this->Path(input), "--cuts", "2", "--samples", "500", "--json" });
  }

  void Check(const std::string& ending, bool hasColors, bool hasLabels) const
  {
    const auto mesh = MakeMesh();
    Write(this->Path("right." + ending), mesh);
    ASSERT_EQ(this->Bmt({ "build", this->Path("right." + ending), "-o", this->Path("model.bmt") }).Exit, 0);
    const MTRun right = this->Verify("right." + ending);
    EXPECT_EQ(right.Exit, 0) << ending << ": " << right.Out << right.Err;
    EXPECT_EQ(right.Json()["input"]["independent"], true);
    for (const Difference& difference : GetDifferences())
    {
      const std::string name = difference.Name;
      if ((name == "other colours" && !hasColors) || (name == "labels mixed" && !hasLabels))
      {
        continue;
      }
      vtkNew<vtkPolyData> wrong;
      wrong->DeepCopy(mesh);
      difference.Make(wrong);
      Write(this->Path("wrong." + ending), wrong);
      const MTRun run = this->Verify("wrong." + ending);
      EXPECT_EQ(run.Exit, 1) << ending << ", " << name << ": " << run.Out;
      std::string message;
      const nlohmann::json report = run.Json();
      for (const nlohmann::json& check : report["checks"])
      {
        message = check["name"] == difference.Check ? check.value("message", "") : message;
      }
      std::cout << ending << ", " << name << ": " << message << "\n";
      EXPECT_NE(message, "") << ending << ", " << name << ": " << run.Out;
    }
  }
};

TEST_F(VerifyFormats, PlyIsHeldAgainstItsModel)
{
  this->Check("ply", true, true);
}

TEST_F(VerifyFormats, ObjIsHeldAgainstItsModel)
{
  this->Check("obj", true, false);
}

TEST_F(VerifyFormats, StlIsHeldAgainstItsModel)
{
  this->Check("stl", false, false);
}

TEST_F(VerifyFormats, GltfIsHeldAgainstItsModel)
{
  this->Check("glb", true, false);
}

TEST_F(VerifyFormats, VtkFilesAreHeldAgainstTheirModels)
{
  this->Check("vtp", true, true);
  this->Check("vtk", true, true);
}

TEST_F(VerifyFormats, ColorsOfPlyOfEveryTypeAndCountAreThoseOfTheModel)
{
  const std::vector<std::pair<std::string, std::string>> kinds = { { "uchar", "255" }, { "ushort", "200" },
    { "ushort", "60000" }, { "short", "32767" }, { "int", "255" }, { "uint", "4294967295" }, { "float", "0.75" },
    { "float", "128.5" }, { "double", "1000" } };
  for (const auto& [type, most] : kinds)
  {
    std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    for (const char* channel : { "red", "green", "blue" })
    {
      text += "property " + type + " " + channel + "\n";
    }
    text += "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    text += "0 0 0 " + most + " 0 0\n1 0 0 0 " + most + " 0\n1 1 0 0 0 " + most + "\n0 1 0 0 0 0\n3 0 1 2\n3 0 2 3\n";
    this->WriteFile("colors.ply", text);
    ASSERT_EQ(this->Bmt({ "build", this->Path("colors.ply"), "-o", this->Path("model.bmt") }).Exit, 0);
    const MTRun run = this->Verify("colors.ply");
    EXPECT_EQ(run.Exit, 0) << type << " up to " << most << ": " << run.Err;
    const nlohmann::json report = run.Json();
    const auto arrays = std::find_if(report["checks"].begin(), report["checks"].end(),
      [](const nlohmann::json& check) { return check["name"] == "input_arrays"; });
    EXPECT_GT((*arrays)["tested"], 0) << type;
    this->WriteFile("colors.ply", text.replace(text.find(most + " 0 0"), most.size(), "0"));
    EXPECT_EQ(this->Verify("colors.ply").Exit, 1) << type << " up to " << most;
  }
}

TEST_F(VerifyFormats, WholeNumbersThatTheUserCallsValuesMayMix)
{
  constexpr int side = 60;
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << side * side
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty int zone\nelement face "
       << (side - 1) * (side - 1) << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < side * side; ++i)
  {
    const int x = i % side, y = i / side;
    text << x << ' ' << y << ' ' << std::sin(0.3 * x) * std::cos(0.2 * y) << ' ' << (x < side / 2 ? 7 : 200) << "\n";
  }
  for (int i = 0; i < side * (side - 1); ++i)
  {
    if (i % side < side - 1)
    {
      text << "4 " << i << ' ' << i + 1 << ' ' << i + side + 1 << ' ' << i + side << "\n";
    }
  }
  this->WriteFile("zones.ply", text.str());
  for (const char* meaning : { "--labels", "--values" })
  {
    const MTRun built = this->Bmt(
      { "build", this->Path("zones.ply"), "-o", this->Path("model.bmt"), "--patch-triangles", "100", meaning, "zone" });
    ASSERT_EQ(built.Exit, 0) << built.Err;
    const MTRun run = this->Verify("zones.ply");
    EXPECT_EQ(run.Exit, 0) << run.Err;
    const nlohmann::json report = run.Json();
    const auto labels = std::find_if(report["checks"].begin(), report["checks"].end(),
      [](const nlohmann::json& check) { return check["name"] == "labels"; });
    EXPECT_EQ((*labels)["tested"] > 0, meaning == std::string("--labels")) << *labels;
  }
}

TEST_F(VerifyFormats, NamesInAnotherEncodingThanUtf8AreNoFailure)
{
  this->WriteFile("latin.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng fen\xEAtre\nf 1 2 3\ng mur\nf 1 3 4\n");
  for (const char* json : { "", "--json" })
  {
    std::vector<std::string> build = { "build", this->Path("latin.obj"), "-o", this->Path("model.bmt") };
    std::vector<std::string> info = { "info", this->Path("model.bmt") };
    for (std::vector<std::string>* const call : { &build, &info })
    {
      call->insert(call->end(), *json ? 1 : 0, json);
      const MTRun run = this->Bmt(*call);
      EXPECT_EQ(run.Exit, 0) << run.Err;
      EXPECT_NE(run.Out.find("mur"), std::string::npos) << run.Out;
    }
  }
  EXPECT_EQ(this->Verify("latin.obj").Exit, 0);
}

TEST_F(VerifyFormats, ColorsThatTheModelLacksAreMissed)
{
  const auto mesh = MakeMesh();
  Write(this->Path("right.ply"), mesh);
  mesh->GetPointData()->SetScalars(nullptr);
  mesh->GetPointData()->RemoveArray("RGB");
  Write(this->Path("bare.ply"), mesh);
  ASSERT_EQ(this->Bmt({ "build", this->Path("bare.ply"), "-o", this->Path("model.bmt") }).Exit, 0);
  const MTRun run = this->Verify("right.ply");
  EXPECT_EQ(run.Exit, 1);
  EXPECT_NE(run.Err.find("colours"), std::string::npos) << run.Err;
  ASSERT_EQ(
    this->Bmt({ "build", this->Path("right.ply"), "--arrays", "label", "-o", this->Path("model.bmt") }).Exit, 0);
  EXPECT_EQ(this->Verify("right.ply").Exit, 0) << "an array that was not wanted is counted in the model's report";
}

TEST_F(VerifyFormats, PartsAreHeldAgainstTheirFiles)
{
  const auto mesh = MakeMesh();
  Write(this->Path("a.ply"), mesh);
  Move([](double x[3]) { x[0] += 5.0; })(mesh);
  Write(this->Path("b.vtp"), mesh);
  ASSERT_EQ(this->Bmt({ "build", this->Path("a.ply"), this->Path("b.vtp"), "-o", this->Path("model.bmt") }).Exit, 0);
  const auto verify = [this](const char* first, const char* second)
  {
    return this->Bmt({ "verify", this->Path("model.bmt"), "--input", this->Path(first), "--input", this->Path(second),
      "--cuts", "2", "--samples", "500" });
  };
  const MTRun run = verify("a.ply", "b.vtp");
  EXPECT_EQ(run.Exit, 0) << run.Out << run.Err;
  const MTRun swapped = verify("b.vtp", "a.ply");
  EXPECT_EQ(swapped.Exit, 1);
  EXPECT_NE(swapped.Err.find("PartId"), std::string::npos) << swapped.Err;
}
