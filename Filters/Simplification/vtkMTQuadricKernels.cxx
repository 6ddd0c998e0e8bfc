// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadricKernels.h"

#include "vtkMTWide.h"

#include <cmath>

using namespace vtkMTWide;

namespace
{
using Rule = vtkMTCollapseRegion::Rule;
using Request = vtkMTQuadrics::Request;
using Four = vtkMTQuadrics::Four;
using Quadric = vtkMTQuadrics::Quadric;
using OfVertex = vtkMTQuadrics::OfVertex;

constexpr double Regularisation = 1e-4; // of the trace, towards the midpoint
constexpr double LengthTerm = 1e-6;     // of the trace times the squared length of the edge

// Four quadrics, lane by lane.
struct Quadrics
{
  Wide XX, XY, XZ, YY, YZ, ZZ, X, Y, Z, C;
};

// 1 / sqrt(2 length), 0 where there is no length: the factor that makes a normal's square the triangle's area.
[[gnu::always_inline]] inline void GetFactors(const Wide& squaredLengths, Wide& factors)
{
  for (int lane = 0; lane < 4; ++lane)
  {
    const double length = std::sqrt(squaredLengths[lane]);
    factors[lane] = length > 0.0 ? 1.0 / std::sqrt(2.0 * length) : 0.0;
  }
}

[[gnu::always_inline]] inline void SumOfEnds(const OfVertex* const (&ends)[2][4], Quadrics& q)
{
  Wide parts[4][3];
  for (int lane = 0; lane < 4; ++lane)
  {
    const double* const a = ends[0][lane]->Sum.V;
    const double* const b = ends[1][lane]->Sum.V;
    parts[lane][0] = Load(a) + Load(b);
    parts[lane][1] = Load(a + 4) + Load(b + 4);
    parts[lane][2] = Load(a + 8) + Load(b + 8);
  }
  q.XX = parts[0][0];
  q.XY = parts[1][0];
  q.XZ = parts[2][0];
  q.YY = parts[3][0];
  Transpose(q.XX, q.XY, q.XZ, q.YY);
  q.YZ = parts[0][1];
  q.ZZ = parts[1][1];
  q.X = parts[2][1];
  q.Y = parts[3][1];
  Transpose(q.YZ, q.ZZ, q.X, q.Y);
  q.Z = parts[0][2];
  q.C = parts[1][2];
  Wide unused[2] = { parts[2][2], parts[3][2] };
  Transpose(q.Z, q.C, unused[0], unused[1]);
}

// Solves (A + r I) y = -(A m + b) by cofactors, then refines once against A itself, which squares what r takes away
// from directions that A determines (corners stay corners to the last digit) and leaves the others at the midpoint m.
[[gnu::always_inline]] inline void Minimize(const Quadrics& q, const Wide& trace, const Wide3& m, Wide3& place)
{
  const Wide r = Regularisation * trace;
  const Wide a = q.XX + r;
  const Wide& b = q.XY;
  const Wide& c = q.XZ;
  const Wide d = q.YY + r;
  const Wide& e = q.YZ;
  const Wide f = q.ZZ + r;
  const Wide c00 = d * f - e * e;
  const Wide c01 = c * e - b * f;
  const Wide c02 = b * e - c * d;
  const Wide determinant = a * c00 + b * c01 + c * c02;
  const Wide s = -(1.0 / determinant);
  const Wide c11 = a * f - c * c;
  const Wide c12 = b * c - a * e;
  const Wide c22 = a * d - b * b;
  Wide3 p = m;
  for (int i = 0; i < 2; ++i)
  {
    const Wide x = s * (q.XX * p.X + b * p.Y + c * p.Z + q.X);
    const Wide y = s * (b * p.X + q.YY * p.Y + e * p.Z + q.Y);
    const Wide z = s * (c * p.X + e * p.Y + q.ZZ * p.Z + q.Z);
    p.X += c00 * x + c01 * y + c02 * z;
    p.Y += c01 * x + c11 * y + c12 * z;
    p.Z += c02 * x + c12 * y + c22 * z;
  }
  const Wide sum = p.X + p.Y + p.Z;
  const Mask isGood = (determinant > 0.0) & (sum - sum == 0.0); // which no other number is than a finite one
  place.X = isGood ? p.X : m.X;
  place.Y = isGood ? p.Y : m.Y;
  place.Z = isGood ? p.Z : m.Z;
}

[[gnu::always_inline]] inline void Evaluate(const Quadrics& q, const Wide3& p, Wide& value)
{
  value = p.X * (q.XX * p.X + 2.0 * (q.XY * p.Y + q.XZ * p.Z + q.X)) + p.Y * (q.YY * p.Y + 2.0 * (q.YZ * p.Z + q.Y)) +
    p.Z * (q.ZZ * p.Z + 2.0 * q.Z) + q.C;
}

// Places one of the ends where the rule says so.
[[gnu::always_inline]] inline void TakeEnds(
  const Request* four, const Quadrics& q, const Wide3& first, const Wide3& second, Wide3& place)
{
  Wide costs[2];
  Evaluate(q, first, costs[0]);
  Evaluate(q, second, costs[1]);
  Mask isFirst = costs[0] <= costs[1];
  Mask isEnd{};
  for (int lane = 0; lane < 4; ++lane)
  {
    const Rule rule = four[lane].ByRule;
    isEnd[lane] = rule == Rule::Free ? 0 : -1;
    isFirst[lane] = rule == Rule::Ends ? isFirst[lane] : rule == Rule::First ? -1 : 0;
  }
  place.X = isEnd ? (isFirst ? first.X : second.X) : place.X;
  place.Y = isEnd ? (isFirst ? first.Y : second.Y) : place.Y;
  place.Z = isEnd ? (isFirst ? first.Z : second.Z) : place.Z;
}
}

namespace vtkMTQuadricKernels
{
MT_FOR_WIDE_PROCESSORS
void MakeFaceQuadrics(
  const vtkMTCollapseRegion& region, const std::uint32_t* halfedges, std::size_t count, Quadric* ofFaces)
{
  const vtkMTCollapseMesh& mesh = region.Mesh;
  for (const std::uint32_t* four = halfedges; four < halfedges + count; four += 4)
  {
    const double* normals[4];
    const double* places[4];
    double* results[4];
    for (int lane = 0; lane < 4; ++lane)
    {
      const vtkMTCollapseMesh::Halfedge& h = mesh.Halfedges[four[lane]];
      normals[lane] = region.GetNormal(h.Face).data();
      places[lane] = mesh.GetPlace(h.Target).data();
      results[lane] = ofFaces[h.Face].V;
    }
    Wide3 n, p;
    Gather(normals[0], normals[1], normals[2], normals[3], n);
    Gather(places[0], places[1], places[2], places[3], p);
    Wide squared;
    Wide factor{};
    Dot(n, n, squared);
    GetFactors(squared, factor);
    n.X *= factor;
    n.Y *= factor;
    n.Z *= factor;
    Wide d;
    Dot(n, p, d);
    d = -d;
    Wide rows[3][4] = { { n.X * n.X, n.X * n.Y, n.X * n.Z, n.Y * n.Y }, { n.Y * n.Z, n.Z * n.Z, n.X * d, n.Y * d },
      { n.Z * d, d * d, Wide{}, Wide{} } };
    for (int row = 0; row < 3; ++row)
    {
      Transpose(rows[row][0], rows[row][1], rows[row][2], rows[row][3]);
      for (int lane = 0; lane < 4; ++lane)
      {
        Store(results[lane] + 4 * row, rows[row][lane]);
      }
    }
  }
}

MT_FOR_WIDE_PROCESSORS
void SumAroundVertices(const vtkMTCollapseMesh& mesh, const std::uint32_t* vertices, std::size_t count,
  const Quadric* ofFaces, OfVertex* ofVertices)
{
  const vtkMTCollapseMesh::Halfedge* const halfedges = mesh.Halfedges.data();
  for (const std::uint32_t* vertex = vertices; vertex < vertices + count; ++vertex)
  {
    Wide sums[3] = {};
    const std::uint32_t begin = mesh.Outs[*vertex];
    std::uint32_t h = begin;
    do
    {
      const std::uint32_t face = halfedges[h].Face;
      if (face != vtkMTCollapseMesh::None)
      {
        const double* const q = ofFaces[face].V;
        sums[0] += Load(q);
        sums[1] += Load(q + 4);
        sums[2] += Load(q + 8);
      }
      h = halfedges[h].Previous ^ 1;
    } while (h != begin);
    double* const result = ofVertices[*vertex].Sum.V;
    Store(result, sums[0]);
    Store(result + 4, sums[1]);
    Store(result + 8, sums[2]);
    Store(ofVertices[*vertex].Place, Load(mesh.GetPlace(*vertex).data()));
  }
}

MT_FOR_WIDE_PROCESSORS
void Propose(const vtkMTCollapseRegion& region, const Request* requests, std::size_t count, const OfVertex* ofVertices,
  Four* proposals)
{
  const vtkMTCollapseMesh::Halfedge* const halfedges = region.Mesh.Halfedges.data();
  const double magic = region.GetMagic();
  for (const Request* four = requests; four < requests + count; four += 4, ++proposals)
  {
    const OfVertex* ends[2][4];
    bool isFree = true;
    for (int lane = 0; lane < 4; ++lane)
    {
      ends[0][lane] = ofVertices + halfedges[four[lane].Halfedge ^ 1].Target;
      ends[1][lane] = ofVertices + halfedges[four[lane].Halfedge].Target;
      isFree = isFree && four[lane].ByRule == Rule::Free;
    }
    Quadrics q;
    SumOfEnds(ends, q);
    Wide3 first, second;
    Gather(ends[0][0]->Place, ends[0][1]->Place, ends[0][2]->Place, ends[0][3]->Place, first);
    Gather(ends[1][0]->Place, ends[1][1]->Place, ends[1][2]->Place, ends[1][3]->Place, second);
    const Wide3 middle = { (first.X + second.X) * 0.5, (first.Y + second.Y) * 0.5, (first.Z + second.Z) * 0.5 };
    const Wide trace = q.XX + q.YY + q.ZZ;
    Wide3 place;
    Minimize(q, trace, middle, place);
    place.X = (place.X + magic) - magic;
    place.Y = (place.Y + magic) - magic;
    place.Z = (place.Z + magic) - magic;
    if (!isFree)
    {
      TakeEnds(four, q, first, second, place);
    }
    Wide3 along;
    Subtract(second, first, along);
    Wide squared;
    Dot(along, along, squared);
    Wide cost;
    Evaluate(q, place, cost);
    Store(proposals->Cost, cost + trace * LengthTerm * squared);
    Store(proposals->Place[0], place.X);
    Store(proposals->Place[1], place.Y);
    Store(proposals->Place[2], place.Z);
  }
}
}
