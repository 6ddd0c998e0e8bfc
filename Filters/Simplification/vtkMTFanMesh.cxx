// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFanMesh.h"

#include <algorithm>
#include <utility>

namespace
{
// Where wedges come in order of point, as they mostly do, and no two are of the same one.
bool HasOneWedgePerPoint(const vtkMTPatch& floor)
{
  const std::vector<std::uint32_t>& points = floor.WedgePoints;
  bool isRising = true;
  for (std::size_t w = 1; w < points.size(); ++w)
  {
    isRising &= points[w - 1] < points[w];
  }
  return isRising;
}
}

bool vtkMTFanMesh::Build(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::string& error)
{
  if (locked.size() != floor.Points.size())
  {
    error =
      "there are " + std::to_string(floor.Points.size()) + " points but " + std::to_string(locked.size()) + " locks";
    return false;
  }
  if (!this->TakeTriangles(floor, error))
  {
    return false;
  }
  // Until the fans are known, Vertex holds points.
  this->Opposite = vtkMTHalfedgePairs::Find(this->Vertex);
  this->SplitIntoFans(floor.Points.size(), locked);
  this->TakeWedges(floor);
  if (!this->Wedge.empty())
  {
    this->FindSeams();
  }
  return true;
}

bool vtkMTFanMesh::TakeTriangles(const vtkMTPatch& floor, std::string& error)
{
  const std::size_t triangles = floor.Triangles.size();
  if (triangles >= std::size_t(None) / 3)
  {
    error = std::to_string(triangles) + " triangles are too many for one region";
    return false;
  }
  const std::size_t wedges = floor.GetNumberOfWedges();
  const std::size_t points = floor.Points.size();
  const std::uint32_t* const pointOf = floor.WedgePoints.empty() ? nullptr : floor.WedgePoints.data();
  const auto isPoint = [points](std::uint32_t p) { return p < points; };
  if (pointOf && !std::all_of(floor.WedgePoints.begin(), floor.WedgePoints.end(), isPoint))
  {
    error = "a wedge has a point that does not exist";
    return false;
  }
  this->Vertex.resize(3 * triangles);
  this->Wedge.resize(HasOneWedgePerPoint(floor) ? 0 : 3 * triangles);
  std::uint32_t* vertex = this->Vertex.data();
  std::uint32_t* wedge = this->Wedge.data();
  const bool hasWedges = wedge != nullptr;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const vtkMTTriangle w = floor.Triangles[t];
    if (std::max({ w[0], w[1], w[2] }) >= wedges)
    {
      error = "triangle " + std::to_string(t) + " has a wedge that does not exist";
      return false;
    }
    const vtkMTTriangle p = pointOf ? vtkMTTriangle{ pointOf[w[0]], pointOf[w[1]], pointOf[w[2]] } : w;
    std::copy(p.begin(), p.end(), vertex);
    const std::ptrdiff_t taken = p[0] != p[1] && p[1] != p[2] && p[2] != p[0] ? 3 : 0;
    vertex += taken;
    if (hasWedges)
    {
      std::copy(w.begin(), w.end(), wedge);
      wedge += taken;
    }
  }
  this->Vertex.resize(static_cast<std::size_t>(vertex - this->Vertex.data()));
  this->Wedge.resize(hasWedges ? this->Vertex.size() : 0);
  return true;
}

// Pairs edges that join the same two vertices when they are two, opposite, and not of twin triangles.
void vtkMTFanMesh::PairEqual(std::vector<std::uint32_t>& edges)
{
  if (edges.size() != 2)
  {
    return;
  }
  const std::uint32_t e = edges[0];
  const std::uint32_t f = edges[1];
  if (this->Vertex[e] == this->Vertex[Next(f)] && this->Vertex[Previous(e)] != this->Vertex[Previous(f)])
  {
    this->Opposite[e] = f;
    this->Opposite[f] = e;
  }
}

void vtkMTFanMesh::SplitIntoFans(std::size_t points, const std::vector<unsigned char>& locked)
{
  const auto corners = static_cast<std::uint32_t>(this->Vertex.size());
  std::vector<std::uint32_t> vertexOfCorner(corners, None);
  std::vector<std::uint32_t> vertexOfPoint(points, None); // its first fan
  this->Point.clear();
  this->Lock.clear();
  bool split = false;
  for (std::uint32_t c = 0; c < corners; ++c)
  {
    if (vertexOfCorner[c] != None)
    {
      continue;
    }
    const std::uint32_t point = this->Vertex[c];
    const auto vertex = static_cast<std::uint32_t>(this->Point.size());
    this->Point.push_back(point);
    this->Lock.push_back(locked[point] ? Outside : Free);
    if (vertexOfPoint[point] == None)
    {
      vertexOfPoint[point] = vertex;
    }
    else
    {
      split = true;
      this->Lock[vertexOfPoint[point]] |= NonManifold;
      this->Lock[vertex] |= NonManifold;
    }
    this->WalkFan(c, vertex, vertexOfCorner);
  }
  this->Vertex.swap(vertexOfCorner);
  if (split)
  {
    this->PairAgain();
  }
}

void vtkMTFanMesh::WalkFan(std::uint32_t corner, std::uint32_t vertex, std::vector<std::uint32_t>& vertexOfCorner) const
{
  std::uint32_t c = corner;
  do
  {
    vertexOfCorner[c] = vertex;
    c = this->Opposite[Previous(c)];
  } while (c != None && c != corner);
  if (c == corner)
  {
    return;
  }
  for (c = this->Opposite[corner]; c != None; c = this->Opposite[c])
  {
    c = Next(c);
    vertexOfCorner[c] = vertex;
  }
}

void vtkMTFanMesh::PairAgain()
{
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> open;
  for (std::uint32_t c = 0; c < this->Vertex.size(); ++c)
  {
    const std::uint32_t a = this->Vertex[c];
    const std::uint32_t b = this->Vertex[Next(c)];
    if (this->Opposite[c] == None && (this->Lock[a] & NonManifold) && (this->Lock[b] & NonManifold))
    {
      open.push_back({ { std::min(a, b), std::max(a, b) }, c });
    }
  }
  std::sort(open.begin(), open.end());
  std::vector<std::uint32_t> equal;
  for (std::size_t i = 0; i < open.size();)
  {
    equal.clear();
    const auto key = open[i].first;
    for (; i < open.size() && open[i].first == key; ++i)
    {
      equal.push_back(open[i].second);
    }
    this->PairEqual(equal);
  }
}

// Of the vertices.
void vtkMTFanMesh::TakeWedges(const vtkMTPatch& floor)
{
  this->WedgeOf.resize(this->Point.size());
  for (std::size_t c = 0; c < this->Wedge.size(); ++c)
  {
    this->WedgeOf[this->Vertex[c]] = this->Wedge[c];
  }
  if (this->Wedge.empty())
  {
    std::vector<std::uint32_t> ofPoints(floor.WedgePoints.empty() ? 0 : floor.Points.size());
    for (std::uint32_t w = 0; w < floor.WedgePoints.size(); ++w)
    {
      ofPoints[floor.WedgePoints[w]] = w;
    }
    std::transform(this->Point.begin(), this->Point.end(), this->WedgeOf.begin(),
      [&](std::uint32_t point) { return ofPoints.empty() ? point : ofPoints[point]; });
  }
}

void vtkMTFanMesh::FindSeams()
{
  for (std::uint32_t e = 0; e < this->Opposite.size(); ++e)
  {
    const std::uint32_t f = this->Opposite[e];
    if (f != None && (this->Wedge[e] != this->Wedge[Next(f)] || this->Wedge[Next(e)] != this->Wedge[f]))
    {
      this->Seams = true;
      return;
    }
  }
}
