// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFrameHeap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

#include <sys/resource.h>

namespace
{
long GetFaults()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

// The pages fetched by a frame that takes 32 MiB as software OpenGL does, in blocks of 64 KiB, and frees them.
long DrawFrame()
{
  const long before = GetFaults();
  std::vector<char*> blocks(512);
  for (char*& block : blocks)
  {
    constexpr std::size_t size = 1 << 16;
    block = static_cast<char*>(std::malloc(size));
    std::fill(block, block + size, 'x');
  }
  std::for_each(blocks.rbegin(), blocks.rend(), [](char* block) { std::free(block); });
  return GetFaults() - before;
}

// gtest_discover_tests runs each test in a process of its own, where nothing has been freed before.
TEST(FrameHeap, WhatAFrameFreesStaysForTheNextOne)
{
  DrawFrame();
  const long given = DrawFrame();
  vtkMTFrameHeap::Keep();
  DrawFrame();
  const long kept = DrawFrame();
  std::cout << "pages fetched by a frame of 32 MiB: " << given << " before, " << kept << " after\n";
  EXPECT_LT(kept, 100);
}
}
