// SPDX-License-Identifier: BSD-3-Clause
// A good file, damaged in ten thousand ways: none is taken for whole, and none needs more memory than the good one.
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"

#include <atomic>
#include <map>
#include <new>

#include <malloc.h>

using namespace MTIOTest;

namespace
{
std::atomic<std::size_t> Held{ 0 };
std::atomic<std::size_t> MostHeld{ 0 };
}

// What the process holds is counted where no sanitizer counts itself. Not inlined, or the compiler would see a free for
// every new.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
__attribute__((noinline)) void* operator new(std::size_t size)
{
  void* memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  const std::size_t held = Held += malloc_usable_size(memory);
  std::size_t most = MostHeld;
  while (held > most && !MostHeld.compare_exchange_weak(most, held))
  {
  }
  return memory;
}

__attribute__((noinline)) void operator delete(void* memory) noexcept
{
  Held -= malloc_usable_size(memory);
  std::free(memory);
}

__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}
#endif

namespace
{
using MTTestMeshes::Random;

Bytes MakeGoodFile()
{
  Folder folder;
  MTTestModel::TubeOptions options;
  options.Rings = 64;
  options.Across = 8;
  options.Regions = 8;
  const auto model = MTTestModel::MakeTube(options);
  vtkMTGraph graph = model->GetGraph();
  graph.Blobs.push_back({ "picture", "image/png", {} });
  vtkMTFileSink sink(folder / "model.bmt");
  bool done = sink.Begin(graph.Arrays) && sink.WriteBlob(Bytes(333, 3));
  std::vector<std::uint32_t> order;
  for (std::uint32_t arc = 0; done && arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    done = model->ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    order.push_back(arc);
  }
  EXPECT_TRUE(done && sink.Finish(graph, order)) << sink.GetError();
  return ReadFile(folder / "model.bmt");
}

// Whether everything in it can be read; the memory that it took at most.
bool IsTakenForWhole(const Bytes& bytes, std::size_t& most, std::string& error)
{
  MostHeld = Held.load();
  const std::size_t before = Held;
  vtkMTFileSource source;
  bool whole = source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error);
  const vtkMTGraph& graph = source.GetGraph();
  for (std::uint32_t arc = 0; whole && arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    whole = source.ReadPatch(arc, nullptr, patch, error);
  }
  for (std::uint32_t blob = 0; whole && blob < graph.Blobs.size(); ++blob)
  {
    Bytes read;
    whole = source.ReadBlob(blob, read, error);
  }
  most = MostHeld - before;
  return whole;
}

struct Range
{
  std::ptrdiff_t Begin;
  std::ptrdiff_t Size;
};

Range DrawRange(Random& random, std::size_t size)
{
  const std::size_t length = 1 + random.Below(random.Below(2) ? 64 : size / 2);
  return { static_cast<std::ptrdiff_t>(random.Below(size - length + 1)), static_cast<std::ptrdiff_t>(length) };
}

const char* Damage(Random& random, Bytes& bytes)
{
  const Range one = DrawRange(random, bytes.size());
  const Range other = DrawRange(random, bytes.size());
  const auto at = [&bytes](std::ptrdiff_t place) { return bytes.begin() + place; };
  switch (random.Below(8))
  {
    case 0:
      for (std::size_t i = 0; i <= random.Below(8); ++i)
      {
        bytes[random.Below(bytes.size())] ^= static_cast<unsigned char>(1u << random.Below(8));
      }
      return "flipped bits";
    case 1:
      bytes.resize(random.Below(bytes.size()));
      return "truncated";
    case 2:
    {
      const Bytes piece(at(other.Begin), at(other.Begin + other.Size));
      const std::ptrdiff_t room = std::min(other.Size, static_cast<std::ptrdiff_t>(bytes.size()) - one.Begin);
      std::copy(piece.begin(), piece.begin() + room, at(one.Begin));
      return "a block over another";
    }
    case 3:
    {
      const Bytes piece(at(other.Begin), at(other.Begin + other.Size));
      bytes.insert(at(one.Begin), piece.begin(), piece.end());
      return "a block inserted";
    }
    case 4:
      bytes.erase(at(one.Begin), at(one.Begin + one.Size));
      return "a block removed";
    case 5:
    {
      const std::size_t block = std::size_t(16) << random.Below(9);
      const std::size_t blocks = bytes.size() / block;
      const auto first = static_cast<std::ptrdiff_t>(random.Below(blocks) * block);
      const auto second = static_cast<std::ptrdiff_t>(random.Below(blocks) * block);
      std::swap_ranges(at(first), at(first + static_cast<std::ptrdiff_t>(block)), at(second));
      return "swapped blocks";
    }
    case 6:
      std::fill(at(one.Begin), at(one.Begin + one.Size), static_cast<unsigned char>(random.Below(2) ? 0 : 255));
      return "a block of zeros";
    default:
      bytes[8 + random.Below(4)] = static_cast<unsigned char>(random.Below(256));
      return "another version";
  }
}
}

TEST(Damage, TenThousandDamagedFilesAreRefusedWithinTheMemoryOfTheGoodOne)
{
  const Bytes good = MakeGoodFile();
  std::string error;
  std::size_t goodMemory = 0;
  ASSERT_TRUE(IsTakenForWhole(good, goodMemory, error)) << error;
  std::map<std::string, int> kinds;
  std::size_t worst = 0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed)
  {
    Random random(seed);
    Bytes bytes = good;
    std::string kind = Damage(random, bytes);
    while (bytes == good)
    {
      kind = Damage(random, bytes);
    }
    ++kinds[kind];
    std::size_t memory = 0;
    error.clear();
    EXPECT_FALSE(IsTakenForWhole(bytes, memory, error)) << "seed " << seed << ": " << kind;
    EXPECT_FALSE(error.empty()) << "seed " << seed << ": " << kind;
    // The bytes themselves are in memory here.
    const std::size_t longer = bytes.size() > good.size() ? bytes.size() - good.size() : 0;
    EXPECT_LE(memory, goodMemory * 11 / 10 + longer) << "seed " << seed << ": " << kind;
    worst = std::max(worst, memory > longer ? memory - longer : 0);
  }
  for (const auto& [kind, count] : kinds)
  {
    std::cout << kind << ": " << count << "\n";
  }
  std::cout << "a file of " << good.size() << " bytes; memory of the good one " << goodMemory
            << ", most of a damaged one " << worst << "\n";
}
