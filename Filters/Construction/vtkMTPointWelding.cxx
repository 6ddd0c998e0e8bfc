// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPointWelding.h"

#include "vtkMTHalfedgePairs.h"

#include <algorithm>
#include <cstring>
#include <numeric>

using Place = vtkMTInputBlock::Place;

struct vtkMTPointWelding::Edge
{
  std::uint64_t Key;
  std::uint32_t From; // points
  std::uint32_t To;
  Place PlaceOfFrom;
  Place PlaceOfTo;
  std::int64_t Part;
};

struct vtkMTPointWelding::Union
{
  std::uint64_t Key; // of the place
  std::uint32_t A;
  std::uint32_t B;
};

namespace
{
// Equal places have equal hashes; nothing depends on unequal ones having different ones. Zero has one sign only.
std::uint64_t Hash(const Place& place)
{
  std::uint64_t hash = 0;
  for (const double x : place)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  return hash;
}

// Part and places of an edge, whatever its direction.
using Ends = std::pair<std::int64_t, std::pair<Place, Place>>;
Ends GetEnds(std::int64_t part, const Place& a, const Place& b)
{
  return { part, a < b ? std::make_pair(a, b) : std::make_pair(b, a) };
}

std::int32_t GetPart(const vtkMTInputBlock& block, std::size_t triangle, int column)
{
  std::int32_t part = 0;
  if (column >= 0)
  {
    std::memcpy(&part, block.Columns[static_cast<std::size_t>(column)].data() + triangle * sizeof(part), sizeof(part));
  }
  return part;
}

class UnionFind
{
public:
  explicit UnionFind(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
  }
  std::size_t Find(std::size_t x)
  {
    while (this->Parent[x] != x)
    {
      this->Parent[x] = this->Parent[this->Parent[x]];
      x = this->Parent[x];
    }
    return x;
  }
  // The smaller index stays the root, so that the result does not depend on the order of the calls.
  void Unite(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> Parent;
};
}

vtkMTPointWelding::vtkMTPointWelding(vtkMTSpoolStore& store, std::size_t memory)
  : Store(store)
  , Memory(memory)
  , Open(std::make_unique<vtkMTRecordSort>(store, sizeof(Edge), memory / 2))
  , Border(std::make_unique<vtkMTRecordSort>(store, sizeof(Edge), memory / 2))
{
}

vtkMTPointWelding::~vtkMTPointWelding() = default;

bool vtkMTPointWelding::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

//------------------------------------------------------------------------------
// Border edges
vtkMTPointWelding::BlockEdges vtkMTPointWelding::FindEdges(const vtkMTInputBlock& block)
{
  const vtkMTHalfedgePairs pairs(block.Triangles, block.Points.size());
  BlockEdges result;
  for (std::uint32_t t = 0; t < block.Triangles.size(); ++t)
  {
    const vtkMTInputBlock::Triangle& points = block.Triangles[t];
    const bool isOpen[4] = { block.IsOpen[points[0]] != 0, block.IsOpen[points[1]] != 0, block.IsOpen[points[2]] != 0,
      block.IsOpen[points[0]] != 0 };
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      if (isOpen[c] && isOpen[c + 1])
      {
        result.Open.push_back(3 * t + c);
      }
      else if (pairs.Partners[3 * std::size_t(t) + c] == vtkMTHalfedgePairs::None)
      {
        result.Border.push_back(3 * t + c);
      }
    }
  }
  return result;
}

bool vtkMTPointWelding::Add(const vtkMTInputBlock& block, const BlockEdges& edges, int partColumn)
{
  for (const std::uint32_t corner : edges.Open)
  {
    Edge edge = MakeEdge(block, corner, partColumn);
    edge.Key = (std::uint64_t(std::min(edge.From, edge.To)) << 32) | std::max(edge.From, edge.To);
    if (!this->Open->Add(&edge))
    {
      return this->Fail(this->Open->GetError());
    }
  }
  for (const std::uint32_t corner : edges.Border)
  {
    if (!this->AddBorderEdge(MakeEdge(block, corner, partColumn)))
    {
      return false;
    }
  }
  return true;
}

vtkMTPointWelding::Edge vtkMTPointWelding::MakeEdge(const vtkMTInputBlock& block, std::uint32_t corner, int partColumn)
{
  const vtkMTInputBlock::Triangle& t = block.Triangles[corner / 3];
  const std::uint32_t from = t[corner % 3];
  const std::uint32_t to = t[(corner + 1) % 3];
  return { 0, block.Points[from], block.Points[to], block.Places[from], block.Places[to],
    GetPart(block, corner / 3, partColumn) };
}

bool vtkMTPointWelding::AddBorderEdge(const Edge& edge)
{
  Edge keyed = edge;
  keyed.Key = Hash(edge.PlaceOfFrom) + Hash(edge.PlaceOfTo);
  return this->Border->Add(&keyed) || this->Fail(this->Border->GetError());
}

bool vtkMTPointWelding::FindBorderAmongOpen()
{
  Edge last{};
  std::uint64_t uses = 0;
  bool good = this->Open->Finish();
  while (const unsigned char* record = good ? this->Open->Next() : nullptr)
  {
    Edge edge;
    std::memcpy(&edge, record, sizeof(edge));
    if (uses > 0 && edge.Key != last.Key)
    {
      good = uses > 1 || this->AddBorderEdge(last);
      uses = 0;
    }
    last = edge;
    ++uses;
  }
  good = good && !this->Open->HasFailed() && (uses != 1 || this->AddBorderEdge(last));
  if (!good)
  {
    return this->Fail(this->Open->GetError() + this->Border->GetError());
  }
  this->Open.reset();
  return true;
}

//------------------------------------------------------------------------------
// Pairs of border edges
bool vtkMTPointWelding::JoinEdges()
{
  std::vector<Edge> edges; // with one key
  bool good = this->Border->Finish();
  while (const unsigned char* record = good ? this->Border->Next() : nullptr)
  {
    Edge edge;
    std::memcpy(&edge, record, sizeof(edge));
    good = edges.empty() || edges[0].Key == edge.Key || this->JoinEdgesAtPlaces(edges);
    edges.push_back(edge);
  }
  good = good && !this->Border->HasFailed() && this->JoinEdgesAtPlaces(edges);
  if (!good)
  {
    return this->Fail(this->Border->GetError() + this->Unions->GetError());
  }
  this->Border.reset();
  return true;
}

// Empties the list.
bool vtkMTPointWelding::JoinEdgesAtPlaces(std::vector<Edge>& edges)
{
  const auto ends = [](const Edge& edge) { return GetEnds(edge.Part, edge.PlaceOfFrom, edge.PlaceOfTo); };
  std::stable_sort(edges.begin(), edges.end(), [&ends](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  bool added = true;
  for (std::size_t i = 0; added && i < edges.size();)
  {
    std::size_t end = i + 1;
    while (end < edges.size() && ends(edges[end]) == ends(edges[i]))
    {
      ++end;
    }
    const Edge& a = edges[i];
    const Edge& b = edges[end - 1];
    if (end - i == 2 && a.PlaceOfFrom == b.PlaceOfTo)
    {
      const Union first{ Hash(a.PlaceOfFrom), a.From, b.To };
      const Union second{ Hash(a.PlaceOfTo), a.To, b.From };
      added = this->Unions->Add(&first) && this->Unions->Add(&second);
      ++this->StitchedEdges;
    }
    i = end;
  }
  edges.clear();
  return added;
}

//------------------------------------------------------------------------------
// Points that have become one
bool vtkMTPointWelding::SolvePlaces()
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unions; // with one key
  std::uint64_t last = 0;
  bool good = this->Unions->Finish();
  while (const unsigned char* record = good ? this->Unions->Next() : nullptr)
  {
    Union join;
    std::memcpy(&join, record, sizeof(join));
    good = unions.empty() || join.Key == last || this->SolvePlace(unions);
    last = join.Key;
    unions.emplace_back(join.A, join.B);
  }
  good = good && !this->Unions->HasFailed() && this->SolvePlace(unions) && this->Roots->Finish();
  if (!good)
  {
    return this->Fail(this->Unions->GetError() + this->Roots->GetError());
  }
  this->Unions.reset();
  return true;
}

// Empties the list.
bool vtkMTPointWelding::SolvePlace(std::vector<std::pair<std::uint32_t, std::uint32_t>>& unions)
{
  std::vector<std::uint32_t> points;
  for (const auto& [a, b] : unions)
  {
    points.push_back(a);
    points.push_back(b);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto find = [&points](std::uint32_t point)
  { return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin()); };
  UnionFind identity(points.size());
  for (const auto& [a, b] : unions)
  {
    identity.Unite(find(a), find(b));
  }
  std::vector<std::size_t> members(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ++members[identity.Find(i)];
  }
  bool added = true;
  for (std::size_t i = 0; added && i < points.size(); ++i)
  {
    const std::size_t root = identity.Find(i);
    if (members[root] > 1)
    {
      const std::uint64_t entry = (std::uint64_t(points[i]) << 32) | points[root];
      added = this->Roots->Add(&entry);
      this->StitchedPoints += root != i ? 1 : 0;
    }
  }
  unions.clear();
  return added;
}

bool vtkMTPointWelding::Finish()
{
  if (!this->FindBorderAmongOpen())
  {
    return false;
  }
  this->Unions = std::make_unique<vtkMTRecordSort>(this->Store, sizeof(Union), this->Memory / 2);
  if (!this->JoinEdges())
  {
    return false;
  }
  this->Roots = std::make_unique<vtkMTRecordSort>(this->Store, sizeof(std::uint64_t), this->Memory / 2);
  if (!this->SolvePlaces())
  {
    return false;
  }
  const unsigned char* record = this->Roots->Next();
  this->NextRoot = record ? vtkMTRecordSort::GetKey(record) : ~std::uint64_t(0);
  return !this->Roots->HasFailed() || this->Fail(this->Roots->GetError());
}

std::uint32_t vtkMTPointWelding::FindRoot(std::uint32_t point)
{
  while ((this->NextRoot >> 32) < point)
  {
    const unsigned char* record = this->Roots->Next();
    this->NextRoot = record ? vtkMTRecordSort::GetKey(record) : ~std::uint64_t(0);
    this->Error = this->Roots->GetError();
  }
  return (this->NextRoot >> 32) == point ? static_cast<std::uint32_t>(this->NextRoot) : None;
}
