// SPDX-License-Identifier: BSD-3-Clause
// Topology and content.
#include "MTStiffMeshes.h"

namespace MTStiffMeshes
{
namespace
{
const double Pi = vtkMath::Pi();

std::vector<vtkIdType> AddRing(Parts& parts, int n, double z, double wobble)
{
  std::vector<vtkIdType> ring;
  for (int i = 0; i < n; ++i)
  {
    const double a = 2.0 * Pi * i / n;
    const double r = 1.0 + wobble * std::sin(7.0 * a);
    ring.push_back(parts.Add(r * std::cos(a), r * std::sin(a), z + 0.02 * std::sin(9.0 * a)));
  }
  return ring;
}

void AddFan(Parts& parts, vtkIdType apex, const std::vector<vtkIdType>& ring)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    parts.AddTriangle(apex, ring[i], ring[(i + 1) % ring.size()]);
  }
}

// A grid whose columns, or rows, close up: (columns, j) is (0, j) or, mirrored, (0, rows - 1 - j).
Mesh CloseGrid(Parts& parts, int columns, int rows, bool mirrored, bool closeRows)
{
  for (Corners& corners : parts.Triangles)
  {
    for (vtkIdType& p : corners)
    {
      vtkIdType i = p % (columns + 1);
      vtkIdType j = p / (columns + 1);
      j = closeRows && j == rows ? 0 : j;
      if (i == columns)
      {
        i = 0;
        j = !mirrored ? j : closeRows ? (rows - j) % rows : rows - j;
      }
      p = j * (columns + 1) + i;
    }
  }
  return parts.Make();
}
}

//------------------------------------------------------------------------------
Mesh Components(int triangles)
{
  const int side = static_cast<int>(std::ceil(std::cbrt(triangles)));
  Parts parts;
  for (int k = 0; k < triangles; ++k)
  {
    const int row = k / side % side;
    const int layer = k / side / side;
    const double x = k % side, y = row, z = layer;
    const vtkIdType first = parts.Add(x, y, z);
    parts.AddTriangle(first, parts.Add(x + 0.5, y, z), parts.Add(x, y + 0.5, z + 0.1));
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Tetrahedra(int triangles)
{
  return MTTestMeshes::ManyComponents(std::max(1, triangles / 20), 0, 14);
}

//------------------------------------------------------------------------------
Mesh Fan(int triangles)
{
  Parts parts;
  AddFan(parts, parts.Add(0.0, 0.0, 0.5), AddRing(parts, triangles, 0.0, 0.1));
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh TwoFans(int triangles)
{
  Parts parts;
  const vtkIdType apex = parts.Add(0.0, 0.0, 0.0);
  for (const double z : { -0.5, 0.5 })
  {
    std::vector<vtkIdType> ring = AddRing(parts, triangles / 2, z, 0.1);
    if (z > 0.0)
    {
      std::reverse(ring.begin(), ring.end());
    }
    AddFan(parts, apex, ring);
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Spindle(int triangles)
{
  Parts parts;
  std::vector<vtkIdType> ring = AddRing(parts, triangles / 2, 0.0, 0.1);
  AddFan(parts, parts.Add(0.0, 0.0, 0.5), ring);
  std::reverse(ring.begin(), ring.end());
  AddFan(parts, parts.Add(0.0, 0.0, -0.5), ring);
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Checkerboard(int triangles)
{
  const int side = GetSide(2 * triangles);
  Parts parts;
  parts.AddGrid(side, side,
    [](int i, int j) {
      return Place{ 1.0 * i, 1.0 * j, std::sin(0.3 * i) * std::cos(0.2 * j) };
    });
  std::vector<Corners> kept;
  for (std::size_t t = 0; t < parts.Triangles.size(); ++t)
  {
    const int cell = static_cast<int>(t / 2);
    if ((cell % (side - 1) + cell / (side - 1)) % 2 == 0)
    {
      kept.push_back(parts.Triangles[t]);
    }
  }
  parts.Triangles.swap(kept);
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Moebius(int triangles)
{
  const int rows = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 20.0))));
  const int columns = triangles / (2 * rows);
  Parts parts;
  parts.AddGrid(columns + 1, rows + 1,
    [&](int i, int j)
    {
      const double a = 2.0 * Pi * i / columns;
      const double w = 0.6 * (static_cast<double>(j) / rows - 0.5);
      const double r = 1.0 + w * std::cos(0.5 * a);
      return Place{ r * std::cos(a), r * std::sin(a), w * std::sin(0.5 * a) };
    });
  return CloseGrid(parts, columns, rows, true, false);
}

//------------------------------------------------------------------------------
Mesh Klein(int triangles)
{
  const int rows = 2 * std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 16.0))));
  const int columns = triangles / (2 * rows);
  Parts parts;
  // The figure of eight, turned half about on its way around: closed, it crosses itself along a circle.
  parts.AddGrid(columns + 1, rows + 1,
    [&](int i, int j)
    {
      const double a = 2.0 * Pi * i / columns;
      const double b = 2.0 * Pi * j / rows;
      const double r = 2.0 + std::cos(0.5 * a) * std::sin(b) - std::sin(0.5 * a) * std::sin(2.0 * b);
      return Place{ r * std::cos(a), r * std::sin(a),
        std::sin(0.5 * a) * std::sin(b) + std::cos(0.5 * a) * std::sin(2.0 * b) };
    });
  return CloseGrid(parts, columns, rows, true, true);
}

//------------------------------------------------------------------------------
Mesh Barycentres(int triangles)
{
  Parts parts;
  for (int i = 1; i <= triangles; ++i)
  {
    const double u = i;
    const double v = static_cast<double>(std::int64_t(i) * 7919 % (triangles + 1));
    const vtkIdType first = parts.Add(u, v, 0.0);
    parts.Add(-v, u - v, 1.0);
    parts.Add(v - u, -u, -1.0);
    parts.AddTriangle(first, first + 1, first + 2);
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Pages(int triangles)
{
  Parts parts;
  const vtkIdType a = parts.Add(0.0, 0.0, 0.0);
  const vtkIdType b = parts.Add(0.0, 0.0, 1.0);
  for (int i = 0; i < triangles; ++i)
  {
    const double t = 2.0 * Pi * i / triangles;
    parts.AddTriangle(a, b, parts.Add(std::cos(t), std::sin(t), 0.5));
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh TJunctions(int triangles)
{
  // Blocks of four cells and of sixteen take turns; each has points of its own.
  const int blocks = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 20.0))));
  Parts parts;
  for (int block = 0; block < blocks * blocks; ++block)
  {
    const int x = block % blocks;
    const int y = block / blocks;
    const int cells = (x + y) % 2 == 0 ? 2 : 4;
    parts.AddGrid(cells + 1, cells + 1,
      [&](int i, int j)
      {
        const double u = x + static_cast<double>(i) / cells;
        const double v = y + static_cast<double>(j) / cells;
        return Place{ u, v, 0.3 * std::sin(0.5 * u) * std::cos(0.4 * v) };
      });
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh FewTriangles(int triangles)
{
  Parts parts;
  for (const Place& p :
    { Place{ 0.0, 0.0, 0.0 }, Place{ 1.0, 0.0, 0.1 }, Place{ 0.3, 1.0, 0.2 }, Place{ 1.2, 0.9, 0.0 } })
  {
    parts.Places.push_back(p);
  }
  parts.Triangles = { { 0, 1, 2 }, { 1, 3, 2 } };
  parts.Triangles.resize(static_cast<std::size_t>(std::max(0, std::min(2, triangles))));
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh SignedZeros(int triangles)
{
  const int side = GetSide(triangles) | 1;
  MTTestMeshes::Random random(15);
  Parts parts;
  const int middle = side / 2;
  parts.AddGrid(side, side,
    [&](int i, int j)
    {
      const double z = 0.25 * std::max(0, i - middle - 2);
      return Place{ i == middle ? -0.0 : i - middle, j == middle ? -0.0 : j - middle,
        z == 0.0 && random.Below(2) == 0 ? -0.0 : z };
    });
  return MTTestMeshes::Soup(parts.Make());
}

//------------------------------------------------------------------------------
Mesh NotFinite(int triangles)
{
  Mesh mesh = Relief(triangles, 0.1);
  MTTestMeshes::Random random(16);
  const double bad[3] = { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (random.Below(100) == 0)
    {
      Place p;
      mesh->GetPoint(i, p.data());
      p[random.Below(3)] = bad[random.Below(3)];
      mesh->GetPoints()->SetPoint(i, p.data());
    }
  }
  return mesh;
}
}
