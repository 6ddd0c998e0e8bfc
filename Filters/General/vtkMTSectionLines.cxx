// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSectionLines.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace
{
constexpr vtkIdType BetweenReports = 1 << 14; // triangles

// A point on an edge, Weight of the way from the negative end.
struct Crossing
{
  vtkIdType Negative;
  vtkIdType Other;
  double Weight;
};

//------------------------------------------------------------------------------
class Lines
{
public:
  Lines(vtkPolyData* mesh, vtkImplicitFunction* function)
    : Values(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
  {
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      double x[3];
      mesh->GetPoint(p, x);
      this->Values[p] = function->FunctionValue(x);
    }
  }

  void AddTriangle(vtkIdType triangle, const vtkIdType* corners)
  {
    std::array<vtkIdType, 2> ends{ -1, -1 }; // where the sign rises, and where it falls, along the triangle's border
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = corners[i];
      const vtkIdType b = corners[(i + 1) % 3];
      if (this->IsNegative(a) != this->IsNegative(b))
      {
        ends[this->IsNegative(a) ? 0 : 1] = this->IsNegative(a) ? this->GetCrossing(a, b) : this->GetCrossing(b, a);
      }
    }
    if (ends[0] >= 0)
    {
      this->Cells->InsertNextCell(2, ends.data());
      this->Triangles.push_back(triangle);
    }
  }

  std::vector<Crossing> Crossings;
  std::vector<vtkIdType> Triangles; // of each line
  vtkNew<vtkCellArray> Cells;

private:
  bool IsNegative(vtkIdType point) const { return this->Values[point] < 0.0; }

  vtkIdType GetCrossing(vtkIdType negative, vtkIdType other)
  {
    const auto key = (static_cast<std::uint64_t>(negative) << 32) | static_cast<std::uint64_t>(other);
    const auto found = this->Index.emplace(key, static_cast<vtkIdType>(this->Crossings.size()));
    if (found.second)
    {
      const double weight = this->Values[negative] / (this->Values[negative] - this->Values[other]);
      constexpr double middle = 0.5; // where a value is infinite or no number
      this->Crossings.push_back({ negative, other, weight >= 0.0 && weight <= 1.0 ? weight : middle });
    }
    return found.first->second;
  }

  std::vector<double> Values;
  std::unordered_map<std::uint64_t, vtkIdType> Index; // points of a mesh have 32 bits, see vtkMTPatch
};

//------------------------------------------------------------------------------
void MendArray(const vtkMTArrayInfo& info, vtkPointData* from, const std::vector<Crossing>& crossings, vtkPointData* to)
{
  vtkDataArray* source = from->GetArray(info.Name.c_str());
  vtkDataArray* target = to->GetArray(info.Name.c_str());
  if (!source || !target || info.Association != vtkMTArrayInfo::Point || info.Resampling == vtkMTArrayInfo::Interpolate)
  {
    return;
  }
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    if (info.Resampling == vtkMTArrayInfo::Nearest)
    {
      target->SetTuple(point, crossings[i].Weight < 0.5 ? crossings[i].Negative : crossings[i].Other, source);
      continue;
    }
    double square = 0.0;
    for (int c = 0; c < info.Components; ++c)
    {
      square += target->GetComponent(point, c) * target->GetComponent(point, c);
    }
    for (int c = 0; square > 0.0 && c < info.Components; ++c)
    {
      target->SetComponent(point, c, target->GetComponent(point, c) / std::sqrt(square));
    }
  }
}

//------------------------------------------------------------------------------
void FillPoints(vtkPolyData* mesh, const std::vector<Crossing>& crossings, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(crossings.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkPointData* from = mesh->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Crossing& c = crossings[i];
    double a[3];
    double b[3];
    mesh->GetPoint(c.Negative, a);
    mesh->GetPoint(c.Other, b);
    points->SetPoint(
      i, a[0] + c.Weight * (b[0] - a[0]), a[1] + c.Weight * (b[1] - a[1]), a[2] + c.Weight * (b[2] - a[2]));
    to->InterpolateEdge(from, i, c.Negative, c.Other, c.Weight);
  }
  output->SetPoints(points);
}
}

//------------------------------------------------------------------------------
bool vtkMTSectionLines::Make(vtkPolyData* mesh, vtkPolyData* output) const
{
  output->Initialize();
  Lines lines(mesh, this->Function);
  vtkCellArray* polys = mesh->GetPolys();
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < polys->GetNumberOfCells(); ++t)
  {
    if (t % BetweenReports == 0 && this->Progress &&
      !this->Progress(static_cast<double>(t) / static_cast<double>(polys->GetNumberOfCells())))
    {
      return false;
    }
    polys->GetCellAtId(t, corners);
    lines.AddTriangle(t, corners->GetPointer(0));
  }
  FillPoints(mesh, lines.Crossings, output);
  for (std::size_t i = 0; this->Arrays && i < this->Arrays->size(); ++i)
  {
    MendArray((*this->Arrays)[i], mesh->GetPointData(), lines.Crossings, output->GetPointData());
  }
  output->SetLines(lines.Cells);
  output->GetCellData()->CopyAllOn();
  output->GetCellData()->CopyAllocate(mesh->GetCellData(), static_cast<vtkIdType>(lines.Triangles.size()));
  for (std::size_t i = 0; i < lines.Triangles.size(); ++i)
  {
    output->GetCellData()->CopyData(mesh->GetCellData(), lines.Triangles[i], static_cast<vtkIdType>(i));
  }
  return true;
}
