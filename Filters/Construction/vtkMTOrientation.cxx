// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrientation.h"

#include "vtkMTRadixSort.h"

#include <algorithm>
#include <numeric>
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

// Triangles that are connected, and which of them agree with each other.
class ParityUnion
{
public:
  explicit ParityUnion(std::size_t size)
    : Parent(size)
    , Parity(size, 0)
    , IsOrientable(size, 1)
    , HasConflict(size, 0)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0u);
  }

  // The smallest of the triangles that are connected with it; parity with respect to that one.
  std::uint32_t Find(std::uint32_t x, bool& parity)
  {
    // Twice along the path: first to the root, then every parent is set to it.
    std::uint32_t root = x;
    bool sum = false;
    while (this->Parent[root] != root)
    {
      sum = sum != (this->Parity[root] != 0);
      root = this->Parent[root];
    }
    parity = sum;
    while (this->Parent[x] != root && x != root)
    {
      const std::uint32_t next = this->Parent[x];
      const bool own = this->Parity[x] != 0;
      this->Parent[x] = root;
      this->Parity[x] = sum ? 1 : 0;
      sum = sum != own;
      x = next;
    }
    return root;
  }

  void Connect(std::uint32_t a, std::uint32_t b, bool conflict)
  {
    bool parityOfA = false;
    bool parityOfB = false;
    const std::uint32_t rootOfA = this->Find(a, parityOfA);
    const std::uint32_t rootOfB = this->Find(b, parityOfB);
    const std::uint32_t root = std::min(rootOfA, rootOfB);
    const std::uint32_t other = std::max(rootOfA, rootOfB);
    const bool differ = (parityOfA != parityOfB) != conflict;
    if (root == other)
    {
      this->IsOrientable[root] = this->IsOrientable[root] && !differ ? 1 : 0;
    }
    else
    {
      this->Parent[other] = root;
      this->Parity[other] = differ ? 1 : 0;
      this->IsOrientable[root] = this->IsOrientable[root] && this->IsOrientable[other] ? 1 : 0;
    }
    this->HasConflict[root] = this->HasConflict[root] || this->HasConflict[other] || conflict ? 1 : 0;
  }

  std::vector<std::uint32_t> Parent;
  std::vector<unsigned char> Parity;
  std::vector<unsigned char> IsOrientable; // of roots
  std::vector<unsigned char> HasConflict;
};

using Use = std::pair<std::uint64_t, std::uint32_t>; // an edge by its ends, and 3 triangle + corner

// Connects the triangles at every edge that exactly two have.
void ConnectNeighbours(std::vector<Use>& uses, const vtkMTPatch& mesh, ParityUnion& parts)
{
  std::vector<Use> scratch;
  vtkMTRadixSort::Sort(uses, scratch, [](const Use& use) { return use.first; });
  const auto start = [&mesh](std::uint32_t slot) { return mesh.GetPointsOfTriangle(slot / 3)[slot % 3]; };
  for (std::size_t i = 0; i < uses.size();)
  {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].first == uses[i].first)
    {
      ++end;
    }
    if (end - i == 2)
    {
      const std::uint32_t a = uses[i].second;
      const std::uint32_t b = uses[i + 1].second;
      parts.Connect(a / 3, b / 3, start(a) == start(b));
    }
    i = end;
  }
}
}

//------------------------------------------------------------------------------
void vtkMTOrientation::Fragment::Run(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& numbers)
{
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.Triangles.size());
  ParityUnion parts(count);
  std::vector<Use> uses;
  uses.reserve(3 * std::size_t(count));
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const std::uint32_t a = p[c];
      const std::uint32_t b = p[(c + 1) % 3];
      if (a < mesh.Ids.size() && b < mesh.Ids.size())
      {
        const auto from = static_cast<std::uint32_t>(mesh.Ids[a]);
        const auto to = static_cast<std::uint32_t>(mesh.Ids[b]);
        this->OpenEdges.push_back({ std::min(from, to), std::max(from, to), t, to < from });
        continue;
      }
      uses.emplace_back((std::uint64_t(std::min(a, b)) << 32) | std::max(a, b), 3 * t + c);
    }
  }
  ConnectNeighbours(uses, mesh, parts);
  // Roots are the smallest of their triangles, so components are numbered in the order of their first ones.
  this->ComponentOf.assign(count, None);
  this->IsTurned.assign(count, 0);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    bool isTurned = false;
    const std::uint32_t root = parts.Find(t, isTurned);
    if (root == t)
    {
      this->ComponentOf[t] = static_cast<std::uint32_t>(this->Components.size());
      this->Components.emplace_back();
      this->Components.back().First = numbers[t];
      this->Components.back().IsOrientable = parts.IsOrientable[root] != 0;
      this->Components.back().HasConflict = parts.HasConflict[root] != 0;
    }
    this->ComponentOf[t] = this->ComponentOf[root];
    this->IsTurned[t] = isTurned ? 1 : 0;
    Component& component = this->Components[this->ComponentOf[t]];
    ++component.Triangles;
    component.Turned += isTurned ? 1 : 0;
  }
  for (const OpenEdge& edge : this->OpenEdges)
  {
    this->Components[this->ComponentOf[edge.Triangle]].IsOpen = true;
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
