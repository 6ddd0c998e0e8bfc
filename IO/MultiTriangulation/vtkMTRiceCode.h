// SPDX-License-Identifier: BSD-3-Clause
/**
 * Small numbers as Rice codes (Rice and Plaunt, "Adaptive variable-length coding", 1971) in blocks. Not installed.
 *
 * A code of parameter k is its value above the k lowest bits in unary, so many zeros and a one, and these k bits. The
 * two parts are in lists of their own: where the k bits are is known at once, and only the ends of the unary codes have
 * to be found one after the other. Several lists are read side by side, as each waits for its own ends alone.
 */
#ifndef vtkMTRiceCode_h
#define vtkMTRiceCode_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace vtkMTRiceCode
{
constexpr std::size_t BlockSize = 64;
constexpr unsigned MostBits = 32; // the largest parameter

inline std::size_t GetNumberOfBlocks(std::size_t codes)
{
  return (codes + BlockSize - 1) / BlockSize;
}
/// Bytes of the low bits of `codes` codes of a block; those of a whole block are a whole number of bytes.
inline std::size_t GetLowSize(std::size_t codes, unsigned parameter)
{
  return (codes * parameter + 7) / 8;
}

struct Coded
{
  std::vector<unsigned char> Parameters; ///< of each block, the one that takes the fewest bits
  std::vector<unsigned char> Low;
  std::vector<unsigned char> Unary;
};

/// mostBits: the largest parameter to be used. head: so many codes have blocks of their own, before the others'.
Coded Encode(const std::vector<std::uint32_t>& codes, unsigned mostBits = MostBits, std::size_t head = 0);

/// Block after block of such a list.
class Reader
{
public:
  /// So many bytes behind the ends of both parts can be read.
  static constexpr std::size_t Slack = 8;

  Reader() = default;
  Reader(const unsigned char* low, const unsigned char* unary, std::size_t unarySize)
    : Low(low)
    , Next(unary)
    , End(unary + unarySize)
  {
  }

  /// The low bits of code `i` of the block and some that follow, LoadedBits at least.
  std::uint64_t LoadLow(std::size_t i, unsigned k) const { return Load(this->Low + i * k / 8) >> (i * k % 8); }
  static constexpr unsigned LoadedBits = 57;

  /// What the next code has above its low bits; false when the unary codes have ended.
  bool GetHigh(std::uint64_t& high)
  {
    while (__builtin_expect(this->Word == 0, 0))
    {
      if (this->Next >= this->End)
      {
        return false;
      }
      this->LoadWord();
    }
    const std::int64_t one = __builtin_ctzll(this->Word);
    this->Word &= this->Word - 1;
    high = static_cast<std::uint64_t>(one - this->At);
    this->At = one + 1;
    return true;
  }
  void GoToNextBlock(std::size_t codes, unsigned k) { this->Low += GetLowSize(codes, k); }

  /// Whether nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    return this->Word == 0 && this->Next >= this->End && (this->End - this->Next + 8) * 8 - this->At < 8;
  }

private:
  static std::uint64_t Load(const unsigned char* bytes)
  {
    std::uint64_t bits;
    std::memcpy(&bits, bytes, sizeof(bits));
    return bits;
  }
  void LoadWord()
  {
    this->Word = Load(this->Next);
    const std::ptrdiff_t left = this->End - this->Next;
    this->Word = left < 8 ? this->Word & ((std::uint64_t(1) << (8 * left)) - 1) : this->Word;
    this->Next += 8;
    this->At -= 64;
  }

  const unsigned char* Low = nullptr;
  const unsigned char* Next = nullptr; // behind the present word
  const unsigned char* End = nullptr;
  std::uint64_t Word = 0; // its ones that end codes which were not read yet
  std::int64_t At = 64;   // the bit behind the last code that was read, counted from the word's first one
};

/// As many of the next codes of some lists as are a multiple of Group, from code i on; see ReadBlock.
template <std::size_t Group, std::size_t Width, std::size_t... L>
bool ReadGroups(std::array<Reader, sizeof...(L)>& readers, const std::array<unsigned, sizeof...(L)>& parameters,
  std::size_t& i, std::size_t count, std::uint32_t (*codes)[Width], std::index_sequence<L...> /* lists */)
{
  std::array<Reader, sizeof...(L)> local = readers; // in registers
  const std::array<std::uint64_t, sizeof...(L)> masks = { (std::uint64_t(1) << parameters[L]) - 1 ... };
  for (; i + Group <= count; i += Group)
  {
    std::array<std::uint64_t, sizeof...(L)> low = { local[L].LoadLow(i, parameters[L])... };
    for (std::size_t g = 0; g < Group; ++g)
    {
      std::array<std::uint64_t, sizeof...(L)> high{};
      if (!(local[L].GetHigh(high[L]) && ...))
      {
        return false;
      }
      ((codes[i + g][L] = static_cast<std::uint32_t>((high[L] << parameters[L]) | (low[L] & masks[L]))), ...);
      ((low[L] >>= parameters[L]), ...);
    }
  }
  readers = local;
  return true;
}

/// The next block of each of some lists: puts code i of list l, of which there are `count` in each, to codes[i][l].
/// False when the unary codes of one have ended.
template <std::size_t Width, std::size_t... L>
bool ReadBlock(std::array<Reader, sizeof...(L)>& readers, const std::array<unsigned, sizeof...(L)>& parameters,
  std::size_t count, std::uint32_t (*codes)[Width], std::index_sequence<L...> lists)
{
  std::size_t i = 0;
  const unsigned most = std::max({ parameters[L]... });
  if ((4 * most <= Reader::LoadedBits && !ReadGroups<4>(readers, parameters, i, count, codes, lists)) ||
    !ReadGroups<1>(readers, parameters, i, count, codes, lists))
  {
    return false;
  }
  (readers[L].GoToNextBlock(count, parameters[L]), ...);
  return true;
}
}

#endif
