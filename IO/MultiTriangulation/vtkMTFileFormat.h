// SPDX-License-Identifier: BSD-3-Clause
// The records of a Multi-Triangulation file, version 6, as Documentation/file-format.md describes them. Not installed.
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
constexpr std::uint32_t Version = 6;
constexpr std::uint64_t Alignment = 16;      // of every block and section; the gaps are zero and under a checksum
constexpr std::uint64_t SectionStart = 4096; // the sections begin at a multiple of it
constexpr std::uint64_t PageSize = 65536;    // the blocks are under a checksum for each page of so many bytes
constexpr std::uint64_t HeaderSizeLimit = 65536;

enum Codec : std::uint8_t
{
  Raw = 0,     // as it is in memory
  Lz4 = 1,     // packed, what can be encoded in fewer bytes again is an LZ4 block
  Zstd = 2,    // the same, a zstd frame
  Expected = 3 // normals that the builder made, as differences to what the triangles say
};

enum BlockType : std::uint32_t
{
  PageBlock = 1,     // a checksum for each page
  MetadataBlock = 2, // a ModelRecord, then strings and numbers
  NodeBlock = 3,
  ArcBlock = 4,
  EnteringBlock = 5, // u32 arc indices, by the node that the arcs enter
  SectionBlock = 6,
  MeasureBlock = 7, // f64 for each node and measure
  RangeBlock = 8,   // two f64 for each arc and column
  DistanceBlock = 9 // two f32 for each arc
};
constexpr std::uint32_t NumberOfBlockTypes = 10; // counting 0, which is none

// Of blocks and of sections: a reader that does not know the type or class must refuse the file or the patch.
constexpr std::uint32_t MustBeKnown = 1;

// Classes of sections: an array's is FirstArrayClass and its place in the metadata.
constexpr std::uint16_t GeometryClass = 0;
constexpr std::uint16_t FirstArrayClass = 1;
constexpr std::uint16_t OtherClasses = 0x8000;
constexpr std::uint16_t BlobClass = OtherClasses; // of no patch

// Then the table of blocks, zeros, and in the last eight of HeaderSize bytes the checksum of what is before them.
struct Header
{
  unsigned char Magic[8];
  std::uint32_t Version;
  std::uint32_t HeaderSize;
  std::uint64_t FileSize;
  std::uint64_t PageOffset;    // where the first page begins
  std::uint64_t SectionOffset; // where the last page ends
  std::uint64_t PageChecksum;  // of the page block
  std::uint32_t PageBytes;
  std::uint32_t BlockCount;
  std::uint64_t Reserved;
};
static_assert(sizeof(Header) == 64 && std::is_trivially_copyable<Header>::value, "fixed by the format");

struct BlockRecord
{
  std::uint32_t Type;
  std::uint32_t Flags;
  std::uint64_t Offset;
  std::uint64_t Size; // without padding
};
static_assert(sizeof(BlockRecord) == 24 && std::is_trivially_copyable<BlockRecord>::value, "fixed by the format");

// The metadata begin with one.
struct ModelRecord
{
  double Step;
  std::int64_t Origin[3];
  double MaximumShift;
  std::uint64_t InputTriangles;
  std::uint64_t InputPoints;
  std::uint64_t InputSamples;
  std::uint64_t InputCells;
  std::uint64_t FinestTriangles;
  std::int32_t Box[6];
  std::uint32_t Levels;
  std::uint32_t FullySharedBorders;
  std::uint32_t ArrayCount;
  std::uint32_t BlobCount;
  std::uint32_t MeasureCount;
  std::uint32_t RangeColumnCount;
  std::uint8_t Refinement; // 0 replaces, 1 adds
  std::uint8_t HasFrame;
  std::uint8_t Reserved[2];
  std::uint32_t LargestWedges; // of a patch
  double Frame[16];
};
static_assert(sizeof(ModelRecord) == 264 && std::is_trivially_copyable<ModelRecord>::value, "fixed by the format");

struct NodeRecord
{
  double Error;
  double OwnError;
  double EdgeLength;
  double Center[3];
  double Radius;
  std::uint32_t Level;
  std::uint32_t Region;
  std::uint32_t FirstOut; // the arcs that leave the node are those from here to the next node's
  std::uint32_t FirstIn;  // the same in the entering table
};
static_assert(sizeof(NodeRecord) == 72 && std::is_trivially_copyable<NodeRecord>::value, "fixed by the format");

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
  std::uint8_t Kind;
  std::uint8_t Flags; // 0
  std::uint16_t SectionCount;
  std::uint32_t FirstSection;
  std::uint32_t Reserved[3];
  std::uint64_t Offset; // of the first section's bytes; the others follow
};
static_assert(sizeof(ArcRecord) == 96 && std::is_trivially_copyable<ArcRecord>::value, "fixed by the format");

struct SectionRecord
{
  std::uint64_t Checksum; // of the stored bytes and of the padding after them
  std::uint32_t StoredSize;
  std::uint8_t Codec;
  std::uint8_t Flags;
  std::uint16_t Class;
};
static_assert(sizeof(SectionRecord) == 16 && std::is_trivially_copyable<SectionRecord>::value, "fixed by the format");

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
  std::uint32_t SideSize;       // the side bytes, decoded
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
