// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionMeshes.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPerlinNoise.h"
#include "vtkPoints.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>

namespace MTPartitionTest
{
namespace
{
std::uint32_t GetMiddle(
  Mesh& mesh, std::map<std::array<std::uint32_t, 2>, std::uint32_t>& middles, std::uint32_t a, std::uint32_t b)
{
  const auto place =
    middles.try_emplace({ std::min(a, b), std::max(a, b) }, static_cast<std::uint32_t>(mesh.Vertices.size()));
  if (place.second)
  {
    const Point& p = mesh.Vertices[a];
    const Point& q = mesh.Vertices[b];
    Point m = { p[0] + q[0], p[1] + q[1], p[2] + q[2] };
    const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    mesh.Vertices.push_back({ m[0] / length, m[1] / length, m[2] / length });
  }
  return place.first->second;
}

void Subdivide(Mesh& mesh)
{
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : mesh.Triangles)
  {
    const std::uint32_t a = GetMiddle(mesh, middles, t[0], t[1]);
    const std::uint32_t b = GetMiddle(mesh, middles, t[1], t[2]);
    const std::uint32_t c = GetMiddle(mesh, middles, t[2], t[0]);
    triangles.insert(triangles.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
  }
  mesh.Triangles = std::move(triangles);
}

Mesh MakeSphere(int subdivisions)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const double l = std::sqrt(1.0 + g * g);
  Mesh mesh;
  for (const Point& p : Points{ { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
         { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } })
  {
    mesh.Vertices.push_back({ p[0] / l, p[1] / l, p[2] / l });
  }
  mesh.Triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
    { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 },
    { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for (int i = 0; i < subdivisions; ++i)
  {
    Subdivide(mesh);
  }
  return mesh;
}

void Append(Mesh& scene, const Mesh& mesh, double size, const Point& place)
{
  const std::uint32_t first = static_cast<std::uint32_t>(scene.Vertices.size());
  for (const Point& p : mesh.Vertices)
  {
    scene.Vertices.push_back({ place[0] + size * p[0], place[1] + size * p[1], place[2] + size * p[2] });
  }
  for (const auto& t : mesh.Triangles)
  {
    scene.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
}

Mesh MakeGrid(int n)
{
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.Vertices.push_back({ static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0 });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const std::uint32_t a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const std::uint32_t c = a + static_cast<std::uint32_t>(n) + 1;
      mesh.Triangles.push_back({ a, a + 1, c + 1 });
      mesh.Triangles.push_back({ a, c + 1, c });
    }
  }
  return mesh;
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> Read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".vtp" ? Read<vtkXMLPolyDataReader>(path)
    : ending == ".ply"    ? Read<vtkPLYReader>(path)
    : ending == ".stl"    ? Read<vtkSTLReader>(path)
    : ending == ".obj"    ? Read<vtkOBJReader>(path)
                          : Read<vtkPolyDataReader>(path);
}
}

Points Mesh::GetBarycentres() const
{
  Points barycentres;
  barycentres.reserve(this->Triangles.size());
  for (const auto& t : this->Triangles)
  {
    Point sum = { 0.0, 0.0, 0.0 };
    for (const std::uint32_t v : t)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += this->Vertices[v][axis];
      }
    }
    barycentres.push_back({ sum[0] / 3.0, sum[1] / 3.0, sum[2] / 3.0 });
  }
  return barycentres;
}

vtkSmartPointer<vtkPolyData> Mesh::GetPolyData() const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : this->Vertices)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const auto& t : this->Triangles)
  {
    polys->InsertNextCell({ static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]), static_cast<vtkIdType>(t[2]) });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

Mesh MakeFractalSphere(int subdivisions)
{
  Mesh mesh = MakeSphere(subdivisions);
  vtkNew<vtkPerlinNoise> noise;
  for (Point& p : mesh.Vertices)
  {
    double radius = 1.0;
    for (int octave = 0; octave < 8; ++octave)
    {
      const double frequency = 1.7 * std::pow(2.03, octave);
      noise->SetFrequency(frequency, frequency, frequency);
      radius += 0.25 * std::pow(0.47, octave) * noise->EvaluateFunction(p.data());
    }
    p = { radius * p[0], radius * p[1], radius * p[2] };
  }
  return mesh;
}

Mesh MakeTerrain(int n)
{
  Mesh mesh = MakeGrid(n);
  for (Point& p : mesh.Vertices)
  {
    p[2] = 0.05 * std::sin(7.0 * p[0]) * std::cos(5.0 * p[1]) + 0.01 * std::sin(31.0 * p[0] * p[1]);
  }
  return mesh;
}

Mesh MakeUnevenScene()
{
  std::mt19937 random(5);
  const auto next = [&random] { return random() * (1.0 / 4294967296.0); };
  const Mesh ball = MakeSphere(4);
  const Mesh plate = MakeGrid(100);
  Mesh scene;
  for (int i = 0; i < 12; ++i)
  {
    Append(scene, ball, std::pow(10.0, -i % 7), { 20.0 * next(), 20.0 * next(), 20.0 * next() });
  }
  for (int i = 0; i < 3; ++i)
  {
    Append(scene, plate, 20.0, { 0.0, 0.0, 20.0 * next() });
  }
  return scene;
}

Points MakeCloud(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  const auto next = [&random] { return random() * (1.0 / 4294967296.0); };
  Points points(count);
  for (Point& p : points)
  {
    p = { next(), next(), next() };
  }
  return points;
}

Points MakeShrinkingHelix(std::size_t count)
{
  Points points(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const double r = std::pow(10.0, -12.0 * t);
    points[i] = { r * std::cos(200.0 * t), r * std::sin(200.0 * t), r };
  }
  return points;
}

std::vector<std::string> GetDataFiles()
{
  const char* variable = std::getenv("MT_TEST_DATA");
  const std::filesystem::path folder =
    variable ? std::filesystem::path(variable) : std::filesystem::path(MT_SOURCE_DIRECTORY) / ".." / "shared" / "data";
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
  {
    const std::string ending = i->path().extension().string();
    const bool readable =
      ending == ".vtp" || ending == ".ply" || ending == ".stl" || ending == ".obj" || ending == ".vtk";
    // Some files of the folder are there because VTK's reader crashes on them, and are named so.
    if (readable && i->path().string().find("crashes") == std::string::npos)
    {
      files.push_back(i->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Mesh ReadMesh(const std::string& path, bool weld)
{
  const vtkSmartPointer<vtkPolyData> data = ReadPolyData(path);
  Mesh mesh;
  mesh.Vertices.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  std::map<Point, std::uint32_t> welded;
  std::vector<std::uint32_t> place(mesh.Vertices.size());
  for (std::uint32_t i = 0; i < mesh.Vertices.size(); ++i)
  {
    data->GetPoint(i, mesh.Vertices[i].data());
    place[i] = weld ? welded.try_emplace(mesh.Vertices[i], i).first->second : i;
  }
  const auto add = [&mesh, &place](vtkIdList* ids, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    mesh.Triangles.push_back({ place[static_cast<std::size_t>(ids->GetId(a))],
      place[static_cast<std::size_t>(ids->GetId(b))], place[static_cast<std::size_t>(ids->GetId(c))] });
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetPolys()->GetNumberOfCells(); ++cell)
  {
    data->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      add(ids, 0, i - 1, i);
    }
  }
  for (vtkIdType cell = 0; cell < data->GetStrips()->GetNumberOfCells(); ++cell)
  {
    data->GetStrips()->GetCellAtId(cell, ids);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      add(ids, i - 2, i - 1, i);
    }
  }
  return mesh;
}
}
