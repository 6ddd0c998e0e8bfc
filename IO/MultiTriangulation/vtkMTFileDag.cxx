// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileDag.h"

#include "vtkMTFileBlocks.h"
#include "vtkMTFileMetadata.h"
#include "vtkMTFileRecords.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace vtkMTFileFormat;

namespace
{
// Levels are scales, of which no model has many.
constexpr std::uint32_t LevelLimit = 65536;

//------------------------------------------------------------------------------
bool IsLength(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

//------------------------------------------------------------------------------
// The axis of a cone that culls has length 1; one that culls nothing may be anything finite.
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

//------------------------------------------------------------------------------
bool CheckMeasures(const vtkMTGraph& graph, std::string& error)
{
  for (const vtkMTMeasure& measure : graph.Measures)
  {
    if (measure.Values.size() != graph.Nodes.size() ||
      !std::all_of(measure.Values.begin(), measure.Values.end(), IsLength))
    {
      error = "the measure \"" + measure.Name + "\" has not one good value for each node";
      return false;
    }
  }
  for (const vtkMTArcRanges::Column& column : graph.ArcRanges.Columns)
  {
    if (column.Array >= graph.Arrays.size() ||
      column.Component >= static_cast<std::uint32_t>(graph.Arrays[column.Array].Components))
    {
      error = "ranges are asked for of an array that there is not";
      return false;
    }
  }
  if (graph.Frame && !std::all_of(graph.Frame->begin(), graph.Frame->end(), [](double x) { return std::isfinite(x); }))
  {
    error = "its frame is not finite";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// A block's records, written one after the other.
class RecordWriter
{
public:
  RecordWriter(std::vector<unsigned char>& bytes, const BlockRecord& block)
    : Next(bytes.data() + block.Offset)
  {
  }
  template <typename Record>
  void Put(const Record& record)
  {
    std::memcpy(this->Next, &record, sizeof(record));
    this->Next += sizeof(record);
  }

private:
  unsigned char* Next;
};

//------------------------------------------------------------------------------
vtkMTFileBlocks MakeTable(const vtkMTGraph& graph, const vtkMTFileDag::Contents& contents, std::uint64_t metadataSize)
{
  vtkMTFileBlocks blocks;
  const auto add = [&blocks](BlockType type, std::uint64_t size, std::uint32_t flags = MustBeKnown) {
    blocks.Table.push_back({ type, flags, 0, size });
  };
  add(PageBlock, 0);
  add(MetadataBlock, metadataSize);
  add(NodeBlock, graph.Nodes.size() * sizeof(NodeRecord));
  add(ArcBlock, graph.Arcs.size() * sizeof(ArcRecord));
  add(EnteringBlock, graph.Arcs.size() * sizeof(std::uint32_t));
  add(SectionBlock, contents.Sections.size() * sizeof(SectionRecord));
  if (!graph.Measures.empty())
  {
    add(MeasureBlock, graph.Nodes.size() * graph.Measures.size() * sizeof(double));
  }
  if (!contents.ArcRanges.Columns.empty())
  {
    add(RangeBlock, contents.ArcRanges.Values.size() * 2 * sizeof(double));
  }
  if (graph.HasArcDistances())
  {
    add(DistanceBlock, graph.Arcs.size() * 2 * sizeof(float), 0);
  }
  blocks.Place();
  return blocks;
}

//------------------------------------------------------------------------------
// The blobs lie behind the patches.
vtkMTFileTables PlaceSections(const vtkMTGraph& graph, const vtkMTFileDag::Contents& contents, std::uint64_t offset)
{
  vtkMTFileTables tables;
  auto section = static_cast<std::uint32_t>(graph.Blobs.size());
  tables.Patches.reserve(contents.SectionCounts.size());
  for (const std::uint16_t count : contents.SectionCounts)
  {
    tables.Patches.push_back({ offset, section, count });
    for (const std::uint32_t end = section + count; section < end; ++section)
    {
      offset += Align(contents.Sections[section].StoredSize);
    }
  }
  for (std::size_t blob = 0; blob < graph.Blobs.size(); ++blob)
  {
    tables.Blobs.push_back(offset);
    offset += Align(contents.Sections[blob].StoredSize);
  }
  tables.Blobs.push_back(offset); // the end of the file
  return tables;
}

//------------------------------------------------------------------------------
void PutRecords(const vtkMTGraph& graph, const vtkMTFileDag::Contents& contents, const vtkMTFileTables& tables,
  const vtkMTFileBlocks& blocks, std::vector<unsigned char>& bytes)
{
  RecordWriter nodes(bytes, blocks.Get(NodeBlock));
  RecordWriter measures(bytes, blocks.Get(MeasureBlock));
  for (std::size_t node = 0; node < graph.Nodes.size(); ++node)
  {
    nodes.Put(vtkMTFileRecords::ToRecord(graph.Nodes[node]));
    for (const vtkMTMeasure& measure : graph.Measures)
    {
      measures.Put(measure.Values[node]);
    }
  }
  RecordWriter arcs(bytes, blocks.Get(ArcBlock));
  RecordWriter entering(bytes, blocks.Get(EnteringBlock));
  for (std::size_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    arcs.Put(vtkMTFileRecords::ToRecord(graph.Arcs[arc], tables.Patches[arc]));
    entering.Put(graph.Entering[arc]);
  }
  RecordWriter sections(bytes, blocks.Get(SectionBlock));
  for (const SectionRecord& section : contents.Sections)
  {
    sections.Put(section);
  }
  RecordWriter distances(bytes, blocks.Get(DistanceBlock));
  for (std::size_t arc = 0; arc < graph.Arcs.size() && blocks.Get(DistanceBlock).Size > 0; ++arc)
  {
    distances.Put(graph.Arcs[arc].ToInput);
    distances.Put(graph.Arcs[arc].FromInput);
  }
  RecordWriter ranges(bytes, blocks.Get(RangeBlock));
  for (const vtkMTRange& range : contents.ArcRanges.Values)
  {
    ranges.Put(range.Minimum);
    ranges.Put(range.Maximum);
  }
}
}

namespace vtkMTFileDag
{
//------------------------------------------------------------------------------
bool CheckLattice(const vtkMTLattice& lattice)
{
  int exponent = 0;
  constexpr std::int64_t most = (std::int64_t(1) << 53) - (std::int64_t(1) << 31);
  return std::isfinite(lattice.Step) && lattice.Step > 0.0 && std::frexp(lattice.Step, &exponent) == 0.5 &&
    IsLength(lattice.MaximumShift) &&
    std::all_of(lattice.Origin.begin(), lattice.Origin.end(), [](std::int64_t x) { return x >= -most && x <= most; });
}

//------------------------------------------------------------------------------
bool CheckNode(const vtkMTNode& node)
{
  return IsLength(node.Error) && IsLength(node.OwnError) && IsLength(node.EdgeLength) && IsLength(node.Radius) &&
    std::isfinite(node.Center[0]) && std::isfinite(node.Center[1]) && std::isfinite(node.Center[2]) &&
    node.Level < LevelLimit;
}

//------------------------------------------------------------------------------
bool CheckArc(const vtkMTArc& arc, std::size_t nodes)
{
  return arc.From < arc.To && arc.To < nodes && arc.SharedPoints <= arc.Points && IsLength(arc.MeanEdgeLength) &&
    CheckCone(arc);
}

//------------------------------------------------------------------------------
bool CheckRange(const vtkMTRange& range)
{
  return range.Minimum <= range.Maximum || range == vtkMTRange();
}

//------------------------------------------------------------------------------
bool CheckMeasure(double value)
{
  return IsLength(value);
}

//------------------------------------------------------------------------------
bool Check(const vtkMTGraph& graph, std::string& error)
{
  if (!CheckLattice(graph.Lattice))
  {
    error = "its lattice is impossible";
    return false;
  }
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    if (!CheckNode(graph.Nodes[i]))
    {
      error = "node " + std::to_string(i) + " has an impossible error, edge length, sphere or level";
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
  if (graph.Entering.size() != graph.Arcs.size())
  {
    error = "it has not been indexed";
    return false;
  }
  return CheckMeasures(graph, error);
}

//------------------------------------------------------------------------------
bool Encode(const vtkMTGraph& graph, const Contents& contents, std::vector<unsigned char>& bytes, std::string& error)
{
  if (contents.Sections.size() > std::numeric_limits<std::uint32_t>::max())
  {
    error = "it has more than 2^32 - 1 sections";
    return false;
  }
  vtkMTFileMetadata::Extras extras{ contents.ArrayRanges, std::vector<std::uint64_t>(graph.Blobs.size()) };
  vtkMTFileBlocks blocks = MakeTable(graph, contents, vtkMTFileMetadata::Encode(graph, extras).size());
  const vtkMTFileTables tables = PlaceSections(graph, contents, blocks.Header.SectionOffset);
  extras.BlobOffsets.assign(tables.Blobs.begin(), tables.Blobs.end() - 1);
  const std::vector<unsigned char> metadata = vtkMTFileMetadata::Encode(graph, extras);

  bytes.assign(static_cast<std::size_t>(blocks.Header.SectionOffset), 0);
  std::memcpy(bytes.data() + blocks.Get(MetadataBlock).Offset, metadata.data(), metadata.size());
  PutRecords(graph, contents, tables, blocks, bytes);
  blocks.Seal(tables.Blobs.back(), bytes);
  return true;
}
}
