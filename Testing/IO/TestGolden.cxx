// SPDX-License-Identifier: BSD-3-Clause
// A file of each version that is to be read for good lies in Testing/Data. It was written once from a model made by
// hand, and holds every table of the format: arrays of points and cells, measures, ranges, a frame, a blob,
// dependencies. With MT_WRITE_GOLDEN the test writes the present version's file there, for a version that is new.
#include "MTIOTest.h"
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"

using namespace MTIOTest;

namespace
{
constexpr char Path[] = MT_SOURCE_DIRECTORY "/Testing/Data/golden-6.bmt";

const Bytes& GetBlob()
{
  static const Bytes blob{ 'a', ' ', 'b', 'l', 'o', 'b' };
  return blob;
}

std::shared_ptr<vtkMTPatchStore> MakeModel()
{
  MTTestModel::TubeOptions options;
  options.Rings = 32;
  options.Across = 4;
  options.Regions = 4;
  std::shared_ptr<vtkMTPatchStore> model = MTTestModel::MakeTube(options);
  vtkMTGraph& graph = model->GetMutableGraph();
  std::vector<double> values(graph.Nodes.size());
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    values[node] = static_cast<double>(values.size() - node);
  }
  graph.Measures = { { "deviation", values } };
  graph.ArcRanges.Columns = { { 0, 0 } };
  graph.Frame = { 2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3, 0, 0, 0, 1 };
  graph.Crs = "EPSG:2056";
  graph.Units = "m";
  graph.InputCounts = { 1, 2, 3, 4 };
  graph.Settings = { { "partition", "by hand" } };
  graph.InputReport = { { "dropped", 5 } };
  graph.Blobs = { { "blob.txt", "text/plain", { { "for", "this test" } } } };
  return model;
}

Bytes Write(const vtkMTPatchStore& model)
{
  const Folder folder;
  vtkMTFileSink sink(folder / "model.bmt");
  const vtkMTGraph& graph = model.GetGraph();
  std::string error;
  bool done = sink.Begin(graph.Arrays);
  std::vector<std::uint32_t> order;
  for (std::uint32_t arc = 0; done && arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    done = model.ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    order.push_back(arc);
  }
  done = done && sink.WriteBlob(Bytes(GetBlob())) && sink.Finish(graph, order);
  EXPECT_TRUE(done) << error << sink.GetError();
  return ReadFile(folder / "model.bmt");
}
}

TEST(Golden, FileOfVersion6IsReadAsItWasWritten)
{
  const std::shared_ptr<vtkMTPatchStore> model = MakeModel();
  if (std::getenv("MT_WRITE_GOLDEN"))
  {
    WriteFile(Path, Write(*model));
  }
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(Path, error)) << error;
  std::cout << source.GetFileSize() << " bytes\n";
  ExpectStored(*model, source);
  const vtkMTGraph& graph = source.GetGraph();
  EXPECT_EQ(graph.Measures[0].Values, model->GetGraph().Measures[0].Values);
  EXPECT_EQ(graph.Frame, model->GetGraph().Frame);
  EXPECT_EQ(graph.Crs, "EPSG:2056");
  EXPECT_EQ(graph.Units, "m");
  EXPECT_EQ(graph.InputCounts.Cells, 4u);
  EXPECT_EQ(graph.ArcRanges.Values.size(), graph.Arcs.size());
  Bytes blob;
  ASSERT_TRUE(source.ReadBlob(0, blob, error)) << error;
  EXPECT_EQ(blob, GetBlob());
}

TEST(Golden, WhatIsWrittenTodayIsThatFile)
{
  EXPECT_EQ(Write(*MakeModel()), ReadFile(Path)) << "the format has changed: it needs another version";
}

// Programs before vtkMTNormalCodec wrote the normals of golden-6-normals.bmt (bmt generate fractal-sphere --triangles
// 1280; bmt build --patch-triangles 64 --no-ids). The sum is that of what the reader of that time in Python found.
TEST(Golden, NormalsOfEarlierProgramsAreReadAsTheyWere)
{
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(MT_SOURCE_DIRECTORY "/Testing/Data/golden-6-normals.bmt", error)) << error;
  const vtkMTGraph& graph = source.GetGraph();
  ASSERT_EQ(graph.Arrays.size(), 1u);
  ASSERT_EQ(graph.Arrays[0].Role, vtkMTArrayInfo::MadeNormals);
  std::uint64_t hash = 14695981039346656037u;
  std::size_t bytes = 0;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    ASSERT_TRUE(source.ReadPatch(arc, nullptr, patch, error)) << error;
    for (const unsigned char byte : patch.PointColumns[0])
    {
      hash = (hash ^ byte) * 1099511628211u;
    }
    bytes += patch.PointColumns[0].size();
  }
  EXPECT_EQ(bytes, 1643u * 12);
  EXPECT_EQ(hash, 17135149133926624499u);
}
