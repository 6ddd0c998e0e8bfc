// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBytes.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTRecordSpool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>

namespace
{
using Bytes = std::vector<unsigned char>;

Bytes GetBytes(const vtkMTBytes::Record& record)
{
  return Bytes(record.data(), record.data() + record.size());
}
}

TEST(RecordSpool, GivesBackWhatWasPutUnderAKeyInOrder)
{
  vtkMTMemorySpoolStore store;
  vtkMTRecordSpool spool;
  std::string error;
  ASSERT_TRUE(spool.Begin(store, "a", 50, error));
  std::mt19937 random(4);
  std::vector<std::vector<Bytes>> expected(50);
  for (std::size_t i = 0; i < 2000; ++i)
  {
    const std::size_t key = random() % 49;                                  // the last one stays empty
    Bytes record(i % 100 == 7 ? 70000 + random() % 5000 : random() % 5000); // some are not buffered
    for (unsigned char& byte : record)
    {
      byte = static_cast<unsigned char>(random());
    }
    ASSERT_TRUE(spool.Put(key, record.data(), record.size(), error));
    expected[key].push_back(record);
  }
  EXPECT_FALSE(spool.Put(50, nullptr, 0, error));
  EXPECT_FALSE(error.empty());
  ASSERT_TRUE(spool.Seal(error));
  Bytes state;
  spool.Save(state);
  vtkMTRecordSpool other;
  ASSERT_TRUE(other.Open(store, "a", state, error)) << error;
  std::size_t copies = 0;
  for (const vtkMTRecordSpool* tested : { &spool, &other })
  {
    for (std::size_t key = 0; key < 50; ++key)
    {
      std::vector<vtkMTBytes::Record> records;
      ASSERT_TRUE(tested->Take(key, records, error));
      ASSERT_EQ(records.size(), expected[key].size());
      for (std::size_t place = 0; place < records.size(); ++place)
      {
        EXPECT_EQ(GetBytes(records[place]), expected[key][place]);
        vtkMTBytes::Record record;
        ASSERT_TRUE(tested->Take(key, place, record, error));
        EXPECT_EQ(GetBytes(record), expected[key][place]);
        copies += records[place].data() != record.data() ? 1 : 0;
      }
      vtkMTBytes::Record none;
      EXPECT_FALSE(tested->Take(key, records.size(), none, error));
    }
  }
  // Only what lies across two parts of the memory is copied.
  EXPECT_GT(copies, 0u);
  EXPECT_LT(copies, 40u);
  std::cout << copies << " of 4000 records were copied\n";
  state.pop_back();
  EXPECT_FALSE(vtkMTRecordSpool().Open(store, "a", state, error));
  std::vector<vtkMTBytes::Record> records;
  EXPECT_FALSE(spool.Take(50, records, error));
  EXPECT_GT(store.GetSize(), 1000000u);
  other.Remove();
  spool.Remove();
  EXPECT_EQ(store.GetSize(), 0u);
}

TEST(RecordSpool, GivesUpTheMemoryOfWhatIsForgottenAndNothingElse)
{
  constexpr std::size_t Keys = 400;
  vtkMTMemorySpoolStore store;
  vtkMTRecordSpool spool;
  std::string error;
  ASSERT_TRUE(spool.Begin(store, "a", Keys, error));
  std::mt19937 random(5);
  std::vector<Bytes> expected(Keys);
  for (std::size_t key = 0; key < Keys; ++key)
  {
    expected[key].resize(key % 7 == 3 ? random() % 100 : 20000 + random() % 20000);
    for (unsigned char& byte : expected[key])
    {
      byte = static_cast<unsigned char>(random());
    }
    ASSERT_TRUE(spool.Put(key, expected[key].data(), expected[key].size(), error));
  }
  ASSERT_TRUE(spool.Seal(error));
  const std::uint64_t all = store.GetSize();
  std::vector<std::size_t> order(Keys);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t forgotten = 0; forgotten < Keys; ++forgotten)
  {
    if (forgotten % 50 == 0)
    {
      std::cout << forgotten << " of " << Keys << " forgotten: " << 100 * store.GetSize() / all << " % of the bytes\n";
      for (std::size_t i = forgotten; i < Keys; ++i)
      {
        std::vector<vtkMTBytes::Record> records;
        ASSERT_TRUE(spool.Take(order[i], records, error));
        ASSERT_EQ(GetBytes(records[0]), expected[order[i]]);
      }
    }
    spool.Forget(order[forgotten]);
  }
  EXPECT_EQ(store.GetSize(), 0u);
  EXPECT_EQ(store.GetLargestSize(), all);
  spool.Remove();
  EXPECT_EQ(store.GetSize(), 0u);
}

TEST(Bytes, DamagedBytesReadAsNothingAndAreNoticed)
{
  Bytes bytes;
  vtkMTBytes::Writer writer(bytes);
  writer.Put(42);
  writer.PutList(std::vector<double>{ 1.0, 2.0 });
  writer.PutText("text");
  writer.PutCounts({ { "a", 1 }, { "b", 2 } });
  std::map<std::string, std::int64_t> counts;
  std::vector<double> list;
  const auto read = [&](const Bytes& from)
  {
    vtkMTBytes::Reader reader(from);
    EXPECT_LE(reader.Take<int>(), 42);
    reader.TakeList(list);
    reader.TakeText();
    reader.TakeCounts(counts);
    return reader.IsSound() && reader.IsAtEnd();
  };
  EXPECT_TRUE(read(bytes));
  EXPECT_EQ(counts["b"], 2);
  EXPECT_EQ(list[1], 2.0);
  Bytes shifted(1, 0); // to where no double begins
  shifted.insert(shifted.end(), bytes.begin(), bytes.end());
  for (std::size_t shift = 1; shift <= 8; ++shift)
  {
    vtkMTBytes::Reader reader(shifted.data() + shift, bytes.size());
    reader.Take<int>();
    list.clear();
    reader.TakeList(list);
    EXPECT_EQ(list, (std::vector<double>{ 1.0, 2.0 })) << shift;
    shifted.insert(shifted.begin(), 0);
  }
  for (std::size_t size = 4; size < bytes.size(); ++size)
  {
    EXPECT_FALSE(read(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))));
  }
}
