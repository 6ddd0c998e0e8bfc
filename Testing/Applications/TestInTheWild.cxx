// SPDX-License-Identifier: BSD-3-Clause
// Meshes as people have them: each becomes a model that passes every check, in which every triangle of the input is in
// the finest level or counted with its reason, or is refused with a message.
#include "MTTestMeshes.h"

#include "bmtInput.h"

#include "vtkMTCut.h"
#include "vtkMTErrorSampling.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>

namespace
{
using MTTestMeshes::Corners;
using MTTestMeshes::Mesh;
using MTTestMeshes::Place;
using Report = std::map<std::string, std::int64_t>;

struct Built
{
  vtkMTPatchStore Store;
  bool IsGood = false;
  std::string Error;
  const vtkMTGraph& GetGraph() const { return this->Store.GetGraph(); }
};

void Build(vtkPolyData* mesh, Built& built)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(100);
  builder->SetInputIds(vtkMultiTriangulationBuilder::AllInputIds);
  vtkMTPolyDataStream stream(mesh);
  built.IsGood = builder->Build(stream, built.Store);
  built.Error = builder->GetErrorMessage();
}

std::int64_t CountDropped(const Report& report)
{
  std::int64_t dropped = 0;
  for (const auto& [reason, count] : report)
  {
    dropped += reason.rfind("dropped_", 0) == 0 ? count : 0;
  }
  return dropped;
}

// Conforming, nested, whole; certified against the input; and no triangle lost.
void ExpectSound(const std::string& name, const Built& built, vtkPolyData* mesh, std::uint64_t triangles)
{
  const vtkMTGraph& graph = built.GetGraph();
  const vtkMTValidate::Result valid = vtkMTValidate::All(built.Store, 40, 1);
  EXPECT_TRUE(valid.IsValid()) << name << ": " << (valid.Findings.empty() ? "" : valid.Findings.front().What);
  vtkMTPolyDataStream stream(mesh);
  vtkMTSampledSurface input;
  std::string error;
  ASSERT_TRUE(input.Read(
    stream, [] { return true; }, error))
    << name << ": " << error;
  vtkMTErrorSampling sampling(built.Store, std::move(input), 2000, 1);
  const auto goOn = [](const std::string&, double) { return true; };
  for (std::uint32_t level = 0; level < graph.GetNumberOfLevels(); ++level)
  {
    EXPECT_TRUE(sampling.TestLevel(level, goOn, error)) << error;
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_TRUE(sampling.TestCut(vtkMTRandomCut::Make(graph, 1, i), "random cut", goOn, error)) << error;
  }
  EXPECT_TRUE(sampling.GetPatchToInput().IsOk()) << name << ": " << sampling.GetPatchToInput().Message;
  EXPECT_TRUE(sampling.GetInputToCut().IsOk()) << name << ": " << sampling.GetInputToCut().Message;
  EXPECT_EQ(graph.InputCounts.Triangles, triangles) << name;
  EXPECT_EQ(graph.GetNumberOfFinestTriangles() + static_cast<std::uint64_t>(CountDropped(graph.InputReport)), triangles)
    << name << ": stored and dropped are not all";
  std::printf("%-28s %8llu triangles, %8llu stored, %2u levels;", name.c_str(),
    static_cast<unsigned long long>(triangles), static_cast<unsigned long long>(graph.GetNumberOfFinestTriangles()),
    graph.GetNumberOfLevels());
  for (const auto& [reason, count] : graph.InputReport)
  {
    std::printf(" %s %lld", reason.c_str(), static_cast<long long>(count));
  }
  std::printf("\n");
}

//------------------------------------------------------------------------------
// A terrain of size x size points with something done to it.
struct Parts
{
  std::vector<Place> Places;
  std::vector<Corners> Triangles;

  explicit Parts(int size)
    : Triangles(MTTestMeshes::GridTriangles(size, size))
  {
    const Mesh terrain = MTTestMeshes::Terrain(size, size);
    this->Places.resize(static_cast<std::size_t>(terrain->GetNumberOfPoints()));
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      terrain->GetPoint(static_cast<vtkIdType>(i), this->Places[i].data());
    }
  }
  Mesh Make() const { return MTTestMeshes::Make(this->Places, this->Triangles, VTK_DOUBLE); }
};

Mesh RepeatFaces(bool reversed)
{
  Parts parts(50);
  for (std::size_t t = 0; t < 1000; t += 20)
  {
    Corners again = parts.Triangles[t];
    reversed ? std::swap(again[1], again[2]) : void();
    parts.Triangles.push_back(again);
  }
  return parts.Make();
}

Mesh IsolatedVertices()
{
  Parts parts(50);
  parts.Places.insert(parts.Places.end(), 7, Place{ 5.0, 5.0, 5.0 });
  return parts.Make();
}

// Two grids side by side, one with twice as many rows: every other vertex of its border lies on an edge of the other.
Mesh TJunctions()
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int side = 0; side < 2; ++side)
  {
    const int rows = side == 0 ? 31 : 61;
    const auto first = static_cast<vtkIdType>(places.size());
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < 31; ++i)
      {
        places.push_back({ side + i / 30.0, j / (rows - 1.0), 0.05 * std::sin(9.0 * (side + i / 30.0)) });
      }
    }
    const auto more = MTTestMeshes::GridTriangles(31, rows, first);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  return MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
}

// Triangles whose three different corners lie on a line.
Mesh Slivers()
{
  Parts parts(40);
  for (int i = 0; i < 100; ++i)
  {
    const auto first = static_cast<vtkIdType>(parts.Places.size());
    const double y = 0.01 * i;
    parts.Places.insert(parts.Places.end(), { { 0.0, y, 0.5 }, { 0.5, y, 0.5 }, { 1.0, y, 0.5 } });
    parts.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return parts.Make();
}

Mesh RepeatedCorners()
{
  Parts parts(40);
  for (vtkIdType i = 0; i < 25; ++i)
  {
    parts.Triangles.push_back({ i, i + 1, i + 1 });
  }
  const auto first = static_cast<vtkIdType>(parts.Places.size());
  parts.Places.push_back(parts.Places[3]); // another point at the same place
  parts.Triangles.push_back({ 3, first, 9 });
  return parts.Make();
}

// Inner vertices, six triangles each, moved to no place at all.
Mesh MovedVertices(const std::vector<double>& coordinates)
{
  Parts parts(40);
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    parts.Places[410 + 5 * i][i % 3] = coordinates[i];
  }
  return parts.Make();
}

Mesh IndicesOutOfRange()
{
  Parts parts(40);
  for (vtkIdType i = 0; i < 10; ++i)
  {
    parts.Triangles.push_back({ i, i + 1, i % 2 ? vtkIdType(-1) : vtkIdType(1) << 40 });
  }
  return parts.Make();
}

Mesh EqualTriangles(int count, bool ownPoints)
{
  std::vector<Place> places;
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i)
  {
    const auto first = static_cast<vtkIdType>(places.size());
    if (ownPoints || i == 0)
    {
      places.insert(places.end(), { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.25 } });
    }
    const vtkIdType corner = ownPoints ? first : 0;
    triangles.push_back({ corner, corner + 1, corner + 2 });
  }
  return MTTestMeshes::Make(places, triangles);
}

// Regular polygons of 3 to 64 corners in a row.
Mesh ManyGons()
{
  std::vector<Place> places;
  vtkNew<vtkCellArray> polys;
  for (int n = 3; n <= 64; ++n)
  {
    polys->InsertNextCell(n);
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2.0 * M_PI * i / n;
      polys->InsertCellPoint(static_cast<vtkIdType>(places.size()));
      places.push_back({ 3.0 * n + std::cos(angle), std::sin(angle), 0.0 });
    }
  }
  Mesh mesh = MTTestMeshes::Make(places, {});
  mesh->SetPolys(polys);
  return mesh;
}

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Case
{
  const char* Name;
  std::function<Mesh()> Make;
  std::uint64_t Triangles; // of the input
  Report Expected;         // exactly
};

const std::vector<Case>& GetCases()
{
  using namespace MTTestMeshes;
  static const std::vector<Case> cases{
    // Six of the copies have an edge at the terrain's border: there, two triangles of one winding meet.
    { "DuplicateFaces", [] { return RepeatFaces(false); }, 4852, { { "reoriented_triangles", 6 } } },
    { "OppositeFaces", [] { return RepeatFaces(true); }, 4852, {} },
    { "IsolatedVertices", IsolatedVertices, 4802, { { "isolated_points", 7 } } },
    { "BowTies", [] { return BowTie(30, 4); }, 4 * 2 * 29 * 29, {} },
    { "Fins", [] { return Fin(40); }, 0, {} },
    { "TJunctions", TJunctions, 2 * 30 * 30 + 2 * 30 * 60, {} },
    { "ZeroAreaSlivers", Slivers, 3042 + 100, {} },
    { "RepeatedCorners", RepeatedCorners, 3042 + 26, { { "dropped_degenerate", 26 }, { "isolated_points", 1 } } },
    { "NanAndInf",
      [] {
        return MovedVertices({ NaN, Infinity, -Infinity, NaN });
      },
      3042, { { "dropped_not_finite", 24 }, { "isolated_points", 4 } } },
    { "AVertexAt1e38", [] { return MovedVertices({ 1e38 }); }, 3042,
      { { "dropped_far_outlier", 6 }, { "isolated_points", 1 } } },
    { "IndicesOutOfRange", IndicesOutOfRange, 3052, { { "dropped_index_out_of_range", 10 } } },
    { "CoincidentSheets", [] { return CoincidentSheets(40); }, 2 * 2 * 39 * 39, {} },
    { "HundredThousandDisconnected", [] { return RandomSoup(100000, 1, 0.01); }, 100000, {} },
    { "FortyThousandEqual", [] { return EqualTriangles(40000, false); }, 40000, {} },
    { "FortyThousandEqualWithOwnPoints", [] { return EqualTriangles(40000, true); }, 40000, {} },
    { "NGonsUpTo64Corners", ManyGons, 62 * 63 / 2, {} },
    { "TriangleStrips", [] { return Strips(40, 40); }, 3042, {} },
  };
  return cases;
}
}

class InTheWildMesh : public testing::TestWithParam<Case>
{
};

TEST_P(InTheWildMesh, IsASoundModelThatCountsWhatIsMissing)
{
  const Case& wild = GetParam();
  const Mesh mesh = wild.Make();
  Built built;
  Build(mesh, built);
  ASSERT_TRUE(built.IsGood) << built.Error;
  const std::uint64_t triangles = wild.Triangles > 0 ? wild.Triangles : mesh->GetNumberOfPolys();
  ExpectSound(wild.Name, built, mesh, triangles);
  EXPECT_EQ(built.GetGraph().InputReport, wild.Expected);
}

INSTANTIATE_TEST_SUITE_P(
  All, InTheWildMesh, testing::ValuesIn(GetCases()), [](const auto& info) { return std::string(info.param.Name); });

TEST(InTheWild, MeshesWithoutAUsableTriangleAreRefusedWithTheReason)
{
  const std::vector<std::pair<Mesh, const char*>> refused = {
    { MTTestMeshes::Make({}, {}), "no triangles" },
    { MTTestMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 } }, {}), "no triangles" },
    { MTTestMeshes::OnlyDegenerate(20), "none of the input's 20 triangles is usable" },
    { MTTestMeshes::Make({ { NaN, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }), "not finite" },
  };
  for (const auto& [mesh, reason] : refused)
  {
    Built built;
    Build(mesh, built);
    EXPECT_FALSE(built.IsGood);
    EXPECT_NE(built.Error.find(reason), std::string::npos) << built.Error;
  }
}

//------------------------------------------------------------------------------
namespace
{
// Small spheres on a wide grid: a component that is missing from a cut leaves the cut at least this far away.
struct Components
{
  Mesh All;
  std::vector<int> OfTriangle;
  std::vector<double> DistanceToOthers;
};

Components MakeComponents(int side)
{
  const Mesh sphere = MTTestMeshes::FractalSphere(1);
  std::vector<Place> places;
  std::vector<Corners> triangles;
  Components result;
  MTTestMeshes::Random random(5);
  for (int c = 0; c < side * side; ++c)
  {
    const double radius = std::pow(10.0, random.Uniform(-3.0, 0.0));
    const auto first = static_cast<vtkIdType>(places.size());
    for (vtkIdType p = 0; p < sphere->GetNumberOfPoints(); ++p)
    {
      const double* x = sphere->GetPoint(p);
      places.push_back({ 10.0 * (c % side) + radius * x[0], 10.0 * (c / side) + radius * x[1], radius * x[2] });
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType t = 0; t < sphere->GetNumberOfPolys(); ++t)
    {
      sphere->GetCellPoints(t, corners);
      triangles.push_back({ first + corners->GetId(0), first + corners->GetId(1), first + corners->GetId(2) });
      result.OfTriangle.push_back(c);
    }
    result.DistanceToOthers.push_back(10.0 - 1.5 - 1.5 * radius);
  }
  result.All = MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
  return result;
}

std::vector<unsigned char> FindPresent(const Built& built, const vtkMTCut& cut, const Components& components)
{
  const vtkMTGraph& graph = built.GetGraph();
  std::size_t column = 0;
  for (const vtkMTArrayInfo& info : graph.Arrays)
  {
    if (info.Role == vtkMTArrayInfo::InputCellIds)
    {
      break;
    }
    column += info.Association == vtkMTArrayInfo::Cell ? 1 : 0;
  }
  std::vector<unsigned char> present(components.DistanceToOthers.size(), 0);
  for (std::uint32_t arc : cut.GetArcs())
  {
    vtkMTPatch patch;
    std::string error;
    EXPECT_TRUE(built.Store.ReadPatch(arc, nullptr, patch, error)) << error;
    for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
    {
      vtkIdType id = 0;
      std::memcpy(&id, patch.CellColumns[column].data() + t * sizeof(id), sizeof(id));
      present[static_cast<std::size_t>(components.OfTriangle[static_cast<std::size_t>(id)])] = 1;
    }
  }
  return present;
}
}

TEST(InTheWild, ComponentsVanishOnlyBelowTheStoredError)
{
  const Components components = MakeComponents(24);
  Built built;
  Build(components.All, built);
  ASSERT_TRUE(built.IsGood) << built.Error;
  ExpectSound("small components", built, components.All, components.OfTriangle.size());
  std::size_t vanished = 0;
  std::size_t cuts = 0;
  for (; cuts < 40; ++cuts)
  {
    const vtkMTCut cut =
      cuts == 0 ? vtkMTCut(built.GetGraph()) : vtkMTRandomCut::Make(built.GetGraph(), 2, cuts); // the coarsest first
    const std::vector<unsigned char> present = FindPresent(built, cut, components);
    for (std::size_t c = 0; c < present.size(); ++c)
    {
      vanished += present[c] ? 0 : 1;
      EXPECT_TRUE(present[c] || cut.GetError() >= components.DistanceToOthers[c])
        << "component " << c << " is missing in cut " << cuts << " of error " << cut.GetError();
    }
  }
  std::printf("%zu components in %zu cuts: %zu missing, coarsest error %g\n", components.DistanceToOthers.size(), cuts,
    vanished, vtkMTCut(built.GetGraph()).GetError());
}

//------------------------------------------------------------------------------
TEST(InTheWild, EveryFileOfTheDataFolderIsASoundModelOrARefusal)
{
  const char* variable = std::getenv("MT_TEST_DATA");
  const std::filesystem::path folder =
    std::filesystem::path(variable ? variable : MT_SOURCE_DIRECTORY "/../shared/data") / "extreme";
  if (!std::filesystem::is_directory(folder))
  {
    GTEST_SKIP() << folder << " is not there";
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files)
  {
    vtkNew<vtkPolyData> mesh;
    Built built;
    try
    {
      bmtReadInput(bmtInput(file.string()), mesh);
      Build(mesh, built);
    }
    catch (const bmtError& error)
    {
      built.Error = error.what();
      EXPECT_NE(built.Error.find(file.filename().string()), std::string::npos) << built.Error;
    }
    if (built.IsGood)
    {
      vtkMTPolyDataStream stream(mesh);
      ExpectSound(file.filename().string(), built, mesh, stream.GetNumberOfTriangles());
    }
    else
    {
      EXPECT_GT(built.Error.size(), 20u) << file;
      std::printf("%-28s refused: %s\n", file.filename().c_str(), built.Error.c_str());
    }
  }
}
