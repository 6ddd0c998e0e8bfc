// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRangeAllocator.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>

namespace
{
TEST(RangeAllocator, HandsOutEverythingAndTakesItBack)
{
  vtkMTRangeAllocator ranges;
  ranges.Reset(100);
  EXPECT_EQ(ranges.Allocate(60), 0u);
  EXPECT_EQ(ranges.Allocate(40), 60u);
  EXPECT_EQ(ranges.Allocate(1), vtkMTRangeAllocator::Nowhere);
  ranges.Free(0, 60);
  ranges.Free(60, 40);
  EXPECT_EQ(ranges.GetUsed(), 0u);
  EXPECT_EQ(ranges.Allocate(100), 0u);
}

TEST(RangeAllocator, JoinsFreeNeighbours)
{
  vtkMTRangeAllocator ranges;
  ranges.Reset(30);
  for (int i = 0; i < 3; ++i)
  {
    ranges.Allocate(10);
  }
  ranges.Free(0, 10);
  ranges.Free(20, 10);
  EXPECT_EQ(ranges.Allocate(11), vtkMTRangeAllocator::Nowhere);
  ranges.Free(10, 10);
  EXPECT_EQ(ranges.GetLargestFree(), 30u);
}

TEST(RangeAllocator, GrowsAtTheEnd)
{
  vtkMTRangeAllocator ranges;
  ranges.Reset(0);
  EXPECT_EQ(ranges.Allocate(1), vtkMTRangeAllocator::Nowhere);
  ranges.Grow(10);
  EXPECT_EQ(ranges.Allocate(5), 0u);
  ranges.Grow(20);
  EXPECT_EQ(ranges.Allocate(15), 5u);
  ranges.Grow(3);
  EXPECT_EQ(ranges.GetCapacity(), 20u);
}

TEST(RangeAllocator, RandomUseNeverOverlapsAndLosesNothing)
{
  std::mt19937 random(1);
  vtkMTRangeAllocator ranges;
  ranges.Reset(10000);
  std::map<std::uint64_t, std::uint64_t> used;
  std::uint64_t sum = 0;
  int refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    if (random() % 2 || used.empty())
    {
      const std::uint64_t size = random() % 200;
      const std::uint64_t at = ranges.Allocate(size);
      if (at == vtkMTRangeAllocator::Nowhere)
      {
        ++refused;
        EXPECT_LT(ranges.GetLargestFree(), size);
      }
      else if (size > 0)
      {
        const auto next = used.lower_bound(at);
        EXPECT_TRUE(next == used.end() || next->first >= at + size);
        EXPECT_TRUE(next == used.begin() || std::prev(next)->first + std::prev(next)->second <= at);
        EXPECT_LE(at + size, ranges.GetCapacity());
        used[at] = size;
        sum += size;
      }
    }
    else
    {
      auto it = used.lower_bound(random() % 10000);
      it = it == used.end() ? used.begin() : it;
      ranges.Free(it->first, it->second);
      sum -= it->second;
      used.erase(it);
    }
    ASSERT_EQ(ranges.GetUsed(), sum);
  }
  for (const auto& each : used)
  {
    ranges.Free(each.first, each.second);
  }
  EXPECT_EQ(ranges.GetLargestFree(), 10000u);
  std::cout << refused << " requests refused\n";
}
}
