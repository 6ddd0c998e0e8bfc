// SPDX-License-Identifier: BSD-3-Clause
// Rice codes in blocks, alone: all numbers come back, however long their codes are, and bytes that end too early or too
// late are refused without a look at what is behind them.
#include "MTTestMeshes.h"

#include "vtkMTRiceCode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>
#include <vector>

namespace
{
using MTTestMeshes::Random;
using vtkMTRiceCode::Coded;
using vtkMTRiceCode::Reader;
constexpr std::size_t NumberOfLists = 3;
using Lists = std::array<std::vector<std::uint32_t>, NumberOfLists>;

// Mostly of so many bits, with some that are much longer, so that unary codes pass every place of a word.
std::vector<std::uint32_t> MakeNumbers(Random& random, std::size_t count)
{
  const unsigned bits = static_cast<unsigned>(random.Below(33));
  const unsigned more = static_cast<unsigned>(random.Below(9));
  const std::uint64_t outliers = 2 + random.Below(60);
  std::vector<std::uint32_t> numbers(count);
  for (std::uint32_t& number : numbers)
  {
    const unsigned most = std::min(32u, random.Below(outliers) == 0 ? bits + more : bits);
    number = static_cast<std::uint32_t>(random.Below(std::uint64_t(1) << most));
  }
  return numbers;
}

// In memory of its own that ends where reading has to.
struct Stored
{
  explicit Stored(const Coded& coded)
    : Parameters(coded.Parameters)
    , Low(coded.Low)
    , Unary(coded.Unary)
    , UnarySize(coded.Unary.size())
  {
    this->Pad();
  }
  void Pad()
  {
    this->Low.resize(this->Low.size() + Reader::Slack, 0xff);
    this->Unary.resize(this->UnarySize + Reader::Slack, 0xff);
    this->Low.shrink_to_fit();
    this->Unary.shrink_to_fit();
  }
  Reader GetReader() const { return Reader(this->Low.data(), this->Unary.data(), this->UnarySize); }

  std::vector<unsigned char> Parameters;
  std::vector<unsigned char> Low;
  std::vector<unsigned char> Unary;
  std::size_t UnarySize;
};

bool Read(const std::vector<Stored>& stored, std::size_t count, Lists& lists)
{
  std::array<Reader, NumberOfLists> readers = { stored[0].GetReader(), stored[1].GetReader(), stored[2].GetReader() };
  for (std::vector<std::uint32_t>& list : lists)
  {
    list.clear();
  }
  for (std::size_t begin = 0; begin < count; begin += vtkMTRiceCode::BlockSize)
  {
    const std::size_t block = begin / vtkMTRiceCode::BlockSize;
    const std::size_t size = std::min(vtkMTRiceCode::BlockSize, count - begin);
    std::uint32_t codes[vtkMTRiceCode::BlockSize][4];
    if (!vtkMTRiceCode::ReadBlock(readers,
          { stored[0].Parameters[block], stored[1].Parameters[block], stored[2].Parameters[block] }, size, codes,
          std::make_index_sequence<NumberOfLists>()))
    {
      return false;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      for (std::size_t l = 0; l < NumberOfLists; ++l)
      {
        lists[l].push_back(codes[i][l]);
      }
    }
  }
  return readers[0].IsAtEnd() && readers[1].IsAtEnd() && readers[2].IsAtEnd();
}

std::vector<Stored> Store(const Lists& lists)
{
  std::vector<Stored> stored;
  for (const std::vector<std::uint32_t>& list : lists)
  {
    stored.emplace_back(vtkMTRiceCode::Encode(list));
  }
  return stored;
}
}

//------------------------------------------------------------------------------
TEST(RiceCode, AllNumbersComeBackWhateverTheirLengths)
{
  Random random(1611);
  std::size_t all = 0;
  std::array<std::size_t, vtkMTRiceCode::MostBits + 1> blocksOf{};
  for (int round = 0; round < 3000; ++round)
  {
    const std::size_t count = random.Below(300);
    const Lists lists = { MakeNumbers(random, count), MakeNumbers(random, count), MakeNumbers(random, count) };
    const std::vector<Stored> stored = Store(lists);
    Lists read;
    ASSERT_TRUE(Read(stored, count, read)) << "round " << round;
    ASSERT_EQ(read, lists) << "round " << round;
    for (const Stored& one : stored)
    {
      for (const unsigned char parameter : one.Parameters)
      {
        ++blocksOf[parameter];
      }
    }
    all += NumberOfLists * count;
  }
  const auto seen = std::count_if(blocksOf.begin(), blocksOf.end(), [](std::size_t blocks) { return blocks > 0; });
  std::printf("%zu numbers; blocks of %td parameters of %zu\n", all, seen, blocksOf.size());
  EXPECT_GE(seen, 30);
}

//------------------------------------------------------------------------------
TEST(RiceCode, UnaryCodesThatEndElsewhereAreRefused)
{
  Random random(1612);
  std::size_t refused = 0;
  const int rounds = 3000;
  for (int round = 0; round < rounds; ++round)
  {
    const std::size_t count = 1 + random.Below(300);
    const Lists lists = { MakeNumbers(random, count), MakeNumbers(random, count), MakeNumbers(random, count) };
    std::vector<Stored> stored = Store(lists);
    Stored& damaged = stored[random.Below(NumberOfLists)];
    // Shorter or longer by some bytes; what is behind the end is ones, which would end codes.
    damaged.Unary.resize(damaged.UnarySize);
    const std::size_t other = 1 + random.Below(12);
    damaged.UnarySize =
      random.Below(2) == 0 ? damaged.UnarySize + other : damaged.UnarySize - std::min(damaged.UnarySize, other);
    damaged.Unary.resize(damaged.UnarySize, 0);
    damaged.Pad();
    Lists read;
    refused += Read(stored, count, read) ? 0 : 1;
  }
  std::printf("%zu of %d refused\n", refused, rounds);
  EXPECT_EQ(refused, static_cast<std::size_t>(rounds));
}
