// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRiceCode.h"

#include "vtkMTBitWriter.h"

#include <algorithm>
#include <numeric>

namespace
{
// How many bits the codes of a block take above those that each of them takes. With parameters that are not far below
// the logarithm of the mean code, which others are not asked for, they can be counted in 32 bits.
std::uint64_t GetBits(const std::uint32_t* codes, std::size_t count, unsigned k)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; k < 32 && i < count; ++i)
  {
    bits += codes[i] >> k;
  }
  return bits + std::uint64_t(k) * count;
}

// With which the codes take the fewest bits, the least one of these. What a step of the parameter saves falls with the
// parameter, so from any of them, here from the mean code's logarithm, it is downhill to there.
unsigned ChooseParameter(const std::uint32_t* codes, std::size_t count, unsigned mostBits)
{
  const std::uint64_t mean = std::accumulate(codes, codes + count, std::uint64_t(0)) / count;
  unsigned best = std::min(mostBits, 63u - static_cast<unsigned>(__builtin_clzll(mean | 1)));
  std::uint64_t fewest = GetBits(codes, count, best);
  const unsigned first = best;
  while (best > 0)
  {
    const std::uint64_t bits = GetBits(codes, count, best - 1);
    if (bits > fewest)
    {
      break;
    }
    --best;
    fewest = bits;
  }
  while (best >= first && best < mostBits)
  {
    const std::uint64_t bits = GetBits(codes, count, best + 1);
    if (bits >= fewest)
    {
      break;
    }
    ++best;
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
  vtkMTBitWriter low;
  vtkMTBitWriter unary;
  for (std::size_t begin = 0, end = 0; begin < codes.size(); begin = end)
  {
    end = std::min(begin + BlockSize, begin < head ? head : codes.size());
    const unsigned parameter = ChooseParameter(codes.data() + begin, end - begin, mostBits);
    coded.Parameters.push_back(static_cast<unsigned char>(parameter));
    const auto mask = static_cast<std::uint32_t>((std::uint64_t(1) << parameter) - 1);
    for (std::size_t i = begin; i < end; ++i)
    {
      low.Put(codes[i] & mask, parameter);
      unary.PutZeros(static_cast<std::uint32_t>(std::uint64_t(codes[i]) >> parameter));
    }
    low.Align();
  }
  coded.Low = low.Take();
  coded.Unary = unary.Take();
  return coded;
}
}
