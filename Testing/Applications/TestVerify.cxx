// SPDX-License-Identifier: BSD-3-Clause
// `bmt verify` must find what is wrong: each kind of fault is made here and must be seen, by the right check.
#include "MTRunBmt.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>

namespace
{
using GraphEdit = std::function<void(vtkMTGraph&)>;
using PatchEdit = std::function<void(std::uint32_t, vtkMTPatch&)>;

// Reads a model, lets graph and patches be changed, and writes it with good checksums.
void Rewrite(const std::string& from, const std::string& to, const GraphEdit& editGraph, const PatchEdit& editPatch)
{
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(from, error)) << error;
  vtkMTGraph graph = source.GetGraph();
  editGraph(graph);
  vtkMTFileSink sink(to);
  ASSERT_TRUE(sink.Begin(graph.Arrays)) << sink.GetError();
  std::vector<std::uint32_t> patchOfArc;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    ASSERT_TRUE(source.ReadPatch(arc, nullptr, patch, error)) << error;
    editPatch(arc, patch);
    ASSERT_TRUE(sink.WritePatch(std::move(patch))) << sink.GetError();
    patchOfArc.push_back(arc);
  }
  ASSERT_TRUE(sink.Finish(graph, patchOfArc)) << sink.GetError();
}

const GraphEdit SameGraph = [](vtkMTGraph&) {};
const PatchEdit SamePatch = [](std::uint32_t, vtkMTPatch&) {};

bool IsOk(const nlohmann::json& report, const std::string& check)
{
  for (const nlohmann::json& entry : report["checks"])
  {
    if (entry["name"] == check)
    {
      return entry["ok"];
    }
  }
  ADD_FAILURE() << "no check '" << check << "' in " << report.dump();
  return false;
}
}

// Values of measures, larger or smaller.
GraphEdit ScaleMeasures(double by)
{
  return [by](vtkMTGraph& graph)
  {
    for (vtkMTMeasure& measure : graph.Measures)
    {
      for (double& value : measure.Values)
      {
        value *= by;
      }
    }
  };
}

class Verify : public MTBmtTest
{
protected:
  // What verify says of a file; the exit code and "ok" must agree.
  nlohmann::json Report(const std::string& name, bool withInput, const char* cuts = "60") const
  {
    std::vector<std::string> call = { "verify", this->Path(name), "--cuts", cuts, "--samples", "20000", "--json" };
    if (withInput)
    {
      call.insert(call.end(), { "--input", this->Path("sphere.ply") });
    }
    const MTRun run = this->Bmt(call);
    nlohmann::json report = run.Json();
    EXPECT_EQ(run.Exit, report["ok"].get<bool>() ? 0 : 1) << run.Err;
    EXPECT_EQ(run.Err.empty(), report["ok"].get<bool>()) << run.Err;
    return report;
  }
};

TEST_F(Verify, AnglesThatAreTooSmallAreFound)
{
  this->MakeModel(5120, 100, { "--certify-normals" });
  Rewrite(this->Path("sphere.bmt"), this->Path("same.bmt"), ScaleMeasures(1.0), SamePatch);
  EXPECT_TRUE(IsOk(this->Report("same.bmt", true), "certified_normals"));
  Rewrite(this->Path("sphere.bmt"), this->Path("forged.bmt"), ScaleMeasures(0.1), SamePatch);
  EXPECT_FALSE(IsOk(this->Report("forged.bmt", true), "certified_normals"));
}

TEST_F(Verify, DeviationsOfValuesThatAreTooSmallAreFound)
{
  // Hills with a value at each point.
  constexpr int side = 60;
  std::ostringstream ply;
  ply << "ply\nformat ascii 1.0\nelement vertex " << (side + 1) * (side + 1)
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty float warmth\nelement face "
      << 2 * side * side << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int j = 0; j <= side; ++j)
  {
    for (int i = 0; i <= side; ++i)
    {
      ply << i << " " << j << " " << 3.0 * std::sin(0.3 * i) * std::cos(0.2 * j) << " " << std::sin(0.5 * i + 0.1 * j)
          << "\n";
    }
  }
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const int a = j * (side + 1) + i;
      ply << "3 " << a << " " << a + 1 << " " << a + side + 2 << "\n3 " << a << " " << a + side + 2 << " "
          << a + side + 1 << "\n";
    }
  }
  this->WriteFile("sphere.ply", ply.str());
  const auto build = [&](const std::string& array)
  {
    return this->Bmt({ "build", this->Path("sphere.ply"), "-o", this->Path("sphere.bmt"), "--certify-values", array,
      "--patch-triangles", "100" });
  };
  ASSERT_EQ(build("warmth").Exit, 0);
  EXPECT_TRUE(IsOk(this->Report("sphere.bmt", true, "4"), "certified_values"));
  Rewrite(this->Path("sphere.bmt"), this->Path("forged.bmt"), ScaleMeasures(0.1), SamePatch);
  EXPECT_FALSE(IsOk(this->Report("forged.bmt", true, "4"), "certified_values"));
  const MTRun unknown = build("wramth");
  EXPECT_NE(unknown.Exit, 0);
  EXPECT_NE(unknown.Err.find("no array \"wramth\""), std::string::npos) << unknown.Err;
}

TEST_F(Verify, AGoodModelPassesEveryCheck)
{
  this->MakeModel(20480);
  const nlohmann::json report = this->Report("sphere.bmt", true);
  std::cout << report.dump(1) << "\n";
  EXPECT_TRUE(report["ok"]);
  std::vector<std::string> names;
  for (const nlohmann::json& check : report["checks"])
  {
    names.push_back(check["name"]);
    const bool needsArrays = check["name"] == "input_arrays" || check["name"] == "labels"; // which this mesh has not
    EXPECT_EQ(check["tested"].get<std::uint64_t>() > 0, !needsArrays) << check.dump();
    EXPECT_EQ(check["violations"], 0) << check.dump();
    EXPECT_TRUE(check["worst"].is_number()) << check.dump();
  }
  EXPECT_EQ(names,
    (std::vector<std::string>{ "checksums", "graph", "patches", "nesting", "pasting", "conformity", "input_reading",
      "input_triangles", "input_bounds", "input_area", "input_volume", "input_orientation", "input_arrays", "labels",
      "certified_patch_to_input", "certified_input_to_cut" }));
  EXPECT_GE(report["spans"]["three_levels_or_more"].get<int>(), 30);
  for (const auto& [level, ratio] : report["certified_over_sampled"].items())
  {
    EXPECT_GE(ratio["median"].get<double>(), 1.0);
    EXPECT_LE(ratio["median"].get<double>(), ratio["worst"].get<double>()) << "level " << level;
  }
}

TEST_F(Verify, ItsReportIsTheSameForTheSameSeed)
{
  this->MakeModel(5120, 100);
  EXPECT_EQ(this->Report("sphere.bmt", true), this->Report("sphere.bmt", true));
}

TEST_F(Verify, ADamagedByteIsFoundWhereverItIs)
{
  this->MakeModel(5120, 100);
  const std::string good = this->ReadFile("sphere.bmt");
  int found = 0;
  for (int i = 0; i < 40; ++i)
  {
    std::string bad = good;
    // Header and end exactly, the rest at even distances; the byte before the last may be padding.
    const std::size_t at = i < 5 ? 8 + i : good.size() - 1 - static_cast<std::size_t>(i - 5) * (good.size() / 36);
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    this->WriteFile("bad.bmt", bad);
    const nlohmann::json report = this->Report("bad.bmt", false);
    EXPECT_FALSE(report["ok"].get<bool>()) << "byte " << at;
    found += report["ok"].get<bool>() ? 0 : 1;
  }
  std::cout << found << " of 40 damaged bytes found\n";
}

TEST_F(Verify, ErrorsThatAreTooSmallAreFound)
{
  this->MakeModel(20480);
  const auto halve = [](vtkMTGraph& graph)
  {
    for (vtkMTNode& node : graph.Nodes)
    {
      node.Error *= 0.3;
      node.OwnError *= 0.3;
    }
    for (vtkMTArc& arc : graph.Arcs)
    {
      arc.ToInput *= 0.29f;
      arc.FromInput *= 0.29f;
    }
  };
  Rewrite(this->Path("sphere.bmt"), this->Path("bad.bmt"), halve, SamePatch);
  EXPECT_TRUE(this->Report("bad.bmt", false)["ok"]) << "without the input nothing can be seen";
  const nlohmann::json report = this->Report("bad.bmt", true);
  EXPECT_TRUE(IsOk(report, "nesting"));
  EXPECT_FALSE(IsOk(report, "certified_patch_to_input"));
  EXPECT_FALSE(IsOk(report, "certified_input_to_cut"));
}

TEST_F(Verify, OnePointThatLeavesTheInputIsFound)
{
  this->MakeModel(20480);
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(this->Path("sphere.bmt"), error)) << error;
  const vtkMTGraph graph = source.GetGraph();
  int moved = 0;
  // A point of the finest level that no other patch shares, well inside its patch's box, moves by a thousandth of the
  // model.
  const auto move = [&moved, &graph](std::uint32_t arc, vtkMTPatch& patch)
  {
    constexpr std::int32_t shift = 1 << 13;
    const vtkMTBox box = patch.GetBox();
    const bool isFinest = graph.Arcs[arc].To == graph.GetSink();
    for (std::size_t i = patch.Ids.size(); isFinest && moved == 0 && i < patch.Points.size(); ++i)
    {
      vtkMTPoint& point = patch.Points[i];
      const bool isInside = point[1] > box[2] && point[1] < box[3] && point[2] > box[4] && point[2] < box[5];
      if (isInside && point[0] > box[0] && point[0] + shift < box[1])
      {
        point[0] += shift;
        ++moved;
      }
    }
  };
  Rewrite(this->Path("sphere.bmt"), this->Path("bad.bmt"), SameGraph, move);
  ASSERT_EQ(moved, 1);
  const nlohmann::json report = this->Report("bad.bmt", true);
  EXPECT_TRUE(IsOk(report, "patches"));
  EXPECT_TRUE(IsOk(report, "conformity"));
  EXPECT_FALSE(IsOk(report, "certified_patch_to_input"));
}

TEST_F(Verify, ATriangleThatIsMissingIsFound)
{
  this->MakeModel(20480);
  const auto drop = [](std::uint32_t arc, vtkMTPatch& patch)
  {
    if (arc == 1)
    {
      patch.Triangles.pop_back();
      for (vtkMTColumn& column : patch.CellColumns)
      {
        column.resize(column.size() / (patch.Triangles.size() + 1) * patch.Triangles.size());
      }
    }
  };
  const auto count = [](vtkMTGraph& graph) { --graph.Arcs[1].Triangles; };
  Rewrite(this->Path("sphere.bmt"), this->Path("bad.bmt"), count, drop);
  EXPECT_FALSE(this->Report("bad.bmt", false)["ok"].get<bool>());
}

TEST_F(Verify, ErrorsAndSpheresThatAreNotNestedAreFound)
{
  this->MakeModel(5120, 100);
  const auto raise = [](vtkMTGraph& graph) { graph.Nodes[graph.GetSink() - 1].Error = 10.0 * graph.Nodes[1].Error; };
  Rewrite(this->Path("sphere.bmt"), this->Path("bad.bmt"), raise, SamePatch);
  EXPECT_FALSE(this->Report("bad.bmt", false)["ok"].get<bool>());
  const auto shrink = [](vtkMTGraph& graph) { graph.Nodes[1].Radius *= 0.9; };
  Rewrite(this->Path("sphere.bmt"), this->Path("bad.bmt"), shrink, SamePatch);
  EXPECT_FALSE(this->Report("bad.bmt", false)["ok"].get<bool>());
}

TEST_F(Verify, AnotherMeshIsNotTakenForTheInput)
{
  this->MakeModel(5120, 100);
  this->BmtJson({ "generate", "fractal-sphere", "--triangles", "5120", "--seed", "9", "-o", this->Path("sphere.ply") });
  EXPECT_FALSE(this->Report("sphere.bmt", true)["ok"].get<bool>());
}
