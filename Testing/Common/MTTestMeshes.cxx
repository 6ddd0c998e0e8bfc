// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"

namespace MTTestMeshes
{
namespace
{
//------------------------------------------------------------------------------
// Appends a copy of a mesh, scaled, then moved.
void Append(std::vector<Place>& places, std::vector<Corners>& triangles, const std::vector<Place>& morePlaces,
  const std::vector<Corners>& moreTriangles, double scale, const Place& offset)
{
  const vtkIdType first = static_cast<vtkIdType>(places.size());
  for (const Place& p : morePlaces)
  {
    places.push_back({ scale * p[0] + offset[0], scale * p[1] + offset[1], scale * p[2] + offset[2] });
  }
  for (const Corners& t : moreTriangles)
  {
    triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

//------------------------------------------------------------------------------
// Irregular ticks for the three axes of the box [0,3] x [0,2] x [0,1].
std::array<std::vector<double>, 3> BoxTicks(int cells, std::uint64_t seed)
{
  Random random(seed);
  const double size[3] = { 3.0, 2.0, 1.0 };
  std::array<std::vector<double>, 3> ticks;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i <= cells; ++i)
    {
      // Most ticks near one end: big flat triangles beside tiny ones, as CAD tessellation gives them.
      const double x = i / static_cast<double>(cells);
      const double shifted = i == 0 || i == cells ? x : x + random.Uniform(-0.3, 0.3) / cells;
      ticks[axis].push_back(size[axis] * shifted * shifted * shifted);
    }
  }
  return ticks;
}

//------------------------------------------------------------------------------
// 12 cells^2 triangles on the box [0,3] x [0,2] x [0,1], outward. With hardEdges every face has its own points and
// normals, so the box's edges are seams; without, it is a closed manifold.
Mesh Box(int cells, std::uint64_t seed, bool hardEdges)
{
  const std::array<std::vector<double>, 3> ticks = BoxTicks(cells, seed);
  std::vector<Place> places;
  std::vector<Corners> triangles;
  std::map<Place, vtkIdType> known;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const bool high = face % 2 == 1;
    const int u = high ? (axis + 1) % 3 : (axis + 2) % 3;
    const int v = high ? (axis + 2) % 3 : (axis + 1) % 3;
    std::vector<vtkIdType> index;
    known = hardEdges ? std::map<Place, vtkIdType>() : known;
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        Place p{};
        p[axis] = high ? ticks[axis].back() : ticks[axis].front();
        p[u] = ticks[u][i];
        p[v] = ticks[v][j];
        const auto found = known.insert({ p, static_cast<vtkIdType>(places.size()) });
        index.push_back(found.first->second);
        if (found.second)
        {
          places.push_back(p);
          float n[3] = { 0.0f, 0.0f, 0.0f };
          n[axis] = high ? 1.0f : -1.0f;
          normals->InsertNextTypedTuple(n);
        }
      }
    }
    for (const Corners& t : GridTriangles(cells + 1, cells + 1))
    {
      triangles.push_back({ index[t[0]], index[t[1]], index[t[2]] });
    }
  }
  Mesh mesh = Make(places, triangles);
  if (hardEdges)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
  return mesh;
}
}

//------------------------------------------------------------------------------
Mesh Make(const std::vector<Place>& places, const std::vector<Corners>& triangles, int type)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  vtkNew<vtkCellArray> polys;
  for (const Corners& t : triangles)
  {
    polys->InsertNextCell(3, t.data());
  }
  Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

//------------------------------------------------------------------------------
double Bumps(const Place& p, std::uint64_t seed)
{
  Random random(seed);
  double sum = 0.0;
  double amplitude = 0.5;
  double frequency = 2.0;
  for (int octave = 0; octave < 5; ++octave)
  {
    double phase = random.Uniform(0.0, 6.0);
    for (int i = 0; i < 3; ++i)
    {
      phase += frequency * p[i] * random.Uniform(-1.5, 1.5);
    }
    sum += amplitude * std::sin(phase);
    amplitude *= 0.6;
    frequency *= 2.1;
  }
  return sum;
}

//------------------------------------------------------------------------------
void MakeIcosphere(int subdivisions, std::vector<Place>& places, std::vector<Corners>& triangles)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  places = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g }, { 0, -1, -g },
    { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
    { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 },
    { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  const auto normalize = [](Place& p) { vtkMath::Normalize(p.data()); };
  std::for_each(places.begin(), places.end(), normalize);
  for (int i = 0; i < subdivisions; ++i)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto middle = [&](vtkIdType a, vtkIdType b)
    {
      const auto found = middles.insert({ std::minmax(a, b), static_cast<vtkIdType>(places.size()) });
      if (found.second)
      {
        Place p;
        for (int j = 0; j < 3; ++j)
        {
          p[j] = places[a][j] + places[b][j];
        }
        normalize(p);
        places.push_back(p);
      }
      return found.first->second;
    };
    std::vector<Corners> finer;
    for (const Corners& t : triangles)
    {
      const vtkIdType a = middle(t[0], t[1]);
      const vtkIdType b = middle(t[1], t[2]);
      const vtkIdType c = middle(t[2], t[0]);
      finer.insert(finer.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
    }
    triangles.swap(finer);
  }
}

//------------------------------------------------------------------------------
Mesh Icosphere(int subdivisions)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  MakeIcosphere(subdivisions, places, triangles);
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh FractalSphere(int subdivisions, std::uint64_t seed)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  MakeIcosphere(subdivisions, places, triangles);
  for (Place& p : places)
  {
    const double radius = 1.0 + 0.2 * Bumps(p, seed);
    p = { p[0] * radius, p[1] * radius, p[2] * radius };
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
std::vector<Corners> GridTriangles(int columns, int rows, vtkIdType first)
{
  std::vector<Corners> triangles;
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const vtkIdType a = first + static_cast<vtkIdType>(j) * columns + i;
      triangles.push_back({ a, a + 1, a + columns });
      triangles.push_back({ a + 1, a + columns + 1, a + columns });
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
Mesh Terrain(int columns, int rows, std::uint64_t seed, bool holes)
{
  std::vector<Place> places;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      Place p{ i / (columns - 1.0), j / (rows - 1.0), 0.0 };
      p[2] = 0.1 * Bumps({ 4.0 * p[0], 4.0 * p[1], 0.0 }, seed);
      places.push_back(p);
    }
  }
  std::vector<Corners> triangles = GridTriangles(columns, rows);
  if (holes)
  {
    Random random(seed);
    std::vector<Corners> kept;
    for (const Corners& t : triangles)
    {
      const bool square = t[0] % columns * 8 / columns % 4 == 1 && t[0] / columns * 8 / rows % 4 == 2;
      if (!square && random.Below(20) != 0)
      {
        kept.push_back(t);
      }
    }
    triangles.swap(kept);
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh Torus(int around, int across)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  const double full = 2.0 * vtkMath::Pi();
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = full * i / around;
      const double v = full * j / across;
      const double r = 1.0 + 0.4 * std::cos(v);
      places.push_back({ r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) });
      const vtkIdType a = static_cast<vtkIdType>(i) * across + j;
      const vtkIdType b = static_cast<vtkIdType>((i + 1) % around) * across + j;
      const vtkIdType c = static_cast<vtkIdType>((i + 1) % around) * across + (j + 1) % across;
      const vtkIdType d = static_cast<vtkIdType>(i) * across + (j + 1) % across;
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh BowTie(int size, int count)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int sheet = 0; sheet < count; ++sheet)
  {
    const vtkIdType last = static_cast<vtkIdType>(places.size()) - 1;
    std::vector<vtkIdType> index;
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        if (sheet > 0 && i == 0 && j == 0)
        {
          index.push_back(last);
          continue;
        }
        const double x = sheet + i / (size - 1.0);
        const double y = sheet + j / (size - 1.0);
        index.push_back(static_cast<vtkIdType>(places.size()));
        places.push_back({ x, y, 0.1 * Bumps({ x, y, 0.0 }, 3) });
      }
    }
    for (const Corners& t : GridTriangles(size, size))
    {
      triangles.push_back({ index[t[0]], index[t[1]], index[t[2]] });
    }
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh ClosedBowTie(int subdivisions)
{
  std::vector<Place> sphere;
  std::vector<Corners> sphereTriangles;
  MakeIcosphere(subdivisions, sphere, sphereTriangles);
  std::vector<Place> places = sphere;
  std::vector<Corners> triangles = sphereTriangles;
  const vtkIdType shift = static_cast<vtkIdType>(sphere.size()) - 1;
  const Place pole = sphere[0];
  // The second sphere is the first one mirrored at its point 0, which stays where it is.
  for (std::size_t i = 1; i < sphere.size(); ++i)
  {
    const Place& p = sphere[i];
    places.push_back({ 2.0 * pole[0] - p[0], 2.0 * pole[1] - p[1], 2.0 * pole[2] - p[2] });
  }
  for (const Corners& t : sphereTriangles)
  {
    const auto mirror = [shift](vtkIdType i) { return i == 0 ? i : i + shift; };
    triangles.push_back({ mirror(t[0]), mirror(t[2]), mirror(t[1]) });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh Fin(int size)
{
  std::vector<Place> places;
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      places.push_back({ i / (size - 1.0), j / (size - 1.0), 0.0 });
    }
  }
  std::vector<Corners> triangles = GridTriangles(size, size);
  const int half = size / 2;
  std::vector<vtkIdType> index;
  for (int k = 0; k <= half; ++k)
  {
    for (int i = 0; i < size; ++i)
    {
      if (k == 0)
      {
        index.push_back(static_cast<vtkIdType>(half) * size + i);
        continue;
      }
      index.push_back(static_cast<vtkIdType>(places.size()));
      places.push_back({ i / (size - 1.0), half / (size - 1.0), k / (size - 1.0) });
    }
  }
  for (const Corners& t : GridTriangles(size, half + 1))
  {
    triangles.push_back({ index[t[0]], index[t[1]], index[t[2]] });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh Soup(vtkPolyData* mesh)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    const vtkIdType first = static_cast<vtkIdType>(places.size());
    for (int i = 0; i < 3; ++i)
    {
      Place p;
      mesh->GetPoint(ids->GetId(i), p.data());
      places.push_back(p);
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh SphereSoup(int subdivisions)
{
  return Soup(FractalSphere(subdivisions));
}

//------------------------------------------------------------------------------
Mesh RandomSoup(int count, std::uint64_t seed, double size)
{
  Random random(seed);
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int t = 0; t < count; ++t)
  {
    const Place center{ random.Uniform(), random.Uniform(), random.Uniform() };
    for (int i = 0; i < 3; ++i)
    {
      places.push_back({ center[0] + random.Uniform(-size, size), center[1] + random.Uniform(-size, size),
        center[2] + random.Uniform(-size, size) });
    }
    triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh ManyComponents(int count, int subdivisions, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Place> sphere;
  std::vector<Corners> sphereTriangles;
  MakeIcosphere(subdivisions, sphere, sphereTriangles);
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i)
  {
    const double scale = random.Uniform(0.001, 0.01);
    Append(places, triangles, sphere, sphereTriangles, scale, { random.Uniform(), random.Uniform(), random.Uniform() });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh CoincidentSheets(int size, int sheets)
{
  const Mesh terrain = Terrain(size, size, 7);
  std::vector<Place> sheet(terrain->GetNumberOfPoints());
  for (std::size_t i = 0; i < sheet.size(); ++i)
  {
    terrain->GetPoint(static_cast<vtkIdType>(i), sheet[i].data());
  }
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int i = 0; i < sheets; ++i)
  {
    Append(places, triangles, sheet, GridTriangles(size, size), 1.0, { 0.0, 0.0, 0.0 });
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh CadBox(int cells, std::uint64_t seed)
{
  return Box(cells, seed, false);
}

//------------------------------------------------------------------------------
Mesh HardEdgeBox(int cells, std::uint64_t seed)
{
  return Box(cells, seed, true);
}

//------------------------------------------------------------------------------
Mesh SeamSphere(int around, int down)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (int j = 0; j <= down; ++j)
  {
    for (int i = 0; i <= around; ++i)
    {
      const bool pole = j == 0 || j == down;
      const double theta = vtkMath::Pi() * j / down;
      const double phi = 2.0 * vtkMath::Pi() * (i % around) / around;
      const double r = pole ? 0.0 : std::sin(theta);
      places.push_back({ r * std::cos(phi), r * std::sin(phi), pole ? (j == 0 ? 1.0 : -1.0) : std::cos(theta) });
      const float uv[2] = { static_cast<float>(i) / around, static_cast<float>(j) / down };
      coordinates->InsertNextTypedTuple(uv);
      if (i == around || j == down)
      {
        continue;
      }
      const vtkIdType a = static_cast<vtkIdType>(j) * (around + 1) + i;
      const vtkIdType b = a + around + 1;
      if (j + 1 < down)
      {
        triangles.push_back({ a, b, b + 1 });
      }
      if (j > 0)
      {
        triangles.push_back({ a, b + (j + 1 < down ? 1 : 0), a + 1 });
      }
    }
  }
  Mesh mesh = Make(places, triangles);
  mesh->GetPointData()->SetTCoords(coordinates);
  return mesh;
}

//------------------------------------------------------------------------------
Mesh Quads(int columns, int rows)
{
  Mesh mesh = Terrain(columns, rows);
  vtkNew<vtkCellArray> polys;
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * columns + i;
      const vtkIdType quad[4] = { a, a + 1, a + columns + 1, a + columns };
      polys->InsertNextCell(4, quad);
    }
  }
  mesh->SetPolys(polys);
  return mesh;
}

//------------------------------------------------------------------------------
Mesh Strips(int columns, int rows)
{
  Mesh mesh = Terrain(columns, rows);
  vtkNew<vtkCellArray> strips;
  for (int j = 0; j + 1 < rows; ++j)
  {
    strips->InsertNextCell(2 * columns);
    for (int i = 0; i < columns; ++i)
    {
      strips->InsertCellPoint(static_cast<vtkIdType>(j + 1) * columns + i);
      strips->InsertCellPoint(static_cast<vtkIdType>(j) * columns + i);
    }
  }
  mesh->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  mesh->SetStrips(strips);
  return mesh;
}

//------------------------------------------------------------------------------
Mesh Polygons(int count)
{
  std::vector<Place> places;
  vtkNew<vtkCellArray> polys;
  for (int k = 0; k < count; ++k)
  {
    const double x = 2.0 * k;
    const vtkIdType first = static_cast<vtkIdType>(places.size());
    places.insert(places.end(),
      { { x, 0, 0 }, { x + 2, 0, 0 }, { x + 2, 1, 0 }, { x + 1, 1, 0 }, { x + 1, 2, 0 }, { x, 2, 0 },
        { x + 2, 2, 0 } });
    const vtkIdType ell[6] = { first, first + 1, first + 2, first + 3, first + 4, first + 5 };
    const vtkIdType square[4] = { first + 3, first + 2, first + 6, first + 4 };
    polys->InsertNextCell(6, ell);
    polys->InsertNextCell(4, square);
  }
  Mesh mesh = Make(places, {});
  mesh->SetPolys(polys);
  return mesh;
}

//------------------------------------------------------------------------------
Mesh Dirty(int size, int each, Dirt* dirt, bool outOfRange)
{
  const Mesh terrain = Terrain(size, size);
  std::vector<Place> places(terrain->GetNumberOfPoints());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    terrain->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  std::vector<Corners> triangles = GridTriangles(size, size);
  const Corners copied = triangles.front();
  const vtkIdType sound = static_cast<vtkIdType>(triangles.size());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < each; ++i)
  {
    triangles.push_back({ 0, 1, 1 });
    const vtkIdType first = static_cast<vtkIdType>(places.size());
    places.insert(places.end(), { { 0.25, 0.5, 0.5 }, { 0.5, 0.5, 0.5 }, { 0.75, 0.5, 0.5 } });
    triangles.push_back({ first, first + 1, first + 2 });
    places.push_back({ 0.0, i % 2 ? nan : infinity, 0.0 });
    triangles.push_back({ 0, 1, first + 3 });
    triangles.push_back(copied);
    if (outOfRange)
    {
      triangles.push_back({ 0, 1, i % 2 ? vtkIdType(-5) : vtkIdType(1) << 40 });
    }
  }
  if (dirt)
  {
    dirt->Sound = sound;
    dirt->RepeatedPoint = dirt->Flat = dirt->NotFinite = dirt->Duplicate = each;
    dirt->OutOfRange = outOfRange ? each : 0;
  }
  return Make(places, triangles);
}

//------------------------------------------------------------------------------
Mesh OnlyDegenerate(int count)
{
  return Make({ { 0, 0, 0 }, { 1, 0, 0 } }, std::vector<Corners>(count, Corners{ 0, 1, 1 }));
}

//------------------------------------------------------------------------------
void AddArrays(vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType cells = mesh->GetNumberOfCells();
  double bounds[6];
  mesh->GetBounds(bounds);
  vtkNew<vtkDoubleArray> elevation;
  vtkNew<vtkUnsignedCharArray> colour;
  vtkNew<vtkIntArray> label;
  vtkNew<vtkFloatArray> tensor;
  vtkNew<vtkIdTypeArray> ids;
  elevation->SetName("elevation");
  colour->SetName("colour");
  colour->SetNumberOfComponents(3);
  label->SetName("label");
  tensor->SetName("tensor");
  tensor->SetNumberOfComponents(9);
  tensor->SetComponentName(0, "xx");
  tensor->SetComponentName(1, "xy");
  ids->SetName("ids");
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    elevation->InsertNextValue(p[2]);
    for (int c = 0; c < 3; ++c)
    {
      const double extent = bounds[2 * c + 1] - bounds[2 * c];
      const double share = extent > 0.0 ? (p[c] - bounds[2 * c]) / extent : 0.0;
      colour->InsertNextValue(static_cast<unsigned char>(255.0 * std::min(1.0, std::max(0.0, share))));
    }
    label->InsertNextValue(p[0] < 0.5 * (bounds[0] + bounds[1]) ? 7 : -3);
    for (int c = 0; c < 9; ++c)
    {
      tensor->InsertNextValue(static_cast<float>(p[c % 3] * (c + 1)));
    }
    ids->InsertNextValue(1000000000000 + i);
  }
  mesh->GetPointData()->SetScalars(elevation);
  mesh->GetPointData()->AddArray(colour);
  mesh->GetPointData()->AddArray(label);
  mesh->GetPointData()->AddArray(tensor);
  mesh->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkIdTypeArray> face;
  vtkNew<vtkFloatArray> weight;
  vtkSmartPointer<vtkDataArray> flag;
  flag.TakeReference(vtkDataArray::CreateDataArray(VTK_SHORT));
  face->SetName("face");
  weight->SetName("weight");
  flag->SetName("flag");
  for (vtkIdType i = 0; i < cells; ++i)
  {
    face->InsertNextValue(i);
    weight->InsertNextValue(static_cast<float>(0.5 * i));
    flag->InsertNextTuple1(static_cast<double>(i % 100) - 50.0);
  }
  mesh->GetCellData()->AddArray(face);
  mesh->GetCellData()->AddArray(weight);
  mesh->GetCellData()->AddArray(flag);
}

//------------------------------------------------------------------------------
EdgeFigures CountEdges(vtkPolyData* mesh, bool byPlace)
{
  std::vector<vtkIdType> index(mesh->GetNumberOfPoints());
  std::map<Place, vtkIdType> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Place p;
    mesh->GetPoint(i, p.data());
    index[i] = byPlace ? places.insert({ p, i }).first->second : i;
  }
  std::map<std::pair<vtkIdType, vtkIdType>, std::array<int, 2>> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType a = index[ids->GetId(i)];
      const vtkIdType b = index[ids->GetId((i + 1) % ids->GetNumberOfIds())];
      ++edges[std::minmax(a, b)][a < b ? 0 : 1];
    }
  }
  EdgeFigures figures;
  for (const auto& edge : edges)
  {
    const int forward = edge.second[0];
    const int backward = edge.second[1];
    vtkIdType& figure = forward + backward == 1 ? figures.Open
      : forward == 1 && backward == 1           ? figures.Inner
                                                : figures.Crowded;
    ++figure;
  }
  return figures;
}
}
