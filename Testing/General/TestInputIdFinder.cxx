// SPDX-License-Identifier: BSD-3-Clause
// The input's ids of places on coarse patches are those that a search over the whole input finds.
#include "MTGeneralTest.h"

#include "vtkMTCut.h"
#include "vtkMTCutIds.h"
#include "vtkMTFinestNear.h"
#include "vtkMTGraph.h"
#include "vtkMTInputIdFinder.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTRandomCut.h"
#include "vtkMultiTriangulationCutFilter.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkReverseSense.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangle.h"

#include <chrono>
#include <iostream>
#include <memory>

using namespace MTGeneralTest;

namespace
{
using Finder = vtkMTInputIdFinder;
using Query = vtkMTInputIdFinder::Query;
using Place = std::array<double, 3>;

struct Model
{
  MTTestMeshes::Mesh Input;
  std::shared_ptr<vtkMTPatchStore> Store = std::make_shared<vtkMTPatchStore>();
  const vtkMTGraph& Graph() const { return this->Store->GetGraph(); }
};

Model Build(const MTTestMeshes::Mesh& input, int ids = vtkMultiTriangulationBuilder::FinestInputIds)
{
  Model model;
  model.Input = input;
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(200);
  builder->MakeNormalsOff();
  builder->SetInputIds(ids);
  builder->InputPointIdsOn();
  vtkMTPolyDataStream stream(input);
  EXPECT_TRUE(builder->Build(stream, *model.Store)) << builder->GetErrorMessage();
  return model;
}

// Two shells, one so near to the other one that coarse patches are farther from the input than they are apart, the
// inner one turned inside out, as the two sides of a thin wall are.
MTTestMeshes::Mesh MakeWall()
{
  const auto outer = MTTestMeshes::FractalSphere(5);
  vtkNew<vtkTransform> smaller;
  smaller->Scale(0.995, 0.995, 0.995);
  vtkNew<vtkTransformPolyDataFilter> inner;
  inner->SetInputData(outer);
  inner->SetTransform(smaller);
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(inner->GetOutputPort());
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(outer);
  both->AddInputConnection(reversed->GetOutputPort());
  both->Update();
  auto mesh = MTTestMeshes::Mesh::New();
  mesh->ShallowCopy(both->GetOutput());
  return mesh;
}

const Model& GetModel(bool isWall)
{
  static const Model sphere = Build(MTTestMeshes::FractalSphere(5));
  static const Model wall = Build(MakeWall());
  return isWall ? wall : sphere;
}

// Places on triangles of the cut's coarse patches, with their normals.
std::vector<Query> MakeQueries(const Model& model, const vtkMTCut& cut, std::size_t count, std::uint64_t seed)
{
  MTTestMeshes::Random random(seed);
  std::vector<std::uint32_t> arcs;
  for (const std::uint32_t arc : cut.GetArcs())
  {
    if (!model.Graph().IsFinest(arc) && model.Graph().Arcs[arc].Triangles > 0)
    {
      arcs.push_back(arc);
    }
  }
  std::vector<Query> queries;
  while (!arcs.empty() && queries.size() < count)
  {
    Query query;
    query.Arc = arcs[random.Below(arcs.size())];
    vtkMTPatch patch;
    std::string error;
    EXPECT_TRUE(model.Store->ReadPatch(query.Arc, nullptr, patch, error)) << error;
    const vtkMTTriangle points = patch.GetPointsOfTriangle(random.Below(patch.Triangles.size()));
    double weights[3] = { random.Uniform(), random.Uniform(), 0.0 };
    if (weights[0] + weights[1] > 1.0)
    {
      weights[0] = 1.0 - weights[0];
      weights[1] = 1.0 - weights[1];
    }
    weights[2] = 1.0 - weights[0] - weights[1];
    Place corners[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = model.Graph().Lattice.ToWorld(patch.Points[points[i]]);
      for (int k = 0; k < 3; ++k)
      {
        query.X[k] += weights[i] * corners[i][k];
      }
    }
    vtkTriangle::ComputeNormal(corners[0].data(), corners[1].data(), corners[2].data(), query.Direction.data());
    queries.push_back(query);
  }
  return queries;
}

// All triangles of the input, by VTK's own arithmetic.
class BruteForce
{
public:
  explicit BruteForce(vtkPolyData* input)
    : Input(input)
  {
    vtkNew<vtkIdList> ids;
    this->Corners.resize(static_cast<std::size_t>(input->GetNumberOfCells()));
    for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
    {
      input->GetCellPoints(c, ids);
      for (int i = 0; i < 3; ++i)
      {
        input->GetPoint(ids->GetId(i), this->Corners[c][i].data());
      }
    }
    this->Triangle->GetPoints()->SetNumberOfPoints(3);
  }

  double GetDistance(vtkIdType cell, const Place& x)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Triangle->GetPoints()->SetPoint(i, this->Corners[cell][i].data());
    }
    double closest[3];
    double coordinates[3];
    double weights[3];
    double distance2 = 0.0;
    int part = 0;
    this->Triangle->EvaluatePosition(x.data(), closest, part, coordinates, distance2, weights);
    return std::sqrt(distance2);
  }

  bool Faces(vtkIdType cell, const Place& direction) const
  {
    double normal[3];
    const auto& c = this->Corners[cell];
    vtkTriangle::ComputeNormal(c[0].data(), c[1].data(), c[2].data(), normal);
    return vtkMath::Dot(normal, direction.data()) > 0.0;
  }

  // The least distance of those that face the same way within reach, or of all.
  double FindNearest(const Query& query, double reach, bool& isFacing)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    double any = infinity;
    double facing = infinity;
    for (vtkIdType c = 0; c < this->Input->GetNumberOfCells(); ++c)
    {
      const double distance = this->GetDistance(c, query.X);
      any = std::min(any, distance);
      facing = distance <= reach && this->Faces(c, query.Direction) ? std::min(facing, distance) : facing;
    }
    isFacing = facing < infinity;
    return isFacing ? facing : any;
  }

  double FindNearestPoint(const Place& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    double y[3];
    for (vtkIdType p = 0; p < this->Input->GetNumberOfPoints(); ++p)
    {
      this->Input->GetPoint(p, y);
      least = std::min(least, vtkMath::Distance2BetweenPoints(x.data(), y));
    }
    return std::sqrt(least);
  }

private:
  vtkPolyData* Input;
  vtkNew<vtkTriangle> Triangle;
  std::vector<std::array<Place, 3>> Corners;
};

struct Comparison
{
  int Compared = 0;
  int Wrong = 0;
  int OtherSide = 0; // that the nearest one of all would have been
};

Comparison Compare(const Model& model, const std::vector<Query>& queries, const std::vector<vtkIdType>& ids)
{
  const vtkMTLattice& lattice = model.Graph().Lattice;
  BruteForce brute(model.Input);
  Comparison result;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const double reach = model.Graph().GetDistanceToInput(queries[i].Arc) + lattice.Step;
    const double step = 2.0 * lattice.MaximumShift + 1e-9 * lattice.Step;
    bool isFacing = false;
    const double nearest = brute.FindNearest(queries[i], reach, isFacing);
    Query undirected = queries[i];
    undirected.Direction = { 0.0, 0.0, 0.0 };
    bool unused = false;
    result.OtherSide += brute.FindNearest(undirected, reach, unused) < nearest - step ? 1 : 0;
    ++result.Compared;
    const bool isThere = ids[i] >= 0 && ids[i] < model.Input->GetNumberOfCells();
    const bool isRight = isThere && brute.GetDistance(ids[i], queries[i].X) <= nearest + step &&
      (!isFacing || brute.Faces(ids[i], queries[i].Direction));
    result.Wrong += isRight ? 0 : 1;
  }
  return result;
}

std::vector<vtkIdType> Find(const vtkMTPatchSource& source, const std::vector<Query>& queries,
  const Finder::Settings& settings = Finder::Settings(), vtkMTArrayInfo::RoleType role = vtkMTArrayInfo::InputCellIds)
{
  Finder finder(source, role, settings);
  std::vector<vtkIdType> ids;
  std::string error;
  EXPECT_TRUE(finder.Find(queries, ids, error)) << error;
  return ids;
}

// A coarse cut, some mixed ones, and a fine one.
std::vector<vtkMTCut> MakeCuts(const vtkMTGraph& graph)
{
  std::vector<vtkMTCut> cuts{ vtkMTCut(graph) };
  for (std::size_t i = 0; i < 4; ++i)
  {
    cuts.push_back(vtkMTRandomCut::Make(graph, 5, i));
  }
  return cuts;
}
}

class InputIdFinderOf : public ::testing::TestWithParam<bool>
{
};

TEST_P(InputIdFinderOf, PlacesOnCoarsePatchesFindsTheInputsNearestCell)
{
  const Model& model = GetModel(GetParam());
  std::uint64_t seed = 1;
  for (const vtkMTCut& cut : MakeCuts(model.Graph()))
  {
    const std::vector<Query> queries = MakeQueries(model, cut, 60, seed++);
    const Comparison result = Compare(model, queries, Find(*model.Store, queries));
    std::cout << cut.GetNumberOfTriangles() << " triangles: " << result.Compared << " places, " << result.Wrong
              << " wrong; for " << result.OtherSide << " one that faces the other way is nearer\n";
    EXPECT_EQ(result.Wrong, 0);
    EXPECT_EQ(result.Compared, static_cast<int>(queries.size()));
  }
}

TEST_P(InputIdFinderOf, PlacesOnCoarsePatchesFindsTheInputsNearestPoint)
{
  const Model& model = GetModel(GetParam());
  const std::vector<Query> queries = MakeQueries(model, vtkMTCut(model.Graph()), 200, 9);
  const std::vector<vtkIdType> ids = Find(*model.Store, queries, Finder::Settings(), vtkMTArrayInfo::InputPointIds);
  const BruteForce brute(model.Input);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    double x[3];
    model.Input->GetPoint(ids[i], x);
    EXPECT_LE(std::sqrt(vtkMath::Distance2BetweenPoints(x, queries[i].X.data())),
      brute.FindNearestPoint(queries[i].X) + 2.0 * model.Graph().Lattice.MaximumShift);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, InputIdFinderOf, ::testing::Bool());

// The comparison of these tests sees a fault: ids of neighbours.
TEST(InputIdFinder, WrongIdsAreSeen)
{
  const Model& model = GetModel(true);
  const std::vector<Query> queries = MakeQueries(model, vtkMTCut(model.Graph()), 60, 1);
  std::vector<vtkIdType> ids = Find(*model.Store, queries);
  for (vtkIdType& id : ids)
  {
    id = (id + 1) % model.Input->GetNumberOfCells();
  }
  const Comparison shifted = Compare(model, queries, ids);
  std::cout << shifted.Wrong << " of " << shifted.Compared << " wrong ids are seen\n";
  EXPECT_GT(shifted.Wrong, shifted.Compared / 2);
}

// A pick reads few patches, whatever the model's size: here of about a thousand on the finest level.
TEST(InputIdFinder, APlaceTakesFewPatches)
{
  const Model model = Build(MTTestMeshes::FractalSphere(6));
  std::size_t finest = 0;
  for (std::uint32_t arc = 0; arc < model.Graph().Arcs.size(); ++arc)
  {
    finest += model.Graph().IsFinest(arc) ? 1 : 0;
  }
  for (const vtkMTCut& cut : MakeCuts(model.Graph()))
  {
    const std::vector<Query> queries = MakeQueries(model, cut, 100, 7);
    std::uint64_t most = 0;
    std::uint64_t all = 0;
    std::uint64_t nodes = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (const Query& query : queries)
    {
      Finder finder(*model.Store, vtkMTArrayInfo::InputCellIds);
      std::vector<vtkIdType> ids;
      std::string error;
      ASSERT_TRUE(finder.Find({ query }, ids, error)) << error;
      EXPECT_GE(ids[0], 0);
      most = std::max(most, finder.GetNumberOfReads());
      all += finder.GetNumberOfReads();
      nodes += finder.GetNumberOfNodes();
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    const double count = static_cast<double>(std::max<std::size_t>(queries.size(), 1));
    std::cout << cut.GetNumberOfTriangles() << " triangles: " << all / count << " of " << finest
              << " patches read for a place, " << most << " at most; " << nodes / count << " of "
              << model.Graph().Nodes.size() << " nodes; " << time.count() / count << " ms\n";
    EXPECT_LE(all / count, 4.0);
    EXPECT_LE(most, 16u);
  }
}

TEST(InputIdFinder, ManyPlacesAreAsOneByOneForAnyThreadsAndLimitAndReadEachPatchOnce)
{
  const Model& model = GetModel(false);
  const vtkMTCut cut = vtkMTRandomCut::Make(model.Graph(), 5, 1);
  std::vector<Query> queries = MakeQueries(model, cut, 2000, 3);
  std::stable_sort(
    queries.begin(), queries.end(), [](const Query& a, const Query& b) { return a.Arc < b.Arc; }); // as selections are
  std::vector<vtkIdType> expected;
  for (const Query& query : queries)
  {
    expected.push_back(Find(*model.Store, { query })[0]);
  }
  for (const int threads : { 1, 2, 7 })
  {
    for (const std::size_t limit : { std::size_t(0), std::size_t(50000), std::size_t(64) << 20 })
    {
      const auto source = std::make_shared<CountingSource>(model.Store);
      Finder finder(*source, vtkMTArrayInfo::InputCellIds, { limit, threads });
      std::vector<vtkIdType> ids;
      std::string error;
      ASSERT_TRUE(finder.Find(queries, ids, error)) << error;
      EXPECT_TRUE(ids == expected) << threads << " threads, " << limit << " bytes";
      std::size_t finest = 0;
      for (std::uint32_t arc = 0; arc < model.Graph().Arcs.size(); ++arc)
      {
        finest += model.Graph().IsFinest(arc) ? 1 : 0;
      }
      std::cout << threads << " threads, " << limit << " bytes: " << source->Reads << " reads, " << finest
                << " patches\n";
      EXPECT_TRUE(limit < (std::size_t(1) << 20) || static_cast<std::size_t>(source->Reads) <= finest);
    }
  }
}

TEST(InputIdFinder, SaysWhatItCouldNotRead)
{
  const Model& model = GetModel(false);
  const std::vector<Query> queries = MakeQueries(model, vtkMTCut(model.Graph()), 100, 3);
  const auto source = std::make_shared<CountingSource>(model.Store);
  source->IsBroken = true;
  Finder finder(*source, vtkMTArrayInfo::InputCellIds);
  std::vector<vtkIdType> ids;
  std::string error;
  EXPECT_FALSE(finder.Find(queries, ids, error));
  EXPECT_NE(error.find("broken on purpose"), std::string::npos) << error;
  EXPECT_EQ(ids, std::vector<vtkIdType>(queries.size(), Finder::Unknown));
  Finder stopped(*model.Store, vtkMTArrayInfo::InputCellIds);
  EXPECT_FALSE(stopped.Find(queries, ids, error, [](double) { return false; }));
  EXPECT_EQ(error, "");
  double last = 0.0;
  EXPECT_TRUE(stopped.Find(queries, ids, error,
    [&last](double fraction)
    {
      EXPECT_TRUE(fraction >= last && fraction <= 1.0);
      last = fraction;
      return true;
    }));
  EXPECT_EQ(last, 1.0);
}

// Of a graph that cannot be read to its end nothing is guessed.
TEST(InputIdFinder, IsSilentWhereTheGraphIsNotKnown)
{
  const Model model = Build(MTTestMeshes::FractalSphere(3));
  const std::vector<Query> queries = MakeQueries(model, vtkMTCut(model.Graph()), 10, 3);
  model.Store->GetMutableGraph().SetNumberOfKnownNodes(2);
  Finder finder(*model.Store, vtkMTArrayInfo::InputCellIds);
  std::vector<vtkIdType> ids;
  std::string error;
  EXPECT_FALSE(finder.Find(queries, ids, error));
  EXPECT_EQ(ids, std::vector<vtkIdType>(queries.size(), Finder::Unknown));
}

TEST(InputIdFinder, CutsHaveTheIdsOfTheNearestCellsWhenTheyAreAskedFor)
{
  const Model& model = GetModel(true);
  const auto data = MakeModel(model.Store);
  vtkNew<vtkTransform> mirrored;
  mirrored->Scale(-2.0, 2.0, 2.0);
  for (const bool isPlaced : { false, true })
  {
    vtkNew<vtkMultiTriangulation> placed;
    placed->ShallowCopy(data);
    ASSERT_TRUE(!isPlaced || placed->ApplyTransform(mirrored->GetMatrix()->GetData()));
    vtkNew<vtkMultiTriangulationCutFilter> filter;
    filter->SetInputData(placed);
    filter->SetTriangleLimit(6000);
    filter->Update();
    auto* ids = vtkIdTypeArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("vtkMTInputCellIds"));
    ASSERT_NE(ids, nullptr);
    vtkIdType unknown = 0;
    for (vtkIdType c = 0; c < ids->GetNumberOfValues(); ++c)
    {
      unknown += ids->GetValue(c) == -1 ? 1 : 0;
    }
    filter->FindInputIdsOn();
    filter->Update();
    vtkPolyData* mesh = filter->GetOutput();
    ids = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("vtkMTInputCellIds"));
    BruteForce brute(model.Input);
    int wrong = 0;
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); c += 97)
    {
      Query query;
      mesh->GetCellPoints(c, corners);
      Place places[3];
      for (int i = 0; i < 3; ++i)
      {
        mesh->GetPoint(corners->GetId(i), places[i].data());
        for (int k = 0; k < 3 && isPlaced; ++k)
        {
          places[i][k] *= k == 0 ? -0.5 : 0.5;
        }
        vtkMath::Add(query.X.data(), places[i].data(), query.X.data());
      }
      vtkMath::MultiplyScalar(query.X.data(), 1.0 / 3.0);
      vtkTriangle::ComputeNormal(places[0].data(), places[1].data(), places[2].data(), query.Direction.data());
      vtkMath::MultiplyScalar(query.Direction.data(), isPlaced ? -1.0 : 1.0);
      bool isFacing = false;
      const double nearest = brute.FindNearest(query, filter->GetDistanceToInput(), isFacing);
      const double step = 3.0 * model.Graph().Lattice.Step;
      wrong += brute.GetDistance(ids->GetValue(c), query.X) > nearest + step ||
          (isFacing && !brute.Faces(ids->GetValue(c), query.Direction))
        ? 1
        : 0;
    }
    std::cout << unknown << " of " << mesh->GetNumberOfCells() << " cells had no id; " << wrong << " are wrong\n";
    EXPECT_GT(unknown, 1000);
    EXPECT_EQ(wrong, 0);
    auto* points = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray("vtkMTInputPointIds"));
    ASSERT_NE(points, nullptr);
    for (vtkIdType p = 0; p < points->GetNumberOfValues(); ++p)
    {
      EXPECT_GE(points->GetValue(p), 0);
    }
  }
}
