// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStreamPreview.h"

#include "vtkCellArray.h"
#include "vtkMTTriangleStream.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t None = 0xffffffff;    // of points that are not finite
constexpr double FirstCells = 1 << 20;        // of the grid along the extent of the first points
constexpr double LargestPlace = 1e18;         // fits into 64 bits
constexpr std::size_t TrianglesOfCluster = 4; // at most, in the mean; a surface has two

bool IsFinite(const std::array<double, 3>& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}
}

template <class T>
std::size_t vtkMTStreamPreview::Hash::operator()(const std::array<T, 3>& key) const
{
  std::uint64_t hash = 0;
  for (const T value : key)
  {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29;
  }
  return hash;
}

//------------------------------------------------------------------------------
vtkMTStreamPreview::vtkMTStreamPreview(std::size_t clusterLimit)
  : ClusterLimit(std::max<std::size_t>(clusterLimit, 8))
{
}

//------------------------------------------------------------------------------
bool vtkMTStreamPreview::Read(vtkMTTriangleStream& stream, const std::function<bool()>& goesOn, std::string& error)
{
  error.clear();
  bool isRead = stream.Rewind();
  vtkMTTriangleStream::PointBlock points;
  while (isRead && (isRead = stream.NextPoints(points)) && !points.Points.empty())
  {
    this->StartGrid(points.Points);
    std::for_each(points.Points.begin(), points.Points.end(),
      [this](const std::array<double, 3>& point) { this->AddPoint(point); });
    if (!goesOn())
    {
      return false;
    }
  }
  vtkMTTriangleStream::TriangleBlock triangles;
  while (isRead && (isRead = stream.NextTriangles(triangles)) && !triangles.Triangles.empty())
  {
    for (const std::array<std::uint64_t, 3>& corners : triangles.Triangles)
    {
      this->AddTriangle(corners);
    }
    if (!goesOn())
    {
      return false;
    }
  }
  error = isRead ? "" : stream.GetError();
  return isRead;
}

//------------------------------------------------------------------------------
void vtkMTStreamPreview::StartGrid(const std::vector<std::array<double, 3>>& points)
{
  if (this->HasGrid)
  {
    return;
  }
  std::array<double, 3> least;
  std::array<double, 3> largest;
  least.fill(std::numeric_limits<double>::infinity());
  largest.fill(-std::numeric_limits<double>::infinity());
  for (const std::array<double, 3>& point : points)
  {
    for (int i = 0; i < 3 && IsFinite(point); ++i)
    {
      least[i] = std::min(least[i], point[i]);
      largest[i] = std::max(largest[i], point[i]);
    }
  }
  if (!IsFinite(least))
  {
    return; // not a single point that is finite
  }
  double extent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    extent = std::max(extent, 0.5 * largest[i] - 0.5 * least[i]);
  }
  this->Origin = least;
  this->CellSize = std::max(
    std::min(2.0 * extent, std::numeric_limits<double>::max()) / FirstCells, std::numeric_limits<double>::min());
  this->HasGrid = true;
}

//------------------------------------------------------------------------------
void vtkMTStreamPreview::AddPoint(const std::array<double, 3>& point)
{
  std::uint32_t cluster = None;
  if (this->HasGrid && IsFinite(point))
  {
    Key key;
    std::array<double, 3> local;
    for (int i = 0; i < 3; ++i)
    {
      local[i] = point[i] - this->Origin[i];
      key[i] =
        static_cast<std::int64_t>(std::clamp(std::floor(local[i] / this->CellSize), -LargestPlace, LargestPlace));
    }
    const auto [place, isNew] = this->Places.try_emplace(key, static_cast<std::uint32_t>(this->Clusters.size()));
    cluster = place->second;
    if (isNew)
    {
      this->Clusters.push_back({ key, {}, 0.0 });
    }
    for (int i = 0; i < 3; ++i)
    {
      this->Clusters[cluster].Sum[i] += local[i];
    }
    this->Clusters[cluster].Count += 1.0;
  }
  if (this->ClusterOfPoint.size() < PointLimit)
  {
    this->ClusterOfPoint.push_back(cluster);
  }
  while (this->Clusters.size() > this->ClusterLimit)
  {
    this->Coarsen();
  }
}

//------------------------------------------------------------------------------
void vtkMTStreamPreview::AddTriangle(const std::array<std::uint64_t, 3>& corners)
{
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
  {
    triangle[i] = corners[i] < this->ClusterOfPoint.size() ? this->ClusterOfPoint[corners[i]] : None;
    if (triangle[i] == None)
    {
      return;
    }
  }
  if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
  {
    return;
  }
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  this->Triangles.insert(triangle);
  while (this->Triangles.size() > TrianglesOfCluster * this->ClusterLimit)
  {
    this->Coarsen();
  }
}

//------------------------------------------------------------------------------
// Cells of twice the size: each has eight of those before.
void vtkMTStreamPreview::Coarsen()
{
  this->CellSize *= 2.0;
  std::vector<Cluster> before;
  before.swap(this->Clusters);
  this->Places.clear();
  std::vector<std::uint32_t> newIndex(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    const Cluster& cluster = before[i];
    const Key key{ cluster.Place[0] >> 1, cluster.Place[1] >> 1, cluster.Place[2] >> 1 }; // rounds down
    const auto [place, isNew] = this->Places.try_emplace(key, static_cast<std::uint32_t>(this->Clusters.size()));
    newIndex[i] = place->second;
    if (isNew)
    {
      this->Clusters.push_back({ key, cluster.Sum, cluster.Count });
      continue;
    }
    Cluster& whole = this->Clusters[place->second];
    std::transform(whole.Sum.begin(), whole.Sum.end(), cluster.Sum.begin(), whole.Sum.begin(), std::plus<>());
    whole.Count += cluster.Count;
  }
  for (std::uint32_t& cluster : this->ClusterOfPoint)
  {
    cluster = cluster == None ? None : newIndex[cluster];
  }
  std::unordered_set<Triangle, Hash> triangles;
  triangles.swap(this->Triangles);
  for (const Triangle& old : triangles)
  {
    Triangle triangle{ newIndex[old[0]], newIndex[old[1]], newIndex[old[2]] };
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      this->Triangles.insert(triangle);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMTStreamPreview::Make(vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Clusters.size()));
  for (std::size_t i = 0; i < this->Clusters.size(); ++i)
  {
    const Cluster& cluster = this->Clusters[i];
    points->SetPoint(static_cast<vtkIdType>(i), this->Origin[0] + cluster.Sum[0] / cluster.Count,
      this->Origin[1] + cluster.Sum[1] / cluster.Count, this->Origin[2] + cluster.Sum[2] / cluster.Count);
  }
  std::vector<Triangle> triangles(this->Triangles.begin(), this->Triangles.end());
  std::sort(triangles.begin(), triangles.end()); // a set's order depends on its history
  vtkNew<vtkCellArray> cells;
  for (const Triangle& triangle : triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  for (vtkIdType i = 0; triangles.empty() && i < points->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell({ i });
  }
  output->Initialize();
  output->SetPoints(points);
  if (triangles.empty())
  {
    output->SetVerts(cells);
  }
  else
  {
    output->SetPolys(cells);
  }
}
