// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTAttributeTransfer.h"

#include "vtkMTLinearFit.h"
#include "vtkMTSimplifier.h"
#include "vtkMTSurface.h"
#include "vtkMTTriangleTree.h"
#include "vtkMTVector.h"

#include "vtkDataSetAttributes.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

using namespace vtkMTVector;

namespace
{
using Hit = vtkMTSurface::Hit;

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
      // A value that is not a number must not get to a corner with weight 0.
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

// Made normals are made again; until then points have those of the points that they come from.
bool IsTakenFromPlaces(const vtkMTArrayInfo& info)
{
  return !info.IsFinestOnly() && info.Role != vtkMTArrayInfo::MadeNormals;
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
      if (hit.Triangle == Hit::None || !IsTakenFromPlaces(info))
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

// Values of points that have a mean: what was taken at the places of the fragment's points is fitted to all of the
// floor.
class PointFit
{
public:
  explicit PointFit(const vtkMTAttributeTransfer::Meshes& meshes, std::size_t sharedPoints)
    : Meshes(meshes)
    , SharedPoints(sharedPoints)
  {
  }

  static bool IsFor(const vtkMTArrayInfo& info)
  {
    return info.Resampling == vtkMTArrayInfo::Interpolate && !info.IsFinestOnly() &&
      info.Attribute != vtkDataSetAttributes::TCOORDS;
  }

  void Run(const vtkMTArrayInfo& info, const vtkMTColumn& from, vtkMTColumn& to)
  {
    if (!this->Fit)
    {
      this->MakeSamples();
    }
    switch (info.Type)
    {
      vtkTemplateMacro(this->FitColumn<VTK_TT>(info, from, to));
    }
  }

private:
  // The middle of a floor's edge, as two of its wedges.
  using Middle = std::array<std::uint32_t, 2>;

  // Shared points keep their values, as their neighbours do; so do those of seams, which have one on each side.
  std::vector<unsigned char> FindFreeWedges() const
  {
    const vtkMTSimplification& mesh = this->Meshes.Simplification;
    std::vector<std::uint32_t> wedges(mesh.Points.size(), 0);
    for (const std::uint32_t p : mesh.WedgePoints)
    {
      ++wedges[p];
    }
    std::vector<unsigned char> isFree(mesh.WedgePoints.size());
    for (std::size_t w = 0; w < isFree.size(); ++w)
    {
      const std::uint32_t p = mesh.WedgePoints[w];
      isFree[w] = p >= this->SharedPoints && wedges[p] == 1 ? 1 : 0;
    }
    return isFree;
  }

  // Middles of edges integrate what is linear over both meshes' triangles exactly where these are the same.
  void MakeSamples()
  {
    const vtkMTSurface& floor = this->Meshes.FloorSurface;
    const vtkMTSurface& fragment = this->Meshes.FragmentSurface;
    std::vector<vtkMTLinearFit::Sample> samples;
    for (std::uint32_t t = 0; t < floor.GetNumberOfTriangles(); ++t)
    {
      const Vector& a = floor.GetCorner(t, 0);
      const double area = Norm(Cross(Subtract(floor.GetCorner(t, 1), a), Subtract(floor.GetCorner(t, 2), a)));
      const std::uint32_t near = this->FindNear(t);
      for (int c = 0; c < 3 && near != Hit::None && area > 0.0; ++c)
      {
        const Vector x = Lerp(floor.GetCorner(t, c), floor.GetCorner(t, (c + 1) % 3), 0.5);
        Hit hit = fragment.Project(x, near);
        fragment.Descend(x, hit);
        if (Dot(fragment.GetNormal(hit.Triangle), floor.GetNormal(t)) > 0.0)
        {
          const vtkMTTriangle& wedges = this->Meshes.Floor.Triangles[t];
          this->Middles.push_back({ wedges[c], wedges[(c + 1) % 3] });
          samples.push_back({ this->Meshes.Simplification.Triangles[hit.Triangle], hit.Weights, area });
        }
      }
    }
    this->Fit.emplace(this->FindFreeWedges(), std::move(samples));
  }

  // A triangle of the fragment that one of the corners went to.
  std::uint32_t FindNear(std::uint32_t t) const
  {
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
    {
      const std::uint32_t place = this->Meshes.Findings.Places[this->Meshes.FloorSurface.GetPoint(h)];
      if (place != Hit::None)
      {
        return place;
      }
    }
    return Hit::None;
  }

  template <class Value>
  static Value Get(const vtkMTColumn& column, std::size_t i)
  {
    Value value;
    std::memcpy(&value, column.data() + i * sizeof(Value), sizeof(Value));
    return value;
  }

  template <class Value>
  void FitColumn(const vtkMTArrayInfo& info, const vtkMTColumn& from, vtkMTColumn& to)
  {
    const auto components = static_cast<std::size_t>(info.Components);
    std::vector<vtkMTLinearFit::Value> ofSamples(this->Middles.size());
    std::vector<double> values(to.size() / (components * sizeof(Value)));
    for (std::size_t i = 0; i < components; ++i)
    {
      for (std::size_t s = 0; s < ofSamples.size(); ++s)
      {
        const auto [a, b] = this->Middles[s];
        const auto atA = static_cast<double>(Get<Value>(from, a * components + i));
        const auto atB = static_cast<double>(Get<Value>(from, b * components + i));
        ofSamples[s] = { 0.5 * atA + 0.5 * atB, std::min(atA, atB), std::max(atA, atB) };
      }
      for (std::size_t w = 0; w < values.size(); ++w)
      {
        values[w] = static_cast<double>(Get<Value>(to, w * components + i));
      }
      if (!std::all_of(ofSamples.begin(), ofSamples.end(),
            [](const vtkMTLinearFit::Value& value) { return std::isfinite(value.Mean); }) ||
        !std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
      {
        continue; // what was taken at the points stays
      }
      this->Fit->Solve(ofSamples, values);
      for (std::size_t w = 0; w < values.size(); ++w)
      {
        const auto value = FromDouble<Value>(values[w]);
        std::memcpy(to.data() + (w * components + i) * sizeof(Value), &value, sizeof(Value));
      }
    }
  }

  const vtkMTAttributeTransfer::Meshes& Meshes;
  const std::size_t SharedPoints;
  std::optional<vtkMTLinearFit> Fit;
  std::vector<Middle> Middles; // [samples]
};

// Finds places on the floor for those of the fragment.
class Locator
{
public:
  explicit Locator(const vtkMTAttributeTransfer::Meshes& meshes)
    : Meshes(meshes)
    , Floor(meshes.FloorSurface)
    , Fragment(meshes.FragmentSurface)
    , Tree(meshes.FloorSurface, vtkMTTriangleTree::GetEnoughEffort(meshes.FloorSurface))
  {
  }

  // For every moved point where on the floor its values are; None for the others.
  std::vector<Hit> LocateMovedPoints()
  {
    const vtkMTSimplification& mesh = this->Meshes.Simplification;
    std::vector<unsigned char> wedgeCount(mesh.Points.size(), 0);
    for (std::uint32_t p : mesh.WedgePoints)
    {
      wedgeCount[p] = static_cast<unsigned char>(std::min(wedgeCount[p] + 1, 2));
    }
    const std::vector<Vector> normals = this->GetPointNormals();
    std::vector<Hit> hits(mesh.Points.size());
    for (std::uint32_t p = 0; p < hits.size(); ++p)
    {
      // A seam's point has one set of values per side: the nearest place would know one of them only.
      if (mesh.Moved[p] && wedgeCount[p] == 1)
      {
        const std::uint32_t out = this->Fragment.GetHalfedge(p);
        hits[p] = this->Find(this->Fragment.GetPlace(out), normals[p], out / 3);
      }
    }
    return hits;
  }

  std::vector<std::uint32_t> LocateTriangles()
  {
    std::vector<std::uint32_t> nearest(this->Fragment.GetNumberOfTriangles());
    for (std::uint32_t t = 0; t < nearest.size(); ++t)
    {
      const Vector sum =
        Add(Add(this->Fragment.GetCorner(t, 0), this->Fragment.GetCorner(t, 1)), this->Fragment.GetCorner(t, 2));
      nearest[t] = this->Find(Scale(sum, 1.0 / 3.0), this->Fragment.GetNormal(t), t).Triangle;
    }
    return nearest;
  }

private:
  std::vector<Vector> GetPointNormals() const
  {
    std::vector<Vector> normals(this->Fragment.GetNumberOfPoints(), Vector{ 0.0, 0.0, 0.0 });
    for (std::uint32_t t = 0; t < this->Fragment.GetNumberOfTriangles(); ++t)
    {
      const Vector& corner = this->Fragment.GetCorner(t, 0);
      const Vector normal =
        Cross(Subtract(this->Fragment.GetCorner(t, 1), corner), Subtract(this->Fragment.GetCorner(t, 2), corner));
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        Vector& sum = normals[this->Fragment.GetPoint(3 * t + c)];
        sum = Add(sum, normal);
      }
    }
    return normals;
  }

  // x is a place on the fragment's triangle.
  Hit Find(const Vector& x, const Vector& direction, std::uint32_t triangle)
  {
    // A step of the lattice more: what is certified as zero is not computed as zero.
    const double farthest = this->Meshes.Findings.Deviations[triangle].ToInput + 1.0;
    const auto isThere = [&](const Hit& hit)
    { return hit.Distance2 <= farthest * farthest && Dot(this->Floor.GetNormal(hit.Triangle), direction) > 0.0; };
    const std::uint32_t guess = this->Meshes.Findings.FloorTriangle[triangle];
    if (guess != Hit::None)
    {
      Hit hit = this->Floor.Project(x, guess);
      this->Floor.Descend(x, hit);
      if (isThere(hit))
      {
        return hit;
      }
    }
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
    {
      const std::uint32_t origin = this->Meshes.Simplification.PointOrigin[this->Fragment.GetPoint(h)];
      if (this->Floor.IsHub(origin))
      {
        continue;
      }
      const Hit hit = this->Floor.FindAround(x, this->Floor.GetHalfedge(origin));
      if (isThere(hit))
      {
        return hit;
      }
    }
    const Hit facing = this->Tree.FindNearestFacing(x, direction);
    return facing.Triangle != Hit::None ? facing : this->Tree.FindNearest(x);
  }

  const vtkMTAttributeTransfer::Meshes& Meshes;
  const vtkMTSurface& Floor;
  const vtkMTSurface& Fragment;
  vtkMTTriangleTree Tree;
};

// Values of triangles.
void TakeNearest(const vtkMTColumn& from, std::size_t size, const std::vector<std::uint32_t>& nearest, vtkMTColumn& to)
{
  to.resize(nearest.size() * size);
  for (std::size_t t = 0; t < nearest.size(); ++t)
  {
    std::memcpy(to.data() + t * size, from.data() + nearest[t] * size, size);
  }
}
}

void vtkMTAttributeTransfer::Run(const Meshes& meshes, const std::vector<vtkMTArrayInfo>& arrays, vtkMTPatch& fragment)
{
  const vtkMTPatch& floor = meshes.Floor;
  Locator locator(meshes);
  fragment.PointColumns.assign(floor.PointColumns.size(), {});
  fragment.CellColumns.assign(floor.CellColumns.size(), {});
  // Looking for places takes most of the time, and many meshes have nothing but what follows from the triangles.
  const auto isSomeOf = [&](vtkMTArrayInfo::AssociationType association)
  {
    return std::any_of(arrays.begin(), arrays.end(),
      [&](const vtkMTArrayInfo& info) { return info.Association == association && IsTakenFromPlaces(info); });
  };
  const std::vector<Hit> hits =
    isSomeOf(vtkMTArrayInfo::Point) ? locator.LocateMovedPoints() : std::vector<Hit>(fragment.Points.size());
  const std::vector<std::uint32_t> nearest =
    isSomeOf(vtkMTArrayInfo::Cell) ? locator.LocateTriangles() : std::vector<std::uint32_t>();
  const PointTransfer transfer(floor, hits, meshes.Simplification);
  PointFit fit(meshes, fragment.Ids.size());
  std::size_t pointArray = 0;
  std::size_t cellArray = 0;
  for (const vtkMTArrayInfo& info : arrays)
  {
    if (info.Association == vtkMTArrayInfo::Point)
    {
      if (!info.IsFinestOnly())
      {
        transfer.Run(info, floor.PointColumns[pointArray], fragment.PointColumns[pointArray]);
      }
      if (PointFit::IsFor(info))
      {
        fit.Run(info, floor.PointColumns[pointArray], fragment.PointColumns[pointArray]);
      }
      ++pointArray;
      continue;
    }
    if (!info.IsFinestOnly())
    {
      TakeNearest(floor.CellColumns[cellArray], info.GetTupleSize(), nearest, fragment.CellColumns[cellArray]);
    }
    ++cellArray;
  }
}
