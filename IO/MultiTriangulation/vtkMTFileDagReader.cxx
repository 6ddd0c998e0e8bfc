// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileDagReader.h"

#include "vtkMTFileDag.h"
#include "vtkMTFileMetadata.h"
#include "vtkMTFileRecords.h"

#include <algorithm>
#include <cstring>
#include <limits>

using namespace vtkMTFileFormat;

namespace
{
// Bytes of a block that are read at once: more and more, so that the first picture needs few and all of it few reads.
constexpr std::uint64_t LargestLoad = std::uint64_t(1) << 20;

//------------------------------------------------------------------------------
template <typename Record>
Record Get(const unsigned char* data)
{
  Record record;
  std::memcpy(&record, data, sizeof(record));
  return record;
}
}

//------------------------------------------------------------------------------
vtkMTFileDagReader::vtkMTFileDagReader(const vtkMTByteSource& source, vtkMTGraph& graph, vtkMTFileTables& tables)
  : Source(source)
  , Graph(graph)
  , Tables(tables)
{
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::Open(std::string& error)
{
  std::vector<unsigned char> head;
  if (!this->Blocks.Read(this->Source, head, error))
  {
    return false;
  }
  this->Pages = std::make_unique<vtkMTFilePages>(this->Source, this->Blocks, std::move(head));
  if (!this->ReadMetadata(error) || !this->MakeTables(error) || !this->ReadSink(error))
  {
    return false;
  }
  while (
    !this->IsWhole() && (this->Graph.GetNumberOfKnownNodes() == 0 || this->Sections.Known < this->Graph.Blobs.size()))
  {
    if (!this->ReadOn(1, error))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::ReadMetadata(std::string& error)
{
  const BlockRecord block = this->Blocks.Get(MetadataBlock);
  std::vector<unsigned char> metadata(static_cast<std::size_t>(block.Size));
  if (!this->Pages->Read(block.Offset, metadata.size(), metadata.data(), error))
  {
    return false;
  }
  vtkMTFileMetadata::Extras extras;
  if (!vtkMTFileMetadata::Decode(metadata.data(), metadata.size(), this->Graph, extras))
  {
    error = "its metadata are impossible";
    return false;
  }
  this->Tables.Blobs = std::move(extras.BlobOffsets);
  return true;
}

//------------------------------------------------------------------------------
// All sizes follow from those of the blocks, which lie within the file.
bool vtkMTFileDagReader::MakeTables(std::string& error)
{
  const auto set = [this](Column& column, BlockType type, std::size_t recordSize)
  {
    column.Block = this->Blocks.Get(type);
    column.RecordSize = recordSize;
  };
  const std::size_t measures = this->Graph.Measures.size();
  const std::size_t columns = this->Graph.ArcRanges.Columns.size();
  set(this->Nodes, NodeBlock, sizeof(NodeRecord));
  set(this->Arcs, ArcBlock, sizeof(ArcRecord));
  set(this->Entering, EnteringBlock, sizeof(std::uint32_t));
  set(this->Sections, SectionBlock, sizeof(SectionRecord));
  set(this->Measures, MeasureBlock, std::max<std::size_t>(measures, 1) * sizeof(double));
  set(this->Ranges, RangeBlock, std::max<std::size_t>(columns, 1) * sizeof(double) * 2);
  set(this->Distances, DistanceBlock, sizeof(float) * 2);
  const std::uint64_t nodes = this->Nodes.GetNumberOfRecords();
  const std::uint64_t arcs = this->Arcs.GetNumberOfRecords();
  const std::uint64_t sections = this->Sections.GetNumberOfRecords();
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  const Column* const all[] = { &this->Nodes, &this->Arcs, &this->Entering, &this->Sections, &this->Measures,
    &this->Ranges, &this->Distances };
  const bool whole =
    std::all_of(std::begin(all), std::end(all), [](const Column* c) { return c->Block.Size % c->RecordSize == 0; });
  if (!whole || nodes > most || arcs > most || sections > most || this->Entering.GetNumberOfRecords() != arcs ||
    this->Measures.GetNumberOfRecords() != (measures > 0 ? nodes : 0) ||
    this->Ranges.GetNumberOfRecords() != (columns > 0 ? arcs : 0) ||
    (this->Distances.GetNumberOfRecords() != 0 && this->Distances.GetNumberOfRecords() != arcs) ||
    this->Graph.Blobs.size() > sections || (nodes == 0 && arcs > 0))
  {
    error = "its header is impossible: the sizes of its blocks do not belong together";
    return false;
  }
  this->Graph.Nodes.resize(static_cast<std::size_t>(nodes));
  this->Graph.SetNumberOfKnownNodes(0);
  this->Graph.Arcs.resize(static_cast<std::size_t>(arcs));
  this->Graph.Entering.resize(static_cast<std::size_t>(arcs));
  for (vtkMTMeasure& measure : this->Graph.Measures)
  {
    measure.Values.resize(static_cast<std::size_t>(nodes));
  }
  this->Graph.ArcRanges.Values.resize(columns * static_cast<std::size_t>(arcs));
  this->Tables.Patches.resize(static_cast<std::size_t>(arcs));
  this->Tables.Sections.resize(static_cast<std::size_t>(sections));
  this->Enter.resize(static_cast<std::size_t>(nodes));
  this->NextSection = this->Graph.Blobs.size();
  this->NextOffset = this->Blocks.Header.SectionOffset;
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::ReadSink(std::string& error)
{
  if (this->Graph.Nodes.empty())
  {
    return true;
  }
  const std::uint64_t last = this->Graph.Nodes.size() - 1;
  unsigned char data[sizeof(NodeRecord)];
  if (!this->Pages->Read(this->Nodes.Block.Offset + last * sizeof(data), sizeof(data), data, error))
  {
    return false;
  }
  vtkMTNode sink = vtkMTFileRecords::FromRecord(Get<NodeRecord>(data));
  const std::uint64_t arcs = this->Graph.Arcs.size();
  if (!vtkMTFileDag::CheckNode(sink) || sink.FirstOut > arcs || sink.FirstIn > arcs)
  {
    error = "node " + std::to_string(last) + " is impossible";
    return false;
  }
  sink.OutCount = static_cast<std::uint32_t>(arcs - sink.FirstOut);
  sink.InCount = static_cast<std::uint32_t>(arcs - sink.FirstIn);
  this->Graph.Nodes.back() = sink;
  return true;
}

//------------------------------------------------------------------------------
// The next part of a block, up to the end of a page.
bool vtkMTFileDagReader::Load(Column& column, std::string& error)
{
  const std::uint64_t begin = column.Block.Offset + column.Loaded;
  const std::uint64_t end = column.Block.Offset + column.Block.Size;
  const std::uint64_t wish = std::clamp(column.Loaded, PageSize, LargestLoad);
  // The first load ends with the page in which the block begins, as long as that holds a record.
  const std::uint64_t most = column.Loaded == 0 ? begin + column.RecordSize : begin + wish;
  const std::uint64_t next = std::min(end, this->Pages->GetPageEnd(std::min(end, most)));
  const std::size_t left = column.Bytes.size();
  column.Bytes.resize(left + static_cast<std::size_t>(next - begin));
  if (!this->Pages->Read(begin, static_cast<std::size_t>(next - begin), column.Bytes.data() + left, error))
  {
    return false;
  }
  column.Loaded += next - begin;
  std::size_t taken = 0;
  for (; column.Bytes.size() - taken >= column.RecordSize; taken += column.RecordSize)
  {
    if (!this->TakeRecord(column, column.Known, column.Bytes.data() + taken, error))
    {
      return false;
    }
    ++column.Known;
  }
  column.Bytes.erase(column.Bytes.begin(), column.Bytes.begin() + static_cast<std::ptrdiff_t>(taken));
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::TakeRecord(
  const Column& column, std::uint64_t index, const unsigned char* data, std::string& error)
{
  if (&column == &this->Nodes)
  {
    return this->TakeNode(index, data, error);
  }
  if (&column == &this->Arcs)
  {
    return this->TakeArc(index, data, error);
  }
  if (&column == &this->Entering)
  {
    this->Graph.Entering[index] = Get<std::uint32_t>(data);
    return true;
  }
  if (&column == &this->Sections)
  {
    this->Tables.Sections[index] = Get<SectionRecord>(data);
    return true;
  }
  if (&column == &this->Ranges)
  {
    return this->TakeRange(index, data, error);
  }
  if (&column == &this->Distances)
  {
    return this->TakeDistances(index, data, error);
  }
  bool good = true;
  for (std::size_t m = 0; m < this->Graph.Measures.size(); ++m)
  {
    const auto value = Get<double>(data + m * sizeof(double));
    this->Graph.Measures[m].Values[index] = value;
    good = good && vtkMTFileDag::CheckMeasure(value);
  }
  error = good ? error : "node " + std::to_string(index) + " has an impossible measure";
  return good;
}

//------------------------------------------------------------------------------
// How many arcs a node has is known with the next one; nothing of a node changes after IsNodeComplete.
bool vtkMTFileDagReader::TakeNode(std::uint64_t index, const unsigned char* data, std::string& error)
{
  const vtkMTNode node = vtkMTFileRecords::FromRecord(Get<NodeRecord>(data));
  const std::size_t last = this->Graph.Nodes.size() - 1;
  const std::uint64_t arcs = this->Graph.Arcs.size();
  bool good = vtkMTFileDag::CheckNode(node) && node.FirstOut <= arcs && node.FirstIn <= arcs;
  const auto count = [&good](vtkMTNode& before, const vtkMTNode& next)
  {
    good = good && before.FirstOut <= next.FirstOut && before.FirstIn <= next.FirstIn;
    before.OutCount = next.FirstOut - before.FirstOut;
    before.InCount = next.FirstIn - before.FirstIn;
  };
  if (index < last)
  {
    this->Graph.Nodes[index] = node;
    if (index > 0)
    {
      count(this->Graph.Nodes[index - 1], node);
    }
    if (index + 1 == last)
    {
      count(this->Graph.Nodes[index], this->Graph.Nodes[last]);
    }
  }
  good = good && (index > 0 || (node.FirstOut == 0 && node.FirstIn == 0));
  error = good ? error : "node " + std::to_string(index) + " is impossible";
  return good;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::TakeArc(std::uint64_t index, const unsigned char* data, std::string& error)
{
  const auto record = Get<ArcRecord>(data);
  if (record.Kind > static_cast<std::uint8_t>(vtkMTPatchKind::Grid))
  {
    error = "arc " + std::to_string(index) + " is of kind " + std::to_string(record.Kind) +
      ", which this program does not know";
    return false;
  }
  vtkMTArc& arc = this->Graph.Arcs[index];
  const std::array<float, 2> distances{ arc.ToInput, arc.FromInput }; // they may have come before
  arc = vtkMTFileRecords::FromRecord(record);
  arc.ToInput = distances[0];
  arc.FromInput = distances[1];
  this->Tables.Patches[index] = { record.Offset, record.FirstSection, record.SectionCount };
  const bool good = record.Flags == 0 && record.Reserved[0] == 0 && record.Reserved[1] == 0 &&
    record.Reserved[2] == 0 && vtkMTFileDag::CheckArc(this->Graph.Arcs[index], this->Graph.Nodes.size());
  error = good ? error : "arc " + std::to_string(index) + " is impossible";
  return good;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::TakeDistances(std::uint64_t index, const unsigned char* data, std::string& error)
{
  vtkMTArc& arc = this->Graph.Arcs[index];
  arc.ToInput = Get<float>(data);
  arc.FromInput = Get<float>(data + sizeof(float));
  const bool good = vtkMTFileDag::CheckMeasure(arc.ToInput) && vtkMTFileDag::CheckMeasure(arc.FromInput);
  error = good ? error : "arc " + std::to_string(index) + " has an impossible distance";
  return good;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::TakeRange(std::uint64_t index, const unsigned char* data, std::string& error)
{
  const std::size_t columns = this->Graph.ArcRanges.Columns.size();
  bool good = true;
  for (std::size_t c = 0; c < columns; ++c)
  {
    const vtkMTRange range{ Get<double>(data + c * 16), Get<double>(data + c * 16 + 8) };
    this->Graph.ArcRanges.Values[index * columns + c] = range;
    good = good && vtkMTFileDag::CheckRange(range);
  }
  error = good ? error : "arc " + std::to_string(index) + " has an impossible range";
  return good;
}
