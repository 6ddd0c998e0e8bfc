// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTAttributeTransfer.h"

#include "vtkMTSimplifier.h"
#include "vtkMTTriangleTree.h"
#include "vtkMTVector.h"

#include "vtkSetGet.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

using namespace vtkMTVector;

namespace
{
using Hit = vtkMTTriangleTree::Hit;

Vector ToVector(const vtkMTPoint& k, const vtkMTPoint& origin)
{
  return { static_cast<double>(k[0]) - static_cast<double>(origin[0]),
    static_cast<double>(k[1]) - static_cast<double>(origin[1]),
    static_cast<double>(k[2]) - static_cast<double>(origin[2]) };
}

Hit FindOnFloor(const vtkMTTriangleTree& tree, const Vector& x, const Vector& direction)
{
  const Hit facing = tree.FindNearestFacing(x, direction);
  return facing.Triangle != Hit::None ? facing : tree.FindNearest(x);
}

template <class Value>
Value FromDouble(double value)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    return static_cast<Value>(value);
  }
  else
  {
    // A weighted mean of values of the type: rounding is all that can leave its range.
    const double low = static_cast<double>(std::numeric_limits<Value>::lowest());
    const double high = static_cast<double>(std::numeric_limits<Value>::max());
    const double rounded = std::nearbyint(value);
    return rounded <= low ? std::numeric_limits<Value>::lowest()
                          : (rounded >= high ? std::numeric_limits<Value>::max() : static_cast<Value>(rounded));
  }
}

// One tuple as the weighted mean of three.
template <class Value>
void Interpolate(const unsigned char* column, const std::array<std::uint32_t, 3>& wedges, const Vector& weights,
  int components, bool isDirection, unsigned char* output)
{
  const std::size_t size = components * sizeof(Value);
  std::array<double, 3> direction{ 0.0, 0.0, 0.0 };
  for (int i = 0; i < components; ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      Value value;
      std::memcpy(&value, column + wedges[c] * size + i * sizeof(Value), sizeof(Value));
      // A value that is not a number must not reach a corner with weight 0.
      sum += weights[c] != 0.0 ? weights[c] * static_cast<double>(value) : 0.0;
    }
    if (isDirection && i < 3)
    {
      direction[i] = sum;
    }
    const Value result = FromDouble<Value>(sum);
    std::memcpy(output + i * sizeof(Value), &result, sizeof(Value));
  }
  const double length = Norm(direction);
  if (isDirection && components == 3 && length > 0.0 && std::is_floating_point_v<Value>)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Value result = FromDouble<Value>(direction[i] / length);
      std::memcpy(output + i * sizeof(Value), &result, sizeof(Value));
    }
  }
}

class PointTransfer
{
public:
  PointTransfer(const vtkMTPatch& floor, const std::vector<Hit>& hits, const vtkMTSimplification& simplification)
    : Floor(floor)
    , Hits(hits)
    , Simplification(simplification)
  {
  }

  void Run(const vtkMTArrayInfo& info, const vtkMTColumn& from, vtkMTColumn& to) const
  {
    const std::size_t size = info.GetTupleSize();
    const std::size_t wedges = this->Simplification.WedgeOrigin.size();
    to.resize(wedges * size);
    for (std::size_t w = 0; w < wedges; ++w)
    {
      const Hit& hit = this->Hits[this->Simplification.WedgePoints[w]];
      unsigned char* output = to.data() + w * size;
      if (hit.Triangle == Hit::None)
      {
        std::memcpy(output, from.data() + this->Simplification.WedgeOrigin[w] * size, size);
      }
      else
      {
        this->Resample(info, from, hit, output);
      }
    }
  }

private:
  void Resample(const vtkMTArrayInfo& info, const vtkMTColumn& from, const Hit& hit, unsigned char* output) const
  {
    const vtkMTTriangle& wedges = this->Floor.Triangles[hit.Triangle];
    if (info.Resampling == vtkMTArrayInfo::Nearest)
    {
      const std::size_t size = info.GetTupleSize();
      const auto largest = std::max_element(hit.Weights.begin(), hit.Weights.end()) - hit.Weights.begin();
      std::memcpy(output, from.data() + wedges[largest] * size, size);
      return;
    }
    const bool isDirection = info.Resampling == vtkMTArrayInfo::Direction;
    switch (info.Type)
    {
      vtkTemplateMacro(Interpolate<VTK_TT>(from.data(), wedges, hit.Weights, info.Components, isDirection, output));
    }
  }

  const vtkMTPatch& Floor;
  const std::vector<Hit>& Hits;
  const vtkMTSimplification& Simplification;
};

// For every moved point where on the floor its values are; None for the others.
std::vector<Hit> LocateMovedPoints(
  const vtkMTTriangleTree& floorTree, const vtkMTPoint& origin, const vtkMTSimplification& simplification)
{
  const std::size_t points = simplification.Points.size();
  std::vector<Vector> normals(points, Vector{ 0.0, 0.0, 0.0 });
  std::vector<unsigned char> wedgeCount(points, 0);
  for (std::uint32_t p : simplification.WedgePoints)
  {
    wedgeCount[p] = static_cast<unsigned char>(std::min(wedgeCount[p] + 1, 2));
  }
  for (const vtkMTTriangle& t : simplification.Triangles)
  {
    std::array<std::uint32_t, 3> p;
    std::array<Vector, 3> x;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = simplification.WedgePoints[t[c]];
      x[c] = ToVector(simplification.Points[p[c]], origin);
    }
    const Vector normal = Cross(Subtract(x[1], x[0]), Subtract(x[2], x[0]));
    for (std::uint32_t point : p)
    {
      normals[point] = Add(normals[point], normal);
    }
  }
  std::vector<Hit> hits(points);
  for (std::size_t p = 0; p < points; ++p)
  {
    // A seam's point has one set of values per side: the nearest place would know one of them only.
    if (simplification.Moved[p] && wedgeCount[p] == 1)
    {
      hits[p] = FindOnFloor(floorTree, ToVector(simplification.Points[p], origin), normals[p]);
    }
  }
  return hits;
}

std::vector<std::uint32_t> LocateTriangles(
  const vtkMTTriangleTree& floorTree, const vtkMTPoint& origin, const vtkMTPatch& fragment)
{
  std::vector<std::uint32_t> nearest(fragment.Triangles.size());
  for (std::size_t t = 0; t < nearest.size(); ++t)
  {
    const vtkMTTriangle p = fragment.GetPointsOfTriangle(t);
    const std::array<Vector, 3> x{ ToVector(fragment.Points[p[0]], origin), ToVector(fragment.Points[p[1]], origin),
      ToVector(fragment.Points[p[2]], origin) };
    const Vector barycentre = Scale(Add(Add(x[0], x[1]), x[2]), 1.0 / 3.0);
    const Vector normal = Cross(Subtract(x[1], x[0]), Subtract(x[2], x[0]));
    nearest[t] = FindOnFloor(floorTree, barycentre, normal).Triangle;
  }
  return nearest;
}
}

void vtkMTAttributeTransfer::Run(const vtkMTPatch& floor, const vtkMTTriangleTree& floorTree, const vtkMTPoint& origin,
  const vtkMTSimplification& simplification, const std::vector<vtkMTArrayInfo>& arrays, vtkMTPatch& fragment)
{
  fragment.PointColumns.assign(floor.PointColumns.size(), {});
  fragment.CellColumns.assign(floor.CellColumns.size(), {});
  std::vector<Hit> hits;
  if (!floor.PointColumns.empty())
  {
    hits = LocateMovedPoints(floorTree, origin, simplification);
  }
  const PointTransfer transfer(floor, hits, simplification);
  const std::vector<std::uint32_t> nearest = LocateTriangles(floorTree, origin, fragment);
  std::size_t pointArray = 0;
  std::size_t cellArray = 0;
  for (const vtkMTArrayInfo& info : arrays)
  {
    if (info.Association == vtkMTArrayInfo::Point)
    {
      transfer.Run(info, floor.PointColumns[pointArray], fragment.PointColumns[pointArray]);
      ++pointArray;
      continue;
    }
    const std::size_t size = info.GetTupleSize();
    vtkMTColumn& to = fragment.CellColumns[cellArray];
    to.resize(nearest.size() * size);
    for (std::size_t t = 0; t < nearest.size(); ++t)
    {
      std::memcpy(to.data() + t * size, floor.CellColumns[cellArray].data() + nearest[t] * size, size);
    }
    ++cellArray;
  }
}
