// SPDX-License-Identifier: BSD-3-Clause
#include "MTIOTest.h"
#include "vtkMTFileSpoolStore.h"

#include <gtest/gtest.h>

namespace
{
using namespace MTIOTest;

std::string ReadAll(const vtkMTSpool& spool)
{
  std::string text(static_cast<std::size_t>(spool.GetSize()), ' ');
  std::string error;
  EXPECT_TRUE(spool.Read(0, text.size(), &text[0], error)) << error;
  return text;
}

bool Append(vtkMTSpool& spool, const std::string& text)
{
  std::string error;
  return spool.Append(text.data(), text.size(), error);
}

Bytes ToBytes(const std::string& text)
{
  return Bytes(text.begin(), text.end());
}
}

TEST(FileSpoolStore, GoesOnFromItsLastCommit)
{
  const Folder folder;
  std::string error;
  Bytes state;
  {
    vtkMTFileSpoolStore store;
    ASSERT_TRUE(store.OpenFolder(folder / "work", error)) << error;
    ASSERT_TRUE(store.Restore(state, error));
    EXPECT_TRUE(state.empty());
    auto kept = store.Create("kept", error);
    auto removed = store.Create("removed", error);
    ASSERT_TRUE(Append(*kept, "one") && Append(*removed, "two"));
    ASSERT_TRUE(store.Commit(ToBytes("first"), error)) << error;
    // After the commit: more bytes, a file removed, a file made.
    ASSERT_TRUE(Append(*kept, " and more"));
    store.Remove("removed");
    auto made = store.Create("made", error);
    ASSERT_TRUE(Append(*made, "three"));
    EXPECT_EQ(store.GetSize(), 20u); // the one that is removed is still open
  }
  EXPECT_TRUE(vtkMTFileSpoolStore::HasState(folder / "work"));
  vtkMTFileSpoolStore store;
  ASSERT_TRUE(store.OpenFolder(folder / "work", error)) << error;
  ASSERT_TRUE(store.Restore(state, error)) << error;
  EXPECT_EQ(state, ToBytes("first"));
  const auto kept = store.Open("kept", 3, error);
  const auto removed = store.Open("removed", 3, error);
  ASSERT_TRUE(kept && removed) << error;
  EXPECT_EQ(ReadAll(*kept), "one");
  EXPECT_EQ(ReadAll(*removed), "two");
  EXPECT_FALSE(store.Open("made", 5, error)) << "what came after the commit is gone";
  EXPECT_FALSE(error.empty());
  EXPECT_TRUE(Append(*kept, "!"));
  EXPECT_EQ(ReadAll(*kept), "one!");
  store.Clear();
  EXPECT_TRUE(folder.List().empty());
}

TEST(FileSpoolStore, LeavesNothingWhenNothingCanBeResumed)
{
  const Folder folder;
  std::string error;
  {
    vtkMTFileSpoolStore store;
    ASSERT_TRUE(store.OpenFolder(folder / "work", error)) << error;
    auto nameless = store.Create(error);
    auto named = store.Create("named", error);
    ASSERT_TRUE(Append(*nameless, "x") && Append(*named, "y"));
    EXPECT_EQ(store.GetSize(), 2u);
    EXPECT_FALSE(store.Create("named", error));
    std::vector<char> much(10);
    EXPECT_FALSE(named->Read(0, 2, much.data(), error));
  }
  EXPECT_TRUE(folder.List().empty());
}

TEST(FileSpoolStore, DamagedStateIsAnErrorAndASecondProcessIsKeptOut)
{
  const Folder folder;
  std::string error;
  Bytes state;
  {
    vtkMTFileSpoolStore store;
    ASSERT_TRUE(store.OpenFolder(folder / "work", error)) << error;
    auto named = store.Create("named", error);
    ASSERT_TRUE(store.Commit(ToBytes("state"), error)) << error;
    vtkMTFileSpoolStore second;
    EXPECT_FALSE(second.OpenFolder(folder / "work", error));
    EXPECT_NE(error.find("another build"), std::string::npos) << error;
  }
  const Bytes good = ReadFile(folder / "work/state");
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    Bytes bad = good;
    bad[i] ^= 0x10;
    WriteFile(folder / "work/state", bad);
    vtkMTFileSpoolStore store;
    ASSERT_TRUE(store.OpenFolder(folder / "work", error)) << error;
    EXPECT_FALSE(store.Restore(state, error)) << "byte " << i;
  }
}

TEST(FileSpoolStore, FolderThatCannotBeUsedIsAClearError)
{
  const Folder folder;
  std::string error;
  vtkMTFileSpoolStore store;
  EXPECT_FALSE(store.OpenFolder(folder / "missing/work", error));
  EXPECT_NE(error.find("cannot be made"), std::string::npos) << error;
  WriteFile(folder / "file", std::string("x"));
  EXPECT_FALSE(store.OpenFolder(folder / "file", error));
  EXPECT_FALSE(error.empty());
}
