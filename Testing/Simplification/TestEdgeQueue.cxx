// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTEdgeQueue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

TEST(EdgeQueue, GivesTheCheapestFirstWithinABucket)
{
  constexpr std::uint32_t edges = 5000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-60.0, 20.0);
  vtkMTEdgeQueue queue(edges);
  std::vector<double> costs(edges);
  for (std::uint32_t e = 0; e < edges; ++e)
  {
    costs[e] = std::exp(exponent(random));
    queue.Put(e, costs[e]);
  }
  double last = 0.0;
  for (std::uint32_t taken = 0; taken < edges; ++taken)
  {
    const std::uint32_t edge = queue.Take();
    ASSERT_NE(edge, vtkMTEdgeQueue::None);
    EXPECT_GE(costs[edge], last / (1.0 + 1.0 / 31.0));
    last = costs[edge];
  }
  EXPECT_EQ(queue.Take(), vtkMTEdgeQueue::None);
}

TEST(EdgeQueue, AnEdgeCountsOnceAndNotWhenWithdrawn)
{
  vtkMTEdgeQueue queue(4);
  queue.Put(0, 1.0);
  queue.Put(1, 2.0);
  queue.Put(2, 3.0);
  queue.Put(0, 5.0);
  queue.Withdraw(1);
  EXPECT_FALSE(queue.IsNext(4.0));
  EXPECT_TRUE(queue.IsNext(2.5));
  EXPECT_EQ(queue.Take(), 2u);
  EXPECT_EQ(queue.Take(), 0u);
  EXPECT_TRUE(queue.IsNext(1e300));
  EXPECT_EQ(queue.Take(), vtkMTEdgeQueue::None);
  queue.Put(3, 0.5);
  EXPECT_EQ(queue.Take(), 3u);
}

TEST(EdgeQueue, TakesAnyNumberForACost)
{
  vtkMTEdgeQueue queue(5);
  queue.Put(0, std::numeric_limits<double>::quiet_NaN());
  queue.Put(1, std::numeric_limits<double>::infinity());
  queue.Put(2, -1.0);
  queue.Put(3, 1e308);
  queue.Put(4, 1e-308);
  std::vector<std::uint32_t> order;
  for (std::uint32_t edge = queue.Take(); edge != vtkMTEdgeQueue::None; edge = queue.Take())
  {
    order.push_back(edge);
  }
  EXPECT_EQ(order, (std::vector<std::uint32_t>{ 4, 2, 0, 3, 1 }));
}
