// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "vtkBitArray.h"
#include "vtkMTPolyDataStream.h"
#include "vtkStringArray.h"
#include "vtkVariantArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iostream>

#if __has_include("vtkSOADataArrayTemplate.h")
#include "vtkSOADataArrayTemplate.h"
#endif

namespace
{
struct Everything
{
  std::vector<std::array<double, 3>> Points;
  std::vector<vtkMTColumn> PointColumns;
  std::vector<std::array<std::uint64_t, 3>> Triangles;
  std::vector<std::int64_t> CellIds;
  std::vector<vtkMTColumn> CellColumns;
  std::size_t Blocks = 0;
};

void Append(std::vector<vtkMTColumn>& to, const std::vector<vtkMTColumn>& from)
{
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    to[i].insert(to[i].end(), from[i].begin(), from[i].end());
  }
}

Everything ReadAll(vtkMTTriangleStream& stream)
{
  Everything all;
  EXPECT_TRUE(stream.Rewind());
  vtkMTTriangleStream::PointBlock points;
  while (stream.NextPoints(points) && !points.Points.empty())
  {
    all.Points.insert(all.Points.end(), points.Points.begin(), points.Points.end());
    Append(all.PointColumns, points.Columns);
    ++all.Blocks;
  }
  vtkMTTriangleStream::TriangleBlock triangles;
  while (stream.NextTriangles(triangles) && !triangles.Triangles.empty())
  {
    all.Triangles.insert(all.Triangles.end(), triangles.Triangles.begin(), triangles.Triangles.end());
    all.CellIds.insert(all.CellIds.end(), triangles.CellIds.begin(), triangles.CellIds.end());
    Append(all.CellColumns, triangles.Columns);
    ++all.Blocks;
  }
  EXPECT_EQ(all.Points.size(), stream.GetNumberOfPoints());
  EXPECT_EQ(all.Triangles.size(), stream.GetNumberOfTriangles());
  EXPECT_EQ(all.CellIds.size(), all.Triangles.size());
  return all;
}

// The triangles' areas along z, all of the same sign where nothing is turned over.
double GetArea(const Everything& all, double* smallest)
{
  double sum = 0.0;
  *smallest = 1e300;
  for (const auto& t : all.Triangles)
  {
    const auto& a = all.Points[t[0]];
    const auto& b = all.Points[t[1]];
    const auto& c = all.Points[t[2]];
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    sum += area;
    *smallest = std::min(*smallest, area);
  }
  return sum;
}

const vtkMTArrayInfo* Find(const vtkMTTriangleStream& stream, const std::string& name)
{
  for (const vtkMTArrayInfo& array : stream.GetArrays())
  {
    if (array.Name == name)
    {
      return &array;
    }
  }
  ADD_FAILURE() << "no array " << name;
  return nullptr;
}
}

TEST(PolyDataStream, TrianglesPassAsTheyAreInBlocks)
{
  const auto mesh = MTTestMeshes::Terrain(150, 100);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  EXPECT_GT(all.Blocks, 4u);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    ASSERT_EQ(all.CellIds[cell], cell);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_EQ(all.Triangles[cell][i], static_cast<std::uint64_t>(ids->GetId(i)));
    }
  }
  const Everything again = ReadAll(stream);
  EXPECT_EQ(again.Triangles, all.Triangles) << "as often as wanted";
  EXPECT_EQ(again.Points, all.Points);
  EXPECT_TRUE(stream.GetReport().empty());
}

TEST(PolyDataStream, QuadsPolygonsAndStripsCoverTheSameAreaTheSameWayRound)
{
  struct Case
  {
    const char* Name;
    MTTestMeshes::Mesh Mesh;
    std::size_t Triangles;
    double Area;
  };
  const Case cases[] = { { "quads", MTTestMeshes::Quads(11, 7), 2 * 10 * 6, 1.0 },
    { "strips", MTTestMeshes::Strips(11, 7), 2 * 10 * 6, 1.0 },
    { "polygons", MTTestMeshes::Polygons(5), 5 * 6, 20.0 } };
  for (const Case& c : cases)
  {
    vtkMTPolyDataStream stream(c.Mesh);
    const Everything all = ReadAll(stream);
    double smallest = 0.0;
    EXPECT_NEAR(GetArea(all, &smallest), c.Area, 1e-6) << c.Name;
    EXPECT_GT(smallest, 0.0) << c.Name << ": no triangle is turned over or flat";
    EXPECT_EQ(all.Triangles.size(), c.Triangles) << c.Name;
  }
}

TEST(PolyDataStream, ConvexQuadsAreSplitAlongTheShorterDiagonal)
{
  const auto mesh = MTTestMeshes::Make({ { 0, 0, 0 }, { 4, 1, 0 }, { 5, 3, 0 }, { 1, 2, 0 }, { 0.5, 0.5, 0 } }, {});
  vtkNew<vtkCellArray> polys;
  const vtkIdType quads[3][4] = { { 0, 1, 2, 3 }, { 1, 2, 3, 0 }, { 0, 1, 4, 3 } };
  for (const auto& quad : quads)
  {
    polys->InsertNextCell(4, quad);
  }
  mesh->SetPolys(polys);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  for (int quad = 0; quad < 2; ++quad)
  {
    for (int i = 0; i < 2; ++i)
    {
      const auto& t = all.Triangles[2 * quad + i];
      EXPECT_EQ(std::count(t.begin(), t.end(), 1u) + std::count(t.begin(), t.end(), 3u), 2) << "the diagonal 1-3";
    }
  }
  double smallest = 0.0;
  GetArea(all, &smallest);
  EXPECT_GT(smallest, 0.0) << "the dart-shaped quad is split at its reflex corner";
}

TEST(PolyDataStream, VerticesLinesAndDegenerateCellsAreCounted)
{
  const auto mesh = MTTestMeshes::Polygons(2);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1 });
  strips->InsertNextCell({ 0, 1, 2, 3 });
  mesh->GetPolys()->InsertNextCell({ 4, 5 });
  mesh->GetPolys()->InsertNextCell(0);
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2 });
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  mesh->SetStrips(strips);
  vtkMTPolyDataStream stream(mesh);
  const std::map<std::string, std::int64_t> expected{ { "vertices", 1 }, { "lines", 2 }, { "degenerate_cells", 3 } };
  EXPECT_EQ(stream.GetReport(), expected);
  const Everything all = ReadAll(stream);
  ASSERT_EQ(all.Triangles.size(), 2u * 6 + 1 + 2);
  // Cells are counted in VTK's order: vertices, lines, polygons, strips.
  EXPECT_EQ(all.CellIds.front(), 3);
  EXPECT_EQ(all.CellIds[12], 3 + 4 + 2) << "the triangle behind two degenerate polygons";
  EXPECT_EQ(all.CellIds.back(), 3 + 7 + 1) << "the second strip";
  EXPECT_EQ(all.Triangles[13], (std::array<std::uint64_t, 3>{ 0, 1, 2 }));
  EXPECT_EQ(all.Triangles[14], (std::array<std::uint64_t, 3>{ 1, 3, 2 })) << "every second one is turned";
}

TEST(PolyDataStream, BadPolygonsKeepTheirNumberOfTriangles)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesh = MTTestMeshes::Make(
    { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { nan, 0, 0 }, { 0, 0, 0 }, { 0.5, 0, 0 } }, {});
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });          // crosses itself
  polys->InsertNextCell({ 0, 2, 1, 3, 4 });       // a point that is no number
  polys->InsertNextCell({ 0, 2, 1, 3, 99 });      // a point that does not exist
  polys->InsertNextCell({ 0, -7, 1, 3 });         // the same
  polys->InsertNextCell({ 0, 6, 2, 6, 0, 5 });    // no area
  polys->InsertNextCell({ 0, 0, 0, 0 });          // one point
  polys->InsertNextCell({ 0, 1, 3, 2, 0, 1, 3 }); // round twice
  mesh->SetPolys(polys);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  EXPECT_EQ(all.Triangles.size(), 2u + 3 + 3 + 2 + 4 + 2 + 5);
}

TEST(PolyDataStream, DirtyMeshesPassUnchanged)
{
  MTTestMeshes::Dirt dirt;
  const auto mesh = MTTestMeshes::Dirty(9, 4, &dirt);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  EXPECT_EQ(all.Triangles.size(), static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  std::int64_t outOfRange = 0;
  for (const auto& t : all.Triangles)
  {
    outOfRange += t[0] >= all.Points.size() || t[1] >= all.Points.size() || t[2] >= all.Points.size() ? 1 : 0;
  }
  EXPECT_EQ(outOfRange, dirt.OutOfRange) << "negative indices are out of range too";
}

TEST(PolyDataStream, ArraysAreDescribedAndCarried)
{
  const auto mesh = MTTestMeshes::HardEdgeBox(6);
  MTTestMeshes::AddArrays(mesh);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  using Info = vtkMTArrayInfo;
  const std::map<std::string, Info::ResamplingType> expected{ { "Normals", Info::Direction },
    { "elevation", Info::Interpolate }, { "colour", Info::Interpolate }, { "label", Info::Nearest },
    { "tensor", Info::Interpolate }, { "ids", Info::Nearest }, { "face", Info::Nearest }, { "weight", Info::Nearest },
    { "flag", Info::Nearest } };
  EXPECT_EQ(stream.GetArrays().size(), expected.size());
  for (const auto& entry : expected)
  {
    const Info* info = Find(stream, entry.first);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->Resampling, entry.second) << entry.first;
    EXPECT_EQ(info->Role, Info::Plain);
  }
  EXPECT_EQ(Find(stream, "elevation")->Attribute, vtkDataSetAttributes::SCALARS);
  EXPECT_EQ(Find(stream, "Normals")->Attribute, vtkDataSetAttributes::NORMALS);
  EXPECT_EQ(Find(stream, "ids")->Attribute, vtkDataSetAttributes::GLOBALIDS);
  EXPECT_EQ(Find(stream, "colour")->Attribute, -1);
  EXPECT_EQ(Find(stream, "tensor")->ComponentNames[1], "xy");
  EXPECT_EQ(Find(stream, "tensor")->ComponentNames.size(), 9u);
  EXPECT_EQ(Find(stream, "weight")->Association, Info::Cell);
  std::size_t column[2] = { 0, 0 };
  for (const Info& info : stream.GetArrays())
  {
    const bool cell = info.Association == Info::Cell;
    const vtkMTColumn& bytes = (cell ? all.CellColumns : all.PointColumns)[column[cell]++];
    vtkDataSetAttributes* attributes = cell ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData())
                                            : static_cast<vtkDataSetAttributes*>(mesh->GetPointData());
    vtkDataArray* array = attributes->GetArray(info.Name.c_str());
    ASSERT_EQ(bytes.size(), info.GetTupleSize() * array->GetNumberOfTuples()) << info.Name;
    EXPECT_EQ(std::memcmp(bytes.data(), array->GetVoidPointer(0), bytes.size()), 0) << info.Name;
  }
}

TEST(PolyDataStream, ArraysThatCannotBeCarriedAreCountedByReason)
{
  const auto mesh = MTTestMeshes::Terrain(4, 4);
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  strings->SetNumberOfValues(points);
  vtkNew<vtkVariantArray> variants;
  variants->SetName("variants");
  variants->SetNumberOfValues(points);
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  bits->SetNumberOfValues(points);
  vtkNew<vtkFloatArray> tooShort;
  tooShort->SetName("short");
  tooShort->SetNumberOfValues(points - 1);
  for (vtkAbstractArray* array : std::initializer_list<vtkAbstractArray*>{ strings, variants, bits, tooShort })
  {
    mesh->GetPointData()->AddArray(array);
  }
  vtkMTPolyDataStream stream(mesh);
  EXPECT_TRUE(stream.GetArrays().empty());
  const std::map<std::string, std::int64_t> expected{ { "arrays_of_strings", 1 }, { "arrays_of_variants", 1 },
    { "arrays_of_bits", 1 }, { "arrays_of_wrong_length", 1 } };
  EXPECT_EQ(stream.GetReport(), expected);
}

TEST(PolyDataStream, UnnamedArraysGetNamesThatNobodyElseHas)
{
  const auto mesh = MTTestMeshes::Terrain(4, 4);
  for (const char* name : { static_cast<const char*>(nullptr), "array_1", static_cast<const char*>(nullptr), "" })
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfValues(mesh->GetNumberOfPoints());
    array->Fill(0.0);
    mesh->GetPointData()->AddArray(array);
  }
  vtkMTPolyDataStream stream(mesh);
  std::set<std::string> names;
  for (const vtkMTArrayInfo& array : stream.GetArrays())
  {
    names.insert(array.Name);
  }
  EXPECT_EQ(names, (std::set<std::string>{ "array_0", "array_1", "array_2", "array_3" }));
}

#if __has_include("vtkSOADataArrayTemplate.h")
TEST(PolyDataStream, StructureOfArraysIsReadTupleByTuple)
{
  const auto mesh = MTTestMeshes::Terrain(4, 4);
  vtkNew<vtkSOADataArrayTemplate<float>> array;
  array->SetName("soa");
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    array->SetTypedComponent(i, 0, static_cast<float>(i));
    array->SetTypedComponent(i, 1, static_cast<float>(-i));
  }
  mesh->GetPointData()->AddArray(array);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  ASSERT_EQ(all.PointColumns.size(), 1u);
  for (int i = 0; i < 16; ++i)
  {
    float pair[2];
    std::memcpy(pair, all.PointColumns[0].data() + 8 * i, 8);
    EXPECT_EQ(pair[0], static_cast<float>(i));
    EXPECT_EQ(pair[1], static_cast<float>(-i));
  }
}
#endif

TEST(PolyDataStream, EmptyPolyDataIsAnEmptyStream)
{
  vtkNew<vtkPolyData> empty;
  vtkMTPolyDataStream stream(empty);
  const Everything all = ReadAll(stream);
  EXPECT_EQ(all.Blocks, 0u);
  EXPECT_TRUE(stream.GetArrays().empty());
}

TEST(PolyDataStream, PolygonsThatCrossThemselvesAreCountedWhenTheyAreRead)
{
  const auto mesh = MTTestMeshes::Make({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, {});
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  polys->InsertNextCell({ 0, 2, 1, 3 });
  polys->InsertNextCell({ 0, 1, 2, 3 });
  mesh->SetPolys(polys);
  vtkMTPolyDataStream stream(mesh);
  const std::map<std::string, std::int64_t> expected{ { vtkMTPolyDataStream::GetCrossedPolygonsName(), 2 } };
  for (int round = 0; round < 2; ++round)
  {
    EXPECT_EQ(ReadAll(stream).Triangles.size(), 6u);
    EXPECT_EQ(stream.GetReport(), expected);
  }
}

TEST(PolyDataStream, PolygonWithABadCornerIsDroppedAsAWhole)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesh = MTTestMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { nan, 1, 0 }, { 0, 1, 0 }, { 0, 0.5, 0 } }, {});
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3, 4 });
  polys->InsertNextCell({ 0, 1, 77, 3 });
  mesh->SetPolys(polys);
  vtkMTPolyDataStream stream(mesh);
  const Everything all = ReadAll(stream);
  ASSERT_EQ(all.Triangles.size(), 5u);
  for (std::size_t t = 0; t < all.Triangles.size(); ++t)
  {
    const std::uint64_t bad = t < 3 ? 2 : 77;
    EXPECT_EQ(std::count(all.Triangles[t].begin(), all.Triangles[t].end(), bad), 1) << t;
  }
}
