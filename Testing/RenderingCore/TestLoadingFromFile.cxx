// SPDX-License-Identifier: BSD-3-Clause
// The cache with a file behind it: reads that merge, arrays that are not read, files that go bad while they are viewed.
#include "MTTestModel.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTPatchCache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <thread>

namespace
{
std::shared_ptr<vtkMTPatchStore> MakeModel()
{
  MTTestModel::TubeOptions options;
  options.Rings = 2048;
  options.Across = 16;
  return MTTestModel::MakeTube(options);
}

// A file of its own for each test, away when the test is over.
class ModelFile
{
public:
  explicit ModelFile(const std::string& name)
    : Path(std::string(MT_TEST_OUTPUT_DIRECTORY) + "/" + name + ".bmt")
  {
    const auto model = MakeModel();
    vtkMTFileSink sink(this->Path);
    const vtkMTGraph& graph = model->GetGraph();
    bool written = sink.Begin(graph.Arrays);
    std::vector<std::uint32_t> patchOfArc(graph.Arcs.size());
    std::iota(patchOfArc.begin(), patchOfArc.end(), 0u);
    std::string error;
    for (const std::uint32_t arc : patchOfArc)
    {
      vtkMTPatch patch;
      written = written && model->ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    }
    EXPECT_TRUE(written && sink.Finish(graph, patchOfArc)) << sink.GetError() << error;
  }
  ~ModelFile() { std::remove(this->Path.c_str()); }

  const std::string Path;
};

// A file that counts how it is read.
class CountedFile : public vtkMTByteSource
{
public:
  explicit CountedFile(const std::string& path)
    : File(vtkMTFileByteSource::Open(path, this->Error))
  {
    EXPECT_NE(this->File, nullptr) << this->Error;
  }
  std::uint64_t GetSize() const override { return this->File->GetSize(); }
  std::string GetName() const override { return this->File->GetName(); }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override
  {
    ++this->Reads;
    this->Bytes += count;
    return this->File->Read(offset, count, destination, error);
  }

  std::string Error;
  std::unique_ptr<vtkMTByteSource> File;
  mutable std::atomic<std::uint64_t> Reads{ 0 };
  mutable std::atomic<std::uint64_t> Bytes{ 0 };
};

std::shared_ptr<vtkMTFileSource> OpenFile(const std::string& path)
{
  auto source = std::make_shared<vtkMTFileSource>();
  std::string error;
  EXPECT_TRUE(source->Open(path, error)) << error;
  return source;
}

std::vector<std::uint32_t> AllArcs(const vtkMTPatchSource& source)
{
  std::vector<std::uint32_t> arcs(source.GetGraph().Arcs.size());
  std::iota(arcs.begin(), arcs.end(), 0u);
  return arcs;
}

std::size_t CountPatches(const vtkMTPatchCache& cache, const std::vector<std::uint32_t>& arcs)
{
  return static_cast<std::size_t>(
    std::count_if(arcs.begin(), arcs.end(), [&cache](std::uint32_t arc) { return cache.Has(arc); }));
}

TEST(LoadingFromFile, NeighboursAreReadTogetherAndGiveTheSame)
{
  const ModelFile file("neighbours");
  const auto bytes = std::make_shared<CountedFile>(file.Path);
  const auto source = std::make_shared<vtkMTFileSource>();
  std::string error;
  ASSERT_TRUE(source->Open(bytes, error)) << error;
  bytes->Reads = 0;
  bytes->Bytes = 0;
  vtkMTPatchCache cache(source);
  const auto arcs = AllArcs(*source);
  // The order is that of urgency; the store's order is another one.
  std::vector<std::uint32_t> backwards(arcs.rbegin(), arcs.rend());
  cache.Request(backwards);
  std::uint64_t stored = 0;
  for (const std::uint32_t arc : arcs)
  {
    stored += source->GetPatchSize(arc);
    vtkMTPatch patch;
    ASSERT_TRUE(source->ReadPatch(arc, nullptr, patch, error)) << error;
    const auto loaded = cache.Get(arc);
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(loaded->Points, patch.Points);
    EXPECT_EQ(loaded->Triangles, patch.Triangles);
    EXPECT_EQ(loaded->PointColumns, patch.PointColumns);
    EXPECT_EQ(loaded->CellColumns, patch.CellColumns);
  }
  const std::uint64_t reads = bytes->Reads - arcs.size(); // those of the comparison apart
  std::cout << arcs.size() << " patches of " << stored << " bytes in " << reads << " reads\n";
  EXPECT_EQ(bytes->Bytes, 2 * stored);
  EXPECT_LE(reads, stored / (std::uint64_t(1) << 19) + 4);
}

TEST(LoadingFromFile, ArraysThatAreNotWantedAreNotRead)
{
  const ModelFile file("arrays");
  const auto bytes = std::make_shared<CountedFile>(file.Path);
  const auto source = std::make_shared<vtkMTFileSource>();
  std::string error;
  ASSERT_TRUE(source->Open(bytes, error)) << error;
  bytes->Bytes = 0;
  vtkMTPatchCache cache(source);
  cache.SetArrays(std::vector<unsigned char>(source->GetGraph().Arrays.size(), 0));
  const auto arcs = AllArcs(*source);
  cache.Request(arcs);
  std::uint64_t stored = 0;
  std::uint64_t geometry = 0;
  for (const std::uint32_t arc : arcs)
  {
    stored += source->GetPatchSize(arc);
    const auto patch = cache.Get(arc);
    ASSERT_NE(patch, nullptr);
    for (const vtkMTColumn& column : patch->PointColumns)
    {
      EXPECT_TRUE(column.empty());
    }
  }
  geometry = source->GetSizeByKind()[0];
  const std::uint64_t gaps = arcs.size() * vtkMTFileSource::MaximumGap;
  std::cout << bytes->Bytes << " bytes read of " << stored << ", " << geometry << " of them geometry\n";
  EXPECT_LE(bytes->Bytes, std::min(stored, geometry + gaps));
  EXPECT_LT(bytes->Bytes, stored);
}

TEST(LoadingFromFile, FileThatDisappearsIsReadOn)
{
  const ModelFile file("disappears");
  const auto source = OpenFile(file.Path);
  vtkMTPatchCache cache(source);
  cache.Request({ 0, 1 });
  ASSERT_EQ(std::remove(file.Path.c_str()), 0);
  const auto arcs = AllArcs(*source);
  cache.Request(arcs);
  EXPECT_EQ(CountPatches(cache, arcs), arcs.size());
  EXPECT_TRUE(cache.TakeFailures().empty());
}

TEST(LoadingFromFile, FileCutShortGivesWhatIsLeftAndNamesTheRestOnce)
{
  const ModelFile file("short");
  const auto source = OpenFile(file.Path);
  vtkMTPatchCache cache(source);
  cache.Request({ 0, 1 });
  const auto arcs = AllArcs(*source);
  const std::uint64_t half = source->GetPatchPlace(arcs[arcs.size() / 2]) + 10;
  std::filesystem::resize_file(file.Path, half);
  cache.Request(arcs);
  for (const std::uint32_t arc : arcs)
  {
    EXPECT_EQ(cache.Has(arc), source->GetPatchPlace(arc) + source->GetPatchSize(arc) <= half) << arc;
  }
  auto failures = cache.TakeFailures();
  ASSERT_EQ(failures.size(), arcs.size() - CountPatches(cache, arcs));
  std::sort(failures.begin(), failures.end(), [](const auto& a, const auto& b) { return a.Arc < b.Arc; });
  std::cout << failures.front().What << "\n";
  EXPECT_NE(failures.front().What.find(file.Path), std::string::npos);
  EXPECT_NE(failures.front().What.find("patch " + std::to_string(failures.front().Arc)), std::string::npos);
  cache.Request(arcs);
  EXPECT_TRUE(cache.TakeFailures().empty());
}

TEST(LoadingFromFile, DamagedBlockFailsAloneAndNamesFileAndBlock)
{
  const ModelFile file("damaged");
  const auto source = OpenFile(file.Path);
  const auto arcs = AllArcs(*source);
  const std::uint32_t bad = arcs[arcs.size() / 3];
  {
    std::fstream stream(file.Path, std::ios::in | std::ios::out | std::ios::binary);
    const auto place = static_cast<std::streamoff>(source->GetPatchPlace(bad) + 50);
    stream.seekg(place);
    const char byte = static_cast<char>(stream.get() ^ 1);
    stream.seekp(place);
    stream.put(byte);
  }
  vtkMTPatchCache cache(source);
  cache.Request(arcs);
  EXPECT_EQ(CountPatches(cache, arcs), arcs.size() - 1);
  EXPECT_FALSE(cache.Has(bad));
  EXPECT_TRUE(cache.IsFailed(bad));
  const auto failures = cache.TakeFailures();
  ASSERT_EQ(failures.size(), 1u);
  std::cout << failures[0].What << "\n";
  EXPECT_NE(failures[0].What.find(file.Path), std::string::npos);
  EXPECT_NE(failures[0].What.find("patch " + std::to_string(bad)), std::string::npos);
  EXPECT_NE(failures[0].What.find("checksum"), std::string::npos);
}

TEST(LoadingFromFile, ManyCachesShareOneFile)
{
  const ModelFile file("shared");
  const auto source = OpenFile(file.Path);
  const auto arcs = AllArcs(*source);
  std::vector<std::thread> owners;
  std::atomic<std::size_t> there{ 0 };
  for (int i = 0; i < 4; ++i)
  {
    owners.emplace_back(
      [&]
      {
        vtkMTPatchCache cache(source);
        cache.Request(arcs);
        there += CountPatches(cache, arcs);
      });
  }
  for (std::thread& owner : owners)
  {
    owner.join();
  }
  EXPECT_EQ(there, 4 * arcs.size());
}
}
