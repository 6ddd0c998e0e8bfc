// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTValidate.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidateExpect.h"

#include <algorithm>
#include <cmath>

namespace
{
using Result = vtkMTValidate::Result;
using vtkMTValidateExpect::Expect;

//------------------------------------------------------------------------------
void CheckLattice(const vtkMTLattice& lattice, Result& result)
{
  int exponent = 0;
  Expect(result, "graph", std::isfinite(lattice.Step) && std::frexp(lattice.Step, &exponent) == 0.5,
    "the lattice's step ", lattice.Step, " is no power of two");
  for (std::int64_t origin : lattice.Origin)
  {
    Expect(result, "graph", std::abs(static_cast<double>(origin)) <= 0x1p53, "the lattice's origin ", origin,
      " is beyond 2^53 steps");
  }
}

//------------------------------------------------------------------------------
// Everything that the other checks index with. False when they cannot go on.
bool CheckIndices(const vtkMTGraph& graph, Result& result)
{
  const std::size_t nodes = graph.Nodes.size();
  const std::size_t arcs = graph.Arcs.size();
  bool ok = Expect(result, "graph", nodes >= 2 && arcs > 0, "a graph needs a source, a sink and an arc: ", nodes,
    " nodes, ", arcs, " arcs");
  ok = Expect(result, "graph", graph.Entering.size() == arcs, "Entering has ", graph.Entering.size(), " entries for ",
         arcs, " arcs") &&
    ok;
  for (std::size_t i = 0; i < arcs; ++i)
  {
    const vtkMTArc& arc = graph.Arcs[i];
    ok = Expect(result, "graph", arc.From < arc.To && arc.To < nodes, "arc ", i, " runs from node ", arc.From, " to ",
           arc.To, " of ", nodes) &&
      ok;
    const bool sorted = i == 0 || graph.Arcs[i - 1].From < arc.From ||
      (graph.Arcs[i - 1].From == arc.From && graph.Arcs[i - 1].To <= arc.To);
    ok = Expect(result, "graph", sorted, "arc ", i, " is out of order") && ok;
  }
  for (std::size_t i = 0; i < graph.Entering.size(); ++i)
  {
    ok =
      Expect(result, "graph", graph.Entering[i] < arcs, "Entering ", i, " is arc ", graph.Entering[i], " of ", arcs) &&
      ok;
  }
  std::uint64_t out = 0;
  std::uint64_t in = 0;
  for (std::size_t i = 0; i < nodes; ++i)
  {
    const vtkMTNode& node = graph.Nodes[i];
    ok = Expect(result, "graph", node.FirstOut == out && node.FirstIn == in, "the arcs of node ", i,
           " do not begin where those of the node before end") &&
      ok;
    out += node.OutCount;
    in += node.InCount;
  }
  return Expect(result, "graph", out == arcs && in == arcs, "the nodes have ", out, " arcs that leave and ", in,
           " that enter, of ", arcs) &&
    ok;
}

//------------------------------------------------------------------------------
// The arcs' ends, as their nodes list them, and that every node lies on a path from source to sink.
bool CheckPaths(const vtkMTGraph& graph, Result& result)
{
  bool ok = true;
  for (std::uint32_t i = 0; i < graph.Nodes.size(); ++i)
  {
    const vtkMTNode& node = graph.Nodes[i];
    // Arcs run forward, so a node has a path from the source when all but the source are entered; likewise to the sink.
    ok = Expect(result, "graph", (node.InCount > 0) == (i != graph.GetSource()), "node ", i, " is entered by ",
           node.InCount, " arcs") &&
      ok;
    ok = Expect(result, "graph", (node.OutCount > 0) == (i != graph.GetSink()), "node ", i, " is left by ",
           node.OutCount, " arcs") &&
      ok;
    for (std::uint32_t a = 0; a < node.OutCount; ++a)
    {
      const vtkMTArc& arc = graph.Arcs[node.FirstOut + a];
      ok = Expect(result, "graph", arc.From == i, "arc ", node.FirstOut + a, " does not leave node ", i) && ok;
    }
    for (std::uint32_t a = 0; a < node.InCount; ++a)
    {
      const std::uint32_t arc = graph.Entering[node.FirstIn + a];
      const bool sorted = a == 0 || graph.Entering[node.FirstIn + a - 1] < arc;
      ok = Expect(result, "graph", graph.Arcs[arc].To == i && sorted, "arc ", arc, " does not enter node ", i,
             " in order") &&
        ok;
    }
  }
  return ok;
}

//------------------------------------------------------------------------------
bool CheckLevels(const vtkMTGraph& graph, Result& result)
{
  bool ok = Expect(result, "graph", graph.Nodes[graph.GetSink()].Level == 0, "the sink's level is ",
    graph.Nodes[graph.GetSink()].Level, ", not 0");
  for (std::size_t i = 0; i < graph.Arcs.size(); ++i)
  {
    const std::uint32_t from = graph.Nodes[graph.Arcs[i].From].Level;
    const std::uint32_t to = graph.Nodes[graph.Arcs[i].To].Level;
    ok = Expect(result, "graph", from > to && from < graph.Nodes.size(), "arc ", i, " runs from level ", from,
           " to level ", to) &&
      ok;
  }
  return ok;
}

//------------------------------------------------------------------------------
struct Sphere
{
  std::array<double, 3> Center; // in steps: spheres and boxes are compared where both are exact
  double Radius;

  Sphere(const vtkMTLattice& lattice, const vtkMTNode& node)
    : Radius(node.Radius / lattice.Step)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Center[i] = node.Center[i] / lattice.Step - static_cast<double>(lattice.Origin[i]);
    }
  }

  bool Holds(double x, double y, double z, double radius) const
  {
    const double d[3] = { x - this->Center[0], y - this->Center[1], z - this->Center[2] };
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) + radius <= this->Radius;
  }
  bool Holds(const Sphere& s) const { return this->Holds(s.Center[0], s.Center[1], s.Center[2], s.Radius); }
  bool Holds(const vtkMTBox& box) const
  {
    bool holds = true;
    for (int corner = 0; holds && corner < 8 && box[0] <= box[1]; ++corner)
    {
      holds = this->Holds(box[corner & 1], box[2 + ((corner >> 1) & 1)], box[4 + (corner >> 2)], 0.0);
    }
    return holds;
  }
};

//------------------------------------------------------------------------------
// Of two nodes that an arc joins.
void CheckMeasures(const vtkMTGraph& graph, std::uint32_t coarse, std::uint32_t fine, Result& result)
{
  for (const vtkMTMeasure& measure : graph.Measures)
  {
    const bool complete = measure.Values.size() == graph.Nodes.size();
    Expect(result, "graph", complete && measure.Values[coarse] >= measure.Values[fine], "the measure ", measure.Name,
      " of node ", coarse, " is not saturated: node ", fine, " below has a larger one");
  }
}

//------------------------------------------------------------------------------
// The ranges of an arc hold those of all arcs below.
void CheckArcRanges(const vtkMTGraph& graph, Result& result)
{
  const vtkMTArcRanges& ranges = graph.ArcRanges;
  const std::size_t columns = ranges.Columns.size();
  const bool complete = Expect(result, "graph", ranges.Values.size() == columns * graph.Arcs.size(), "there are ",
    ranges.Values.size(), " ranges for ", columns, " columns of ", graph.Arcs.size(), " arcs");
  for (std::size_t arc = 0; complete && columns > 0 && arc < graph.Arcs.size(); ++arc)
  {
    const vtkMTNode& node = graph.Nodes[graph.Arcs[arc].To];
    for (std::size_t i = 0; i < node.OutCount * columns; ++i)
    {
      const std::size_t finer = node.FirstOut + i / columns;
      Expect(result, "graph",
        ranges.Values[arc * columns + i % columns].Holds(ranges.Values[finer * columns + i % columns]),
        "the ranges of arc ", arc, " do not hold those of arc ", finer, " below");
    }
  }
}

//------------------------------------------------------------------------------
void CheckSaturation(const vtkMTGraph& graph, Result& result)
{
  for (std::uint32_t i = 0; i < graph.Nodes.size(); ++i)
  {
    const vtkMTNode& node = graph.Nodes[i];
    Expect(result, "graph",
      std::isfinite(node.Error) && node.Error >= 0.0 && std::isfinite(node.OwnError) && node.OwnError >= 0.0 &&
        std::isfinite(node.EdgeLength) && node.EdgeLength >= 0.0 && std::isfinite(node.Radius) && node.Radius >= 0.0,
      "node ", i, " has an error, an edge length or a radius that is negative or no number");
    const double rounding = i == graph.GetSource() ? 0.0 : graph.Nodes.back().Error;
    Expect(result, "graph", node.Error >= node.OwnError + rounding, "the error ", node.Error, " of node ", i,
      " is less than its own ", node.OwnError, " with the lattice's rounding ", rounding);
    const Sphere sphere(graph.Lattice, node);
    for (std::uint32_t a = 0; a < node.OutCount; ++a)
    {
      const std::uint32_t index = node.FirstOut + a;
      const std::uint32_t to = graph.Arcs[index].To;
      const vtkMTNode& finer = graph.Nodes[to];
      Expect(result, "graph", node.Error >= finer.Error, "the error ", node.Error, " of node ", i,
        " is not saturated: node ", to, " below has ", finer.Error);
      Expect(result, "graph", node.EdgeLength >= finer.EdgeLength, "the edge length ", node.EdgeLength, " of node ", i,
        " is not saturated: node ", to, " below has ", finer.EdgeLength);
      CheckMeasures(graph, i, to, result);
      Expect(result, "graph", sphere.Holds(graph.Arcs[index].Box), "the sphere of node ", i,
        " does not hold the patch of arc ", index, " which leaves it");
      Expect(result, "graph", to == graph.GetSink() || sphere.Holds(Sphere(graph.Lattice, finer)),
        "the sphere of node ", i, " does not hold that of node ", to, " below");
    }
    for (std::uint32_t a = 0; a < node.InCount; ++a)
    {
      const std::uint32_t index = graph.Entering[node.FirstIn + a];
      const vtkMTArc& arc = graph.Arcs[index];
      Expect(result, "graph", sphere.Holds(arc.Box), "the sphere of node ", i, " does not hold the patch of arc ",
        index, " which enters it");
      Expect(result, "graph", std::max(arc.ToInput, arc.FromInput) * graph.Lattice.Step <= node.OwnError,
        "the distances of arc ", index, " are larger than the error of node ", i, " which it enters");
    }
  }
}

//------------------------------------------------------------------------------
// What a patch of the arc's kind must have of.
bool HasContents(const vtkMTArc& arc)
{
  switch (arc.Kind)
  {
    case vtkMTPatchKind::Triangles:
      return arc.Triangles > 0 && arc.Points > 0 && arc.Wedges > 0;
    case vtkMTPatchKind::Points:
    case vtkMTPatchKind::Voxels:
      return arc.Points > 0 && arc.Wedges > 0;
    case vtkMTPatchKind::Grid:
      return arc.Wedges > 0;
  }
  return false;
}

//------------------------------------------------------------------------------
void CheckRecords(const vtkMTGraph& graph, Result& result)
{
  const Sphere whole(graph.Lattice, graph.Nodes[graph.GetSink()]);
  for (std::size_t i = 0; i < graph.Arcs.size(); ++i)
  {
    const vtkMTArc& arc = graph.Arcs[i];
    Expect(result, "graph", arc.IsDependency() || HasContents(arc), "arc ", i, " has an empty patch");
    Expect(result, "graph", arc.SharedPoints <= arc.Points, "arc ", i, " has more shared points than points");
    const bool hasBox = arc.Box[0] <= arc.Box[1] && arc.Box[2] <= arc.Box[3] && arc.Box[4] <= arc.Box[5];
    Expect(result, "graph", hasBox != arc.IsDependency(), "arc ", i,
      hasBox ? " is a dependency with a box" : " has an empty box");
    Expect(result, "graph", whole.Holds(arc.Box), "the sphere of the sink does not hold the patch of arc ", i);
  }
  Expect(result, "graph", graph.InputCounts.Triangles >= graph.GetNumberOfFinestTriangles(), "the finest level has ",
    graph.GetNumberOfFinestTriangles(), " triangles, the input ", graph.InputCounts.Triangles);
}
}

//------------------------------------------------------------------------------
void vtkMTValidate::Result::Report(const std::string& check, const std::string& what)
{
  ++this->Violations;
  if (this->Findings.size() < MaximumFindings)
  {
    this->Findings.push_back({ check, what });
  }
}

//------------------------------------------------------------------------------
void vtkMTValidate::Result::Append(const Result& other)
{
  this->Tested += other.Tested;
  this->Violations += other.Violations;
  const std::size_t room = MaximumFindings - std::min(MaximumFindings, this->Findings.size());
  const std::size_t count = std::min(room, other.Findings.size());
  this->Findings.insert(this->Findings.end(), other.Findings.begin(), other.Findings.begin() + count);
}

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::Graph(const vtkMTGraph& graph)
{
  Result result;
  CheckLattice(graph.Lattice, result);
  if (!Expect(result, "graph", graph.IsWhole(), "only ", graph.GetNumberOfKnownNodes(), " of ", graph.Nodes.size(),
        " nodes could be read"))
  {
    return result;
  }
  if (CheckIndices(graph, result) && CheckPaths(graph, result) && CheckLevels(graph, result))
  {
    CheckSaturation(graph, result);
    CheckArcRanges(graph, result);
    CheckRecords(graph, result);
  }
  return result;
}

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::All(const vtkMTPatchSource& source, std::size_t cuts, std::uint32_t seed)
{
  Result result = Graph(source.GetGraph());
  if (!result.IsValid())
  {
    return result; // nothing else may be indexed
  }
  Borders borders;
  result.Append(borders.Load(source));
  for (std::size_t i = 0; i < cuts; ++i)
  {
    result.Append(borders.Cut(vtkMTRandomCut::Make(source.GetGraph(), seed, i)));
  }
  return result;
}
