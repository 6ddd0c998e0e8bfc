// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the graph of a Multi-Triangulation file by and by. Not installed.
 *
 * Nodes, arcs, entering table and sections lie in the file from coarse to fine, each in a block of its own. The reader
 * goes from node to node: what it needs to know of one (its record and the next one's, its arcs, the nodes that these
 * enter, the entries of the table, the sections of the arcs' patches, measures, ranges and distances) it reads from the
 * blocks page by page, and so a few pages of each block suffice for the coarse part. A node is known when all of that
 * has been found right; then no check needs to be repeated. The sink's record, which every node refers to that has
 * finest patches, is read first.
 *
 * Threads: one at a time. Others may look at the known part of the graph and of the tables meanwhile.
 */
#ifndef vtkMTFileDagReader_h
#define vtkMTFileDagReader_h

#include "vtkMTFilePages.h"
#include "vtkMTFileTables.h"
#include "vtkMTGraph.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTByteSource;

class vtkMTFileDagReader
{
public:
  /// They must outlive the reader.
  vtkMTFileDagReader(const vtkMTByteSource& source, vtkMTGraph& graph, vtkMTFileTables& tables);

  /// Reads header and metadata, gives graph and tables their sizes, and reads on until the coarsest cut is known. False
  /// with the reason in error, and so in every later call, when the file is damaged or no Multi-Triangulation.
  bool Open(std::string& error);

  /// Reads until so many more bytes have been read, or all. At least one page, so that repeating it comes to an end.
  bool ReadOn(std::uint64_t bytes, std::string& error);

  bool IsWhole() const { return this->Next == this->Graph.Nodes.size() && this->IsFinished; }
  std::uint64_t GetBytesRead() const { return this->Pages ? this->Pages->GetBytesRead() : 0; }

private:
  // One block whose records are read in their order.
  struct Column
  {
    vtkMTFileFormat::BlockRecord Block{};
    std::size_t RecordSize = 1;
    std::uint64_t Loaded = 0; // bytes
    std::uint64_t Known = 0;  // records
    std::vector<unsigned char> Bytes;

    std::uint64_t GetNumberOfRecords() const { return this->Block.Size / this->RecordSize; }
  };
  enum StepType
  {
    Done,
    Waits,
    Failed
  };

  bool ReadMetadata(std::string& error);
  bool MakeTables(std::string& error);
  bool ReadSink(std::string& error);
  bool Load(Column& column, std::string& error);
  bool TakeRecord(const Column& column, std::uint64_t index, const unsigned char* data, std::string& error);
  bool TakeNode(std::uint64_t index, const unsigned char* data, std::string& error);
  bool TakeArc(std::uint64_t index, const unsigned char* data, std::string& error);
  bool TakeDistances(std::uint64_t index, const unsigned char* data, std::string& error);
  bool TakeRange(std::uint64_t index, const unsigned char* data, std::string& error);

  StepType Advance(std::string& error);
  Column* FindMissing(std::uint64_t endOfArcs);
  bool IsNodeComplete(std::uint64_t node) const;
  bool CheckArcs(std::uint64_t begin, std::uint64_t end, std::string& error);
  bool CheckEntering(const vtkMTNode& node, std::string& error) const;
  bool CheckSections(std::uint32_t arc, std::string& error);
  void AddToFigures(const vtkMTArc& arc);
  bool Finish(std::string& error);

  const vtkMTByteSource& Source;
  vtkMTGraph& Graph;
  vtkMTFileTables& Tables;
  vtkMTFileBlocks Blocks;
  std::unique_ptr<vtkMTFilePages> Pages;
  Column Nodes;
  Column Arcs;
  Column Entering;
  Column Sections;
  Column Measures;
  Column Ranges;
  Column Distances;
  Column* Missing = nullptr;        // the block for which Advance waits
  std::vector<std::uint32_t> Enter; // arcs that enter each node, as far as they leave known nodes
  vtkMTGraphFigures Figures;        // of the known arcs
  std::uint64_t Next = 0;           // the first node that is not known
  std::uint64_t NextSection = 0;    // where the next arc's sections must begin
  std::uint64_t NextOffset = 0;     // and their bytes
  bool IsFinished = false;
};

#endif
