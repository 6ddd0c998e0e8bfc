// SPDX-License-Identifier: BSD-3-Clause
// What the tests of IO share: a folder for each test, whole files as bytes, child processes, comparison of models.
#ifndef MTIOTest_h
#define MTIOTest_h

#include "vtkMTGraph.h"
#include "vtkMTPatchOrder.h"
#include "vtkMTPatchSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace MTIOTest
{
using Bytes = std::vector<unsigned char>;

//------------------------------------------------------------------------------
/// An empty folder of the running test's own, gone at the end.
class Folder
{
public:
  Folder()
  {
    static int count = 0;
    const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
    this->Path = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) /
      ("IO-" + std::string(info->test_suite_name()) + "-" + info->name() + "-" + std::to_string(::getpid()) + "-" +
        std::to_string(count++));
    std::filesystem::remove_all(this->Path);
    std::filesystem::create_directories(this->Path);
  }
  ~Folder() { std::filesystem::remove_all(this->Path); }
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }
  std::vector<std::string> List() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(this->Path))
    {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  std::filesystem::path Path;
};

//------------------------------------------------------------------------------
inline Bytes ReadFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

inline void WriteFile(const std::string& path, const Bytes& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline void WriteFile(const std::string& path, const std::string& text)
{
  WriteFile(path, Bytes(text.begin(), text.end()));
}

//------------------------------------------------------------------------------
// Sanitizers keep memory that was freed, so what a process holds says nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool IsSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool IsSanitized = true;
#else
constexpr bool IsSanitized = false;
#endif
#else
constexpr bool IsSanitized = false;
#endif

//------------------------------------------------------------------------------
struct ChildResult
{
  bool Crashed = false;
  int ExitCode = 0;
};

/// Runs body in a child process, whose exit code is what body gives.
inline ChildResult RunInChild(const std::function<int()>& body)
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
/// The folder of real meshes, or empty when it is not there.
inline std::string GetDataFolder()
{
  const char* variable = std::getenv("MT_TEST_DATA");
  const std::string folder = variable ? variable : std::string(MT_SOURCE_DIRECTORY) + "/../shared/data";
  return std::filesystem::is_directory(folder) ? folder : "";
}

//------------------------------------------------------------------------------
inline bool AreEqual(const vtkMTPatch& a, const vtkMTPatch& b)
{
  return a.Points == b.Points && a.Ids == b.Ids && a.WedgePoints == b.WedgePoints && a.Triangles == b.Triangles &&
    a.PointColumns == b.PointColumns && a.CellColumns == b.CellColumns;
}

inline bool AreEqual(const vtkMTNode& a, const vtkMTNode& b)
{
  return a.Error == b.Error && a.OwnError == b.OwnError && a.EdgeLength == b.EdgeLength && a.Center == b.Center &&
    a.Radius == b.Radius && a.FirstOut == b.FirstOut && a.OutCount == b.OutCount && a.FirstIn == b.FirstIn &&
    a.InCount == b.InCount && a.Level == b.Level && a.Region == b.Region;
}

inline bool AreEqual(const vtkMTArc& a, const vtkMTArc& b)
{
  return a.From == b.From && a.To == b.To && a.Triangles == b.Triangles && a.Points == b.Points &&
    a.Wedges == b.Wedges && a.SharedPoints == b.SharedPoints && a.Box == b.Box && a.ConeAxis == b.ConeAxis &&
    a.ConeCosine == b.ConeCosine && a.MeanEdgeLength == b.MeanEdgeLength && a.Kind == b.Kind;
}

template <typename Item>
bool AreAllEqual(const std::vector<Item>& a, const std::vector<Item>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(), [](const Item& x, const Item& y) { return AreEqual(x, y); });
}

inline void ExpectEqual(const vtkMTGraph& a, const vtkMTGraph& b)
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

/// Graph and all patches, byte for byte, where b was made of a by storing it.
inline void ExpectStored(const vtkMTPatchSource& a, const vtkMTPatchSource& b)
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

#endif
