// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportYardsticks.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTSimplificationFilter.h"

#include "vtkBinnedDecimation.h"
#include "vtkCellArray.h"
#include "vtkDecimatePro.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadricClustering.h"
#include "vtkQuadricDecimation.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace
{
using MTReportYardsticks::Mesh;
using MTReportYardsticks::Work;

// The same input without what filters have kept of it.
template <class Filter>
Mesh RunFilter(Filter* filter, vtkPolyData* mesh)
{
  filter->SetInputData(mesh);
  filter->Update();
  Mesh result = filter->GetOutput();
  return result;
}

double GetReduction(vtkPolyData* mesh, vtkIdType triangles)
{
  return 1.0 - static_cast<double>(triangles) / static_cast<double>(mesh->GetNumberOfCells());
}

Work PrepareQuadricDecimation(vtkPolyData* mesh, vtkIdType triangles)
{
  return [=]
  {
    vtkNew<vtkQuadricDecimation> filter;
    filter->SetTargetReduction(GetReduction(mesh, triangles));
    return RunFilter(filter.Get(), mesh);
  };
}

Work PrepareDecimatePro(vtkPolyData* mesh, vtkIdType triangles)
{
  return [=]
  {
    vtkNew<vtkDecimatePro> filter;
    filter->SetTargetReduction(GetReduction(mesh, triangles));
    filter->PreserveTopologyOn();
    filter->SplittingOff();
    return RunFilter(filter.Get(), mesh);
  };
}

// Clusterings take numbers of bins: those of about cubes, so many along the longest side.
template <class Filter>
Mesh RunClustering(vtkPolyData* mesh, int divisions)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  std::array<double, 3> sides;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = bounds[2 * i + 1] - bounds[2 * i];
  }
  const double longest = *std::max_element(sides.begin(), sides.end());
  const auto count = [&](int i) { return std::max(1, static_cast<int>(std::lround(divisions * sides[i] / longest))); };
  vtkNew<Filter> filter;
  filter->AutoAdjustNumberOfDivisionsOff();
  filter->SetNumberOfDivisions(count(0), count(1), count(2));
  return RunFilter(filter.Get(), mesh);
}

// With the number of bins that comes nearest to the number of triangles.
template <class Filter>
Work PrepareClustering(vtkPolyData* mesh, vtkIdType triangles)
{
  const auto hasMore = [=](int divisions)
  { return RunClustering<Filter>(mesh, divisions)->GetNumberOfCells() > triangles; };
  // In small steps: memory grows with the cube of the number.
  int high = 2 + static_cast<int>(0.2 * std::sqrt(static_cast<double>(triangles)));
  int low = 1;
  while (!hasMore(high) && high < 400)
  {
    low = high;
    high += 1 + high / 4;
  }
  while (high - low > 1)
  {
    const int middle = (low + high) / 2;
    (hasMore(middle) ? high : low) = middle;
  }
  const auto getGap = [&](int divisions)
  { return std::abs(RunClustering<Filter>(mesh, divisions)->GetNumberOfCells() - triangles); };
  const int best = getGap(low) <= getGap(high) ? low : high;
  return [=] { return RunClustering<Filter>(mesh, best); };
}

// A mesh as meshoptimizer takes it.
struct Arrays
{
  std::vector<float> Positions;
  std::vector<unsigned int> Indices;
};

Arrays GetArrays(vtkPolyData* mesh)
{
  Arrays arrays;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    arrays.Positions.insert(
      arrays.Positions.end(), { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) });
  }
  vtkIdType count;
  const vtkIdType* ids;
  for (mesh->GetPolys()->InitTraversal(); mesh->GetPolys()->GetNextCell(count, ids);)
  {
    arrays.Indices.insert(arrays.Indices.end(), ids, ids + 3);
  }
  return arrays;
}

Mesh MakeMesh(vtkPoints* points, const std::vector<unsigned int>& indices)
{
  vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3)
  {
    const vtkIdType triangle[3] = { indices[i], indices[i + 1], indices[i + 2] };
    triangles->InsertNextCell(3, triangle);
  }
  Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

Work PrepareMeshoptimizer(vtkPolyData* mesh, vtkIdType triangles)
{
  const auto arrays = std::make_shared<Arrays>(GetArrays(mesh));
  return [=]
  {
    std::vector<unsigned int> result(arrays->Indices.size());
    result.resize(meshopt_simplify(result.data(), arrays->Indices.data(), arrays->Indices.size(),
      arrays->Positions.data(), arrays->Positions.size() / 3, 3 * sizeof(float), 3 * std::size_t(triangles), 1e30f, 0));
    return MakeMesh(mesh->GetPoints(), result);
  };
}
}

Work MTReportYardsticks::PrepareOwn(const std::string& simplifier, vtkPolyData* mesh, vtkIdType triangles)
{
  vtkNew<vtkMTEdgeCollapse> collapse;
  collapse->SetModeByName(simplifier.c_str());
  return [=, mode = collapse->GetMode()]
  {
    vtkNew<vtkMTSimplificationFilter> filter;
    filter->SetMode(mode);
    filter->SetTargetTriangles(triangles);
    filter->LockBorderOff();
    return RunFilter(filter.Get(), mesh);
  };
}

const std::vector<MTReportYardsticks::Yardstick>& MTReportYardsticks::GetOthers()
{
  static const std::vector<Yardstick> others{ { "vtkQuadricDecimation", PrepareQuadricDecimation },
    { "vtkDecimatePro", PrepareDecimatePro }, { "vtkQuadricClustering", PrepareClustering<vtkQuadricClustering> },
    { "vtkBinnedDecimation", PrepareClustering<vtkBinnedDecimation> }, { "meshoptimizer", PrepareMeshoptimizer } };
  return others;
}
