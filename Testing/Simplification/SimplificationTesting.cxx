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
    floor.Triangles.push_back(
      { static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]) });
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
  static const std::vector<int> permutation = []
  {
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
