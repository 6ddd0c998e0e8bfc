// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrientation.h"

#include "vtkMTHalfedgePairs.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);

// One triangle's use of an edge whose ends are both shared, on its way to the others.
struct EdgeRecord
{
  std::uint64_t Key;
  std::uint32_t Component;
  std::uint16_t IsTurned;
  std::uint16_t IsReversed;
};
}

//------------------------------------------------------------------------------
void vtkMTOrientation::Fragment::Run(
  const vtkMTPatch& mesh, const std::vector<std::uint32_t>& numbers, const vtkMTHalfedgePairs& pairs)
{
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.Triangles.size());
  this->ComponentOf.assign(count, None);
  this->IsTurned.assign(count, 0);
  std::vector<std::uint32_t> reached; // but their neighbours were not looked at yet
  for (std::uint32_t t = 0; t < count; ++t)
  {
    if (this->ComponentOf[t] != None)
    {
      continue;
    }
    this->ComponentOf[t] = static_cast<std::uint32_t>(this->Components.size());
    this->Components.emplace_back();
    this->Components.back().First = numbers[t];
    for (reached.push_back(t); !reached.empty();)
    {
      const std::uint32_t next = reached.back();
      reached.pop_back();
      this->Reach(next, mesh, pairs, reached);
    }
  }
  this->FindOpenEdges(mesh, pairs);
}

// Looks across the edges of a triangle that is reached. Edges that other fragments may have as well connect nothing.
void vtkMTOrientation::Fragment::Reach(
  std::uint32_t triangle, const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs, std::vector<std::uint32_t>& reached)
{
  const std::uint32_t component = this->ComponentOf[triangle];
  const bool isTurned = this->IsTurned[triangle] != 0;
  Component& part = this->Components[component];
  ++part.Triangles;
  part.Turned += isTurned ? 1 : 0;
  const std::uint32_t* corners = pairs.Corners.data() + 3 * std::size_t(triangle);
  for (std::uint32_t c = 0; c < 3; ++c)
  {
    const std::uint32_t partner = pairs.Partners[3 * std::size_t(triangle) + c];
    if (partner >= vtkMTHalfedgePairs::Other || std::max(corners[c], corners[c == 2 ? 0 : c + 1]) < mesh.Ids.size())
    {
      continue;
    }
    const std::uint32_t neighbour = partner / 3;
    const bool conflict = corners[c] == pairs.Corners[partner];
    part.HasConflict = part.HasConflict || conflict;
    if (this->ComponentOf[neighbour] == None)
    {
      this->ComponentOf[neighbour] = component;
      this->IsTurned[neighbour] = isTurned != conflict ? 1 : 0;
      reached.push_back(neighbour);
    }
    else if ((this->IsTurned[neighbour] != 0) != (isTurned != conflict))
    {
      part.IsOrientable = false;
    }
  }
}

void vtkMTOrientation::Fragment::FindOpenEdges(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs)
{
  const std::size_t shared = mesh.Ids.size();
  for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::uint32_t* corners = pairs.Corners.data() + 3 * std::size_t(t);
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const std::uint32_t next = c == 2 ? 0 : c + 1;
      if (corners[c] < shared && corners[next] < shared)
      {
        const auto from = static_cast<std::uint32_t>(mesh.Ids[corners[c]]);
        const auto to = static_cast<std::uint32_t>(mesh.Ids[corners[next]]);
        this->OpenEdges.push_back({ std::min(from, to), std::max(from, to), t, to < from });
        this->Components[this->ComponentOf[t]].IsOpen = true;
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkMTOrientation::vtkMTOrientation(vtkMTSpoolStore& store, std::size_t memory)
  : Edges(store, sizeof(EdgeRecord), memory)
{
}

// What becomes of triangles that are connected, with the figures of the report.
std::uint32_t vtkMTOrientation::Count(const Component& component)
{
  if (!component.IsOrientable)
  {
    this->NonOrientableTriangles += component.Triangles;
  }
  if (!component.IsOrientable || !component.HasConflict)
  {
    return LeaveAll;
  }
  const bool keepTurned = 2 * std::uint64_t(component.Turned) > component.Triangles;
  this->ReversedTriangles += keepTurned ? component.Triangles - component.Turned : component.Turned;
  return keepTurned ? ReverseOthers : ReverseTurned;
}

bool vtkMTOrientation::Add(const Fragment& fragment, std::vector<std::uint32_t>& components)
{
  components.clear();
  for (const Component& component : fragment.Components)
  {
    if (!component.IsOpen)
    {
      components.push_back(this->Count(component));
      continue;
    }
    if (this->Parts.size() == LeaveAll)
    {
      this->Error = "the input has too many parts";
      return false;
    }
    const std::uint32_t number = static_cast<std::uint32_t>(this->Parts.size());
    components.push_back(number);
    this->Parts.push_back({ component, number, LeaveAll, false });
  }
  for (const Fragment::OpenEdge& edge : fragment.OpenEdges)
  {
    const EdgeRecord record{ (std::uint64_t(edge.Low) << 32) | edge.High,
      components[fragment.ComponentOf[edge.Triangle]], fragment.IsTurned[edge.Triangle],
      static_cast<std::uint16_t>(edge.IsReversed ? 1 : 0) };
    if (!this->Edges.Add(&record))
    {
      this->Error = this->Edges.GetError();
      return false;
    }
  }
  return true;
}

std::uint32_t vtkMTOrientation::Find(std::uint32_t part, bool& parity)
{
  parity = false;
  while (this->Parts[part].Parent != part)
  {
    Part& own = this->Parts[part];
    const Part& parent = this->Parts[own.Parent];
    // Halve the path: a grandparent's parity is the sum.
    if (parent.Parent != own.Parent)
    {
      own.Parity = own.Parity != parent.Parity;
      own.Parent = parent.Parent;
    }
    parity = parity != own.Parity;
    part = own.Parent;
  }
  return part;
}

void vtkMTOrientation::Connect(std::uint32_t a, std::uint32_t b, bool differ, bool conflict)
{
  bool parityOfA = false;
  bool parityOfB = false;
  std::uint32_t root = this->Find(a, parityOfA);
  std::uint32_t other = this->Find(b, parityOfB);
  differ = differ != (parityOfA != parityOfB);
  if (this->Parts[other].Own.First < this->Parts[root].Own.First)
  {
    std::swap(root, other); // the root is the part with the first triangle
  }
  Component& whole = this->Parts[root].Own;
  whole.HasConflict = whole.HasConflict || conflict;
  if (root == other)
  {
    whole.IsOrientable = whole.IsOrientable && !differ;
    return;
  }
  Part& part = this->Parts[other];
  whole.HasConflict = whole.HasConflict || part.Own.HasConflict;
  whole.IsOrientable = whole.IsOrientable && part.Own.IsOrientable;
  whole.Triangles += part.Own.Triangles;
  whole.Turned += differ ? part.Own.Triangles - part.Own.Turned : part.Own.Turned;
  part.Parent = root;
  part.Parity = differ;
}

bool vtkMTOrientation::Solve()
{
  EdgeRecord first{};
  EdgeRecord second{};
  std::uint64_t uses = 0;
  const auto connect = [&]
  {
    if (uses == 2)
    {
      const bool conflict = first.IsReversed == second.IsReversed;
      this->Connect(first.Component, second.Component, conflict != (first.IsTurned != second.IsTurned), conflict);
    }
  };
  if (this->Edges.Finish())
  {
    while (const unsigned char* bytes = this->Edges.Next())
    {
      EdgeRecord record;
      std::memcpy(&record, bytes, sizeof(record));
      if (uses > 0 && record.Key != first.Key)
      {
        connect();
        uses = 0;
      }
      (uses == 0 ? first : second) = record;
      ++uses;
    }
    connect();
  }
  this->Error = this->Edges.GetError();
  this->Settle();
  return this->Error.empty();
}

void vtkMTOrientation::Settle()
{
  for (std::uint32_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->Parts[i].Parent == i)
    {
      this->Parts[i].Reverse = this->Count(this->Parts[i].Own);
    }
  }
  for (std::uint32_t i = 0; i < this->Parts.size(); ++i)
  {
    bool parity = false;
    const std::uint32_t whole = this->Parts[this->Find(i, parity)].Reverse;
    if (this->Parts[i].Parent != i)
    {
      this->Parts[i].Reverse = whole == LeaveAll || !parity ? whole
        : whole == ReverseTurned                            ? ReverseOthers
                                                            : ReverseTurned;
    }
  }
}
