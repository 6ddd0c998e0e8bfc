// SPDX-License-Identifier: BSD-3-Clause
// Ordered work: results in order, errors of the smallest index, costs within the budget, whatever the threads.
#include "vtkMTOrderedWork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

TEST(OrderedWork, NoMoreIsWorkedOnThanTheBudgetAllows)
{
  // Costs from 1 to 200 in a budget of 100: what is larger comes alone.
  vtkMTOrderedWork::Budget budget;
  budget.Memory = 100;
  budget.Cost = [](std::size_t i) { return 1 + i * 37 % 200; };
  std::atomic<std::uint64_t> atWork{ 0 };
  std::atomic<std::uint64_t> most{ 0 };
  std::atomic<std::uint64_t> tooMuch{ 0 };
  std::string error;
  const auto work = [&](std::size_t i, std::size_t, std::string&)
  {
    const std::uint64_t now = atWork += budget.Cost(i);
    tooMuch += now > budget.Memory && now != budget.Cost(i) ? 1 : 0;
    most = std::max<std::uint64_t>(most, now);
    return true;
  };
  const auto take = [&](std::size_t i, std::size_t, std::string&)
  {
    atWork -= budget.Cost(i);
    return true;
  };
  ASSERT_TRUE(vtkMTOrderedWork::Run(5000, 4, budget, work, take, error)) << error;
  std::printf("at most %llu of %llu at work\n", static_cast<unsigned long long>(most.load()),
    static_cast<unsigned long long>(budget.Memory));
  EXPECT_EQ(tooMuch, 0u);
  EXPECT_EQ(atWork, 0u);
}

TEST(OrderedWork, ResultsAreTakenInOrderAndTheFirstFailureIsReported)
{
  for (const int threads : { 1, 2, 5 })
  {
    std::vector<std::size_t> fetched;
    std::vector<std::size_t> slots(vtkMTOrderedWork::GetNumberOfSlots(threads));
    std::vector<std::size_t> taken;
    std::string error;
    const auto fetch = [&](std::size_t i, std::size_t, std::string&)
    {
      fetched.push_back(i); // one at a time
      return true;
    };
    const auto work = [&](std::size_t i, std::size_t slot, std::string&)
    {
      slots[slot] = i * i;
      return true;
    };
    const auto take = [&](std::size_t i, std::size_t slot, std::string&)
    {
      EXPECT_EQ(slots[slot], i * i);
      taken.push_back(i);
      return true;
    };
    ASSERT_TRUE(vtkMTOrderedWork::Run(1000, threads, fetch, work, take, error)) << error;
    ASSERT_EQ(taken.size(), 1000u);
    EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
    EXPECT_EQ(fetched, taken);

    const auto fail = [](std::size_t i, std::size_t, std::string& message)
    {
      message = "failure " + std::to_string(i);
      if (i == 700)
      {
        throw std::runtime_error("thrown");
      }
      return i < 500;
    };
    taken.clear();
    EXPECT_FALSE(vtkMTOrderedWork::Run(
      1000, threads, fail,
      [&](std::size_t i, std::size_t, std::string&)
      {
        taken.push_back(i);
        return true;
      },
      error));
    EXPECT_EQ(error, "failure 500");
    EXPECT_EQ(taken.size(), 500u);
  }
}
