// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTIdTable.h"
#include "vtkMTPatchSource.h"
#include "vtkMTValidate.h"

#include <algorithm>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
std::uint16_t Saturated(std::uint32_t count)
{
  return static_cast<std::uint16_t>(std::min<std::uint32_t>(count, std::numeric_limits<std::uint16_t>::max()));
}

//------------------------------------------------------------------------------
// How many triangles of one patch use an edge between shared points, forward (from the point that was seen first) and
// backward.
struct EdgeUse
{
  std::uint32_t Edge = 0;
  std::uint16_t Forward = 0;
  std::uint16_t Backward = 0;
  std::uint16_t InLevel = 0; // triangles at the edge in the mesh of the patch's own level
};

struct EdgeCount
{
  std::uint32_t Forward = 0;
  std::uint32_t Backward = 0;
  std::uint32_t Sum() const { return this->Forward + this->Backward; }
  bool operator==(const EdgeCount& o) const { return this->Forward == o.Forward && this->Backward == o.Backward; }
};

struct PatchBorder
{
  std::size_t First = 0; // its edges are Uses[First .. First + Count)
  std::size_t Count = 0;
  std::uint64_t PrivateOpen = 0; // edges with one triangle and an end that no other patch shares
};
}

//------------------------------------------------------------------------------
/**
 * Shared points and the edges between them are numbered once, over all patches. A point is its id together with its
 * place: where a simplification moves a point and keeps its id, the two are never in one cut, and count as two.
 *
 * The i-th mesh is the cut that refines every node above level i.
 */
struct vtkMTValidate::Borders::Internals
{
  struct Point
  {
    std::uint64_t Id;
    vtkMTPoint Place;
    std::uint32_t Level; // where it was seen last
  };

  const vtkMTGraph* Graph = nullptr;
  std::vector<PatchBorder> Patches; // per arc
  std::vector<EdgeUse> Uses;
  std::vector<Point> Points;
  std::vector<std::array<std::uint32_t, 2>> Edges; // indices of Points
  vtkMTIdTable PointTable;
  vtkMTIdTable EdgeTable;
  std::vector<std::uint64_t> Directed; // scratch

  std::uint32_t FindPoint(std::uint64_t id, const vtkMTPoint& place, std::uint32_t level, Result& result);
  std::uint32_t FindEdge(std::uint32_t from, std::uint32_t to, bool& forward);
  void AddPatch(std::uint32_t arc, const vtkMTPatch& patch, Result& result);
  void AddEdge(
    const std::vector<std::uint32_t>& shared, std::uint32_t a, std::uint32_t b, EdgeCount count, PatchBorder& border);
  void LoadPatches(const vtkMTPatchSource& source, Result& result);
  void CheckLevels(Result& result);
  void CheckNode(
    std::uint32_t node, const std::vector<EdgeCount>& finer, const std::vector<EdgeCount>& coarser, Result& result);
  std::string Describe(std::uint32_t edge) const;
};

//------------------------------------------------------------------------------
std::string vtkMTValidate::Borders::Internals::Describe(std::uint32_t edge) const
{
  return "the edge between the points " + std::to_string(this->Points[this->Edges[edge][0]].Id) + " and " +
    std::to_string(this->Points[this->Edges[edge][1]].Id);
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTValidate::Borders::Internals::FindPoint(
  std::uint64_t id, const vtkMTPoint& place, std::uint32_t level, Result& result)
{
  std::uint32_t& index = this->PointTable[id];
  if (index != vtkMTIdTable::None && this->Points[index].Place == place)
  {
    this->Points[index].Level = level;
    return index;
  }
  if (index != vtkMTIdTable::None && this->Points[index].Level == level)
  {
    result.Report(
      "paste", "the shared point " + std::to_string(id) + " lies in two places on level " + std::to_string(level));
    return index;
  }
  index = static_cast<std::uint32_t>(this->Points.size());
  this->Points.push_back({ id, place, level });
  return index;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTValidate::Borders::Internals::FindEdge(std::uint32_t from, std::uint32_t to, bool& forward)
{
  forward = from < to;
  const std::uint32_t low = std::min(from, to);
  const std::uint32_t high = std::max(from, to);
  std::uint32_t& index = this->EdgeTable[(static_cast<std::uint64_t>(low) << 32) | high];
  if (index == vtkMTIdTable::None)
  {
    index = static_cast<std::uint32_t>(this->Edges.size());
    this->Edges.push_back({ low, high });
  }
  return index;
}

//------------------------------------------------------------------------------
// a < b are points of the patch; shared has the numbers of its first points.
void vtkMTValidate::Borders::Internals::AddEdge(
  const std::vector<std::uint32_t>& shared, std::uint32_t a, std::uint32_t b, EdgeCount count, PatchBorder& border)
{
  if (b >= shared.size())
  {
    border.PrivateOpen += count.Sum() == 1 ? 1 : 0;
    return;
  }
  EdgeUse use;
  bool forward = true;
  use.Edge = this->FindEdge(shared[a], shared[b], forward);
  use.Forward = Saturated(forward ? count.Forward : count.Backward);
  use.Backward = Saturated(forward ? count.Backward : count.Forward);
  this->Uses.push_back(use);
}

//------------------------------------------------------------------------------
void vtkMTValidate::Borders::Internals::AddPatch(std::uint32_t arc, const vtkMTPatch& patch, Result& result)
{
  PatchBorder& border = this->Patches[arc];
  const std::uint32_t level = this->Graph->GetLevelOfArc(arc);
  std::vector<std::uint32_t> shared(patch.Ids.size());
  for (std::size_t i = 0; i < patch.Ids.size(); ++i)
  {
    shared[i] = this->FindPoint(patch.Ids[i], patch.Points[i], level, result);
  }
  // Every use of an edge as one number: the smaller point, the larger one (31 bits), the direction.
  this->Directed.clear();
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    for (int i = 0; i < 3; ++i)
    {
      const std::uint64_t a = p[i];
      const std::uint64_t b = p[(i + 1) % 3];
      this->Directed.push_back((std::min(a, b) << 32) | (std::max(a, b) << 1) | (a < b ? 0 : 1));
    }
  }
  std::sort(this->Directed.begin(), this->Directed.end());
  border.First = this->Uses.size();
  for (std::size_t i = 0; i < this->Directed.size();)
  {
    const std::uint64_t edge = this->Directed[i] >> 1;
    EdgeCount count;
    for (; i < this->Directed.size() && this->Directed[i] >> 1 == edge; ++i)
    {
      ++(this->Directed[i] & 1 ? count.Backward : count.Forward);
    }
    this->AddEdge(
      shared, static_cast<std::uint32_t>(edge >> 31), static_cast<std::uint32_t>(edge & 0x7FFFFFFF), count, border);
  }
  border.Count = this->Uses.size() - border.First;
}

//------------------------------------------------------------------------------
void vtkMTValidate::Borders::Internals::LoadPatches(const vtkMTPatchSource& source, Result& result)
{
  std::vector<std::uint32_t> order(this->Graph->Arcs.size());
  for (std::uint32_t arc = 0; arc < order.size(); ++arc)
  {
    order[arc] = arc;
  }
  // Level by level, so that a point which lies in two places of one level is noticed.
  std::stable_sort(order.begin(), order.end(),
    [this](std::uint32_t a, std::uint32_t b) { return this->Graph->GetLevelOfArc(a) < this->Graph->GetLevelOfArc(b); });
  vtkMTPatch patch;
  std::string error;
  for (std::uint32_t arc : order)
  {
    ++result.Tested;
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      result.Report("patch", "patch " + std::to_string(arc) + " cannot be read: " + error);
      continue;
    }
    const Result found = vtkMTValidate::Patch(*this->Graph, arc, patch);
    result.Append(found);
    if (found.IsValid())
    {
      this->AddPatch(arc, patch, result);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMTValidate::Borders::Internals::CheckLevels(Result& result)
{
  const vtkMTGraph& graph = *this->Graph;
  const std::uint32_t levels = graph.GetNumberOfLevels();
  std::vector<std::vector<std::uint32_t>> arcsOfLevel(levels);
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    for (std::uint32_t level = graph.GetLevelOfArc(arc); level < graph.Nodes[graph.Arcs[arc].From].Level; ++level)
    {
      arcsOfLevel[level].push_back(arc);
    }
  }
  std::vector<std::vector<std::uint32_t>> nodesOfLevel(levels);
  for (std::uint32_t node = graph.GetSource() + 1; node < graph.GetSink(); ++node)
  {
    nodesOfLevel[graph.Nodes[node].Level].push_back(node);
  }
  std::vector<EdgeCount> finer(this->Edges.size());
  std::vector<EdgeCount> present(this->Edges.size());
  for (std::uint32_t level = 0; level < levels; ++level)
  {
    std::fill(present.begin(), present.end(), EdgeCount());
    for (std::uint32_t arc : arcsOfLevel[level])
    {
      for (std::size_t i = 0; i < this->Patches[arc].Count; ++i)
      {
        const EdgeUse& use = this->Uses[this->Patches[arc].First + i];
        present[use.Edge].Forward += use.Forward;
        present[use.Edge].Backward += use.Backward;
      }
    }
    for (std::uint32_t arc : arcsOfLevel[level])
    {
      for (std::size_t i = 0; graph.GetLevelOfArc(arc) == level && i < this->Patches[arc].Count; ++i)
      {
        EdgeUse& use = this->Uses[this->Patches[arc].First + i];
        use.InLevel = Saturated(present[use.Edge].Sum());
      }
    }
    for (std::uint32_t node : nodesOfLevel[level])
    {
      this->CheckNode(node, finer, present, result);
    }
    finer.swap(present);
  }
}

//------------------------------------------------------------------------------
/**
 * Pasting. An edge that triangles outside the region use, in the mesh with the floor or in that with the fragment, has
 * as many triangles of the fragment as of the floor, in each direction: otherwise replacing one by the other opens or
 * crowds the mesh there. And a floor without open edges has a fragment without open edges.
 */
void vtkMTValidate::Borders::Internals::CheckNode(
  std::uint32_t index, const std::vector<EdgeCount>& finer, const std::vector<EdgeCount>& coarser, Result& result)
{
  const vtkMTGraph& graph = *this->Graph;
  const vtkMTNode& node = graph.Nodes[index];
  struct Side
  {
    std::uint32_t Edge;
    EdgeCount Count[2]; // in the floor, in the fragment
  };
  std::vector<Side> sides;
  std::uint64_t open[2] = { 0, 0 };
  for (std::uint32_t a = 0; a < node.OutCount + node.InCount; ++a)
  {
    const bool fragment = a >= node.OutCount;
    const std::uint32_t arc = fragment ? graph.Entering[node.FirstIn + a - node.OutCount] : node.FirstOut + a;
    const PatchBorder& border = this->Patches[arc];
    open[fragment] += border.PrivateOpen;
    for (std::size_t i = 0; i < border.Count; ++i)
    {
      const EdgeUse& use = this->Uses[border.First + i];
      Side side{ use.Edge, {} };
      side.Count[fragment] = { use.Forward, use.Backward };
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.Edge < b.Edge; });
  for (std::size_t i = 0; i < sides.size();)
  {
    Side sum{ sides[i].Edge, {} };
    for (; i < sides.size() && sides[i].Edge == sum.Edge; ++i)
    {
      for (int side = 0; side < 2; ++side)
      {
        sum.Count[side].Forward += sides[i].Count[side].Forward;
        sum.Count[side].Backward += sides[i].Count[side].Backward;
      }
    }
    open[0] += sum.Count[0].Sum() == 1 && finer[sum.Edge].Sum() == 1 ? 1 : 0;
    open[1] += sum.Count[1].Sum() == 1 && coarser[sum.Edge].Sum() == 1 ? 1 : 0;
    const bool outside = finer[sum.Edge].Sum() > sum.Count[0].Sum() || coarser[sum.Edge].Sum() > sum.Count[1].Sum();
    ++result.Tested;
    if (outside && !(sum.Count[0] == sum.Count[1]))
    {
      result.Report("paste",
        "node " + std::to_string(index) + " of level " + std::to_string(node.Level) + ": " + this->Describe(sum.Edge) +
          " has " + std::to_string(sum.Count[0].Forward) + "+" + std::to_string(sum.Count[0].Backward) +
          " triangles in the floor, " + std::to_string(sum.Count[1].Forward) + "+" +
          std::to_string(sum.Count[1].Backward) + " in the fragment");
    }
  }
  ++result.Tested;
  if (open[0] == 0 && open[1] > 0)
  {
    result.Report("paste",
      "node " + std::to_string(index) + " of level " + std::to_string(node.Level) + ": the fragment has " +
        std::to_string(open[1]) + " open edges, the floor none");
  }
}

//------------------------------------------------------------------------------
vtkMTValidate::Borders::Borders() = default;

//------------------------------------------------------------------------------
vtkMTValidate::Borders::~Borders() = default;

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::Borders::Load(const vtkMTPatchSource& source)
{
  Result result;
  this->Implementation = std::make_unique<Internals>();
  this->Implementation->Graph = &source.GetGraph();
  this->Implementation->Patches.resize(source.GetGraph().Arcs.size());
  this->Implementation->LoadPatches(source, result);
  this->Implementation->CheckLevels(result);
  return result;
}

//------------------------------------------------------------------------------
vtkMTValidate::Result vtkMTValidate::Borders::Cut(const vtkMTCut& cut) const
{
  Result result;
  if (!this->Implementation)
  {
    result.Report("cut", "no model has been loaded");
    return result;
  }
  const Internals& in = *this->Implementation;
  const std::vector<std::uint32_t> arcs = cut.GetArcs();
  std::vector<std::uint32_t> counts(in.Edges.size(), 0);
  for (std::uint32_t arc : arcs)
  {
    const EdgeUse* uses = in.Uses.data() + in.Patches[arc].First;
    for (std::size_t i = 0; i < in.Patches[arc].Count; ++i)
    {
      counts[uses[i].Edge] += uses[i].Forward + uses[i].Backward;
    }
  }
  for (std::uint32_t arc : arcs)
  {
    const EdgeUse* uses = in.Uses.data() + in.Patches[arc].First;
    result.Tested += in.Patches[arc].Count;
    for (std::size_t i = 0; i < in.Patches[arc].Count; ++i)
    {
      const std::uint32_t count = Saturated(counts[uses[i].Edge]);
      const bool opened = uses[i].InLevel >= 2 && count < 2;
      if (opened || count > uses[i].InLevel)
      {
        result.Report("cut",
          "patch " + std::to_string(arc) + " of level " + std::to_string(in.Graph->GetLevelOfArc(arc)) + ": " +
            in.Describe(uses[i].Edge) + " has " + std::to_string(count) + " triangles in the cut, " +
            std::to_string(uses[i].InLevel) + " in the mesh of its level");
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTValidate::Borders::CountBorderEdges(const vtkMTCut& cut) const
{
  std::uint64_t border = 0;
  if (!this->Implementation)
  {
    return border;
  }
  const Internals& in = *this->Implementation;
  std::vector<std::uint32_t> counts(in.Edges.size(), 0);
  for (std::uint32_t arc : cut.GetArcs())
  {
    border += in.Patches[arc].PrivateOpen;
    for (std::size_t i = 0; i < in.Patches[arc].Count; ++i)
    {
      const EdgeUse& use = in.Uses[in.Patches[arc].First + i];
      counts[use.Edge] += use.Forward + use.Backward;
    }
  }
  return border + static_cast<std::uint64_t>(std::count(counts.begin(), counts.end(), 1u));
}
