// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTColumnCodec.h"

#include "vtkMTDecodeScratch.h"
#include "vtkMTRiceCode.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr float HalfNet = 2047.0f;
constexpr std::uint16_t NoDirection = 4095;

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

constexpr unsigned MostParameter = 15; // two of them are in a byte

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

std::uint32_t ToZigzag16(std::uint16_t difference)
{
  return static_cast<std::uint16_t>((difference << 1) ^ (0 - (difference >> 15)));
}

std::uint16_t FromZigzag16(std::uint32_t code)
{
  return static_cast<std::uint16_t>((code >> 1) ^ (0u - (code & 1)));
}

std::uint16_t ToNet(float x)
{
  return static_cast<std::uint16_t>(std::lround(std::clamp(x, -1.0f, 1.0f) * HalfNet) + 2047);
}
}

namespace vtkMTColumnCodec
{
std::array<std::uint16_t, 2> EncodeDirection(const std::array<float, 3>& d)
{
  const float sum = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
  if (!(sum > 0.0f) || !std::isfinite(sum))
  {
    return { NoDirection, NoDirection };
  }
  float x = d[0] / sum;
  float y = d[1] / sum;
  if (d[2] < 0.0f)
  {
    const float folded = (1.0f - std::abs(y)) * (x < 0.0f ? -1.0f : 1.0f);
    y = (1.0f - std::abs(x)) * (y < 0.0f ? -1.0f : 1.0f);
    x = folded;
  }
  return { ToNet(x), ToNet(y) };
}

std::array<float, 3> DecodeDirection(const std::array<std::uint16_t, 2>& place)
{
  std::array<float, 3> direction;
  const std::uint32_t first = 0;
  DecodeDirections(place.data(), place.data() + 1, 1, &first, reinterpret_cast<unsigned char*>(direction.data()));
  return direction;
}

// In blocks, whose loop has no branch, so that several directions are computed at once.
void DecodeDirections(const std::uint16_t* u, const std::uint16_t* v, std::size_t count, const std::uint32_t* places,
  unsigned char* directions)
{
  constexpr std::size_t blockSize = 64;
  float xs[blockSize];
  float ys[blockSize];
  float zs[blockSize];
  for (std::size_t begin = 0; begin < count; begin += blockSize)
  {
    const std::size_t size = std::min(blockSize, count - begin);
    for (std::size_t i = 0; i < size; ++i)
    {
      const float isSome = std::max(u[begin + i], v[begin + i]) < NoDirection ? 1.0f : 0.0f;
      const float x = (static_cast<float>(u[begin + i]) - HalfNet) / HalfNet;
      const float y = (static_cast<float>(v[begin + i]) - HalfNet) / HalfNet;
      const float z = 1.0f - std::abs(x) - std::abs(y);
      const float unfoldedX = std::copysign(1.0f - std::abs(y), x);
      const float unfoldedY = std::copysign(1.0f - std::abs(x), y);
      const float a = z < 0.0f ? unfoldedX : x;
      const float b = z < 0.0f ? unfoldedY : y;
      const float length = std::sqrt(a * a + b * b + z * z);
      xs[i] = isSome * (a / length);
      ys[i] = isSome * (b / length);
      zs[i] = isSome * (z / length);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const float direction[3] = { xs[i], ys[i], zs[i] };
      std::memcpy(directions + places[begin + i] * sizeof(direction), direction, sizeof(direction));
    }
  }
}

std::uint64_t GetPackedSize(const vtkMTArrayInfo& array, std::uint64_t tuples)
{
  return tuples * array.GetTupleSize();
}

bool IsDirection(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::MadeNormals && array.GetTupleSize() == 3 * sizeof(float) &&
    array.Association == vtkMTArrayInfo::Point;
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

void PackDirections(const vtkMTColumn& column, const vtkMTDecodeScratch& traversal, std::vector<unsigned char>& bytes)
{
  const std::size_t tuples = column.size() / sizeof(std::array<float, 3>);
  std::array<std::vector<std::uint16_t>, 2> known{ std::vector<std::uint16_t>(tuples + 1),
    std::vector<std::uint16_t>(tuples + 1) };
  for (std::size_t i = 0; i < tuples; ++i)
  {
    std::array<float, 3> direction;
    std::memcpy(direction.data(), column.data() + traversal.WedgeOfStream[i] * sizeof(direction), sizeof(direction));
    const std::array<std::uint16_t, 2> place = EncodeDirection(direction);
    known[0][i + 1] = place[0];
    known[1][i + 1] = place[1];
  }
  DirectionRecord record{};
  std::array<vtkMTRiceCode::Coded, 2> coded;
  for (std::size_t k = 0; k < 2; ++k)
  {
    record.First[k] = tuples > 0 ? known[k][1] : std::uint16_t(0);
    known[k][0] = record.First[k];
    std::vector<std::uint32_t> codes(tuples);
    for (std::size_t i = 0; i < tuples; ++i)
    {
      codes[i] =
        ToZigzag16(static_cast<std::uint16_t>(known[k][i + 1] - Expect(known[k].data(), traversal.Mesh.Bases[i], i)));
    }
    coded[k] = vtkMTRiceCode::Encode(codes, MostParameter);
  }
  record.UnarySize = static_cast<std::uint32_t>(coded[0].Unary.size());
  const auto* head = reinterpret_cast<const unsigned char*>(&record);
  bytes.insert(bytes.end(), head, head + sizeof(record));
  for (std::size_t block = 0; block < coded[0].Parameters.size(); ++block)
  {
    bytes.push_back(static_cast<unsigned char>(coded[0].Parameters[block] | coded[1].Parameters[block] << 4));
  }
  for (const auto& part : { coded[0].Low, coded[1].Low, coded[0].Unary, coded[1].Unary })
  {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
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
  DecodeDirections(known[0].data() + 1, known[1].data() + 1, tuples, traversal.WedgeOfStream.data(), column.data());
  return readers[0].IsAtEnd() && readers[1].IsAtEnd();
}
}
