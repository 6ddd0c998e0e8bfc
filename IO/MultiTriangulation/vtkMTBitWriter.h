// SPDX-License-Identifier: BSD-3-Clause
// Appends bits to bytes, the lowest first. Not installed.
#ifndef vtkMTBitWriter_h
#define vtkMTBitWriter_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

class vtkMTBitWriter
{
public:
  /// value < 2^width, width <= 32.
  void Put(std::uint32_t value, unsigned width)
  {
    this->Pending |= std::uint64_t(value) << this->Count;
    this->Count += width;
    if (this->Count >= 32)
    {
      this->Flush();
    }
  }
  /// So many zeros and a one.
  void PutZeros(std::uint32_t zeros)
  {
    for (; zeros >= 31; zeros -= 31)
    {
      this->Put(0, 31);
    }
    this->Put(1u << zeros, zeros + 1);
  }
  /// So many ones and a zero.
  void PutOnes(std::uint32_t ones)
  {
    for (; ones >= 31; ones -= 31)
    {
      this->Put(0x7fffffffu, 31);
    }
    this->Put((1u << ones) - 1, ones + 1);
  }
  /// Zeros up to the next whole byte.
  void Align()
  {
    this->Count = (this->Count + 7) / 8 * 8;
    if (this->Count >= 32)
    {
      this->Flush();
    }
  }
  /// The bytes, the last one filled with zeros.
  std::vector<unsigned char> Take()
  {
    const std::size_t size = this->Size + (this->Count + 7) / 8;
    this->Reserve();
    std::memcpy(this->Bytes.data() + this->Size, &this->Pending, sizeof(this->Pending));
    this->Bytes.resize(size);
    this->Size = 0;
    this->Pending = 0;
    this->Count = 0;
    return std::move(this->Bytes);
  }

private:
  void Flush()
  {
    this->Reserve();
    std::memcpy(this->Bytes.data() + this->Size, &this->Pending, sizeof(this->Pending));
    this->Size += 4;
    this->Pending >>= 32;
    this->Count -= 32;
  }
  void Reserve()
  {
    if (this->Size + sizeof(this->Pending) > this->Bytes.size())
    {
      this->Bytes.resize(std::max<std::size_t>(256, 2 * this->Bytes.size()));
    }
  }

  std::vector<unsigned char> Bytes;
  std::size_t Size = 0; // of what is complete
  std::uint64_t Pending = 0;
  unsigned Count = 0; // of bits that are pending, less than 32
};

#endif
