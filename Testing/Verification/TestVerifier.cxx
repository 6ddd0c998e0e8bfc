// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationVerifier: good models pass, planted faults are found by the right check, failures say why.
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTCut.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationVerifier.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
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

TEST(Verifier, TheFilterGivesTheSameTableAndHoldsTheMeshAgainstTheFinestLevel)
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
  std::cout << Dump(filter->GetOutput());
  EXPECT_TRUE(filter->IsValid());
  EXPECT_TRUE(filter->GetInputChecked());
  EXPECT_FALSE(alone->GetInputChecked()) << "a stream of triangles may come from the builder's reader";
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 15);
  const std::string whole = Dump(filter->GetOutput());
  std::istringstream lines(Dump(alone->GetChecks()));
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_NE(whole.find(line), std::string::npos) << line;
  }
}

namespace
{
// What the check says of a mesh that differs from the one that the model was built from; empty when it passes.
std::string GetMessage(const vtkMTPatchStore& store, vtkPolyData* mesh, const std::string& check)
{
  vtkNew<vtkMultiTriangulation> model;
  EXPECT_TRUE(model->SetSource(std::make_shared<vtkMTPatchStore>(store)));
  vtkNew<vtkMultiTriangulationVerifier> filter;
  SetSmall(filter);
  filter->SetInputData(0, model);
  filter->SetInputData(1, mesh);
  filter->Update();
  for (vtkIdType row = 0; row < filter->GetOutput()->GetNumberOfRows(); ++row)
  {
    if (filter->GetOutput()->GetValueByName(row, "name").ToString() == check)
    {
      EXPECT_EQ(filter->GetOutput()->GetValueByName(row, "violations").ToInt() == 0,
        filter->GetOutput()->GetValueByName(row, "message").ToString().empty());
      return filter->GetOutput()->GetValueByName(row, "message").ToString();
    }
  }
  return "no such check";
}

using PointEdit = std::function<void(double x[3])>;

vtkSmartPointer<vtkPolyData> Move(vtkPolyData* mesh, const PointEdit& edit)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(mesh);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[3];
    moved->GetPoint(i, x);
    edit(x);
    moved->GetPoints()->SetPoint(i, x);
  }
  return moved;
}
}

TEST(Verifier, AMeshOfAnotherShapeIsFoundByTheCheckForIt)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  const std::pair<const char*, PointEdit> edits[] = { { "input_bounds", [](double x[3]) { x[0] *= 1.001; } },
    { "input_bounds", [](double x[3]) { x[2] += 1e-3; } }, { "input_orientation", [](double x[3]) { x[0] = -x[0]; } },
    { "input_volume", [](double x[3]) { x[0] = -x[0]; } },
    { "input_area", [](double x[3]) { std::for_each(x, x + 3, [](double& c) { c *= 1.01; }); } } };
  for (const auto& [check, edit] : edits)
  {
    const std::string message = GetMessage(*store, Move(mesh, edit), check);
    std::cout << check << ": " << message << "\n";
    EXPECT_FALSE(message.empty()) << check;
  }
  vtkNew<vtkPolyData> lacking;
  lacking->DeepCopy(mesh);
  lacking->BuildCells();
  lacking->DeleteCell(7);
  lacking->RemoveDeletedCells();
  EXPECT_NE(GetMessage(*store, lacking, "input_triangles").find("too many"), std::string::npos);
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(mesh);
  turned->BuildCells();
  turned->ReverseCell(7);
  EXPECT_NE(GetMessage(*store, turned, "input_orientation").find("turned over"), std::string::npos);
}

TEST(Verifier, ArraysThatAreLostOrMixedAreFound)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  colors->Fill(255);
  vtkNew<vtkPolyData> colored;
  colored->DeepCopy(mesh);
  colored->GetPointData()->SetScalars(colors);
  const std::string lost = GetMessage(*store, colored, "input_arrays");
  EXPECT_NE(lost.find("colours 'RGB'"), std::string::npos) << lost;
  vtkNew<vtkPolyData> mixed;
  mixed->DeepCopy(mesh);
  vtkDataArray* ids = mixed->GetCellData()->GetArray(0);
  const double first = ids->GetTuple1(0);
  ids->SetTuple1(0, ids->GetTuple1(1));
  ids->SetTuple1(1, first);
  const std::string message = GetMessage(*store, mixed, "input_arrays");
  std::cout << lost << "\n" << message << "\n";
  EXPECT_NE(message.find("the input has"), std::string::npos) << message;
  vtkNew<vtkPolyData> scaled;
  scaled->DeepCopy(mesh);
  scaled->GetPointData()->GetArray("height")->SetTuple1(5, 1e6);
  EXPECT_FALSE(GetMessage(*store, scaled, "input_arrays").empty());
}

TEST(Verifier, LabelsThatMixOnCoarseLevelsAreFound)
{
  const auto store = MTTestModel::MakeTube();
  vtkMTGraph& graph = store->GetMutableGraph();
  for (vtkMTArrayInfo& array : graph.Arrays)
  {
    array.Role = vtkMTArrayInfo::Plain; // the cell ids become labels: 7 everywhere
  }
  for (vtkMTPatch& patch : store->GetMutablePatches())
  {
    vtkMTColumn& column = patch.CellColumns.at(0);
    for (std::size_t i = 0; i < column.size(); ++i)
    {
      column[i] = i % sizeof(vtkIdType) == 0 ? 7 : 0;
    }
  }
  EXPECT_EQ(GetMessage(*store, MakeInput(*store), "labels"), "");
  store->GetMutablePatches().at(0).CellColumns.at(0).at(0) = 8; // the first arc leaves the source: it is coarse
  EXPECT_NE(GetMessage(*store, MakeInput(*store), "labels").find("mixed"), std::string::npos);
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

// A model with distances of its patches, as those of a builder are: all of what the nodes say.
TEST(Verifier, DistancesOfPatchesThatAreTooSmallAreFound)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkMTGraph& graph = store->GetMutableGraph();
  const auto verify = [&](float toInput, float fromInput)
  {
    for (vtkMTArc& arc : graph.Arcs)
    {
      const auto steps = static_cast<float>(0.999999 * graph.Nodes[arc.To].OwnError / graph.Lattice.Step);
      arc.ToInput = toInput * steps;
      arc.FromInput = fromInput * steps;
    }
    vtkNew<vtkMultiTriangulationVerifier> verifier;
    SetSmall(verifier);
    EXPECT_TRUE(verifier->Verify(*store, Open(mesh)));
    const auto violations = std::make_pair(CountViolations(verifier->GetChecks(), "certified_patch_to_input"),
      CountViolations(verifier->GetChecks(), "certified_input_to_cut"));
    std::cout << "distances of " << toInput << " and " << fromInput << " of the nodes' errors: " << violations.first
              << " and " << violations.second << " violations\n";
    return violations;
  };
  EXPECT_EQ(verify(1.0f, 1.0f), std::make_pair(0, 0));
  EXPECT_GT(verify(0.1f, 1.0f).first, 0);
  EXPECT_GT(verify(1.0f, 0.1f).second, 0);
}

// The largest distance of all holds, but that of one patch does not.
TEST(Verifier, ADistanceOfOnePatchThatIsTooSmallIsFound)
{
  const auto store = MTTestModel::MakeTube();
  const auto mesh = MakeInput(*store);
  vtkMTGraph& graph = store->GetMutableGraph();
  for (std::uint32_t i = 0; i < graph.Arcs.size(); ++i)
  {
    const auto steps = static_cast<float>(0.999999 * graph.Nodes[graph.Arcs[i].To].OwnError / graph.Lattice.Step);
    graph.Arcs[i].ToInput = steps;
    graph.Arcs[i].FromInput = i == 0 ? 0.0f : steps;
  }
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  SetSmall(verifier);
  ASSERT_TRUE(verifier->Verify(*store, Open(mesh)));
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
