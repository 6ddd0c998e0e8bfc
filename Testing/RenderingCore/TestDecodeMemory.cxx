// SPDX-License-Identifier: BSD-3-Clause
// What reading a patch from a file allocates, beside what a source says that it does.
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <malloc.h>
#include <new>
#include <numeric>

namespace
{
// Of this thread, while Counting.
thread_local bool Counting = false;
thread_local std::int64_t Now = 0;
thread_local std::int64_t Most = 0;

void* Count(void* memory)
{
  if (Counting && memory)
  {
    Now += static_cast<std::int64_t>(malloc_usable_size(memory));
    Most = std::max(Most, Now);
  }
  return memory;
}
}

// Not inlined: the compiler would see std::malloc beside operator delete, and warn.
// NOLINTBEGIN
[[gnu::noinline]] void* operator new(std::size_t size)
{
  void* memory = Count(std::malloc(size ? size : 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  if (Counting && memory)
  {
    Now -= static_cast<std::int64_t>(malloc_usable_size(memory));
  }
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}
// NOLINTEND

namespace
{
std::string WriteModel(const vtkMTPatchSource& model)
{
  std::string path = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/DecodeMemory.bmt";
  vtkMTFileSink sink(path);
  const vtkMTGraph& graph = model.GetGraph();
  bool written = sink.Begin(graph.Arrays);
  std::vector<std::uint32_t> patchOfArc(graph.Arcs.size());
  std::iota(patchOfArc.begin(), patchOfArc.end(), 0u);
  std::string error;
  for (const std::uint32_t arc : patchOfArc)
  {
    vtkMTPatch patch;
    written = written && model.ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
  }
  EXPECT_TRUE(written && sink.Finish(graph, patchOfArc)) << sink.GetError() << error;
  return path;
}

TEST(DecodeMemory, IsNotMoreThanTheSourceSays)
{
  MTTestModel::TubeOptions options;
  options.Rings = 2048;
  options.Across = 16;
  const std::string path = WriteModel(*MTTestModel::MakeTube(options));
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(path, error)) << error;
  double largestShare = 0.0;
  for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    Now = Most = 0;
    Counting = true;
    const bool read = source.ReadPatch(arc, nullptr, patch, error);
    Counting = false;
    ASSERT_TRUE(read) << error;
    const auto said =
      static_cast<std::int64_t>(patch.GetMemorySize() + source.GetPatchSize(arc) + source.GetDecodeSize(arc));
    largestShare = std::max(largestShare, static_cast<double>(Most) / static_cast<double>(said));
    EXPECT_LE(Most, said) << "patch " << arc;
  }
  std::cout << "at most " << largestShare << " of what the source says is allocated\n";
  EXPECT_GT(largestShare, 0.2); // or it is not counted
  std::remove(path.c_str());
}
}
