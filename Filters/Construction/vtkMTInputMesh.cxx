// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputMesh.h"

#include "vtkMTFarOutliers.h"
#include "vtkMTOrientation.h"
#include "vtkMTPointNormals.h"
#include "vtkMTStitch.h"
#include "vtkMTTriangleStream.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace
{
using WorldPoint = std::array<double, 3>;
using Indices = std::array<std::uint32_t, 3>;
constexpr std::uint32_t None = ~std::uint32_t(0);

void Append(vtkMTColumn& column, const vtkMTColumn& more)
{
  column.insert(column.end(), more.begin(), more.end());
}

// Everything that the stream says, with the triangles that are no triangles left out.
class Loader
{
public:
  Loader(vtkMTTriangleStream& stream, vtkMTInputMesh& result)
    : Stream(stream)
    , Result(result)
  {
  }

  bool Load(std::string& error)
  {
    this->SetUpColumns();
    if (this->Stream.GetNumberOfPoints() >= None)
    {
      error = "the input has more points than the 4294967294 that are supported";
      return false;
    }
    if (!this->Stream.Rewind() || !this->LoadPoints() || !this->LoadTriangles())
    {
      error = this->Stream.GetError();
      return false;
    }
    return true;
  }

  // Takes these triangles, in ascending order, out again.
  void RemoveTriangles(const std::vector<std::uint32_t>& which)
  {
    for (std::size_t i = 0; i < this->CellColumns.size(); ++i)
    {
      RemoveTuples(this->CellColumns[i], this->CellTupleSizes[i], which);
    }
    auto next = which.begin();
    std::size_t kept = 0;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      if (next != which.end() && *next == t)
      {
        ++next;
      }
      else
      {
        this->Triangles[kept++] = this->Triangles[t];
      }
    }
    this->Triangles.resize(kept);
  }

  std::vector<WorldPoint> Points;
  std::vector<vtkMTColumn> PointColumns;
  std::vector<Indices> Triangles;
  std::vector<vtkMTColumn> CellColumns; // the last one holds the input cell ids

private:
  static void RemoveTuples(vtkMTColumn& column, std::size_t size, const std::vector<std::uint32_t>& which)
  {
    auto next = which.begin();
    std::size_t kept = 0;
    for (std::size_t t = 0; t * size < column.size(); ++t)
    {
      if (next != which.end() && *next == t)
      {
        ++next;
      }
      else
      {
        std::copy_n(column.begin() + static_cast<std::ptrdiff_t>(t * size), size,
          column.begin() + static_cast<std::ptrdiff_t>(kept++ * size));
      }
    }
    column.resize(kept * size);
  }

  void SetUpColumns()
  {
    for (const vtkMTArrayInfo& info : this->Stream.GetArrays())
    {
      (info.Association == vtkMTArrayInfo::Point ? this->PointColumns : this->CellColumns).emplace_back();
      if (info.Association == vtkMTArrayInfo::Cell)
      {
        this->CellTupleSizes.push_back(info.GetTupleSize());
      }
    }
    this->CellColumns.emplace_back();
    this->CellTupleSizes.push_back(sizeof(vtkIdType));
  }

  bool LoadPoints()
  {
    this->Points.reserve(this->Stream.GetNumberOfPoints());
    vtkMTTriangleStream::PointBlock block;
    while (this->Stream.NextPoints(block))
    {
      if (block.Points.empty())
      {
        return true;
      }
      for (WorldPoint x : block.Points)
      {
        for (double& coordinate : x)
        {
          coordinate += 0.0; // minus zero is zero: the same place
        }
        this->Points.push_back(x);
      }
      for (std::size_t i = 0; i < this->PointColumns.size(); ++i)
      {
        Append(this->PointColumns[i], block.Columns[i]);
      }
    }
    return false;
  }

  bool LoadTriangles()
  {
    this->Triangles.reserve(this->Stream.GetNumberOfTriangles());
    vtkMTTriangleStream::TriangleBlock block;
    while (this->Stream.NextTriangles(block))
    {
      if (block.Triangles.empty())
      {
        return true;
      }
      this->Result.InputTriangles += block.Triangles.size();
      for (std::size_t t = 0; t < block.Triangles.size(); ++t)
      {
        if (const char* reason = this->FindFault(block.Triangles[t]))
        {
          ++this->Result.Report[reason];
        }
        else
        {
          this->KeepTriangle(block, t);
        }
      }
    }
    return false;
  }

  const char* FindFault(const std::array<std::uint64_t, 3>& t) const
  {
    for (std::uint64_t p : t)
    {
      if (p >= this->Points.size())
      {
        return "dropped_index_out_of_range";
      }
    }
    for (std::uint64_t p : t)
    {
      const WorldPoint& x = this->Points[p];
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return "dropped_not_finite";
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      if (this->Points[t[c]] == this->Points[t[(c + 1) % 3]])
      {
        return "dropped_degenerate";
      }
    }
    return nullptr;
  }

  void KeepTriangle(const vtkMTTriangleStream::TriangleBlock& block, std::size_t t)
  {
    const auto& indices = block.Triangles[t];
    this->Triangles.push_back({ static_cast<std::uint32_t>(indices[0]), static_cast<std::uint32_t>(indices[1]),
      static_cast<std::uint32_t>(indices[2]) });
    for (std::size_t i = 0; i + 1 < this->CellColumns.size(); ++i)
    {
      const auto tuple = block.Columns[i].begin() + static_cast<std::ptrdiff_t>(t * this->CellTupleSizes[i]);
      this->CellColumns[i].insert(
        this->CellColumns[i].end(), tuple, tuple + static_cast<std::ptrdiff_t>(this->CellTupleSizes[i]));
    }
    const vtkIdType id = block.CellIds[t];
    const auto* bytes = reinterpret_cast<const unsigned char*>(&id);
    this->CellColumns.back().insert(this->CellColumns.back().end(), bytes, bytes + sizeof(id));
  }

  vtkMTTriangleStream& Stream;
  vtkMTInputMesh& Result;
  std::vector<std::size_t> CellTupleSizes;
};

// Makes points and wedges of the input's points: wedges of one point are those with the same root.
class WedgeMaker
{
public:
  WedgeMaker(const Loader& input, const std::vector<std::uint32_t>& root, std::vector<std::size_t> tupleSizes)
    : Input(input)
    , Root(root)
    , TupleSizes(std::move(tupleSizes))
  {
  }

  // Fills points' places later: gives, for each new point, the input point that stands for it.
  std::vector<std::uint32_t> Run(vtkMTPatch& mesh)
  {
    const std::size_t count = this->Input.Points.size();
    std::vector<unsigned char> used(count, 0);
    for (const Indices& t : this->Input.Triangles)
    {
      used[t[0]] = used[t[1]] = used[t[2]] = 1;
    }
    this->SortByRoot(used);
    std::vector<std::uint32_t> wedgeOf(count, None);
    std::vector<std::uint32_t> representatives;
    std::vector<std::uint32_t> wedgeInput; // per wedge the input point that gives its values
    for (std::size_t begin = 0; begin < this->Sorted.size();)
    {
      const std::uint32_t root = this->Root[this->Sorted[begin]];
      const std::size_t firstWedge = wedgeInput.size();
      for (; begin < this->Sorted.size() && this->Root[this->Sorted[begin]] == root; ++begin)
      {
        const std::uint32_t p = this->Sorted[begin];
        std::size_t w = firstWedge;
        while (w < wedgeInput.size() && !this->AreValuesEqual(wedgeInput[w], p))
        {
          ++w;
        }
        if (w == wedgeInput.size())
        {
          wedgeInput.push_back(p);
          mesh.WedgePoints.push_back(static_cast<std::uint32_t>(representatives.size()));
        }
        wedgeOf[p] = static_cast<std::uint32_t>(w);
      }
      representatives.push_back(root);
    }
    if (mesh.WedgePoints.size() == representatives.size())
    {
      mesh.WedgePoints.clear();
    }
    this->CopyValues(wedgeInput, mesh);
    mesh.Triangles.reserve(this->Input.Triangles.size());
    for (const Indices& t : this->Input.Triangles)
    {
      mesh.Triangles.push_back({ wedgeOf[t[0]], wedgeOf[t[1]], wedgeOf[t[2]] });
    }
    return representatives;
  }

private:
  // Used points in order of root, then index.
  void SortByRoot(const std::vector<unsigned char>& used)
  {
    for (std::uint32_t p = 0; p < used.size(); ++p)
    {
      if (used[p])
      {
        this->Sorted.push_back(p);
      }
    }
    std::stable_sort(this->Sorted.begin(), this->Sorted.end(),
      [this](std::uint32_t a, std::uint32_t b) { return this->Root[a] < this->Root[b]; });
  }

  bool AreValuesEqual(std::uint32_t a, std::uint32_t b) const
  {
    for (std::size_t i = 0; i < this->TupleSizes.size(); ++i)
    {
      const unsigned char* values = this->Input.PointColumns[i].data();
      if (std::memcmp(values + a * this->TupleSizes[i], values + b * this->TupleSizes[i], this->TupleSizes[i]) != 0)
      {
        return false;
      }
    }
    return true;
  }

  void CopyValues(const std::vector<std::uint32_t>& wedgeInput, vtkMTPatch& mesh) const
  {
    mesh.PointColumns.resize(this->TupleSizes.size());
    for (std::size_t i = 0; i < this->TupleSizes.size(); ++i)
    {
      const std::size_t size = this->TupleSizes[i];
      mesh.PointColumns[i].resize(wedgeInput.size() * size);
      for (std::size_t w = 0; w < wedgeInput.size(); ++w)
      {
        std::memcpy(
          mesh.PointColumns[i].data() + w * size, this->Input.PointColumns[i].data() + wedgeInput[w] * size, size);
      }
    }
  }

  const Loader& Input;
  const std::vector<std::uint32_t>& Root;
  const std::vector<std::size_t> TupleSizes;
  std::vector<std::uint32_t> Sorted;
};

// The lattice for the used points, and these snapped to it.
void Snap(const std::vector<WorldPoint>& points, const std::vector<std::uint32_t>& representatives, int bits,
  vtkMTInputMesh& result)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  double bounds[6] = { inf, -inf, inf, -inf, inf, -inf };
  for (std::uint32_t p : representatives)
  {
    for (int i = 0; i < 3; ++i)
    {
      bounds[2 * i] = std::min(bounds[2 * i], points[p][i]);
      bounds[2 * i + 1] = std::max(bounds[2 * i + 1], points[p][i]);
    }
  }
  result.Lattice = vtkMTLattice::FromBounds(bounds, bits);
  double largest = 0.0; // in steps, so that the square neither underflows nor overflows at extreme scales
  result.Mesh.Points.reserve(representatives.size());
  for (std::uint32_t p : representatives)
  {
    const vtkMTPoint k = result.Lattice.Snap(points[p].data());
    result.Mesh.Points.push_back(k);
    const WorldPoint snapped = result.Lattice.ToWorld(k);
    double shift2 = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double shift = (snapped[i] - points[p][i]) / result.Lattice.Step;
      shift2 += shift * shift;
    }
    largest = std::max(largest, shift2);
  }
  // Four roundings at most: 2^-50 covers them.
  result.Lattice.MaximumShift = std::sqrt(largest) * (1.0 + std::ldexp(1.0, -50)) * result.Lattice.Step;
}

void Count(std::map<std::string, std::int64_t>& report, const char* reason, std::int64_t count)
{
  if (count > 0)
  {
    report[reason] += count;
  }
}

void Orient(vtkMTInputMesh& result)
{
  const vtkMTOrientation orientation = vtkMTOrientation::Run(result.Mesh);
  for (std::uint32_t t : orientation.Reversed)
  {
    std::swap(result.Mesh.Triangles[t][1], result.Mesh.Triangles[t][2]);
  }
  Count(result.Report, "reoriented_triangles", static_cast<std::int64_t>(orientation.Reversed.size()));
  Count(result.Report, "not_orientable_triangles", static_cast<std::int64_t>(orientation.NonOrientableTriangles));
}

void AddNormals(vtkMTInputMesh& result)
{
  const std::vector<std::array<float, 3>> normals = vtkMTPointNormals::Compute(result.Mesh);
  const std::size_t wedges = result.Mesh.GetNumberOfWedges();
  vtkMTColumn column(wedges * sizeof(normals[0]));
  for (std::uint32_t w = 0; w < wedges; ++w)
  {
    std::memcpy(column.data() + w * sizeof(normals[0]), &normals[result.Mesh.GetPointOfWedge(w)], sizeof(normals[0]));
  }
  result.Mesh.PointColumns.push_back(std::move(column));
  vtkMTArrayInfo info;
  info.Name = "Normals";
  const auto isTaken = [&info](const vtkMTArrayInfo& other)
  { return other.Association == vtkMTArrayInfo::Point && other.Name == info.Name; };
  while (std::any_of(result.Arrays.begin(), result.Arrays.end(), isTaken))
  {
    info.Name = "Made" + info.Name;
  }
  info.Type = VTK_FLOAT;
  info.Components = 3;
  info.Resampling = vtkMTArrayInfo::Direction;
  info.Role = vtkMTArrayInfo::MadeNormals;
  info.Attribute = vtkDataSetAttributes::NORMALS;
  result.Arrays.push_back(info);
}

bool LeaveOutFarOutliers(Loader& input, int latticeBits, vtkMTInputMesh& result, std::string& error)
{
  const vtkMTFarOutliers outliers = vtkMTFarOutliers::Find(input.Points, input.Triangles, latticeBits);
  if (outliers.IsRefused)
  {
    error = outliers.Message;
    return false;
  }
  input.RemoveTriangles(outliers.Triangles);
  result.Warning = outliers.Message;
  Count(result.Report, "dropped_far_outlier", static_cast<std::int64_t>(outliers.Triangles.size()));
  return true;
}

// The part of each triangle; empty where there is only one.
std::vector<std::int32_t> GetParts(
  const std::vector<vtkMTArrayInfo>& arrays, const std::vector<vtkMTColumn>& cellColumns)
{
  std::size_t column = 0;
  for (const vtkMTArrayInfo& info : arrays)
  {
    if (info.Association != vtkMTArrayInfo::Cell)
    {
      continue;
    }
    if (info.Name == "PartId" && info.Type == VTK_INT && info.Components == 1)
    {
      std::vector<std::int32_t> parts(cellColumns[column].size() / sizeof(std::int32_t));
      std::memcpy(parts.data(), cellColumns[column].data(), parts.size() * sizeof(parts[0]));
      return parts;
    }
    ++column;
  }
  return {};
}

vtkMTArrayInfo MakeCellIdInfo()
{
  vtkMTArrayInfo info;
  info.Name = "vtkMTInputCellIds";
  info.Type = VTK_ID_TYPE;
  info.Association = vtkMTArrayInfo::Cell;
  info.Resampling = vtkMTArrayInfo::Nearest;
  info.Role = vtkMTArrayInfo::InputCellIds;
  return info;
}
}

bool vtkMTInputMesh::Read(
  vtkMTTriangleStream& stream, int latticeBits, bool makeNormals, std::string& error, bool keepFarOutliers)
{
  *this = vtkMTInputMesh();
  Loader input(stream, *this);
  if (!input.Load(error))
  {
    return false;
  }
  for (const auto& [reason, count] : stream.GetReport())
  {
    Count(this->Report, reason.c_str(), count);
  }
  if (input.Triangles.empty())
  {
    error = this->InputTriangles == 0 ? "the input has no triangles"
                                      : "none of the input's " + std::to_string(this->InputTriangles) +
        " triangles is usable (all are degenerate, not finite, or refer to points that do not exist)";
    return false;
  }
  if (!keepFarOutliers && !LeaveOutFarOutliers(input, latticeBits, *this, error))
  {
    return false;
  }
  this->Arrays = stream.GetArrays();
  std::vector<std::size_t> pointTupleSizes;
  bool hasNormals = false;
  for (const vtkMTArrayInfo& info : this->Arrays)
  {
    if (info.Association == vtkMTArrayInfo::Point)
    {
      pointTupleSizes.push_back(info.GetTupleSize());
      hasNormals = hasNormals || info.Attribute == vtkDataSetAttributes::NORMALS;
    }
  }
  this->Arrays.push_back(MakeCellIdInfo());

  const vtkMTStitch stitch = vtkMTStitch::Run(input.Points, input.Triangles, GetParts(this->Arrays, input.CellColumns));
  const std::vector<std::uint32_t> representatives = WedgeMaker(input, stitch.Root, pointTupleSizes).Run(this->Mesh);
  this->Mesh.CellColumns = std::move(input.CellColumns);
  Snap(input.Points, representatives, latticeBits, *this);
  Orient(*this);
  if (makeNormals && !hasNormals)
  {
    AddNormals(*this);
  }
  Count(this->Report, "stitched_edges", stitch.StitchedEdges);
  Count(this->Report, "stitched_points", stitch.StitchedPoints);
  Count(this->Report, "seam_wedges",
    static_cast<std::int64_t>(this->Mesh.GetNumberOfWedges()) - static_cast<std::int64_t>(this->Mesh.Points.size()));
  std::vector<unsigned char> isUsed(input.Points.size(), 0);
  for (const Indices& t : input.Triangles)
  {
    isUsed[t[0]] = isUsed[t[1]] = isUsed[t[2]] = 1;
  }
  Count(this->Report, "isolated_points", std::count(isUsed.begin(), isUsed.end(), 0));
  return true;
}
