// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileDag.h"
#include "vtkMTChecksum.h"

#include "vtkMTByteSource.h"
#include "vtkMTFileMetadata.h"

#include <cmath>
#include <cstring>

namespace
{
using namespace vtkMTFileFormat;

//------------------------------------------------------------------------------
// Where things lie
struct Layout
{
  std::uint64_t NodeOffset;
  std::uint64_t ArcOffset;
  std::uint64_t DirectoryOffset;
  std::uint64_t MetadataOffset;
  std::uint64_t PatchOffset;

  Layout(std::uint32_t nodes, std::uint32_t arcs, std::uint64_t sections, std::uint64_t metadataSize)
    : NodeOffset(sizeof(Header))
    , ArcOffset(Align(this->NodeOffset + std::uint64_t(nodes) * sizeof(NodeRecord)))
    , DirectoryOffset(Align(this->ArcOffset + std::uint64_t(arcs) * sizeof(ArcRecord)))
    , MetadataOffset(Align(this->DirectoryOffset + sections * sizeof(SectionRecord)))
    , PatchOffset((this->MetadataOffset + metadataSize + PageSize - 1) / PageSize * PageSize)
  {
  }
};

//------------------------------------------------------------------------------
// Records
NodeRecord ToRecord(const vtkMTNode& node)
{
  return { node.Error, node.OwnError, node.EdgeLength, { node.Center[0], node.Center[1], node.Center[2] }, node.Radius,
    node.Level, node.Region };
}

vtkMTNode FromRecord(const NodeRecord& record)
{
  vtkMTNode node;
  node.Error = record.Error;
  node.OwnError = record.OwnError;
  node.EdgeLength = record.EdgeLength;
  node.Center = { record.Center[0], record.Center[1], record.Center[2] };
  node.Radius = record.Radius;
  node.Level = record.Level;
  node.Region = record.Region;
  return node;
}

ArcRecord ToRecord(const vtkMTArc& arc)
{
  ArcRecord record{};
  record.From = arc.From;
  record.To = arc.To;
  record.Triangles = arc.Triangles;
  record.Points = arc.Points;
  record.Wedges = arc.Wedges;
  record.SharedPoints = arc.SharedPoints;
  std::memcpy(record.Box, arc.Box.data(), sizeof(record.Box));
  std::memcpy(record.ConeAxis, arc.ConeAxis.data(), sizeof(record.ConeAxis));
  record.ConeCosine = arc.ConeCosine;
  record.MeanEdgeLength = arc.MeanEdgeLength;
  return record;
}

vtkMTArc FromRecord(const ArcRecord& record)
{
  vtkMTArc arc;
  arc.From = record.From;
  arc.To = record.To;
  arc.Triangles = record.Triangles;
  arc.Points = record.Points;
  arc.Wedges = record.Wedges;
  arc.SharedPoints = record.SharedPoints;
  std::memcpy(arc.Box.data(), record.Box, sizeof(record.Box));
  std::memcpy(arc.ConeAxis.data(), record.ConeAxis, sizeof(record.ConeAxis));
  arc.ConeCosine = record.ConeCosine;
  arc.MeanEdgeLength = record.MeanEdgeLength;
  return arc;
}

template <typename Record, typename Item>
void PutRecords(std::vector<unsigned char>& bytes, std::uint64_t offset, const std::vector<Item>& items)
{
  for (const Item& item : items)
  {
    const Record record = ToRecord(item);
    std::memcpy(bytes.data() + offset, &record, sizeof(record));
    offset += sizeof(record);
  }
}

template <typename Record, typename Item>
void GetRecords(const unsigned char* data, std::uint32_t count, std::vector<Item>& items)
{
  items.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Record record;
    std::memcpy(&record, data + std::size_t(i) * sizeof(record), sizeof(record));
    items.push_back(FromRecord(record));
  }
}

//------------------------------------------------------------------------------
// Checks
bool IsLength(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

bool CheckLattice(const vtkMTLattice& lattice, std::string& error)
{
  int exponent = 0;
  bool good = std::isfinite(lattice.Step) && lattice.Step > 0.0 && std::frexp(lattice.Step, &exponent) == 0.5 &&
    IsLength(lattice.MaximumShift);
  constexpr std::int64_t most = (std::int64_t(1) << 53) - (std::int64_t(1) << 31);
  for (const std::int64_t origin : lattice.Origin)
  {
    good = good && origin >= -most && origin <= most;
  }
  error = good ? error : "its lattice is impossible";
  return good;
}

bool CheckNode(const vtkMTNode& node)
{
  return IsLength(node.Error) && IsLength(node.OwnError) && IsLength(node.EdgeLength) && IsLength(node.Radius) &&
    std::isfinite(node.Center[0]) && std::isfinite(node.Center[1]) && std::isfinite(node.Center[2]);
}

// The axis of a cone that culls has length 1; one that culls nothing may say what it likes, as long as it is finite.
bool CheckCone(const vtkMTArc& arc)
{
  double square = 0.0;
  bool finite = std::isfinite(arc.ConeCosine);
  for (const float x : arc.ConeAxis)
  {
    finite = finite && std::isfinite(x);
    square += double(x) * x;
  }
  return finite && (arc.ConeCosine <= 0.0f || (arc.ConeCosine <= 1.0f && std::abs(square - 1.0) < 1e-3));
}

bool CheckArc(const vtkMTArc& arc, std::size_t nodes)
{
  return arc.From < arc.To && arc.To < nodes && arc.SharedPoints <= arc.Points && IsLength(arc.MeanEdgeLength) &&
    CheckCone(arc);
}

// The sections lie one after the other, from the first byte after the DAG block to the end of the file.
bool PlaceSections(const SectionRecord* records, std::vector<Section>& directory, std::uint64_t begin,
  std::uint64_t end, std::string& error)
{
  std::uint64_t next = begin;
  for (std::size_t i = 0; i < directory.size(); ++i)
  {
    SectionRecord record;
    std::memcpy(&record, records + i, sizeof(record));
    const std::uint64_t size = Align(record.StoredSize);
    if (size > end - next || record.Codec > Zstd || record.Reserved[0] != 0 || record.Reserved[1] != 0 ||
      record.Reserved[2] != 0)
    {
      error = "entry " + std::to_string(i) + " of its directory is impossible";
      return false;
    }
    static_cast<SectionRecord&>(directory[i]) = record;
    directory[i].Offset = next;
    next += size;
  }
  if (next != end)
  {
    error = "its directory does not account for all of its bytes";
    return false;
  }
  return true;
}

// At most 2^64 - 2^32: a count of blobs that does not fit is refused with the layout.
std::uint64_t GetNumberOfSections(const Header& header)
{
  return std::uint64_t(header.ArcCount) * (std::uint64_t(header.ArrayCount) + 1) + header.BlobCount;
}

bool CheckHeader(const Header& header, std::uint64_t size, std::string& error)
{
  if (vtkMTChecksum(&header, offsetof(Header, HeaderChecksum)) != header.HeaderChecksum ||
    header.HeaderSize != sizeof(Header))
  {
    error = "its header is damaged: the checksum is wrong";
    return false;
  }
  if (header.FileSize != size)
  {
    error = "it has " + std::to_string(size) + " bytes and should have " + std::to_string(header.FileSize) +
      (size < header.FileSize ? ": it is cut off" : ": something was added to it");
    return false;
  }
  if (header.MetadataSize > size)
  {
    error = "its metadata are longer than the file";
    return false;
  }
  if (GetNumberOfSections(header) > size / sizeof(SectionRecord))
  {
    error = "its directory is longer than the file";
    return false;
  }
  const Layout layout(header.NodeCount, header.ArcCount, GetNumberOfSections(header), header.MetadataSize);
  if (header.NodeOffset != layout.NodeOffset || header.ArcOffset != layout.ArcOffset ||
    header.DirectoryOffset != layout.DirectoryOffset || header.MetadataOffset != layout.MetadataOffset ||
    header.PatchOffset != layout.PatchOffset || header.PatchOffset > size)
  {
    error = "its header is impossible: blocks overlap or pass the end";
    return false;
  }
  return true;
}

bool ReadHeader(const vtkMTByteSource& bytes, Header& header, std::string& error)
{
  const std::uint64_t size = bytes.GetSize();
  unsigned char begin[16] = {};
  if (!bytes.Read(0, size < 16 ? static_cast<std::size_t>(size) : 16, begin, error))
  {
    return false;
  }
  if (!vtkMTFileDag::HasMagic(begin, 16))
  {
    error = size == 0 ? "it is empty" : "it is not a Multi-Triangulation file";
    return false;
  }
  std::uint32_t version;
  std::memcpy(&version, begin + offsetof(Header, Version), sizeof(version));
  if (size >= 12 && version > vtkMTFileFormat::Version)
  {
    error = "it is of version " + std::to_string(version) + " of the format, which is newer than version " +
      std::to_string(vtkMTFileFormat::Version) + ", the newest that this program reads";
    return false;
  }
  if (size < sizeof(Header) || version != vtkMTFileFormat::Version)
  {
    error = size < sizeof(Header) ? "it is cut off within its header"
                                  : "version " + std::to_string(version) + " of the format does not exist";
    return false;
  }
  return bytes.Read(0, sizeof(Header), &header, error) && CheckHeader(header, size, error);
}

bool DecodeBlock(const std::vector<unsigned char>& block, const Header& header, vtkMTGraph& graph,
  std::vector<Section>& directory, std::string& error)
{
  const auto at = [&block](std::uint64_t offset) { return block.data() + (offset - sizeof(Header)); };
  if (!vtkMTFileMetadata::Decode(
        at(header.MetadataOffset), header.MetadataSize, { header.ArrayCount, header.BlobCount }, graph))
  {
    error = "its metadata are impossible";
    return false;
  }
  GetRecords<NodeRecord>(at(header.NodeOffset), header.NodeCount, graph.Nodes);
  GetRecords<ArcRecord>(at(header.ArcOffset), header.ArcCount, graph.Arcs);
  directory.resize(static_cast<std::size_t>(GetNumberOfSections(header)));
  graph.Lattice.Step = header.Step;
  graph.Lattice.Origin = { header.Origin[0], header.Origin[1], header.Origin[2] };
  graph.Lattice.MaximumShift = header.MaximumShift;
  graph.InputTriangles = header.InputTriangles;
  graph.FullySharedBorders = header.FullySharedBorders;
  return vtkMTFileDag::Check(graph, error) &&
    PlaceSections(reinterpret_cast<const SectionRecord*>(at(header.DirectoryOffset)), directory, header.PatchOffset,
      header.FileSize, error);
}
}

namespace vtkMTFileDag
{
bool HasMagic(const unsigned char* bytes, std::size_t count)
{
  return count >= sizeof(Magic) && std::memcmp(bytes, Magic, sizeof(Magic)) == 0;
}

bool Check(const vtkMTGraph& graph, std::string& error)
{
  if (!CheckLattice(graph.Lattice, error))
  {
    return false;
  }
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    if (!CheckNode(graph.Nodes[i]))
    {
      error = "node " + std::to_string(i) + " has an impossible error, edge length or sphere";
      return false;
    }
  }
  for (std::size_t i = 0; i < graph.Arcs.size(); ++i)
  {
    const vtkMTArc& arc = graph.Arcs[i];
    if (!CheckArc(arc, graph.Nodes.size()))
    {
      error = "arc " + std::to_string(i) + " is impossible";
      return false;
    }
    if (i > 0 &&
      (arc.From < graph.Arcs[i - 1].From || (arc.From == graph.Arcs[i - 1].From && arc.To < graph.Arcs[i - 1].To)))
    {
      error = "arc " + std::to_string(i) + " is out of order";
      return false;
    }
  }
  return true;
}

void Encode(const vtkMTGraph& graph, const std::vector<SectionRecord>& directory, std::vector<unsigned char>& bytes)
{
  const std::vector<unsigned char> metadata = vtkMTFileMetadata::Encode(graph);
  Header header{};
  std::memcpy(header.Magic, Magic, sizeof(Magic));
  header.Version = vtkMTFileFormat::Version;
  header.HeaderSize = sizeof(Header);
  header.NodeCount = static_cast<std::uint32_t>(graph.Nodes.size());
  header.ArcCount = static_cast<std::uint32_t>(graph.Arcs.size());
  header.ArrayCount = static_cast<std::uint32_t>(graph.Arrays.size());
  header.MetadataSize = metadata.size();
  header.BlobCount = static_cast<std::uint32_t>(graph.Blobs.size());
  const Layout layout(header.NodeCount, header.ArcCount, directory.size(), header.MetadataSize);
  header.NodeOffset = layout.NodeOffset;
  header.ArcOffset = layout.ArcOffset;
  header.DirectoryOffset = layout.DirectoryOffset;
  header.MetadataOffset = layout.MetadataOffset;
  header.PatchOffset = layout.PatchOffset;
  header.FullySharedBorders = graph.FullySharedBorders;
  header.InputTriangles = graph.InputTriangles;
  header.Step = graph.Lattice.Step;
  header.MaximumShift = graph.Lattice.MaximumShift;
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Origin[axis] = graph.Lattice.Origin[axis];
  }
  header.FileSize = header.PatchOffset;
  for (const SectionRecord& section : directory)
  {
    header.FileSize += Align(section.StoredSize);
  }

  bytes.assign(static_cast<std::size_t>(header.PatchOffset), 0);
  PutRecords<NodeRecord>(bytes, header.NodeOffset, graph.Nodes);
  PutRecords<ArcRecord>(bytes, header.ArcOffset, graph.Arcs);
  if (!directory.empty())
  {
    std::memcpy(bytes.data() + header.DirectoryOffset, directory.data(), directory.size() * sizeof(SectionRecord));
  }
  std::memcpy(bytes.data() + header.MetadataOffset, metadata.data(), metadata.size());
  header.DagChecksum = vtkMTChecksum(bytes.data() + sizeof(Header), bytes.size() - sizeof(Header));
  header.HeaderChecksum = vtkMTChecksum(&header, offsetof(Header, HeaderChecksum));
  std::memcpy(bytes.data(), &header, sizeof(Header));
}

bool Decode(const vtkMTByteSource& bytes, vtkMTGraph& graph, std::vector<Section>& directory, std::string& error)
{
  graph = vtkMTGraph();
  directory.clear();
  Header header;
  if (!ReadHeader(bytes, header, error))
  {
    return false;
  }
  std::vector<unsigned char> block(static_cast<std::size_t>(header.PatchOffset - sizeof(Header)));
  if (!bytes.Read(sizeof(Header), block.size(), block.data(), error))
  {
    return false;
  }
  if (vtkMTChecksum(block.data(), block.size()) != header.DagChecksum)
  {
    error = "its DAG is damaged: the checksum is wrong";
    return false;
  }
  if (!DecodeBlock(block, header, graph, directory, error))
  {
    return false;
  }
  graph.Index();
  return true;
}
}
