// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrientation.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);

// The other triangle at each of a triangle's edges where there is exactly one.
class Adjacency
{
public:
  explicit Adjacency(const vtkMTPatch& mesh)
    : Across(3 * mesh.Triangles.size(), None)
    , RunsAlong(3 * mesh.Triangles.size(), 0)
  {
    std::vector<std::size_t> first(mesh.Points.size() + 1, 0);
    this->ForEdges(mesh, [&first](std::uint32_t low, std::uint32_t, std::size_t) { ++first[low + std::size_t(1)]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge> edges(this->Across.size());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    this->ForEdges(mesh,
      [&](std::uint32_t low, std::uint32_t high, std::size_t slot) {
        edges[next[low]++] = { high, slot };
      });
    for (std::size_t p = 0; p + 1 < first.size(); ++p)
    {
      this->Pair(mesh, edges.data() + first[p], edges.data() + first[p + 1]);
    }
  }

  std::uint32_t GetAcross(std::size_t slot) const { return this->Across[slot]; }
  /// Whether both triangles at this edge run along it in the same direction.
  bool IsConflict(std::size_t slot) const { return this->RunsAlong[slot] != 0; }
  bool HasConflicts() const { return this->Conflicts > 0; }

private:
  struct Edge
  {
    std::uint32_t High;
    std::size_t Slot; // 3 triangle + corner at which it begins
  };

  template <class Visit>
  void ForEdges(const vtkMTPatch& mesh, const Visit& visit) const
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
      for (std::size_t c = 0; c < 3; ++c)
      {
        const std::uint32_t a = p[c];
        const std::uint32_t b = p[(c + 1) % 3];
        visit(std::min(a, b), std::max(a, b), 3 * t + c);
      }
    }
  }

  // Of the edges with one smaller end those that have exactly two triangles.
  void Pair(const vtkMTPatch& mesh, Edge* begin, Edge* end)
  {
    std::sort(
      begin, end, [](const Edge& a, const Edge& b) { return a.High != b.High ? a.High < b.High : a.Slot < b.Slot; });
    for (Edge* edge = begin; edge != end;)
    {
      Edge* after = edge;
      while (after != end && after->High == edge->High)
      {
        ++after;
      }
      if (after - edge == 2)
      {
        const std::size_t slots[2] = { edge[0].Slot, edge[1].Slot };
        const bool conflict = GetStart(mesh, slots[0]) == GetStart(mesh, slots[1]);
        for (int i = 0; i < 2; ++i)
        {
          this->Across[slots[i]] = static_cast<std::uint32_t>(slots[1 - i] / 3);
          this->RunsAlong[slots[i]] = conflict ? 1 : 0;
        }
        this->Conflicts += conflict ? 1 : 0;
      }
      edge = after;
    }
  }

  static std::uint32_t GetStart(const vtkMTPatch& mesh, std::size_t slot)
  {
    return mesh.GetPointOfWedge(mesh.Triangles[slot / 3][slot % 3]);
  }

  std::vector<std::uint32_t> Across;
  std::vector<unsigned char> RunsAlong;
  std::size_t Conflicts = 0;
};

// One part of the mesh, from its first triangle on: who must be turned round for all to agree with that one.
class Part
{
public:
  Part(const Adjacency& adjacency, std::vector<signed char>& turn)
    : Adjacent(adjacency)
    , Turn(turn)
  {
  }

  void Walk(std::uint32_t first)
  {
    this->Triangles.assign(1, first);
    this->Turn[first] = 0;
    this->HasConflict = false;
    this->IsOrientable = true;
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      const std::uint32_t t = this->Triangles[i];
      for (std::size_t slot = 3 * std::size_t(t); slot < 3 * std::size_t(t) + 3; ++slot)
      {
        const std::uint32_t other = this->Adjacent.GetAcross(slot);
        if (other == None)
        {
          continue;
        }
        const signed char turn = this->Adjacent.IsConflict(slot) ? 1 - this->Turn[t] : this->Turn[t];
        this->HasConflict = this->HasConflict || this->Adjacent.IsConflict(slot);
        if (this->Turn[other] == Unknown)
        {
          this->Turn[other] = turn;
          this->Triangles.push_back(other);
        }
        this->IsOrientable = this->IsOrientable && this->Turn[other] == turn;
      }
    }
  }

  void Finish(vtkMTOrientation& result) const
  {
    if (!this->IsOrientable)
    {
      result.NonOrientableTriangles += this->Triangles.size();
    }
    if (!this->IsOrientable || !this->HasConflict)
    {
      return;
    }
    const auto isTurned = [this](std::uint32_t t) { return this->Turn[t] == 1; };
    const std::size_t turned =
      static_cast<std::size_t>(std::count_if(this->Triangles.begin(), this->Triangles.end(), isTurned));
    const bool keepTurned = 2 * turned > this->Triangles.size();
    for (std::uint32_t t : this->Triangles)
    {
      if (isTurned(t) != keepTurned)
      {
        result.Reversed.push_back(t);
      }
    }
  }

  static constexpr signed char Unknown = -1;

private:
  const Adjacency& Adjacent;
  std::vector<signed char>& Turn;
  std::vector<std::uint32_t> Triangles;
  bool HasConflict = false;
  bool IsOrientable = true;
};
}

vtkMTOrientation vtkMTOrientation::Run(const vtkMTPatch& mesh)
{
  vtkMTOrientation result;
  const Adjacency adjacency(mesh);
  if (!adjacency.HasConflicts())
  {
    return result;
  }
  std::vector<signed char> turn(mesh.Triangles.size(), Part::Unknown);
  Part part(adjacency, turn);
  for (std::uint32_t t = 0; t < turn.size(); ++t)
  {
    if (turn[t] == Part::Unknown)
    {
      part.Walk(t);
      part.Finish(result);
    }
  }
  std::sort(result.Reversed.begin(), result.Reversed.end());
  return result;
}
