// SPDX-License-Identifier: BSD-3-Clause
#include "SimplificationTesting.h"

#include "vtkGenericCell.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <set>

namespace SimplificationTesting
{
//------------------------------------------------------------------------------
vtkMTPatch MakeFloor(const std::vector<Place>& places, const std::vector<Corners>& triangles, double steps)
{
  vtkMTPatch floor;
  for (const Place& p : places)
  {
    floor.Points.push_back({ static_cast<std::int32_t>(std::lround(p[0] * steps)),
      static_cast<std::int32_t>(std::lround(p[1] * steps)), static_cast<std::int32_t>(std::lround(p[2] * steps)) });
  }
  for (const Corners& t : triangles)
  {
    floor.Triangles.push_back({ static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
      static_cast<std::uint32_t>(t[2]) });
  }
  return floor;
}

//------------------------------------------------------------------------------
vtkMTPatch MakeFloor(vtkPolyData* mesh, double steps)
{
  std::vector<Place> places(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  std::vector<Corners> triangles;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, size, ids);
    triangles.push_back({ ids[0], ids[1], ids[2] });
  }
  return MakeFloor(places, triangles, steps);
}

//------------------------------------------------------------------------------
vtkMTPatch MakeGrid(int columns, int rows, double amplitude, double steps)
{
  std::vector<Place> places;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double x = static_cast<double>(i) / (columns - 1);
      const double y = static_cast<double>(j) / (rows - 1);
      places.push_back({ x, y, amplitude * std::sin(7.0 * x) * std::cos(5.0 * y) });
    }
  }
  return MakeFloor(places, MTTestMeshes::GridTriangles(columns, rows), steps);
}

//------------------------------------------------------------------------------
double Noise(double x, double y, double z)
{
  static const std::vector<int> permutation = [] {
    std::vector<int> p(256);
    std::iota(p.begin(), p.end(), 0);
    MTTestMeshes::Random random(7);
    for (std::size_t i = 255; i > 0; --i)
    {
      std::swap(p[i], p[random.Below(i + 1)]);
    }
    p.insert(p.end(), p.begin(), p.end());
    return p;
  }();
  const auto hash = [&](int i, int j, int k)
  { return permutation[permutation[permutation[i & 255] + (j & 255)] + (k & 255)]; };
  const auto gradient = [](int h, double a, double b, double c)
  {
    h &= 15;
    const double u = h < 8 ? a : b;
    const double v = h < 4 ? b : (h == 12 || h == 14 ? a : c);
    return ((h & 1) ? -u : u) + ((h & 2) ? -v : v);
  };
  const auto fade = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const int k = static_cast<int>(std::floor(z));
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int a = corner & 1;
    const int b = (corner >> 1) & 1;
    const int c = corner >> 2;
    const double u = x - i - a;
    const double v = y - j - b;
    const double w = z - k - c;
    sum += fade(1.0 - std::abs(u)) * fade(1.0 - std::abs(v)) * fade(1.0 - std::abs(w)) *
      gradient(hash(i + a, j + b, k + c), u, v, w);
  }
  return sum;
}

//------------------------------------------------------------------------------
vtkMTPatch MakeFractalCap(int subdivisions, std::size_t triangles, int direction)
{
  static std::map<int, std::pair<std::vector<Place>, std::vector<Corners>>> spheres;
  auto& sphere = spheres[subdivisions];
  const std::vector<Place>& places = sphere.first;
  const std::vector<Corners>& all = sphere.second;
  if (all.empty())
  {
    MTTestMeshes::MakeIcosphere(subdivisions, sphere.first, sphere.second);
  }
  const Place axis = { std::cos(1.7 * direction), std::sin(1.7 * direction) * 0.8, std::sin(2.3 * direction) };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    double dot = 0.0;
    for (const vtkIdType p : all[t])
    {
      dot += places[p][0] * axis[0] + places[p][1] * axis[1] + places[p][2] * axis[2];
    }
    order.push_back({ -dot, t });
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(triangles, order.size()));
  std::vector<vtkIdType> map(places.size(), -1);
  std::vector<Place> used;
  std::vector<Corners> kept;
  for (const auto& entry : order)
  {
    Corners t = all[entry.second];
    for (vtkIdType& p : t)
    {
      if (map[p] < 0)
      {
        double radius = 1.0;
        for (int o = 0; o < 8; ++o)
        {
          const double f = 1.7 * std::pow(2.03, o);
          radius += 0.25 * std::pow(0.47, o) * Noise(places[p][0] * f, places[p][1] * f, places[p][2] * f);
        }
        map[p] = static_cast<vtkIdType>(used.size());
        used.push_back({ places[p][0] * radius, places[p][1] * radius, places[p][2] * radius });
      }
      p = map[p];
    }
    kept.push_back(t);
  }
  return MakeFloor(used, kept, 1 << 22);
}

//------------------------------------------------------------------------------
std::map<Edge, int> CountEdges(const vtkMTPatch& mesh)
{
  std::map<Edge, int> edges;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0])
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      ++edges[{ p[i], p[(i + 1) % 3] }];
    }
  }
  return edges;
}

//------------------------------------------------------------------------------
std::vector<Edge> FindBorder(const vtkMTPatch& mesh)
{
  const std::map<Edge, int> edges = CountEdges(mesh);
  std::vector<Edge> border;
  for (const auto& e : edges)
  {
    if (e.second == 1 && edges.count({ e.first.second, e.first.first }) == 0)
    {
      border.push_back(e.first);
    }
  }
  return border;
}

//------------------------------------------------------------------------------
Locks LockBorder(const vtkMTPatch& floor)
{
  Locks locked(floor.Points.size(), 0);
  for (const Edge& e : FindBorder(floor))
  {
    locked[e.first] = locked[e.second] = 1;
  }
  return locked;
}

//------------------------------------------------------------------------------
Locks LockNothing(const vtkMTPatch& floor)
{
  return Locks(floor.Points.size(), 0);
}

//------------------------------------------------------------------------------
vtkMTPatch ToPatch(const vtkMTSimplification& result)
{
  vtkMTPatch mesh;
  mesh.Points = result.Points;
  mesh.WedgePoints = result.WedgePoints;
  mesh.Triangles = result.Triangles;
  return mesh;
}

//------------------------------------------------------------------------------
bool IsClosedManifold(const vtkMTPatch& mesh)
{
  const std::map<Edge, int> edges = CountEdges(mesh);
  for (const auto& e : edges)
  {
    const auto back = edges.find({ e.first.second, e.first.first });
    if (e.second != 1 || back == edges.end() || back->second != 1)
    {
      return false;
    }
  }
  return !edges.empty();
}

//------------------------------------------------------------------------------
std::size_t CountComponents(const vtkMTPatch& mesh)
{
  std::vector<std::uint32_t> parents(mesh.Points.size());
  std::iota(parents.begin(), parents.end(), 0u);
  const auto root = [&](std::uint32_t i)
  {
    while (parents[i] != i)
    {
      i = parents[i] = parents[parents[i]];
    }
    return i;
  };
  std::set<std::uint32_t> roots;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    parents[root(p[1])] = root(p[0]);
    parents[root(p[2])] = root(p[0]);
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    roots.insert(root(mesh.GetPointsOfTriangle(t)[0]));
  }
  return roots.size();
}

//------------------------------------------------------------------------------
std::size_t CountFlatTriangles(const vtkMTPatch& mesh)
{
  std::size_t flat = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    double d[2][3];
    for (int e = 0; e < 2; ++e)
    {
      for (int i = 0; i < 3; ++i)
      {
        d[e][i] = static_cast<double>(mesh.Points[p[e + 1]][i]) - static_cast<double>(mesh.Points[p[0]][i]);
      }
    }
    double n[3];
    vtkMath::Cross(d[0], d[1], n);
    flat += n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0 ? 1 : 0;
  }
  return flat;
}

//------------------------------------------------------------------------------
Outcome Simplify(const vtkMTPatch& floor, const Locks& locked, std::size_t target, int mode)
{
  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetMode(mode);
  Outcome run;
  run.Ok = simplifier->Simplify(floor, locked, target, run.Result, run.Error);
  return run;
}

namespace
{
//------------------------------------------------------------------------------
std::string FindBadIndex(const vtkMTPatch& floor, const vtkMTSimplification& r)
{
  const std::size_t n = r.Points.size();
  if (r.PointOrigin.size() != n || r.Moved.size() != n || r.WedgeOrigin.size() != r.WedgePoints.size())
  {
    return "arrays of different lengths";
  }
  std::set<std::uint32_t> origins;
  for (std::size_t p = 0; p < n; ++p)
  {
    if (r.PointOrigin[p] >= floor.Points.size() || !origins.insert(r.PointOrigin[p]).second)
    {
      return "origin of point " + std::to_string(p) + " out of range or used twice";
    }
    if ((r.Moved[p] != 0) != (r.Points[p] != floor.Points[r.PointOrigin[p]]))
    {
      return "Moved of point " + std::to_string(p);
    }
  }
  for (std::size_t w = 0; w < r.WedgePoints.size(); ++w)
  {
    if (r.WedgePoints[w] >= n || r.WedgeOrigin[w] >= floor.GetNumberOfWedges() ||
      floor.GetPointOfWedge(r.WedgeOrigin[w]) != r.PointOrigin[r.WedgePoints[w]])
    {
      return "wedge " + std::to_string(w) + " is not of its point's origin";
    }
  }
  std::vector<bool> usedWedges(r.WedgePoints.size(), false);
  std::vector<bool> usedPoints(n, false);
  for (const vtkMTTriangle& t : r.Triangles)
  {
    for (const std::uint32_t w : t)
    {
      if (w >= r.WedgePoints.size())
      {
        return "triangle with a wedge out of range";
      }
      usedWedges[w] = true;
      usedPoints[r.WedgePoints[w]] = true;
    }
    const std::uint32_t a = r.WedgePoints[t[0]];
    const std::uint32_t b = r.WedgePoints[t[1]];
    const std::uint32_t c = r.WedgePoints[t[2]];
    if (a == b || b == c || c == a)
    {
      return "triangle with a repeated point";
    }
  }
  const bool allUsed = std::all_of(usedWedges.begin(), usedWedges.end(), [](bool b) { return b; }) &&
    std::all_of(usedPoints.begin(), usedPoints.end(), [](bool b) { return b; });
  return allUsed ? "" : "points or wedges that no triangle uses";
}

// Points of the floor at which an edge is not shared by exactly two opposite triangles, or whose triangles are several fans.
std::vector<bool> FindNonManifoldPoints(const vtkMTPatch& floor, const std::map<Edge, int>& edges)
{
  std::vector<bool> bad(floor.Points.size(), false);
  std::map<std::uint32_t, std::vector<Edge>> links; // per point, the opposite edges of its triangles
  for (const auto& e : edges)
  {
    const auto back = edges.find({ e.first.second, e.first.first });
    if (e.second > 1 || (back != edges.end() && back->second > 1))
    {
      bad[e.first.first] = bad[e.first.second] = true;
    }
  }
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = floor.GetPointsOfTriangle(t);
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0])
    {
      for (int i = 0; i < 3; ++i)
      {
        links[p[i]].push_back({ p[(i + 1) % 3], p[(i + 2) % 3] });
      }
    }
  }
  for (const auto& link : links)
  {
    // One path or one circle: every point starts at most one edge and all edges hang together.
    std::map<std::uint32_t, std::uint32_t> next(link.second.begin(), link.second.end());
    std::set<std::uint32_t> ends;
    for (const auto& e : next)
    {
      ends.insert(e.second);
    }
    std::uint32_t start = next.begin()->first;
    for (const auto& e : next)
    {
      start = ends.count(e.first) ? start : e.first;
    }
    std::size_t walked = 0;
    for (std::uint32_t p = start; next.count(p) && walked <= next.size(); ++walked)
    {
      p = next[p];
      if (p == start)
      {
        ++walked;
        break;
      }
    }
    if (next.size() != link.second.size() || walked != next.size())
    {
      bad[link.first] = true;
    }
  }
  return bad;
}
}

//------------------------------------------------------------------------------
std::string FindFault(const vtkMTPatch& floor, const Locks& locked, const vtkMTSimplification& result)
{
  const std::string bad = FindBadIndex(floor, result);
  if (!bad.empty())
  {
    return bad;
  }
  const std::map<Edge, int> before = CountEdges(floor);
  const std::vector<bool> nonManifold = FindNonManifoldPoints(floor, before);
  std::map<std::uint32_t, bool> present; // floor's points in the fragment
  for (std::size_t p = 0; p < result.Points.size(); ++p)
  {
    const std::uint32_t origin = result.PointOrigin[p];
    present[origin] = true;
    if ((locked[origin] || nonManifold[origin]) && result.Moved[p])
    {
      return "fixed point " + std::to_string(origin) + " has moved";
    }
  }
  const bool removal = result.RemovedComponents > 0;
  std::map<Edge, int> after;
  for (const auto& e : CountEdges(ToPatch(result)))
  {
    after[{ result.PointOrigin[e.first.first], result.PointOrigin[e.first.second] }] = e.second;
  }
  const auto count = [](const std::map<Edge, int>& edges, const Edge& e)
  {
    const auto found = edges.find(e);
    return found == edges.end() ? 0 : found->second;
  };
  const auto fixed = [&](std::uint32_t p) { return locked[p] || nonManifold[p]; };
  for (const auto& e : before)
  {
    const Edge edge = e.first;
    const bool outside = locked[edge.first] && locked[edge.second];
    if (locked[edge.first] && !present[edge.first])
    {
      return "locked point " + std::to_string(edge.first) + " is gone";
    }
    if (fixed(edge.first) && fixed(edge.second) && (outside || !removal) && count(after, edge) != e.second)
    {
      return "edge " + std::to_string(edge.first) + " -> " + std::to_string(edge.second) + " between fixed points had " +
        std::to_string(e.second) + " triangles and has " + std::to_string(count(after, edge));
    }
  }
  for (const auto& e : after)
  {
    const Edge edge = e.first;
    const int back = count(after, { edge.second, edge.first });
    if (fixed(edge.first) && fixed(edge.second))
    {
      if (count(before, edge) != e.second)
      {
        return "new edge between fixed points " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
      }
      continue;
    }
    if (e.second != 1 || back > 1)
    {
      return "edge " + std::to_string(edge.first) + " -> " + std::to_string(edge.second) + " has " +
        std::to_string(e.second) + " triangles, and " + std::to_string(back) + " the other way; in the floor " +
        std::to_string(count(before, edge)) + " and " + std::to_string(count(before, { edge.second, edge.first }));
    }
  }
  return "";
}

//------------------------------------------------------------------------------
Distance Measure(const vtkMTPatch& a, const vtkMTPatch& b, std::size_t samples)
{
  Distance result;
  double sum = 0.0;
  double weight = 0.0;
  const auto toMesh = [](const vtkMTPatch& patch)
  {
    std::vector<Place> places;
    for (const vtkMTPoint& k : patch.Points)
    {
      places.push_back({ static_cast<double>(k[0]), static_cast<double>(k[1]), static_cast<double>(k[2]) });
    }
    std::vector<Corners> triangles;
    for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
    {
      const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
      triangles.push_back({ p[0], p[1], p[2] });
    }
    return MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
  };
  const auto oneWay = [&](vtkPolyData* from, vtkPolyData* to)
  {
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(to);
    locator->BuildLocator();
    vtkNew<vtkGenericCell> cell;
    std::vector<double> areas(1, 0.0);
    for (vtkIdType t = 0; t < from->GetNumberOfCells(); ++t)
    {
      double p[3][3];
      from->GetCell(t, cell);
      for (int i = 0; i < 3; ++i)
      {
        cell->GetPoints()->GetPoint(i, p[i]);
      }
      double u[3];
      double v[3];
      double n[3];
      vtkMath::Subtract(p[1], p[0], u);
      vtkMath::Subtract(p[2], p[0], v);
      vtkMath::Cross(u, v, n);
      areas.push_back(areas.back() + vtkMath::Norm(n));
    }
    const auto distance = [&](double x[3])
    {
      double closest[3];
      vtkIdType id = -1;
      int sub = 0;
      double d2 = 0.0;
      locator->FindClosestPoint(x, closest, cell, id, sub, d2);
      return d2;
    };
    MTTestMeshes::Random random(11);
    for (std::size_t i = 0; i < samples; ++i)
    {
      const double where = random.Uniform() * areas.back();
      const auto t = std::upper_bound(areas.begin(), areas.end() - 1, where) - areas.begin() - 1;
      double r = std::sqrt(random.Uniform());
      const double s = random.Uniform();
      from->GetCell(t, cell);
      double x[3] = { 0.0, 0.0, 0.0 };
      const double w[3] = { 1.0 - r, r * (1.0 - s), r * s };
      for (int c = 0; c < 3; ++c)
      {
        double p[3];
        cell->GetPoints()->GetPoint(c, p);
        for (int k = 0; k < 3; ++k)
        {
          x[k] += w[c] * p[k];
        }
      }
      const double d2 = distance(x);
      sum += d2;
      weight += 1.0;
      result.Max = std::max(result.Max, std::sqrt(d2));
    }
    for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
    {
      double x[3];
      from->GetPoint(i, x);
      result.Max = std::max(result.Max, std::sqrt(distance(x)));
    }
  };
  const auto meshA = toMesh(a);
  const auto meshB = toMesh(b);
  oneWay(meshA, meshB);
  oneWay(meshB, meshA);
  result.Rms = std::sqrt(sum / weight);
  return result;
}

//------------------------------------------------------------------------------
double GetThreadSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
}
