// SPDX-License-Identifier: BSD-3-Clause
// What arrays say of themselves travels with the model.
#include "vtkMTLookupTable.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPolyDataStream.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
void FillTable(vtkLookupTable* table)
{
  table->SetNumberOfTableValues(5);
  for (int i = 0; i < 5; ++i)
  {
    table->SetTableValue(i, 0.2 * i, 1.0 - 0.2 * i, 0.5, i == 3 ? 0.25 : 1.0);
  }
  table->SetTableRange(0.01, 1000.0);
  table->SetScale(VTK_SCALE_LOG10);
  table->SetNanColor(0.1, 0.2, 0.3, 0.4);
  table->SetUseBelowRangeColor(1);
  table->SetBelowRangeColor(1.0, 0.0, 0.0, 1.0);
  table->SetAboveRangeColor(0.0, 0.0, 1.0, 1.0);
  table->SetAnnotation(vtkVariant(2.5), "two and a half");
  table->SetAnnotation(vtkVariant("name"), "a name");
  table->Build();
}
}

TEST(LookupTable, GivesTheSameColoursAfterTheWayThroughBytes)
{
  vtkNew<vtkLookupTable> table;
  FillTable(table);
  for (const bool isIndexed : { false, true })
  {
    table->SetIndexedLookup(isIndexed ? 1 : 0);
    const std::string bytes = vtkMTLookupTable::Encode(table);
    const vtkSmartPointer<vtkLookupTable> copy = vtkMTLookupTable::Decode(bytes);
    ASSERT_TRUE(copy);
    EXPECT_EQ(vtkMTLookupTable::Encode(copy), bytes);
    for (const double x : { -1.0, 0.0, 0.001, 0.01, 0.5, 2.5, 30.0, 999.0, 1001.0, std::nan("") })
    {
      double expected[3];
      double got[3];
      table->GetColor(x, expected);
      copy->GetColor(x, got);
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_EQ(got[i], expected[i]) << x;
      }
      EXPECT_EQ(copy->GetOpacity(x), table->GetOpacity(x)) << x;
    }
    EXPECT_EQ(copy->GetAnnotation(copy->GetAnnotatedValueIndex(vtkVariant(2.5))), "two and a half");
  }
}

TEST(LookupTable, BytesThatAreNoneAreRefused)
{
  vtkNew<vtkLookupTable> table;
  FillTable(table);
  const std::string bytes = vtkMTLookupTable::Encode(table);
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    EXPECT_EQ(vtkMTLookupTable::Decode(bytes.substr(0, length)), nullptr) << length;
  }
  EXPECT_EQ(vtkMTLookupTable::Decode(bytes + "x"), nullptr);
  EXPECT_EQ(vtkMTLookupTable::Decode(std::string(200, '\xff')), nullptr); // four thousand million colours
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x81);
    vtkMTLookupTable::Decode(damaged); // anything but a crash
  }
}

TEST(LookupTable, TablesUnitsAndComponentNamesComeBackWithTheArray)
{
  vtkNew<vtkPolyData> input;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkFloatArray> array;
  array->SetName("depth");
  array->SetNumberOfComponents(2);
  array->SetComponentName(0, "from");
  array->SetComponentName(1, "to");
  array->InsertNextTuple2(1.0, 2.0);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m");
  vtkNew<vtkLookupTable> table;
  FillTable(table);
  array->SetLookupTable(table);
  input->SetPoints(points);
  input->GetPointData()->AddArray(array);
  vtkMTPolyDataStream stream(input);
  ASSERT_EQ(stream.GetArrays().size(), 1u);
  vtkMTTriangleStream::PointBlock block;
  ASSERT_TRUE(stream.NextPoints(block));
  vtkMTPatch patch;
  patch.Points = { { 0, 0, 0 } };
  patch.PointColumns = block.Columns;
  vtkNew<vtkPolyData> output;
  ASSERT_TRUE(vtkMTMeshToPolyData::Convert(patch, vtkMTLattice(), stream.GetArrays(), output));
  vtkDataArray* copy = output->GetPointData()->GetArray("depth");
  ASSERT_TRUE(copy && copy->GetLookupTable());
  EXPECT_EQ(vtkMTLookupTable::Encode(copy->GetLookupTable()), vtkMTLookupTable::Encode(table));
  EXPECT_STREQ(copy->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), "m");
  EXPECT_STREQ(copy->GetComponentName(1), "to");
}
