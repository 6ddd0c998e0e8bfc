// SPDX-License-Identifier: BSD-3-Clause
// Nodes and arcs as records of a Multi-Triangulation file and back. Not installed.
#ifndef vtkMTFileRecords_h
#define vtkMTFileRecords_h

#include "vtkMTFileFormat.h"
#include "vtkMTFileTables.h"
#include "vtkMTGraph.h"

#include <cstring>

namespace vtkMTFileRecords
{
inline vtkMTFileFormat::NodeRecord ToRecord(const vtkMTNode& node)
{
  return { node.Error, node.OwnError, node.EdgeLength, { node.Center[0], node.Center[1], node.Center[2] }, node.Radius,
    node.Level, node.Region, node.FirstOut, node.FirstIn };
}

/// How many arcs leave and enter the node follows from the record of the next one.
inline vtkMTNode FromRecord(const vtkMTFileFormat::NodeRecord& record)
{
  vtkMTNode node;
  node.Error = record.Error;
  node.OwnError = record.OwnError;
  node.EdgeLength = record.EdgeLength;
  node.Center = { record.Center[0], record.Center[1], record.Center[2] };
  node.Radius = record.Radius;
  node.Level = record.Level;
  node.Region = record.Region;
  node.FirstOut = record.FirstOut;
  node.FirstIn = record.FirstIn;
  return node;
}

inline vtkMTFileFormat::ArcRecord ToRecord(const vtkMTArc& arc, const vtkMTFileTables::Place& place)
{
  vtkMTFileFormat::ArcRecord record{};
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
  record.Kind = static_cast<std::uint8_t>(arc.Kind);
  record.SectionCount = static_cast<std::uint16_t>(place.SectionCount);
  record.FirstSection = place.FirstSection;
  record.Offset = place.Offset;
  return record;
}

/// The kind has been checked.
inline vtkMTArc FromRecord(const vtkMTFileFormat::ArcRecord& record)
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
  arc.Kind = static_cast<vtkMTPatchKind>(record.Kind);
  return arc;
}
}

#endif
