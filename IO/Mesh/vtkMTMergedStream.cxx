// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMergedStream.h"

#include "vtkMTMeshMerge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>

namespace
{
// As vtkMTPolyDataStream describes that of a merged mesh.
vtkMTArrayInfo DescribePartId()
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(3);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkMTMeshMerge::GetPartIdName());
  ids->InsertNextValue(0);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetCellData()->AddArray(ids);
  return vtkMTPolyDataStream(mesh).GetArrays().front();
}

vtkMTColumn MakePartIds(std::size_t part, std::size_t count)
{
  const std::vector<int> ids(count, static_cast<int>(part));
  vtkMTColumn column(count * sizeof(int));
  std::memcpy(column.data(), ids.data(), column.size());
  return column;
}

bool FitTogether(const std::vector<std::unique_ptr<vtkMTChunkStream>>& parts)
{
  const std::vector<vtkMTArrayInfo>& arrays = parts.front()->GetArrays();
  const bool isTaken = std::any_of(arrays.begin(), arrays.end(),
    [](const vtkMTArrayInfo& info) { return info.Name == vtkMTMeshMerge::GetPartIdName(); });
  return !isTaken &&
    std::all_of(parts.begin(), parts.end(),
      [&arrays](const std::unique_ptr<vtkMTChunkStream>& part)
      { return part->GetArrays() == arrays && part->HasPolygonsOnly() && part->GetNumberOfTriangles() > 0; });
}
}

std::unique_ptr<vtkMTTriangleStream> vtkMTMergedStream::Make(std::vector<std::unique_ptr<vtkMTChunkStream>> parts)
{
  return FitTogether(parts) ? std::unique_ptr<vtkMTTriangleStream>(new vtkMTMergedStream(std::move(parts))) : nullptr;
}

vtkMTMergedStream::vtkMTMergedStream(std::vector<std::unique_ptr<vtkMTChunkStream>> parts)
  : Parts(std::move(parts))
  , Arrays(this->Parts.front()->GetArrays())
{
  this->Arrays.push_back(DescribePartId());
  for (const auto& part : this->Parts)
  {
    this->Points += part->GetNumberOfPoints();
    this->Triangles += part->GetNumberOfTriangles();
  }
  this->AddUpReports();
}

void vtkMTMergedStream::AddUpReports()
{
  this->Report.clear();
  for (const auto& part : this->Parts)
  {
    for (const auto& [reason, count] : part->GetReport())
    {
      this->Report[reason] += count;
    }
  }
}

bool vtkMTMergedStream::Fail(std::size_t part)
{
  this->Error = this->Parts[part]->GetError();
  return false;
}

bool vtkMTMergedStream::Rewind()
{
  this->PointPart = this->TrianglePart = 0;
  this->FirstPoint = this->FirstCell = 0;
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    if (!this->Parts[part]->Rewind())
    {
      return this->Fail(part);
    }
  }
  this->AddUpReports();
  return true;
}

bool vtkMTMergedStream::NextPoints(PointBlock& block)
{
  for (block = PointBlock(); this->PointPart < this->Parts.size(); ++this->PointPart)
  {
    if (!this->Parts[this->PointPart]->NextPoints(block))
    {
      return this->Fail(this->PointPart);
    }
    if (!block.Points.empty())
    {
      return true;
    }
  }
  return true;
}

bool vtkMTMergedStream::NextTriangles(TriangleBlock& block)
{
  for (block = TriangleBlock(); this->TrianglePart < this->Parts.size(); ++this->TrianglePart)
  {
    vtkMTChunkStream& part = *this->Parts[this->TrianglePart];
    if (!part.NextTriangles(block))
    {
      return this->Fail(this->TrianglePart);
    }
    if (!block.Triangles.empty())
    {
      break;
    }
    this->FirstPoint += part.GetNumberOfPoints();
    this->FirstCell += part.GetNumberOfCells();
  }
  for (std::size_t t = 0; t < block.Triangles.size(); ++t)
  {
    for (std::uint64_t& point : block.Triangles[t])
    {
      // One that the file does not have must not become one of another file.
      const bool isKnown = point < this->Parts[this->TrianglePart]->GetNumberOfPoints();
      point = isKnown ? point + this->FirstPoint : std::max(point, this->Points);
    }
    block.CellIds[t] += static_cast<std::int64_t>(this->FirstCell);
  }
  if (!block.Triangles.empty())
  {
    block.Columns.push_back(MakePartIds(this->TrianglePart, block.Triangles.size()));
  }
  else
  {
    this->AddUpReports();
  }
  return true;
}
