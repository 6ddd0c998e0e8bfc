// SPDX-License-Identifier: BSD-3-Clause
// A file is opened by its first pages: the coarse part can be drawn and refined while the rest is read.
#include "MTFileSeal.h"
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTCut.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTRandomCut.h"

#include <atomic>
#include <limits>
#include <thread>

using namespace MTIOTest;

namespace
{
constexpr std::uint64_t Everything = std::numeric_limits<std::uint64_t>::max();

// Counts what is read.
class CountingSource : public vtkMTByteSource
{
public:
  explicit CountingSource(Bytes bytes)
    : Inner(std::move(bytes))
  {
  }
  std::uint64_t GetSize() const override { return this->Inner.GetSize(); }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override
  {
    this->Count += count;
    ++this->Reads;
    return this->Inner.Read(offset, count, destination, error);
  }
  std::string GetName() const override { return "counting"; }
  mutable std::atomic<std::uint64_t> Count{ 0 };
  mutable std::atomic<std::uint64_t> Reads{ 0 };

private:
  vtkMTMemoryByteSource Inner;
};

// A model whose graph has some twenty pages, and its file.
struct LargeModel
{
  std::shared_ptr<vtkMTPatchStore> Store;
  Bytes File;

  static const LargeModel& Get()
  {
    static const LargeModel model = Make();
    return model;
  }

private:
  static LargeModel Make()
  {
    LargeModel model;
    MTTestModel::TubeOptions options;
    options.Rings = 8192;
    options.Across = 3;
    options.Regions = 2048;
    model.Store = MTTestModel::MakeTube(options);
    vtkMTGraph& graph = model.Store->GetMutableGraph();
    graph.Measures = { { "one", std::vector<double>(graph.Nodes.size(), 1.0) } };
    graph.ArcRanges.Columns = { { 0, 0 }, { 1, 1 } };
    model.File = StoreModel(*model.Store);
    return model;
  }
};

// All that is known is as in the whole graph, and closed.
void ExpectKnownPart(const vtkMTGraph& whole, const vtkMTGraph& graph)
{
  const std::uint32_t nodes = graph.GetNumberOfKnownNodes();
  const std::uint32_t arcs = graph.GetNumberOfKnownArcs();
  ASSERT_LE(nodes, whole.Nodes.size());
  ASSERT_LE(arcs, whole.Arcs.size());
  bool same = true;
  for (std::uint32_t node = 0; node < nodes; ++node)
  {
    same = same && AreEqual(whole.Nodes[node], graph.Nodes[node]);
    for (const std::uint32_t arc : graph.GetEntering(node))
    {
      same = same && arc < arcs && graph.Arcs[arc].To == node;
    }
  }
  for (std::uint32_t arc = 0; arc < arcs; ++arc)
  {
    same = same && AreEqual(whole.Arcs[arc], graph.Arcs[arc]) &&
      AreEqual(whole.Nodes[graph.Arcs[arc].To], graph.Nodes[graph.Arcs[arc].To]);
  }
  EXPECT_TRUE(same) << nodes << " nodes, " << arcs << " arcs known";
}
}

TEST(FirstPages, CoarsestCutNeedsFewBytes)
{
  const LargeModel& model = LargeModel::Get();
  const std::uint64_t sections = MTFileSeal::GetSectionOffset(model.File.data());
  const auto bytes = std::make_shared<CountingSource>(model.File);
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.OpenFirstPages(bytes, error)) << error;
  const std::uint64_t opened = bytes->Count;
  EXPECT_FALSE(source.GetKnownGraph().IsWhole());
  const vtkMTCut cut(source.GetKnownGraph());
  vtkMTPatch patch;
  for (const std::uint32_t arc : cut.GetArcs())
  {
    ASSERT_TRUE(source.ReadPatch(arc, nullptr, patch, error)) << error;
  }
  std::cout << "graph of " << sections << " bytes: " << opened << " read when opened, " << bytes->Reads
            << " reads until the coarsest cut is decoded\n";
  EXPECT_EQ(opened, source.GetGraphBytesRead());
  EXPECT_LT(opened, 600000u);
  EXPECT_LT(opened, sections / 2);
  EXPECT_GT(sections, 1200000u);
  // What is not known is no patch.
  const auto unknown = static_cast<std::uint32_t>(source.GetKnownGraph().Arcs.size()) - 1;
  EXPECT_FALSE(source.ReadPatch(unknown, nullptr, patch, error));
  EXPECT_NE(error.find("not known yet"), std::string::npos);
  EXPECT_EQ(source.GetPatchSize(unknown), 0u);
}

TEST(FirstPages, FiguresOfTheWholeModelAreThereAtOnce)
{
  const LargeModel& model = LargeModel::Get();
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(Bytes(model.File)), error)) << error;
  const vtkMTGraph& graph = source.GetKnownGraph();
  const vtkMTGraph& whole = model.Store->GetGraph();
  ASSERT_FALSE(graph.IsWhole());
  EXPECT_EQ(graph.Nodes.size(), whole.Nodes.size());
  EXPECT_EQ(graph.Arcs.size(), whole.Arcs.size());
  EXPECT_EQ(graph.GetNumberOfLevels(), whole.GetNumberOfLevels());
  EXPECT_EQ(graph.GetNumberOfFinestTriangles(), whole.GetNumberOfFinestTriangles());
  EXPECT_EQ(graph.GetNumberOfRootTriangles(), whole.GetNumberOfRootTriangles());
  EXPECT_EQ(graph.ArrayRanges, whole.ArrayRanges);
  double bounds[2][6];
  graph.GetBounds(bounds[0]);
  whole.GetBounds(bounds[1]);
  EXPECT_TRUE(std::equal(bounds[0], bounds[0] + 6, bounds[1]));
  EXPECT_FALSE(graph.IsWhole()) << "none of this should have read on";
}

TEST(FirstPages, ReadOnPageByPageTheKnownPartIsSoundAtAnyTime)
{
  const LargeModel& model = LargeModel::Get();
  const auto bytes = std::make_shared<CountingSource>(model.File);
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.OpenFirstPages(bytes, error)) << error;
  const vtkMTGraph& graph = source.GetKnownGraph();
  const vtkMTGraph& whole = model.Store->GetGraph();
  int steps = 0;
  for (std::uint32_t known = 0; !graph.IsWhole(); ++steps)
  {
    EXPECT_GE(graph.GetNumberOfKnownNodes(), known);
    known = graph.GetNumberOfKnownNodes();
    ExpectKnownPart(whole, graph);
    // The cut that refines all that can be refined is one of the whole graph.
    vtkMTCut cut(graph);
    vtkMTCut same(whole);
    for (std::uint32_t node = 0; node < graph.Nodes.size(); ++node)
    {
      const std::size_t refined = cut.RefineWithDependencies(node);
      EXPECT_EQ(refined > 0, node > 0 && node < known);
      if (node < known)
      {
        same.RefineWithDependencies(node);
      }
    }
    EXPECT_EQ(cut.GetArcs(), same.GetArcs());
    ASSERT_TRUE(source.ReadOn(1, error)) << error;
  }
  ExpectEqual(whole, source.GetGraph());
  EXPECT_EQ(source.GetGraph().Measures[0].Values, whole.Measures[0].Values);
  const std::uint64_t sections = MTFileSeal::GetSectionOffset(model.File.data());
  std::cout << steps << " steps, " << bytes->Count << " bytes read in " << bytes->Reads << " reads, of " << sections
            << "\n";
  EXPECT_GT(steps, 10);
  EXPECT_LT(bytes->Count, sections + 200000) << "pages are read twice";
}

TEST(FirstPages, WholeGraphIsReadWhenSomebodyAsksForIt)
{
  const LargeModel& model = LargeModel::Get();
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(Bytes(model.File)), error)) << error;
  ASSERT_FALSE(source.GetKnownGraph().IsWhole());
  ExpectStored(*model.Store, source);
  EXPECT_TRUE(source.GetKnownGraph().IsWhole());
  EXPECT_TRUE(source.ReadOn(Everything, error));
}

TEST(FirstPages, ThreadReadsOnWhileOthersRefineAndRead)
{
  const LargeModel& model = LargeModel::Get();
  const vtkMTGraph& whole = model.Store->GetGraph();
  for (int run = 0; run < 5; ++run)
  {
    vtkMTFileSource source;
    std::string error;
    ASSERT_TRUE(source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(Bytes(model.File)), error)) << error;
    source.StartReadingOn();
    std::atomic<int> wrong{ 0 };
    const auto look = [&]
    {
      const vtkMTGraph& graph = source.GetKnownGraph();
      bool last = false;
      for (std::uint32_t before = 0; !last;)
      {
        last = graph.IsWhole();
        const std::uint32_t known = graph.GetNumberOfKnownNodes();
        vtkMTCut cut(graph);
        for (std::uint32_t node = before; node < known; ++node)
        {
          cut.RefineWithDependencies(node);
        }
        const std::vector<std::uint32_t> arcs = cut.GetArcs();
        wrong += !std::all_of(arcs.begin(), arcs.end(),
          [&](std::uint32_t arc)
          {
            const vtkMTArc& record = graph.Arcs[arc];
            return AreEqual(record, whole.Arcs[arc]) && AreEqual(graph.Nodes[record.To], whole.Nodes[record.To]);
          });
        vtkMTPatch patch;
        std::string message;
        wrong += !source.ReadPatch(arcs.back(), nullptr, patch, message);
        before = known > 0 ? known - 1 : 0;
      }
    };
    std::thread other(look);
    look();
    other.join();
    EXPECT_EQ(wrong, 0);
    ExpectEqual(whole, source.GetGraph());
  }
}

TEST(FirstPages, SourceCanBeClosedWhileItReadsOn)
{
  const LargeModel& model = LargeModel::Get();
  for (int run = 0; run < 20; ++run)
  {
    vtkMTFileSource source;
    std::string error;
    ASSERT_TRUE(source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(Bytes(model.File)), error)) << error;
    source.StartReadingOn();
    if (run % 2)
    {
      ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(model.File)), error)) << error;
    }
  }
}

// The author of the damage has not made checksums right: what was known stays, the rest never comes.
TEST(FirstPages, DamagedPageEndsWhatIsKnownAndNothingElse)
{
  const LargeModel& model = LargeModel::Get();
  const vtkMTGraph& whole = model.Store->GetGraph();
  const std::uint64_t sections = MTFileSeal::GetSectionOffset(model.File.data());
  MTTestMeshes::Random random(5);
  int opened = 0;
  for (int run = 0; run < 60; ++run)
  {
    Bytes bytes = model.File;
    bytes[300 + random.Below(sections - 300)] ^= 1;
    vtkMTFileSource source;
    std::string error;
    EXPECT_FALSE(vtkMTFileSource().Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error));
    if (!source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), error))
    {
      continue;
    }
    ++opened;
    EXPECT_FALSE(source.ReadOn(Everything, error));
    EXPECT_NE(error.find("damaged"), std::string::npos) << error;
    EXPECT_FALSE(source.GetGraph().IsWhole());
    ExpectKnownPart(whole, source.GetGraph());
    std::string again;
    EXPECT_FALSE(source.ReadOn(1, again));
    EXPECT_EQ(error, again);
    vtkMTPatch patch;
    EXPECT_TRUE(source.ReadPatch(source.GetGraph().GetNumberOfKnownArcs() - 1, nullptr, patch, error)) << error;
  }
  std::cout << opened << " of 60 could be opened\n";
  EXPECT_GT(opened, 10);
}

TEST(FirstPages, ModelOfOnePageIsWholeAtOnce)
{
  const auto model = MTTestModel::MakeTube();
  const auto bytes = std::make_shared<CountingSource>(StoreModel(*model));
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.OpenFirstPages(bytes, error)) << error;
  EXPECT_TRUE(source.GetKnownGraph().IsWhole() || source.ReadOn(1, error));
  EXPECT_LE(bytes->Reads, 2u);
}
