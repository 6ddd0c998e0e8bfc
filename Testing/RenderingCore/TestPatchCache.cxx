// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"

#include "vtkMTPatchCache.h"
#include "vtkMTPatchSource.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <numeric>
#include <set>
#include <thread>

namespace
{
// Counts what is read and fails where it is told to.
class Source : public vtkMTPatchSource
{
public:
  const vtkMTGraph& GetGraph() const override { return this->Store->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    ++this->Reads;
    if (this->Broken.count(arc))
    {
      error = "broken block";
      return false;
    }
    return this->Store->ReadPatch(arc, arrays, patch, error);
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Store->GetPatchSize(arc); }
  std::string GetName() const override { return "test"; }

  std::shared_ptr<vtkMTPatchStore> Store = MTTestModel::MakeTube();
  std::set<std::uint32_t> Broken;
  mutable std::atomic<int> Reads{ 0 };
};

std::vector<std::uint32_t> AllArcs(const Source& source)
{
  std::vector<std::uint32_t> arcs(source.GetGraph().Arcs.size());
  std::iota(arcs.begin(), arcs.end(), 0u);
  return arcs;
}

TEST(PatchCache, GivesWhatWasRequested)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache cache(source);
  EXPECT_EQ(cache.Get(3), nullptr);
  cache.Request({ 3, 5 });
  for (const std::uint32_t arc : { 3u, 5u })
  {
    const auto patch = cache.Get(arc);
    ASSERT_NE(patch, nullptr);
    EXPECT_EQ(patch->Triangles.size(), source->GetGraph().Arcs[arc].Triangles);
  }
  EXPECT_EQ(cache.Get(4), nullptr);
  EXPECT_EQ(cache.GetNumberOfPatches(), 2u);
}

TEST(PatchCache, ReadsNothingTwice)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache cache(source);
  cache.Request(AllArcs(*source));
  const int reads = source->Reads;
  EXPECT_EQ(static_cast<std::size_t>(reads), source->GetGraph().Arcs.size());
  cache.Request(AllArcs(*source));
  EXPECT_EQ(source->Reads, reads);
}

TEST(PatchCache, LimitHoldsAndTheLongestUnusedGoFirst)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache whole(source);
  whole.Request(AllArcs(*source));
  vtkMTPatchCache cache(source, whole.GetBytes() / 3);
  std::uint32_t last = 0;
  for (const std::uint32_t arc : AllArcs(*source))
  {
    cache.Request({ 0 });
    cache.Request({ arc });
    EXPECT_LE(cache.GetBytes(), cache.GetLimit());
    EXPECT_NE(cache.Get(arc), nullptr);
    last = arc;
  }
  EXPECT_NE(cache.Get(0), nullptr); // asked for all along
  EXPECT_EQ(cache.Get(1), nullptr);
  EXPECT_NE(cache.Get(last), nullptr);
  cache.SetLimit(cache.GetLimit() / 4);
  EXPECT_LE(cache.GetBytes(), cache.GetLimit());
}

TEST(PatchCache, OneRequestDoesNotThrowOutItsOwnPatches)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache whole(source);
  whole.Request(AllArcs(*source));
  vtkMTPatchCache cache(source, whole.GetBytes() / 2);
  const std::vector<std::uint32_t> arcs = AllArcs(*source);
  cache.Request(arcs);
  std::size_t first = 0;
  while (first < arcs.size() && cache.Get(arcs[first]))
  {
    ++first;
  }
  std::cout << first << " of " << arcs.size() << " patches in half of the memory\n";
  EXPECT_GT(first, arcs.size() / 4);
  EXPECT_LE(cache.GetBytes(), cache.GetLimit());
  EXPECT_TRUE(cache.TakeFailures().empty());
}

TEST(PatchCache, PatchInUseOutlivesItsPlace)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache cache(source);
  cache.Request({ 2 });
  const auto patch = cache.Get(2);
  cache.SetLimit(0);
  EXPECT_EQ(cache.Get(2), nullptr);
  EXPECT_EQ(cache.GetBytes(), 0u);
  EXPECT_EQ(patch->Triangles.size(), source->GetGraph().Arcs[2].Triangles);
}

TEST(PatchCache, FailureIsToldOnceAndNotTriedAgainBeforeRetry)
{
  const auto source = std::make_shared<Source>();
  source->Broken = { 4 };
  vtkMTPatchCache cache(source);
  cache.Request({ 3, 4, 5 });
  EXPECT_EQ(cache.Get(4), nullptr);
  EXPECT_NE(cache.Get(5), nullptr);
  const auto failures = cache.TakeFailures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].Arc, 4u);
  EXPECT_EQ(failures[0].What, "broken block");
  const int reads = source->Reads;
  cache.Request({ 4 });
  EXPECT_EQ(source->Reads, reads);
  EXPECT_TRUE(cache.TakeFailures().empty());
  source->Broken.clear();
  cache.Retry();
  cache.Request({ 4 });
  EXPECT_NE(cache.Get(4), nullptr);
}

TEST(PatchCache, PatchLargerThanTheLimitIsAFailureThatSaysSo)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache cache(source, 10);
  cache.Request({ 1 });
  EXPECT_EQ(cache.Get(1), nullptr);
  const auto failures = cache.TakeFailures();
  ASSERT_EQ(failures.size(), 1u);
  std::cout << failures[0].What << "\n";
  EXPECT_NE(failures[0].What.find("limit"), std::string::npos);
}

TEST(PatchCache, OnlyWantedArraysAreRead)
{
  const auto source = std::make_shared<Source>();
  const auto& arrays = source->GetGraph().Arrays;
  ASSERT_EQ(arrays.size(), 3u);
  vtkMTPatchCache cache(source);
  cache.SetArrays({ 0, 0, 0 });
  cache.Request({ 1 });
  ASSERT_NE(cache.Get(1), nullptr);
  EXPECT_TRUE(cache.Get(1)->PointColumns[0].empty());
  cache.SetArrays({ 1, 0, 0 });
  EXPECT_EQ(cache.Get(1), nullptr); // not with that array
  cache.Request({ 1 });
  ASSERT_NE(cache.Get(1), nullptr);
  EXPECT_FALSE(cache.Get(1)->PointColumns[0].empty());
  cache.SetArrays({ 0, 1, 0 });
  cache.Request({ 1 });
  EXPECT_FALSE(cache.Get(1)->PointColumns[0].empty()); // what it had is kept
  EXPECT_FALSE(cache.Get(1)->PointColumns[1].empty());
  cache.SetArrays({ 1, 0, 0 });
  EXPECT_NE(cache.Get(1), nullptr);
}

std::vector<vtkMTPatchCache::Want> Wants(const std::vector<std::uint32_t>& arcs, double priority = 1.0)
{
  std::vector<vtkMTPatchCache::Want> wants;
  for (const std::uint32_t arc : arcs)
  {
    wants.push_back({ arc, priority, true });
    priority *= 0.999;
  }
  return wants;
}

// Looks until nothing more comes, as a view does from frame to frame.
void LookOn(vtkMTPatchCache& cache, const void* view, const std::vector<vtkMTPatchCache::Want>& wants)
{
  cache.SetWants(view, wants);
  for (int idle = 0; idle < 200 && cache.IsLoading(); ++idle)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    idle = cache.Collect() ? 0 : idle;
    cache.SetWants(view, wants);
  }
}

TEST(PatchCache, WhatAViewWantsComesWithoutWaiting)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache cache(source);
  int view = 0;
  LookOn(cache, &view, Wants({ 1, 2, 3 }));
  EXPECT_FALSE(cache.IsLoading());
  for (const std::uint32_t arc : { 1u, 2u, 3u })
  {
    EXPECT_NE(cache.Get(arc), nullptr);
  }
  EXPECT_EQ(source->Reads, 3);
}

TEST(PatchCache, ViewsDoNotPushOutWhatTheOtherWantsMore)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache whole(source);
  whole.Request(AllArcs(*source));
  vtkMTPatchCache cache(source, whole.GetBytes() / 2);
  int first = 0;
  int second = 0;
  LookOn(cache, &first, Wants({ 10, 11, 12 }, 5.0));
  const int before = source->Reads;
  LookOn(cache, &second, Wants(AllArcs(*source), 1.0));
  for (const std::uint32_t arc : { 10u, 11u, 12u })
  {
    EXPECT_NE(cache.Get(arc), nullptr);
  }
  EXPECT_LE(cache.GetMostUsedBytes(), cache.GetLimit());
  std::cout << source->Reads - before << " patches beside the other view's three\n";
  EXPECT_GT(source->Reads, before + 5);
  // Nobody else wants anything: now there is room for the rest of this view, and only as much as before.
  cache.Forget(&first);
  LookOn(cache, &second, Wants(AllArcs(*source), 1.0));
  const int settled = source->Reads;
  LookOn(cache, &second, Wants(AllArcs(*source), 1.0));
  EXPECT_EQ(source->Reads, settled); // no patch pushes out another in turn
}

TEST(PatchCache, LimitHoldsForWhatOthersStillHold)
{
  const auto source = std::make_shared<Source>();
  vtkMTPatchCache whole(source);
  whole.Request(AllArcs(*source));
  vtkMTPatchCache cache(source, whole.GetBytes() / 3);
  std::vector<vtkMTPatchCache::PatchPointer> held;
  for (const std::uint32_t arc : AllArcs(*source))
  {
    cache.Request({ arc });
    if (const auto patch = cache.Get(arc))
    {
      held.push_back(patch);
    }
  }
  std::cout << held.size() << " patches held, most used " << cache.GetMostUsedBytes() << " of " << cache.GetLimit()
            << "\n";
  EXPECT_LT(held.size(), AllArcs(*source).size());
  EXPECT_LE(cache.GetMostUsedBytes(), cache.GetLimit());
  EXPECT_TRUE(cache.TakeFailures().empty());
  held.clear();
  cache.Request({ 40 });
  EXPECT_NE(cache.Get(40), nullptr);
}
}
