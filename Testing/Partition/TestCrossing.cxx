// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMTCrossing.h"
#include "vtkMTPartitionSequence.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

using namespace MTPartitionTest;

namespace
{
vtkIdTypeArray* GetIds(vtkPolyData* mesh, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(name));
}

vtkSmartPointer<vtkPolyData> MakeSequence(int subdivisions, double target)
{
  vtkNew<vtkMTPartitionSequence> sequence;
  sequence->SetInputData(MakeFractalSphere(subdivisions).GetPolyData());
  sequence->SetFirstTarget(target);
  sequence->Update();
  return sequence->GetOutput();
}

void ExpectError(vtkPolyData* input)
{
  vtkNew<vtkMTCrossing> crossing;
  crossing->SetInputData(input);
  const bool warn = vtkObject::GetGlobalWarningDisplay();
  vtkObject::SetGlobalWarningDisplay(false);
  crossing->Update();
  vtkObject::SetGlobalWarningDisplay(warn);
  EXPECT_EQ(crossing->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(crossing->GetOutput()->GetNumberOfCells(), 0);
}
}

TEST(Crossing, EqualsBruteForce)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSequence(4, 80.0);
  vtkNew<vtkMTCrossing> crossing;
  crossing->SetInputData(mesh);
  crossing->Update();
  vtkIdTypeArray* patches = GetIds(crossing->GetOutput(), "Patch");
  ASSERT_TRUE(patches);
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> numbers; // in the order of (a, b)
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    numbers[{ GetIds(mesh, "Region_0")->GetValue(i), GetIds(mesh, "Region_1")->GetValue(i) }] = 0;
  }
  vtkIdType next = 0;
  for (auto& element : numbers)
  {
    element.second = next++;
  }
  EXPECT_EQ(crossing->GetNumberOfPatches(), next);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const auto pair = std::make_pair(GetIds(mesh, "Region_0")->GetValue(i), GetIds(mesh, "Region_1")->GetValue(i));
    ASSERT_EQ(patches->GetValue(i), numbers[pair]);
  }
}

TEST(Crossing, AnyIntegerLabelsWillDo)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeFractalSphere(1).GetPolyData();
  vtkNew<vtkIntArray> first;
  vtkNew<vtkIntArray> second;
  first->SetName("A");
  second->SetName("B");
  for (int i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    first->InsertNextValue(-1000000 * (i % 2));
    second->InsertNextValue(i % 4 - 7);
  }
  mesh->GetCellData()->AddArray(first);
  mesh->GetCellData()->AddArray(second);
  vtkNew<vtkMTCrossing> crossing;
  crossing->SetInputData(mesh);
  crossing->SetFirstArrayName("A");
  crossing->SetSecondArrayName("B");
  crossing->SetPatchArrayName("C");
  crossing->Update();
  EXPECT_EQ(crossing->GetNumberOfPatches(), 4);
  // Order of (a, b): (-1000000, -6), (-1000000, -4), (0, -7), (0, -5).
  const vtkIdType expected[] = { 2, 0, 3, 1 };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(GetIds(crossing->GetOutput(), "C")->GetValue(i), expected[i % 4]);
  }
}

TEST(Crossing, UnsuitableArraysAreErrors)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeFractalSphere(1).GetPolyData();
  ExpectError(mesh);
  vtkNew<vtkIdTypeArray> first;
  first->SetName("Region_0");
  first->SetNumberOfTuples(mesh->GetNumberOfCells());
  first->FillValue(0);
  mesh->GetCellData()->AddArray(first);
  ExpectError(mesh);
  vtkNew<vtkFloatArray> real;
  real->SetName("Region_1");
  real->SetNumberOfTuples(mesh->GetNumberOfCells());
  real->FillValue(0.5f);
  mesh->GetCellData()->AddArray(real);
  ExpectError(mesh);
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("Region_1");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(mesh->GetNumberOfCells());
  pairs->FillValue(0);
  mesh->GetCellData()->AddArray(pairs);
  ExpectError(mesh);
}

TEST(Crossing, MergedSliversKeepTheirFirstRegion)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSequence(6, 500.0);
  vtkNew<vtkMTCrossing> crossing;
  crossing->SetInputData(mesh);
  crossing->Update();
  const vtkIdType before = crossing->GetNumberOfPatches();
  crossing->MergeSliversOn();
  crossing->Update();
  EXPECT_GT(crossing->GetNumberOfSlivers(), 0);
  EXPECT_EQ(crossing->GetNumberOfPatches(), before - crossing->GetNumberOfSlivers());
  vtkIdTypeArray* patches = GetIds(crossing->GetOutput(), "Patch");
  std::vector<vtkIdType> sizes(static_cast<std::size_t>(crossing->GetNumberOfPatches()), 0);
  std::vector<vtkIdType> regionOf(sizes.size(), -1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const auto patch = static_cast<std::size_t>(patches->GetValue(i));
    const vtkIdType region = GetIds(mesh, "Region_0")->GetValue(i);
    ++sizes.at(patch);
    EXPECT_TRUE(regionOf[patch] == -1 || regionOf[patch] == region);
    regionOf[patch] = region;
  }
  const double minimum = 0.1 * static_cast<double>(mesh->GetNumberOfCells()) / static_cast<double>(before);
  const vtkIdType smallest = *std::min_element(sizes.begin(), sizes.end());
  EXPECT_GE(static_cast<double>(smallest), minimum);
  std::cout << "  " << before << " elements, " << crossing->GetNumberOfSlivers() << " slivers merged, smallest "
            << smallest << " cells\n";
}
