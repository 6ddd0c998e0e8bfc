// SPDX-License-Identifier: BSD-3-Clause
// vtkMTFileDagReader: from node to node, and what is checked of each.
#include "vtkMTFileDagReader.h"

#include <algorithm>

using namespace vtkMTFileFormat;

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::IsNodeComplete(std::uint64_t node) const
{
  const std::uint64_t last = this->Graph.Nodes.size() - 1;
  return node == last || node + 1 < this->Nodes.Known || (node + 1 == last && node < this->Nodes.Known);
}

//------------------------------------------------------------------------------
// The block that must be read on before the next node can be known; null when there is none.
vtkMTFileDagReader::Column* vtkMTFileDagReader::FindMissing(std::uint64_t endOfArcs)
{
  const vtkMTNode& node = this->Graph.Nodes[this->Next];
  if (this->Arcs.Known < endOfArcs)
  {
    return &this->Arcs;
  }
  if (this->Entering.Known < std::uint64_t(node.FirstIn) + node.InCount)
  {
    return &this->Entering;
  }
  std::uint64_t sections = this->NextSection;
  for (std::uint64_t arc = node.FirstOut; arc < endOfArcs; ++arc)
  {
    sections += this->Tables.Patches[arc].SectionCount;
    if (!this->IsNodeComplete(this->Graph.Arcs[arc].To))
    {
      return &this->Nodes;
    }
  }
  if (this->Sections.Known < std::min<std::uint64_t>(sections, this->Tables.Sections.size()))
  {
    return &this->Sections;
  }
  if (this->Measures.Known < std::min(this->Next + 1, this->Measures.GetNumberOfRecords()))
  {
    return &this->Measures;
  }
  if (this->Distances.Known < std::min(endOfArcs, this->Distances.GetNumberOfRecords()))
  {
    return &this->Distances;
  }
  return this->Ranges.Known < std::min(endOfArcs, this->Ranges.GetNumberOfRecords()) ? &this->Ranges : nullptr;
}

//------------------------------------------------------------------------------
// To the next node, if all that belongs to it has been read.
vtkMTFileDagReader::StepType vtkMTFileDagReader::Advance(std::string& error)
{
  this->Missing = &this->Nodes;
  const bool isRead = this->Next + 1 == this->Graph.Nodes.size() ? this->Nodes.Known == this->Graph.Nodes.size()
                                                                 : this->IsNodeComplete(this->Next);
  if (!isRead)
  {
    return Waits;
  }
  const vtkMTNode& node = this->Graph.Nodes[this->Next];
  const std::uint64_t endOfArcs = std::uint64_t(node.FirstOut) + node.OutCount;
  this->Missing = this->FindMissing(endOfArcs);
  if (this->Missing)
  {
    return Waits;
  }
  if (!this->CheckEntering(node, error) || !this->CheckArcs(node.FirstOut, endOfArcs, error))
  {
    return Failed;
  }
  ++this->Next;
  return Done;
}

//------------------------------------------------------------------------------
// All arcs that enter the node leave known ones, and none twice.
bool vtkMTFileDagReader::CheckEntering(const vtkMTNode& node, std::string& error) const
{
  bool good = this->Enter[this->Next] == node.InCount;
  for (std::uint32_t i = 0; good && i < node.InCount; ++i)
  {
    const std::uint32_t arc = this->Graph.Entering[node.FirstIn + i];
    good = arc < node.FirstOut && this->Graph.Arcs[arc].To == this->Next &&
      (i == 0 || this->Graph.Entering[node.FirstIn + i - 1] < arc);
  }
  error = good ? error : "the arcs that enter node " + std::to_string(this->Next) + " are not those of its table";
  return good;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::CheckArcs(std::uint64_t begin, std::uint64_t end, std::string& error)
{
  for (std::uint64_t index = begin; index < end; ++index)
  {
    const vtkMTArc& arc = this->Graph.Arcs[index];
    if (arc.From != this->Next || (index > begin && this->Graph.Arcs[index - 1].To > arc.To))
    {
      error = "arc " + std::to_string(index) + " is out of order";
      return false;
    }
    if (!this->CheckSections(static_cast<std::uint32_t>(index), error))
    {
      return false;
    }
    ++this->Enter[arc.To];
    this->AddToFigures(arc);
  }
  return true;
}

//------------------------------------------------------------------------------
// The sections lie one after the other, by arcs and in each by class, the geometry first.
bool vtkMTFileDagReader::CheckSections(std::uint32_t arc, std::string& error)
{
  const vtkMTFileTables::Place& place = this->Tables.Patches[arc];
  bool good = place.FirstSection == this->NextSection && place.Offset == this->NextOffset &&
    place.SectionCount <= this->Tables.Sections.size() - this->NextSection &&
    this->Graph.Arcs[arc].IsDependency() == (place.SectionCount == 0);
  for (std::uint32_t i = 0; good && i < place.SectionCount; ++i)
  {
    const SectionRecord& section = this->Tables.Sections[this->NextSection + i];
    const bool isOther = section.Class >= OtherClasses;
    if (isOther && (section.Flags & MustBeKnown) != 0)
    {
      error = "arc " + std::to_string(arc) + " has a section of class " + std::to_string(section.Class) +
        ", which a newer program must read";
      return false;
    }
    if (!isOther && section.Codec > Expected)
    {
      error = "arc " + std::to_string(arc) + " has a section of codec " + std::to_string(section.Codec) +
        ", which a newer program must read";
      return false;
    }
    const std::uint64_t size = Align(section.StoredSize);
    good = size <= this->Blocks.Header.FileSize - this->NextOffset && section.Flags <= MustBeKnown &&
      (isOther ||
        (section.Codec <= (section.Class == GeometryClass ? Zstd : Expected) &&
          section.Class <= this->Graph.Arrays.size())) &&
      (i == 0 ? section.Class == GeometryClass
              : this->Tables.Sections[this->NextSection + i - 1].Class < section.Class);
    this->NextOffset += good ? size : 0;
  }
  this->NextSection += place.SectionCount;
  error = good ? error : "the sections of arc " + std::to_string(arc) + " are impossible";
  return good;
}

//------------------------------------------------------------------------------
void vtkMTFileDagReader::AddToFigures(const vtkMTArc& arc)
{
  this->Figures.Levels = std::max(this->Figures.Levels, this->Graph.Nodes[arc.To].Level + 1);
  const bool isFinest = arc.To == this->Graph.GetSink() || this->Graph.Refinement == vtkMTGraph::Add;
  this->Figures.FinestTriangles += isFinest ? arc.Triangles : 0;
  this->Figures.LargestWedges = std::max(this->Figures.LargestWedges, arc.Wedges);
  this->Figures.AddBox(arc.Box);
}

//------------------------------------------------------------------------------
// The blobs come last; with them the whole file is accounted for.
bool vtkMTFileDagReader::Finish(std::string& error)
{
  bool good = this->NextSection == this->Tables.Sections.size();
  for (std::size_t blob = 0; good && blob < this->Tables.Blobs.size(); ++blob)
  {
    const SectionRecord& section = this->Tables.Sections[blob];
    const std::uint64_t size = Align(section.StoredSize);
    good = this->Tables.Blobs[blob] == this->NextOffset && section.Codec == Raw && section.Flags == 0 &&
      section.Class == BlobClass && size <= this->Blocks.Header.FileSize - this->NextOffset;
    this->NextOffset += good ? size : 0;
  }
  if (!good || this->NextOffset != this->Blocks.Header.FileSize)
  {
    error = "its sections do not account for all of its bytes";
    return false;
  }
  if (!(this->Figures == this->Graph.GetFigures()) && !this->Graph.Nodes.empty())
  {
    error = "the figures of its metadata are not those of its arcs";
    return false;
  }
  this->IsFinished = true;
  this->Enter = {};
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileDagReader::ReadOn(std::uint64_t bytes, std::string& error)
{
  const std::uint64_t before = this->GetBytesRead();
  for (bool isFirst = true; !this->IsWhole(); isFirst = false)
  {
    StepType step = Done;
    while (step == Done && this->Next < this->Graph.Nodes.size())
    {
      step = this->Advance(error);
    }
    if (step == Failed)
    {
      return false;
    }
    if (this->Next == this->Graph.Nodes.size())
    {
      // What is left are sections of blobs alone.
      if (this->Sections.Known == this->Tables.Sections.size() && !this->Finish(error))
      {
        return false;
      }
      this->Missing = &this->Sections;
    }
    this->Graph.SetNumberOfKnownNodes(static_cast<std::uint32_t>(
      this->IsWhole() ? this->Next : std::min<std::uint64_t>(this->Next, this->Graph.Nodes.size() - 1)));
    if (this->IsWhole() || (!isFirst && this->GetBytesRead() - before >= bytes))
    {
      break;
    }
    if (!this->Load(*this->Missing, error))
    {
      return false;
    }
  }
  return true;
}
