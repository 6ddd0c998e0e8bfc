// SPDX-License-Identifier: BSD-3-Clause
// The construction in spools: the result does not depend on memory, and every failure is reported.
#include "MTFaultyStore.h"
#include "MTTestMeshes.h"

#include "vtkMTBuildSettings.h"
#include "vtkMTEdgeCollapse.h"
#include "vtkMTInputMesh.h"
#include "vtkMTLevelLoop.h"
#include "vtkMTMemoryPlan.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSequenceState.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace
{
struct Model
{
  vtkMTPatchStore Patches;
  vtkMTMemorySpoolStore Spools;
  MTFaultyStore Elsewhere{ Spools }; // does not say that it is in memory; nothing fails
  std::string Error;
  bool Built = false;

  Model(vtkPolyData* mesh, std::size_t sortMemory, int threads, bool isInMemory)
  {
    const vtkNew<vtkMTVoronoiPartition> partition;
    const vtkNew<vtkMTEdgeCollapse> simplifier;
    vtkMTBuildSettings settings;
    settings.PatchTriangles = 100;
    settings.Partition = partition;
    settings.Simplifier = simplifier;
    settings.Threads = threads;
    settings.SortMemory = sortMemory;
    settings.Store = isInMemory ? static_cast<vtkMTSpoolStore*>(&this->Spools) : &this->Elsewhere;
    vtkMTPolyDataStream stream(mesh);
    vtkMTSequenceState state;
    vtkMTInputMesh input(settings);
    vtkMTLevelLoop loop(settings, this->Patches, "");
    this->Built = input.Read(stream, state) && this->Patches.Begin(state.Graph.Arrays) && loop.Run(state);
    this->Error = input.GetError() + loop.GetError();
  }
};

// A triangle far away in front of all others, and one behind.
vtkSmartPointer<vtkPolyData> WithOutliers(vtkPolyData* mesh)
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  const auto addFar = [&](double place)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    points->InsertNextPoint(place, 0.0, 0.0);
    points->InsertNextPoint(place + 1.0, 0.0, 0.0);
    points->InsertNextPoint(place, 1.0, 0.0);
    const vtkIdType ids[3] = { first, first + 1, first + 2 };
    cells->InsertNextCell(3, ids);
  };
  addFar(1e12);
  const vtkIdType offset = points->GetNumberOfPoints();
  points->InsertPoints(offset, mesh->GetNumberOfPoints(), 0, mesh->GetPoints());
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    vtkIdType count;
    const vtkIdType* ids;
    mesh->GetCellPoints(c, count, ids);
    const vtkIdType moved[3] = { ids[0] + offset, ids[1] + offset, ids[2] + offset };
    cells->InsertNextCell(3, moved);
  }
  addFar(-1e12);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  return result;
}

void ExpectSame(const vtkMTPatchStore& a, const vtkMTPatchStore& b, const char* name)
{
  ASSERT_EQ(a.GetGraph().Arcs.size(), b.GetGraph().Arcs.size()) << name;
  ASSERT_EQ(a.GetGraph().Nodes.size(), b.GetGraph().Nodes.size()) << name;
  EXPECT_EQ(a.GetGraph().InputReport, b.GetGraph().InputReport) << name;
  for (std::size_t n = 0; n < a.GetGraph().Nodes.size(); ++n)
  {
    EXPECT_EQ(a.GetGraph().Nodes[n].Error, b.GetGraph().Nodes[n].Error) << name << ", node " << n;
  }
  std::vector<unsigned char> bytesOfA;
  std::vector<unsigned char> bytesOfB;
  for (std::uint32_t arc = 0; arc < a.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    ASSERT_TRUE(a.ReadPatch(arc, nullptr, patch, error));
    vtkMTPatchRecord::Encode(patch, bytesOfA);
    ASSERT_TRUE(b.ReadPatch(arc, nullptr, patch, error));
    vtkMTPatchRecord::Encode(patch, bytesOfB);
    ASSERT_EQ(bytesOfA, bytesOfB) << name << ", arc " << arc;
  }
}
}

TEST(OutOfCore, ModelDoesNotDependOnMemoryOrThreads)
{
  using namespace MTTestMeshes;
  const std::pair<const char*, vtkSmartPointer<vtkPolyData>> meshes[] = { { "fractal sphere", FractalSphere(6) },
    { "sphere as soup", SphereSoup(6) }, { "random soup", RandomSoup(20000) }, { "seam", SeamSphere(200, 150) },
    { "dirty", Dirty(100, 20) }, { "outliers", WithOutliers(FractalSphere(5)) } };
  for (const auto& [name, mesh] : meshes)
  {
    AddArrays(mesh);
    const Model much(mesh, std::size_t(1) << 30, 1, false);
    const Model little(mesh, 0, 3, false); // each sort gets its minimum
    const Model inMemory(mesh, std::size_t(1) << 30, 2, true);
    ASSERT_TRUE(much.Built && little.Built && inMemory.Built) << name << ": " << much.Error << little.Error;
    ExpectSame(much.Patches, little.Patches, name);
    ExpectSame(much.Patches, inMemory.Patches, name);
    for (const auto& [reason, count] : inMemory.Patches.GetGraph().InputReport)
    {
      std::printf("  %s %lld\n", reason.c_str(), static_cast<long long>(count));
    }
    std::printf("%-16s %9llu bytes spooled with much memory, %9llu with little, %9llu in memory\n", name,
      static_cast<unsigned long long>(much.Spools.GetLargestSize()),
      static_cast<unsigned long long>(little.Spools.GetLargestSize()),
      static_cast<unsigned long long>(inMemory.Spools.GetLargestSize()));
    EXPECT_LT(inMemory.Spools.GetLargestSize(), much.Spools.GetLargestSize()) << name;
    EXPECT_GT(little.Spools.GetLargestSize(), much.Spools.GetLargestSize()) << name << ": nothing was spilled";
  }
}

TEST(OutOfCore, EveryFailedWriteOrReadIsAnErrorAndNothingIsPublished)
{
  const auto mesh = MTTestMeshes::SphereSoup(3);
  std::uint64_t writes = 1;
  std::uint64_t reads = 0;
  std::size_t runs = 0;
  for (std::uint64_t i = 0; i <= writes + reads; ++i, ++runs)
  {
    vtkMTMemorySpoolStore memory;
    const auto store = std::make_shared<MTFaultyStore>(memory);
    if (i > 0)
    {
      (i <= writes ? store->FailingWrite : store->FailingRead) = i <= writes ? i - 1 : i - writes - 1;
    }
    vtkMTPatchStore patches;
    vtkNew<vtkMultiTriangulationBuilder> builder;
    builder->SetPatchTriangles(100);
    builder->SetNumberOfThreads(2);
    builder->SetSpoolStore(store);
    vtkMTPolyDataStream stream(mesh);
    EXPECT_EQ(builder->Build(stream, patches), i == 0);
    if (i == 0)
    {
      writes = store->GetNumberOfWrites();
      reads = store->GetNumberOfReads();
      continue;
    }
    EXPECT_NE(builder->GetErrorMessage().find("planned failure"), std::string::npos)
      << i << ": " << builder->GetErrorMessage();
    EXPECT_TRUE(patches.GetGraph().IsEmpty());
  }
  std::printf("%zu builds: %llu writes, %llu reads\n", runs, static_cast<unsigned long long>(writes),
    static_cast<unsigned long long>(reads));
}

TEST(OutOfCore, LimitThatIsTooSmallSaysTheLeastThatWouldDo)
{
  const auto mesh = MTTestMeshes::FractalSphere(5);
  vtkMTPolyDataStream stream(mesh);
  vtkMTPatchStore patches;
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetMemoryLimit(1 << 20);
  EXPECT_FALSE(builder->Build(stream, patches));
  const std::uint64_t least = builder->MakeMemoryPlan(stream).GetLeast();
  EXPECT_NE(builder->GetErrorMessage().find(vtkMTMemoryPlan::ToText(least)), std::string::npos)
    << builder->GetErrorMessage();
  builder->SetMemoryLimit(static_cast<vtkTypeInt64>(least));
  EXPECT_TRUE(builder->Build(stream, patches)) << builder->GetErrorMessage();
}

namespace
{
// As a damaged file may: says that it has many more points than it has.
class Boaster : public vtkMTPolyDataStream
{
public:
  using vtkMTPolyDataStream::vtkMTPolyDataStream;
  std::uint64_t GetNumberOfPoints() const override { return ~std::uint64_t(0); }
};
}

TEST(OutOfCore, PlanForImpossibleCountsIsFinite)
{
  Boaster stream(MTTestMeshes::FractalSphere(2));
  const vtkNew<vtkMultiTriangulationBuilder> builder;
  const vtkMTMemoryPlan plan = builder->MakeMemoryPlan(stream);
  EXPECT_EQ(plan.GetSpoolSize(), std::uint64_t(1) << 60);
  EXPECT_LE(plan.GetLeast(), std::uint64_t(1) << 60);
  EXPECT_EQ(plan.GetSortMemory(0), std::uint64_t(1) << 60);
}

namespace
{
// Triangles whose barycentres are one point: no partition can take them apart.
vtkSmartPointer<vtkPolyData> MakeInseparable(int triangles)
{
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  for (int i = 0; i < triangles; ++i)
  {
    const double angle = 3.0 * i / triangles;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const vtkIdType first = points->InsertNextPoint(x, y, 1e-4 * i);
    points->InsertNextPoint(-0.5 * x - 0.01 * y, -0.5 * y + 0.01 * x, -0.5e-4 * i);
    points->InsertNextPoint(-0.5 * x + 0.01 * y, -0.5 * y - 0.01 * x, -0.5e-4 * i);
    cells->InsertNextCell({ first, first + 1, first + 2 });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

bool BuildWithin(vtkPolyData* mesh, std::uint64_t limit, vtkMTPatchStore& patches, std::string& error)
{
  vtkMTPolyDataStream stream(mesh);
  const vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(16);
  builder->SetNumberOfThreads(2);
  builder->SetMemoryLimit(static_cast<vtkTypeInt64>(limit));
  const bool built = builder->Build(stream, patches);
  error = builder->GetErrorMessage();
  return built;
}
}

TEST(OutOfCore, RegionThatIsTooLargeForTheLimitSaysHowMuchIsMissing)
{
  const auto mesh = MakeInseparable(60000);
  vtkMTPolyDataStream stream(mesh);
  const vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(16);
  builder->SetNumberOfThreads(2);
  const std::uint64_t least = builder->MakeMemoryPlan(stream).GetLeast();
  vtkMTPatchStore patches;
  std::string error;
  ASSERT_FALSE(BuildWithin(mesh, least, patches, error));
  const std::string advice = "raise the limit by ";
  const std::size_t place = error.find(advice);
  ASSERT_NE(place, std::string::npos) << error;
  const double missing = std::stod(error.substr(place + advice.size()));
  std::printf("least %s; %s\n", vtkMTMemoryPlan::ToText(least).c_str(), error.c_str());
  vtkMTPatchStore more;
  EXPECT_TRUE(BuildWithin(mesh, least + static_cast<std::uint64_t>(missing * 1048576.0), more, error)) << error;
  vtkMTPatchStore whole;
  ASSERT_TRUE(BuildWithin(mesh, 0, whole, error)) << error;
  ExpectSame(more, whole, "inseparable");
}
