// SPDX-License-Identifier: BSD-3-Clause
#include "MTGatedSource.h"

#include "vtkMTMemoryLimit.h"
#include "vtkMTPatchLoader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>

namespace
{
constexpr std::size_t Plenty = std::size_t(1) << 30;

std::shared_ptr<const vtkMTPatchLoader::Order> MakeOrder(std::vector<std::uint32_t> arcs)
{
  auto order = std::make_shared<vtkMTPatchLoader::Order>();
  order->Arcs = std::move(arcs);
  return order;
}

std::vector<std::uint32_t> AllArcs(const vtkMTPatchSource& source)
{
  std::vector<std::uint32_t> arcs(source.GetGraph().Arcs.size());
  std::iota(arcs.begin(), arcs.end(), 0u);
  return arcs;
}

// A loader with its memory, started.
struct LoaderInUse
{
  explicit LoaderInUse(std::shared_ptr<const vtkMTPatchSource> source, int threads = 1, std::size_t limit = Plenty)
    : Memory(std::make_shared<vtkMTMemoryLimit>(limit))
    , Loader(std::move(source), this->Memory)
  {
    vtkMTPatchLoader::Settings settings;
    settings.Threads = threads;
    std::string error;
    EXPECT_TRUE(this->Loader.Start(settings, error)) << error;
  }

  // All that comes until the loader has nothing to do.
  std::vector<vtkMTPatchLoader::Delivery> Drain()
  {
    std::vector<vtkMTPatchLoader::Delivery> all;
    while (this->Loader.Wait())
    {
      this->Loader.Take(all);
    }
    return all;
  }

  std::shared_ptr<vtkMTMemoryLimit> Memory;
  vtkMTPatchLoader Loader;
};

std::vector<std::uint32_t> ArcsOf(const std::vector<vtkMTPatchLoader::Delivery>& deliveries)
{
  std::vector<std::uint32_t> arcs;
  arcs.reserve(deliveries.size());
  for (const vtkMTPatchLoader::Delivery& delivery : deliveries)
  {
    arcs.push_back(delivery.Arc);
  }
  return arcs;
}

TEST(PatchLoader, DeliversAllThatWasPostedOnce)
{
  for (const int threads : { 1, 2, 3, 8 })
  {
    const auto source = MTGatedSource::MakeTube();
    LoaderInUse use(source, threads);
    use.Loader.Post(MakeOrder(AllArcs(*source)));
    const auto deliveries = use.Drain();
    std::vector<std::uint32_t> arcs = ArcsOf(deliveries);
    std::sort(arcs.begin(), arcs.end());
    EXPECT_EQ(arcs, AllArcs(*source));
    for (const vtkMTPatchLoader::Delivery& delivery : deliveries)
    {
      ASSERT_NE(delivery.Patch, nullptr) << delivery.Error;
      EXPECT_EQ(delivery.Patch->Triangles.size(), source->GetGraph().Arcs[delivery.Arc].Triangles);
      EXPECT_EQ(delivery.Bytes, delivery.Patch->GetMemorySize());
    }
  }
}

TEST(PatchLoader, LoadsInTheOrderOfThePost)
{
  const auto source = MTGatedSource::MakeTube();
  LoaderInUse use(source);
  const std::vector<std::uint32_t> arcs{ 17, 3, 41, 5, 4, 30 };
  use.Loader.Post(MakeOrder(arcs));
  EXPECT_EQ(ArcsOf(use.Drain()), arcs);
}

TEST(PatchLoader, DropsWhatOnlyAPastPostWanted)
{
  const auto source = MTGatedSource::MakeTube();
  source->SetOpen(false);
  LoaderInUse use(source);
  use.Loader.Post(MakeOrder({ 1, 2, 3, 4, 5 }));
  source->AwaitReads(1);
  use.Loader.Post(MakeOrder({ 20, 3, 21 }));
  source->SetOpen(true);
  EXPECT_EQ(ArcsOf(use.Drain()), (std::vector<std::uint32_t>{ 1, 20, 3, 21 }));
}

TEST(PatchLoader, DoesNotReadAgainWhatIsOnItsWay)
{
  const auto source = MTGatedSource::MakeTube();
  source->SetOpen(false);
  LoaderInUse use(source, 2);
  for (int i = 0; i < 5; ++i)
  {
    use.Loader.Post(MakeOrder({ 1, 2 }));
    source->AwaitReads(2);
  }
  source->SetOpen(true);
  std::vector<std::uint32_t> arcs = ArcsOf(use.Drain());
  std::sort(arcs.begin(), arcs.end());
  EXPECT_EQ(arcs, (std::vector<std::uint32_t>{ 1, 2 }));
  EXPECT_EQ(source->GetRead().size(), 2u);
}

// The reads stand still here until the owner has done all its calls: it would never come back if one of them needed a
// lock that is held while a patch is read.
TEST(PatchLoader, OwnerIsNotKeptWaitingByAReadThatHangs)
{
  const auto source = MTGatedSource::MakeTube();
  source->SetOpen(false);
  LoaderInUse use(source, 2);
  use.Loader.Post(MakeOrder({ 1, 2 }));
  source->AwaitReads(2);
  std::vector<vtkMTPatchLoader::Delivery> deliveries;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    use.Loader.Post(MakeOrder({ i % 50, 1, 2, 3 }));
    use.Loader.Take(deliveries);
  }
  EXPECT_TRUE(deliveries.empty());
  std::cout << "longest lock of the owner: " << use.Loader.GetLongestLock() * 1e6 << " microseconds\n";
  source->SetOpen(true);
  EXPECT_FALSE(use.Drain().empty());
}

TEST(PatchLoader, OwnerIsNotKeptWaitingWhileThreadsDecode)
{
  MTTestModel::TubeOptions options;
  options.Rings = 4096;
  options.Regions = 128;
  const auto source = std::make_shared<MTGatedSource>(MTTestModel::MakeTube(options));
  LoaderInUse use(source, 3);
  std::vector<vtkMTPatchLoader::Delivery> deliveries;
  std::vector<std::uint32_t> arcs = AllArcs(*source);
  int posts = 0;
  while (deliveries.size() < source->GetGraph().Arcs.size())
  {
    std::rotate(arcs.begin(), arcs.begin() + 7, arcs.end());
    std::vector<std::uint32_t> missing;
    std::vector<unsigned char> there(arcs.size(), 0);
    for (const vtkMTPatchLoader::Delivery& delivery : deliveries)
    {
      there[delivery.Arc] = 1;
    }
    std::copy_if(arcs.begin(), arcs.end(), std::back_inserter(missing), [&](std::uint32_t a) { return !there[a]; });
    use.Loader.Post(MakeOrder(missing));
    use.Loader.Take(deliveries);
    ++posts;
  }
  std::cout << deliveries.size() << " patches, " << posts
            << " posts, longest lock of the owner: " << use.Loader.GetLongestLock() * 1e6 << " microseconds\n";
}

TEST(PatchLoader, WhatDecodingTakesIsCountedWhileItLasts)
{
  const auto source = MTGatedSource::MakeTube();
  source->DecodeSize = 12345;
  source->SetOpen(false);
  LoaderInUse use(source);
  use.Loader.Post(MakeOrder({ 3 }));
  source->AwaitReads(1);
  const std::size_t patch = vtkMTPatchLoader::GetPatchBytes(source->GetGraph(), 3, {});
  EXPECT_EQ(use.Memory->GetUsed(), patch + source->GetPatchSize(3) + 12345);
  source->SetOpen(true);
  const auto deliveries = use.Drain();
  use.Loader.Stop();
  ASSERT_EQ(deliveries.size(), 1u);
  EXPECT_EQ(use.Memory->GetUsed(), deliveries[0].Bytes);
}

TEST(PatchLoader, MemoryIsNeverExceeded)
{
  const auto source = MTGatedSource::MakeTube();
  source->DecodeSize = 5000;
  std::size_t all = 0;
  std::size_t largest = 0;
  for (const std::uint32_t arc : AllArcs(*source))
  {
    const std::size_t bytes = vtkMTPatchLoader::GetPatchBytes(source->GetGraph(), arc, {});
    all += bytes;
    largest = std::max(largest, bytes + static_cast<std::size_t>(source->GetPatchSize(arc) + source->DecodeSize));
  }
  for (const std::size_t limit : { largest, 2 * largest, all / 2, 2 * all })
  {
    LoaderInUse use(source, 3, limit);
    std::size_t loaded = 0;
    std::vector<std::uint32_t> wanted = AllArcs(*source);
    while (!wanted.empty())
    {
      use.Loader.Post(MakeOrder(wanted));
      const auto deliveries = use.Drain(); // full, or done; dropped at the end of this block
      ASSERT_FALSE(deliveries.empty());
      loaded += deliveries.size();
      for (const vtkMTPatchLoader::Delivery& delivery : deliveries)
      {
        EXPECT_NE(delivery.Patch, nullptr) << delivery.Error;
        wanted.erase(std::find(wanted.begin(), wanted.end(), delivery.Arc));
      }
    }
    EXPECT_EQ(loaded, source->GetGraph().Arcs.size());
    EXPECT_EQ(use.Memory->GetUsed(), 0u);
    std::cout << "limit " << limit << ", most used " << use.Memory->GetMostUsed() << "\n";
    EXPECT_LE(use.Memory->GetMostUsed(), limit);
  }
}

TEST(PatchLoader, PatchThatNeverHasRoomIsAnErrorAndTheOthersCome)
{
  const auto source = MTGatedSource::MakeTube();
  std::map<std::size_t, std::uint32_t> bySize;
  for (const std::uint32_t arc : AllArcs(*source))
  {
    bySize[vtkMTPatchLoader::GetPatchBytes(source->GetGraph(), arc, {})] = arc;
  }
  ASSERT_GT(bySize.rbegin()->first, 2 * bySize.begin()->first);
  LoaderInUse use(source, 1, 2 * bySize.begin()->first + 100);
  use.Loader.Post(MakeOrder({ bySize.rbegin()->second, bySize.begin()->second }));
  const auto deliveries = use.Drain();
  ASSERT_EQ(deliveries.size(), 2u);
  EXPECT_EQ(deliveries[0].Patch, nullptr);
  std::cout << deliveries[0].Error << "\n";
  EXPECT_NE(deliveries[0].Error.find("limit"), std::string::npos);
  EXPECT_NE(deliveries[1].Patch, nullptr);
}

TEST(PatchLoader, FailuresAndExceptionsAreDeliveredAsErrors)
{
  for (const bool near : { false, true })
  {
    const auto source = MTGatedSource::MakeTube();
    source->Near = near;
    source->Broken = { 2 };
    source->Throwing = { 6 };
    LoaderInUse use(source, 2);
    std::vector<std::uint32_t> wanted{ 1, 2, 3, 6, 7, 8 };
    use.Loader.Post(MakeOrder(wanted));
    const auto deliveries = use.Drain();
    EXPECT_EQ(deliveries.size(), wanted.size());
    for (const vtkMTPatchLoader::Delivery& delivery : deliveries)
    {
      if (!delivery.Patch)
      {
        EXPECT_FALSE(delivery.Error.empty());
        EXPECT_NE(delivery.Error.find("patch " + std::to_string(delivery.Arc)), std::string::npos) << delivery.Error;
      }
    }
    const auto failed = [&](std::uint32_t arc)
    {
      return std::any_of(deliveries.begin(), deliveries.end(),
        [arc](const vtkMTPatchLoader::Delivery& d) { return d.Arc == arc && !d.Patch; });
    };
    EXPECT_TRUE(failed(2));
    EXPECT_TRUE(failed(6));
    EXPECT_FALSE(failed(1));
    EXPECT_FALSE(failed(3));
  }
}

TEST(PatchLoader, StopsInTheMiddleAndStartsAgain)
{
  const auto source = MTGatedSource::MakeTube();
  LoaderInUse use(source, 2);
  for (int i = 0; i < 20; ++i)
  {
    use.Loader.Post(MakeOrder(AllArcs(*source)));
    use.Loader.Stop();
    EXPECT_FALSE(use.Loader.IsRunning());
    std::vector<vtkMTPatchLoader::Delivery> deliveries;
    use.Loader.Take(deliveries);
    std::string error;
    ASSERT_TRUE(use.Loader.Start(vtkMTPatchLoader::Settings(), error)) << error;
  }
  use.Loader.Post(MakeOrder({ 5, 6 }));
  EXPECT_EQ(use.Drain().size(), 2u);
  use.Loader.Stop();
  use.Loader.Stop();
  EXPECT_FALSE(use.Loader.Wait());
  EXPECT_EQ(use.Memory->GetUsed(), 0u);
}

TEST(PatchLoader, PatchesOutliveTheLoader)
{
  std::vector<vtkMTPatchLoader::Delivery> deliveries;
  std::weak_ptr<vtkMTMemoryLimit> memory;
  {
    const auto source = MTGatedSource::MakeTube();
    LoaderInUse use(source);
    memory = use.Memory;
    use.Loader.Post(MakeOrder({ 1 }));
    deliveries = use.Drain();
  }
  ASSERT_EQ(deliveries.size(), 1u);
  EXPECT_FALSE(deliveries[0].Patch->Triangles.empty());
  EXPECT_EQ(memory.lock()->GetUsed(), deliveries[0].Bytes);
  deliveries.clear();
  EXPECT_TRUE(memory.expired());
}
}
