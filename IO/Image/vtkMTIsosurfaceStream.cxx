// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTIsosurfaceStream.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using Place = vtkMTVolumePlace::Vector;

// Flying edges subtract samples in their own type, where a difference of unsigned int wraps around and one of int may
// overflow (VTK 9.1): such samples become double.
void MakeSubtractable(vtkImageData* slab)
{
  vtkDataArray* const samples = slab->GetPointData()->GetScalars();
  const int type = samples ? samples->GetDataType() : VTK_DOUBLE;
  if (type == VTK_FLOAT || type == VTK_DOUBLE || samples->GetDataTypeSize() < 4)
  {
    return;
  }
  vtkNew<vtkDoubleArray> safe;
  safe->DeepCopy(samples);
  slab->GetPointData()->SetScalars(safe);
}

void Contour(vtkImageData* slab, double value, bool gradientNormals, vtkPolyData* mesh)
{
  MakeSubtractable(slab);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(slab);
  contour->SetValue(0, value);
  contour->SetComputeNormals(gradientNormals);
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  mesh->ShallowCopy(contour->GetOutput());
}

std::string DescribeNone(double value, double least, double most)
{
  return "has no isosurface at " + std::to_string(value) + ": its values are between " + std::to_string(least) +
    " and " + std::to_string(most);
}

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
    , IsTurned(this->Volume->GetPlace().IsLeftHanded())
    , Report(this->Volume->GetReport())
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
    if (this->IsTurned)
    {
      this->Report["turned_triangles"] = static_cast<std::int64_t>(this->Triangles);
    }
    if (this->Triangles == 0)
    {
      this->Error = DescribeNone(this->Value, this->Range[0], this->Range[1]);
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
    vtkNew<vtkPolyData> mesh;
    ::Contour(slab, this->Value, false, mesh);
    this->Take(mesh, { first, last }, walk);
    walk.NextSlice = last;
    return true;
  }

  // Numbers the slab's points and takes its triangles.
  void Take(vtkPolyData* mesh, const std::array<int, 2>& slices, Walk& walk) const
  {
    std::vector<std::uint64_t> index(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    std::vector<KnownPoint> face;
    walk.NewPoints.clear();
    for (std::size_t p = 0; p < index.size(); ++p)
    {
      Place at;
      mesh->GetPoint(static_cast<vtkIdType>(p), at.data());
      index[p] = at[2] == slices[0] ? FindKnown(walk.Face, at) : None;
      if (index[p] == None)
      {
        index[p] = walk.Points++;
        walk.NewPoints.push_back(this->Volume->GetPlace().ToWorld(at));
      }
      if (at[2] == slices[1])
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
      walk.Corners.push_back({ get(0), get(this->IsTurned ? 2 : 1), get(this->IsTurned ? 1 : 2) });
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
  bool IsTurned;
  std::map<std::string, std::int64_t> Report;
  std::array<double, 2> Range{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  int SlabSlices = 1;
  std::vector<vtkMTArrayInfo> Arrays;
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

namespace
{
void TakeToWorld(const vtkMTVolumePlace& place, vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    Place at;
    mesh->GetPoint(p, at.data());
    points->SetPoint(p, place.ToWorld(at).data());
    if (normals)
    {
      normals->GetTuple(p, at.data());
      normals->SetTuple(p, place.TurnNormal(at).data());
    }
  }
  mesh->SetPoints(points);
  for (vtkIdType t = 0; place.IsLeftHanded() && t < mesh->GetNumberOfPolys(); ++t)
  {
    vtkIdType corners[3];
    vtkIdType size = 0;
    const vtkIdType* there = nullptr;
    mesh->GetPolys()->GetCellAtId(t, size, there);
    std::copy_n(there, 3, corners);
    std::swap(corners[1], corners[2]);
    mesh->GetPolys()->ReplaceCellAtId(t, 3, corners);
  }
}
}

bool vtkMTIsosurfaceStream::Make(
  vtkMTVolumeSlabs& volume, double value, bool gradientNormals, vtkPolyData* output, std::string& error)
{
  vtkNew<vtkImageData> all;
  if (!volume.Read(volume.GetExtent()[4], volume.GetExtent()[5], all, error))
  {
    return false;
  }
  ::Contour(all, value, gradientNormals, output);
  if (output->GetNumberOfPolys() == 0)
  {
    double range[2];
    all->GetPointData()->GetScalars()->GetRange(range, 0);
    error = DescribeNone(value, range[0], range[1]);
    return false;
  }
  TakeToWorld(volume.GetPlace(), output);
  return true;
}
