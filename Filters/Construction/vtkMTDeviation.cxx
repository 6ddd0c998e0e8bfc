// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDeviation.h"

#include "vtkMTTriangleTree.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
// A convex polygon inside one triangle: clipping a triangle with a few planes leaves few corners; beyond the capacity a piece is
// halved no further.
struct Piece
{
  static constexpr int Capacity = 12;
  std::array<Vector, Capacity> Corners;
  int Count = 0;
  int Depth = 0;
  std::uint32_t Triangle = 0;

  void Append(const Vector& x) { this->Corners[this->Count++] = x; }
  Vector GetMiddle() const
  {
    Vector sum{ 0.0, 0.0, 0.0 };
    for (int i = 0; i < this->Count; ++i)
    {
      sum = Add(sum, this->Corners[i]);
    }
    return Scale(sum, 1.0 / this->Count);
  }
};

constexpr int MaximumDepth = 48;

// Splits a convex piece by the plane through `on` with normal `normal` into what lies on the normal's side and the rest. False when the
// plane leaves it whole (then only one of the two has corners).
bool Split(const Piece& piece, const Vector& on, const Vector& normal, Piece& inside, Piece& outside)
{
  inside = Piece{ {}, 0, piece.Depth + 1, piece.Triangle };
  outside = inside;
  std::array<double, Piece::Capacity> side;
  bool anyIn = false;
  bool anyOut = false;
  const double tolerance = 1e-12 * Norm(normal);
  for (int i = 0; i < piece.Count; ++i)
  {
    side[i] = Dot(Subtract(piece.Corners[i], on), normal);
    anyIn = anyIn || side[i] > tolerance;
    anyOut = anyOut || side[i] < -tolerance;
  }
  if (!anyIn || !anyOut || piece.Count + 2 > Piece::Capacity)
  {
    (anyOut ? outside : inside) = piece;
    return false;
  }
  for (int i = 0; i < piece.Count; ++i)
  {
    const int j = (i + 1) % piece.Count;
    if (side[i] >= 0.0)
    {
      inside.Append(piece.Corners[i]);
    }
    if (side[i] <= 0.0)
    {
      outside.Append(piece.Corners[i]);
    }
    if ((side[i] > 0.0 && side[j] < 0.0) || (side[i] < 0.0 && side[j] > 0.0))
    {
      const Vector cut = Lerp(piece.Corners[i], piece.Corners[j], side[i] / (side[i] - side[j]));
      inside.Append(cut);
      outside.Append(cut);
    }
  }
  return true;
}

// Across its longest side or diagonal.
bool Halve(const Piece& piece, Piece& one, Piece& other)
{
  double longest = 0.0;
  int from = 0;
  int to = 0;
  for (int i = 0; i < piece.Count; ++i)
  {
    for (int j = i + 1; j < piece.Count; ++j)
    {
      const Vector d = Subtract(piece.Corners[j], piece.Corners[i]);
      if (Dot(d, d) > longest)
      {
        longest = Dot(d, d);
        from = i;
        to = j;
      }
    }
  }
  const Vector direction = Subtract(piece.Corners[to], piece.Corners[from]);
  return longest > 0.0 && Split(piece, Lerp(piece.Corners[from], piece.Corners[to], 0.5), direction, one, other);
}

using Integer = __int128;

// Whether all corners of triangle t lie in the plane of triangle s, exactly: coordinates are integers below 2^33.
bool IsCoplanar(const vtkMTTriangleTree& treeOfT, std::uint32_t t, const vtkMTTriangleTree& treeOfS, std::uint32_t s)
{
  const auto difference = [](const Vector& a, const Vector& b)
  {
    return std::array<Integer, 3>{ static_cast<std::int64_t>(a[0] - b[0]), static_cast<std::int64_t>(a[1] - b[1]),
      static_cast<std::int64_t>(a[2] - b[2]) };
  };
  const Vector& origin = treeOfS.GetCorner(s, 0);
  const auto u = difference(treeOfS.GetCorner(s, 1), origin);
  const auto v = difference(treeOfS.GetCorner(s, 2), origin);
  const std::array<Integer, 3> normal{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  for (int c = 0; c < 3; ++c)
  {
    const auto w = difference(treeOfT.GetCorner(t, c), origin);
    if (w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2] != 0)
    {
      return false;
    }
  }
  return true;
}

// One direction: how far the triangles of one mesh are from the other.
class OneSided
{
public:
  OneSided(const vtkMTTriangleTree& from, const vtkMTTriangleTree& to, vtkMTDeviation& result, double slack)
    : From(from)
    , To(to)
    , Result(result)
    , Slack(slack)
  {
  }

  // The true distances of all points: the lower bound to start with, and candidates for the triangles' bounds.
  void VisitPoints(const vtkMTPatch& mesh, const vtkMTPoint& origin)
  {
    std::vector<unsigned char> used(mesh.Points.size(), 0);
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (std::uint32_t p : mesh.GetPointsOfTriangle(t))
      {
        used[p] = 1;
      }
    }
    this->NearestToPoint.assign(mesh.Points.size(), vtkMTTriangleTree::Hit::None);
    for (std::size_t p = 0; p < mesh.Points.size(); ++p)
    {
      if (used[p])
      {
        const vtkMTPoint& k = mesh.Points[p];
        this->NearestToPoint[p] = this->Visit({ static_cast<double>(k[0]) - static_cast<double>(origin[0]),
          static_cast<double>(k[1]) - static_cast<double>(origin[1]),
          static_cast<double>(k[2]) - static_cast<double>(origin[2]) });
      }
    }
  }

  void BoundTriangles(const vtkMTPatch& mesh, std::size_t& budget)
  {
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      Piece piece;
      piece.Triangle = t;
      for (int c = 0; c < 3; ++c)
      {
        piece.Append(this->From.GetCorner(t, c));
      }
      double bound = std::numeric_limits<double>::infinity();
      for (std::uint32_t p : mesh.GetPointsOfTriangle(t))
      {
        bound = std::min(bound, this->GetBound(piece, this->NearestToPoint[p]));
      }
      if (!this->Accept(bound))
      {
        this->BoundPieces(piece, bound, budget);
      }
    }
  }

private:
  // Raises the lower bound by the true distance at x; gives the nearest triangle.
  std::uint32_t Visit(const Vector& x)
  {
    const vtkMTTriangleTree::Hit hit = this->To.FindNearest(x);
    // What rounding may have added must not raise the lower bound.
    this->Result.LowerBound = std::max(this->Result.LowerBound, std::sqrt(hit.Distance2) - this->Slack);
    return hit.Triangle;
  }

  double GetBound(const Piece& piece, std::uint32_t s) const
  {
    double distance2 = 0.0;
    for (int i = 0; i < piece.Count; ++i)
    {
      distance2 = std::max(distance2, this->To.Project(piece.Corners[i], s).Distance2);
    }
    const double distance = std::sqrt(distance2);
    return distance <= this->Slack && IsCoplanar(this->From, piece.Triangle, this->To, s) ? 0.0 : distance + this->Slack;
  }

  bool Accept(double bound)
  {
    if (bound > std::max(vtkMTDeviation::Looseness * this->Result.LowerBound, 2.0 * this->Slack))
    {
      return false;
    }
    this->Result.UpperBound = std::max(this->Result.UpperBound, bound);
    return true;
  }

  void BoundPieces(const Piece& whole, double wholeBound, std::size_t& budget)
  {
    this->Stack.clear();
    this->Stack.push_back({ whole, wholeBound });
    while (!this->Stack.empty())
    {
      const Entry entry = this->Stack.back();
      this->Stack.pop_back();
      if (budget == 0 || entry.Shape.Depth >= MaximumDepth)
      {
        this->Result.BudgetUsedUp = true;
        this->Result.UpperBound = std::max(this->Result.UpperBound, entry.Bound);
        continue;
      }
      --budget;
      ++this->Result.Pieces;
      this->BoundPiece(entry.Shape, entry.Bound);
    }
  }

  void BoundPiece(const Piece& piece, double knownBound)
  {
    const std::uint32_t s = this->Visit(piece.GetMiddle());
    const double bound = std::min(knownBound, this->GetBound(piece, s));
    if (this->Accept(bound))
    {
      return;
    }
    Piece rest = piece;
    bool cut = false;
    const Vector& normal = this->To.GetNormal(s);
    for (int e = 0; e < 3 && Dot(normal, normal) > 0.0; ++e)
    {
      const Vector& a = this->To.GetCorner(s, e);
      const Vector inward = Cross(normal, Subtract(this->To.GetCorner(s, (e + 1) % 3), a));
      Piece inside;
      Piece outside;
      if (Split(rest, a, inward, inside, outside))
      {
        cut = true;
        this->Push(outside, bound);
        rest = inside;
      }
    }
    if (cut)
    {
      this->Push(rest, bound);
      return;
    }
    this->PushHalves(piece, bound);
  }

  void PushHalves(const Piece& piece, double bound)
  {
    for (int i = 0; i < piece.Count; ++i)
    {
      this->Visit(piece.Corners[i]);
    }
    Piece one;
    Piece other;
    if (this->Accept(bound))
    {
      return;
    }
    if (Halve(piece, one, other))
    {
      this->Push(one, bound);
      this->Push(other, bound);
      return;
    }
    this->Result.UpperBound = std::max(this->Result.UpperBound, bound); // too small to be cut
  }

  // A part is within its whole's bound.
  void Push(const Piece& part, double bound) { this->Stack.push_back({ part, bound }); }

  struct Entry
  {
    Piece Shape;
    double Bound;
  };

  const vtkMTTriangleTree& From;
  const vtkMTTriangleTree& To;
  vtkMTDeviation& Result;
  const double Slack;
  std::vector<std::uint32_t> NearestToPoint;
  std::vector<Entry> Stack;
};

double GetExtent(const vtkMTPatch& mesh, const vtkMTPoint& origin)
{
  const vtkMTBox box = mesh.GetBox();
  double extent = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    extent = std::max({ extent, std::abs(static_cast<double>(box[2 * i]) - static_cast<double>(origin[i])),
      std::abs(static_cast<double>(box[2 * i + 1]) - static_cast<double>(origin[i])) });
  }
  return extent;
}
}

vtkMTDeviation vtkMTDeviation::Between(const vtkMTPatch& a, const vtkMTTriangleTree& treeOfA, const vtkMTPatch& b,
  const vtkMTTriangleTree& treeOfB, const vtkMTPoint& origin)
{
  vtkMTDeviation result;
  const double slack = std::ldexp(std::max(GetExtent(a, origin), GetExtent(b, origin)), -40);
  OneSided forward(treeOfA, treeOfB, result, slack);
  OneSided backward(treeOfB, treeOfA, result, slack);
  forward.VisitPoints(a, origin);
  backward.VisitPoints(b, origin);
  std::size_t budget = PiecesPerTriangle * (a.Triangles.size() + b.Triangles.size());
  forward.BoundTriangles(a, budget);
  backward.BoundTriangles(b, budget);
  return result;
}
