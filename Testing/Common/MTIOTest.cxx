// SPDX-License-Identifier: BSD-3-Clause
#include "MTIOTest.h"

#include "vtkMTFileSink.h"

#include "vtkMTPatchOrder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <sys/wait.h>
#include <unistd.h>

namespace MTIOTest
{
//------------------------------------------------------------------------------
Folder::Folder()
{
  static int count = 0;
  const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
  this->Path = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) /
    ("IO-" + std::string(info->test_suite_name()) + "-" + info->name() + "-" + std::to_string(::getpid()) + "-" +
      std::to_string(count++));
  std::filesystem::remove_all(this->Path);
  std::filesystem::create_directories(this->Path);
}

//------------------------------------------------------------------------------
Folder::~Folder()
{
  std::filesystem::remove_all(this->Path);
}

//------------------------------------------------------------------------------
std::vector<std::string> Folder::List() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(this->Path))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

//------------------------------------------------------------------------------
Bytes ReadFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

//------------------------------------------------------------------------------
void WriteFile(const std::string& path, const Bytes& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

//------------------------------------------------------------------------------
void WriteFile(const std::string& path, const std::string& text)
{
  WriteFile(path, Bytes(text.begin(), text.end()));
}

//------------------------------------------------------------------------------
ChildResult RunInChild(const std::function<int()>& body)
{
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0)
  {
    ::_exit(body());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ChildResult result;
  result.Crashed = !WIFEXITED(status);
  result.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

//------------------------------------------------------------------------------
std::string GetDataFolder()
{
  const char* variable = std::getenv("MT_TEST_DATA");
  const std::string folder = variable ? variable : std::string(MT_SOURCE_DIRECTORY) + "/../shared/data";
  return std::filesystem::is_directory(folder) ? folder : "";
}

//------------------------------------------------------------------------------
bool AreEqual(const vtkMTPatch& a, const vtkMTPatch& b)
{
  return a.Points == b.Points && a.Ids == b.Ids && a.WedgePoints == b.WedgePoints && a.Triangles == b.Triangles &&
    a.PointColumns == b.PointColumns && a.CellColumns == b.CellColumns;
}

//------------------------------------------------------------------------------
bool AreEqual(const vtkMTNode& a, const vtkMTNode& b)
{
  return a.Error == b.Error && a.OwnError == b.OwnError && a.EdgeLength == b.EdgeLength && a.Center == b.Center &&
    a.Radius == b.Radius && a.FirstOut == b.FirstOut && a.OutCount == b.OutCount && a.FirstIn == b.FirstIn &&
    a.InCount == b.InCount && a.Level == b.Level && a.Region == b.Region;
}

//------------------------------------------------------------------------------
bool AreEqual(const vtkMTArc& a, const vtkMTArc& b)
{
  return a.From == b.From && a.To == b.To && a.Triangles == b.Triangles && a.Points == b.Points &&
    a.Wedges == b.Wedges && a.SharedPoints == b.SharedPoints && a.Box == b.Box && a.ConeAxis == b.ConeAxis &&
    a.ConeCosine == b.ConeCosine && a.MeanEdgeLength == b.MeanEdgeLength && a.Kind == b.Kind;
}

//------------------------------------------------------------------------------
void ExpectEqual(const vtkMTGraph& a, const vtkMTGraph& b)
{
  EXPECT_EQ(a.Lattice.Step, b.Lattice.Step);
  EXPECT_EQ(a.Lattice.Origin, b.Lattice.Origin);
  EXPECT_EQ(a.Lattice.MaximumShift, b.Lattice.MaximumShift);
  EXPECT_TRUE(AreAllEqual(a.Nodes, b.Nodes));
  EXPECT_TRUE(AreAllEqual(a.Arcs, b.Arcs));
  EXPECT_EQ(a.Entering, b.Entering);
  EXPECT_TRUE(a.Arrays == b.Arrays);
  EXPECT_EQ(a.Refinement, b.Refinement);
  EXPECT_EQ(a.ArrayRanges, b.ArrayRanges);
  EXPECT_EQ(a.Frame, b.Frame);
  EXPECT_EQ(a.Crs, b.Crs);
  EXPECT_EQ(a.Units, b.Units);
  ASSERT_EQ(a.Measures.size(), b.Measures.size());
  for (std::size_t i = 0; i < a.Measures.size(); ++i)
  {
    EXPECT_EQ(a.Measures[i].Name, b.Measures[i].Name);
    EXPECT_EQ(a.Measures[i].Values, b.Measures[i].Values);
  }
  EXPECT_EQ(a.InputCounts.Triangles, b.InputCounts.Triangles);
  EXPECT_EQ(a.InputCounts.Points, b.InputCounts.Points);
  EXPECT_EQ(a.InputCounts.Samples, b.InputCounts.Samples);
  EXPECT_EQ(a.InputCounts.Cells, b.InputCounts.Cells);
  EXPECT_TRUE(a.GetFigures() == b.GetFigures());
  EXPECT_EQ(a.Settings, b.Settings);
  EXPECT_EQ(a.InputReport, b.InputReport);
  EXPECT_EQ(a.Blocked, b.Blocked);
  EXPECT_EQ(a.FullySharedBorders, b.FullySharedBorders);
}

//------------------------------------------------------------------------------
Bytes StoreModel(const vtkMTPatchSource& model)
{
  const Folder folder;
  const std::string path = folder / "model.bmt";
  vtkMTFileSink sink(path);
  const vtkMTGraph& graph = model.GetGraph();
  std::string error;
  bool done = sink.Begin(graph.Arrays);
  std::vector<std::uint32_t> order;
  for (std::uint32_t arc = 0; done && arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    done = model.ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
    order.push_back(arc);
  }
  EXPECT_TRUE(done && sink.Finish(graph, order)) << sink.GetError() << error;
  return ReadFile(path);
}

//------------------------------------------------------------------------------
void ExpectStored(const vtkMTPatchSource& a, const vtkMTPatchSource& b)
{
  ExpectEqual(a.GetGraph(), b.GetGraph());
  ASSERT_EQ(a.GetGraph().Arcs.size(), b.GetGraph().Arcs.size());
  for (std::uint32_t arc = 0; arc < a.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patches[2];
    std::string error;
    ASSERT_TRUE(a.ReadPatch(arc, nullptr, patches[0], error)) << error;
    ASSERT_TRUE(b.ReadPatch(arc, nullptr, patches[1], error)) << error;
    EXPECT_TRUE(AreEqual(vtkMTPatchOrder::Make(patches[0]).Patch, patches[1])) << "patch " << arc;
  }
}
}
