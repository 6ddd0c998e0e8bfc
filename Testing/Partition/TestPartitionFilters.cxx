// SPDX-License-Identifier: BSD-3-Clause
// The filters in a pipeline. What the crossing finds is in TestCrossing.cxx.
#include "MTPartitionFigures.h"
#include "MTPartitionStrategies.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkMTArrayScan.h"
#include "vtkMTCrossing.h"
#include "vtkMTPartitionFilter.h"
#include "vtkMTPartitionSequence.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>

using namespace MTPartitionTest;

namespace
{
// Calls a function at every event of one kind.
class Observer
{
public:
  Observer(vtkObject* object, unsigned long event, std::function<void(void*)> function)
    : Function(std::move(function))
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* data) { static_cast<Observer*>(self)->Function(data); });
    object->AddObserver(event, this->Command);
  }

private:
  vtkNew<vtkCallbackCommand> Command;
  std::function<void(void*)> Function;
};

vtkIdTypeArray* GetIds(vtkPolyData* mesh, const std::string& name)
{
  return vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(name.c_str()));
}

// A vertex, a line, a quad and a strip of two triangles, in an order of cells that is not that of their making.
vtkSmartPointer<vtkPolyData> MakeMixedCells()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(i / 3 * 10.0 + i % 3, (i % 2) * 1.0, 0.0);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 8, 9, 10, 11 });
  polys->InsertNextCell({ 5, 6, 7, 8 });
  lines->InsertNextCell({ 3, 4 });
  verts->InsertNextCell({ 0 });
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  mesh->SetPolys(polys);
  mesh->SetStrips(strips);
  return mesh;
}
}

TEST(PartitionFilter, CellArrayIsTheRegionOfTheBarycentre)
{
  const Mesh mesh = MakeFractalSphere(5);
  const Points barycentres = mesh.GetBarycentres();
  for (const std::string& name : GetStrategyNames())
  {
    vtkNew<vtkMTPartitionFilter> filter;
    filter->SetInputData(mesh.GetPolyData());
    filter->SetPartitionStrategy(MakeStrategy(name));
    filter->SetTargetTriangles(300.0);
    filter->SetLevel(1);
    filter->Update();
    vtkIdTypeArray* regions = GetIds(filter->GetOutput(), "Region");
    ASSERT_TRUE(regions);
    EXPECT_EQ(filter->GetOutput()->GetCellData()->GetScalars(), regions);
    ASSERT_EQ(regions->GetNumberOfTuples(), static_cast<vtkIdType>(barycentres.size()));
    vtkMTArrayScan scan(barycentres);
    const auto partition = MakeStrategy(name)->Build(scan, 300.0, 1);
    EXPECT_EQ(filter->GetNumberOfRegions(), static_cast<vtkIdType>(partition->GetNumberOfRegions()));
    std::size_t different = 0;
    for (std::size_t i = 0; i < barycentres.size(); ++i)
    {
      different += regions->GetValue(static_cast<vtkIdType>(i)) != partition->Locate(barycentres[i]) ? 1 : 0;
    }
    // The filter's barycentres are sums in another order: they may differ in the last bit.
    EXPECT_LE(different, barycentres.size() / 1000) << name;
  }
}

TEST(PartitionFilter, InputIsPassedThroughAndNotChanged)
{
  vtkSmartPointer<vtkPolyData> input = MakeFractalSphere(3).GetPolyData();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Given");
  ids->SetNumberOfValues(input->GetNumberOfCells());
  ids->FillValue(7);
  input->GetCellData()->AddArray(ids);
  vtkNew<vtkMTPartitionFilter> filter;
  filter->SetInputData(input);
  filter->SetRegionArrayName("Mine");
  filter->Update();
  EXPECT_EQ(input->GetCellData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 2);
  EXPECT_TRUE(GetIds(filter->GetOutput(), "Mine"));
  EXPECT_EQ(filter->GetOutput()->GetPolys(), input->GetPolys());
}

TEST(PartitionFilter, RunsAgainWhenItsStrategyChanges)
{
  vtkNew<vtkMTVoronoiPartition> strategy;
  vtkNew<vtkMTPartitionFilter> filter;
  filter->SetInputData(MakeFractalSphere(4).GetPolyData());
  filter->SetPartitionStrategy(strategy);
  filter->SetTargetTriangles(50.0);
  int runs = 0;
  const Observer observer(filter, vtkCommand::StartEvent, [&runs](void*) { ++runs; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(runs, 1);
  strategy->SetLloydSteps(5);
  filter->Update();
  EXPECT_EQ(runs, 2);
}

TEST(PartitionFilter, EveryKindOfCellGoesByTheMeanOfItsPoints)
{
  vtkNew<vtkMTPartitionFilter> filter;
  filter->SetInputData(MakeMixedCells());
  filter->SetTargetTriangles(1.0);
  filter->Update();
  vtkIdTypeArray* regions = GetIds(filter->GetOutput(), "Region");
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->GetNumberOfTuples(), 4);
  std::set<vtkIdType> distinct(regions->GetPointer(0), regions->GetPointer(0) + 4);
  EXPECT_EQ(distinct.size(), 4u) << "a target of one gives every cell its own region";
}

TEST(PartitionFilter, ProgressGrowsFromZeroToOne)
{
  vtkNew<vtkMTPartitionFilter> filter;
  filter->SetInputData(MakeFractalSphere(5).GetPolyData());
  std::vector<double> progress;
  const Observer observer(
    filter, vtkCommand::ProgressEvent, [&progress](void* data) { progress.push_back(*static_cast<double*>(data)); });
  filter->Update();
  EXPECT_GE(progress.size(), 4u);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(PartitionFilter, AbortGivesAnEmptyOutput)
{
  vtkNew<vtkMTPartitionFilter> filter;
  vtkNew<vtkMTPartitionSequence> sequence;
  for (vtkPolyDataAlgorithm* algorithm :
    { static_cast<vtkPolyDataAlgorithm*>(filter), static_cast<vtkPolyDataAlgorithm*>(sequence) })
  {
    algorithm->SetInputDataObject(MakeFractalSphere(5).GetPolyData());
    const Observer observer(algorithm, vtkCommand::ProgressEvent,
      [algorithm](void* data)
      {
        if (*static_cast<double*>(data) > 0.25)
        {
          algorithm->SetAbortExecute(1);
        }
      });
    algorithm->Update();
    EXPECT_EQ(algorithm->GetOutput()->GetNumberOfCells(), 0) << algorithm->GetClassName();
    EXPECT_EQ(algorithm->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    algorithm->RemoveAllObservers();
  }
}

TEST(PartitionFilter, AMissingStrategyIsAnErrorThatIsSeen)
{
  vtkNew<vtkMTPartitionFilter> filter;
  filter->SetInputData(MakeFractalSphere(2).GetPolyData());
  filter->SetPartitionStrategy(nullptr);
  int errors = 0;
  const Observer observer(filter, vtkCommand::ErrorEvent, [&errors](void*) { ++errors; });
  const Observer executive(filter->GetExecutive(), vtkCommand::ErrorEvent, [](void*) {});
  filter->Update();
  EXPECT_GE(errors, 1);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
}

TEST(PartitionFilter, EmptyAndNotFiniteInputsAreNoErrors)
{
  vtkNew<vtkMTPartitionFilter> filter;
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  ASSERT_TRUE(GetIds(filter->GetOutput(), "Region"));
  EXPECT_EQ(filter->GetNumberOfRegions(), 0);

  vtkSmartPointer<vtkPolyData> mesh = MakeFractalSphere(4).GetPolyData();
  mesh->GetPoints()->SetPoint(17, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  int warnings = 0;
  const Observer observer(filter, vtkCommand::WarningEvent, [&warnings](void*) { ++warnings; });
  filter->SetInputData(mesh);
  filter->SetTargetTriangles(100.0);
  filter->Update();
  EXPECT_EQ(warnings, 1);
  EXPECT_GT(filter->GetNumberOfRegions(), 30);
}

TEST(PartitionSequence, EndsWithOneRegionAndGetsCoarser)
{
  vtkNew<vtkMTPartitionSequence> sequence;
  sequence->SetInputData(MakeFractalSphere(5).GetPolyData());
  sequence->SetFirstTarget(300.0);
  sequence->Update();
  vtkPolyData* output = sequence->GetOutput();
  // 300 * 2^7 is the first target that is at least 20480; 300 * 2^6 is so near that one region may do.
  EXPECT_GE(sequence->GetNumberOfLevels(), 7);
  EXPECT_LE(sequence->GetNumberOfLevels(), 8);
  EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), sequence->GetNumberOfLevels());
  EXPECT_STREQ(output->GetCellData()->GetScalars()->GetName(), "Region_0");
  vtkIdType previous = output->GetNumberOfCells();
  for (int level = 0; level < sequence->GetNumberOfLevels(); ++level)
  {
    vtkIdTypeArray* regions = GetIds(output, "Region_" + std::to_string(level));
    ASSERT_TRUE(regions);
    const std::set<vtkIdType> distinct(regions->GetPointer(0), regions->GetPointer(0) + regions->GetNumberOfTuples());
    std::cout << "  level " << level << ": " << distinct.size() << " regions\n";
    EXPECT_LT(static_cast<vtkIdType>(distinct.size()), previous);
    EXPECT_EQ(*distinct.rbegin() + 1, static_cast<vtkIdType>(distinct.size())) << "numbered without gaps";
    previous = static_cast<vtkIdType>(distinct.size());
  }
  EXPECT_EQ(previous, 1);
}

TEST(PartitionSequence, EmptyInputGivesNoArrays)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkMTPartitionSequence> sequence;
  sequence->SetInputData(empty);
  sequence->Update();
  EXPECT_EQ(sequence->GetNumberOfLevels(), 0);
  EXPECT_EQ(sequence->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(PartitionFilters, PrintThemselves)
{
  vtkNew<vtkMTPartitionFilter> filter;
  vtkNew<vtkMTPartitionSequence> sequence;
  vtkNew<vtkMTCrossing> crossing;
  for (vtkObject* object : { static_cast<vtkObject*>(filter), static_cast<vtkObject*>(sequence),
         static_cast<vtkObject*>(crossing), static_cast<vtkObject*>(filter->GetPartitionStrategy()) })
  {
    std::ostringstream text;
    object->Print(text);
    EXPECT_NE(text.str().find(object->GetClassName()), std::string::npos);
  }
}
