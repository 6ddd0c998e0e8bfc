// SPDX-License-Identifier: BSD-3-Clause
#include "MTVerifyFiles.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtk_zlib.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

namespace MTVerifyFiles
{
namespace
{
using Triangle = std::array<std::array<double, 3>, 3>;

std::vector<Triangle> GetTriangles(vtkPolyData* surface)
{
  std::vector<Triangle> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, corners);
    triangles.emplace_back();
    for (vtkIdType c = 0; c < 3; ++c)
    {
      surface->GetPoint(corners->GetId(c), triangles.back()[static_cast<std::size_t>(c)].data());
    }
  }
  return triangles;
}
}

const std::array<std::function<std::string(const std::vector<double>&, bool)>, 10>& GetEncoders()
{
  static const std::array<std::function<std::string(const std::vector<double>&, bool)>, 10> encoders = { {
    Encode<std::int8_t>,
    Encode<std::uint8_t>,
    Encode<std::int16_t>,
    Encode<std::uint16_t>,
    Encode<std::int32_t>,
    Encode<std::uint32_t>,
    Encode<std::int64_t>,
    Encode<std::uint64_t>,
    Encode<float>,
    Encode<double>,
  } };
  return encoders;
}

std::string Compress(std::string text, int windowBits)
{
  z_stream state = {};
  EXPECT_EQ(deflateInit2(&state, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&state, static_cast<uLong>(text.size())) + 64, '\0');
  state.next_in = reinterpret_cast<unsigned char*>(&text[0]);
  state.avail_in = static_cast<uInt>(text.size());
  state.next_out = reinterpret_cast<unsigned char*>(&packed[0]);
  state.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  packed.resize(state.total_out);
  deflateEnd(&state);
  return packed;
}

std::string ToText(const std::vector<double>& samples)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    text << samples[i] << (i % 10 == 9 ? "\n" : " ");
  }
  return text.str();
}

std::string ToHex(const std::string& bytes)
{
  std::string text;
  for (const unsigned char byte : bytes)
  {
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789ABCDEF"[byte % 16];
    text += text.size() % 70 == 0 ? "\n" : "";
  }
  return text;
}

double GetSignedVolume(vtkPolyData* surface)
{
  double volume = 0.0;
  for (const Triangle& x : GetTriangles(surface))
  {
    double normal[3];
    vtkMath::Cross(x[1].data(), x[2].data(), normal);
    volume += vtkMath::Dot(x[0].data(), normal) / 6.0;
  }
  return volume;
}

double GetArea(vtkPolyData* surface)
{
  double area = 0.0;
  for (const Triangle& x : GetTriangles(surface))
  {
    double u[3], v[3], normal[3];
    vtkMath::Subtract(x[1].data(), x[0].data(), u);
    vtkMath::Subtract(x[2].data(), x[0].data(), v);
    vtkMath::Cross(u, v, normal);
    area += 0.5 * vtkMath::Norm(normal);
  }
  return area;
}

std::size_t CountComponents(vtkPolyData* surface)
{
  std::vector<vtkIdType> parents(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  std::iota(parents.begin(), parents.end(), 0);
  const auto find = [&](vtkIdType id)
  {
    while (parents[static_cast<std::size_t>(id)] != id)
    {
      id = parents[static_cast<std::size_t>(id)] =
        parents[static_cast<std::size_t>(parents[static_cast<std::size_t>(id)])];
    }
    return id;
  };
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, corners);
    parents[static_cast<std::size_t>(find(corners->GetId(0)))] = find(corners->GetId(1));
    parents[static_cast<std::size_t>(find(corners->GetId(1)))] = find(corners->GetId(2));
  }
  std::set<vtkIdType> roots;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    roots.insert(find(i));
  }
  return roots.size();
}

void FolderTest::SetUp()
{
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  this->Folder = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/" + test->test_suite_name() + "_" + test->name();
  std::filesystem::remove_all(this->Folder);
  std::filesystem::create_directories(this->Folder);
}

std::string FolderTest::Write(const std::string& name, const std::string& bytes) const
{
  std::ofstream(this->Folder + "/" + name, std::ios::binary) << bytes;
  return this->Folder + "/" + name;
}

std::string GetReports()
{
  const std::string folder = std::string(MT_SOURCE_DIRECTORY) + "/../shared/reports";
  return std::filesystem::is_directory(folder) ? folder + "/" : "";
}
}
