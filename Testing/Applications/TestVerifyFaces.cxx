// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie on each other or on parts of each other, and polygons that are bent: the model is right, however a
// polygon was split, and a model that differs in one of the faces is still found to be wrong.
#include "MTRunBmt.h"

#include "vtkMTMeshWriter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>

namespace
{
struct Face
{
  std::vector<int> Points;
  int Label;
};

struct Mesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<double, 3>> Normals; // none, or one of each point
  std::vector<Face> Faces;
};

constexpr int Side = 12;

double GetHeight(int x, int y)
{
  return 0.3 * std::sin(0.7 * x) * std::cos(1.1 * y) + 0.05 * (x * y % 3);
}

// A sheet of Side x Side points; a label tells its faces. height: how much of the relief it has.
void AddSheet(Mesh& mesh, double height, bool isTurned, int firstCorner, int label)
{
  const auto first = static_cast<int>(mesh.Points.size());
  for (int i = 0; i < Side * Side; ++i)
  {
    const int x = i % Side, y = i / Side;
    mesh.Points.push_back({ 1.0 * x, 1.0 * y, height * GetHeight(x, y) });
    mesh.Normals.push_back({ 0.0, 0.0, isTurned ? -1.0 : 1.0 });
  }
  for (int i = 0; i < Side * (Side - 1); ++i)
  {
    if (i % Side < Side - 1)
    {
      std::vector<int> corners = { first + i, first + i + 1, first + i + Side + 1, first + i + Side };
      std::rotate(corners.begin(), corners.begin() + firstCorner, corners.end());
      if (isTurned)
      {
        std::reverse(corners.begin(), corners.end());
      }
      mesh.Faces.push_back({ corners, label });
    }
  }
}

// Bent pentagons and quads in a row. The longer diagonal of each, which no split by the shorter one has, is the edge of
// a triangle above or of one that covers a part of the polygon.
Mesh MakeBentPolygons()
{
  Mesh mesh;
  for (int i = 0; i < 60; ++i)
  {
    const int first = static_cast<int>(mesh.Points.size());
    const double x = 3.0 * i, bend = 0.1 + 0.01 * (i % 7);
    mesh.Points.insert(mesh.Points.end(),
      { { x, 0.0, bend }, { x + 2.0, 0.1, 0.0 }, { x + 2.1, 1.0, bend }, { x + 1.0, 1.5, 0.0 }, { x, 1.1, 0.0 } });
    mesh.Faces.push_back({ { first, first + 1, first + 2, first + 3, first + 4 }, i });
    mesh.Faces.push_back({ { first + 4, first + 2, first + 1 }, i });
    mesh.Faces.push_back({ { first, first + 2, first + 4 }, i });
    mesh.Points.insert(
      mesh.Points.end(), { { x, 3.0, bend }, { x + 2.0, 3.0, 0.0 }, { x + 2.4, 4.0, bend }, { x, 4.0, 0.0 } });
    mesh.Faces.push_back({ { first + 5, first + 6, first + 7, first + 8 }, i });
    mesh.Faces.push_back({ { first + 5, first + 6, first + 7 }, i });
    mesh.Faces.push_back({ { first + 5, first + 7, first + 6 }, i });
  }
  return mesh;
}

void WriteObj(const std::string& path, const Mesh& mesh)
{
  std::ofstream file(path);
  file.precision(9);
  for (const auto& x : mesh.Points)
  {
    file << "v " << x[0] / 3.0 << " " << x[1] / 3.0 << " " << x[2] / 3.0 << "\n";
  }
  for (const Face& face : mesh.Faces)
  {
    file << "f";
    std::for_each(face.Points.begin(), face.Points.end(), [&](int point) { file << " " << point + 1; });
    file << "\n";
  }
}

void WriteVtp(const std::string& path, const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& x : mesh.Points)
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> labels;
  labels->SetName("label");
  for (const Face& face : mesh.Faces)
  {
    const std::vector<vtkIdType> ids(face.Points.begin(), face.Points.end());
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    labels->InsertNextValue(face.Label);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->AddArray(labels);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const auto& normal : mesh.Normals)
  {
    normals->InsertNextTuple(normal.data());
  }
  if (!mesh.Normals.empty())
  {
    data->GetPointData()->SetNormals(normals);
  }
  std::string error;
  ASSERT_TRUE(vtkMTMeshWriter::Write(path, data, error)) << error;
}
}

class VerifyFaces : public MTBmtTest
{
protected:
  struct Difference
  {
    std::string Name;
    std::string Check; // that must find it
    std::function<void(Mesh&)> Make;
    bool IsOfArrays = false;
  };

  MTRun Verify(const std::string& input) const
  {
    return this->Bmt({ "verify", this->Path("model.bmt"), "--input", this->Path(input), "--cuts", "3", "--samples",
      "2000", "--json" });
  }

  static nlohmann::json GetCheck(const MTRun& run, const std::string& name)
  {
    const nlohmann::json report = run.Json();
    for (const nlohmann::json& check : report["checks"])
    {
      if (check["name"] == name)
      {
        return check;
      }
    }
    ADD_FAILURE() << "no check " << name << ": " << run.Out << run.Err;
    return {};
  }

  // The model of the right mesh passes against it, with all triangles compared, and against each wrong one does not.
  void Check(const Mesh& right, std::size_t triangles, const std::vector<Difference>& differences) const
  {
    for (const bool isObj : { false, true })
    {
      const std::string ending = isObj ? ".obj" : ".vtp";
      const auto write = isObj ? WriteObj : WriteVtp;
      write(this->Path("right" + ending), right);
      ASSERT_EQ(this->Bmt({ "build", this->Path("right" + ending), "-o", this->Path("model.bmt") }).Exit, 0);
      const MTRun run = this->Verify("right" + ending);
      EXPECT_EQ(run.Exit, 0) << ending << ": " << run.Out << run.Err;
      EXPECT_EQ(GetCheck(run, "input_orientation")["tested"], triangles);
      for (const Difference& difference : differences)
      {
        if (isObj && difference.IsOfArrays)
        {
          continue;
        }
        Mesh wrong = right;
        difference.Make(wrong);
        write(this->Path("wrong" + ending), wrong);
        const MTRun found = this->Verify("wrong" + ending);
        EXPECT_EQ(found.Exit, 1) << ending << ", " << difference.Name;
        const nlohmann::json check = GetCheck(found, difference.Check);
        EXPECT_EQ(check["ok"], false) << ending << ", " << difference.Name << ": " << found.Out;
        std::cout << ending << ", " << difference.Name << ": " << check.value("message", "") << "\n";
      }
    }
  }
};

TEST_F(VerifyFaces, BentPolygonsMayHaveTheirOtherDiagonalAsAnEdgeBesideThem)
{
  const auto turn = [](Mesh& mesh) { std::reverse(mesh.Faces[63].Points.begin(), mesh.Faces[63].Points.end()); };
  const auto move = [](Mesh& mesh) { mesh.Points[25][2] += 0.01; };
  const auto drop = [](Mesh& mesh) { mesh.Faces[60] = mesh.Faces[66]; };
  this->Check(MakeBentPolygons(), 60 * 9,
    { { "a polygon turned over", "input_orientation", turn }, { "a corner moved", "input_orientation", move },
      { "a polygon gone, another one twice", "input_orientation", drop } });
}

TEST_F(VerifyFaces, TwoFacesUponEachOtherKeepTheirTurnsNormalsAndLabels)
{
  for (const double height : { 0.0, 1.0 })
  {
    Mesh mesh;
    AddSheet(mesh, height, false, 0, 1);
    AddSheet(mesh, height, true, 1, 2);
    const std::size_t face = 40, other = face + mesh.Faces.size() / 2;
    const auto turn = [=](Mesh& wrong)
    { std::reverse(wrong.Faces[face].Points.begin(), wrong.Faces[face].Points.end()); };
    const auto exchangeNormals = [](Mesh& wrong) { std::swap(wrong.Normals[50], wrong.Normals[Side * Side + 50]); };
    const auto exchangeLabels = [=](Mesh& wrong) { std::swap(wrong.Faces[face].Label, wrong.Faces[other].Label); };
    this->Check(mesh, mesh.Faces.size() * 2,
      { { "a face turned over", "input_orientation", turn },
        { "two normals exchanged", "input_arrays", exchangeNormals, true },
        { "two labels exchanged", "input_arrays", exchangeLabels, true } });
  }
}

TEST_F(VerifyFaces, OfSeveralFacesUponEachOtherNoneIsMissed)
{
  for (const double height : { 0.0, 1.0 })
  {
    Mesh mesh;
    for (int copy = 0; copy < 5; ++copy)
    {
      AddSheet(mesh, height, copy == 3, copy % 4, copy + 1);
    }
    const std::size_t face = 40, faces = mesh.Faces.size() / 5;
    const auto turn = [=](Mesh& wrong)
    { std::reverse(wrong.Faces[face + faces].Points.begin(), wrong.Faces[face + faces].Points.end()); };
    const auto drop = [=](Mesh& wrong) { wrong.Faces[face + faces] = wrong.Faces[face + faces + 5]; };
    const auto exchange = [=](Mesh& wrong) { // with one of another turn: its own turn has no such label
      std::swap(wrong.Faces[face].Label, wrong.Faces[face + 3 * faces].Label);
    };
    std::vector<Difference> differences = { { "a face turned over", "input_orientation", turn },
      { "a face gone, another one once more", "input_orientation", drop } };
    if (height > 0.0)
    {
      differences.push_back({ "two labels exchanged", "input_arrays", exchange, true });
    }
    this->Check(mesh, mesh.Faces.size() * 2, differences);
  }
}
