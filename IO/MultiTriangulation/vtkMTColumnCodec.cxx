// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTColumnCodec.h"

#include "vtkMTDecodeScratch.h"
#include "vtkMTMadeNormals.h"
#include "vtkMTRiceCode.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
constexpr int DirectionBits = 12;

// Residuals have nothing to do with the ones before them.
bool IsResidual(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::ExactPoints;
}

// Tuples in the order in which they were met, each with one that was met before.
class Order
{
public:
  Order(const vtkMTArrayInfo& array, const vtkMTDecodeScratch& traversal)
    : Traversal(traversal)
    , IsOfCells(array.Association == vtkMTArrayInfo::Cell)
  {
  }
  std::size_t GetPlace(std::size_t i) const { return this->IsOfCells ? i : this->Traversal.WedgeOfStream[i]; }
  // Counted from one: 0 is no tuple. A triangle's is the one across the gate behind which it was found, a wedge's where
  // that gate begins; where that is not known, the one before.
  std::size_t GetBefore(std::size_t i) const
  {
    const std::uint32_t known =
      this->IsOfCells ? this->Traversal.Mesh.Triangles[i][3] : this->Traversal.Mesh.Bases[i].A;
    return known == vtkMTTriangleCodec::None ? i : std::size_t(known) + 1;
  }

private:
  const vtkMTDecodeScratch& Traversal;
  bool IsOfCells;
};

// What a tuple is made of, and whether differences are packed.
struct Layout
{
  std::size_t Tuples;
  std::size_t Components;
  bool HasDifferences;
};

template <class Number>
void PackNumbers(const unsigned char* values, const Layout& layout, const Order& order, unsigned char* packed)
{
  constexpr unsigned bits = 8 * sizeof(Number);
  const auto [tuples, components, hasDifferences] = layout;
  const std::size_t plane = tuples * components;
  std::vector<Number> known(tuples + 1, 0);
  for (std::size_t c = 0; c < components; ++c)
  {
    for (std::size_t i = 0; i < tuples; ++i)
    {
      Number& value = known[i + 1];
      std::memcpy(&value, values + (order.GetPlace(i) * components + c) * sizeof(Number), sizeof(Number));
      const Number before = hasDifferences ? known[order.GetBefore(i)] : Number(0);
      const Number difference = static_cast<Number>(value - before);
      const Number sign = static_cast<Number>(difference >> (bits - 1));
      const Number code = static_cast<Number>(static_cast<Number>(difference << 1) ^ static_cast<Number>(0 - sign));
      for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      {
        packed[byte * plane + c * tuples + i] = static_cast<unsigned char>(code >> (8 * byte));
      }
    }
  }
}

// Adds the bytes of one plane to the codes, where there are any.
template <class Number>
void AddPlane(const unsigned char* bytes, std::size_t count, unsigned shift, Number* codes)
{
  unsigned char any = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    any |= bytes[i];
  }
  for (std::size_t i = 0; any != 0 && i < count; ++i)
  {
    codes[i] = static_cast<Number>(codes[i] | static_cast<Number>(Number(bytes[i]) << shift));
  }
}

template <class Number>
void UnpackNumbers(const unsigned char* packed, const Layout& layout, const Order& order, unsigned char* values)
{
  const auto [tuples, components, hasDifferences] = layout;
  const Number mask = static_cast<Number>(hasDifferences ? ~Number(0) : 0);
  const std::size_t plane = tuples * components;
  std::vector<Number> known(tuples + 1); // codes, then what they mean
  for (std::size_t c = 0; c < components; ++c)
  {
    std::fill(known.begin(), known.end(), Number(0));
    for (unsigned byte = 0; byte < sizeof(Number); ++byte)
    {
      AddPlane(packed + byte * plane + c * tuples, tuples, 8 * byte, known.data() + 1);
    }
    for (std::size_t i = 0; i < tuples; ++i)
    {
      const Number code = known[i + 1];
      const Number sign = static_cast<Number>(code & 1);
      const Number before = static_cast<Number>(known[order.GetBefore(i)] & mask);
      const Number value = static_cast<Number>(
        before + static_cast<Number>(static_cast<Number>(code >> 1) ^ static_cast<Number>(0 - sign)));
      known[i + 1] = value;
      std::memcpy(values + (order.GetPlace(i) * components + c) * sizeof(Number), &value, sizeof(Number));
    }
  }
}

// Calls run with a number of that many bytes.
template <class Run>
void ForSize(std::size_t size, Run&& run)
{
  if (size == sizeof(std::uint8_t))
  {
    return run(std::uint8_t());
  }
  if (size == sizeof(std::uint16_t))
  {
    return run(std::uint16_t());
  }
  if (size == sizeof(std::uint32_t))
  {
    return run(std::uint32_t());
  }
  return run(std::uint64_t());
}

Layout GetLayout(const vtkMTArrayInfo& array, std::size_t tuples)
{
  return { tuples, static_cast<std::size_t>(array.Components), !IsResidual(array) };
}

//------------------------------------------------------------------------------
// Directions. What a section begins with.
struct DirectionRecord
{
  std::uint16_t First[2];  // place of the first wedge that was met
  std::uint32_t UnarySize; // of the first coordinates
};
static_assert(sizeof(DirectionRecord) == 8, "DirectionRecord");

// Places on the net as they are expected: three quarters of the way to where a parallelogram would end. Places are
// counted from one.
std::uint16_t Expect(const std::uint16_t* known, const vtkMTTriangleCodec::Basis& basis, std::size_t i)
{
  if (basis.C == vtkMTTriangleCodec::None)
  {
    return known[basis.A == vtkMTTriangleCodec::None ? i : std::size_t(basis.A) + 1];
  }
  const int a = known[basis.A + std::size_t(1)];
  const int b = known[basis.B + std::size_t(1)];
  const int c = known[basis.C + std::size_t(1)];
  return static_cast<std::uint16_t>((3 * (a + b) - 2 * c + 2) >> 2);
}

std::uint16_t FromZigzag16(std::uint32_t code)
{
  return static_cast<std::uint16_t>((code >> 1) ^ (0u - (code & 1)));
}
}

namespace vtkMTColumnCodec
{
std::uint64_t GetPackedSize(const vtkMTArrayInfo& array, std::uint64_t tuples)
{
  return tuples * array.GetTupleSize();
}

std::vector<unsigned char> Pack(
  const vtkMTArrayInfo& array, const vtkMTColumn& column, const vtkMTDecodeScratch& traversal)
{
  const Layout layout = GetLayout(array, column.size() / array.GetTupleSize());
  std::vector<unsigned char> packed(column.size());
  ForSize(array.GetTupleSize() / layout.Components,
    [&](auto number) { PackNumbers<decltype(number)>(column.data(), layout, Order(array, traversal), packed.data()); });
  return packed;
}

void Unpack(const vtkMTArrayInfo& array, const std::vector<unsigned char>& packed, std::size_t tuples,
  const vtkMTDecodeScratch& traversal, vtkMTColumn& column)
{
  column.resize(tuples * array.GetTupleSize());
  const Layout layout = GetLayout(array, tuples);
  ForSize(array.GetTupleSize() / layout.Components,
    [&](auto number)
    { UnpackNumbers<decltype(number)>(packed.data(), layout, Order(array, traversal), column.data()); });
}

bool UnpackDirections(const unsigned char* data, std::size_t size, std::size_t tuples,
  const vtkMTDecodeScratch& traversal, vtkMTColumn& column)
{
  DirectionRecord record;
  const std::size_t blocks = vtkMTRiceCode::GetNumberOfBlocks(tuples);
  // Every code ends with a one.
  if (size < sizeof(record) + blocks || tuples / 4 > size)
  {
    return false;
  }
  std::memcpy(&record, data, sizeof(record));
  const unsigned char* const parameters = data + sizeof(record);
  std::size_t lowSizes[2] = { 0, 0 };
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t count = std::min(vtkMTRiceCode::BlockSize, tuples - block * vtkMTRiceCode::BlockSize);
    lowSizes[0] += vtkMTRiceCode::GetLowSize(count, parameters[block] & 15);
    lowSizes[1] += vtkMTRiceCode::GetLowSize(count, parameters[block] >> 4);
  }
  const std::size_t before = sizeof(record) + blocks + lowSizes[0] + lowSizes[1];
  if (before > size || record.UnarySize > size - before)
  {
    return false;
  }
  const unsigned char* const low = parameters + blocks;
  const unsigned char* const unary = data + before;
  std::array<vtkMTRiceCode::Reader, 2> readers = { vtkMTRiceCode::Reader(low, unary, record.UnarySize),
    vtkMTRiceCode::Reader(low + lowSizes[0], unary + record.UnarySize, size - before - record.UnarySize) };
  std::vector<std::uint16_t> known[2] = { std::vector<std::uint16_t>(tuples + 1),
    std::vector<std::uint16_t>(tuples + 1) };
  known[0][0] = record.First[0];
  known[1][0] = record.First[1];
  std::uint32_t codes[vtkMTRiceCode::BlockSize][2];
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t begin = block * vtkMTRiceCode::BlockSize;
    const std::size_t count = std::min(vtkMTRiceCode::BlockSize, tuples - begin);
    const unsigned both = parameters[block];
    if (!vtkMTRiceCode::ReadBlock(readers, { both & 15u, both >> 4u }, count, codes, std::make_index_sequence<2>()))
    {
      return false;
    }
    for (std::size_t i = begin; i < begin + count; ++i)
    {
      const vtkMTTriangleCodec::Basis& basis = traversal.Mesh.Bases[i];
      for (std::size_t k = 0; k < 2; ++k)
      {
        known[k][i + 1] =
          static_cast<std::uint16_t>(Expect(known[k].data(), basis, i) + FromZigzag16(codes[i - begin][k]));
      }
    }
  }
  column.resize(tuples * sizeof(std::array<float, 3>));
  vtkMTMadeNormals::GetNormals(
    known[0].data() + 1, known[1].data() + 1, tuples, DirectionBits, traversal.WedgeOfStream.data(), column.data());
  return readers[0].IsAtEnd() && readers[1].IsAtEnd();
}
}
