// SPDX-License-Identifier: BSD-3-Clause
/**
 * Small numbers as Rice codes (Rice and Plaunt, "Adaptive variable-length coding", 1971) in blocks. Not installed.
 *
 * A code of parameter k is its value above the k lowest bits in unary, so many zeros and a one, and these k bits. The
 * two parts are in lists of their own: where the k bits are is known at once, and the ends of the unary codes are found
 * one per clock cycle, so many are decoded in the time that a code needs whose beginning waits for the end of the one
 * before.
 */
#ifndef vtkMTRiceCode_h
#define vtkMTRiceCode_h

#include <array>
#include <cstddef>
#include <cstdint>
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

/// mostBits: the largest parameter to be used.
Coded Encode(const std::vector<std::uint32_t>& codes, unsigned mostBits = MostBits);

/// Block after block of such a list.
class Reader
{
public:
  Reader() = default;
  /// low must have LowSlack bytes behind its end that can be read.
  Reader(const unsigned char* low, const unsigned char* unary, std::size_t unarySize)
    : Low(low)
    , Unary(unary)
    , UnarySize(unarySize)
  {
  }
  static constexpr std::size_t LowSlack = 8;

  /// Puts `count` codes, at most BlockSize, to codes[0], codes[stride] and so on. False when the unary codes have
  /// ended.
  bool Read(unsigned parameter, std::size_t count, std::uint32_t* codes, std::size_t stride);

  /// Whether nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    return this->Word == 0 && this->WordEnd >= this->UnarySize && (this->LastEnd + 7) / 8 == this->UnarySize;
  }

private:
  bool LoadWord();

  const unsigned char* Low = nullptr;
  const unsigned char* Unary = nullptr;
  std::size_t UnarySize = 0;
  std::size_t WordEnd = 0;   // the byte behind the present word
  std::uint64_t Word = 0;    // its ones that end codes which were not read yet
  std::uint64_t LastEnd = 0; // the bit behind the last code that was read
};
}

#endif
