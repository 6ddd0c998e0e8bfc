// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTNormalCodec.h"

#include "vtkMTMadeNormals.h"
#include "vtkMTRiceCode.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace
{
// What a section begins with; then a byte for each block of wedges.
struct NormalRecord
{
  std::uint8_t Bits;     // of a coordinate
  std::uint8_t OfPoints; // 1: the sums are those of points, 0: of wedges
  std::uint8_t Reserved[2];
  std::uint32_t UnarySize; // of the first coordinates
};
static_assert(sizeof(NormalRecord) == 8, "fixed by the format");

constexpr std::size_t BlockSize = vtkMTRiceCode::BlockSize;
constexpr unsigned MostParameter = 14; // two of them are in a byte
constexpr unsigned char AsExpected = 255;

using Places = std::array<std::vector<std::uint16_t>, 2>;

// Places on the net as they are expected, of all wedges.
Places Expect(const vtkMTPatch& patch, bool ofPoints, int bits)
{
  Places places;
  vtkMTMadeNormals::GetPlaces(patch, ofPoints, bits, places[0], places[1]);
  if (ofPoints && !patch.WedgePoints.empty())
  {
    for (std::vector<std::uint16_t>& ofAll : places)
    {
      std::vector<std::uint16_t> ofWedges(patch.WedgePoints.size());
      std::transform(patch.WedgePoints.begin(), patch.WedgePoints.end(), ofWedges.begin(),
        [&ofAll](std::uint32_t point) { return ofAll[point]; });
      ofAll = std::move(ofWedges);
    }
  }
  return places;
}

// Differences on the net's middle half.
class Net
{
public:
  explicit Net(int bits)
    : Half((1 << (bits - 1)) - 1)
  {
  }

  // Two differences, modulo 2^16, and back.
  std::array<std::uint16_t, 2> Subtract(
    const std::array<std::uint16_t, 2>& place, const std::array<std::uint16_t, 2>& expected) const
  {
    const Pair e = this->Center(expected);
    const Pair p = this->Center(place);
    const bool isTurned = this->IsOuter(e);
    const Pair a = isTurned ? this->Turn(e) : e;
    const Pair b = isTurned && this->IsIn(p) ? this->Turn(p) : p;
    return { static_cast<std::uint16_t>(b.U - a.U), static_cast<std::uint16_t>(b.V - a.V) };
  }
  std::array<std::uint16_t, 2> Add(
    const std::array<std::uint16_t, 2>& expected, const std::array<std::uint16_t, 2>& difference) const
  {
    const Pair e = this->Center(expected);
    const bool isTurned = this->IsOuter(e);
    const Pair a = isTurned ? this->Turn(e) : e;
    const Pair b = this->Center({ static_cast<std::uint16_t>(a.U + this->Half + difference[0]),
      static_cast<std::uint16_t>(a.V + this->Half + difference[1]) });
    const Pair p = isTurned && this->IsIn(b) ? this->Turn(b) : b;
    return { static_cast<std::uint16_t>(p.U + this->Half), static_cast<std::uint16_t>(p.V + this->Half) };
  }

private:
  struct Pair
  {
    int U;
    int V;
  };
  Pair Center(const std::array<std::uint16_t, 2>& place) const
  {
    return { place[0] - this->Half, place[1] - this->Half };
  }
  bool IsIn(const Pair& p) const { return std::max(std::abs(p.U), std::abs(p.V)) <= this->Half; }
  bool IsOuter(const Pair& p) const { return std::abs(p.U) + std::abs(p.V) > this->Half; }
  // The net of the opposite pole. It is its own inverse on places that are used.
  Pair Turn(const Pair& p) const
  {
    const int u = this->Half - std::abs(p.V);
    const int v = this->Half - std::abs(p.U);
    return { p.U < 0 ? -u : u, p.V < 0 ? -v : v };
  }

  int Half;
};

std::uint32_t ToZigzag(std::uint16_t difference)
{
  return static_cast<std::uint16_t>((difference << 1) ^ (0 - (difference >> 15)));
}

std::uint16_t FromZigzag(std::uint32_t code)
{
  return static_cast<std::uint16_t>((code >> 1) ^ (0u - (code & 1)));
}

// The wedges of a patch in blocks: first those of shared points, then the others.
class Blocks
{
public:
  explicit Blocks(const vtkMTPatch& patch)
    : Wedges(patch.GetNumberOfWedges())
    , Shared(patch.Ids.size())
  {
    if (!patch.WedgePoints.empty())
    {
      const auto isShared = [&patch](std::uint32_t point) { return point < patch.Ids.size(); };
      this->Shared = static_cast<std::size_t>(
        std::find_if_not(patch.WedgePoints.begin(), patch.WedgePoints.end(), isShared) - patch.WedgePoints.begin());
    }
    this->OfShared = vtkMTRiceCode::GetNumberOfBlocks(this->Shared);
    this->Count = this->OfShared + vtkMTRiceCode::GetNumberOfBlocks(this->Wedges - this->Shared);
  }
  std::size_t GetCount() const { return this->Count; }
  bool IsOfShared(std::size_t block) const { return block < this->OfShared; }
  std::size_t GetBegin(std::size_t block) const
  {
    return this->IsOfShared(block) ? block * BlockSize : this->Shared + (block - this->OfShared) * BlockSize;
  }
  std::size_t GetEnd(std::size_t block) const
  {
    return std::min(this->GetBegin(block) + BlockSize, this->IsOfShared(block) ? this->Shared : this->Wedges);
  }
  std::size_t GetSize(std::size_t block) const { return this->GetEnd(block) - this->GetBegin(block); }

private:
  std::size_t Wedges;
  std::size_t Shared;
  std::size_t OfShared = 0;
  std::size_t Count = 0;
};

bool AreEqual(const Places& a, const Places& b, std::size_t begin, std::size_t size)
{
  const auto differs = [&](std::size_t k)
  { return std::memcmp(a[k].data() + begin, b[k].data() + begin, size * sizeof(std::uint16_t)) != 0; };
  return !differs(0) && !differs(1);
}

std::vector<unsigned char> EncodeAgainst(
  const Places& expected, const Places& places, const Blocks& blocks, int bits, bool ofPoints)
{
  const Net net(bits);
  std::array<std::vector<std::uint32_t>, 2> codes; // of blocks that have differences
  std::size_t ofShared = 0;
  std::vector<unsigned char> parameters(blocks.GetCount(), AsExpected);
  for (std::size_t block = 0; block < parameters.size(); ++block)
  {
    const std::size_t begin = blocks.GetBegin(block);
    const std::size_t size = blocks.GetSize(block);
    if (AreEqual(expected, places, begin, size))
    {
      continue;
    }
    parameters[block] = 0;
    for (std::size_t w = begin; w < begin + size; ++w)
    {
      const std::array<std::uint16_t, 2> difference =
        net.Subtract({ places[0][w], places[1][w] }, { expected[0][w], expected[1][w] });
      codes[0].push_back(ToZigzag(difference[0]));
      codes[1].push_back(ToZigzag(difference[1]));
    }
    ofShared = blocks.IsOfShared(block) ? codes[0].size() : ofShared;
  }
  const std::array<vtkMTRiceCode::Coded, 2> coded{ vtkMTRiceCode::Encode(codes[0], MostParameter, ofShared),
    vtkMTRiceCode::Encode(codes[1], MostParameter, ofShared) };
  std::size_t next = 0;
  for (unsigned char& parameter : parameters)
  {
    if (parameter != AsExpected)
    {
      parameter = static_cast<unsigned char>(coded[0].Parameters[next] | coded[1].Parameters[next] << 4);
      ++next;
    }
  }
  const NormalRecord record{ static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(ofPoints ? 1 : 0), {},
    static_cast<std::uint32_t>(coded[0].Unary.size()) };
  const auto* head = reinterpret_cast<const unsigned char*>(&record);
  std::vector<unsigned char> bytes(head, head + sizeof(record));
  for (const auto& part : { parameters, coded[0].Low, coded[1].Low, coded[0].Unary, coded[1].Unary })
  {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  return bytes;
}

bool IsSound(const NormalRecord& record)
{
  return record.Bits >= vtkMTMadeNormals::MinimumBits && record.Bits <= vtkMTMadeNormals::MaximumBits &&
    record.OfPoints <= 1 && record.Reserved[0] == 0 && record.Reserved[1] == 0;
}

// The codes of a section's blocks.
class Codes
{
public:
  bool Start(const NormalRecord& record, const unsigned char* data, std::size_t size, const Blocks& blocks)
  {
    if (size < sizeof(record) || size - sizeof(record) < blocks.GetCount())
    {
      return false;
    }
    this->Parameters = data + sizeof(record);
    std::size_t lowSizes[2] = { 0, 0 };
    for (std::size_t block = 0; block < blocks.GetCount(); ++block)
    {
      for (std::size_t k = 0; k < 2 && !this->IsAsExpected(block); ++k)
      {
        if (this->GetParameter(block, k) > MostParameter)
        {
          return false;
        }
        lowSizes[k] += vtkMTRiceCode::GetLowSize(blocks.GetSize(block), this->GetParameter(block, k));
      }
    }
    const std::size_t before = sizeof(record) + blocks.GetCount() + lowSizes[0] + lowSizes[1];
    if (before > size || record.UnarySize > size - before)
    {
      return false;
    }
    const unsigned char* const low = this->Parameters + blocks.GetCount();
    const unsigned char* const unary = data + before;
    this->Readers = { vtkMTRiceCode::Reader(low, unary, record.UnarySize),
      vtkMTRiceCode::Reader(low + lowSizes[0], unary + record.UnarySize, size - before - record.UnarySize) };
    return true;
  }

  bool IsAsExpected(std::size_t block) const { return this->Parameters[block] == AsExpected; }
  bool Read(std::size_t block, std::size_t count, std::uint32_t (*codes)[2])
  {
    return vtkMTRiceCode::ReadBlock(this->Readers, { this->GetParameter(block, 0), this->GetParameter(block, 1) },
      count, codes, std::make_index_sequence<2>());
  }
  bool IsAtEnd() const { return this->Readers[0].IsAtEnd() && this->Readers[1].IsAtEnd(); }

private:
  unsigned GetParameter(std::size_t block, std::size_t k) const { return this->Parameters[block] >> (4 * k) & 15u; }

  const unsigned char* Parameters = nullptr;
  std::array<vtkMTRiceCode::Reader, 2> Readers;
};
}

namespace vtkMTNormalCodec
{
void Encode(const vtkMTColumn& column, const vtkMTPatch& patch, int bits, std::vector<unsigned char>& bytes)
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  Places places{ std::vector<std::uint16_t>(wedges), std::vector<std::uint16_t>(wedges) };
  for (std::size_t w = 0; w < wedges; ++w)
  {
    std::array<float, 3> normal;
    std::memcpy(normal.data(), column.data() + w * sizeof(normal), sizeof(normal));
    const vtkMTMadeNormals::Place place = vtkMTMadeNormals::GetPlace(normal, bits);
    places[0][w] = place[0];
    places[1][w] = place[1];
  }
  const Blocks blocks(patch);
  std::vector<unsigned char> least = EncodeAgainst(Expect(patch, false, bits), places, blocks, bits, false);
  if (!patch.WedgePoints.empty())
  {
    std::vector<unsigned char> ofPoints = EncodeAgainst(Expect(patch, true, bits), places, blocks, bits, true);
    if (ofPoints.size() < least.size())
    {
      least = std::move(ofPoints);
    }
  }
  bytes.insert(bytes.end(), least.begin(), least.end());
}

bool Decode(const unsigned char* data, std::size_t size, const vtkMTPatch& patch, vtkMTColumn& column)
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  NormalRecord record{};
  std::memcpy(&record, data, std::min(size, sizeof(record)));
  const Blocks blocks(patch);
  Codes section;
  if (!IsSound(record) || !section.Start(record, data, size, blocks))
  {
    return false;
  }
  Places places = Expect(patch, record.OfPoints == 1, record.Bits);
  const Net net(record.Bits);
  std::uint32_t codes[BlockSize][2];
  for (std::size_t block = 0; block < blocks.GetCount(); ++block)
  {
    const std::size_t begin = blocks.GetBegin(block);
    const std::size_t count = blocks.GetSize(block);
    if (section.IsAsExpected(block))
    {
      continue;
    }
    if (!section.Read(block, count, codes))
    {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::array<std::uint16_t, 2> place =
        net.Add({ places[0][begin + i], places[1][begin + i] }, { FromZigzag(codes[i][0]), FromZigzag(codes[i][1]) });
      places[0][begin + i] = place[0];
      places[1][begin + i] = place[1];
    }
  }
  column.resize(wedges * sizeof(std::array<float, 3>));
  vtkMTMadeNormals::GetNormals(places[0].data(), places[1].data(), wedges, record.Bits, nullptr, column.data());
  return section.IsAtEnd();
}
}
