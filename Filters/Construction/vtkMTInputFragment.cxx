// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputFragment.h"

#include "vtkMTBytes.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTRelease.h"
#include "vtkMTSharedIds.h"
#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
using Point = vtkMTInputRegions::Point;
using Triangle = vtkMTInputRegions::Triangle;

template <typename Record>
std::vector<Record> ReadAll(const std::vector<unsigned char>& bytes, std::size_t size)
{
  std::vector<Record> records(bytes.size() / size);
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    std::memcpy(&records[i], bytes.data() + i * size, sizeof(Record));
  }
  return records;
}

void AppendId(std::int64_t id, vtkMTColumn& column)
{
  const auto value = static_cast<vtkIdType>(id);
  const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
  column.insert(column.end(), bytes, bytes + sizeof(value));
}

// Points and wedges: shared points first, then in order of identity; wedges in order of their points. identities: of
// the points.
std::vector<std::uint32_t> MakeWedges(const std::vector<Point>& points, const std::vector<unsigned char>& bytes,
  const vtkMTInputFragment::Layout& layout, vtkMTPatch& mesh, std::vector<std::uint32_t>& identities)
{
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&points](std::uint32_t i, std::uint32_t j)
  {
    const Point& a = points[i];
    const Point& b = points[j];
    return a.IsShared != b.IsShared ? a.IsShared > b.IsShared : a.Root != b.Root ? a.Root < b.Root : a.Wedge < b.Wedge;
  };
  std::stable_sort(order.begin(), order.end(), isBefore);
  std::vector<std::uint32_t> wedgeOf(points.size());
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Point& point = points[order[i]];
    const bool isNewPoint = i == 0 || points[last].Root != point.Root;
    if (isNewPoint)
    {
      mesh.Points.push_back(point.X);
      identities.push_back(point.Root);
      if (point.IsShared)
      {
        mesh.Ids.push_back(vtkMTPatchSplitter::MakeInputId(point.Root));
      }
    }
    if (isNewPoint || points[last].Wedge != point.Wedge)
    {
      mesh.WedgePoints.push_back(static_cast<std::uint32_t>(mesh.Points.size() - 1));
      const unsigned char* values = bytes.data() + order[i] * layout.PointSize + sizeof(Point);
      for (std::size_t c = 0; c < layout.PointTupleSizes.size(); ++c)
      {
        mesh.PointColumns[c].insert(mesh.PointColumns[c].end(), values, values + layout.PointTupleSizes[c]);
        values += layout.PointTupleSizes[c];
      }
      if (layout.HasPointIds)
      {
        AppendId(point.Wedge, mesh.PointColumns.back());
      }
    }
    wedgeOf[order[i]] = static_cast<std::uint32_t>(mesh.WedgePoints.size() - 1);
    last = order[i];
  }
  if (mesh.WedgePoints.size() == mesh.Points.size())
  {
    mesh.WedgePoints.clear();
  }
  return wedgeOf;
}
}

void vtkMTInputFragment::Make(std::uint32_t region, vtkMTInputRegions::Region&& records, const Layout& layout)
{
  const std::vector<Point> points = ReadAll<Point>(records.Points, layout.PointSize);
  this->Mesh.PointColumns.resize(layout.PointTupleSizes.size() + (layout.HasPointIds ? 1 : 0));
  std::vector<std::uint32_t> identities;
  const std::vector<std::uint32_t> wedgeOf = MakeWedges(points, records.Points, layout, this->Mesh, identities);
  vtkMTRelease(records.Points);

  const std::vector<Triangle> triangles = ReadAll<Triangle>(records.Triangles, layout.TriangleSize);
  this->Mesh.CellColumns.resize(layout.CellTupleSizes.size() + (layout.HasCellIds ? 1 : 0));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    vtkMTTriangle wedges;
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t point = triangles[t].Points[c];
      const auto found = std::lower_bound(points.begin(), points.end(), point,
        [](const Point& record, std::uint32_t index) { return static_cast<std::uint32_t>(record.Key) < index; });
      wedges[c] = wedgeOf[static_cast<std::size_t>(found - points.begin())];
    }
    this->Mesh.Triangles.push_back(wedges);
    this->Numbers.push_back(triangles[t].Number);
    const unsigned char* values = records.Triangles.data() + t * layout.TriangleSize + sizeof(Triangle);
    for (std::size_t c = 0; c < layout.CellTupleSizes.size(); ++c)
    {
      this->Mesh.CellColumns[c].insert(this->Mesh.CellColumns[c].end(), values, values + layout.CellTupleSizes[c]);
      values += layout.CellTupleSizes[c];
    }
    if (layout.HasCellIds)
    {
      AppendId(triangles[t].CellId, this->Mesh.CellColumns.back());
    }
  }
  vtkMTRelease(records.Triangles);
  this->Orientation.Run(this->Mesh, this->Numbers);
  this->SharedPlaces = vtkMTSharedIds::FindPlaces(this->Mesh);
  if (layout.MakeNormals)
  {
    this->Angles.Add(this->Mesh);
    vtkMTSharedNormals::FindTerms(this->Mesh, this->Numbers, identities, this->Orientation.ComponentOf,
      this->Orientation.IsTurned, region, this->Terms);
  }
}

void vtkMTInputFragment::Encode(std::vector<unsigned char>& bytes) const
{
  bytes.clear();
  bytes.reserve(this->Mesh.GetMemorySize() + 256);
  vtkMTBytes::Writer writer(bytes);
  vtkMTPatchRecord::Put(this->Mesh, writer);
  writer.PutList(this->Components);
  // As a rule a fragment is connected and all of its triangles agree: nothing has to be stored then.
  const auto& turned = this->Orientation.IsTurned;
  if (this->Components.size() > 1 || std::find(turned.begin(), turned.end(), 1) != turned.end())
  {
    writer.PutList(this->Orientation.ComponentOf);
    writer.PutList(turned);
  }
}

bool vtkMTInputFragment::Decode(const vtkMTBytes::Record& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  vtkMTPatchRecord::Take(reader, this->Mesh); // what is wrong with it shows in the reader
  reader.TakeList(this->Components);
  this->Orientation.ComponentOf.assign(this->Mesh.Triangles.size(), 0);
  this->Orientation.IsTurned.assign(this->Mesh.Triangles.size(), 0);
  if (!reader.IsAtEnd())
  {
    reader.TakeList(this->Orientation.ComponentOf);
    reader.TakeList(this->Orientation.IsTurned);
  }
  error = reader.IsSound() ? error : "temporary data does not hold the fragment that was written";
  return reader.IsSound();
}

void vtkMTInputFragment::TurnRound(const vtkMTOrientation& orientation)
{
  for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
  {
    const std::uint32_t component = this->Components[this->Orientation.ComponentOf[t]];
    if (orientation.IsReversed(component, this->Orientation.IsTurned[t] != 0))
    {
      std::swap(this->Mesh.Triangles[t][1], this->Mesh.Triangles[t][2]);
    }
  }
}

void vtkMTInputFragment::AddNormals(const std::vector<std::array<float, 3>>& normals)
{
  const std::size_t wedges = this->Mesh.GetNumberOfWedges();
  vtkMTColumn column(wedges * sizeof(normals[0]));
  for (std::uint32_t w = 0; w < wedges; ++w)
  {
    std::memcpy(column.data() + w * sizeof(normals[0]), &normals[this->Mesh.GetPointOfWedge(w)], sizeof(normals[0]));
  }
  this->Mesh.PointColumns.push_back(std::move(column));
}

void vtkMTInputFragment::AddNormalsByCorner(const std::vector<std::array<float, 3>>& normals)
{
  const vtkMTPatch old = std::move(this->Mesh);
  std::vector<std::uint32_t> order(normals.size()); // of corners: by wedge, then by normal
  std::iota(order.begin(), order.end(), 0u);
  const auto getWedge = [&old](std::uint32_t h) { return old.Triangles[h / 3][h % 3]; };
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return getWedge(a) != getWedge(b) ? getWedge(a) < getWedge(b) : normals[a] < normals[b]; });
  vtkMTPatch mesh;
  mesh.Points = old.Points;
  mesh.Ids = old.Ids;
  mesh.Triangles.resize(old.Triangles.size());
  mesh.CellColumns = old.CellColumns;
  mesh.PointColumns.resize(old.PointColumns.size() + 1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::uint32_t h = order[i];
    const std::uint32_t wedge = getWedge(h);
    if (i == 0 || wedge != getWedge(order[i - 1]) || normals[h] != normals[order[i - 1]])
    {
      mesh.WedgePoints.push_back(old.GetPointOfWedge(wedge));
      for (std::size_t c = 0; c < old.PointColumns.size(); ++c)
      {
        const std::size_t size = old.PointColumns[c].size() / old.GetNumberOfWedges();
        const unsigned char* value = old.PointColumns[c].data() + wedge * size;
        mesh.PointColumns[c].insert(mesh.PointColumns[c].end(), value, value + size);
      }
      const auto* value = reinterpret_cast<const unsigned char*>(normals[h].data());
      mesh.PointColumns.back().insert(mesh.PointColumns.back().end(), value, value + sizeof(normals[h]));
    }
    mesh.Triangles[h / 3][h % 3] = static_cast<std::uint32_t>(mesh.WedgePoints.size() - 1);
  }
  if (mesh.WedgePoints.size() == mesh.Points.size())
  {
    mesh.WedgePoints.clear();
  }
  this->Mesh = std::move(mesh);
}
