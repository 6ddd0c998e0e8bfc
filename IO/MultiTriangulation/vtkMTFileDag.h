// SPDX-License-Identifier: BSD-3-Clause
// Everything before the first section of a Multi-Triangulation file: what is checked of it, and how it is written.
// vtkMTFileDagReader reads it. Not installed.
#ifndef vtkMTFileDag_h
#define vtkMTFileDag_h

#include "vtkMTFileFormat.h"
#include "vtkMTGraph.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vtkMTFileDag
{
///@{
/// Whether they are such that they can be used without further checks; arcs as far as that can be seen of one alone.
bool CheckLattice(const vtkMTLattice& lattice);
bool CheckNode(const vtkMTNode& node);
bool CheckArc(const vtkMTArc& arc, std::size_t nodes);
bool CheckRange(const vtkMTRange& range);
bool CheckMeasure(double value);
///@}

/// A whole graph that is to be written. ArrayRanges and the values of ArcRanges are not looked at.
bool Check(const vtkMTGraph& graph, std::string& error);

/// What is to be written beside the graph itself.
struct Contents
{
  std::vector<vtkMTFileFormat::SectionRecord> Sections; ///< of the blobs, then of the patches in the order of the arcs
  std::vector<std::uint16_t> SectionCounts;             ///< of each arc's patch
  std::vector<std::vector<vtkMTRange>> ArrayRanges;     ///< in place of the graph's
  vtkMTArcRanges ArcRanges;                             ///< the same
};

/// The bytes of the file up to the first section. False when there are more than 2^32 - 1 sections.
bool Encode(
  const vtkMTGraph& graph, const Contents& contents, std::vector<unsigned char>& bytes, std::string& error);
}

#endif
