// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
bool BeginsWith(const std::string& text, const char* begin)
{
  return text.rfind(begin, 0) == 0;
}

//------------------------------------------------------------------------------
// Values of one block, changed on their way into the array.
using Change = std::function<void(const double* from, double* to)>;

// to has room for as many components as the array, which has no fewer than the values.
struct Block
{
  std::size_t Components;
  std::size_t Count;
  const double* Values;
};

template <typename T>
void Put(T* to, std::size_t components, const Block& block, const Change& change)
{
  std::vector<double> tuple(std::max<std::size_t>(components, 4), 0.0);
  for (std::size_t i = 0; i < block.Count; ++i, to += components)
  {
    const double* from = block.Values + i * block.Components;
    if (change)
    {
      change(from, tuple.data());
    }
    else
    {
      std::copy_n(from, block.Components, tuple.begin());
    }
    std::transform(tuple.begin(), tuple.begin() + static_cast<std::ptrdiff_t>(components), to,
      [](double value) { return static_cast<T>(value); });
  }
}

void PutBlock(vtkDataArray* array, vtkIdType first, const Block& block, const Change& change)
{
  const int components = array->GetNumberOfComponents();
  switch (array->GetDataType())
  {
    vtkTemplateMacro(Put(static_cast<VTK_TT*>(array->GetVoidPointer(first * components)),
      static_cast<std::size_t>(components), block, change));
    default:
      break;
  }
}

//------------------------------------------------------------------------------
Change TurnNormals(const vtkMTGltfMatrix& matrix)
{
  if (matrix.IsIdentity())
  {
    return nullptr;
  }
  return [normals = matrix.GetNormalMatrix()](const double* from, double* to)
  {
    normals.TransformDirection(from, to);
    vtkMath::Normalize(to);
  };
}

Change TurnTangents(const vtkMTGltfMatrix& matrix)
{
  if (matrix.IsIdentity())
  {
    return nullptr;
  }
  return [matrix, sign = matrix.GetDeterminant() < 0.0 ? -1.0 : 1.0](const double* from, double* to)
  {
    matrix.TransformDirection(from, to);
    vtkMath::Normalize(to);
    to[3] = sign * from[3];
  };
}

Change TurnTextureCoordinates(const vtkMTGltfMaterials::TextureTransform& transform)
{
  return [transform, isIdentity = transform.IsIdentity()](const double* from, double* to)
  {
    std::copy_n(from, 2, to);
    if (!isIdentity)
    {
      transform.Transform(from, to);
    }
    to[1] = 1.0 - to[1];
  };
}

// NaN is black; without alpha a colour is opaque.
Change ToBytes(std::size_t components)
{
  return [components](const double* from, double* to)
  {
    to[3] = 255.0;
    for (std::size_t c = 0; c < components; ++c)
    {
      to[c] = from[c] > 0.0 ? std::floor(255.0 * std::min(from[c], 1.0) + 0.5) : 0.0;
    }
  };
}

//------------------------------------------------------------------------------
// Ids that are stored as floating point, since glTF allows no larger integers; the same array where one is no id.
vtkSmartPointer<vtkDataArray> ToIds(const vtkSmartPointer<vtkDataArray>& array)
{
  const float* values = vtkFloatArray::SafeDownCast(array)->GetPointer(0);
  const vtkIdType count = array->GetNumberOfValues();
  const bool hasIds = std::all_of(
    values, values + count, [](float value) { return std::floor(value) == value && std::abs(value) <= 16777216.0f; });
  if (!hasIds)
  {
    return array;
  }
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName(array->GetName());
  ids->SetNumberOfComponents(array->GetNumberOfComponents());
  ids->SetNumberOfTuples(array->GetNumberOfTuples());
  std::transform(values, values + count, ids->GetPointer(0), [](float value) { return static_cast<int>(value); });
  return ids;
}

bool HoldsIds(const std::string& name, vtkDataArray* array)
{
  return (BeginsWith(name, "_FEATURE_ID") || name == "_BATCHID") && vtkFloatArray::SafeDownCast(array);
}
}

//------------------------------------------------------------------------------
vtkMTGltfArrays::Kind vtkMTGltfArrays::FindKind(const std::string& name)
{
  return name == "POSITION"         ? Kind::Position
    : name == "NORMAL"              ? Kind::Normal
    : name == "TANGENT"             ? Kind::Tangent
    : BeginsWith(name, "TEXCOORD_") ? Kind::TextureCoordinates
    : BeginsWith(name, "COLOR_")    ? Kind::Color
                                    : Kind::Custom;
}

int vtkMTGltfArrays::FindType(Kind kind, const vtkMTGltfAccessor& accessor)
{
  if (kind == Kind::Color)
  {
    return VTK_UNSIGNED_CHAR;
  }
  if (kind != Kind::Custom || accessor.IsReal())
  {
    return VTK_FLOAT;
  }
  switch (accessor.GetLayout().Type)
  {
    case vtkMTGltfAccessor::Byte:
      return VTK_SIGNED_CHAR;
    case vtkMTGltfAccessor::UnsignedByte:
      return VTK_UNSIGNED_CHAR;
    case vtkMTGltfAccessor::Short:
      return VTK_SHORT;
    case vtkMTGltfAccessor::UnsignedShort:
      return VTK_UNSIGNED_SHORT;
    default:
      return VTK_UNSIGNED_INT;
  }
}

// A type that holds the values of both.
int vtkMTGltfArrays::Unite(int a, int b)
{
  const auto isReal = [](int type) { return type == VTK_FLOAT || type == VTK_DOUBLE; };
  const auto isWide = [](int type) { return type == VTK_UNSIGNED_INT || type == VTK_LONG_LONG; };
  if (a == b)
  {
    return a;
  }
  if (isReal(a) || isReal(b))
  {
    return a == VTK_DOUBLE || b == VTK_DOUBLE || isWide(a) || isWide(b) ? VTK_DOUBLE : VTK_FLOAT;
  }
  return isWide(a) || isWide(b) ? VTK_LONG_LONG : VTK_INT;
}

void vtkMTGltfArrays::Add(const vtkMTGltfPrimitive& primitive)
{
  ++this->Primitives;
  for (const auto& [name, accessor] : primitive.GetAttributes())
  {
    const Kind kind = FindKind(name);
    const int type = FindType(kind, accessor);
    Column& column = this->Columns[name];
    column.What = kind;
    column.Type = column.Users == 0 ? type : Unite(column.Type, type);
    column.Components = std::max(column.Components, accessor.GetComponents());
    ++column.Users;
  }
}

std::uint64_t vtkMTGltfArrays::GetTupleSize() const
{
  std::uint64_t size = 0;
  for (const auto& [name, column] : this->Columns)
  {
    size += 8 * column.Components; // never more
  }
  return size;
}

void vtkMTGltfArrays::Allocate(vtkIdType points)
{
  for (auto& [name, column] : this->Columns)
  {
    column.Type = column.What == Kind::Position && this->IsDouble ? VTK_DOUBLE : column.Type;
    column.Array.TakeReference(vtkDataArray::CreateDataArray(column.Type));
    column.Array->SetName(name.c_str());
    column.Array->SetNumberOfComponents(static_cast<int>(column.Components));
    column.Array->SetNumberOfTuples(points);
  }
}

// Colours are those of the material: what a viewer shows where there are no colours of points.
void vtkMTGltfArrays::FillMissing(
  const Column& column, const vtkMTGltfMaterials& materials, int material, vtkIdType first, vtkIdType count)
{
  std::vector<double> tuple(column.Components, 0.0);
  if (column.What == Kind::Color)
  {
    const std::array<unsigned char, 4> color = materials.GetColor(material);
    std::copy_n(color.begin(), std::min(tuple.size(), color.size()), tuple.begin());
  }
  for (vtkIdType i = first; i < first + count; ++i)
  {
    column.Array->SetTuple(i, tuple.data());
  }
}

void vtkMTGltfArrays::Fill(vtkMTGltfFile& file, vtkMTGltfPrimitive& primitive, const vtkMTGltfMatrix& matrix,
  const vtkMTGltfMaterials& materials, vtkIdType first)
{
  for (const auto& [name, column] : this->Columns)
  {
    const auto found = primitive.GetAttributes().find(name);
    if (found == primitive.GetAttributes().end())
    {
      FillMissing(
        column, materials, primitive.GetMaterial(), first, static_cast<vtkIdType>(primitive.GetNumberOfPoints()));
      continue;
    }
    const std::size_t components = found->second.GetComponents();
    Change change;
    switch (column.What)
    {
      case Kind::Position:
        change = [&matrix](const double* from, double* to) { matrix.TransformPoint(from, to); };
        break;
      case Kind::Normal:
        change = TurnNormals(matrix);
        break;
      case Kind::Tangent:
        change = TurnTangents(matrix);
        break;
      case Kind::TextureCoordinates:
        change = TurnTextureCoordinates(materials.FindTransform(primitive.GetMaterial(), name));
        break;
      case Kind::Color:
        change = ToBytes(components);
        break;
      case Kind::Custom:
        break;
    }
    primitive.ReadAttribute(file, name,
      [&, array = column.Array.Get()](std::uint64_t from, std::size_t count, const double* values) {
        PutBlock(array, first + static_cast<vtkIdType>(from), { components, count, values }, change);
      });
  }
}

//------------------------------------------------------------------------------
bool vtkMTGltfArrays::NeedsNormals(const vtkMTGltfPrimitive& primitive) const
{
  return this->Columns.count("NORMAL") > 0 && primitive.GetAttributes().count("NORMAL") == 0;
}

void vtkMTGltfArrays::MakeNormals(vtkIdType first, vtkIdType count, const std::vector<vtkIdType>& corners)
{
  vtkDataArray* points = this->Columns.at("POSITION").Array;
  std::vector<double> sums(static_cast<std::size_t>(3 * count), 0.0);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    double places[3][3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      points->GetTuple(corners[i + c], places[c]);
    }
    double normal[3];
    vtkMath::Subtract(places[1], places[0], places[1]);
    vtkMath::Subtract(places[2], places[0], places[2]);
    vtkMath::Cross(places[1], places[2], normal);
    for (std::size_t c = 0; c < 3; ++c)
    {
      double* sum = sums.data() + 3 * (corners[i + c] - first);
      vtkMath::Add(sum, normal, sum);
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double* normal = sums.data() + 3 * i;
    const bool isGood = vtkMath::Normalize(normal) > 0.0 && std::isfinite(normal[0] + normal[1] + normal[2]);
    const double up[3] = { 0.0, 0.0, 1.0 };
    this->Columns.at("NORMAL").Array->SetTuple(first + i, isGood ? normal : up);
  }
}

//------------------------------------------------------------------------------
void vtkMTGltfArrays::Finish(vtkPolyData* output, Counts& counts)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Columns.at("POSITION").Type);
  points->SetData(this->Columns.at("POSITION").Array);
  points->GetData()->SetName("Points");
  output->SetPoints(points);
  vtkPointData* arrays = output->GetPointData();
  for (auto& [name, column] : this->Columns)
  {
    counts["united_arrays_filled"] += column.Users < this->Primitives ? 1 : 0;
    if (column.What == Kind::Position)
    {
      continue;
    }
    column.Array = HoldsIds(name, column.Array) ? ToIds(column.Array) : column.Array;
    const int index = arrays->AddArray(column.Array);
    const int attribute = name == "NORMAL" ? vtkDataSetAttributes::NORMALS
      : name == "TEXCOORD_0"               ? vtkDataSetAttributes::TCOORDS
      : name == "COLOR_0"                  ? vtkDataSetAttributes::SCALARS
                                           : -1;
    if (attribute >= 0)
    {
      arrays->SetActiveAttribute(index, attribute);
    }
  }
}
