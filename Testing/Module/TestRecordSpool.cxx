// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBytes.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTRecordSpool.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using Bytes = std::vector<unsigned char>;
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
  for (const vtkMTRecordSpool* tested : { &spool, &other })
  {
    for (std::size_t key = 0; key < 50; ++key)
    {
      std::vector<Bytes> records;
      ASSERT_TRUE(tested->Take(key, records, error));
      EXPECT_EQ(records, expected[key]);
      for (std::size_t place = 0; place < records.size(); ++place)
      {
        Bytes record;
        ASSERT_TRUE(tested->Take(key, place, record, error));
        EXPECT_EQ(record, expected[key][place]);
      }
      Bytes none;
      EXPECT_FALSE(tested->Take(key, records.size(), none, error));
    }
  }
  state.pop_back();
  EXPECT_FALSE(vtkMTRecordSpool().Open(store, "a", state, error));
  std::vector<Bytes> records;
  EXPECT_FALSE(spool.Take(50, records, error));
  EXPECT_GT(store.GetSize(), 1000000u);
  other.Remove();
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
  for (std::size_t size = 4; size < bytes.size(); ++size)
  {
    EXPECT_FALSE(read(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))));
  }
}
