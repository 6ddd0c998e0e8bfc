// SPDX-License-Identifier: BSD-3-Clause
// The generated meshes and their PLY files.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "vtkMTFractalSphere.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPerlinNoise.h"
#include "vtkMTPlane.h"
#include "vtkMTPlyReader.h"

#include "vtkNew.h"
#include "vtkPLYReader.h"

#include <cmath>
#include <map>

using namespace MTIOTest;

namespace
{
struct Mesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint64_t, 3>> Triangles;
};

Mesh Collect(vtkMTTriangleStream& stream)
{
  Mesh mesh;
  EXPECT_TRUE(stream.Rewind());
  vtkMTTriangleStream::PointBlock points;
  while (stream.NextPoints(points) && !points.Points.empty())
  {
    mesh.Points.insert(mesh.Points.end(), points.Points.begin(), points.Points.end());
  }
  vtkMTTriangleStream::TriangleBlock triangles;
  while (stream.NextTriangles(triangles) && !triangles.Triangles.empty())
  {
    for (std::size_t i = 0; i < triangles.Triangles.size(); ++i)
    {
      EXPECT_EQ(triangles.CellIds[i], static_cast<std::int64_t>(mesh.Triangles.size()));
      mesh.Triangles.push_back(triangles.Triangles[i]);
    }
  }
  EXPECT_EQ(mesh.Points.size(), stream.GetNumberOfPoints());
  EXPECT_EQ(mesh.Triangles.size(), stream.GetNumberOfTriangles());
  return mesh;
}

// Edges that do not have exactly two triangles in opposite directions.
std::size_t CountOpenEdges(const Mesh& mesh)
{
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> edges;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++edges[{ triangle[i], triangle[(i + 1) % 3] }];
    }
  }
  std::size_t open = 0;
  for (const auto& edge : edges)
  {
    const auto opposite = edges.find({ edge.first.second, edge.first.first });
    open += edge.second != 1 || opposite == edges.end();
  }
  return open;
}

double SignedVolume(const Mesh& mesh)
{
  double volume = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    const auto& a = mesh.Points[triangle[0]];
    const auto& b = mesh.Points[triangle[1]];
    const auto& c = mesh.Points[triangle[2]];
    volume +=
      (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
  }
  return volume;
}

// Improved noise written from the paper once more, with the gradients as a table and the sum over the cell's eight
// corners; the permutation in base 16.
const std::string PermutationText =
  "97a0895b5a0f830dc95f6035c2e907e18c24671e458e086325f0150a17be0694f778ea4b001ac53e5efcdbcb75230b2039b1"
  "2158ed953857ae147d88aba844af4aa547868b301ba64d929ee7536fe57a3cd385e6dc695c29372ef528f4668f3641193fa1"
  "01d85049d14c84bbd05912a9c8c4878274bc9f56a4646dc6adba034034d9e2fa7c7b05ca2693767eff5255d4cfce3be32f10"
  "3a11b6bd1c2adfb7aad577f898022c9aa346dd99659ba72bac09811627fd13626c6e4f71e0e8b2b97068daf661e4fb22f2c1"
  "eed2900cbfb3a2f1513391ebf90eef6b31c0d61fb5c76a9db854ccb07379322d7f0496fe8aeccd5dde72431d1848f38d80c3"
  "4e42d73d9cb4";

int Permute(int i)
{
  return std::stoi(PermutationText.substr(2 * static_cast<std::size_t>(i & 255), 2), nullptr, 16);
}

double ReferenceNoise(double x, double y, double z)
{
  static const int gradients[16][3] = { { 1, 1, 0 }, { -1, 1, 0 }, { 1, -1, 0 }, { -1, -1, 0 }, { 1, 0, 1 },
    { -1, 0, 1 }, { 1, 0, -1 }, { -1, 0, -1 }, { 0, 1, 1 }, { 0, -1, 1 }, { 0, 1, -1 }, { 0, -1, -1 }, { 1, 1, 0 },
    { 0, -1, 1 }, { -1, 1, 0 }, { 0, -1, -1 } };
  const double place[3] = { x, y, z };
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    double dot = 0.0;
    int hash = 0;
    double offset[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = (corner >> axis) & 1;
      const double cell = std::floor(place[axis]);
      const double t = place[axis] - cell;
      const double fade = 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3);
      weight *= side ? fade : 1.0 - fade;
      offset[axis] = t - side;
      hash = Permute(hash + static_cast<int>(cell) + side);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      dot += gradients[hash & 15][axis] * offset[axis];
    }
    sum += weight * dot;
  }
  return sum;
}

double ReferenceFactor(const std::array<double, 3>& p)
{
  double factor = 1.0;
  for (int o = 0; o < 8; ++o)
  {
    const double f = 1.7 * std::pow(2.03, o);
    factor += 0.25 * std::pow(0.47, o) * ReferenceNoise(f * p[0], f * p[1], f * p[2]);
  }
  return factor;
}
}

//------------------------------------------------------------------------------
TEST(Generators, NoiseIsPerlinsImprovedNoise)
{
  const vtkMTPerlinNoise noise;
  // A value that is published with the reference implementation.
  EXPECT_DOUBLE_EQ(noise.Evaluate(3.14, 42, 7), 0.13691995878400012);
  MTTestMeshes::Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = random.Uniform(-300, 300);
    const double y = random.Uniform(-300, 300);
    const double z = random.Uniform(-300, 300);
    const double value = noise.Evaluate(x, y, z);
    worst = std::max(worst, std::abs(value - ReferenceNoise(x, y, z)));
    EXPECT_LE(std::abs(value), 1.1);
    EXPECT_EQ(noise.Evaluate(std::floor(x), std::floor(y), std::floor(z)), 0.0);
  }
  std::cout << "largest difference from the reference: " << worst << "\n";
  EXPECT_LT(worst, 1e-12);
}

TEST(Generators, SeedChangesTheNoise)
{
  EXPECT_NE(vtkMTPerlinNoise(1).Evaluate(0.3, 0.4, 0.5), vtkMTPerlinNoise(2).Evaluate(0.3, 0.4, 0.5));
  EXPECT_EQ(vtkMTPerlinNoise(7).Evaluate(0.3, 0.4, 0.5), vtkMTPerlinNoise(7).Evaluate(0.3, 0.4, 0.5));
}

TEST(Generators, CountIsTheNearestThatAnIcosphereCanHave)
{
  const std::vector<std::pair<std::uint64_t, std::uint64_t>> cases = { { 0, 20 }, { 20, 20 }, { 50, 20 }, { 51, 80 },
    { 80, 80 }, { 1000, 1280 }, { 1310720, 1310720 }, { 1000000, 1310720 }, { 335544320, 335544320 } };
  for (const auto& test : cases)
  {
    EXPECT_EQ(vtkMTFractalSphere(test.first).GetNumberOfTriangles(), test.second) << test.first;
  }
  EXPECT_EQ(vtkMTFractalSphere(1310720).GetNumberOfPoints(), 655362u);
  EXPECT_EQ(vtkMTFractalSphere::ChooseSubdivisions(~std::uint64_t(0)), vtkMTFractalSphere::MaximumSubdivisions);
}

TEST(Generators, SphereIsAClosedOutwardManifoldOfGenusZero)
{
  for (int k = 0; k <= 5; ++k)
  {
    vtkMTFractalSphere sphere(std::uint64_t(20) << (2 * k), 3);
    const Mesh mesh = Collect(sphere);
    EXPECT_EQ(mesh.Triangles.size(), std::size_t(20) << (2 * k));
    EXPECT_EQ(CountOpenEdges(mesh), 0u);
    EXPECT_EQ(mesh.Points.size(), mesh.Triangles.size() / 2 + 2); // Euler's formula
    std::vector<bool> used(mesh.Points.size());
    for (const auto& triangle : mesh.Triangles)
    {
      for (const std::uint64_t point : triangle)
      {
        used.at(point) = true;
      }
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    EXPECT_GT(SignedVolume(mesh), 1.0);
  }
}

TEST(Generators, SphereIsTheIcosphereOfRepeatedHalving)
{
  // The directions of the points are those that the tests' own icosphere has, whose factor is 1.
  for (int k = 0; k <= 4; ++k)
  {
    vtkMTFractalSphere sphere(std::uint64_t(20) << (2 * k));
    const Mesh mesh = Collect(sphere);
    const MTTestMeshes::Mesh expected = MTTestMeshes::Icosphere(k);
    const auto key = [](double x, double y, double z)
    {
      const double length = std::sqrt(x * x + y * y + z * z);
      return std::array<long, 3>{ std::lround(x / length * 1e5), std::lround(y / length * 1e5),
        std::lround(z / length * 1e5) };
    };
    std::map<std::array<long, 3>, int> directions;
    for (const auto& p : mesh.Points)
    {
      ++directions[key(p[0], p[1], p[2])];
    }
    EXPECT_EQ(directions.size(), mesh.Points.size());
    std::size_t missing = 0;
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      const double* p = expected->GetPoint(i);
      const auto at = key(p[0], p[1], p[2]);
      bool found = false;
      for (int n = 0; n < 27; ++n) // rounding may end on either side
      {
        found = found || directions.count({ at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1 });
      }
      missing += !found;
    }
    EXPECT_EQ(missing, 0u) << k;
  }
}

TEST(Generators, PointsAreMovedByTheFormula)
{
  vtkMTFractalSphere sphere(20480);
  const Mesh mesh = Collect(sphere);
  double worst = 0.0;
  double least = 2.0;
  double most = 0.0;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 37)
  {
    const auto& p = mesh.Points[i];
    const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const double factor = ReferenceFactor({ p[0] / radius, p[1] / radius, p[2] / radius });
    worst = std::max(worst, std::abs(radius - factor));
    least = std::min(least, radius);
    most = std::max(most, radius);
    for (const double x : p)
    {
      EXPECT_EQ(x, static_cast<float>(x));
    }
  }
  std::cout << "radius " << least << " to " << most << "; largest difference from the formula " << worst << "\n";
  // The direction itself is known to single precision only.
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(least, 0.95);
  EXPECT_GT(most, 1.05);
}

TEST(Generators, PlaneIsAFlatSquareOfTheNearestCount)
{
  const std::vector<std::pair<std::uint64_t, std::uint64_t>> cases = { { 0, 2 }, { 2, 2 }, { 4, 2 }, { 6, 8 },
    { 1000, 968 }, { 20000, 20000 } };
  for (const auto& test : cases)
  {
    vtkMTPlane plane(test.first);
    const Mesh mesh = Collect(plane);
    EXPECT_EQ(mesh.Triangles.size(), test.second) << test.first;
    double area = 0.0;
    for (const auto& t : mesh.Triangles)
    {
      const auto& a = mesh.Points[t[0]];
      const auto& b = mesh.Points[t[1]];
      const auto& c = mesh.Points[t[2]];
      const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      EXPECT_GT(twice, 0.0);
      area += twice / 2;
    }
    EXPECT_NEAR(area, 1.0, 1e-6);
    const std::size_t n = static_cast<std::size_t>(std::lround(std::sqrt(test.second / 2.0)));
    EXPECT_EQ(CountOpenEdges(mesh), 4 * n);
  }
}

//------------------------------------------------------------------------------
TEST(Generators, SameSeedGivesTheSameFile)
{
  Folder folder;
  std::string error;
  for (const char* name : { "a.ply", "b.ply" })
  {
    vtkMTFractalSphere sphere(5000, 42);
    ASSERT_TRUE(vtkMTMeshWriter::WritePly(sphere, folder / name, error)) << error;
  }
  vtkMTFractalSphere other(5000, 43);
  ASSERT_TRUE(vtkMTMeshWriter::WritePly(other, folder / "c.ply", error)) << error;
  EXPECT_EQ(ReadFile(folder / "a.ply"), ReadFile(folder / "b.ply"));
  EXPECT_NE(ReadFile(folder / "a.ply"), ReadFile(folder / "c.ply"));
}

TEST(Generators, PlyFileGivesTheSameMeshToVtksReaderAndToOurs)
{
  Folder folder;
  std::string error;
  vtkMTFractalSphere sphere(81920, 1);
  ASSERT_TRUE(vtkMTMeshWriter::WritePly(sphere, folder / "sphere.ply", error, vtkMTMeshWriter::Precision::Single))
    << error;
  const Mesh mesh = Collect(sphere);
  vtkNew<vtkPLYReader> vtkReader;
  vtkReader->SetFileName((folder / "sphere.ply").c_str());
  vtkReader->Update();
  vtkNew<vtkPolyData> ours;
  ASSERT_TRUE(vtkMTPlyReader::Read(folder / "sphere.ply", ours, error)) << error;
  for (vtkPolyData* read : { vtkReader->GetOutput(), ours.Get() })
  {
    ASSERT_EQ(static_cast<std::size_t>(read->GetNumberOfPoints()), mesh.Points.size());
    ASSERT_EQ(static_cast<std::size_t>(read->GetNumberOfPolys()), mesh.Triangles.size());
    EXPECT_EQ(read->GetPoints()->GetDataType(), VTK_FLOAT);
    std::size_t different = 0;
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      double p[3];
      read->GetPoint(static_cast<vtkIdType>(i), p);
      different += !std::equal(p, p + 3, mesh.Points[i].begin());
    }
    for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      read->GetPolys()->GetCellAtId(static_cast<vtkIdType>(i), count, corners);
      different += count != 3 ||
        !std::equal(corners, corners + 3, mesh.Triangles[i].begin(),
          [](vtkIdType a, std::uint64_t b) { return static_cast<std::uint64_t>(a) == b; });
    }
    EXPECT_EQ(different, 0u);
  }
}

TEST(Generators, MemoryDoesNotFollowTheMesh)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "a sanitizer keeps memory that was freed";
  }
  Folder folder;
  const auto peakKilobytes = []
  {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line) && line.compare(0, 6, "VmHWM:") != 0)
    {
    }
    return std::stol(line.substr(6));
  };
  const auto write = [&folder](std::uint64_t triangles)
  {
    std::string error;
    vtkMTFractalSphere sphere(triangles);
    EXPECT_TRUE(vtkMTMeshWriter::WritePly(sphere, folder / "sphere.ply", error, vtkMTMeshWriter::Precision::Single))
      << error;
  };
  write(81920);
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak starts anew
  const long before = peakKilobytes();
  write(1310720);
  const long grown = peakKilobytes() - before;
  const std::uintmax_t size = std::filesystem::file_size(folder / "sphere.ply");
  std::cout << size << " bytes of PLY: peak memory grew by " << grown << " kB\n";
  EXPECT_GT(size, 655362u * 12 + 1310720u * 13);
  EXPECT_LT(grown, 4096);
}

TEST(Generators, ProgressRisesToOne)
{
  Folder folder;
  std::string error;
  std::vector<double> seen;
  vtkMTPlane plane(100000);
  ASSERT_TRUE(vtkMTMeshWriter::WritePly(plane, folder / "plane.ply", error, vtkMTMeshWriter::Precision::Automatic,
    [&seen](double done) { seen.push_back(done); }))
    << error;
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  ASSERT_GT(seen.size(), 3u);
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}
