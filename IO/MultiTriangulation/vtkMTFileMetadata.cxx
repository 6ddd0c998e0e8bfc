// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileMetadata.h"

#include "vtkMTExactPoints.h"
#include "vtkMTFileDag.h"
#include "vtkMTFileFormat.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
class MetadataWriter
{
public:
  template <typename Number>
  void Put(Number value)
  {
    const unsigned char* from = reinterpret_cast<const unsigned char*>(&value);
    this->Bytes.insert(this->Bytes.end(), from, from + sizeof(value));
  }
  void Put(const std::string& text)
  {
    this->Put(static_cast<std::uint32_t>(text.size()));
    this->Bytes.insert(this->Bytes.end(), text.begin(), text.end());
  }
  template <typename Value>
  void Put(const std::map<std::string, Value>& map)
  {
    this->Put(static_cast<std::uint32_t>(map.size()));
    for (const auto& entry : map)
    {
      this->Put(entry.first);
      this->Put(entry.second);
    }
  }
  void Put(const vtkMTArrayInfo& array)
  {
    this->Put(array.Name);
    this->Put(static_cast<std::int32_t>(array.Type));
    this->Put(static_cast<std::int32_t>(array.Components));
    this->Put(static_cast<std::int32_t>(array.Attribute));
    this->Put(static_cast<std::uint32_t>(array.GetTupleSize()));
    this->Put(static_cast<std::uint8_t>(array.Association));
    this->Put(static_cast<std::uint8_t>(array.Resampling));
    this->Put(static_cast<std::uint8_t>(array.Role));
    this->Put(static_cast<std::uint8_t>(0));
    this->Put(static_cast<std::uint32_t>(array.ComponentNames.size()));
    for (const std::string& name : array.ComponentNames)
    {
      this->Put(name);
    }
    this->Put(array.Properties);
  }

  std::vector<unsigned char> Bytes;
};

class MetadataReader
{
public:
  MetadataReader(const unsigned char* data, std::uint64_t size)
    : Next(data)
    , Left(size)
  {
  }

  template <typename Number>
  bool Get(Number& value)
  {
    if (this->Left < sizeof(value))
    {
      return false;
    }
    std::memcpy(&value, this->Next, sizeof(value));
    this->Next += sizeof(value);
    this->Left -= sizeof(value);
    return true;
  }
  bool Get(std::string& text)
  {
    std::uint32_t size = 0;
    if (!this->Get(size) || size > this->Left)
    {
      return false;
    }
    text.assign(reinterpret_cast<const char*>(this->Next), size);
    this->Next += size;
    this->Left -= size;
    return true;
  }
  template <typename Value>
  bool Get(std::map<std::string, Value>& map)
  {
    std::uint32_t count = 0;
    if (!this->Get(count))
    {
      return false;
    }
    for (std::uint32_t i = 0; i < count; ++i)
    {
      std::string key;
      Value value{};
      if (!this->Get(key) || !this->Get(value) || !map.emplace(std::move(key), std::move(value)).second)
      {
        return false;
      }
    }
    return true;
  }
  bool Get(vtkMTArrayInfo& array)
  {
    std::int32_t type = 0;
    std::int32_t components = 0;
    std::int32_t attribute = 0;
    std::uint32_t tupleSize = 0;
    std::uint8_t kinds[4];
    std::uint32_t names = 0;
    if (!this->Get(array.Name) || !this->Get(type) || !this->Get(components) || !this->Get(attribute) ||
      !this->Get(tupleSize) || !this->Get(kinds) || !this->Get(names) || components < 1 ||
      kinds[0] > vtkMTArrayInfo::Cell || kinds[1] > vtkMTArrayInfo::Direction || kinds[2] > vtkMTArrayInfo::Heights ||
      kinds[3] != 0 || (names != 0 && names != static_cast<std::uint32_t>(components)))
    {
      return false;
    }
    array.Type = type;
    array.Components = components;
    array.Attribute = attribute;
    array.Association = static_cast<vtkMTArrayInfo::AssociationType>(kinds[0]);
    array.Resampling = static_cast<vtkMTArrayInfo::ResamplingType>(kinds[1]);
    array.Role = static_cast<vtkMTArrayInfo::RoleType>(kinds[2]);
    for (std::uint32_t i = 0; i < names; ++i)
    {
      array.ComponentNames.emplace_back();
      if (!this->Get(array.ComponentNames.back()))
      {
        return false;
      }
    }
    if (!this->Get(array.Properties) ||
      (array.Role == vtkMTArrayInfo::ExactPoints && !vtkMTExactPoints::IsSound(array)))
    {
      return false;
    }
    // A type whose size is another one here (long) cannot be read on this machine.
    return tupleSize > 0 && array.GetTupleSize() == tupleSize;
  }
  bool IsAtEnd() const { return this->Left == 0; }

private:
  const unsigned char* Next;
  std::uint64_t Left;
};

using vtkMTFileFormat::ModelRecord;

ModelRecord ToRecord(const vtkMTGraph& graph)
{
  ModelRecord record{};
  record.Step = graph.Lattice.Step;
  std::copy(graph.Lattice.Origin.begin(), graph.Lattice.Origin.end(), record.Origin);
  record.MaximumShift = graph.Lattice.MaximumShift;
  record.InputTriangles = graph.InputCounts.Triangles;
  record.InputPoints = graph.InputCounts.Points;
  record.InputSamples = graph.InputCounts.Samples;
  record.InputCells = graph.InputCounts.Cells;
  const vtkMTGraphFigures figures = graph.GetFigures();
  record.FinestTriangles = figures.FinestTriangles;
  std::copy(figures.Box.begin(), figures.Box.end(), record.Box);
  record.Levels = figures.Levels;
  record.LargestWedges = figures.LargestWedges;
  record.FullySharedBorders = graph.FullySharedBorders;
  record.ArrayCount = static_cast<std::uint32_t>(graph.Arrays.size());
  record.BlobCount = static_cast<std::uint32_t>(graph.Blobs.size());
  record.MeasureCount = static_cast<std::uint32_t>(graph.Measures.size());
  record.RangeColumnCount = static_cast<std::uint32_t>(graph.ArcRanges.Columns.size());
  record.Refinement = graph.Refinement;
  record.HasFrame = graph.Frame ? 1 : 0;
  if (graph.Frame)
  {
    std::copy(graph.Frame->begin(), graph.Frame->end(), record.Frame);
  }
  return record;
}

bool FromRecord(const ModelRecord& record, vtkMTGraph& graph)
{
  graph.Lattice.Step = record.Step;
  std::copy(record.Origin, record.Origin + 3, graph.Lattice.Origin.begin());
  graph.Lattice.MaximumShift = record.MaximumShift;
  graph.InputCounts = { record.InputTriangles, record.InputPoints, record.InputSamples, record.InputCells };
  vtkMTGraphFigures figures;
  figures.FinestTriangles = record.FinestTriangles;
  std::copy(record.Box, record.Box + 6, figures.Box.begin());
  figures.Levels = record.Levels;
  figures.LargestWedges = record.LargestWedges;
  graph.SetFigures(figures);
  graph.FullySharedBorders = record.FullySharedBorders;
  graph.Refinement = record.Refinement == vtkMTGraph::Add ? vtkMTGraph::Add : vtkMTGraph::Replace;
  if (record.HasFrame != 0)
  {
    std::copy(record.Frame, record.Frame + 16, graph.Frame.emplace().begin());
  }
  return vtkMTFileDag::CheckLattice(graph.Lattice) && record.Refinement <= vtkMTGraph::Add && record.HasFrame <= 1 &&
    std::all_of(record.Frame, record.Frame + 16, [](double x) { return std::isfinite(x); }) &&
    record.Reserved[0] == 0 && record.Reserved[1] == 0;
}

bool GetBlobs(MetadataReader& reader, std::uint32_t count, vtkMTGraph& graph, vtkMTFileMetadata::Extras& extras)
{
  for (std::uint32_t i = 0; i < count; ++i)
  {
    vtkMTBlobInfo& blob = graph.Blobs.emplace_back();
    extras.BlobOffsets.push_back(0);
    if (!reader.Get(blob.Name) || !reader.Get(blob.Type) || !reader.Get(blob.Properties) ||
      !reader.Get(extras.BlobOffsets.back()))
    {
      return false;
    }
  }
  return true;
}

bool GetArrays(MetadataReader& reader, std::uint32_t count, vtkMTGraph& graph)
{
  for (std::uint32_t i = 0; i < count; ++i)
  {
    if (!reader.Get(graph.Arrays.emplace_back()))
    {
      return false;
    }
    std::vector<vtkMTRange>& ranges = graph.ArrayRanges.emplace_back();
    for (int component = 0; component < graph.Arrays.back().Components; ++component)
    {
      vtkMTRange& range = ranges.emplace_back();
      if (!reader.Get(range.Minimum) || !reader.Get(range.Maximum) || !vtkMTFileDag::CheckRange(range))
      {
        return false;
      }
    }
  }
  return true;
}

bool GetColumns(MetadataReader& reader, const ModelRecord& record, vtkMTGraph& graph)
{
  for (std::uint32_t i = 0; i < record.MeasureCount; ++i)
  {
    if (!reader.Get(graph.Measures.emplace_back().Name))
    {
      return false;
    }
  }
  for (std::uint32_t i = 0; i < record.RangeColumnCount; ++i)
  {
    vtkMTArcRanges::Column& column = graph.ArcRanges.Columns.emplace_back();
    if (!reader.Get(column.Array) || !reader.Get(column.Component) || column.Array >= graph.Arrays.size() ||
      column.Component >= static_cast<std::uint32_t>(graph.Arrays[column.Array].Components))
    {
      return false;
    }
  }
  return true;
}
}

std::vector<unsigned char> vtkMTFileMetadata::Encode(const vtkMTGraph& graph, const Extras& extras)
{
  MetadataWriter writer;
  writer.Put(ToRecord(graph));
  for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
  {
    writer.Put(graph.Arrays[i]);
    for (std::size_t c = 0; c < static_cast<std::size_t>(graph.Arrays[i].Components); ++c)
    {
      const vtkMTRange range = i < extras.ArrayRanges.size() ? extras.ArrayRanges[i][c] : vtkMTRange();
      writer.Put(range.Minimum);
      writer.Put(range.Maximum);
    }
  }
  for (std::size_t i = 0; i < graph.Blobs.size(); ++i)
  {
    writer.Put(graph.Blobs[i].Name);
    writer.Put(graph.Blobs[i].Type);
    writer.Put(graph.Blobs[i].Properties);
    writer.Put(extras.BlobOffsets[i]);
  }
  for (const vtkMTMeasure& measure : graph.Measures)
  {
    writer.Put(measure.Name);
  }
  for (const vtkMTArcRanges::Column& column : graph.ArcRanges.Columns)
  {
    writer.Put(column.Array);
    writer.Put(column.Component);
  }
  writer.Put(graph.Crs);
  writer.Put(graph.Units);
  writer.Put(graph.Settings);
  writer.Put(graph.InputReport);
  writer.Put(graph.Blocked);
  return writer.Bytes;
}

bool vtkMTFileMetadata::Decode(const unsigned char* data, std::uint64_t size, vtkMTGraph& graph, Extras& extras)
{
  MetadataReader reader(data, size);
  ModelRecord record{};
  return reader.Get(record) && FromRecord(record, graph) && GetArrays(reader, record.ArrayCount, graph) &&
    GetBlobs(reader, record.BlobCount, graph, extras) && GetColumns(reader, record, graph) && reader.Get(graph.Crs) &&
    reader.Get(graph.Units) && reader.Get(graph.Settings) && reader.Get(graph.InputReport) &&
    reader.Get(graph.Blocked) && reader.IsAtEnd();
}
