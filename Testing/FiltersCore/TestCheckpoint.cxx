// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint comes back whole from a store that lasts, or is an error; nothing in between.
#include "vtkMTCheckpoint.h"

#include "vtkMTMemorySpoolStore.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
// As one on disk, for the time of a test.
class LastingStore : public vtkMTMemorySpoolStore
{
public:
  bool IsLasting() const override { return true; }
  bool Commit(const std::vector<unsigned char>& state, std::string& error) override
  {
    error = this->Fails ? "the disk is full" : error;
    this->Bytes = this->Fails ? this->Bytes : state;
    return !this->Fails;
  }
  bool Restore(std::vector<unsigned char>& state, std::string& error) override
  {
    error = this->Fails ? "the disk is gone" : error;
    state = this->Bytes;
    return !this->Fails;
  }

  std::vector<unsigned char> Bytes;
  bool Fails = false;
};

vtkMTCheckpoint MakeCheckpoint()
{
  vtkMTCheckpoint checkpoint;
  checkpoint.Identity = "sphere.ply; 20 triangles";
  checkpoint.State = { 1, 2, 3, 0, 255 };
  checkpoint.Sink = { 9 };
  return checkpoint;
}
}

TEST(Checkpoint, ReadGivesBackWhatWasWritten)
{
  LastingStore store;
  std::string error;
  ASSERT_TRUE(MakeCheckpoint().Write(store, error)) << error;
  vtkMTCheckpoint read;
  ASSERT_TRUE(read.Read(store, error)) << error;
  EXPECT_FALSE(read.IsEmpty());
  EXPECT_EQ(read.Identity, "sphere.ply; 20 triangles");
  EXPECT_EQ(read.State, MakeCheckpoint().State);
  EXPECT_EQ(read.Sink, MakeCheckpoint().Sink);
}

TEST(Checkpoint, StoreWithoutOneGivesAnEmptyOne)
{
  LastingStore store;
  vtkMTCheckpoint read = MakeCheckpoint();
  std::string error;
  EXPECT_TRUE(read.Read(store, error)) << error;
  EXPECT_TRUE(read.IsEmpty());
  EXPECT_TRUE(read.Identity.empty());
}

TEST(Checkpoint, FailuresOfTheStoreAreReported)
{
  LastingStore store;
  store.Fails = true;
  std::string error;
  EXPECT_FALSE(MakeCheckpoint().Write(store, error));
  EXPECT_EQ(error, "the disk is full");
  vtkMTCheckpoint read;
  EXPECT_FALSE(read.Read(store, error));
  EXPECT_EQ(error, "the disk is gone");
}

TEST(Checkpoint, BytesOfAnotherVersionOrLengthAreErrors)
{
  LastingStore store;
  std::string error;
  ASSERT_TRUE(MakeCheckpoint().Write(store, error)) << error;
  const std::vector<unsigned char> whole = store.Bytes;
  std::size_t refused = 0;
  for (std::size_t size = 1; size <= whole.size() + 1; ++size)
  {
    store.Bytes = whole;
    store.Bytes.resize(size);
    vtkMTCheckpoint read;
    error.clear();
    const bool isRead = read.Read(store, error);
    EXPECT_EQ(isRead, size == whole.size()) << size;
    EXPECT_EQ(isRead, error.empty());
    EXPECT_EQ(isRead, !read.IsEmpty());
    refused += isRead ? 0 : 1;
  }
  store.Bytes = whole;
  store.Bytes[0] ^= 1;
  vtkMTCheckpoint read;
  EXPECT_FALSE(read.Read(store, error));
  EXPECT_NE(error.find("another version"), std::string::npos) << error;
  std::printf("%zu lengths refused\n", refused);
}
