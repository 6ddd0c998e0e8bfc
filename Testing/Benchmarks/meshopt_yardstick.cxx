// SPDX-License-Identifier: BSD-3-Clause
// meshopt_yardstick INPUT OUTPUT TRIANGLES [--lock-border]: simplifies a whole mesh in memory with meshoptimizer, to
// compare a cut or a build with.
#include "vtkMTMeshReader.h"
#include "vtkMTMeshWriter.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <meshoptimizer.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

namespace
{
bool GetTriangles(vtkPolyData* mesh, std::vector<float>& positions, std::vector<unsigned int>& indices)
{
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    positions.insert(positions.end(), { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) });
  }
  vtkIdType count;
  const vtkIdType* ids;
  vtkCellArray* polys = mesh->GetPolys();
  for (polys->InitTraversal(); polys->GetNextCell(count, ids);)
  {
    if (count != 3)
    {
      return false;
    }
    indices.insert(indices.end(), ids, ids + 3);
  }
  return !indices.empty();
}

void SetTriangles(const std::vector<float>& positions, const std::vector<unsigned int>& indices, vtkPolyData* mesh)
{
  std::vector<vtkIdType> place(positions.size() / 3, -1);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (std::size_t i = 0; i < indices.size(); i += 3)
  {
    vtkIdType triangle[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      const unsigned int p = indices[i + c];
      if (place[p] < 0)
      {
        place[p] = points->InsertNextPoint(&positions[3 * std::size_t(p)]);
      }
      triangle[c] = place[p];
    }
    polys->InsertNextCell(3, triangle);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
}
}

int main(int argc, char* argv[])
{
  const std::size_t target = argc == 4 || argc == 5 ? std::strtoull(argv[3], nullptr, 10) : 0;
  if (target == 0)
  {
    std::fprintf(stderr, "usage: meshopt_yardstick INPUT OUTPUT TRIANGLES [--lock-border]\n");
    return 2;
  }
  vtkNew<vtkPolyData> mesh;
  std::string error;
  if (!vtkMTMeshReader::Read(argv[1], mesh, error))
  {
    std::fprintf(stderr, "meshopt_yardstick: %s\n", error.c_str());
    return 1;
  }
  std::vector<float> positions;
  std::vector<unsigned int> indices;
  if (!GetTriangles(mesh, positions, indices))
  {
    std::fprintf(stderr, "meshopt_yardstick: %s holds other cells than triangles\n", argv[1]);
    return 1;
  }
  std::vector<unsigned int> simplified(indices.size());
  const unsigned int options = argc > 4 && std::strcmp(argv[4], "--lock-border") == 0 ? meshopt_SimplifyLockBorder : 0;
  const std::clock_t start = std::clock();
  simplified.resize(meshopt_simplify(simplified.data(), indices.data(), indices.size(), positions.data(),
    positions.size() / 3, 3 * sizeof(float), 3 * target, 1e30f, options));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  vtkNew<vtkPolyData> result;
  SetTriangles(positions, simplified, result);
  if (!vtkMTMeshWriter::Write(argv[2], result, error))
  {
    std::fprintf(stderr, "meshopt_yardstick: %s\n", error.c_str());
    return 1;
  }
  std::printf("{\"triangles_in\": %zu, \"triangles\": %zu, \"cpu_s\": %.3f}\n", indices.size() / 3,
    simplified.size() / 3, seconds);
  return 0;
}
