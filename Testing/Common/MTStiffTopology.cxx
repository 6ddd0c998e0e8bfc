// SPDX-License-Identifier: BSD-3-Clause
#include "MTStiffTopology.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
using namespace MTExactPredicates;

std::uint32_t FindRoot(std::vector<std::uint32_t>& parents, std::uint32_t p)
{
  while (parents[p] != p)
  {
    p = parents[p] = parents[parents[p]];
  }
  return p;
}

bool PairMeets(const MTStiffTopology::Mesh& mesh, std::size_t s, std::size_t t)
{
  auto a = mesh.Triangles[s];
  auto b = mesh.Triangles[t];
  // Shared corners first, in the same order.
  int shared = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = shared; j < 3; ++j)
    {
      if (a[i] == b[j])
      {
        std::swap(a[i], a[shared]);
        std::swap(b[j], b[shared]);
        ++shared;
        break;
      }
    }
  }
  const Triangle x{ mesh.Points[a[0]], mesh.Points[a[1]], mesh.Points[a[2]] };
  const Triangle y{ mesh.Points[b[0]], mesh.Points[b[1]], mesh.Points[b[2]] };
  return shared == 0 ? TrianglesMeet(x, y)
    : shared == 1    ? TrianglesMeetBeyondCorner(x, y)
    : shared == 2    ? TrianglesFold(x, y)
                     : true;
}

// The triangles that are not degenerate, with their boxes, sorted along the longest axis.
struct SortedBoxes
{
  struct Box
  {
    Point Low;
    Point High;
    std::size_t Triangle;
  };
  std::vector<Box> Boxes;
  int Axis = 0;

  explicit SortedBoxes(const MTStiffTopology::Mesh& mesh)
  {
    Point sums{ 0, 0, 0 };
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const Triangle x = mesh.GetTriangle(t);
      if (IsDegenerate(x))
      {
        continue;
      }
      Box box{ x[0], x[0], t };
      for (int i = 0; i < 3; ++i)
      {
        box.Low[i] = std::min({ x[0][i], x[1][i], x[2][i] });
        box.High[i] = std::max({ x[0][i], x[1][i], x[2][i] });
        sums[i] += box.High[i] - box.Low[i];
      }
      this->Boxes.push_back(box);
    }
    // Along the axis on which boxes are short beside the mesh, fewest pairs overlap.
    double best = -1.0;
    for (int i = 0; i < 3 && !this->Boxes.empty(); ++i)
    {
      const auto byLow = [i](const Box& a, const Box& b) { return a.Low[i] < b.Low[i]; };
      const auto ends = std::minmax_element(this->Boxes.begin(), this->Boxes.end(), byLow);
      const double share =
        static_cast<double>(ends.second->Low[i] - ends.first->Low[i]) / (1.0 + static_cast<double>(sums[i]));
      this->Axis = share > best ? i : this->Axis;
      best = std::max(best, share);
    }
    std::sort(this->Boxes.begin(), this->Boxes.end(),
      [axis = this->Axis](const Box& a, const Box& b)
      { return std::make_pair(a.Low[axis], a.Triangle) < std::make_pair(b.Low[axis], b.Triangle); });
  }

  static bool Overlap(const Box& a, const Box& b)
  {
    return a.Low[0] <= b.High[0] && b.Low[0] <= a.High[0] && a.Low[1] <= b.High[1] && b.Low[1] <= a.High[1] &&
      a.Low[2] <= b.High[2] && b.Low[2] <= a.High[2];
  }
};
}

//------------------------------------------------------------------------------
MTStiffTopology MTStiffTopology::Count(const Mesh& mesh)
{
  MTStiffTopology found;
  std::vector<std::uint32_t> parents(mesh.Points.size());
  std::iota(parents.begin(), parents.end(), 0u);
  std::vector<unsigned char> isUsed(mesh.Points.size(), 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    for (int c = 0; c < 3; ++c)
    {
      isUsed[corners[c]] = 1;
      edges.push_back(std::minmax(corners[c], corners[(c + 1) % 3]));
      parents[FindRoot(parents, corners[c])] = FindRoot(parents, corners[(c + 1) % 3]);
    }
    found.Degenerate += IsDegenerate(mesh.GetTriangle(t)) ? 1 : 0;
  }
  std::sort(edges.begin(), edges.end());
  std::int64_t numberOfEdges = 0;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next)
  {
    for (next = i; next < edges.size() && edges[next] == edges[i]; ++next)
    {
    }
    ++numberOfEdges;
    found.BorderEdges += next == i + 1 ? 1 : 0;
  }
  std::int64_t points = 0;
  for (std::uint32_t p = 0; p < parents.size(); ++p)
  {
    points += isUsed[p];
    found.Components += isUsed[p] && parents[p] == p ? 1 : 0;
  }
  found.Euler = points - numberOfEdges + static_cast<std::int64_t>(mesh.Triangles.size());
  return found;
}

//------------------------------------------------------------------------------
std::int64_t MTStiffTopology::CountIntersections(const Mesh& mesh, std::size_t limit)
{
  const SortedBoxes sorted(mesh);
  const auto& boxes = sorted.Boxes;
  std::size_t looked = 0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].Low[sorted.Axis] <= boxes[i].High[sorted.Axis]; ++j)
    {
      if (!SortedBoxes::Overlap(boxes[i], boxes[j]))
      {
        continue;
      }
      if (++looked > limit)
      {
        return -1;
      }
      count += PairMeets(mesh, boxes[i].Triangle, boxes[j].Triangle) ? 1 : 0;
    }
  }
  return count;
}
