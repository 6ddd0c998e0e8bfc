// SPDX-License-Identifier: BSD-3-Clause
// The memory plan: shares within the limit, and refusals whose advice holds when it is taken at its word.
#include "vtkMTMemoryPlan.h"

#include "vtkMTWorkSettings.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace
{
constexpr std::uint64_t MiB = std::uint64_t(1) << 20;

vtkMTMemoryPlan::Needs MakeNeeds()
{
  const double mebibyte = static_cast<double>(MiB);
  return { 40.3 * mebibyte, 25.4 * mebibyte, 12.2 * mebibyte, 500.0 * mebibyte, 900.0 * mebibyte };
}

// As a person reads it: "... too small for this input: 162 MiB is the least that would do".
std::uint64_t ReadAdvice(const std::string& message)
{
  const std::string before = "small for this input: ";
  const std::size_t begin = message.find(before);
  EXPECT_NE(begin, std::string::npos) << message;
  std::size_t length = 0;
  const std::string text = begin == std::string::npos ? "0 MiB" : message.substr(begin + before.size());
  const double number = std::stod(text, &length);
  return static_cast<std::uint64_t>(
    number * static_cast<double>(text.compare(length, 4, " MiB") == 0 ? MiB : 1024 * MiB));
}
}

TEST(MemoryPlan, SharesStayWithinTheLimitAndLargerLimitsGiveMore)
{
  const vtkMTMemoryPlan plan(MakeNeeds());
  const auto standing = static_cast<std::uint64_t>(MakeNeeds().Standing);
  std::size_t last = 0;
  for (std::uint64_t limit = plan.GetLeast(); limit < 3000 * MiB; limit += 37 * MiB)
  {
    vtkMTWorkSettings settings;
    std::string error;
    ASSERT_TRUE(plan.Apply(limit, settings, error)) << error;
    EXPECT_EQ(settings.MemoryLimit, limit);
    EXPECT_GE(settings.SortMemory, 16 * MiB);
    EXPECT_GE(settings.SortMemory, last);
    EXPECT_LE(settings.SortMemory, static_cast<std::size_t>(MakeNeeds().Sorts));
    EXPECT_LE(standing + settings.WorkMemory, limit);
    EXPECT_LE(standing + settings.SortMemory + settings.BlockMemory, limit + 13 * MiB)
      << "blocks' standing share twice";
    EXPECT_GE(settings.WorkMemory, static_cast<std::uint64_t>(MakeNeeds().Work));
    last = settings.SortMemory;
  }
  EXPECT_EQ(last, static_cast<std::size_t>(MakeNeeds().Sorts));
}

TEST(MemoryPlan, NoLimitMeansNone)
{
  vtkMTWorkSettings settings;
  std::string error;
  ASSERT_TRUE(vtkMTMemoryPlan(MakeNeeds()).Apply(0, settings, error));
  EXPECT_EQ(settings.MemoryLimit, 0u);
  EXPECT_EQ(settings.WorkMemory, 0u);
  EXPECT_EQ(settings.BlockMemory, 0u);
  EXPECT_EQ(settings.SortMemory, static_cast<std::size_t>(MakeNeeds().Sorts));
}

TEST(MemoryPlan, LimitOfTheBuilderThatTheRefusalNamesIsAccepted)
{
  const vtkMTMemoryPlan plan(MakeNeeds());
  vtkMTWorkSettings settings;
  std::string error;
  ASSERT_FALSE(plan.Apply(plan.GetLeast() - 1, settings, error));
  const std::uint64_t named = ReadAdvice(error);
  EXPECT_LE(named, plan.GetLeast() + MiB);
  EXPECT_TRUE(plan.Apply(named, settings, error)) << error;
}

TEST(MemoryPlan, LimitOfTheProcessThatTheRefusalNamesIsAcceptedWithWhateverIsResidentNext)
{
  const vtkMTMemoryPlan plan(MakeNeeds());
  std::size_t pairs = 0;
  for (std::uint64_t first = 5 * MiB; first < 5000 * MiB; first += first / 7)
  {
    std::uint64_t left = 0;
    std::string error;
    ASSERT_FALSE(plan.Divide(64 * MiB, first, left, error));
    const std::uint64_t named = ReadAdvice(error);
    EXPECT_LE(named,
      vtkMTMemoryPlan::GetBase(first) + plan.GetLeast() + vtkMTMemoryPlan::GetVariation(first) +
        (named < 1024 * MiB ? MiB : 103 * MiB));
    for (const std::int64_t more : { -40, -3, 0, 2, 7 })
    {
      const auto second = static_cast<std::uint64_t>(static_cast<std::int64_t>(first) + more * std::int64_t(MiB));
      if (static_cast<std::int64_t>(second) > 0)
      {
        EXPECT_TRUE(plan.Divide(named, second, left, error)) << first << " then " << second << ": " << error;
        EXPECT_GE(left, plan.GetLeast());
        EXPECT_LE(vtkMTMemoryPlan::GetBase(second) + left, named);
        ++pairs;
      }
    }
  }
  std::printf("%zu pairs of resident sizes\n", pairs);
}

TEST(MemoryPlan, SmallProcessesCountAsOneOfTheSameSize)
{
  const vtkMTMemoryPlan plan(MakeNeeds());
  std::string first;
  std::string second;
  std::uint64_t left = 0;
  EXPECT_FALSE(plan.Divide(MiB, 9 * MiB, left, first));
  EXPECT_FALSE(plan.Divide(MiB, 57 * MiB, left, second));
  EXPECT_EQ(first, second);
  EXPECT_EQ(vtkMTMemoryPlan::GetBase(0), vtkMTMemoryPlan::LeastBase);
  EXPECT_GT(vtkMTMemoryPlan::GetBase(500 * MiB), 500 * MiB);
}

TEST(MemoryPlan, WholeIsWhatHoldsSpoolsAndSortsAsWell)
{
  const vtkMTMemoryPlan plan(MakeNeeds());
  const std::uint64_t whole =
    vtkMTMemoryPlan::LeastBase + plan.GetLeast() + plan.GetSpoolSize() + plan.GetSortMemory(0);
  EXPECT_FALSE(plan.IsWhole(whole - 1, 0));
  EXPECT_TRUE(plan.IsWhole(whole, 0));
  EXPECT_FALSE(plan.IsWhole(whole, 200 * MiB));
}

TEST(MemoryPlan, ImpossibleNeedsAreFinite)
{
  const vtkMTMemoryPlan plan({ 1e30, 1e40, 1e20, 1e300, 1e25 });
  EXPECT_EQ(plan.GetSpoolSize(), std::uint64_t(1) << 60);
  EXPECT_EQ(plan.GetSortMemory(0), std::size_t(1) << 60);
  std::uint64_t left = 0;
  std::string error;
  EXPECT_FALSE(plan.Divide(std::uint64_t(1) << 59, 100 * MiB, left, error));
  EXPECT_FALSE(plan.IsWhole(std::uint64_t(1) << 61, 100 * MiB));
}

TEST(MemoryPlan, TextIsRoundedUp)
{
  EXPECT_EQ(vtkMTMemoryPlan::ToText(1), "1 MiB");
  EXPECT_EQ(vtkMTMemoryPlan::ToText(160 * MiB), "160 MiB");
  EXPECT_EQ(vtkMTMemoryPlan::ToText(160 * MiB + 1), "161 MiB");
  EXPECT_EQ(vtkMTMemoryPlan::ToText((std::uint64_t(3) << 29) + 1), "1.6 GiB");
}
