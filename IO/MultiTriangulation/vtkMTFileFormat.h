// SPDX-License-Identifier: BSD-3-Clause
// The records of a Multi-Triangulation file, version 5, as Documentation/file-format.md describes them. Not installed.
#ifndef vtkMTFileFormat_h
#define vtkMTFileFormat_h

#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "The file is little-endian and its records are copied as they are: this machine would need a conversion."
#endif

namespace vtkMTFileFormat
{
// As PNG's: a byte with the high bit set, both kinds of line end and an end-of-file mark show damage by text transfer.
constexpr unsigned char Magic[8] = { 0x89, 'B', 'M', 'T', '\r', '\n', 0x1a, '\n' };
constexpr std::uint32_t Version = 5;
constexpr std::uint64_t Alignment = 16;  // of every block and section; the gaps are zero and under the checksum before
constexpr std::uint64_t PageSize = 4096; // the patches begin on one

enum Codec : std::uint8_t
{
  Raw = 0, // as it is in memory
  Lz4 = 1, // packed, what can be said in fewer bytes again is an LZ4 block
  Zstd = 2 // the same, a zstd frame
};

struct Header
{
  unsigned char Magic[8];
  std::uint32_t Version;
  std::uint32_t HeaderSize;
  std::uint64_t FileSize;
  std::uint64_t NodeOffset;
  std::uint64_t ArcOffset;
  std::uint64_t DirectoryOffset;
  std::uint64_t MetadataOffset;
  std::uint64_t MetadataSize;
  std::uint64_t PatchOffset;
  std::uint32_t NodeCount;
  std::uint32_t ArcCount;
  std::uint32_t ArrayCount;
  std::uint32_t FullySharedBorders;
  std::uint64_t InputTriangles;
  double Step;
  std::int64_t Origin[3];
  double MaximumShift;
  std::uint32_t BlobCount;
  unsigned char Reserved[100];
  std::uint64_t DagChecksum;
  std::uint64_t HeaderChecksum;
};
static_assert(sizeof(Header) == 256 && std::is_trivially_copyable<Header>::value, "fixed by the format");
static_assert(offsetof(Header, HeaderChecksum) == 248, "the checksum is over the bytes before it");

struct NodeRecord
{
  double Error;
  double OwnError;
  double EdgeLength;
  double Center[3];
  double Radius;
  std::uint32_t Level;
  std::uint32_t Region;
};
static_assert(sizeof(NodeRecord) == 64 && std::is_trivially_copyable<NodeRecord>::value, "fixed by the format");

struct ArcRecord
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Triangles;
  std::uint32_t Points;
  std::uint32_t Wedges;
  std::uint32_t SharedPoints;
  std::int32_t Box[6];
  float ConeAxis[3];
  float ConeCosine;
  float MeanEdgeLength;
  std::uint32_t Reserved;
};
static_assert(sizeof(ArcRecord) == 72 && std::is_trivially_copyable<ArcRecord>::value, "fixed by the format");

struct SectionRecord
{
  std::uint64_t Checksum; // of the stored bytes and of the padding after them
  std::uint32_t StoredSize;
  std::uint8_t Codec;
  std::uint8_t Reserved[3];
};
static_assert(sizeof(SectionRecord) == 16 && std::is_trivially_copyable<SectionRecord>::value, "fixed by the format");

/// A section and where it lies, which follows from the sizes of those before it and is not stored.
struct Section : SectionRecord
{
  std::uint64_t Offset = 0;
};

// A geometry section begins with one of these: the first where its codec is Raw, the second elsewhere.
struct GeometryRecord
{
  std::uint32_t Points;
  std::uint32_t Wedges;
  std::uint32_t Triangles;
  std::uint32_t SharedPoints;
  std::int32_t Corner[3];
  std::uint8_t CoordinateWidth; // 1, 2, 4
  std::uint8_t IdWidth;         // 1, 2, 4, 8
  std::uint8_t WedgeWidth;      // 1, 2, 4; 0: wedge i is point i, and no table is stored
  std::uint8_t IndexWidth;      // 1, 2, 4
  std::uint64_t FirstId;
};
static_assert(sizeof(GeometryRecord) == 40 && std::is_trivially_copyable<GeometryRecord>::value, "fixed by the format");

struct PackedGeometryRecord
{
  std::int32_t Corner[3];
  std::uint8_t Shift;    // coarse points are multiples of 2^Shift
  std::uint8_t HasTable; // 1: wedges are not points
  std::uint8_t IsNear;   // 1: points are expected nearer to their gates than a parallelogram ends
  std::uint8_t Reserved;
  std::uint32_t SideSize;       // bytes of the side stream, decoded
  std::uint32_t StoredSideSize; // stored
};
static_assert(
  sizeof(PackedGeometryRecord) == 24 && std::is_trivially_copyable<PackedGeometryRecord>::value, "fixed by the format");

/// size rounded up to the alignment; the caller has made sure that it is far from overflow.
inline std::uint64_t Align(std::uint64_t size)
{
  return (size + Alignment - 1) / Alignment * Alignment;
}

}

#endif
