// SPDX-License-Identifier: BSD-3-Clause
#include "MTFaultyStore.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTRadixSort.h"
#include "vtkMTRecordSort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace
{
struct Record
{
  std::uint64_t Key;
  std::uint32_t Number;
  std::uint32_t Check;
};

std::vector<Record> MakeRecords(std::size_t count, std::uint64_t keys)
{
  std::mt19937_64 random(7);
  std::vector<Record> records(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    records[i] = { random() % keys, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i * 2654435761u) };
  }
  return records;
}

bool Sort(vtkMTSpoolStore& store, const std::vector<Record>& records, std::size_t memory, std::vector<Record>& sorted,
  std::string& error)
{
  vtkMTRecordSort sort(store, sizeof(Record), memory);
  sorted.clear();
  bool good = true;
  for (std::size_t i = 0; good && i < records.size(); ++i)
  {
    good = sort.Add(&records[i]);
  }
  good = good && sort.Finish();
  while (const unsigned char* bytes = good ? sort.Next() : nullptr)
  {
    sorted.emplace_back();
    std::memcpy(&sorted.back(), bytes, sizeof(Record));
  }
  error = sort.GetError();
  return !sort.HasFailed();
}

void ExpectStablySorted(std::vector<Record> records, const std::vector<Record>& sorted)
{
  std::stable_sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.Key < b.Key; });
  ASSERT_EQ(records.size(), sorted.size());
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    ASSERT_EQ(records[i].Key, sorted[i].Key);
    ASSERT_EQ(records[i].Number, sorted[i].Number);
    ASSERT_EQ(records[i].Check, sorted[i].Check);
  }
}
}

TEST(RecordSort, OrderDoesNotDependOnMemory)
{
  vtkMTMemorySpoolStore store;
  std::string error;
  for (const std::uint64_t keys : { ~std::uint64_t(0), std::uint64_t(1000), std::uint64_t(1) })
  {
    for (const std::size_t count : { 0u, 1u, 511u, 513u, 300000u })
    {
      const std::vector<Record> records = MakeRecords(count, keys);
      for (const std::size_t memory : { vtkMTRecordSort::MinimumMemory, std::size_t(3) << 20, std::size_t(1) << 30 })
      {
        std::vector<Record> sorted;
        ASSERT_TRUE(Sort(store, records, memory, sorted, error)) << error;
        ExpectStablySorted(records, sorted);
      }
    }
  }
  EXPECT_EQ(store.GetSize(), 0u);
  std::printf("most that was spooled: %.1f MB\n", 1e-6 * static_cast<double>(store.GetLargestSize()));
  EXPECT_GT(store.GetLargestSize(), 300000u * sizeof(Record) / 2); // it did not all fit
}

// Few bits that differ, bits far apart, none, and keys that are in order already.
TEST(RecordSort, KeysOfAnyShapeAreSorted)
{
  const std::vector<std::uint64_t> masks = { 0, 1, 0x700, 0xfff, 0x8000000000000001, 0xff000000000000ff, 0x3ff00000fff,
    0xaaaaaaaaaaaaaaaa, ~std::uint64_t(0) };
  for (const std::uint64_t mask : masks)
  {
    for (const std::size_t count : { 0, 1, 2, 500, 1023, 1024, 20000 })
    {
      std::vector<Record> records = MakeRecords(count, ~std::uint64_t(0));
      for (Record& record : records)
      {
        record.Key = (record.Key & mask) | (~mask & 0x123456789abcdef0);
      }
      for (const bool isSorted : { false, true })
      {
        if (isSorted)
        {
          std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.Key < b.Key; });
        }
        vtkMTMemorySpoolStore store;
        std::string error;
        std::vector<Record> sorted;
        ASSERT_TRUE(Sort(store, records, std::size_t(1) << 24, sorted, error)) << error;
        ExpectStablySorted(records, sorted);
      }
    }
  }
}

TEST(RecordSort, ManyMoreRunsThanBuffersAreMergedInSeveralPasses)
{
  // Runs of at most 10922 records, 8 buffers: 1.2 million records need three passes.
  vtkMTMemorySpoolStore store;
  std::string error;
  const std::vector<Record> records = MakeRecords(1200000, 500);
  std::vector<Record> sorted;
  ASSERT_TRUE(Sort(store, records, vtkMTRecordSort::MinimumMemory, sorted, error)) << error;
  ExpectStablySorted(records, sorted);
}

TEST(RecordSort, HoldsNoMoreThanItsMemoryAtAnyTime)
{
  constexpr std::size_t Memory = std::size_t(2) << 20;
  vtkMTMemorySpoolStore store;
  vtkMTRecordSort sort(store, sizeof(Record), Memory);
  std::size_t most = 0;
  const std::vector<Record> records = MakeRecords(500000, 1000000);
  for (const Record& record : records)
  {
    ASSERT_TRUE(sort.Add(&record));
    most = std::max(most, sort.GetMemorySize());
  }
  std::printf("while records are added: %.2f of what is allowed\n", static_cast<double>(most) / Memory);
  EXPECT_LE(most, Memory);
  ASSERT_TRUE(sort.Finish());
  std::size_t mostMerged = 0;
  while (sort.Next())
  {
    mostMerged = std::max(mostMerged, sort.GetMemorySize());
  }
  std::printf("while runs are merged: %.2f of what is allowed\n", static_cast<double>(mostMerged) / Memory);
  EXPECT_LE(mostMerged, Memory);
  EXPECT_EQ(sort.GetMemorySize(), 0u);
}

TEST(RecordSort, EveryFailedWriteAndReadIsReported)
{
  const std::vector<Record> records = MakeRecords(120000, 500);
  std::uint64_t writes = 1;
  std::uint64_t reads = 1;
  for (std::uint64_t i = 0; i < writes + reads; ++i)
  {
    vtkMTMemorySpoolStore memory;
    MTFaultyStore store(memory);
    std::vector<Record> sorted;
    std::string error;
    if (i > 0)
    {
      (i < writes ? store.FailingWrite : store.FailingRead) = i < writes ? i : i - writes;
    }
    EXPECT_EQ(Sort(store, records, vtkMTRecordSort::MinimumMemory, sorted, error), i == 0);
    EXPECT_EQ(error.empty(), i == 0);
    writes = i == 0 ? store.GetNumberOfWrites() : writes;
    reads = i == 0 ? store.GetNumberOfReads() : reads;
  }
  std::printf(
    "%llu writes, %llu reads\n", static_cast<unsigned long long>(writes), static_cast<unsigned long long>(reads));
}

TEST(RadixSort, SortsLikeTheStandardLibrary)
{
  std::mt19937_64 random(3);
  for (const std::size_t count : { 0u, 1u, 511u, 512u, 100000u })
  {
    for (const std::uint64_t mask : { ~std::uint64_t(0), std::uint64_t(0xff00), std::uint64_t(0) })
    {
      std::vector<std::uint64_t> keys(count);
      std::generate(keys.begin(), keys.end(), [&] { return random() & mask; });
      std::vector<std::uint64_t> expected = keys;
      std::sort(expected.begin(), expected.end());
      std::vector<std::uint64_t> scratch;
      vtkMTRadixSort::Sort(keys, scratch);
      EXPECT_EQ(keys, expected);
    }
  }
}
