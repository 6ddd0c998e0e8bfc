// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTIsosurfaceStream.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using Place = std::array<double, 3>;

// A point with its index in the whole isosurface; by place, of equal ones by index.
struct KnownPoint
{
  Place At;
  std::uint64_t Index;
  bool operator<(const KnownPoint& other) const
  {
    return this->At != other.At ? this->At < other.At : this->Index < other.Index;
  }
};

// A walk over the slabs, and the isosurface within the present one.
struct Walk
{
  int NextSlice = 0;
  std::uint64_t Points = 0; // of all slabs so far
  std::uint64_t Triangles = 0;
  std::vector<KnownPoint> Face; // what lies in the slice that the next slab begins with, sorted

  std::vector<Place> NewPoints; // that no slab before has
  std::vector<std::array<std::uint64_t, 3>> Corners;
  std::size_t Taken = 0; // of the new points, or of the triangles
};

class Stream : public vtkMTTriangleStream
{
public:
  Stream(std::unique_ptr<vtkMTVolumeSlabs> volume, double value, std::uint64_t samplesPerSlab)
    : Volume(std::move(volume))
    , Value(value)
    , Extent(this->Volume->GetExtent())
  {
    const std::uint64_t slice = std::uint64_t(this->Extent[1] - this->Extent[0] + 1) *
      static_cast<std::uint64_t>(this->Extent[3] - this->Extent[2] + 1);
    this->SlabSlices = static_cast<int>(std::clamp<std::uint64_t>(samplesPerSlab / slice, 1, 1 << 20));
    this->Rewind();
  }

  bool Count()
  {
    Walk walk = this->Begin();
    while (!this->IsAtEnd(walk))
    {
      if (!this->Contour(walk))
      {
        return false;
      }
    }
    this->Points = walk.Points;
    this->Triangles = walk.Triangles;
    if (this->Triangles == 0)
    {
      this->Error = "has no isosurface at " + std::to_string(this->Value) + ": its values are between " +
        std::to_string(this->Range[0]) + " and " + std::to_string(this->Range[1]);
    }
    return this->Triangles > 0;
  }

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const override { return this->Triangles; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }

  bool Rewind() override
  {
    this->OfPoints = this->Begin();
    this->OfTriangles = this->Begin();
    return true;
  }

  bool NextPoints(PointBlock& block) override
  {
    block = PointBlock();
    Walk& walk = this->OfPoints;
    if (!this->FindMore(walk, walk.NewPoints))
    {
      return false;
    }
    const std::size_t count = std::min(BlockSize, walk.NewPoints.size() - walk.Taken);
    const auto begin = walk.NewPoints.begin() + static_cast<std::ptrdiff_t>(walk.Taken);
    block.Points.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    walk.Taken += count;
    return true;
  }

  bool NextTriangles(TriangleBlock& block) override
  {
    this->OfPoints = Walk(); // its memory is needed now
    this->OfPoints.NextSlice = this->Extent[5];
    block = TriangleBlock();
    Walk& walk = this->OfTriangles;
    if (!this->FindMore(walk, walk.Corners))
    {
      return false;
    }
    const std::size_t count = std::min(BlockSize, walk.Corners.size() - walk.Taken);
    const std::uint64_t first = walk.Triangles - walk.Corners.size() + walk.Taken;
    for (std::size_t t = 0; t < count; ++t)
    {
      block.Triangles.push_back(walk.Corners[walk.Taken + t]);
      block.CellIds.push_back(static_cast<std::int64_t>(first + t));
    }
    walk.Taken += count;
    return true;
  }

private:
  static constexpr std::size_t BlockSize = 65536;

  Walk Begin() const
  {
    Walk walk;
    walk.NextSlice = this->Extent[4];
    return walk;
  }
  bool IsAtEnd(const Walk& walk) const { return walk.NextSlice >= this->Extent[5]; }

  // Goes on to slabs that have some, unless the present one still has.
  template <typename Item>
  bool FindMore(Walk& walk, const std::vector<Item>& items)
  {
    while (walk.Taken == items.size() && !this->IsAtEnd(walk))
    {
      walk.Taken = 0;
      if (!this->Contour(walk))
      {
        return false;
      }
    }
    return true;
  }

  bool Contour(Walk& walk)
  {
    const int first = walk.NextSlice;
    const int last = std::min(first + this->SlabSlices, this->Extent[5]);
    vtkNew<vtkImageData> slab;
    if (!this->Volume->Read(first, last, slab, this->Error))
    {
      return false;
    }
    double range[2];
    slab->GetPointData()->GetScalars()->GetRange(range, 0);
    this->Range = { std::min(this->Range[0], range[0]), std::max(this->Range[1], range[1]) };
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(slab);
    contour->SetValue(0, this->Value);
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    this->Take(contour->GetOutput(), slab, { first, last }, walk);
    walk.NextSlice = last;
    return true;
  }

  // Numbers the slab's points and takes its triangles.
  static void Take(vtkPolyData* mesh, vtkImageData* slab, const std::array<int, 2>& slices, Walk& walk)
  {
    std::vector<std::uint64_t> index(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    std::vector<KnownPoint> face;
    walk.NewPoints.clear();
    for (std::size_t p = 0; p < index.size(); ++p)
    {
      Place at;
      mesh->GetPoint(static_cast<vtkIdType>(p), at.data());
      double place[3];
      slab->TransformPhysicalPointToContinuousIndex(at.data(), place);
      index[p] = std::abs(place[2] - slices[0]) < 0.5 ? FindKnown(walk.Face, at) : None;
      if (index[p] == None)
      {
        index[p] = walk.Points++;
        walk.NewPoints.push_back(at);
      }
      if (std::abs(place[2] - slices[1]) < 0.5)
      {
        face.push_back({ at, index[p] });
      }
    }
    std::sort(face.begin(), face.end());
    walk.Face = std::move(face);
    walk.Corners.clear();
    vtkNew<vtkIdList> corners;
    for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
    {
      mesh->GetPolys()->GetCellAtId(t, corners);
      const auto get = [&](vtkIdType c) { return index[static_cast<std::size_t>(corners->GetId(c))]; };
      walk.Corners.push_back({ get(0), get(1), get(2) });
    }
    walk.Triangles += walk.Corners.size();
  }

  static std::uint64_t FindKnown(const std::vector<KnownPoint>& known, const Place& at)
  {
    const auto found = std::lower_bound(known.begin(), known.end(), KnownPoint{ at, 0 });
    return found != known.end() && found->At == at ? found->Index : None;
  }

  static constexpr std::uint64_t None = ~std::uint64_t(0);

  std::unique_ptr<vtkMTVolumeSlabs> Volume;
  double Value;
  std::array<int, 6> Extent;
  std::array<double, 2> Range{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  int SlabSlices = 1;
  std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  Walk OfPoints;
  Walk OfTriangles;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTIsosurfaceStream::Open(
  std::unique_ptr<vtkMTVolumeSlabs> volume, double value, std::string& error, std::uint64_t samplesPerSlab)
{
  auto stream = std::make_unique<Stream>(std::move(volume), value, samplesPerSlab);
  if (!stream->Count())
  {
    error = stream->GetError();
    return nullptr;
  }
  return stream;
}
