// SPDX-License-Identifier: BSD-3-Clause
#include "MTGridModel.h"

#include "MTTestModel.h"

#include "vtkDataSetAttributes.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkType.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;

template <typename T>
void Append(vtkMTColumn& column, std::initializer_list<T> values)
{
  for (const T value : values)
  {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    column.insert(column.end(), bytes, bytes + sizeof(T));
  }
}

using GridPoint = std::array<int, 2>;
using GridTriangle = std::array<GridPoint, 3>;

// The closed loop along the square's border, counterclockwise, in steps of `step`.
std::vector<GridPoint> GetLoop(int x, int y, int side, int step)
{
  std::vector<GridPoint> loop;
  for (int i = 0; i < side; i += step)
    loop.push_back({ x + i, y });
  for (int i = 0; i < side; i += step)
    loop.push_back({ x + side, y + i });
  for (int i = 0; i < side; i += step)
    loop.push_back({ x + side - i, y + side });
  for (int i = 0; i < side; i += step)
    loop.push_back({ x, y + side - i });
  return loop;
}

// Triangles between two loops that begin at the same corner.
void Zip(const std::vector<GridPoint>& outer, const std::vector<GridPoint>& inner, std::vector<GridTriangle>& triangles)
{
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < outer.size() || (inner.size() > 1 && k < inner.size()))
  {
    const double nextOuter = i < outer.size() ? double(i + 1) / outer.size() : 2.0;
    const double nextInner = inner.size() > 1 && k < inner.size() ? double(k + 1) / inner.size() : 2.0;
    if (nextOuter <= nextInner)
    {
      triangles.push_back({ outer[i % outer.size()], outer[(i + 1) % outer.size()], inner[k % inner.size()] });
      ++i;
    }
    else
    {
      triangles.push_back({ outer[i % outer.size()], inner[(k + 1) % inner.size()], inner[k % inner.size()] });
      ++k;
    }
  }
}

// A square tile: every grid point on its border, steps of `step` inside.
std::vector<GridTriangle> Triangulate(int x, int y, int side, int step)
{
  std::vector<GridTriangle> triangles;
  const int first = step;
  const int last = side - step;
  for (int j = first; j < last; j += step)
  {
    for (int i = first; i < last; i += step)
    {
      const GridPoint a{ x + i, y + j };
      const GridPoint b{ x + i + step, y + j };
      const GridPoint c{ x + i + step, y + j + step };
      const GridPoint d{ x + i, y + j + step };
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  Zip(GetLoop(x, y, side, 1), GetLoop(x + step, y + step, side - 2 * step, step), triangles);
  return triangles;
}

class Maker
{
public:
  explicit Maker(const MTGridModel& model)
    : Model(model)
    , Store(std::make_shared<vtkMTPatchStore>())
  {
    double bounds[6];
    for (int i = 0; i < 3; ++i)
    {
      bounds[2 * i] = model.Corner[i] - (i == 2 ? 0.5 * model.Size : 0.0);
      bounds[2 * i + 1] = bounds[2 * i] + model.Size;
    }
    this->Graph.Lattice = vtkMTLattice::FromBounds(bounds);
    this->DescribeArrays();
  }

  std::shared_ptr<vtkMTPatchStore> Make()
  {
    this->Store->Begin(this->Graph.Arrays);
    int tiles = 1;
    std::uint32_t nodes = 2;
    for (int side = this->Model.Cells; side > this->Model.TileCells; side /= 2, tiles *= 4)
    {
      nodes += static_cast<std::uint32_t>(tiles);
    }
    this->Graph.Nodes.resize(nodes);
    this->AddTile(0, 0, 0, this->Model.Cells);
    this->Graph.InputCounts.Triangles = 2ull * this->Model.Cells * this->Model.Cells;
    this->Graph.Settings["partition"] = "quadtree";
    const std::vector<std::uint32_t> order = this->Graph.Index();
    this->Graph.Saturate(0.0);
    this->Store->Finish(this->Graph, order);
    return this->Store;
  }

private:
  void DescribeArrays()
  {
    const auto add = [this](const char* name, int type, int components, vtkMTArrayInfo::AssociationType association,
                       vtkMTArrayInfo::ResamplingType resampling, int attribute, vtkMTArrayInfo::RoleType role)
    {
      vtkMTArrayInfo info;
      info.Name = name;
      info.Type = type;
      info.Components = components;
      info.Association = association;
      info.Resampling = resampling;
      info.Attribute = attribute;
      info.Role = role;
      this->Graph.Arrays.push_back(info);
    };
    const auto point = vtkMTArrayInfo::Point;
    const auto cell = vtkMTArrayInfo::Cell;
    add("Elevation", VTK_FLOAT, 1, point, vtkMTArrayInfo::Interpolate, vtkDataSetAttributes::SCALARS,
      vtkMTArrayInfo::Plain);
    add("Color", VTK_UNSIGNED_CHAR, 4, point, vtkMTArrayInfo::Interpolate, -1, vtkMTArrayInfo::Plain);
    add("Block", VTK_INT, 1, cell, vtkMTArrayInfo::Nearest, -1, vtkMTArrayInfo::Plain);
    add("TCoords", VTK_FLOAT, 2, point, vtkMTArrayInfo::Interpolate, vtkDataSetAttributes::TCOORDS,
      vtkMTArrayInfo::Plain);
    if (this->Model.WithPointNormals)
    {
      add("Normals", VTK_FLOAT, 3, point, vtkMTArrayInfo::Direction, vtkDataSetAttributes::NORMALS,
        vtkMTArrayInfo::Plain);
    }
    if (this->Model.WithCellIds)
    {
      add("CellIds", VTK_ID_TYPE, 1, cell, vtkMTArrayInfo::Nearest, -1, vtkMTArrayInfo::InputCellIds);
    }
    if (this->Model.WithCellNormals)
    {
      add("FacetNormals", VTK_FLOAT, 3, cell, vtkMTArrayInfo::Nearest, vtkDataSetAttributes::NORMALS,
        vtkMTArrayInfo::Plain);
    }
  }

  // The tile's patch on an arc from the parent; the tile's own node and its four children when it is not a finest one.
  void AddTile(std::uint32_t parent, int x, int y, int side)
  {
    const bool finest = side == this->Model.TileCells;
    const int step = side / this->Model.TileCells;
    const auto sink = static_cast<std::uint32_t>(this->Graph.Nodes.size() - 1);
    const std::uint32_t node = finest ? sink : ++this->LastNode;
    const std::vector<GridTriangle> triangles = Triangulate(x, y, side, step);
    this->AddPatch(parent, node, triangles, x, y, side);
    if (finest)
    {
      return;
    }
    vtkMTNode& record = this->Graph.Nodes[node];
    record.OwnError = this->GetError(triangles) + this->Graph.Lattice.Step;
    record.EdgeLength = this->Model.Size * step / this->Model.Cells;
    record.Level = static_cast<std::uint32_t>(std::lround(std::log2(step)));
    const int half = side / 2;
    for (const GridPoint& corner : { GridPoint{ 0, 0 }, { half, 0 }, { 0, half }, { half, half } })
    {
      this->AddTile(node, x + corner[0], y + corner[1], half);
    }
  }

  // Largest vertical distance of the grid's points from the triangles.
  double GetError(const std::vector<GridTriangle>& triangles) const
  {
    double largest = 0.0;
    for (const GridTriangle& t : triangles)
    {
      const double area = this->Cross(t[0], t[1], t[2]);
      const auto range = [&t](int axis) { return std::minmax({ t[0][axis], t[1][axis], t[2][axis] }); };
      for (int j = range(1).first; j <= range(1).second; ++j)
      {
        for (int i = range(0).first; i <= range(0).second; ++i)
        {
          const GridPoint p{ i, j };
          const double a = this->Cross(p, t[1], t[2]) / area;
          const double b = this->Cross(t[0], p, t[2]) / area;
          const double c = this->Cross(t[0], t[1], p) / area;
          if (a >= 0.0 && b >= 0.0 && c >= 0.0)
          {
            const double flat = a * this->GetHeight(t[0]) + b * this->GetHeight(t[1]) + c * this->GetHeight(t[2]);
            largest = std::max(largest, std::abs(flat - this->GetHeight(p)));
          }
        }
      }
    }
    return largest;
  }

  static double Cross(const GridPoint& a, const GridPoint& b, const GridPoint& c)
  {
    return double(b[0] - a[0]) * (c[1] - a[1]) - double(b[1] - a[1]) * (c[0] - a[0]);
  }

  double GetHeight(const GridPoint& p) const
  {
    return this->Model.Size *
      MTGridModel::GetHeight(double(p[0]) / this->Model.Cells, double(p[1]) / this->Model.Cells);
  }

  void AddPatch(
    std::uint32_t from, std::uint32_t to, const std::vector<GridTriangle>& triangles, int x, int y, int side)
  {
    vtkMTPatch patch;
    std::map<GridPoint, std::uint32_t> index;
    const auto isShared = [&](const GridPoint& p)
    { return p[0] == x || p[1] == y || p[0] == x + side || p[1] == y + side; };
    std::vector<GridPoint> points;
    for (const bool shared : { true, false })
    {
      for (const GridTriangle& t : triangles)
      {
        for (const GridPoint& p : t)
        {
          if (isShared(p) == shared && index.emplace(p, static_cast<std::uint32_t>(points.size())).second)
          {
            points.push_back(p);
          }
        }
      }
      if (shared)
      {
        for (const GridPoint& p : points)
        {
          patch.Ids.push_back(static_cast<std::uint64_t>(p[1]) * (this->Model.Cells + 1) + p[0]);
        }
      }
    }
    patch.PointColumns.resize(this->Model.WithPointNormals ? 4 : 3);
    patch.CellColumns.resize(1 + (this->Model.WithCellIds ? 1 : 0) + (this->Model.WithCellNormals ? 1 : 0));
    for (const GridPoint& p : points)
    {
      this->AddPoint(patch, p);
    }
    for (const GridTriangle& t : triangles)
    {
      patch.Triangles.push_back({ index[t[0]], index[t[1]], index[t[2]] });
      this->AddCell(patch, t);
    }
    vtkMTArc arc;
    arc.From = from;
    arc.To = to;
    MTTestModel::FillRecord(patch, this->Graph.Lattice, arc);
    this->Graph.Arcs.push_back(arc);
    this->Store->WritePatch(std::move(patch));
  }

  void AddPoint(vtkMTPatch& patch, const GridPoint& p) const
  {
    const double u = double(p[0]) / this->Model.Cells;
    const double v = double(p[1]) / this->Model.Cells;
    const double world[3] = { this->Model.Corner[0] + u * this->Model.Size,
      this->Model.Corner[1] + v * this->Model.Size, this->Model.Corner[2] + this->GetHeight(p) };
    patch.Points.push_back(this->Graph.Lattice.Snap(world));
    Append<float>(patch.PointColumns[0], { static_cast<float>(MTGridModel::GetHeight(u, v)) });
    const auto byte = [](double t) { return static_cast<unsigned char>(std::lround(255.0 * t)); };
    Append<unsigned char>(patch.PointColumns[1], { byte(u), byte(v), byte(0.5), byte(0.3 + 0.7 * u) });
    Append<float>(patch.PointColumns[2], { static_cast<float>(u), static_cast<float>(v) });
    if (this->Model.WithPointNormals)
    {
      constexpr double h = 1e-4;
      const double du = (MTGridModel::GetHeight(u + h, v) - MTGridModel::GetHeight(u - h, v)) / (2.0 * h);
      const double dv = (MTGridModel::GetHeight(u, v + h) - MTGridModel::GetHeight(u, v - h)) / (2.0 * h);
      const double length = std::sqrt(1.0 + du * du + dv * dv);
      Append<float>(patch.PointColumns[3],
        { static_cast<float>(-du / length), static_cast<float>(-dv / length), static_cast<float>(1.0 / length) });
    }
  }

  void AddCell(vtkMTPatch& patch, const GridTriangle& t) const
  {
    const int n = this->Model.Cells;
    const int i = std::min((t[0][0] + t[1][0] + t[2][0]) / 3, n - 1);
    const int j = std::min((t[0][1] + t[1][1] + t[2][1]) / 3, n - 1);
    Append<int>(patch.CellColumns[0], { (i * 8 / n) + 8 * (j * 8 / n) });
    if (this->Model.WithCellIds)
    {
      Append<vtkIdType>(patch.CellColumns[1], { 2 * (vtkIdType(j) * n + i) });
    }
    if (this->Model.WithCellNormals)
    {
      const double h = this->Model.Size / n;
      const double a[3] = { h * (t[1][0] - t[0][0]), h * (t[1][1] - t[0][1]),
        this->GetHeight(t[1]) - this->GetHeight(t[0]) };
      const double b[3] = { h * (t[2][0] - t[0][0]), h * (t[2][1] - t[0][1]),
        this->GetHeight(t[2]) - this->GetHeight(t[0]) };
      const double c[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
      const double length = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
      Append<float>(patch.CellColumns.back(),
        { static_cast<float>(c[0] / length), static_cast<float>(c[1] / length), static_cast<float>(c[2] / length) });
    }
  }

  const MTGridModel& Model;
  std::shared_ptr<vtkMTPatchStore> Store;
  vtkMTGraph Graph;
  std::uint32_t LastNode = 0;
};
}

double MTGridModel::GetHeight(double u, double v)
{
  return 0.12 * std::sin(2.0 * Pi * u) * std::cos(2.0 * Pi * v) + 0.02 * std::sin(9.0 * Pi * u + 3.0) * v;
}

std::shared_ptr<vtkMTPatchStore> MTGridModel::Make() const
{
  return Maker(*this).Make();
}

vtkSmartPointer<vtkMultiTriangulation> MTGridModel::MakeData() const
{
  auto data = vtkSmartPointer<vtkMultiTriangulation>::New();
  EXPECT_TRUE(data->SetSource(this->Make()));
  return data;
}

vtkSmartPointer<vtkMultiTriangulationMapper> MTGridModel::MakeMapper(vtkPolyData* input, double pixelError)
{
  auto mapper = vtkSmartPointer<vtkMultiTriangulationMapper>::New();
  mapper->SetInputData(input);
  mapper->SetPixelError(pixelError);
  mapper->SetScalarRange(-0.15, 0.15);
  return mapper;
}
