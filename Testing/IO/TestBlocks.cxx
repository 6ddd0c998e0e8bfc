// SPDX-License-Identifier: BSD-3-Clause
// What later systems add to a file is skipped where it may be, and refused where it must; what the graph holds beside
// triangles comes back.
#include "MTFileSeal.h"
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTCut.h"
#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTValidate.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace MTIOTest;

namespace
{
std::string Write(const vtkMTPatchSource& model, const vtkMTGraph& graph, Bytes& bytes)
{
  Folder folder;
  vtkMTFileSink sink(folder / "model.bmt");
  bool done = sink.Begin(graph.Arrays);
  std::vector<std::uint32_t> order;
  for (std::uint32_t arc = 0; done && arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    done = model.ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    order.push_back(arc);
  }
  if (done && sink.Finish(graph, order))
  {
    bytes = ReadFile(folder / "model.bmt");
  }
  return sink.GetError();
}

std::shared_ptr<vtkMTPatchStore> MakeModel()
{
  MTTestModel::TubeOptions options;
  options.Rings = 32;
  options.Across = 4;
  options.Regions = 4;
  return MTTestModel::MakeTube(options);
}

Bytes MakeFile(const vtkMTPatchSource& model)
{
  Bytes bytes;
  EXPECT_EQ(Write(model, model.GetGraph(), bytes), "");
  return bytes;
}

std::string OpenAndRead(const Bytes& bytes)
{
  vtkMTFileSource source;
  std::string error;
  if (!source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error))
  {
    return error;
  }
  for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      return error;
    }
  }
  return "";
}

// A seventh block, of no bytes, in the room that the header has.
Bytes AddBlock(Bytes bytes, std::uint32_t type, std::uint32_t flags)
{
  const std::size_t entry = 64 + 24 * std::size_t(MTFileSeal::Get<std::uint32_t>(bytes.data(), 52));
  EXPECT_LE(entry + 24, 248u);
  MTFileSeal::Put<std::uint32_t>(bytes.data(), 52, 7);
  MTFileSeal::Put<std::uint32_t>(bytes.data(), entry, type);
  MTFileSeal::Put<std::uint32_t>(bytes.data(), entry + 4, flags);
  MTFileSeal::Put<std::uint64_t>(bytes.data(), entry + 8, MTFileSeal::GetSectionOffset(bytes.data()));
  MTFileSeal::SealPages(bytes.data(), bytes.size());
  return bytes;
}
}

TEST(Blocks, UnknownBlockIsSkippedUnlessItMustBeKnown)
{
  const Bytes good = MakeFile(*MakeModel());
  EXPECT_EQ(OpenAndRead(AddBlock(good, 77, 0)), "");
  const std::string message = OpenAndRead(AddBlock(good, 77, 1));
  EXPECT_NE(message.find("block of type 77"), std::string::npos) << message;
  std::cout << message << "\n";
  EXPECT_NE(OpenAndRead(AddBlock(good, 77, 2)), "") << "a flag without meaning";
  EXPECT_NE(OpenAndRead(AddBlock(good, MTFileSeal::Nodes, 0)), "") << "two blocks of nodes";
}

// The last section of the last arc is called another class; it is an array then that the patch does not have.
TEST(Blocks, UnknownClassOfSectionIsSkippedUnlessItMustBeKnown)
{
  const auto model = MakeModel();
  const Bytes good = MakeFile(*model);
  const auto table = MTFileSeal::GetBlock(good.data(), good.size(), MTFileSeal::Sections);
  const auto set = [&](unsigned char flags, std::uint16_t number)
  {
    Bytes bytes = good;
    bytes[table.Offset + table.Size - 3] = flags;
    MTFileSeal::Put<std::uint16_t>(bytes.data(), table.Offset + table.Size - 2, number);
    MTFileSeal::SealPages(bytes.data(), bytes.size());
    return bytes;
  };
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(set(0, 0x9000)), error)) << error;
  const auto last = static_cast<std::uint32_t>(source.GetGraph().Arcs.size()) - 1;
  std::vector<unsigned char> wanted(source.GetGraph().Arrays.size(), 1);
  vtkMTPatch patch;
  EXPECT_FALSE(source.ReadPatch(last, &wanted, patch, error));
  EXPECT_NE(error.find("no section for the array"), std::string::npos) << error;
  wanted.back() = 0;
  EXPECT_TRUE(source.ReadPatch(last, &wanted, patch, error)) << error;
  EXPECT_FALSE(patch.Triangles.empty());
  const std::string message = OpenAndRead(set(1, 0x9000));
  EXPECT_NE(message.find("section of class 36864"), std::string::npos) << message;
  EXPECT_NE(OpenAndRead(set(0, 1)), "") << "a class twice";
  EXPECT_NE(OpenAndRead(set(0, 4)), "") << "an array that there is not";
}

TEST(Blocks, ArcWithoutSectionsIsADependency)
{
  const auto model = MakeModel();
  vtkMTGraph& graph = model->GetMutableGraph();
  // A coarse node gets an arc to a finer one to which there is none.
  vtkMTArc arc;
  arc.From = 1;
  arc.To = graph.GetSink() - 1;
  graph.Arcs.push_back(arc);
  model->GetMutablePatches().emplace_back();
  model->GetMutablePatches().back().PointColumns.resize(2);
  model->GetMutablePatches().back().CellColumns.resize(1);
  const std::vector<std::uint32_t> order = graph.Index();
  std::vector<vtkMTPatch> patches;
  for (const std::uint32_t patch : order)
  {
    patches.push_back(model->GetMutablePatches()[patch]);
  }
  model->GetMutablePatches() = patches;
  graph.Saturate(graph.Lattice.MaximumShift);
  EXPECT_TRUE(vtkMTValidate::Graph(graph).IsValid());
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(MakeFile(*model)), error)) << error;
  ExpectStored(*model, source);
  std::size_t dependencies = 0;
  for (std::uint32_t i = 0; i < source.GetGraph().Arcs.size(); ++i)
  {
    dependencies += source.GetGraph().Arcs[i].IsDependency();
    EXPECT_EQ(source.GetGraph().Arcs[i].IsDependency(), source.GetPatchSize(i) == 0);
  }
  EXPECT_EQ(dependencies, 1u);
  vtkMTCut cut(source.GetGraph());
  cut.RefineWithDependencies(source.GetGraph().GetSink() - 1);
  EXPECT_TRUE(cut.IsRefined(1));
}

TEST(Blocks, KindsWithoutCodecAreRefusedWithTheirName)
{
  const auto model = MakeModel();
  vtkMTFileSink sink("/tmp/never.bmt");
  for (const auto& [kind, name] : { std::make_pair(vtkMTPatchKind::Points, "points"),
         std::make_pair(vtkMTPatchKind::Voxels, "voxels"), std::make_pair(vtkMTPatchKind::Grid, "grid") })
  {
    vtkMTPatch patch;
    std::string error;
    ASSERT_TRUE(model->ReadPatch(0, nullptr, patch, error));
    patch.Kind = kind;
    EXPECT_EQ(sink.Prepare(std::move(patch), error), nullptr);
    EXPECT_NE(error.find(name), std::string::npos) << error;
  }
  Bytes bytes = MakeFile(*model);
  const auto arcs = MTFileSeal::GetBlock(bytes.data(), bytes.size(), MTFileSeal::Arcs);
  bytes[arcs.Offset + 68] = 2;
  MTFileSeal::SealPages(bytes.data(), bytes.size());
  EXPECT_NE(OpenAndRead(bytes).find("voxels"), std::string::npos);
  bytes[arcs.Offset + 68] = 4;
  MTFileSeal::SealPages(bytes.data(), bytes.size());
  EXPECT_NE(OpenAndRead(bytes).find("kind 4"), std::string::npos);
}

TEST(Blocks, RangesAreThoseOfTheFinestLevelAndOfEverythingBelow)
{
  const auto model = MakeModel();
  vtkMTGraph graph = model->GetGraph();
  // NaN and infinity in the first array of a finest patch.
  vtkMTColumn& heights = model->GetMutablePatches()[graph.Entering[graph.Nodes.back().FirstIn]].PointColumns[0];
  const float values[2] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() };
  std::memcpy(heights.data(), values, sizeof(values));
  graph.ArcRanges.Columns = { { 2, 0 }, { 0, 0 } };
  Bytes bytes;
  ASSERT_EQ(Write(*model, graph, bytes), "");
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), error)) << error;
  const vtkMTGraph& read = source.GetGraph();
  EXPECT_TRUE(vtkMTValidate::Graph(read).IsValid());

  std::vector<std::vector<vtkMTRange>> expected = { { {} }, { {}, {} }, { {} } };
  std::vector<std::vector<vtkMTRange>> own(read.Arcs.size());
  for (std::uint32_t arc = 0; arc < read.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    ASSERT_TRUE(source.ReadPatch(arc, nullptr, patch, error)) << error;
    own[arc] = patch.GetRanges(read.Arrays);
    for (std::size_t i = 0, next = 0; read.Arcs[arc].To == read.GetSink() && i < expected.size(); ++i)
    {
      for (vtkMTRange& range : expected[i])
      {
        range.Add(own[arc][next++]);
      }
    }
  }
  EXPECT_EQ(read.ArrayRanges, expected);
  EXPECT_EQ(read.ArrayRanges[0][0].Maximum, std::numeric_limits<double>::infinity());
  EXPECT_EQ(read.ArrayRanges[2][0].Minimum, 0.0);
  EXPECT_EQ(read.ArrayRanges[2][0].Maximum, static_cast<double>(read.GetNumberOfFinestTriangles() - 1));
  // Of the arcs: nothing but what is below, and all of it. The source's arcs stand for the whole model.
  ASSERT_EQ(read.ArcRanges.Values.size(), 2 * read.Arcs.size());
  vtkMTRange all;
  for (std::uint32_t arc = 0; arc < read.Nodes[0].OutCount; ++arc)
  {
    all.Add(read.ArcRanges.Values[2 * arc]);
  }
  EXPECT_TRUE(all == read.ArrayRanges[2][0]);
  for (const std::uint32_t arc : read.GetEntering(read.GetSink()))
  {
    EXPECT_TRUE(read.ArcRanges.Values[2 * arc] == own[arc][3]);
    EXPECT_TRUE(read.ArcRanges.Values[2 * arc + 1] == own[arc][0]);
  }
}

TEST(Blocks, DistancesOfPatchesComeBackOrAreThoseOfTheNodes)
{
  const auto model = MakeModel();
  const auto read = [](const Bytes& bytes, vtkMTFileSource& source)
  {
    std::string error;
    source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error);
    return error;
  };
  vtkMTFileSource without;
  ASSERT_EQ(read(MakeFile(*model), without), "");
  EXPECT_FALSE(without.GetGraph().HasArcDistances());
  vtkMTGraph& graph = model->GetMutableGraph();
  const double shift = graph.Lattice.MaximumShift;
  for (std::uint32_t i = 0; i < graph.Arcs.size(); ++i)
  {
    EXPECT_EQ(without.GetGraph().GetDistanceToInput(i), graph.Nodes[graph.Arcs[i].To].Error);
    graph.Arcs[i].ToInput = 0.25f * static_cast<float>(i % 3);
    graph.Arcs[i].FromInput = 1e30f; // more than the node's
  }
  const Bytes good = MakeFile(*model);
  vtkMTFileSource with;
  ASSERT_EQ(read(good, with), "");
  EXPECT_TRUE(with.GetGraph().HasArcDistances());
  for (std::uint32_t i = 0; i < graph.Arcs.size(); ++i)
  {
    const double error = graph.Nodes[graph.Arcs[i].To].Error;
    EXPECT_NEAR(
      with.GetGraph().GetDistanceToInput(i), std::min(error, 0.25 * (i % 3) * graph.Lattice.Step + shift), 1e-12);
    EXPECT_EQ(with.GetGraph().GetDistanceFromInput(i), error);
  }
  const auto block = MTFileSeal::GetBlock(good.data(), good.size(), MTFileSeal::Distances);
  ASSERT_EQ(block.Size, 8 * graph.Arcs.size());
  for (const float impossible : { -1.0f, std::nanf(""), std::numeric_limits<float>::infinity() })
  {
    Bytes bytes = good;
    MTFileSeal::Put<float>(bytes.data(), block.Offset + block.Size - 4, impossible);
    MTFileSeal::SealPages(bytes.data(), bytes.size());
    EXPECT_NE(OpenAndRead(bytes).find("impossible distance"), std::string::npos);
  }
}

TEST(Blocks, ColumnsThatDoNotFitTheGraphAreRefused)
{
  const auto model = MakeModel();
  Bytes bytes;
  vtkMTGraph graph = model->GetGraph();
  graph.Measures = { { "short", { 1.0 } } };
  EXPECT_NE(Write(*model, graph, bytes).find("\"short\""), std::string::npos);
  graph.Measures = { { "nan", std::vector<double>(graph.Nodes.size(), std::nan("")) } };
  EXPECT_NE(Write(*model, graph, bytes), "");
  graph.Measures.clear();
  graph.ArcRanges.Columns = { { 3, 0 } };
  EXPECT_NE(Write(*model, graph, bytes), "");
  graph.ArcRanges.Columns.clear();
  graph.Frame.emplace().fill(std::nan(""));
  EXPECT_NE(Write(*model, graph, bytes), "");
  EXPECT_TRUE(bytes.empty());
}

TEST(Blocks, FiguresThatAreNotThoseOfTheArcsAreRefused)
{
  const Bytes good = MakeFile(*MakeModel());
  const auto metadata = MTFileSeal::GetBlock(good.data(), good.size(), MTFileSeal::Metadata);
  for (const std::size_t place : { 72, 80, 104 })
  {
    Bytes bytes = good;
    bytes[metadata.Offset + place] ^= 1;
    MTFileSeal::SealPages(bytes.data(), bytes.size());
    EXPECT_NE(OpenAndRead(bytes).find("figures"), std::string::npos) << place;
  }
}
