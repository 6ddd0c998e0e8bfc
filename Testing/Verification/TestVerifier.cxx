// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationVerifier: good models pass, planted faults are found by the right check, failures say why.
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTCut.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationVerifier.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <new>
#include <string>

namespace
{
// What the model's finest level holds: the mesh that it stands for.
vtkSmartPointer<vtkPolyData> MakeInput(const vtkMTPatchSource& source)
{
  vtkMTCut cut(source.GetGraph());
  for (std::uint32_t node = 1; node < source.GetGraph().GetSink(); ++node)
  {
    if (!cut.IsRefined(node))
    {
      cut.RefineWithDependencies(node);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  std::string error;
  EXPECT_TRUE(vtkMultiTriangulation::CutToPolyData(source, cut, mesh, error)) << error;
  return mesh;
}

vtkMultiTriangulationVerifier::InputOpener Open(vtkPolyData* mesh)
{
  return [mesh](std::string&) { return std::make_unique<vtkMTPolyDataStream>(mesh); };
}

void SetSmall(vtkMultiTriangulationVerifier* verifier)
{
  verifier->SetNumberOfCuts(20);
  verifier->SetNumberOfSamples(5000);
}

// Violations of a check; -1 when there is no such check.
int CountViolations(vtkTable* checks, const std::string& name)
{
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    if (checks->GetValueByName(row, "name").ToString() == name)
    {
      return checks->GetValueByName(row, "violations").ToInt();
    }
  }
  return -1;
}

std::string Dump(vtkTable* table)
{
  std::string text;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      text += table->GetValue(row, column).ToString() + (column + 1 < table->GetNumberOfColumns() ? " | " : "\n");
    }
  }
  return text;
}

// A store that cannot read one patch.
class BrokenSource : public vtkMTPatchStore
{
public:
  std::uint32_t Broken = 3;

  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    if (arc == this->Broken)
    {
      error = "the disk is gone";
      return false;
    }
    return this->vtkMTPatchStore::ReadPatch(arc, arrays, patch, error);
  }
};
}

TEST(Verifier, AGoodModelPassesEveryCheckAgainstItsInput)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh))) << verifier->GetErrorMessage();
  std::cout << Dump(verifier->GetChecks()) << Dump(verifier->GetTightness());
  EXPECT_TRUE(verifier->IsValid());
  EXPECT_TRUE(verifier->GetCertified());
  EXPECT_EQ(verifier->GetChecks()->GetNumberOfRows(), 8);
  for (vtkIdType row = 0; row < verifier->GetChecks()->GetNumberOfRows(); ++row)
  {
    EXPECT_GT(verifier->GetChecks()->GetValueByName(row, "tested").ToInt(), 0);
    EXPECT_LE(verifier->GetChecks()->GetValueByName(row, "worst").ToDouble(), 1.0);
  }
  vtkIdType cuts = 0;
  for (vtkIdType row = 0; row < verifier->GetSpans()->GetNumberOfRows(); ++row)
  {
    cuts += verifier->GetSpans()->GetValueByName(row, "cuts").ToInt();
  }
  EXPECT_EQ(cuts, 20);
  EXPECT_EQ(verifier->GetNumberOfMeasuredCuts(), 8 + static_cast<vtkIdType>(store->GetGraph().GetNumberOfLevels()));
  EXPECT_GT(verifier->GetTolerance(), 0.0);
  EXPECT_EQ(verifier->GetTightness()->GetNumberOfRows(), store->GetGraph().GetNumberOfLevels() - 1);
  for (vtkIdType row = 0; row < verifier->GetTightness()->GetNumberOfRows(); ++row)
  {
    EXPECT_GE(verifier->GetTightness()->GetValueByName(row, "median").ToDouble(), 1.0);
  }
}

TEST(Verifier, TheFilterGivesTheSameTable)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkNew<vtkMultiTriangulation> model;
  ASSERT_TRUE(model->SetSource(store));
  vtkNew<vtkMultiTriangulationVerifier> filter;
  SetSmall(filter);
  filter->SetInputData(0, model);
  filter->SetInputData(1, mesh);
  filter->Update();
  vtkNew<vtkMultiTriangulationVerifier> alone;
  SetSmall(alone);
  ASSERT_TRUE(alone->Verify(*store, Open(mesh)));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 8);
  EXPECT_EQ(Dump(filter->GetOutput()), Dump(alone->GetChecks()));
}

TEST(Verifier, ResultsDoNotDependOnThreads)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh)));
  const std::string together = Dump(verifier->GetChecks()) + Dump(verifier->GetTightness());
  const std::string backend = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh)));
  vtkSMPTools::SetBackend(backend.c_str());
  EXPECT_EQ(Dump(verifier->GetChecks()) + Dump(verifier->GetTightness()), together);
}

TEST(Verifier, ErrorsThatAreTooSmallAreFound)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  for (vtkMTNode& node : store->GetMutableGraph().Nodes)
  {
    node.Error *= 0.1;
    node.OwnError *= 0.1;
  }
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(*store));
  EXPECT_TRUE(verifier->IsValid()) << "without the input nothing can be seen\n" << Dump(verifier->GetChecks());
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh)));
  EXPECT_FALSE(verifier->IsValid());
  EXPECT_GT(CountViolations(verifier->GetChecks(), "certified_patch_to_input"), 0);
  EXPECT_GT(CountViolations(verifier->GetChecks(), "certified_input_to_cut"), 0);
}

TEST(Verifier, AnErrorThatIsNotNestedIsFoundAndTheInputIsLeftAlone)
{
  const auto store = MTTestModel::MakeTube();
  vtkMTGraph& graph = store->GetMutableGraph();
  graph.Nodes[graph.GetSink() - 1].Error = 10.0 * graph.Nodes[1].Error;
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  bool opened = false;
  ASSERT_TRUE(verifier->Verify(*store,
    [&opened](std::string&)
    {
      opened = true;
      return std::unique_ptr<vtkMTTriangleStream>();
    }));
  EXPECT_FALSE(verifier->IsValid());
  EXPECT_GT(CountViolations(verifier->GetChecks(), "nesting"), 0);
  EXPECT_EQ(CountViolations(verifier->GetChecks(), "conformity"), -1) << "cuts of an unsound model mean nothing";
  EXPECT_FALSE(opened);
}

TEST(Verifier, APatchThatCannotBeReadIsAViolationAndNoError)
{
  BrokenSource broken;
  static_cast<vtkMTPatchStore&>(broken) = *MTTestModel::MakeTube();
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(broken));
  EXPECT_FALSE(verifier->IsValid());
  EXPECT_EQ(CountViolations(verifier->GetChecks(), "checksums"), 1);
  EXPECT_NE(Dump(verifier->GetChecks()).find("the disk is gone"), std::string::npos);
}

TEST(Verifier, TrianglesThatAreNoSurfaceAreCounted)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  const vtkIdType bad = mesh->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  mesh->GetPolys()->InsertNextCell({ vtkIdType(0), vtkIdType(1), bad });
  mesh->GetPolys()->InsertNextCell({ vtkIdType(0), vtkIdType(0), vtkIdType(1) });
  mesh->GetPolys()->InsertNextCell({ vtkIdType(2), vtkIdType(2), vtkIdType(1) });
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(*store, Open(bare))) << verifier->GetErrorMessage();
  EXPECT_TRUE(verifier->IsValid()) << Dump(verifier->GetChecks());
  EXPECT_EQ(verifier->GetNumberOfNonFiniteTriangles(), 1);
  EXPECT_EQ(verifier->GetNumberOfDegenerateTriangles(), 2);
  EXPECT_EQ(verifier->GetNumberOfOutOfRangeTriangles(), 0);
  EXPECT_EQ(verifier->GetNumberOfFarOutliers(), 0);
}

TEST(Verifier, FailuresSayWhyAndLeaveNoChecks)
{
  const auto store = MTTestModel::MakeTube();
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  verifier->SetInputName("scan.ply");
  vtkNew<vtkPolyData> empty;
  EXPECT_FALSE(verifier->Verify(*store, Open(empty)));
  EXPECT_EQ(verifier->GetErrorMessage().rfind("scan.ply: has no triangle", 0), 0u) << verifier->GetErrorMessage();
  EXPECT_EQ(verifier->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UnknownError));
  EXPECT_EQ(verifier->GetChecks()->GetNumberOfRows(), 0);
  EXPECT_FALSE(verifier->IsValid());
  EXPECT_FALSE(verifier->Verify(*store,
    [](std::string& error)
    {
      error = "scan.ply: no such file";
      return std::unique_ptr<vtkMTTriangleStream>();
    }));
  EXPECT_EQ(verifier->GetErrorMessage(), "scan.ply: no such file");
  EXPECT_FALSE(
    verifier->Verify(*store, [](std::string&) -> std::unique_ptr<vtkMTTriangleStream> { throw std::bad_alloc(); }))
    << "an exception left the verifier";
  EXPECT_NE(verifier->GetErrorMessage().find("memory"), std::string::npos);
  EXPECT_TRUE(verifier->Verify(*store));
  EXPECT_EQ(verifier->GetErrorMessage(), "");
}

TEST(Verifier, AFilterWithoutPatchesIsAnError)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  verifier->AddObserver(vtkCommand::ErrorEvent, count);
  verifier->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, count);
  verifier->SetInputData(0, MTTestMeshes::Icosphere(1));
  verifier->Update();
  EXPECT_GT(errors, 0);
  EXPECT_EQ(verifier->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(verifier->GetOutput()->GetNumberOfRows(), 0);
}

TEST(Verifier, ProgressRisesToOneAndAnAbortEndsItWithoutAnError)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  struct State
  {
    std::vector<double> Seen;
    double AbortAt = 2.0;
  } state;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&state);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      auto* seen = static_cast<State*>(data);
      seen->Seen.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(seen->Seen.back() >= seen->AbortAt);
    });
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  verifier->AddObserver(vtkCommand::ProgressEvent, watch);
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh)));
  EXPECT_TRUE(std::is_sorted(state.Seen.begin(), state.Seen.end()));
  EXPECT_GT(state.Seen.size(), 30u);
  EXPECT_DOUBLE_EQ(state.Seen.back(), 1.0);
  for (const double at : { 0.0, 0.1, 0.3, 0.5, 0.9 })
  {
    state.Seen.clear();
    state.AbortAt = at;
    EXPECT_FALSE(verifier->Verify(*store, Open(mesh)));
    EXPECT_EQ(verifier->GetErrorMessage(), "") << at;
    EXPECT_EQ(verifier->GetChecks()->GetNumberOfRows(), 0);
    EXPECT_LT(state.Seen.back(), at + 0.1);
  }
}
