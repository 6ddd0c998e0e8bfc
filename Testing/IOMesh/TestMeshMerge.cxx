// SPDX-License-Identifier: BSD-3-Clause
// Several meshes become one, and nothing of them is lost.
#include "MTTestMeshes.h"

#include "vtkMTIdNames.h"
#include "vtkMTMeshMerge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
template <typename Array>
void Add(vtkDataSetAttributes* to, const char* name, vtkIdType tuples, double value, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(value);
  to->AddArray(array);
}

std::int64_t Get(const std::map<std::string, std::int64_t>& report, const char* name)
{
  const auto found = report.find(name);
  return found == report.end() ? 0 : found->second;
}
}

TEST(MeshMerge, CellsSayWhichMeshTheyAreOf)
{
  const auto a = MTTestMeshes::Icosphere(1); // 80 triangles
  const auto b = MTTestMeshes::Strips(5, 4); // 3 strips
  const auto c = MTTestMeshes::Quads(3, 3);
  vtkNew<vtkPolyData> merged;
  std::map<std::string, std::int64_t> report;
  std::string error;
  ASSERT_TRUE(vtkMTMeshMerge::Merge({ a, b, c }, merged, report, error)) << error;
  EXPECT_EQ(merged->GetNumberOfPoints(), a->GetNumberOfPoints() + b->GetNumberOfPoints() + c->GetNumberOfPoints());
  ASSERT_EQ(merged->GetNumberOfCells(), a->GetNumberOfCells() + b->GetNumberOfCells() + c->GetNumberOfCells());
  auto* parts = vtkIntArray::SafeDownCast(merged->GetCellData()->GetArray("PartId"));
  ASSERT_NE(parts, nullptr);
  // Polygons come before strips.
  EXPECT_EQ(parts->GetValue(0), 0);
  EXPECT_EQ(parts->GetValue(79), 0);
  EXPECT_EQ(parts->GetValue(80), 2);
  EXPECT_EQ(parts->GetValue(merged->GetNumberOfCells() - 1), 1);
  double expected[3];
  double found[3];
  c->GetPoint(2, expected);
  merged->GetPoint(a->GetNumberOfPoints() + b->GetNumberOfPoints() + 2, found);
  EXPECT_EQ(found[0], expected[0]);
  EXPECT_EQ(found[1], expected[1]);
}

TEST(MeshMerge, ArraysAreUnitedAndWhatIsMissingIsMarked)
{
  const auto a = MTTestMeshes::Icosphere(0);
  const auto b = MTTestMeshes::Icosphere(0);
  const vtkIdType points = a->GetNumberOfPoints();
  const vtkIdType cells = a->GetNumberOfCells();
  Add<vtkFloatArray>(a->GetPointData(), "heat", points, 2.5);
  Add<vtkFloatArray>(b->GetPointData(), "heat", points, 3.5);
  Add<vtkDoubleArray>(a->GetPointData(), "only a", points, 7.0, 2);
  Add<vtkIntArray>(b->GetPointData(), "only b", points, 9.0);
  Add<vtkIntArray>(a->GetCellData(), "kind", cells, 1.0);
  Add<vtkFloatArray>(b->GetCellData(), "kind", cells, 0.5);
  Add<vtkIntArray>(a->GetCellData(), "PartId", cells, 42.0);
  vtkNew<vtkPolyData> merged;
  std::map<std::string, std::int64_t> report;
  std::string error;
  ASSERT_TRUE(vtkMTMeshMerge::Merge({ a, b }, merged, report, error)) << error;
  vtkPointData* point = merged->GetPointData();
  EXPECT_EQ(point->GetNumberOfArrays(), 3);
  EXPECT_EQ(point->GetArray("heat")->GetComponent(0, 0), 2.5);
  EXPECT_EQ(point->GetArray("heat")->GetComponent(points, 0), 3.5);
  EXPECT_EQ(point->GetArray("only a")->GetComponent(0, 1), 7.0);
  EXPECT_TRUE(std::isnan(point->GetArray("only a")->GetComponent(points, 1)));
  EXPECT_EQ(point->GetArray("only b")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(point->GetArray("only b")->GetComponent(points, 0), 9.0);
  vtkCellData* cell = merged->GetCellData();
  EXPECT_EQ(cell->GetArray("kind")->GetDataType(), VTK_INT);
  EXPECT_EQ(cell->GetArray("kind_2")->GetComponent(cells, 0), 0.5);
  EXPECT_EQ(cell->GetArray("InputPartId")->GetComponent(0, 0), 42.0);
  EXPECT_EQ(cell->GetArray("PartId")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(Get(report, "united_arrays_filled"), 5) << "only a, only b, kind, kind_2, InputPartId";
  EXPECT_EQ(Get(report, "renamed_arrays"), 1);
}

TEST(MeshMerge, NormalsAreMadeWhereAMeshHasNone)
{
  const auto a = MTTestMeshes::Icosphere(1);
  const auto b = MTTestMeshes::Icosphere(1);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(a->GetNumberOfPoints());
  normals->Fill(0.5);
  a->GetPointData()->SetNormals(normals);
  vtkNew<vtkPolyData> merged;
  std::map<std::string, std::int64_t> report;
  std::string error;
  ASSERT_TRUE(vtkMTMeshMerge::Merge({ a, b }, merged, report, error)) << error;
  EXPECT_EQ(Get(report, "made_part_normals"), b->GetNumberOfPoints());
  vtkDataArray* united = merged->GetPointData()->GetNormals();
  ASSERT_NE(united, nullptr);
  EXPECT_EQ(united->GetComponent(3, 1), 0.5);
  for (vtkIdType p = 0; p < b->GetNumberOfPoints(); ++p)
  {
    double place[3];
    double normal[3];
    b->GetPoint(p, place);
    united->GetTuple(a->GetNumberOfPoints() + p, normal);
    EXPECT_GT(place[0] * normal[0] + place[1] * normal[1] + place[2] * normal[2], 0.99) << "outwards";
  }
}

TEST(MeshMerge, NamesOfIdsAreUnitedAndIdsThatDifferHaveAllTheirNames)
{
  const std::vector<std::vector<std::string>> names = { { "steel", "brass" }, { "oak", "brass", "steel" }, {} };
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (const std::vector<std::string>& ofPart : names)
  {
    parts.push_back(MTTestMeshes::Icosphere(0));
    if (!ofPart.empty())
    {
      vtkNew<vtkIntArray> ids;
      ids->SetName("MaterialIds");
      ids->SetNumberOfValues(parts.back()->GetNumberOfCells());
      ids->FillValue(0);
      vtkMTIdNames::Set(ids, ofPart, { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } });
      parts.back()->GetCellData()->AddArray(ids);
    }
  }
  vtkNew<vtkPolyData> merged;
  std::map<std::string, std::int64_t> report;
  std::string error;
  ASSERT_TRUE(vtkMTMeshMerge::Merge(parts, merged, report, error)) << error;
  EXPECT_EQ(
    report, (std::map<std::string, std::int64_t>{ { "united_arrays_filled", 1 }, { "united_names_differ", 1 } }));
  vtkDataArray* ids = merged->GetCellData()->GetArray("MaterialIds");
  ASSERT_NE(ids, nullptr);
  EXPECT_EQ(ids->GetTuple1(ids->GetNumberOfTuples() - 1), -1.0) << "a part without is of none";
  vtkLookupTable* table = ids->GetLookupTable();
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->GetNumberOfAnnotatedValues(), 3);
  EXPECT_EQ(std::string(table->GetAnnotation(0)), "steel | oak");
  EXPECT_EQ(std::string(table->GetAnnotation(1)), "brass");
  EXPECT_EQ(std::string(table->GetAnnotation(2)), "steel");
}
