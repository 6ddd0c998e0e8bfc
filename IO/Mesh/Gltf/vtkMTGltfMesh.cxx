// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariantArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace vtkMTGltfJson;

namespace
{
// Numbers of points and triangles stay far from where their sums would overflow.
constexpr std::uint64_t CountLimit = std::uint64_t(1) << 40;
// Single precision loses five bits more than that takes.
constexpr double FarRatio = 32.0;

std::vector<int> FindUsed(vtkIntArray* ids)
{
  const std::set<int> used(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues());
  return std::vector<int>(used.begin(), used.end());
}

vtkSmartPointer<vtkIntArray> MakeIds(const char* name, std::uint64_t count)
{
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(static_cast<vtkIdType>(count));
  return ids;
}
}

//------------------------------------------------------------------------------
// What is there
vtkMTGltfMesh::vtkMTGltfMesh(vtkMTGltfFile& file, Counts& counts)
  : File(file)
  , Report(counts)
  , Scene(file, counts)
  , Materials(file)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Bounds[2 * i] = std::numeric_limits<double>::infinity();
    this->Bounds[2 * i + 1] = -std::numeric_limits<double>::infinity();
  }
  for (const Placement& placement : this->Scene.GetPlacements())
  {
    this->FindPrimitives(placement.Mesh);
    this->CountPlacement(placement);
  }
  for (const vtkMTGltfMaterials::Material& material : this->Materials.GetMaterials())
  {
    counts["textures_ignored"] += static_cast<std::int64_t>(material.OtherTextures);
  }
}

void vtkMTGltfMesh::FindPrimitives(std::size_t mesh)
{
  if (this->Primitives.count(mesh) > 0)
  {
    return;
  }
  std::vector<vtkMTGltfPrimitive>& primitives = this->Primitives[mesh];
  const std::string where = "mesh " + std::to_string(mesh);
  const std::size_t count = GetList(this->File.GetItem("meshes", mesh), "primitives", where).size();
  for (std::size_t i = 0; i < count; ++i)
  {
    primitives.emplace_back(this->File, mesh, i);
    if (primitives.back().GetNumberOfTriangles() > 0)
    {
      this->Arrays.Add(primitives.back());
    }
  }
}

void vtkMTGltfMesh::CountIgnored(const vtkMTGltfPrimitive& primitive)
{
  this->Report["vertices"] += static_cast<std::int64_t>(primitive.GetNumberOfVertices());
  this->Report["lines"] += static_cast<std::int64_t>(primitive.GetNumberOfLines());
  this->Report["left_corners"] += static_cast<std::int64_t>(primitive.GetNumberOfLeftCorners());
  this->Report["morph_targets_ignored"] += static_cast<std::int64_t>(primitive.GetNumberOfMorphTargets());
  this->Report["primitives_without_points"] += primitive.GetNumberOfPoints() == 0 ? 1 : 0;
}

void vtkMTGltfMesh::CountPlacement(const Placement& placement)
{
  for (const vtkMTGltfPrimitive& primitive : this->Primitives[placement.Mesh])
  {
    this->CountIgnored(primitive);
    if (primitive.GetNumberOfTriangles() == 0)
    {
      continue;
    }
    this->Points += primitive.GetNumberOfPoints();
    this->Triangles += primitive.GetNumberOfTriangles();
    if (this->Points > CountLimit || this->Triangles > CountLimit)
    {
      Fail(primitive.GetName(), "the scene would have more than 2^40 points or triangles");
    }
    const bool isMirrored = placement.Matrix.GetDeterminant() < 0.0;
    this->Report["turned_triangles"] += isMirrored ? static_cast<std::int64_t>(primitive.GetNumberOfTriangles()) : 0;
    this->AddBounds(primitive, placement.Matrix);
  }
}

void vtkMTGltfMesh::AddBounds(const vtkMTGltfPrimitive& primitive, const vtkMTGltfMatrix& matrix)
{
  std::vector<double> least;
  std::vector<double> largest;
  this->IsMoved = this->IsMoved || !matrix.IsIdentity();
  for (int corner = 0; corner < 8 && primitive.GetAttributes().at("POSITION").GetBounds(least, largest); ++corner)
  {
    double place[3];
    for (int i = 0; i < 3; ++i)
    {
      place[i] = corner >> i & 1 ? largest[i] : least[i];
    }
    matrix.TransformPoint(place, place);
    for (int i = 0; i < 3; ++i)
    {
      this->Bounds[2 * i] = std::min(this->Bounds[2 * i], place[i]);
      this->Bounds[2 * i + 1] = std::max(this->Bounds[2 * i + 1], place[i]);
    }
  }
}

bool vtkMTGltfMesh::IsFarFromOrigin() const
{
  double distance = 0.0;
  double extent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    distance = std::max({ distance, std::abs(this->Bounds[2 * i]), std::abs(this->Bounds[2 * i + 1]) });
    extent = std::max(extent, this->Bounds[2 * i + 1] - this->Bounds[2 * i]);
  }
  return this->IsMoved && std::isfinite(distance) && distance > FarRatio * extent;
}

void vtkMTGltfMesh::CheckMemory(std::uint64_t limit) const
{
  constexpr std::uint64_t forTriangle = 4 * (3 + 1 + 1 + 1) + 4; // corners, offset, ids and colour
  const std::uint64_t needed = this->Points * (12 + this->Arrays.GetTupleSize()) + this->Triangles * forTriangle;
  if (needed > limit)
  {
    throw Error("would take " + std::to_string(needed >> 20) + " MiB (" + std::to_string(this->Points) + " points, " +
      std::to_string(this->Triangles) + " triangles); " + std::to_string(limit >> 20) + " MiB is the limit");
  }
}

//------------------------------------------------------------------------------
// Making it
void vtkMTGltfMesh::Make(std::uint64_t memoryLimit, vtkPolyData* output)
{
  if (this->Triangles == 0)
  {
    throw Error("has no triangles");
  }
  this->CheckMemory(memoryLimit);
  this->Arrays.SetDouble(this->IsFarFromOrigin());
  this->Arrays.Allocate(static_cast<vtkIdType>(this->Points));
  this->MaterialIds = MakeIds("MaterialIds", this->Triangles);
  this->NodeIds = MakeIds("NodeIds", this->Triangles);
  constexpr std::uint64_t smallest = std::numeric_limits<std::int32_t>::max();
  const bool isSmall = this->Points <= smallest && 3 * this->Triangles <= smallest;
  isSmall ? this->MakeCells<vtkTypeInt32Array>(output) : this->MakeCells<vtkTypeInt64Array>(output);
  this->Arrays.Finish(output, this->Report);
  this->AddMaterials(output);
  this->AddNodes(output);
}

template <typename Array>
void vtkMTGltfMesh::MakeCells(vtkPolyData* output)
{
  using Value = typename Array::ValueType;
  vtkNew<Array> corners;
  vtkNew<Array> offsets;
  corners->SetNumberOfValues(static_cast<vtkIdType>(3 * this->Triangles));
  offsets->SetNumberOfValues(static_cast<vtkIdType>(this->Triangles + 1));
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, static_cast<Value>(3 * i));
  }
  this->PutCorner = [to = corners->GetPointer(0)](std::uint64_t position, std::uint64_t point)
  { to[position] = static_cast<Value>(point); };
  const std::vector<Placement>& placements = this->Scene.GetPlacements();
  for (std::size_t i = 0; i < placements.size(); ++i)
  {
    this->FillPlacement(placements[i]);
    const bool isLast = i + 1 == placements.size() || placements[i + 1].Mesh != placements[i].Mesh;
    for (vtkMTGltfPrimitive& primitive : this->Primitives[placements[i].Mesh])
    {
      isLast ? primitive.Release() : void();
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetPolys(cells);
}

void vtkMTGltfMesh::FillPlacement(const Placement& placement)
{
  for (vtkMTGltfPrimitive& primitive : this->Primitives[placement.Mesh])
  {
    if (primitive.GetNumberOfTriangles() > 0)
    {
      this->Arrays.Fill(this->File, primitive, placement.Matrix, this->Materials, this->NextPoint);
      this->FillCells(primitive, placement);
      this->NextPoint += static_cast<vtkIdType>(primitive.GetNumberOfPoints());
      this->NextTriangle += static_cast<vtkIdType>(primitive.GetNumberOfTriangles());
    }
  }
}

void vtkMTGltfMesh::FillCells(vtkMTGltfPrimitive& primitive, const Placement& placement)
{
  const bool isMirrored = placement.Matrix.GetDeterminant() < 0.0;
  const bool needsNormals = this->Arrays.NeedsNormals(primitive);
  const auto first = static_cast<std::uint64_t>(this->NextPoint);
  auto position = static_cast<std::uint64_t>(3 * this->NextTriangle);
  std::vector<vtkIdType> corners;
  primitive.ReadTriangles(this->File,
    [&](std::uint64_t a, std::uint64_t b, std::uint64_t c)
    {
      for (const std::uint64_t corner : { a, isMirrored ? c : b, isMirrored ? b : c })
      {
        this->PutCorner(position++, first + corner);
        if (needsNormals)
        {
          corners.push_back(static_cast<vtkIdType>(first + corner));
        }
      }
    });
  if (needsNormals)
  {
    this->Arrays.MakeNormals(this->NextPoint, static_cast<vtkIdType>(primitive.GetNumberOfPoints()), corners);
    this->Report["made_part_normals"] += static_cast<std::int64_t>(primitive.GetNumberOfPoints());
  }
  const auto triangles = static_cast<vtkIdType>(primitive.GetNumberOfTriangles());
  std::fill_n(this->MaterialIds->GetPointer(this->NextTriangle), triangles, primitive.GetMaterial());
  std::fill_n(this->NodeIds->GetPointer(this->NextTriangle), triangles, placement.Node);
}

//------------------------------------------------------------------------------
// What cells are of
void vtkMTGltfMesh::AddMaterials(vtkPolyData* output)
{
  const std::vector<int> used = FindUsed(this->MaterialIds);
  const std::vector<vtkMTGltfMaterials::Material>& all = this->Materials.GetMaterials();
  const bool saysNothing = used.size() == 1 && (used[0] < 0 || all[static_cast<std::size_t>(used[0])].IsPlain());
  if (!saysNothing)
  {
    this->Materials.Describe(this->MaterialIds, used.front() < 0);
    output->GetCellData()->AddArray(this->MaterialIds);
    this->AddBaseColors(used, output);
  }
}

void vtkMTGltfMesh::AddBaseColors(const std::vector<int>& used, vtkPolyData* output)
{
  const std::vector<vtkMTGltfMaterials::Material>& all = this->Materials.GetMaterials();
  const auto hasColor = [&all](int id, std::size_t first)
  {
    return id >= 0 &&
      std::any_of(all[static_cast<std::size_t>(id)].Color.begin() + static_cast<std::ptrdiff_t>(first),
        all[static_cast<std::size_t>(id)].Color.end(), [](double value) { return value != 1.0; });
  };
  if (std::none_of(used.begin(), used.end(), [&](int id) { return hasColor(id, 0); }))
  {
    return;
  }
  const bool hasAlpha = std::any_of(used.begin(), used.end(), [&](int id) { return hasColor(id, 3); });
  std::map<int, std::array<unsigned char, 4>> bytes;
  for (const int id : used)
  {
    bytes[id] = this->Materials.GetColor(id);
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("BaseColor");
  colors->SetNumberOfComponents(hasAlpha ? 4 : 3);
  colors->SetNumberOfTuples(this->MaterialIds->GetNumberOfValues());
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    colors->SetTypedTuple(i, bytes[this->MaterialIds->GetValue(i)].data());
  }
  output->GetCellData()->SetScalars(colors);
}

void vtkMTGltfMesh::AddNodes(vtkPolyData* output)
{
  const std::vector<int> used = FindUsed(this->NodeIds);
  if (used.size() < 2)
  {
    return;
  }
  vtkNew<vtkVariantArray> values;
  vtkNew<vtkStringArray> names;
  for (const int id : used)
  {
    const Json& node = this->File.GetItem("nodes", static_cast<std::size_t>(id));
    values->InsertNextValue(id);
    names->InsertNextValue(GetText(node, "name", "node " + std::to_string(id)));
  }
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(std::min<vtkIdType>(values->GetNumberOfValues(), 256));
  table->SetTableRange(used.front(), used.back());
  table->Build();
  table->SetAnnotations(values, names);
  table->IndexedLookupOn();
  this->NodeIds->SetLookupTable(table);
  output->GetCellData()->AddArray(this->NodeIds);
}
