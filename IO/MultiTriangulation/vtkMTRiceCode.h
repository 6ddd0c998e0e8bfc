// SPDX-License-Identifier: BSD-3-Clause
/**
 * Small numbers as Rice codes (Rice and Plaunt, "Adaptive variable-length coding", 1971) in blocks. Not installed.
 *
 * A code of parameter k is its value above the k lowest bits in unary, so many zeros and a one, and these k bits. The
 * two parts are in lists of their own: where the k bits are is known at once, and only the ends of the unary codes have
 * to be found one after the other. Eight codes are taken from a window of 56 bits without a branch, those of several
 * lists side by side, as each waits for its own ends alone; codes that are longer are read one by one.
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
  /// So many codes are read together.
  static constexpr std::size_t GroupSize = 8;

  Reader() = default;
  Reader(const unsigned char* low, const unsigned char* unary, std::size_t unarySize)
    : Low(low)
    , Unary(unary)
    , End(8 * unarySize)
  {
  }

  /// The next codes of a block, from `first` on, which is a multiple of GroupSize, and as many at most: to codes[0],
  /// codes[width] and so on. False when the unary codes have ended; what was found may be wrong when they end here.
  bool Get(std::size_t first, std::size_t count, unsigned k, std::uint32_t* codes, std::size_t width)
  {
    return count == GroupSize ? this->GetGroup(first, k, codes, width)
                              : this->GetOneByOne(first, count, k, codes, width);
  }
  void GoToNextBlock(std::size_t codes, unsigned k) { this->Low += GetLowSize(codes, k); }

  /// Whether nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    return this->At <= this->End && this->End - this->At < 8 &&
      (this->At == this->End || this->Unary[this->At / 8] >> this->At % 8 == 0);
  }

private:
  static constexpr std::size_t LoadedBits = 57; // at least, from any bit on
  static constexpr unsigned CertainBits = 64 - GroupSize;

  bool GetGroup(std::size_t first, unsigned k, std::uint32_t* codes, std::size_t width)
  {
    if (this->At > this->End)
    {
      return false;
    }
    // Behind the bits that are certain are as many ones as codes, so that as many are found.
    std::uint64_t ones = Load(this->Unary + this->At / 8) >> this->At % 8 | ~std::uint64_t(0) << CertainBits;
    const unsigned char* const low = this->Low + first / GroupSize * k;
    const unsigned end = 4 * k <= 60 ? GetGroup<4>(ones, low, k, codes, width)
      : 2 * k <= LoadedBits          ? GetGroup<2>(ones, low, k, codes, width)
                                     : GetGroup<1>(ones, low, k, codes, width);
    if (__builtin_expect(end > CertainBits, 0))
    {
      return this->GetOneByOne(first, GroupSize, k, codes, width);
    }
    this->At += end;
    return true;
  }
  bool GetOneByOne(std::size_t first, std::size_t count, unsigned k, std::uint32_t* codes, std::size_t width)
  {
    for (std::size_t i = first; i < first + count; ++i, codes += width)
    {
      std::uint64_t high = 0;
      if (!this->GetHigh(high))
      {
        return false;
      }
      *codes = static_cast<std::uint32_t>(high << k | (Load(this->Low + i * k / 8) >> i * k % 8 & GetMask(k)));
    }
    return true;
  }

  static std::uint64_t Load(const unsigned char* bytes)
  {
    std::uint64_t bits;
    std::memcpy(&bits, bytes, sizeof(bits));
    return bits;
  }
  static std::uint64_t GetMask(unsigned k) { return (std::uint64_t(1) << k) - 1; }

  // ones: the ends of the codes. So many have their low bits loaded together. Returns where the last one ends. A
  // function of its own, so that there are registers for all of it.
  template <std::size_t Together>
  [[gnu::noinline]] static unsigned GetGroup(
    std::uint64_t ones, const unsigned char* low, unsigned k, std::uint32_t* codes, std::size_t width)
  {
    unsigned begin = 0;
    for (std::size_t i = 0; i < GroupSize; i += Together)
    {
      std::uint64_t bits = Load(low + i * k / 8) >> i * k % 8;
      for (std::size_t j = 0; j < Together; ++j, codes += width)
      {
        const auto one = static_cast<unsigned>(__builtin_ctzll(ones));
        ones &= ones - 1;
        *codes = (one - begin) << k | static_cast<std::uint32_t>(bits & GetMask(k));
        bits >>= k;
        begin = one + 1;
      }
    }
    return begin;
  }

  // What the next code has above its low bits; false when the unary codes have ended.
  bool GetHigh(std::uint64_t& high)
  {
    for (; this->At < this->End; this->At += LoadedBits, high += LoadedBits)
    {
      const std::uint64_t ones =
        Load(this->Unary + this->At / 8) >> this->At % 8 & (~std::uint64_t(0) >> (64 - LoadedBits));
      if (ones != 0)
      {
        const auto one = static_cast<unsigned>(__builtin_ctzll(ones));
        high += one;
        this->At += one + 1;
        return this->At <= this->End;
      }
    }
    return false;
  }

  const unsigned char* Low = nullptr; // of the present block
  const unsigned char* Unary = nullptr;
  std::size_t At = 0;  // the bit behind the last code that was read
  std::size_t End = 0; // of the bits
};

/// The codes from `first` on of a block of `count`, at most Reader::GroupSize, of each of some lists: puts code i of
/// list l, counted from the first of them, to codes[i][l]. Groups follow each other; after the last one the readers are
/// at the next block. False when the unary codes of one have ended.
template <std::size_t Width, std::size_t... L>
bool ReadGroup(std::array<Reader, sizeof...(L)>& readers, const std::array<unsigned, sizeof...(L)>& parameters,
  std::size_t first, std::size_t count, std::uint32_t (*codes)[Width], std::index_sequence<L...> /* lists */)
{
  const std::size_t size = std::min(count - first, Reader::GroupSize);
  if (!(readers[L].Get(first, size, parameters[L], codes[0] + L, Width) && ...))
  {
    return false;
  }
  if (first + size == count)
  {
    (readers[L].GoToNextBlock(count, parameters[L]), ...);
  }
  return true;
}

/// The next block of each of some lists: puts code i of list l, of which there are `count` in each, to codes[i][l].
template <std::size_t Width, std::size_t... L>
bool ReadBlock(std::array<Reader, sizeof...(L)>& readers, const std::array<unsigned, sizeof...(L)>& parameters,
  std::size_t count, std::uint32_t (*codes)[Width], std::index_sequence<L...> lists)
{
  std::size_t i = 0;
  while (i < count && ReadGroup(readers, parameters, i, count, codes + i, lists))
  {
    i += Reader::GroupSize;
  }
  return i >= count;
}
}

#endif
