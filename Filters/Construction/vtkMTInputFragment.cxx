// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputFragment.h"

#include "vtkMTBytes.h"
#include "vtkMTHalfedgePairs.h"
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

void PutId(std::int64_t id, std::size_t place, vtkMTColumn& column)
{
  const auto value = static_cast<vtkIdType>(id);
  std::memcpy(column.data() + place * sizeof(value), &value, sizeof(value));
}

// One tuple each, of those of item i.
void PutValues(const std::vector<unsigned char>& all, std::size_t i, const std::vector<std::size_t>& sizes,
  std::size_t place, std::vector<vtkMTColumn>& columns)
{
  const unsigned char* values = all.data() + i * std::accumulate(sizes.begin(), sizes.end(), std::size_t(0));
  for (std::size_t c = 0; c < sizes.size(); ++c)
  {
    std::memcpy(columns[c].data() + place * sizes[c], values, sizes[c]);
    values += sizes[c];
  }
}

// Columns of so many tuples each; an id's behind the others.
void SizeColumns(
  const std::vector<std::size_t>& sizes, bool hasIds, std::size_t tuples, std::vector<vtkMTColumn>& columns)
{
  columns.resize(sizes.size() + (hasIds ? 1 : 0));
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    columns[c].resize(tuples * (c < sizes.size() ? sizes[c] : sizeof(vtkIdType)));
  }
}

// Shared points first, then in order of identity; wedges in order of their points.
std::vector<std::uint32_t> SortPoints(const std::vector<Point>& points)
{
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const std::uint32_t isShared : { 1u, 0u })
  {
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      if (points[i].IsShared == isShared)
      {
        order.push_back(i);
      }
    }
  }
  const auto isBefore = [&points](std::uint32_t i, std::uint32_t j)
  {
    const Point& a = points[i];
    const Point& b = points[j];
    return a.IsShared != b.IsShared ? a.IsShared > b.IsShared : a.Root != b.Root ? a.Root < b.Root : a.Wedge < b.Wedge;
  };
  if (!std::is_sorted(order.begin(), order.end(), isBefore)) // as they are where nothing was stitched
  {
    std::stable_sort(order.begin(), order.end(), isBefore);
  }
  return order;
}

// Points and wedges. identities: of the points. Gives the wedge of each of the given points.
std::vector<std::uint32_t> MakeWedges(const vtkMTInputRegions::Region& records,
  const vtkMTInputFragment::Layout& layout, vtkMTPatch& mesh, std::vector<std::uint32_t>& identities)
{
  const std::vector<Point>& points = records.Points;
  const std::vector<std::uint32_t> order = SortPoints(points);
  std::vector<std::uint32_t> wedgeOf(points.size());
  mesh.Points.reserve(points.size());
  identities.reserve(points.size());
  mesh.WedgePoints.reserve(points.size());
  SizeColumns(layout.PointTupleSizes, layout.HasPointIds, points.size(), mesh.PointColumns);
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
      const std::size_t wedge = mesh.WedgePoints.size();
      mesh.WedgePoints.push_back(static_cast<std::uint32_t>(mesh.Points.size() - 1));
      PutValues(records.PointValues, order[i], layout.PointTupleSizes, wedge, mesh.PointColumns);
      if (layout.HasPointIds)
      {
        PutId(point.Wedge, wedge, mesh.PointColumns.back());
      }
    }
    wedgeOf[order[i]] = static_cast<std::uint32_t>(mesh.WedgePoints.size() - 1);
    last = order[i];
  }
  SizeColumns(layout.PointTupleSizes, layout.HasPointIds, mesh.WedgePoints.size(), mesh.PointColumns);
  if (mesh.WedgePoints.size() == mesh.Points.size())
  {
    vtkMTRelease(mesh.WedgePoints);
  }
  return wedgeOf;
}

// From the input's index of a point to its wedge, by open addressing.
class WedgeTable
{
public:
  WedgeTable(const std::vector<Point>& points, const std::vector<std::uint32_t>& wedges)
  {
    while ((std::size_t(1) << this->Bits) < 2 * points.size())
    {
      ++this->Bits;
    }
    this->Entries.assign(std::size_t(1) << this->Bits, Entry{ None, 0 });
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto index = static_cast<std::uint32_t>(points[i].Key);
      this->Entries[this->Find(index)] = { index, wedges[i] };
    }
  }

  std::uint32_t operator[](std::uint32_t index) const { return this->Entries[this->Find(index)].Wedge; }

private:
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  struct Entry
  {
    std::uint32_t Index;
    std::uint32_t Wedge;
  };

  std::size_t Find(std::uint32_t index) const
  {
    std::size_t at = static_cast<std::size_t>((index * 0x9E3779B97F4A7C15u) >> (64 - this->Bits));
    while (this->Entries[at].Index != index && this->Entries[at].Index != None)
    {
      at = (at + 1) & (this->Entries.size() - 1);
    }
    return at;
  }

  unsigned Bits = 4;
  std::vector<Entry> Entries;
};

void MakeTriangles(const vtkMTInputRegions::Region& records, const vtkMTInputFragment::Layout& layout,
  const WedgeTable& wedgeOf, vtkMTPatch& mesh)
{
  mesh.Triangles.resize(records.Triangles.size());
  SizeColumns(layout.CellTupleSizes, layout.HasCellIds, records.Triangles.size(), mesh.CellColumns);
  for (std::size_t t = 0; t < records.Triangles.size(); ++t)
  {
    const Triangle& triangle = records.Triangles[t];
    mesh.Triangles[t] = { wedgeOf[triangle.Points[0]], wedgeOf[triangle.Points[1]], wedgeOf[triangle.Points[2]] };
    if (!layout.CellTupleSizes.empty())
    {
      PutValues(records.TriangleValues, t, layout.CellTupleSizes, t, mesh.CellColumns);
    }
    if (layout.HasCellIds)
    {
      PutId(triangle.CellId, t, mesh.CellColumns.back());
    }
  }
}
}

void vtkMTInputFragment::Make(std::uint32_t region, vtkMTInputRegions::Region&& records, const Layout& layout)
{
  std::vector<std::uint32_t> identities;
  const WedgeTable wedgeOf(records.Points, MakeWedges(records, layout, this->Mesh, identities));
  vtkMTRelease(records.Points);
  vtkMTRelease(records.PointValues);
  MakeTriangles(records, layout, wedgeOf, this->Mesh);
  this->Numbers.reserve(records.Triangles.size());
  for (const Triangle& triangle : records.Triangles)
  {
    this->Numbers.push_back(triangle.Number);
  }
  vtkMTRelease(records.Triangles);
  vtkMTRelease(records.TriangleValues);
  const vtkMTHalfedgePairs pairs(this->Mesh);
  this->Orientation.Run(this->Mesh, this->Numbers, pairs);
  this->SharedPlaces = vtkMTSharedIds::FindPlaces(this->Mesh, pairs);
  if (layout.MakeNormals)
  {
    this->Angles.Add(this->Mesh, pairs);
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
