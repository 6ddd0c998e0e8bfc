// SPDX-License-Identifier: BSD-3-Clause
// OBJ files as people have them: what is read of them, and what is counted; whole and streamed.
#include "MTIOTest.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTPolyDataStream.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MTIOTest;

namespace
{
using Counts = std::map<std::string, std::int64_t>;

// All that a stream gives.
struct Content
{
  bool operator==(const Content& other) const
  {
    return this->Points == other.Points && this->Triangles == other.Triangles && this->CellIds == other.CellIds &&
      this->Values == other.Values;
  }
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint64_t, 3>> Triangles;
  std::vector<std::int64_t> CellIds;
  std::vector<unsigned char> Values;
};

Content ReadAll(vtkMTTriangleStream& stream)
{
  Content all;
  EXPECT_TRUE(stream.Rewind());
  vtkMTTriangleStream::PointBlock points;
  while (stream.NextPoints(points) && !points.Points.empty())
  {
    for (const auto& point : points.Points)
    {
      all.Points.push_back(std::isfinite(point[0]) ? point : std::array<double, 3>{ 1e99, 1e99, 1e99 });
    }
    for (const vtkMTColumn& column : points.Columns)
    {
      all.Values.insert(all.Values.end(), column.begin(), column.end());
    }
  }
  vtkMTTriangleStream::TriangleBlock triangles;
  while (stream.NextTriangles(triangles) && !triangles.Triangles.empty())
  {
    all.Triangles.insert(all.Triangles.end(), triangles.Triangles.begin(), triangles.Triangles.end());
    all.CellIds.insert(all.CellIds.end(), triangles.CellIds.begin(), triangles.CellIds.end());
    for (const vtkMTColumn& column : triangles.Columns)
    {
      all.Values.insert(all.Values.end(), column.begin(), column.end());
    }
  }
  return all;
}

double GetArea(const Content& all)
{
  double area = 0.0;
  for (const auto& t : all.Triangles)
  {
    const auto& a = all.Points[t[0]];
    const auto& b = all.Points[t[1]];
    const auto& c = all.Points[t[2]];
    const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    area += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

// Reads the text whole and as a stream, which must give the same, and the mesh.
class Obj
{
public:
  explicit Obj(const std::string& text)
  {
    WriteFile(this->Folder / "mesh.obj", text);
    this->Read(this->Folder / "mesh.obj");
  }
  Obj(const std::string& text, const std::string& libraryName, const std::string& library)
  {
    WriteFile(this->Folder / libraryName, library);
    WriteFile(this->Folder / "mesh.obj", text);
    this->Read(this->Folder / "mesh.obj");
  }

  vtkDataArray* GetPointArray(const char* name) const { return this->Mesh->GetPointData()->GetArray(name); }
  vtkDataArray* GetCellArray(const char* name) const { return this->Mesh->GetCellData()->GetArray(name); }
  // The name that the table of the array of ids has for this cell.
  std::string GetName(const char* array, vtkIdType cell) const
  {
    vtkDataArray* ids = this->GetCellArray(array);
    vtkLookupTable* table = ids ? ids->GetLookupTable() : nullptr;
    const vtkIdType index = table ? table->GetAnnotatedValueIndex(ids->GetTuple1(cell)) : -1;
    return index < 0 ? "" : std::string(table->GetAnnotation(index));
  }

  vtkNew<vtkPolyData> Mesh;
  std::string Error;
  Counts Report; // with what becomes of the polygons
  double Area = 0.0;

private:
  void Read(const std::string& path)
  {
    const bool isRead = vtkMTMeshReader::Read(path, this->Mesh, this->Error, &this->Report);
    vtkMTMemorySpoolStore store;
    vtkMTMeshStream::Settings settings;
    settings.Store = &store;
    vtkNew<vtkPolyData> names;
    const auto stream = vtkMTMeshStream::Open(path, settings, names);
    ASSERT_EQ(stream != nullptr, isRead) << this->Error;
    if (!isRead)
    {
      return;
    }
    vtkMTPolyDataStream whole(this->Mesh);
    const Content expected = ReadAll(whole);
    for (const auto& [reason, count] : whole.GetReport())
    {
      this->Report[reason] += count;
    }
    this->Area = GetArea(expected);
    EXPECT_EQ(stream->GetArrays(), whole.GetArrays());
    for (int round = 0; round < 2; ++round)
    {
      EXPECT_TRUE(ReadAll(*stream) == expected);
      EXPECT_EQ(stream->GetReport(), this->Report);
    }
  }

  const class Folder Folder;
};

const std::string Points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
}

TEST(ObjReader, ByteOrderMarksLineEndsAndContinuedLinesAreRead)
{
  const std::string square = Points + "f 1 2 3 4\n";
  std::string carriage = square;
  std::replace(carriage.begin(), carriage.end(), '\n', '\r');
  std::string windows;
  for (const char c : square)
  {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  }
  const std::string texts[] = { "\xEF\xBB\xBF" + square, carriage, windows, "\xEF\xBB\xBF" + carriage,
    Points + "f 1 2\\\n3 \\  \r\n4", "# a folder: C:\\models\\\n" + square, Points + "f 1 2 3 4\\",
    Points + "\t f 1 2 3 4 # all\n" };
  for (const std::string& text : texts)
  {
    const Obj obj(text);
    EXPECT_EQ(obj.Error, "");
    EXPECT_EQ(obj.Area, 1.0) << text;
    EXPECT_TRUE(obj.Report.empty()) << text;
  }
}

TEST(ObjReader, Utf16IsRefusedForThatReason)
{
  for (const bool isMarked : { true, false })
  {
    std::string text = isMarked ? "\xFF\xFE" : "";
    for (const char c : Points + "f 1 2 3 4\n")
    {
      text += c;
      text += '\0';
    }
    EXPECT_NE(Obj(text).Error.find("UTF-16"), std::string::npos);
  }
}

TEST(ObjReader, OneBadRecordCostsItselfAndIsCounted)
{
  struct Case
  {
    std::string Text;
    double Area;
    Counts Report;
  };
  const std::string good = "f 1 2 3 4\n";
  const std::string more = Points + "vt 0 0\nvn 0 0 1\n";
  const Case cases[] = { { "f 1 2\n", 1.0, { { "degenerate_cells", 1 } } },
    { "f\nf 1\nl 1\n", 1.0, { { "degenerate_cells", 3 } } },
    { "f 1 2 9\nf 1 2 99999999999999999999\n", 1.0, { { "bad_cells", 2 } } },
    { "f 1 2 -9\nf 0 1 2\nf 1 2 a\nf 1/1/1/1 2 3\nl 1 9\np 9\nf / 2 3\n", 1.0, { { "bad_cells", 7 } } },
    { "l 1 2\np 1 2\nl 2 3 4\n", 1.0, { { "lines", 2 }, { "vertices", 1 } } },
    { "f 1/1 2/2 3/3\n", 1.5, { { "missing_texture_coordinates", 2 }, { "filled_texture_coordinates", 6 } } },
    { "f 1//7 2//-3 3//0\n", 1.5, { { "missing_normals", 3 } } },
    { "f 1/1/1 2/1/1 3/1/1\n", 1.5, { { "filled_texture_coordinates", 4 }, { "filled_normals", 4 } } },
    { "v 1 2\nv x y z\nv\n", 1.0, { { "bad_vertices", 3 } } },
    { "v nan inf 0\nv 1.#QNAN -1.#IND 1.#INF\nv -nan(ind) 0 0\n", 1.0, { { "not_finite_vertices", 3 } } },
    { "v 1 2 3 4 5\nv 1 2 3 4 5 6 7 8\nv 1 2 3 0.5\nv 1 2 3 1\nv 1 2 3 what\n", 1.0,
      { { "ignored_numbers", 3 }, { "ignored_weights", 1 } } },
    { "vt nan 0\nvt\nvt 1 x\nvt 0.5 # u\nvn 0 0\nvn nan 0 1\n", 1.0,
      { { "bad_texture_coordinates", 3 }, { "bad_normals", 2 } } },
    { "s 1\nf 1 2 3\ns 2\ns off\n", 1.5, { { "ignored_smoothing_groups", 2 } } },
    { "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\nwhat 1 2 3\nV 1 2 3\n", 1.0,
      { { "free_forms", 1 }, { "unknown_records", 2 } } },
    { "f 1 3 2 4\n", 0.0, { { "crossed_polygons", 1 } } } };
  for (const Case& test : cases)
  {
    const Obj obj(more + test.Text + good);
    EXPECT_EQ(obj.Error, "");
    EXPECT_EQ(obj.Report, test.Report) << test.Text;
    if (test.Area > 0.0)
    {
      EXPECT_EQ(obj.Area, test.Area) << test.Text;
    }
  }
}

TEST(ObjReader, VertexThatIsNoneKeepsItsNumber)
{
  const Obj obj("v 5 5\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 x 0\nf 2 3 4\nf 2 3 5\nf 1 2 3 4\n");
  EXPECT_EQ(obj.Report, (Counts{ { "bad_vertices", 2 } }));
  EXPECT_EQ(obj.Mesh->GetNumberOfPoints(), 5);
  EXPECT_EQ(obj.Mesh->GetPoint(3)[1], 1.0);
  EXPECT_TRUE(std::isnan(obj.Mesh->GetPoint(4)[0]));
  const Obj none("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
  EXPECT_NE(none.Error.find("no triangles"), std::string::npos) << "of no face there is nothing to read";
}

TEST(ObjReader, PolygonsWithHolesHaveTheirArea)
{
  const Obj obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 3 1 0\nv 3 3 0\nv 1 3 0\nf 1 2 3 4 1 5 8 7 6 5\n");
  EXPECT_NEAR(obj.Area, 12.0, 1e-12);
  EXPECT_TRUE(obj.Report.empty());
}

TEST(ObjReader, ColorsOfSomeVerticesAreKeptAndTheOthersCounted)
{
  const Obj some("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0 0 1\nv 0 1 0 nan 0 0\nf 1 2 3 4\n");
  EXPECT_EQ(some.Report, (Counts{ { "filled_colors", 2 } }));
  vtkDataArray* colors = some.GetPointArray("RGB");
  ASSERT_NE(colors, nullptr);
  const double expected[4][3] = { { 1, 0, 0 }, { 1, 1, 1 }, { 0, 0, 1 }, { 1, 1, 1 } };
  for (vtkIdType p = 0; p < 4; ++p)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(colors->GetComponent(p, c), expected[p][c]) << p << ", " << c;
    }
  }
  EXPECT_EQ(some.Mesh->GetPointData()->GetScalars(), colors) << "drawn by default";

  const Obj alpha("v 0 0 0 1 0 0 0.5\nv 1 0 0 0 1 0\nv 1 1 0\nf 1 2 3\n");
  ASSERT_NE(alpha.GetPointArray("RGBA"), nullptr);
  EXPECT_EQ(alpha.GetPointArray("RGBA")->GetComponent(0, 3), 0.5);
  EXPECT_EQ(alpha.GetPointArray("RGBA")->GetComponent(1, 3), 1.0);
  EXPECT_EQ(alpha.Report, (Counts{ { "filled_colors", 1 } }));

  const Obj bytes("v 0 0 0 255 0 0 255\nv 1 0 0 51 1 0 0\nv 1 1 0 0 0 255 255\nf 1 2 3\n");
  ASSERT_NE(bytes.GetPointArray("RGBA"), nullptr);
  EXPECT_EQ(bytes.GetPointArray("RGBA")->GetComponent(0, 0), 1.0);
  EXPECT_NEAR(bytes.GetPointArray("RGBA")->GetComponent(1, 0), 0.2, 1e-6);
  EXPECT_EQ(bytes.GetPointArray("RGBA")->GetComponent(0, 3), 1.0);
  const Obj dark("v 0 0 0 2 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nf 1 2 3\n");
  EXPECT_NEAR(dark.GetPointArray("RGB")->GetComponent(0, 0), 2.0 / 255.0, 1e-7) << "whole numbers above 1";
  const Obj bright("v 0 0 0 1.01 0 0\nv 1 0 0 0 0.5 0\nv 1 1 0 0 0 1\nf 1 2 3\n");
  EXPECT_NEAR(bright.GetPointArray("RGB")->GetComponent(0, 0), 1.01, 1e-6) << "a little above 1";
}

TEST(ObjReader, NamesAndColorsStayBesideTheIds)
{
  const std::string text = "mtllib my materials.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no box\nf 1 2 3\n"
                           "g inlet\nusemtl brushed steel\nf 1 2 3\no lid\ng walls rough\nusemtl brass\nf 1 2 3\n"
                           "g empty\ng inlet\nusemtl\nf 1 3 4\nusemtl gold\nf 1 3 4\n";
  const std::string library = "\xEF\xBB\xBFnewmtl brushed steel\n\tKd 1 0 0\nnewmtl brass\nKd 0.5\nKa 1 1 1\n"
                              "newmtl gold\nKd spectral gold.rfl\nnewmtl brass\nKd 0 0 1\n";
  const Obj obj(text, "My Materials.MTL", library); // of another case
  const char* names[5][3] = { { "default", "", "box" }, { "inlet", "brushed steel", "box" },
    { "walls rough", "brass", "lid" }, { "inlet", "", "lid" }, { "inlet", "gold", "lid" } };
  for (vtkIdType cell = 0; cell < 5; ++cell)
  {
    EXPECT_EQ(obj.GetName("GroupIds", cell), names[cell][0]);
    EXPECT_EQ(obj.GetName("MaterialIds", cell), names[cell][1]);
    EXPECT_EQ(obj.GetName("ObjectIds", cell), names[cell][2]);
  }
  ASSERT_NE(obj.GetCellArray("MaterialIds"), nullptr);
  vtkLookupTable* table = obj.GetCellArray("MaterialIds")->GetLookupTable();
  EXPECT_EQ(obj.GetCellArray("MaterialIds")->GetTuple1(0), -1.0);
  const double expected[3][3] = { { 1, 0, 0 }, { 0.5, 0.5, 0.5 }, { 0.8, 0.8, 0.8 } };
  for (int id = 0; id < 3; ++id)
  {
    double color[4];
    table->GetAnnotationColor(id, color);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(color[c], expected[id][c], 1.0 / 255.0) << id;
    }
  }
  EXPECT_TRUE(table->GetIndexedLookup());
  const Obj one("o cube\ng cube\n" + Points + "f 1 2 3 4\n");
  EXPECT_EQ(one.GetCellArray("GroupIds"), nullptr) << "one group tells nothing apart";
  EXPECT_EQ(one.GetCellArray("ObjectIds"), nullptr);
}

TEST(ObjReader, ManyNamesTakeNoLongerThanTheyMust)
{
  std::string text = Points;
  for (int i = 0; i < 30000; ++i)
  {
    text += "g part " + std::to_string(i) + "\nf 1 2 3\n";
  }
  const Obj obj(text); // with a quadratic time this test would last for minutes
  EXPECT_EQ(obj.GetName("GroupIds", 29999), "part 29999");
}
