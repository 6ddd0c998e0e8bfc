// SPDX-License-Identifier: BSD-3-Clause
// A sound model has no findings; every kind of damage that is planted is found by the check that is meant for it.
#include "MTTestModel.h"
#include "vtkMTAssembler.h"
#include "vtkMTCut.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <limits>
#include <map>

namespace
{
using Result = vtkMTValidate::Result;
using Damage = std::function<void(vtkMTPatchStore&)>;

std::shared_ptr<vtkMTPatchStore> MakeSmallTube()
{
  MTTestModel::TubeOptions options;
  options.Rings = 128;
  options.Regions = 8;
  return MTTestModel::MakeTube(options);
}

// An arc between two inner nodes: its patch is part of a fragment and of a floor.
std::uint32_t FindInnerArc(const vtkMTGraph& graph)
{
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    if (graph.Arcs[arc].From != graph.GetSource() && graph.Arcs[arc].To != graph.GetSink())
    {
      return arc;
    }
  }
  ADD_FAILURE() << "no inner arc";
  return 0;
}

vtkMTPatch& InnerPatch(vtkMTPatchStore& store)
{
  return store.GetMutablePatches()[FindInnerArc(store.GetGraph())];
}

void RefillRecords(vtkMTPatchStore& store)
{
  vtkMTGraph& graph = store.GetMutableGraph();
  for (std::size_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    MTTestModel::FillRecord(store.GetMutablePatches()[arc], graph.Lattice, graph.Arcs[arc]);
  }
}

void RemoveTriangle(vtkMTPatch& patch, std::size_t triangle)
{
  patch.Triangles.erase(patch.Triangles.begin() + triangle);
  for (vtkMTColumn& column : patch.CellColumns)
  {
    const std::size_t size = column.size() / (patch.Triangles.size() + 1);
    column.erase(column.begin() + triangle * size, column.begin() + (triangle + 1) * size);
  }
}

bool IsShared(const vtkMTPatch& patch, std::uint32_t wedge)
{
  return patch.GetPointOfWedge(wedge) < patch.Ids.size();
}

// A triangle with two shared points that other patches use as well.
std::size_t FindBorderTriangle(const vtkMTPatch& patch, int sharedCorners)
{
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    int shared = 0;
    for (std::uint32_t wedge : patch.Triangles[t])
    {
      shared += IsShared(patch, wedge) ? 1 : 0;
    }
    if (shared == sharedCorners)
    {
      return t;
    }
  }
  ADD_FAILURE() << "no triangle with " << sharedCorners << " shared corners";
  return 0;
}

std::string Describe(const Result& result)
{
  std::string text = std::to_string(result.Violations) + " violations";
  for (const vtkMTValidate::Finding& finding : result.Findings)
  {
    text += "\n  " + finding.Check + ": " + finding.What;
  }
  return text;
}

bool Has(const Result& result, const std::string& check, const std::string& words)
{
  for (const vtkMTValidate::Finding& finding : result.Findings)
  {
    if (finding.Check == check && finding.What.find(words) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

struct Planted
{
  const char* Words; // of the finding
  Damage Do;
};
}

TEST(Validate, SoundModelsHaveNoFindings)
{
  MTTestModel::TubeOptions options[4];
  options[1].Arrays = false;
  options[2].Rings = 1024;
  options[2].Regions = 64;
  options[2].Offset = { 500000, 5400000, 300 };
  options[3].Scale = 1e-30;
  for (const MTTestModel::TubeOptions& option : options)
  {
    const auto tube = MTTestModel::MakeTube(option);
    const Result result = vtkMTValidate::All(*tube, 200, 1);
    std::cout << tube->GetGraph().Arcs.size() << " patches, " << result.Tested << " tests\n";
    EXPECT_TRUE(result.IsValid()) << Describe(result);
  }
}

TEST(Validate, CutOfClosedMeshHasNoBoundary)
{
  const auto tube = MTTestModel::MakeTube();
  vtkMTValidate::Borders borders;
  ASSERT_TRUE(borders.Load(*tube).IsValid());
  for (std::size_t i = 0; i < 300; ++i)
  {
    ASSERT_EQ(borders.CountBorderEdges(vtkMTRandomCut::Make(tube->GetGraph(), 2, i)), 0u);
  }
}

TEST(Validate, BorderEdgesAreThoseOfTheAssembledMesh)
{
  // With holes: triangles of the finest level and of coarser ones are missing, so this is also no sound model.
  const auto tube = MakeSmallTube();
  for (vtkMTPatch& patch : tube->GetMutablePatches())
  {
    RemoveTriangle(patch, patch.Triangles.size() / 2);
  }
  RefillRecords(*tube);
  vtkMTValidate::Borders borders;
  borders.Load(*tube);
  for (std::size_t i = 0; i < 50; ++i)
  {
    const vtkMTCut cut = vtkMTRandomCut::Make(tube->GetGraph(), 3, i);
    vtkMTAssembler assembler(tube->GetGraph().Arrays);
    for (std::uint32_t arc : cut.GetArcs())
    {
      ASSERT_TRUE(assembler.Add(tube->GetMutablePatches()[arc]));
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t t = 0; t < assembler.GetMesh().Triangles.size(); ++t)
    {
      const vtkMTTriangle p = assembler.GetMesh().GetPointsOfTriangle(t);
      for (int j = 0; j < 3; ++j)
      {
        ++edges[std::minmax(p[j], p[(j + 1) % 3])];
      }
    }
    const auto open = std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; });
    ASSERT_GT(open, 0);
    ASSERT_EQ(borders.CountBorderEdges(cut), static_cast<std::uint64_t>(open));
  }
}

TEST(Validate, DamagedGraphsAreFound)
{
  using Store = vtkMTPatchStore;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Planted damages[] = {
    { "power of two", [](Store& s) { s.GetMutableGraph().Lattice.Step *= 1.5; } },
    { "2^53", [](Store& s) { s.GetMutableGraph().Lattice.Origin[1] = std::int64_t(1) << 60; } },
    { "runs from node", [](Store& s) { s.GetMutableGraph().Arcs[3].To = s.GetGraph().Arcs[3].From; } },
    { "runs from node", [](Store& s) { s.GetMutableGraph().Arcs[3].To = 1000000; } },
    { "out of order", [](Store& s) { std::swap(s.GetMutableGraph().Arcs.front(), s.GetMutableGraph().Arcs.back()); } },
    { "entries for", [](Store& s) { s.GetMutableGraph().Entering.pop_back(); } },
    { "Entering 2 is arc", [](Store& s) { s.GetMutableGraph().Entering[2] = 4000000000u; } },
    { "does not enter node", [](Store& s) { s.GetMutableGraph().Entering[2] = s.GetGraph().Entering[3]; } },
    { "do not begin where", [](Store& s) { ++s.GetMutableGraph().Nodes[2].FirstOut; } },
    { "arcs that leave and", [](Store& s) { ++s.GetMutableGraph().Nodes.back().InCount; } },
    { "is left by 0",
      [](Store& s)
      {
        vtkMTGraph& g = s.GetMutableGraph();
        g.Nodes.push_back(g.Nodes.back()); // the former sink has no arc that leaves
        g.Index();
      } },
    { "the sink's level", [](Store& s) { s.GetMutableGraph().Nodes.back().Level = 1; } },
    { "runs from level", [](Store& s) { s.GetMutableGraph().Nodes[2].Level = 0; } },
    { "runs from level", [](Store& s) { s.GetMutableGraph().Nodes[0].Level = 4000000000u; } },
    { "negative or no number", [nan](Store& s) { s.GetMutableGraph().Nodes[2].Error = nan; } },
    { "negative or no number", [](Store& s) { s.GetMutableGraph().Nodes[2].OwnError = -1.0; } },
    { "is not saturated",
      [](Store& s)
      {
        vtkMTNode& node = s.GetMutableGraph().Nodes[2];
        node.OwnError = 0.0;
        node.Error = std::nextafter(s.GetGraph().Nodes[s.GetGraph().Arcs[node.FirstOut].To].Error, 0.0);
      } },
    { "is less than its own",
      [](Store& s)
      {
        vtkMTNode& node = s.GetMutableGraph().Nodes[2];
        node.OwnError = node.Error;
      } },
    { "edge length", [](Store& s) { s.GetMutableGraph().Nodes[1].EdgeLength *= 0.001; } },
    { "does not hold that of node", [](Store& s) { s.GetMutableGraph().Nodes[1].Radius *= 0.9; } },
    { "does not hold the patch of arc",
      [](Store& s) { s.GetMutableGraph().Nodes[s.GetGraph().GetSink() - 1].Center[2] += 1.0; } },
    { "sphere of the sink", [](Store& s) { s.GetMutableGraph().Nodes.back().Radius *= 0.5; } },
    { "empty patch", [](Store& s) { s.GetMutableGraph().Arcs[2].Triangles = 0; } },
    { "more shared points", [](Store& s) { s.GetMutableGraph().Arcs[2].SharedPoints = 100000; } },
    { "empty box",
      [](Store& s) {
        s.GetMutableGraph().Arcs[2].Box = { 0, -1, 0, -1, 0, -1 };
      } },
    { "the input", [](Store& s) { s.GetMutableGraph().InputCounts.Triangles = 7; } },
    { "needs a source", [](Store& s) { s.GetMutableGraph() = vtkMTGraph(); } },
  };
  for (const Planted& damage : damages)
  {
    const auto tube = MakeSmallTube();
    ASSERT_TRUE(vtkMTValidate::Graph(tube->GetGraph()).IsValid());
    damage.Do(*tube);
    const Result result = vtkMTValidate::Graph(tube->GetGraph());
    EXPECT_TRUE(Has(result, "graph", damage.Words)) << damage.Words << " was not among " << Describe(result);
    EXPECT_FALSE(vtkMTValidate::All(*tube, 3, 1).IsValid());
  }
}

TEST(Validate, DamagedPatchesAreFound)
{
  using Store = vtkMTPatchStore;
  const Planted damages[] = {
    { "does not exist", [](Store& s) { InnerPatch(s).Triangles[1][1] = 1000000; } },
    { "is of point", [](Store& s) { InnerPatch(s).WedgePoints[1] = 1000000; } },
    { "repeats a point", [](Store& s) { InnerPatch(s).Triangles[1][1] = InnerPatch(s).Triangles[1][0]; } },
    { "bytes for", [](Store& s) { InnerPatch(s).PointColumns[1].pop_back(); } },
    { "bytes for", [](Store& s) { InnerPatch(s).CellColumns[0].resize(8); } },
    { "point and", [](Store& s) { InnerPatch(s).PointColumns.emplace_back(); } },
    { "occurs twice", [](Store& s) { InnerPatch(s).Ids[1] = InnerPatch(s).Ids[0]; } },
    { "more ids than points",
      [](Store& s)
      {
        for (std::uint64_t id = 0; InnerPatch(s).Ids.size() <= InnerPatch(s).Points.size(); ++id)
        {
          InnerPatch(s).Ids.push_back(1000000 + id);
        }
      } },
    { "its record says", [](Store& s) { RemoveTriangle(InnerPatch(s), 0); } },
    { "box of its record", [](Store& s) { s.GetMutableGraph().Arcs[FindInnerArc(s.GetGraph())].Box[1] += 1; } },
    { "outside the cone",
      [](Store& s)
      {
        vtkMTArc& arc = s.GetMutableGraph().Arcs[FindInnerArc(s.GetGraph())];
        arc.ConeAxis = { 0.0f, 0.0f, 1.0f };
        arc.ConeCosine = 0.999f;
      } },
    { "cannot be read", [](Store& s) { s.GetMutablePatches().pop_back(); } },
  };
  for (const Planted& damage : damages)
  {
    const auto tube = MakeSmallTube();
    damage.Do(*tube);
    const Result result = vtkMTValidate::All(*tube, 0, 1);
    EXPECT_TRUE(Has(result, "patch", damage.Words)) << damage.Words << " was not among " << Describe(result);
  }
}

// Damage that leaves every patch sound by itself and breaks how patches fit together.
TEST(Validate, DamagedPastingIsFoundAndMakesBrokenCuts)
{
  using Store = vtkMTPatchStore;
  const Planted damages[] = {
    { "lies in two places",
      [](Store& s)
      {
        vtkMTPatch& patch = InnerPatch(s);
        patch.Points[0][2] += 1;
      } },
    { "triangles in the floor", [](Store& s) { InnerPatch(s).Ids[0] = 999999; } }, // a point has lost its identity
    { "triangles in the floor", [](Store& s) { RemoveTriangle(InnerPatch(s), FindBorderTriangle(InnerPatch(s), 2)); } },
    { "triangles in the floor",
      [](Store& s) { // one triangle winds the other way round
        vtkMTTriangle& t = InnerPatch(s).Triangles[FindBorderTriangle(InnerPatch(s), 2)];
        std::swap(t[0], t[1]);
      } },
    { "triangles in the floor",
      [](Store& s) { // a triangle is there twice
        vtkMTPatch& patch = InnerPatch(s);
        patch.Triangles.push_back(patch.Triangles[FindBorderTriangle(patch, 2)]);
        patch.CellColumns[0].resize(patch.Triangles.size() * 8);
      } },
    { "triangles in the floor",
      [](Store& s) { // a T-junction: a border edge is split on one side
        vtkMTPatch& patch = InnerPatch(s);
        const std::size_t index = FindBorderTriangle(patch, 2);
        vtkMTTriangle t = patch.Triangles[index];
        while (!IsShared(patch, t[0]) || !IsShared(patch, t[1]))
        {
          std::rotate(t.begin(), t.begin() + 1, t.end());
        }
        const vtkMTPoint& a = patch.Points[patch.GetPointOfWedge(t[0])];
        const vtkMTPoint& b = patch.Points[patch.GetPointOfWedge(t[1])];
        const vtkMTPoint middle{ a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2, a[2] + (b[2] - a[2]) / 2 };
        const std::uint32_t wedge = static_cast<std::uint32_t>(patch.GetNumberOfWedges());
        patch.WedgePoints.push_back(static_cast<std::uint32_t>(patch.Points.size()));
        patch.Points.push_back(middle);
        patch.PointColumns[0].resize((wedge + 1) * 4);
        patch.PointColumns[1].resize((wedge + 1) * 8);
        patch.Triangles[index] = { t[0], wedge, t[2] };
        patch.Triangles.push_back({ wedge, t[1], t[2] });
        patch.CellColumns[0].resize(patch.Triangles.size() * 8);
      } },
  };
  for (const Planted& damage : damages)
  {
    const auto tube = MakeSmallTube();
    damage.Do(*tube);
    RefillRecords(*tube);
    tube->GetMutableGraph().Saturate(tube->GetGraph().Nodes.back().Error);
    ASSERT_TRUE(vtkMTValidate::Graph(tube->GetGraph()).IsValid()) << damage.Words;
    vtkMTValidate::Borders borders;
    const Result result = borders.Load(*tube);
    EXPECT_TRUE(Has(result, "paste", damage.Words)) << damage.Words << " was not among " << Describe(result);
    EXPECT_FALSE(Has(result, "patch", "")) << Describe(result);
    Result cuts;
    for (std::size_t i = 0; i < 100; ++i)
    {
      cuts.Append(borders.Cut(vtkMTRandomCut::Make(tube->GetGraph(), 1, i)));
    }
    std::cout << damage.Words << ": " << result.Violations << " at nodes, " << cuts.Violations << " in 100 cuts\n";
    const bool turned = &damage == &damages[3]; // as many triangles at every edge: only pasting sees directions
    EXPECT_EQ(cuts.Violations > 0, !turned) << damage.Words << Describe(cuts);
  }
}

TEST(Validate, HoleInsideAFragmentIsFoundAndAHoleOfTheInputIsNot)
{
  const auto tube = MakeSmallTube();
  vtkMTPatch& patch = InnerPatch(*tube);
  RemoveTriangle(patch, FindBorderTriangle(patch, 0));
  RefillRecords(*tube);
  vtkMTValidate::Borders borders;
  const Result result = borders.Load(*tube);
  EXPECT_TRUE(Has(result, "paste", "open edges, the floor none")) << Describe(result);

  const auto holed = MakeSmallTube();
  const vtkMTGraph& graph = holed->GetGraph();
  vtkMTPatch& finest = holed->GetMutablePatches()[graph.Entering[graph.Nodes.back().FirstIn]];
  RemoveTriangle(finest, FindBorderTriangle(finest, 0));
  RefillRecords(*holed);
  const Result sound = borders.Load(*holed);
  EXPECT_TRUE(sound.IsValid()) << Describe(sound);
}

TEST(Validate, CutsNeedALoadedModel)
{
  const auto tube = MakeSmallTube();
  const vtkMTValidate::Borders borders;
  EXPECT_FALSE(borders.Cut(vtkMTCut(tube->GetGraph())).IsValid());
  EXPECT_EQ(borders.CountBorderEdges(vtkMTCut(tube->GetGraph())), 0u);
}

TEST(Validate, FindingsAreLimitedAndViolationsAreNot)
{
  Result result;
  for (int i = 0; i < 100; ++i)
  {
    result.Report("graph", std::to_string(i));
  }
  Result sum;
  sum.Report("cut", "first");
  sum.Append(result);
  EXPECT_EQ(sum.Violations, 101u);
  EXPECT_EQ(sum.Findings.size(), vtkMTValidate::MaximumFindings);
  EXPECT_EQ(sum.Findings.front().What, "first");
}
