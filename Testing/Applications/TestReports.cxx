// SPDX-License-Identifier: BSD-3-Clause
// The small inputs after public reports of other tools, where they are there: built, held against their inputs and cut
// by the command, as its users do; what came out beside what is right, as a table.
#include "MTIOTest.h"
#include "MTRunBmt.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace
{
// What is right of one input. What is not given is not asked.
struct Right
{
  std::vector<std::string> Inputs;
  std::vector<std::string> Options;
  std::string Refusal; ///< what the refusal names; empty: it is read
  std::int64_t Triangles = -1;
  std::vector<double> Bounds;
  double Volume = NAN;
  double Area = NAN;
  std::string Count;                    ///< a figure of the input report that is not 0
  std::size_t TextureProblems = 0;      ///< that the build lists
  std::string Array;                    ///< an array of the cut ...
  std::set<std::vector<double>> Values; ///< ... all values that it has ...
  std::set<std::string> Names;          ///< ... and what they are called
  int Components = 0;                   ///< parts that are connected
};

constexpr double CubeArea = 6.0;
const std::vector<double> UnitCube{ 0, 1, 0, 1, 0, 1 };

Right Cube(const std::string& input)
{
  Right right;
  right.Inputs = { input };
  right.Triangles = 12;
  right.Bounds = UnitCube;
  right.Volume = 1.0;
  right.Area = CubeArea;
  return right;
}

Right Counted(const std::string& input, const std::string& count)
{
  Right right = Cube(input);
  right.Count = count;
  return right;
}

Right CubeWith(const std::string& input, const std::string& array, const std::set<std::vector<double>>& values)
{
  Right right = Cube(input);
  right.Array = array;
  right.Values = values;
  return right;
}

Right Refused(const std::string& input, const std::string& reason)
{
  Right right;
  right.Inputs = { input };
  right.Refusal = reason;
  return right;
}

Right Isosurface(const std::string& input, const std::vector<double>& bounds, const std::string& value = "50")
{
  Right right;
  right.Inputs = { input };
  right.Options = { "--iso", value };
  right.Bounds = bounds;
  return right;
}

Right Textured(const std::string& input, int problems)
{
  Right right = Cube(input);
  right.TextureProblems = problems;
  return right;
}

std::vector<Right> GetGltf()
{
  Right sparse = Cube("g_sparse.glb");
  sparse.Bounds = { 0, 1, 0, 1, 0, 5 };
  sparse.Volume = sparse.Area = NAN;
  Right mirror = Cube("g_mirror.glb");
  mirror.Bounds = { -1, 0, 0, 1, 0, 1 };
  Right instances = Cube("g_instancing.glb");
  instances.Triangles = 36;
  instances.Bounds = {};
  instances.Volume = 3.0;
  instances.Area = 3.0 * CubeArea;
  Right mixed = CubeWith("g_mixed.glb", "COLOR_0", { { 255, 0, 0, 255 }, { 0, 0, 255, 255 } });
  mixed.Count = "united_arrays_filled";
  Right materials = CubeWith("g_matcolor.glb", "BaseColor", { { 255, 0, 0 }, { 0, 0, 255 } });
  for (Right* const two : { &mixed, &materials })
  {
    two->Triangles = 24;
    two->Bounds = {};
    two->Volume = 2.0;
    two->Area = 2.0 * CubeArea;
  }
  return { Refused("g_missingbin.gltf", "not_there.bin"), Cube("dir with spaces/cube.gltf"),
    Refused("g_meshopt_like.gltf", "EXT_meshopt_compression"), Refused("g_recursive.gltf", "cycle"), sparse,
    Cube("g_quant_u16.glb"), instances,
    CubeWith("g_textransform.glb", "TEXCOORD_0", { { 0.5, -1 }, { 0.5, 1 }, { 2.5, -1 }, { 2.5, 1 } }), mirror, mixed,
    materials, CubeWith("g_col_u8.glb", "COLOR_0", { { 255, 127, 0, 255 } }), Textured("g_missingimage.glb", 1),
    Textured("g_missingnormalmap.glb", 1), Textured("g_ktx2.glb", 1) };
}

std::vector<Right> GetText()
{
  Right keyhole = Cube("o_keyhole.obj");
  keyhole.Triangles = 8;
  keyhole.Bounds = { 0, 4, 0, 4, 0, 0 };
  keyhole.Volume = 0.0;
  keyhole.Area = 12.0;
  Right partly = CubeWith("o_partcolor.obj", "RGB", { { 1, 0, 0 }, { 1, 1, 1 } });
  partly.Count = "filled_colors";
  partly.Triangles = 24;
  partly.Bounds = {};
  partly.Volume = 2.0;
  partly.Area = 2.0 * CubeArea;
  Right groups = CubeWith("o_groupnames.obj", "GroupIds", { { 0 }, { 1 } });
  groups.Names = { "inlet", "walls" };
  Right solids = CubeWith("s_twosolids.stl", "SolidIds", { { 0 }, { 1 } });
  solids.Names = groups.Names;
  return { keyhole, Cube("o_bom.obj"), Cube("o_bom_shift.obj"), Cube("s_bom.stl"), partly, groups,
    Counted("o_missingvn.obj", "missing_normals"), Counted("o_twocorner.obj", "degenerate_cells"),
    Textured("o_mtllib2.obj", 1), Counted("o_nanind.obj", "not_finite_vertices"),
    CubeWith("p_diffuse.ply", "RGB", { { 255, 128, 0 } }), Counted("p_headerjunk.ply", "ignored_header_lines"),
    CubeWith("s_viscam.stl", "RGB", { { 255, 0, 0 }, { 0, 0, 255 } }), solids,
    Counted("s_endloop.stl", "split_keywords"), Counted("s_count0.stl", "wrong_triangle_count") };
}

std::vector<Right> GetImages()
{
  Right left = Isosurface("i_left.vti", {});
  left.Volume = 3053;
  Right terrain;
  terrain.Inputs = { "t_left.tif", "t_right.tif" };
  terrain.Triangles = 4582;
  terrain.Components = 1;
  Right labels;
  labels.Inputs = { "v_labels.vtp" };
  labels.Triangles = 1500;
  labels.Array = "LabelU8";
  labels.Values = { { 7 }, { 200 } };
  return { left, Isosurface("i_plain.mhd", { 13, 23, 28, 48, 36, 66 }),
    Isosurface("i_rot.mhd", { -18, 2, 23, 33, 36, 66 }), Isosurface("i_flip.mhd", { -3, 7, -8, 12, 36, 66 }),
    Isosurface("i_q.nii", { 13, 23, 28, 48, 36, 66 }), Isosurface("i_s.nii", { -3, 7, 28, 48, 36, 66 }),
    Isosurface("i_slope.nii", {}, "-850"), terrain, labels };
}

// The place, size and orientation of a mesh.
struct Figures
{
  std::int64_t Triangles = 0;
  double Volume = 0.0;
  double Area = 0.0;
};

Figures Measure(vtkPolyData* mesh)
{
  Figures figures;
  const auto cells = mesh->GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(size, ids);)
  {
    std::array<double, 9> p{};
    for (int c = 0; c < 3; ++c)
    {
      mesh->GetPoint(ids[c], p.data() + 3 * c);
    }
    const double u[3] = { p[3] - p[0], p[4] - p[1], p[5] - p[2] };
    const double v[3] = { p[6] - p[0], p[7] - p[1], p[8] - p[2] };
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
    figures.Volume += (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / 6.0;
    figures.Area += 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    ++figures.Triangles;
  }
  return figures;
}

std::set<std::vector<double>> GetValues(vtkPolyData* mesh, const std::string& name)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name.c_str());
  array = array ? array : mesh->GetCellData()->GetArray(name.c_str());
  std::set<std::vector<double>> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    const double* const tuple = array->GetTuple(i);
    values.insert(std::vector<double>(tuple, tuple + array->GetNumberOfComponents()));
  }
  return values;
}

std::set<std::string> GetNames(vtkPolyData* mesh, const std::string& array)
{
  const auto pairs = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray((array + "_names").c_str()));
  std::set<std::string> names;
  for (vtkIdType i = 0; pairs && i < pairs->GetNumberOfTuples(); ++i)
  {
    names.insert(pairs->GetValue(2 * i + 1));
  }
  return names;
}

int CountComponents(vtkPolyData* mesh)
{
  const vtkNew<vtkPolyDataConnectivityFilter> filter;
  filter->SetInputData(mesh);
  filter->SetExtractionModeToAllRegions();
  filter->Update();
  return filter->GetNumberOfExtractedRegions();
}

class Reports : public MTBmtTest
{
protected:
  static std::filesystem::path GetFolder()
  {
    const std::string data = MTIOTest::GetDataFolder();
    const std::filesystem::path folder = std::filesystem::path(data).parent_path() / "reports";
    return !data.empty() && std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
  }

  std::vector<std::string> MakeCall(const Right& right, const std::vector<std::string>& words) const
  {
    std::vector<std::string> call = words;
    for (const std::string& input : right.Inputs)
    {
      call.insert(call.end(), call.front() == "verify" ? 1 : 0, "--input");
      call.push_back((GetFolder() / input).string());
    }
    call.insert(call.end(), right.Options.begin(), right.Options.end());
    return call;
  }

  void CheckCut(const Right& right)
  {
    const bool isFinest = right.Triangles != 1500;
    this->BmtJson({ "extract", this->Path("a.bmt"), isFinest ? "--level" : "--triangles", isFinest ? "0" : "1500", "-o",
      this->Path("a.vtp") });
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->Path("a.vtp").c_str());
    reader->Update();
    vtkPolyData* const mesh = reader->GetOutput();
    const Figures got = Measure(mesh);
    double bounds[6];
    mesh->GetBounds(bounds);
    std::printf(" %lld triangles, volume %.6g, area %.6g, bounds %g %g %g %g %g %g |",
      static_cast<long long>(got.Triangles), got.Volume, got.Area, bounds[0], bounds[1], bounds[2], bounds[3],
      bounds[4], bounds[5]);
    EXPECT_TRUE(isFinest ? right.Triangles < 0 || right.Triangles == got.Triangles : got.Triangles <= right.Triangles);
    EXPECT_GT(got.Triangles, isFinest ? 0 : 500);
    for (std::size_t i = 0; i < right.Bounds.size(); ++i)
    {
      EXPECT_NEAR(bounds[i], right.Bounds[i], 1e-5);
    }
    EXPECT_TRUE(std::isnan(right.Volume) || std::abs(got.Volume - right.Volume) < 1e-4 * (1.0 + right.Volume) * 3.0);
    EXPECT_TRUE(std::isnan(right.Area) || std::abs(got.Area - right.Area) < 1e-4 * (1.0 + right.Area));
    if (!right.Options.empty())
    {
      EXPECT_GT(got.Volume, 0.0) << "the surface is inside out";
    }
    EXPECT_TRUE(right.Array.empty() || GetValues(mesh, right.Array) == right.Values) << right.Array;
    EXPECT_TRUE(right.Names.empty() || GetNames(mesh, right.Array) == right.Names) << right.Array;
    EXPECT_TRUE(right.Components == 0 || CountComponents(mesh) == right.Components);
  }

  void Check(const Right& right)
  {
    SCOPED_TRACE(right.Inputs.front());
    std::printf("| `%s` |", right.Inputs.front().c_str());
    const MTRun built = this->Bmt(this->MakeCall(right,
      { "build", "-o", this->Path("a.bmt"), "--patch-triangles", right.Triangles == 1500 ? "200" : "1000", "--json" }));
    if (!right.Refusal.empty())
    {
      EXPECT_EQ(built.Exit, 1);
      EXPECT_NE(built.Err.find(right.Refusal), std::string::npos) << built.Err;
      std::printf(" refused, names %s |\n", right.Refusal.c_str());
      return;
    }
    ASSERT_EQ(built.Exit, 0) << built.Err;
    const nlohmann::json result = built.Json();
    EXPECT_TRUE(right.Count.empty() || result["input_report"].contains(right.Count)) << result["input_report"];
    EXPECT_EQ(result.contains("texture_problems") ? result["texture_problems"].size() : 0, right.TextureProblems);
    this->CheckCut(right);
    const MTRun verified =
      this->Bmt(this->MakeCall(right, { "verify", this->Path("a.bmt"), "--cuts", "2", "--samples", "2000", "--json" }));
    EXPECT_EQ(verified.Exit, 0) << verified.Err;
    std::printf(" %s | %s |\n", result["input_report"].dump().c_str(), verified.Exit == 0 ? "passed" : "failed");
  }

  void CheckAll(const std::vector<Right>& all)
  {
    if (GetFolder().empty())
    {
      GTEST_SKIP() << "the reports are not there: a folder reports beside the test data";
    }
    for (const Right& right : all)
    {
      this->Check(right);
    }
  }
};
}

TEST_F(Reports, OfGltfHaveTheirRightValues)
{
  this->CheckAll(GetGltf());
}

TEST_F(Reports, OfTextAndOldFormatsHaveTheirRightValues)
{
  this->CheckAll(GetText());
}

TEST_F(Reports, OfVolumesTerrainAndLabelsHaveTheirRightValues)
{
  this->CheckAll(GetImages());
}
