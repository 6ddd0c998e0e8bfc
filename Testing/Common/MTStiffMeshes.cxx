// SPDX-License-Identifier: BSD-3-Clause
// Scales, proportions, and what is flat.
#include "MTStiffMeshes.h"

namespace MTStiffMeshes
{
namespace
{
const double Pi = vtkMath::Pi();

// Every place of a mesh, changed by a function; the type of coordinates stays.
template <class Function>
Mesh Change(const Mesh& mesh, int type, const Function& function)
{
  Mesh changed = Mesh::New();
  changed->DeepCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Place x;
    mesh->GetPoint(i, x.data());
    x = function(x);
    points->SetPoint(i, x.data());
  }
  changed->SetPoints(points);
  return changed;
}
}

//------------------------------------------------------------------------------
vtkIdType Parts::Add(double x, double y, double z)
{
  this->Places.push_back({ x, y, z });
  return static_cast<vtkIdType>(this->Places.size()) - 1;
}

//------------------------------------------------------------------------------
int GetSide(int triangles)
{
  return std::max(2, 1 + static_cast<int>(std::lround(std::sqrt(0.5 * triangles))));
}

//------------------------------------------------------------------------------
Mesh Scale(const Mesh& mesh, double x, double y, double z)
{
  return Change(mesh, mesh->GetPoints()->GetDataType(),
    [&](const Place& p) {
      return Place{ p[0] * x, p[1] * y, p[2] * z };
    });
}

//------------------------------------------------------------------------------
Mesh Move(const Mesh& mesh, double x, double y, double z)
{
  return Change(mesh, mesh->GetPoints()->GetDataType(),
    [&](const Place& p) {
      return Place{ p[0] + x, p[1] + y, p[2] + z };
    });
}

//------------------------------------------------------------------------------
Mesh TurnAndMove(const Mesh& mesh, double angle, const Place& offset)
{
  // Rodrigues' formula about (2, 3, 6) / 7.
  const Place axis{ 2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0 };
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return Change(mesh, VTK_DOUBLE,
    [&](const Place& p)
    {
      const double along = (1.0 - c) * vtkMath::Dot(axis.data(), p.data());
      Place cross;
      vtkMath::Cross(axis.data(), p.data(), cross.data());
      Place turned;
      for (int i = 0; i < 3; ++i)
      {
        turned[i] = c * p[i] + s * cross[i] + along * axis[i] + offset[i];
      }
      return turned;
    });
}

//------------------------------------------------------------------------------
Mesh BumpySphere(int triangles, int type)
{
  const int subdivisions = static_cast<int>(std::lround(std::log2(std::max(20, triangles) / 20.0) / 2.0));
  Parts parts;
  MTTestMeshes::MakeIcosphere(subdivisions, parts.Places, parts.Triangles);
  for (Place& p : parts.Places)
  {
    // 20 bits, so that scaling by a power of two and large offsets change nothing.
    const double radius = 1.0 + 0.1 * MTTestMeshes::Bumps(p, 3);
    p = { std::nearbyint(std::ldexp(p[0] * radius, 19)) * 0x1p-19,
      std::nearbyint(std::ldexp(p[1] * radius, 19)) * 0x1p-19,
      std::nearbyint(std::ldexp(p[2] * radius, 19)) * 0x1p-19 };
  }
  return parts.Make(type);
}

//------------------------------------------------------------------------------
Mesh Relief(int triangles, double height)
{
  const int side = GetSide(triangles);
  Parts parts;
  parts.AddGrid(side, side,
    [&](int i, int j)
    {
      const double x = static_cast<double>(i) / (side - 1);
      const double y = static_cast<double>(j) / (side - 1);
      return Place{ x, y, height * MTTestMeshes::Bumps({ 5.0 * x, 5.0 * y, 0.3 }, 5) };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Graded(int triangles, double smallest)
{
  const int side = GetSide(triangles);
  const double factor = std::pow(smallest, 1.0 / (side - 2));
  const auto getTick = [&](int i) { return i == 0 ? 0.0 : std::pow(factor, side - 1 - i); };
  MTTestMeshes::Random random(4);
  Parts parts;
  parts.AddGrid(side, side,
    [&](int i, int j)
    {
      const double x = getTick(i);
      const double y = getTick(j);
      return Place{ x, y, 0.1 * std::max(x, y) * (std::sin(0.7 * i) * std::cos(0.9 * j) + 0.2 * random.Uniform()) };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh GradedRings(int triangles, double smallest)
{
  // As many rings of as many cells as make the cells about square.
  const int around = std::max(8, static_cast<int>(std::lround(std::sqrt(Pi * triangles / std::log(1.0 / smallest)))));
  const int rings = std::max(4, triangles / (2 * around));
  Parts parts;
  parts.AddGrid(around + 1, rings + 1,
    [&](int i, int j)
    {
      const double angle = 2.0 * Pi * (i % around) / around;
      const double r = std::pow(smallest, 1.0 - static_cast<double>(j) / rings);
      return Place{ r * std::cos(angle), r * std::sin(angle), 0.1 * r * std::sin(3.0 * angle + 0.4 * j) };
    });
  for (Corners& corners : parts.Triangles)
  {
    for (vtkIdType& p : corners)
    {
      p -= p % (around + 1) == around ? around : 0;
    }
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Slivers(int triangles, double aspect)
{
  const int columns = 9;
  const int rows = std::max(3, triangles / (2 * (columns - 1)));
  Parts parts;
  parts.AddGrid(columns, rows,
    [&](int i, int j) {
      return Place{ 0.125 * i, 0.125 * j / aspect, 0.01 * std::sin(2.0 * i) + 10.0 / aspect * std::sin(0.3 * j) };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Needles(int triangles)
{
  const int rows = std::max(2, triangles / 2);
  Parts parts;
  parts.AddGrid(2, rows + 1,
    [&](int i, int j)
    {
      return Place{ 1000.0 * i, 0.1 / rows * j,
        0.01 * (i == 0 ? std::sin(10.0 * j / rows) : std::cos(13.0 * j / rows)) };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh NoisyPlane(int triangles, double noise)
{
  const int side = GetSide(triangles);
  MTTestMeshes::Random random(7);
  Parts parts;
  parts.AddGrid(side, side,
    [&](int i, int j)
    {
      return Place{ static_cast<double>(i) / (side - 1), static_cast<double>(j) / (side - 1),
        random.Uniform(-noise, noise) };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Plane(int triangles)
{
  const int side = GetSide(triangles);
  MTTestMeshes::Random random(8);
  Parts parts;
  parts.AddGrid(side, side,
    [&](int i, int j)
    {
      // Irregular, on a lattice of 2^-12 cells, so that nothing is rounded.
      const double x = std::floor(4096.0 * (i + (i > 0 && i + 1 < side ? random.Uniform(-0.3, 0.3) : 0.0))) / 4096.0;
      const double y = std::floor(4096.0 * (j + (j > 0 && j + 1 < side ? random.Uniform(-0.3, 0.3) : 0.0))) / 4096.0;
      return Place{ x, y, 0.0 };
    });
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh SlopingPlane(int triangles)
{
  const Mesh plane = Plane(triangles);
  return Change(plane, VTK_DOUBLE,
    [](const Place& p) {
      return Place{ p[0] + 2.0 * p[1], 2.0 * p[0] - p[1], 0.5 * p[0] - 0.25 * p[1] };
    });
}

//------------------------------------------------------------------------------
Mesh Cylinder(int triangles)
{
  const int around = 4 * std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 32.0))));
  const int rows = std::max(2, triangles / (2 * around) + 1);
  Parts parts;
  parts.AddGrid(around + 1, rows,
    [&](int i, int j)
    {
      const double angle = 2.0 * Pi * (i % around) / around;
      return Place{ std::cos(angle), std::sin(angle), 4.0 * j / (rows - 1) };
    });
  // The last column is the first one.
  for (Corners& corners : parts.Triangles)
  {
    for (vtkIdType& p : corners)
    {
      p -= p % (around + 1) == around ? around : 0;
    }
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Cone(int triangles)
{
  return Change(Cylinder(triangles), VTK_DOUBLE,
    [](const Place& p)
    {
      const double r = 1.0 - 0.2499 * p[2];
      return Place{ r * p[0], r * p[1], p[2] };
    });
}

//------------------------------------------------------------------------------
Mesh Rings(int triangles)
{
  return Change(Cylinder(triangles), VTK_DOUBLE,
    [](const Place& p)
    {
      const double r = 0.25 + p[2];
      return Place{ r * p[0], r * p[1], 0.0 };
    });
}

//------------------------------------------------------------------------------
Mesh Terraces(int triangles)
{
  const int side = GetSide(triangles);
  Parts parts;
  parts.AddGrid(side, side,
    [](int i, int j)
    {
      const int step = i / 4 + j / 4;
      return Place{ 1.0 * i, 1.0 * j, 1.0 * step };
    });
  return parts.Make();
}
}
