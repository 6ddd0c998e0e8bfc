// SPDX-License-Identifier: BSD-3-Clause
// The small glTF files after reports of other tools, where they are there.
#include "MTGltfScene.h"

#include "vtkMTMeshReader.h"
#include "vtkMTTextureCollector.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

using namespace MTIOTest;

namespace
{
std::filesystem::path FindReports()
{
  const std::string data = GetDataFolder();
  const std::filesystem::path folder = std::filesystem::path(data).parent_path() / "reports";
  return !data.empty() && std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

MTGltfMesh ReadReport(const std::string& name)
{
  MTGltfMesh result;
  vtkMTMeshReader::Read((FindReports() / name).string(), result.Mesh, result.Error, &result.Counts);
  return result;
}

std::size_t CountTextureProblems(const std::string& name)
{
  const MTGltfMesh read = ReadReport(name);
  vtkMTTextureCollector collector;
  collector.Collect((FindReports() / name).string(), read.Mesh);
  return collector.GetProblems().size();
}
}

TEST(GltfReports, EveryFileHasItsRightValue)
{
  if (FindReports().empty())
  {
    GTEST_SKIP() << "the reports are not there: a folder reports beside the test data";
  }
  const std::vector<std::pair<std::string, std::string>> refused = { { "g_missingbin.gltf", "not_there.bin" },
    { "g_meshopt_like.gltf", "EXT_meshopt_compression" }, { "g_recursive.gltf", "cycle" } };
  for (const auto& [name, reason] : refused)
  {
    EXPECT_NE(ReadReport(name).Error.find(reason), std::string::npos) << name << ReadReport(name).Error;
  }
  const std::vector<std::pair<std::string, int>> triangles = { { "dir with spaces/cube.gltf", 12 },
    { "g_sparse.glb", 12 }, { "g_quant_u16.glb", 12 }, { "g_instancing.glb", 36 }, { "g_textransform.glb", 12 },
    { "g_mirror.glb", 12 }, { "g_mixed.glb", 24 }, { "g_matcolor.glb", 24 }, { "g_col_u8.glb", 12 },
    { "g_missingimage.glb", 12 }, { "g_missingnormalmap.glb", 12 }, { "g_ktx2.glb", 12 } };
  for (const auto& [name, count] : triangles)
  {
    const MTGltfMesh read = ReadReport(name);
    EXPECT_EQ(read.Error, "") << name;
    EXPECT_EQ(read.Mesh->GetNumberOfPolys(), count) << name;
    EXPECT_NEAR(read.GetVolume(), name == "g_sparse.glb" ? read.GetVolume() : count / 12.0, 1e-5) << name;
  }
  EXPECT_EQ(ReadReport("g_sparse.glb").GetBounds()[5], 5.0);
  EXPECT_NEAR(ReadReport("g_quant_u16.glb").GetBounds()[5], 1.0, 1e-6);
  EXPECT_EQ(ReadReport("g_mixed.glb").Counts.at("united_arrays_filled"), 2);
  EXPECT_EQ(ReadReport("g_matcolor.glb").GetCellValues("BaseColor")[0], 255.0);
  EXPECT_EQ(ReadReport("g_matcolor.glb").GetCellValues("MaterialIds")[23], 1.0);
  const std::vector<double> colors = ReadReport("g_col_u8.glb").GetValues("COLOR_0");
  EXPECT_EQ(std::vector<double>(colors.begin(), colors.begin() + 4), (std::vector<double>{ 255, 127, 0, 255 }));
  for (const char* name : { "g_missingimage.glb", "g_missingnormalmap.glb", "g_ktx2.glb" })
  {
    EXPECT_EQ(CountTextureProblems(name), 1u) << name;
  }
}
