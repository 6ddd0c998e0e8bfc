// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshMerge.h"

#include "vtkMTIdNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <map>
#include <tuple>

namespace
{
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;
using Report = std::map<std::string, std::int64_t>;

// Tuples of one mesh that lie together in it and in the whole.
struct Range
{
  std::size_t Part;
  vtkIdType From;
  vtkIdType Count;
};

// One array of the whole, and the arrays of the meshes that it is made of (or none).
struct United
{
  std::string Name;
  int Type = VTK_FLOAT;
  int Components = 1;
  int Attribute = -1;
  std::vector<vtkDataArray*> Sources;
};

std::array<vtkCellArray*, 4> GetCells(vtkPolyData* mesh)
{
  return { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() };
}

//------------------------------------------------------------------------------
// Which arrays become one.
class Union
{
public:
  Union(std::size_t parts, Report& report)
    : NumberOfParts(parts)
    , Counts(report)
  {
  }

  void Add(std::size_t part, vtkDataSetAttributes* arrays, vtkIdType tuples)
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      if (!array || array->GetDataType() == VTK_BIT)
      {
        ++this->Counts[array ? "arrays_of_bits" : "arrays_of_strings"];
      }
      else if (array->GetNumberOfTuples() != tuples)
      {
        ++this->Counts["arrays_of_wrong_length"];
      }
      else
      {
        this->Find(array, arrays->IsArrayAnAttribute(i)).Sources[part] = array;
      }
    }
  }

  std::vector<United> Finish()
  {
    std::vector<std::string> taken;
    for (United& united : this->Arrays)
    {
      const std::string name = united.Name;
      for (int i = 2; std::find(taken.begin(), taken.end(), united.Name) != taken.end(); ++i)
      {
        united.Name = name + "_" + std::to_string(i);
      }
      taken.push_back(united.Name);
      this->Counts["renamed_arrays"] += united.Name != name ? 1 : 0;
      const bool isFilled = std::count(united.Sources.begin(), united.Sources.end(), nullptr) > 0;
      this->Counts["united_arrays_filled"] += isFilled ? 1 : 0;
    }
    return std::move(this->Arrays);
  }

private:
  United& Find(vtkDataArray* array, int attribute)
  {
    United wanted;
    wanted.Name = array->GetName() ? array->GetName() : "";
    wanted.Name = wanted.Name == vtkMTMeshMerge::GetPartIdName() ? "InputPartId" : wanted.Name;
    wanted.Type = array->GetDataType();
    wanted.Components = array->GetNumberOfComponents();
    wanted.Attribute = attribute;
    const auto isReal = [](int type) { return type == VTK_FLOAT || type == VTK_DOUBLE; };
    const bool mayWiden =
      isReal(wanted.Type) && (attribute == vtkDataSetAttributes::NORMALS || attribute == vtkDataSetAttributes::TCOORDS);
    for (United& united : this->Arrays)
    {
      const bool isSameType =
        united.Type == wanted.Type || (mayWiden && united.Attribute == attribute && isReal(united.Type));
      if (united.Name == wanted.Name && united.Components == wanted.Components && isSameType)
      {
        united.Type = std::max(united.Type, wanted.Type); // VTK_DOUBLE is above VTK_FLOAT
        return united;
      }
    }
    wanted.Sources.assign(this->NumberOfParts, nullptr);
    this->Arrays.push_back(std::move(wanted));
    return this->Arrays.back();
  }

  const std::size_t NumberOfParts;
  Report& Counts;
  std::vector<United> Arrays;
};

//------------------------------------------------------------------------------
// The newell normal of a polygon points its way and is as long as twice its area.
void AddPolygonNormal(vtkPoints* points, const vtkIdType* corners, vtkIdType count, std::vector<double>& sums)
{
  double normal[3] = { 0.0, 0.0, 0.0 };
  double first[3];
  points->GetPoint(corners[0], first);
  for (vtkIdType i = 1; i + 1 < count; ++i)
  {
    double a[3], b[3], cross[3];
    points->GetPoint(corners[i], a);
    points->GetPoint(corners[i + 1], b);
    vtkMath::Subtract(a, first, a);
    vtkMath::Subtract(b, first, b);
    vtkMath::Cross(a, b, cross);
    vtkMath::Add(normal, cross, normal);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sums[static_cast<std::size_t>(3 * corners[i] + axis)] += normal[axis];
    }
  }
}

vtkSmartPointer<vtkFloatArray> MakeNormals(vtkPolyData* mesh)
{
  std::vector<double> sums(static_cast<std::size_t>(3 * mesh->GetNumberOfPoints()), 0.0);
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, count, corners);
    AddPolygonNormal(mesh->GetPoints(), corners, count, sums);
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfStrips(); ++i)
  {
    mesh->GetStrips()->GetCellAtId(i, count, corners);
    for (vtkIdType c = 0; c + 2 < count; ++c)
    {
      const vtkIdType triangle[3] = { corners[c + c % 2], corners[c + 1 - c % 2], corners[c + 2] };
      AddPolygonNormal(mesh->GetPoints(), triangle, 3, sums);
    }
  }
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double* sum = sums.data() + 3 * p;
    const double length = vtkMath::Norm(sum);
    const bool isGood = length > 0.0 && vtkMath::IsFinite(length);
    const float normal[3] = { isGood ? static_cast<float>(sum[0] / length) : 0.0f,
      isGood ? static_cast<float>(sum[1] / length) : 0.0f, isGood ? static_cast<float>(sum[2] / length) : 1.0f };
    normals->SetTypedTuple(p, normal);
  }
  return normals;
}

//------------------------------------------------------------------------------
void FillMissing(vtkDataArray* array, vtkIdType first, vtkIdType count)
{
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const bool hasNames = array->GetLookupTable() && array->GetLookupTable()->GetNumberOfAnnotatedValues() > 0;
  const double whole = hasNames && array->GetDataTypeMin() < 0.0 ? -1.0 : 0.0; // which is no id
  const std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()),
    isReal ? std::numeric_limits<double>::quiet_NaN() : whole);
  for (vtkIdType i = first; i < first + count; ++i)
  {
    array->SetTuple(i, tuple.data());
  }
}

// The names of ids in several tables; null where some table has none. differing: ids with several names.
vtkSmartPointer<vtkLookupTable> UniteNames(const std::vector<vtkDataArray*>& sources, std::int64_t& differing)
{
  struct Id
  {
    std::string Name;
    vtkMTIdNames::Color Color;
  };
  std::map<double, Id> ids;
  for (vtkDataArray* source : sources)
  {
    vtkLookupTable* table = source ? source->GetLookupTable() : nullptr;
    if (source && (!table || !table->GetIndexedLookup() || table->GetNumberOfAnnotatedValues() == 0))
    {
      return nullptr;
    }
    for (vtkIdType i = 0; table && i < table->GetNumberOfAnnotatedValues(); ++i)
    {
      double color[4];
      table->GetAnnotationColor(table->GetAnnotatedValue(i), color);
      const std::string name = table->GetAnnotation(i);
      const auto [id, isNew] =
        ids.emplace(table->GetAnnotatedValue(i).ToDouble(), Id{ name, { color[0], color[1], color[2] } });
      if (!isNew && (" | " + id->second.Name + " | ").find(" | " + name + " | ") == std::string::npos)
      {
        id->second.Name += " | " + name;
      }
    }
  }
  std::vector<double> values;
  std::vector<std::string> names;
  std::vector<vtkMTIdNames::Color> colors;
  for (const auto& [value, id] : ids)
  {
    values.push_back(value);
    names.push_back(id.Name);
    colors.push_back(id.Color);
    differing += id.Name.find(" | ") != std::string::npos ? 1 : 0;
  }
  return ids.empty() ? nullptr : vtkMTIdNames::MakeTable(names, colors, values);
}

void DescribeArray(vtkDataArray* array, const United& united, Report& report)
{
  array->SetLookupTable(UniteNames(united.Sources, report["united_names_differ"]));
  array->SetName(united.Name.empty() ? nullptr : united.Name.c_str());
  for (vtkDataArray* source : united.Sources)
  {
    if (!source)
    {
      continue;
    }
    if (source->GetLookupTable() && !array->GetLookupTable())
    {
      array->SetLookupTable(source->GetLookupTable());
    }
    for (int i = 0; i < united.Components && source->HasAComponentName(); ++i)
    {
      if (source->GetComponentName(i) && !array->GetComponentName(i))
      {
        array->SetComponentName(i, source->GetComponentName(i));
      }
    }
  }
}

void AddUnited(const United& united, const std::vector<Range>& ranges, vtkIdType tuples, vtkDataSetAttributes* output,
  Report& report)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(united.Type));
  array->SetNumberOfComponents(united.Components);
  array->SetNumberOfTuples(tuples);
  DescribeArray(array, united, report);
  vtkIdType next = 0;
  for (const Range& range : ranges)
  {
    vtkDataArray* source = united.Sources[range.Part];
    if (!source)
    {
      FillMissing(array, next, range.Count);
    }
    else if (range.Count > 0)
    {
      array->InsertTuples(next, range.Count, range.From, source);
    }
    next += range.Count;
  }
  const int index = output->AddArray(array);
  if (united.Attribute >= 0 && !output->GetAbstractAttribute(united.Attribute))
  {
    output->SetActiveAttribute(index, united.Attribute);
  }
}

//------------------------------------------------------------------------------
void MergePoints(const Parts& parts, vtkPolyData* output, Report& report)
{
  Union arrays(parts.size(), report);
  std::vector<Range> ranges;
  vtkIdType total = 0;
  bool isDouble = false;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const vtkIdType count = parts[part]->GetNumberOfPoints();
    isDouble = isDouble || (count > 0 && parts[part]->GetPoints()->GetDataType() != VTK_FLOAT);
    arrays.Add(part, parts[part]->GetPointData(), count);
    ranges.push_back({ part, 0, count });
    total += count;
  }
  United places;
  places.Type = isDouble ? VTK_DOUBLE : VTK_FLOAT;
  places.Components = 3;
  for (const auto& part : parts)
  {
    places.Sources.push_back(part->GetPoints() ? part->GetPoints()->GetData() : nullptr);
  }
  vtkNew<vtkPointData> holder;
  AddUnited(places, ranges, total, holder, report);
  vtkNew<vtkPoints> points;
  points->SetDataType(places.Type);
  points->SetData(holder->GetArray(0));
  output->SetPoints(points);

  std::vector<vtkSmartPointer<vtkFloatArray>> made;
  for (United& united : arrays.Finish())
  {
    for (std::size_t part = 0; part < parts.size() && united.Attribute == vtkDataSetAttributes::NORMALS; ++part)
    {
      if (!united.Sources[part] && united.Components == 3 && parts[part]->GetNumberOfPoints() > 0)
      {
        made.push_back(MakeNormals(parts[part]));
        united.Sources[part] = made.back();
        report["made_part_normals"] += parts[part]->GetNumberOfPoints();
      }
    }
    AddUnited(united, ranges, total, output->GetPointData(), report);
  }
}

// Kind by kind, and the ranges of cells in the order in which VTK numbers them.
std::vector<Range> MergeCells(const Parts& parts, vtkPolyData* output)
{
  std::vector<Range> ranges;
  std::vector<vtkIdType> next(parts.size(), 0);
  for (std::size_t kind = 0; kind < 4; ++kind)
  {
    vtkNew<vtkCellArray> cells;
    vtkIdType firstPoint = 0;
    for (std::size_t part = 0; part < parts.size(); ++part)
    {
      vtkCellArray* more = GetCells(parts[part])[kind];
      const vtkIdType count = more ? more->GetNumberOfCells() : 0;
      if (count > 0)
      {
        cells->Append(more, firstPoint);
      }
      ranges.push_back({ part, next[part], count });
      next[part] += count;
      firstPoint += parts[part]->GetNumberOfPoints();
    }
    if (cells->GetNumberOfCells() > 0)
    {
      kind == 0     ? output->SetVerts(cells)
        : kind == 1 ? output->SetLines(cells)
        : kind == 2 ? output->SetPolys(cells)
                    : output->SetStrips(cells);
    }
  }
  return ranges;
}

void AddPartIds(const std::vector<Range>& ranges, vtkPolyData* output)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkMTMeshMerge::GetPartIdName());
  ids->SetNumberOfValues(output->GetNumberOfCells());
  int* next = ids->GetPointer(0);
  for (const Range& range : ranges)
  {
    next = std::fill_n(next, range.Count, static_cast<int>(range.Part));
  }
  output->GetCellData()->AddArray(ids);
}

void MergeAll(const Parts& parts, vtkPolyData* output, Report& report)
{
  MergePoints(parts, output, report);
  const std::vector<Range> ranges = MergeCells(parts, output);
  Union arrays(parts.size(), report);
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    arrays.Add(part, parts[part]->GetCellData(), parts[part]->GetNumberOfCells());
  }
  for (const United& united : arrays.Finish())
  {
    AddUnited(united, ranges, output->GetNumberOfCells(), output->GetCellData(), report);
  }
  AddPartIds(ranges, output);
}
}

bool vtkMTMeshMerge::Merge(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, vtkPolyData* output,
  std::map<std::string, std::int64_t>& report, std::string& error)
{
  output->Initialize();
  try
  {
    MergeAll(parts, output, report);
  }
  catch (const std::exception& exception) // no memory
  {
    error = std::string("the meshes could not be merged: ") + exception.what();
    output->Initialize();
    return false;
  }
  for (auto entry = report.begin(); entry != report.end();)
  {
    entry = entry->second == 0 ? report.erase(entry) : std::next(entry);
  }
  return true;
}
