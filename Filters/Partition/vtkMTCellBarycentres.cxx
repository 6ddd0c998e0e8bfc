// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCellBarycentres.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdTypeArray.h"
#include "vtkMTArrayScan.h"
#include "vtkMTBarycentreSample.h"
#include "vtkMTLocateBlock.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace
{
using Point = vtkMTCellBarycentres::Point;

Point GetBarycentre(vtkPoints* points, vtkIdType count, const vtkIdType* ids)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (count == 0)
  {
    return { nan, nan, nan };
  }
  // Relative to the first point, so that a place far from the origin costs no precision.
  Point first;
  points->GetPoint(ids[0], first.data());
  Point sum = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 1; i < count; ++i)
  {
    Point point;
    points->GetPoint(ids[i], point.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += point[axis] - first[axis];
    }
  }
  const double n = static_cast<double>(count);
  return { first[0] + sum[0] / n, first[1] + sum[1] / n, first[2] + sum[2] / n };
}

class ProgressScan : public vtkMTArrayScan
{
public:
  ProgressScan(const std::vector<Point>& barycentres, const vtkMTCellBarycentres::Progress& progress)
    : vtkMTArrayScan(barycentres)
    , Progress(progress)
  {
  }

  bool Scan(const Block& block) override
  {
    if (!vtkMTArrayScan::Scan(block))
    {
      return false;
    }
    this->Left *= 0.5;
    return this->Progress(1.0 - this->Left);
  }

private:
  const vtkMTCellBarycentres::Progress& Progress;
  double Left = 1.0;
};
}

std::vector<Point> vtkMTCellBarycentres::Make(vtkPolyData* mesh)
{
  std::vector<Point> barycentres;
  barycentres.reserve(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      barycentres.push_back(GetBarycentre(mesh->GetPoints(), count, ids));
    }
  }
  return barycentres;
}

std::size_t vtkMTCellBarycentres::CountNotFinite(const std::vector<Point>& barycentres)
{
  return static_cast<std::size_t>(std::count_if(barycentres.begin(), barycentres.end(),
    [](const Point& point) { return !vtkMTBarycentreSample::IsFinite(point); }));
}

std::unique_ptr<vtkMTPartition> vtkMTCellBarycentres::Build(const vtkMTPartitionStrategy& strategy,
  const std::vector<Point>& barycentres, double target, int level, const Progress& progress)
{
  ProgressScan scan(barycentres, progress);
  return strategy.Build(scan, target, level);
}

vtkSmartPointer<vtkIdTypeArray> vtkMTCellBarycentres::MakeRegionArray(
  const vtkMTPartition& partition, const std::vector<Point>& barycentres, const std::string& name)
{
  auto regions = vtkSmartPointer<vtkIdTypeArray>::New();
  regions->SetName(name.c_str());
  regions->SetNumberOfTuples(static_cast<vtkIdType>(barycentres.size()));
  std::vector<std::uint32_t> located(barycentres.size());
  vtkMTLocateBlock::Locate(partition, barycentres.data(), barycentres.size(), located.data());
  std::copy(located.begin(), located.end(), regions->GetPointer(0));
  return regions;
}
