// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFractalSphere.h"

#include "vtkMTPerlinNoise.h"
#include "vtkMTSinglePrecision.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = std::array<double, 3>;
using Row = std::vector<Point>;

constexpr int Octaves = 8;
constexpr std::size_t BlockPoints = 16384;
constexpr std::size_t BlockTriangles = 16384;

// Corners of the icosahedron, before scaling; q is the golden ratio.
constexpr double Golden = 1.6180339887498948482;
constexpr double Corners[12][3] = { { -1, Golden, 0 }, { 1, Golden, 0 }, { -1, -Golden, 0 }, { 1, -Golden, 0 },
  { 0, -1, Golden }, { 0, 1, Golden }, { 0, -1, -Golden }, { 0, 1, -Golden }, { Golden, 0, -1 }, { Golden, 0, 1 },
  { -Golden, 0, -1 }, { -Golden, 0, 1 } };
constexpr int Faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
  { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 },
  { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };

Point ToSphere(const Point& p)
{
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return { p[0] / length, p[1] / length, p[2] / length };
}

// Symmetric in its arguments bit for bit, so an edge is the same from both of its faces.
Point Middle(const Point& a, const Point& b)
{
  return ToSphere({ a[0] + b[0], a[1] + b[1], a[2] + b[2] });
}

/**
 * The rows of one face, subdivided `levels` times: row r has r + 1 points, from the face's side 01 to its side 02; row
 * 0 is corner 0. A row is made from at most two rows of the level above, of which the last two are kept.
 */
class FaceRows
{
public:
  void Reset(const Point& corner0, const Point& corner1, const Point& corner2, int levels)
  {
    this->Kept.assign(static_cast<std::size_t>(levels) + 1, {});
    this->Kept[0][0] = { 0, { corner0 } };
    this->Kept[0][1] = { 1, { corner1, corner2 } };
  }

  const Row& Get(int level, std::uint64_t row)
  {
    Entry& entry = this->Kept[static_cast<std::size_t>(level)][row & 1];
    if (entry.Number != row)
    {
      this->Make(level, row, entry.Points);
      entry.Number = row;
    }
    return entry.Points;
  }

private:
  struct Entry
  {
    std::uint64_t Number = ~std::uint64_t(0);
    Row Points;
  };

  void Make(int level, std::uint64_t row, Row& points)
  {
    const Row& above = this->Get(level - 1, row / 2);
    points.resize(row + 1);
    if (row % 2 == 0)
    {
      for (std::size_t c = 0; c <= row; ++c)
      {
        points[c] = c % 2 == 0 ? above[c / 2] : Middle(above[c / 2], above[c / 2 + 1]);
      }
      return;
    }
    const Row& below = this->Get(level - 1, row / 2 + 1);
    for (std::size_t c = 0; c <= row; ++c)
    {
      points[c] = Middle(above[c / 2], below[(c + 1) / 2]);
    }
  }

  std::vector<std::array<Entry, 2>> Kept; // per level, the last even and the last odd row
};

struct Topology
{
  std::array<std::array<int, 2>, 30> Edges;       // corners, the smaller first
  std::array<std::array<int, 3>, 20> EdgesOfFace; // sides 01, 12, 02
  Topology()
  {
    int count = 0;
    for (int face = 0; face < 20; ++face)
    {
      constexpr int sides[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
      for (int side = 0; side < 3; ++side)
      {
        const std::array<int, 2> ends = { std::min(Faces[face][sides[side][0]], Faces[face][sides[side][1]]),
          std::max(Faces[face][sides[side][0]], Faces[face][sides[side][1]]) };
        const auto end = this->Edges.begin() + count;
        const auto found = std::find(this->Edges.begin(), end, ends);
        if (found == end)
        {
          this->Edges[static_cast<std::size_t>(count++)] = ends;
        }
        this->EdgesOfFace[face][side] = static_cast<int>(found - this->Edges.begin());
      }
    }
  }
};
}

struct vtkMTFractalSphere::Internals
{
  int Levels;
  std::uint64_t Segments; // of one edge of the icosahedron: 2^Levels
  vtkMTPerlinNoise Noise;
  Topology Shape;
  std::array<double, Octaves> Amplitudes;
  std::array<double, Octaves> Frequencies;
  std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;

  int PointStage = 0; // 0: corners; 1 .. 30: edges; 31 .. 50: insides of faces; 51: done
  std::uint64_t PointRow = 0;
  FaceRows Rows;
  int Face = 0; // of the next triangle
  std::uint64_t FaceRow = 0;

  Internals(int levels, std::uint64_t seed)
    : Levels(levels)
    , Segments(std::uint64_t(1) << levels)
    , Noise(seed)
  {
    double amplitude = 0.25;
    double frequency = 1.7;
    for (int o = 0; o < Octaves; ++o)
    {
      this->Amplitudes[o] = amplitude;
      this->Frequencies[o] = frequency;
      amplitude *= 0.47;
      frequency *= 2.03;
    }
  }

  std::uint64_t EdgePoints() const { return this->Segments - 1; }
  std::uint64_t InnerPoints() const { return (this->Segments - 1) * (this->Segments - 2) / 2; }

  static Point GetCorner(int corner)
  {
    return ToSphere({ Corners[corner][0], Corners[corner][1], Corners[corner][2] });
  }

  // The point at distance `step` (in segments) from the side's first corner.
  std::uint64_t IndexOnSide(int face, int side, int firstCorner, std::uint64_t step) const
  {
    const int edge = this->Shape.EdgesOfFace[face][side];
    const bool forward = this->Shape.Edges[edge][0] == firstCorner;
    return 12 + static_cast<std::uint64_t>(edge) * this->EdgePoints() + (forward ? step : this->Segments - step) - 1;
  }

  // Index of the point in column c of row r of a face.
  std::uint64_t IndexInFace(int face, std::uint64_t r, std::uint64_t c) const
  {
    const int* corners = Faces[face];
    if (r == 0 || (r == this->Segments && (c == 0 || c == r)))
    {
      return static_cast<std::uint64_t>(corners[r == 0 ? 0 : c == 0 ? 1 : 2]);
    }
    if (c == 0 || c == r)
    {
      return this->IndexOnSide(face, c == 0 ? 0 : 2, corners[0], r);
    }
    if (r == this->Segments)
    {
      return this->IndexOnSide(face, 1, corners[1], c);
    }
    return 12 + 30 * this->EdgePoints() + static_cast<std::uint64_t>(face) * this->InnerPoints() +
      (r - 1) * (r - 2) / 2 + (c - 1);
  }

  void AppendEdge(int edge, std::vector<Point>& points)
  {
    Row line = { GetCorner(this->Shape.Edges[edge][0]), GetCorner(this->Shape.Edges[edge][1]) };
    for (int level = 0; level < this->Levels; ++level)
    {
      Row finer;
      finer.reserve(2 * line.size());
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
      {
        finer.push_back(line[i]);
        finer.push_back(Middle(line[i], line[i + 1]));
      }
      finer.push_back(line.back());
      line.swap(finer);
    }
    points.insert(points.end(), line.begin() + 1, line.end() - 1);
  }

  // One step of the enumeration: corners, an edge, or a row within a face.
  void AppendPoints(std::vector<Point>& points)
  {
    if (this->PointStage == 0)
    {
      for (int corner = 0; corner < 12; ++corner)
      {
        points.push_back(GetCorner(corner));
      }
      ++this->PointStage;
      return;
    }
    if (this->PointStage <= 30)
    {
      this->AppendEdge(this->PointStage - 1, points);
      ++this->PointStage;
      this->PointRow = 0;
      return;
    }
    if (this->PointRow == 0)
    {
      const int* corners = Faces[this->PointStage - 31];
      this->Rows.Reset(GetCorner(corners[0]), GetCorner(corners[1]), GetCorner(corners[2]), this->Levels);
      this->PointRow = 2; // the first row with a point inside
    }
    if (this->PointRow >= this->Segments)
    {
      ++this->PointStage;
      this->PointRow = 0;
      return;
    }
    const Row& row = this->Rows.Get(this->Levels, this->PointRow);
    points.insert(points.end(), row.begin() + 1, row.end() - 1);
    ++this->PointRow;
  }

  Point Displace(const Point& p) const
  {
    double factor = 1.0;
    for (int o = 0; o < Octaves; ++o)
    {
      const double f = this->Frequencies[o];
      factor += this->Amplitudes[o] * this->Noise.Evaluate(f * p[0], f * p[1], f * p[2]);
    }
    Point moved;
    for (int axis = 0; axis < 3; ++axis)
    {
      moved[axis] = vtkMTSinglePrecision::Round(factor * p[axis]);
    }
    return moved;
  }

  void AppendTriangles(TriangleBlock& block)
  {
    const std::uint64_t r = this->FaceRow;
    for (std::uint64_t c = 0; c <= r; ++c)
    {
      const std::uint64_t above = this->IndexInFace(this->Face, r, c);
      const std::uint64_t left = this->IndexInFace(this->Face, r + 1, c);
      const std::uint64_t right = this->IndexInFace(this->Face, r + 1, c + 1);
      block.Triangles.push_back({ above, left, right });
      if (c < r)
      {
        block.Triangles.push_back({ above, right, this->IndexInFace(this->Face, r, c + 1) });
      }
    }
  }
};

int vtkMTFractalSphere::ChooseSubdivisions(std::uint64_t triangles)
{
  int levels = 0;
  for (std::uint64_t count = 20; levels < MaximumSubdivisions; ++levels, count *= 4)
  {
    if (triangles <= count + (count * 4 - count) / 2)
    {
      break;
    }
  }
  return levels;
}

vtkMTFractalSphere::vtkMTFractalSphere(std::uint64_t triangles, std::uint64_t seed)
  : Implementation(new Internals(ChooseSubdivisions(triangles), seed))
{
}

vtkMTFractalSphere::~vtkMTFractalSphere() = default;

const std::vector<vtkMTArrayInfo>& vtkMTFractalSphere::GetArrays() const
{
  return this->Implementation->Arrays;
}

std::uint64_t vtkMTFractalSphere::GetNumberOfPoints() const
{
  return 10 * this->Implementation->Segments * this->Implementation->Segments + 2;
}

std::uint64_t vtkMTFractalSphere::GetNumberOfTriangles() const
{
  return 20 * this->Implementation->Segments * this->Implementation->Segments;
}

const std::map<std::string, std::int64_t>& vtkMTFractalSphere::GetReport() const
{
  return this->Implementation->Report;
}

bool vtkMTFractalSphere::Rewind()
{
  Internals& own = *this->Implementation;
  own.PointStage = 0;
  own.PointRow = 0;
  own.Face = 0;
  own.FaceRow = 0;
  return true;
}

bool vtkMTFractalSphere::NextPoints(PointBlock& block)
{
  Internals& own = *this->Implementation;
  block.Points.clear();
  block.Columns.clear();
  while (own.PointStage <= 50 && block.Points.size() < BlockPoints)
  {
    own.AppendPoints(block.Points);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(block.Points.size()), 1024,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Point& point = block.Points[static_cast<std::size_t>(i)];
        point = own.Displace(point);
      }
    });
  return true;
}

bool vtkMTFractalSphere::NextTriangles(TriangleBlock& block)
{
  Internals& own = *this->Implementation;
  block.Triangles.clear();
  block.CellIds.clear();
  block.Columns.clear();
  const std::uint64_t perFace = own.Segments * own.Segments;
  const std::uint64_t first = static_cast<std::uint64_t>(own.Face) * perFace + own.FaceRow * own.FaceRow;
  while (own.Face < 20 && block.Triangles.size() < BlockTriangles)
  {
    own.AppendTriangles(block);
    if (++own.FaceRow == own.Segments)
    {
      own.FaceRow = 0;
      ++own.Face;
    }
  }
  for (std::size_t i = 0; i < block.Triangles.size(); ++i)
  {
    block.CellIds.push_back(static_cast<std::int64_t>(first + i));
  }
  return true;
}
