// SPDX-License-Identifier: BSD-3-Clause
// Numbers of any size in bytes of seven bits, lowest first; the high bit says that more follow (LEB128). Zigzag codes
// of differences. Not installed.
#ifndef vtkMTNumberCode_h
#define vtkMTNumberCode_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTNumberCode
{
inline void Append(std::vector<unsigned char>& bytes, std::uint64_t value)
{
  for (; value >= 0x80; value >>= 7)
  {
    bytes.push_back(static_cast<unsigned char>(value | 0x80));
  }
  bytes.push_back(static_cast<unsigned char>(value));
}

inline std::uint32_t ToZigzag(std::uint32_t difference)
{
  return (difference << 1) ^ (0u - (difference >> 31));
}

inline std::uint32_t FromZigzag(std::uint32_t code)
{
  return (code >> 1) ^ (0u - (code & 1));
}

class Reader
{
public:
  Reader(const unsigned char* data, std::size_t size)
    : Next(data)
    , End(data + size)
  {
  }
  bool Get(std::uint64_t& value)
  {
    value = 0;
    for (unsigned shift = 0; this->Next != this->End && shift < 64; shift += 7)
    {
      const unsigned char byte = *this->Next++;
      value |= std::uint64_t(byte & 0x7f) << shift;
      if (byte < 0x80)
      {
        return true;
      }
    }
    return false;
  }
  /// nullptr when there are not so many bytes left.
  const unsigned char* GetBytes(std::uint64_t count)
  {
    if (count > static_cast<std::uint64_t>(this->End - this->Next))
    {
      return nullptr;
    }
    const unsigned char* bytes = this->Next;
    this->Next += count;
    return bytes;
  }
  bool IsAtEnd() const { return this->Next == this->End; }

private:
  const unsigned char* Next;
  const unsigned char* End;
};
}

#endif
