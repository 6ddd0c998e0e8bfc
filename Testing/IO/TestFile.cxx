// SPDX-License-Identifier: BSD-3-Clause
// The Multi-Triangulation file: what is written is read, byte for byte, and nothing else is ever taken for it.
#include "MTFileSeal.h"
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTPatchOrder.h"

#include <atomic>
#include <csignal>
#include <cstring>
#include <numeric>
#include <thread>

#include <sys/resource.h>

using namespace MTIOTest;

namespace
{
std::shared_ptr<vtkMTPatchStore> MakeSmallModel()
{
  MTTestModel::TubeOptions options;
  options.Rings = 16;
  options.Across = 4;
  options.Regions = 2;
  return MTTestModel::MakeTube(options);
}

// All that a graph can hold, with bytes that are no UTF-8 and empty strings.
void FillMetadata(vtkMTGraph& graph)
{
  graph.InputCounts.Triangles = 12345678901ull;
  graph.FullySharedBorders = 3;
  graph.Settings = { { "partition", "v" }, { "", "empty key" },
    { "latin-1",
      "Terraind\xfc"
      "k" } };
  graph.InputReport = { { "degenerate", -1 }, { "lines", std::int64_t(1) << 40 } };
  graph.Blocked = { { "link", 7 } };
}

bool WriteModel(const vtkMTPatchSource& model, const std::string& path, std::string& error,
  vtkMTFileSink::CompressionType compression = vtkMTFileSink::Fast)
{
  vtkMTFileSink sink(path, compression);
  const vtkMTGraph& graph = model.GetGraph();
  bool ok = sink.Begin(graph.Arrays);
  // Finest first, as the builder does.
  std::vector<std::uint32_t> patchOfArc(graph.Arcs.size());
  for (std::uint32_t i = static_cast<std::uint32_t>(graph.Arcs.size()); ok && i-- > 0;)
  {
    vtkMTPatch patch;
    ok = model.ReadPatch(i, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    patchOfArc[i] = static_cast<std::uint32_t>(graph.Arcs.size()) - 1 - i;
  }
  ok = ok && sink.Finish(graph, patchOfArc);
  error = sink.GetError();
  return ok;
}

constexpr vtkMTFileSink::CompressionType Compressions[] = { vtkMTFileSink::None, vtkMTFileSink::Fast,
  vtkMTFileSink::Small };

Bytes MakeFile(const vtkMTPatchSource& model, vtkMTFileSink::CompressionType compression = vtkMTFileSink::Fast)
{
  Folder folder;
  std::string error;
  EXPECT_TRUE(WriteModel(model, folder / "model.bmt", error, compression)) << error;
  return ReadFile(folder / "model.bmt");
}

// Opens and reads everything; the error, or nothing when all of it could be read.
std::string ReadAll(Bytes bytes)
{
  vtkMTFileSource source;
  std::string error;
  if (!source.Open(std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), error))
  {
    return error.empty() ? "refused without a reason" : error;
  }
  for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      EXPECT_TRUE(patch.Points.empty() && patch.Triangles.empty());
      return error.empty() ? "refused without a reason" : error;
    }
  }
  return "";
}

std::uint64_t SectionOffset(const Bytes& bytes)
{
  return MTFileSeal::GetSectionOffset(bytes.data());
}

// An entry of the table of sections.
struct SectionOnDisk
{
  std::uint64_t Checksum;
  std::uint32_t StoredSize;
  std::uint8_t Codec;
  std::uint8_t Flags;
  std::uint16_t Class;

  SectionOnDisk(const Bytes& bytes, std::size_t i)
  {
    std::memcpy(this, bytes.data() + GetPlace(bytes, i), sizeof(*this));
  }
  void Put(Bytes& bytes, std::size_t i) const { std::memcpy(bytes.data() + GetPlace(bytes, i), this, sizeof(*this)); }
  std::size_t GetPaddedSize() const { return (std::size_t(this->StoredSize) + 15) / 16 * 16; }
  static std::size_t GetPlace(const Bytes& bytes, std::size_t i)
  {
    const auto table = MTFileSeal::GetBlock(bytes.data(), bytes.size(), MTFileSeal::Sections);
    return static_cast<std::size_t>(table.Offset) + i * sizeof(SectionOnDisk);
  }
};

// Makes the checksums of header and pages right again.
void Reseal(Bytes& bytes)
{
  MTFileSeal::SealPages(bytes.data(), bytes.size());
}

// A patch whose points span `extent` steps, with ids from firstId on.
vtkMTPatch MakePatch(
  std::int32_t corner, std::uint32_t extent, std::uint64_t firstId, std::uint64_t lastId, std::uint32_t points)
{
  vtkMTPatch patch;
  for (std::uint32_t i = 0; i < points; ++i)
  {
    const std::int32_t x = static_cast<std::int32_t>(corner + std::int64_t(extent) * i / (points - 1));
    patch.Points.push_back({ x, corner, x });
    patch.Triangles.push_back({ i, (i + 1) % points, (i + 2) % points });
  }
  patch.Ids = { lastId, firstId };
  return patch;
}

// A graph of one arc for that patch.
vtkMTGraph MakeGraph(const vtkMTPatch& patch)
{
  vtkMTGraph graph;
  graph.Nodes.resize(2);
  graph.Arcs.resize(1);
  graph.Arcs[0].To = 1;
  MTTestModel::FillRecord(patch, graph.Lattice, graph.Arcs[0]);
  graph.Index();
  return graph;
}
}

//------------------------------------------------------------------------------
TEST(File, ModelIsReadBackByteForByte)
{
  Folder folder;
  const auto model = MTTestModel::MakeTube();
  FillMetadata(model->GetMutableGraph());
  std::string error;
  ASSERT_TRUE(WriteModel(*model, folder / "model.bmt", error)) << error;
  vtkMTFileSource source;
  ASSERT_TRUE(source.Open(folder / "model.bmt", error)) << error;
  ExpectStored(*model, source);
  std::uint64_t patchBytes = 0;
  for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
  {
    patchBytes += source.GetPatchSize(arc);
  }
  EXPECT_EQ(source.GetFileSize(), SectionOffset(ReadFile(folder / "model.bmt")) + patchBytes);
  std::cout << source.GetGraph().Arcs.size() << " patches, " << source.GetFileSize() << " bytes, of which "
            << patchBytes << " in patches\n";
}

TEST(File, EveryWidthIsReadBack)
{
  const std::uint64_t large = ~std::uint64_t(0);
  const std::vector<vtkMTPatch> patches = { MakePatch(-7, 255, 0, 255, 3), MakePatch(-7, 256, 0, 256, 256),
    MakePatch(-2147483647, 65535, 65536, 131071, 257), MakePatch(5, 65536, 0, 65536, 300),
    MakePatch(-2147483647 - 1, 4294967295u, 0, 4294967295u, 65536), MakePatch(0, 1, 1, large, 65537) };
  for (const vtkMTPatch& patch : patches)
  {
    vtkMTPatchStore store;
    ASSERT_TRUE(store.Begin({}) && store.WritePatch(vtkMTPatch(patch)) && store.Finish(MakeGraph(patch), { 0 }));
    for (const auto compression : Compressions)
    {
      vtkMTFileSource source;
      std::string error;
      ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(MakeFile(store, compression)), error)) << error;
      ExpectStored(store, source);
    }
  }
}

TEST(File, WedgeTableIsKeptAlsoWhereItSaysNothing)
{
  vtkMTPatch patch = MakePatch(0, 100, 0, 1, 4);
  patch.WedgePoints = { 0, 1, 2, 3 };
  vtkMTPatchStore store;
  ASSERT_TRUE(store.Begin({}) && store.WritePatch(vtkMTPatch(patch)) && store.Finish(MakeGraph(patch), { 0 }));
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(MakeFile(store)), error)) << error;
  ExpectStored(store, source);
}

TEST(File, ModelWithoutPatchesIsReadBack)
{
  vtkMTPatchStore store;
  vtkMTGraph graph;
  graph.Nodes.resize(2);
  graph.Index();
  ASSERT_TRUE(store.Begin({}) && store.Finish(graph, {}));
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(MakeFile(store)), error)) << error;
  ExpectEqual(store.GetGraph(), source.GetGraph());
}

TEST(File, SameModelGivesSameBytes)
{
  const auto model = MTTestModel::MakeTube();
  EXPECT_EQ(MakeFile(*model), MakeFile(*model));
}

TEST(File, PatchesLieInArcOrderFromTheDagToTheEnd)
{
  const auto model = MTTestModel::MakeTube();
  const Bytes bytes = MakeFile(*model);
  std::uint64_t next = SectionOffset(bytes);
  const auto table = MTFileSeal::GetBlock(bytes.data(), bytes.size(), MTFileSeal::Sections);
  const std::size_t sections = table.Size / sizeof(SectionOnDisk);
  EXPECT_EQ(sections, model->GetGraph().Arcs.size() * (model->GetGraph().Arrays.size() + 1));
  for (std::size_t i = 0; i < sections; ++i)
  {
    const SectionOnDisk section(bytes, i);
    next += section.GetPaddedSize();
  }
  EXPECT_EQ(SectionOffset(bytes) % 4096, 0u);
  EXPECT_EQ(next, bytes.size());
}

//------------------------------------------------------------------------------
TEST(File, ArraysThatAreNotAskedForAreNotRead)
{
  // Gives bytes of zero where it should not be asked.
  class Watched : public vtkMTByteSource
  {
  public:
    explicit Watched(Bytes bytes)
      : Inner(std::move(bytes))
    {
    }
    std::uint64_t GetSize() const override { return this->Inner.GetSize(); }
    bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override
    {
      this->Count += count;
      return this->Inner.Read(offset, count, destination, error);
    }
    std::string GetName() const override { return "watched"; }
    mutable std::atomic<std::uint64_t> Count{ 0 };

  private:
    vtkMTMemoryByteSource Inner;
  };

  const auto model = MTTestModel::MakeTube();
  const auto bytes = std::make_shared<Watched>(MakeFile(*model));
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(bytes, error)) << error;
  const std::size_t arrays = source.GetGraph().Arrays.size();
  ASSERT_GE(arrays, 3u);
  const std::uint32_t arc = static_cast<std::uint32_t>(source.GetGraph().Arcs.size()) - 1;
  vtkMTPatch all;
  bytes->Count = 0;
  ASSERT_TRUE(source.ReadPatch(arc, nullptr, all, error)) << error;
  EXPECT_EQ(bytes->Count, source.GetPatchSize(arc));
  const std::vector<unsigned char> none(arrays, 0);
  vtkMTPatch bare;
  bytes->Count = 0;
  ASSERT_TRUE(source.ReadPatch(arc, &none, bare, error)) << error;
  EXPECT_LT(bytes->Count, source.GetPatchSize(arc));
  EXPECT_EQ(bare.Points, all.Points);
  EXPECT_EQ(bare.Triangles, all.Triangles);
  ASSERT_EQ(bare.PointColumns.size(), all.PointColumns.size());
  for (const vtkMTColumn& column : bare.PointColumns)
  {
    EXPECT_TRUE(column.empty());
  }
  // The last array alone.
  std::vector<unsigned char> last(arrays, 0);
  last.back() = 1;
  vtkMTPatch some;
  ASSERT_TRUE(source.ReadPatch(arc, &last, some, error)) << error;
  const bool ofPoints = source.GetGraph().Arrays.back().Association == vtkMTArrayInfo::Point;
  EXPECT_EQ(ofPoints ? some.PointColumns.back() : some.CellColumns.back(),
    ofPoints ? all.PointColumns.back() : all.CellColumns.back());
}

TEST(File, ThreadsReadTheSame)
{
  Folder folder;
  const auto model = MTTestModel::MakeTube();
  std::string error;
  ASSERT_TRUE(WriteModel(*model, folder / "model.bmt", error)) << error;
  vtkMTFileSource source;
  ASSERT_TRUE(source.Open(folder / "model.bmt", error)) << error;
  std::atomic<int> wrong{ 0 };
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
  {
    threads.emplace_back(
      [&]
      {
        for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
        {
          vtkMTPatch patches[2];
          std::string message;
          const bool ok =
            source.ReadPatch(arc, nullptr, patches[0], message) && model->ReadPatch(arc, nullptr, patches[1], message);
          wrong += !ok || !AreEqual(patches[0], vtkMTPatchOrder::Make(patches[1]).Patch);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
}

TEST(File, PatchOutOfRangeIsAnError)
{
  vtkMTFileSource source;
  std::string error;
  vtkMTPatch patch;
  EXPECT_FALSE(source.ReadPatch(0, nullptr, patch, error));
  EXPECT_FALSE(error.empty());
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(MakeFile(*MakeSmallModel())), error));
  EXPECT_FALSE(source.ReadPatch(static_cast<std::uint32_t>(source.GetGraph().Arcs.size()), nullptr, patch, error));
  const std::vector<unsigned char> tooMany(source.GetGraph().Arrays.size() + 1, 1);
  EXPECT_FALSE(source.ReadPatch(0, &tooMany, patch, error));
}

//------------------------------------------------------------------------------
TEST(File, EveryChangedByteIsFound)
{
  const Bytes good = MakeFile(*MakeSmallModel());
  ASSERT_EQ(ReadAll(good), "");
  MTTestMeshes::Random random(1);
  std::size_t accepted = 0;
  Bytes bytes = good;
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    bytes[i] = good[i] ^ static_cast<unsigned char>(1 + random.Below(255));
    accepted += ReadAll(bytes).empty();
    bytes[i] = good[i];
  }
  EXPECT_EQ(accepted, 0u);
  std::cout << good.size() << " bytes changed, one at a time\n";
}

TEST(File, EveryLengthButTheRightOneIsRefused)
{
  const Bytes good = MakeFile(*MakeSmallModel());
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    EXPECT_NE(ReadAll(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length))), "") << length;
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_NE(ReadAll(longer).find("added"), std::string::npos);
  std::cout << good.size() << " lengths\n";
}

TEST(File, NewerVersionIsRefusedWithAMessageThatSaysSo)
{
  Bytes bytes = MakeFile(*MakeSmallModel());
  bytes[8] = 255;
  EXPECT_NE(ReadAll(bytes).find("newer"), std::string::npos);
  Reseal(bytes);
  const std::string message = ReadAll(bytes);
  EXPECT_NE(message.find("newer"), std::string::npos);
  EXPECT_NE(message.find("version 255"), std::string::npos);
  std::cout << message << "\n";
  bytes[8] = 0;
  EXPECT_NE(ReadAll(bytes).find("does not exist"), std::string::npos);
}

TEST(File, OtherFilesAreRefused)
{
  EXPECT_NE(ReadAll({}).find("empty"), std::string::npos);
  EXPECT_NE(ReadAll(Bytes(1000, 'x')).find("not a Multi-Triangulation"), std::string::npos);
  Folder folder;
  vtkMTFileSource source;
  std::string error;
  EXPECT_FALSE(source.Open(folder / "missing.bmt", error));
  EXPECT_NE(error.find("missing.bmt"), std::string::npos);
  EXPECT_FALSE(source.Open(folder / "", error)); // the folder itself
  EXPECT_NE(error.find("not a regular file"), std::string::npos);
}

// Damage whose author has made the checksums of header and DAG right again.
TEST(File, LiesUnderRightChecksumsDoNoHarm)
{
  const Bytes good = MakeFile(*MakeSmallModel());
  const std::uint64_t patchOffset = SectionOffset(good);
  const auto headerSize = MTFileSeal::Get<std::uint32_t>(good.data(), 12);
  MTTestMeshes::Random random(2);
  std::size_t refused = 0;
  constexpr std::size_t attempts = 20000;
  for (std::size_t i = 0; i < attempts; ++i)
  {
    Bytes bytes = good;
    const std::size_t changes = 1 + random.Below(4);
    for (std::size_t j = 0; j < changes; ++j)
    {
      const std::size_t begin = random.Below(2) ? 16 : headerSize;
      const std::size_t end = begin == 16 ? headerSize - 8 : patchOffset;
      const std::size_t place = begin + random.Below(end - begin);
      static const unsigned char values[] = { 0, 1, 0x7f, 0x80, 0xff };
      bytes[place] = random.Below(2) ? values[random.Below(5)] : static_cast<unsigned char>(random.Below(256));
    }
    Reseal(bytes);
    refused += !ReadAll(std::move(bytes)).empty();
  }
  std::cout << refused << " of " << attempts << " refused\n";
  EXPECT_GT(refused, attempts / 3); // much of what lies before the patches is padding
}

class FileOfEveryCodec : public ::testing::TestWithParam<vtkMTFileSink::CompressionType>
{
};

TEST_P(FileOfEveryCodec, LiesInPatchesUnderRightChecksumsDoNoHarm)
{
  const Bytes good = MakeFile(*MakeSmallModel(), this->GetParam());
  MTTestMeshes::Random random(3);
  std::size_t refused = 0;
  constexpr std::size_t attempts = 20000;
  for (std::size_t i = 0; i < attempts; ++i)
  {
    Bytes bytes = good;
    SectionOnDisk section(bytes, 0);
    const std::size_t begin = SectionOffset(bytes);
    for (std::size_t j = 0; j <= random.Below(3); ++j)
    {
      const std::uint64_t limit = random.Below(2) ? 40 : section.StoredSize;
      bytes[begin + random.Below(limit)] = static_cast<unsigned char>(random.Below(256));
    }
    section.Checksum = XXH3_64bits(bytes.data() + begin, section.GetPaddedSize());
    section.Put(bytes, 0);
    Reseal(bytes);
    refused += !ReadAll(std::move(bytes)).empty();
  }
  std::cout << refused << " of " << attempts << " refused\n";
  EXPECT_GT(refused, attempts / 4);
}

INSTANTIATE_TEST_SUITE_P(All, FileOfEveryCodec, ::testing::ValuesIn(Compressions),
  [](const auto& test)
  {
    return std::string(test.param == vtkMTFileSink::None ? "None"
        : test.param == vtkMTFileSink::Fast              ? "Fast"
                                                         : "Small");
  });

//------------------------------------------------------------------------------
TEST(File, InconsistentPatchesAndGraphsAreRefused)
{
  Folder folder;
  const auto model = MakeSmallModel();
  const vtkMTGraph& graph = model->GetGraph();
  const auto patchOf = [&](std::uint32_t arc)
  {
    vtkMTPatch patch;
    std::string error;
    EXPECT_TRUE(model->ReadPatch(arc, nullptr, patch, error));
    return patch;
  };
  const auto refuses = [&](const std::function<void(vtkMTPatch&)>& spoil)
  {
    vtkMTFileSink sink(folder / "model.bmt");
    vtkMTPatch patch = patchOf(0);
    spoil(patch);
    EXPECT_TRUE(sink.Begin(graph.Arrays));
    const bool refused = !sink.WritePatch(std::move(patch));
    EXPECT_FALSE(sink.GetError().empty());
    EXPECT_FALSE(sink.Finish(graph, {}));
    return refused;
  };
  EXPECT_TRUE(refuses([](vtkMTPatch& patch) { patch.Triangles[0][1] = 1u << 30; }));
  EXPECT_TRUE(refuses([](vtkMTPatch& patch) { patch.WedgePoints.assign(patch.GetNumberOfWedges(), 1u << 30); }));
  EXPECT_TRUE(refuses([](vtkMTPatch& patch) { patch.Ids.resize(patch.Points.size() + 1); }));
  EXPECT_TRUE(refuses([](vtkMTPatch& patch) { patch.PointColumns[0].pop_back(); }));
  EXPECT_TRUE(refuses([](vtkMTPatch& patch) { patch.CellColumns.emplace_back(); }));

  std::vector<std::uint32_t> order(graph.Arcs.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto refusesGraph = [&](const std::function<void(vtkMTGraph&, std::vector<std::uint32_t>&)>& spoil)
  {
    vtkMTFileSink sink(folder / "model.bmt");
    bool ok = sink.Begin(graph.Arrays);
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      ok = ok && sink.WritePatch(patchOf(arc));
    }
    EXPECT_TRUE(ok);
    vtkMTGraph spoiled = graph;
    std::vector<std::uint32_t> patchOfArc = order;
    spoil(spoiled, patchOfArc);
    return !sink.Finish(spoiled, patchOfArc) && !sink.GetError().empty();
  };
  using Order = std::vector<std::uint32_t>;
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { g.Arcs[0].Triangles += 1; }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { g.Arcs[0].To = 1u << 30; }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { std::swap(g.Arcs.front(), g.Arcs.back()); }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { g.Arrays.pop_back(); }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { g.Lattice.Step = 0.3; }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph& g, Order&) { g.Nodes[0].Error = std::nan(""); }));
  EXPECT_TRUE(refusesGraph(
    [](vtkMTGraph& g, Order&)
    {
      g.Arcs[0].ConeAxis = { 0.0f, 0.0f, 1.0f };
      g.Arcs[0].ConeCosine = 1.5f;
    }));
  EXPECT_TRUE(refusesGraph(
    [](vtkMTGraph& g, Order&)
    {
      g.Arcs[0].ConeAxis = { 0.0f, 0.0f, 1.1f };
      g.Arcs[0].ConeCosine = 0.5f;
    }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph&, Order& p) { p.pop_back(); }));
  EXPECT_TRUE(refusesGraph([](vtkMTGraph&, Order& p) { p[0] = p[1]; }));
  EXPECT_TRUE(folder.List().empty());
}

TEST(File, AbandonedModelLeavesNothingAndTheEarlierOneStays)
{
  Folder folder;
  WriteFile(folder / "model.bmt", "earlier");
  const auto model = MakeSmallModel();
  for (const bool explicitly : { true, false })
  {
    vtkMTFileSink sink(folder / "model.bmt");
    vtkMTPatch patch;
    std::string error;
    ASSERT_TRUE(model->ReadPatch(0, nullptr, patch, error));
    ASSERT_TRUE(sink.Begin(model->GetGraph().Arrays));
    ASSERT_TRUE(sink.WritePatch(std::move(patch)));
    EXPECT_EQ(folder.List(), std::vector<std::string>{ "model.bmt" }) << "the spool has a name";
    if (explicitly)
    {
      sink.Abandon();
      EXPECT_FALSE(sink.WritePatch(vtkMTPatch()));
    }
  }
  EXPECT_EQ(folder.List(), std::vector<std::string>{ "model.bmt" });
  EXPECT_EQ(ReadFile(folder / "model.bmt"), Bytes({ 'e', 'a', 'r', 'l', 'i', 'e', 'r' }));
  std::string error;
  ASSERT_TRUE(WriteModel(*model, folder / "model.bmt", error)) << error;
  EXPECT_EQ(folder.List(), std::vector<std::string>{ "model.bmt" });
  EXPECT_EQ(ReadAll(ReadFile(folder / "model.bmt")), "");
}

TEST(File, FullDiskIsAClearErrorAndLeavesNothing)
{
  Folder folder;
  WriteFile(folder / "model.bmt", "earlier");
  const auto model = MTTestModel::MakeTube();
  const std::size_t size = MakeFile(*model).size();
  for (const std::size_t limit : { std::size_t(0), std::size_t(100), size / 4, size / 2, size - 1 })
  {
    const ChildResult result = RunInChild(
      [&]
      {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit most = { limit, limit };
        ::setrlimit(RLIMIT_FSIZE, &most);
        std::string error;
        const bool written = WriteModel(*model, folder / "model.bmt", error);
        const bool isClear =
          error.find("model.bmt") != std::string::npos && error.find("failed after") != std::string::npos;
        return written ? 1 : isClear ? 0 : 2;
      });
    EXPECT_FALSE(result.Crashed);
    EXPECT_EQ(result.ExitCode, 0) << limit;
    EXPECT_EQ(folder.List(), std::vector<std::string>{ "model.bmt" }) << limit;
    EXPECT_EQ(ReadFile(folder / "model.bmt").size(), 7u);
  }
}

TEST(File, OutputThatCannotBeMadeIsRefusedBeforeAnyWork)
{
  Folder folder;
  const auto model = MakeSmallModel();
  for (const std::string& path : { folder / "missing/model.bmt", std::string("/dev/full"), folder / "", std::string() })
  {
    vtkMTFileSink sink(path);
    EXPECT_FALSE(sink.Begin(model->GetGraph().Arrays)) << path;
    EXPECT_FALSE(sink.GetError().empty());
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_TRUE(folder.List().empty());
}

TEST(File, LinkStaysALinkAndPermissionsStay)
{
  Folder folder;
  WriteFile(folder / "real.bmt", "earlier");
  std::filesystem::permissions(folder / "real.bmt", std::filesystem::perms(0640));
  std::filesystem::create_symlink("real.bmt", folder / "link.bmt");
  std::string error;
  ASSERT_TRUE(WriteModel(*MakeSmallModel(), folder / "link.bmt", error)) << error;
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bmt"));
  EXPECT_EQ(ReadAll(ReadFile(folder / "real.bmt")), "");
  EXPECT_EQ(std::filesystem::status(folder / "real.bmt").permissions(), std::filesystem::perms(0640));
  EXPECT_EQ(folder.List(), (std::vector<std::string>{ "link.bmt", "real.bmt" }));
}

TEST(File, MemoryOfTheSinkDoesNotFollowTheModel)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "a sanitizer keeps memory that was freed";
  }
  const auto residentBytes = []
  {
    std::ifstream file("/proc/self/statm");
    std::uint64_t pages[2] = { 0, 0 };
    file >> pages[0] >> pages[1];
    return pages[1] * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  };
  Folder folder;
  vtkMTFileSink sink(folder / "model.bmt");
  ASSERT_TRUE(sink.Begin({}));
  const vtkMTPatch patch = MakePatch(0, 1u << 24, 0, 1000, 2000);
  const auto write = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      ASSERT_TRUE(sink.WritePatch(vtkMTPatch(patch)));
    }
  };
  write(20);
  const std::uint64_t before = residentBytes();
  constexpr int count = 2000;
  write(count);
  const std::uint64_t after = residentBytes();
  const std::uint64_t grown = after > before ? after - before : 0;
  std::cout << count << " patches, " << count * patch.GetMemorySize() / 1000000 << " MB: resident memory grew by "
            << grown << " bytes\n";
  EXPECT_LT(grown, std::uint64_t(4) << 20);
}
