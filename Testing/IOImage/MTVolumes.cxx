// SPDX-License-Identifier: BSD-3-Clause
#include "MTVolumes.h"

#include "vtkMTTriangleStream.h"
#include "vtkMTVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using MTIOTest::Bytes;

namespace MTVolumes
{
namespace
{
Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// From the world to indices: row r of the inverse is the cross product of the two other axes, over the determinant.
std::array<Vector, 3> Invert(const Frame& frame)
{
  std::array<Vector, 3> rows;
  for (std::size_t r = 0; r < 3; ++r)
  {
    rows[r] = Cross(frame.Axes[(r + 1) % 3], frame.Axes[(r + 2) % 3]);
    for (double& number : rows[r])
    {
      number /= frame.GetDeterminant();
    }
  }
  return rows;
}

Vector ToIndex(const Frame& frame, const Vector& place)
{
  const std::array<Vector, 3> rows = Invert(frame);
  const Vector from{ place[0] - frame.Origin[0], place[1] - frame.Origin[1], place[2] - frame.Origin[2] };
  return { Dot(rows[0], from), Dot(rows[1], from), Dot(rows[2], from) };
}

// How far the vertex is from an edge of the grid, and the value between the ends of the edge.
void LookAtVertex(const Vector& index, double& distance, double& value)
{
  std::array<int, 3> low;
  std::size_t along = 0;
  Vector off;
  for (std::size_t i = 0; i < 3; ++i)
  {
    low[i] = static_cast<int>(std::lround(index[i]));
    off[i] = std::abs(index[i] - low[i]);
    along = off[i] > off[along] ? i : along;
  }
  off[along] = 0.0;
  distance = std::max({ distance, off[0], off[1], off[2] });
  low[along] = static_cast<int>(std::floor(index[along]));
  std::array<int, 3> high = low;
  ++high[along];
  const double t = index[along] - low[along];
  value = (1.0 - t) * GetSample(low[0], low[1], low[2]) + t * GetSample(high[0], high[1], high[2]);
}

using Triangles = std::vector<std::array<std::uint64_t, 3>>;

double SumVolume(const std::vector<Vector>& points, const Triangles& triangles, const Vector& origin)
{
  double volume = 0.0;
  for (const auto& corners : triangles)
  {
    std::array<Vector, 3> p;
    for (std::size_t c = 0; c < 3; ++c)
    {
      p[c] = points.at(corners[c]);
      for (std::size_t i = 0; i < 3; ++i)
      {
        p[c][i] -= origin[i];
      }
    }
    volume += Dot(p[0], Cross(p[1], p[2])) / 6.0;
  }
  return volume;
}

void ExpectSurface(
  const std::vector<Vector>& points, const Triangles& triangles, const Frame& frame, const std::string& name)
{
  double distance = 0.0;
  double deviation = 0.0;
  for (const Vector& point : points)
  {
    double value = 0.0;
    LookAtVertex(ToIndex(frame, point), distance, value);
    deviation = std::max(deviation, std::abs(value - IsoValue));
  }
  EXPECT_GT(points.size(), 500u) << name;
  EXPECT_LT(distance, 1e-4) << name << ": a vertex is on no edge of the grid";
  EXPECT_LT(deviation, 0.01) << name << ": the value at a vertex is another one";
  const double volume = SumVolume(points, triangles, frame.Origin);
  // The ellipsoid's, less what triangles leave out of it.
  const double rest = 400.0 - IsoValue;
  const double ideal = 4.0 / 3.0 * M_PI * std::sqrt(rest / 4.0 * rest / 3.0 * rest / 5.0);
  EXPECT_NEAR(volume / std::abs(frame.GetDeterminant()) / ideal, 0.985, 0.01) << name << ": signed volume";
}

void ExpectNormals(vtkPolyData* mesh, const Frame& frame, const std::string& name)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr) << name;
  const std::array<Vector, 3> rows = Invert(frame);
  double least = 1.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    Vector place;
    Vector normal;
    mesh->GetPoint(p, place.data());
    normals->GetTuple(p, normal.data());
    const Vector index = ToIndex(frame, place);
    const Vector slope{ 8.0 * (index[0] - 8.0), 6.0 * (index[1] - 10.0), 10.0 * (index[2] - 7.0) };
    Vector right{ 0, 0, 0 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      right[i] = rows[0][i] * slope[0] + rows[1][i] * slope[1] + rows[2][i] * slope[2];
    }
    least = std::min(least, Dot(right, normal) / std::sqrt(Dot(right, right)));
    ASSERT_NEAR(Dot(normal, normal), 1.0, 1e-5) << name;
  }
  EXPECT_GT(least, 0.9999) << name << ": a gradient normal is not that of the ellipsoid";
}

void ReadMesh(vtkPolyData* mesh, std::vector<Vector>& points, Triangles& triangles)
{
  points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    mesh->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetCellPoints(t, corners);
    triangles.push_back({ static_cast<std::uint64_t>(corners->GetId(0)), static_cast<std::uint64_t>(corners->GetId(1)),
      static_cast<std::uint64_t>(corners->GetId(2)) });
  }
}

void ReadStream(vtkMTTriangleStream& stream, std::vector<Vector>& points, Triangles& triangles)
{
  vtkMTTriangleStream::PointBlock some;
  while (stream.NextPoints(some) && !some.Points.empty())
  {
    points.insert(points.end(), some.Points.begin(), some.Points.end());
  }
  vtkMTTriangleStream::TriangleBlock more;
  while (stream.NextTriangles(more) && !more.Triangles.empty())
  {
    triangles.insert(triangles.end(), more.Triangles.begin(), more.Triangles.end());
  }
  EXPECT_EQ(stream.GetError(), "");
}
}

double Frame::GetDeterminant() const
{
  return Dot(this->Axes[0], Cross(this->Axes[1], this->Axes[2]));
}

double GetSignedVolume(vtkPolyData* mesh)
{
  std::vector<Vector> points;
  Triangles triangles;
  ReadMesh(mesh, points, triangles);
  return points.empty() ? 0.0 : SumVolume(points, triangles, points.front());
}

int GetSample(int i, int j, int k)
{
  return 400 - 4 * (i - 8) * (i - 8) - 3 * (j - 10) * (j - 10) - 5 * (k - 7) * (k - 7);
}

template <typename Number>
Bytes GetSamples(bool isSwapped)
{
  Bytes bytes;
  for (int k = 0; k < Size[2]; ++k)
  {
    for (int j = 0; j < Size[1]; ++j)
    {
      for (int i = 0; i < Size[0]; ++i)
      {
        const auto number = static_cast<Number>(GetSample(i, j, k));
        unsigned char octets[sizeof(Number)];
        std::memcpy(octets, &number, sizeof(Number));
        if (isSwapped)
        {
          std::reverse(std::begin(octets), std::end(octets));
        }
        bytes.insert(bytes.end(), std::begin(octets), std::end(octets));
      }
    }
  }
  return bytes;
}
template Bytes GetSamples<std::int16_t>(bool);
template Bytes GetSamples<std::int32_t>(bool);
template Bytes GetSamples<std::int64_t>(bool);
template Bytes GetSamples<float>(bool);
template Bytes GetSamples<double>(bool);

void Append(Bytes& bytes, const std::string& text)
{
  bytes.insert(bytes.end(), text.begin(), text.end());
}

void Append(Bytes& bytes, const Bytes& more)
{
  bytes.insert(bytes.end(), more.begin(), more.end());
}

Bytes Gzip(const Bytes& bytes)
{
  z_stream state{};
  Bytes packed(bytes.size() + 1024);
  deflateInit2(&state, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  state.next_in = const_cast<unsigned char*>(bytes.data());
  state.avail_in = static_cast<unsigned>(bytes.size());
  state.next_out = packed.data();
  state.avail_out = static_cast<unsigned>(packed.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  packed.resize(packed.size() - state.avail_out);
  deflateEnd(&state);
  return packed;
}

Read ExpectEllipsoid(const std::string& path, const Frame& frame, double isoValue)
{
  const std::string name = std::filesystem::path(path).filename().string();
  Read read;
  std::string error;
  vtkNew<vtkPolyData> mesh;
  vtkMTVolumeReader::Facts facts;
  const bool good = vtkMTVolumeReader::ReadIsosurface(path, isoValue, true, mesh, error, &facts);
  EXPECT_TRUE(good) << error;
  if (!good)
  {
    return read;
  }
  read = { facts.Frame, facts.Report, mesh->GetNumberOfPolys() };
  std::vector<Vector> points;
  Triangles triangles;
  ReadMesh(mesh, points, triangles);
  ExpectSurface(points, triangles, frame, name);
  ExpectNormals(mesh, frame, name);
  for (const int slices : { 1, 6, 100 })
  {
    const auto samples = static_cast<std::uint64_t>(slices * Size[0] * Size[1]);
    vtkMTWorldFrame world;
    const auto stream = vtkMTVolumeReader::StreamIsosurface(path, isoValue, error, samples, &world);
    EXPECT_NE(stream, nullptr) << error;
    points.clear();
    triangles.clear();
    ReadStream(*stream, points, triangles);
    ExpectSurface(points, triangles, frame, name + ", in slabs of " + std::to_string(slices));
    EXPECT_EQ(triangles.size(), static_cast<std::size_t>(read.Triangles)) << name;
    EXPECT_EQ(stream->GetReport(), read.Report) << name;
    EXPECT_EQ(world.Crs + world.Units, read.Frame.Crs + read.Frame.Units) << name;
  }
  const std::int64_t turned = frame.GetDeterminant() < 0.0 ? read.Triangles : 0;
  const auto found = read.Report.find("turned_triangles");
  EXPECT_EQ(found == read.Report.end() ? 0 : found->second, turned) << name;
  return read;
}
}
