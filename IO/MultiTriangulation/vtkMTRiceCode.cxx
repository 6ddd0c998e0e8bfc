// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRiceCode.h"

#include <algorithm>

namespace
{
class BitWriter
{
public:
  explicit BitWriter(std::vector<unsigned char>& bytes)
    : Bytes(bytes)
  {
  }
  void Put(std::uint32_t value, unsigned width)
  {
    this->Pending |= std::uint64_t(value) << this->Count;
    for (this->Count += width; this->Count >= 8; this->Count -= 8)
    {
      this->Bytes.push_back(static_cast<unsigned char>(this->Pending));
      this->Pending >>= 8;
    }
  }
  void PutUnary(std::uint32_t zeros)
  {
    for (; zeros >= 32; zeros -= 32)
    {
      this->Put(0, 32);
    }
    this->Put(1u << zeros, zeros + 1);
  }
  void Finish()
  {
    if (this->Count > 0)
    {
      this->Bytes.push_back(static_cast<unsigned char>(this->Pending));
    }
    this->Pending = 0;
    this->Count = 0;
  }

private:
  std::vector<unsigned char>& Bytes;
  std::uint64_t Pending = 0;
  unsigned Count = 0;
};

std::uint32_t GetHigh(std::uint32_t code, unsigned parameter)
{
  return static_cast<std::uint32_t>(std::uint64_t(code) >> parameter);
}

// With which the codes take the fewest bits: as these fall and then rise with the parameter, the first one behind which
// they do not fall.
unsigned ChooseParameter(const std::uint32_t* codes, std::size_t count, unsigned mostBits)
{
  const auto getBits = [&](unsigned k)
  {
    std::uint64_t bits = std::uint64_t(k) * count;
    for (std::size_t i = 0; i < count; ++i)
    {
      bits += GetHigh(codes[i], k);
    }
    return bits;
  };
  unsigned best = 0;
  std::uint64_t fewest = getBits(0);
  for (unsigned k = 1; k <= mostBits; ++k)
  {
    const std::uint64_t bits = getBits(k);
    if (bits >= fewest)
    {
      break;
    }
    best = k;
    fewest = bits;
  }
  return best;
}
}

namespace vtkMTRiceCode
{
Coded Encode(const std::vector<std::uint32_t>& codes, unsigned mostBits, std::size_t head)
{
  Coded coded;
  BitWriter low(coded.Low);
  BitWriter unary(coded.Unary);
  for (std::size_t begin = 0, end = 0; begin < codes.size(); begin = end)
  {
    end = std::min(begin + BlockSize, begin < head ? head : codes.size());
    const unsigned parameter = ChooseParameter(codes.data() + begin, end - begin, mostBits);
    coded.Parameters.push_back(static_cast<unsigned char>(parameter));
    for (std::size_t i = begin; i < end; ++i)
    {
      low.Put(codes[i] & static_cast<std::uint32_t>((std::uint64_t(1) << parameter) - 1), parameter);
      unary.PutUnary(GetHigh(codes[i], parameter));
    }
    low.Finish();
  }
  unary.Finish();
  return coded;
}
}
