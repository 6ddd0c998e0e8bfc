// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemoryPlan.h"

#include "vtkMTArrayInfo.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTTriangleStream.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;

// Blocks of the input, buffers, code.
constexpr double Base = 48.0 * MiB;
// Working on one region: bytes per triangle of its floor; and for what waits to be taken over.
constexpr double PerFloorTriangle = 2600.0;
constexpr double PerWaitingTriangle = 400.0;
// The sample, and the seeds' relaxation: bytes per triangle of the mesh.
constexpr double Sample = 1.5;
// The DAG's records in builder, graph and sink: bytes per patch.
constexpr double PerPatch = 600.0;
}

vtkMTMemoryPlan::vtkMTMemoryPlan(const vtkMTTriangleStream& input, const vtkMTBuildSettings& settings)
{
  const double triangles = static_cast<double>(input.GetNumberOfTriangles());
  const double points = static_cast<double>(input.GetNumberOfPoints());
  double pointValues = 12.0 + (settings.ExactPoints ? 24.0 : 0.0); // normals and residuals
  double cellValues = 16.0;                                        // ids and reach
  for (const vtkMTArrayInfo& array : input.GetArrays())
  {
    (array.Association == vtkMTArrayInfo::Point ? pointValues : cellValues) +=
      static_cast<double>(array.GetTupleSize());
  }
  const double floor = 2.0 * settings.GetRegionTarget();
  const double values = 1.0 * pointValues + cellValues;
  const double slots = static_cast<double>(vtkMTOrderedWork::GetNumberOfSlots(settings.Threads));
  const double patches = 2.2 * triangles / static_cast<double>(settings.PatchTriangles) + 16.0;
  const double fixed = Base + settings.Threads * floor * (PerFloorTriangle + 4.0 * values) +
    slots * floor * (PerWaitingTriangle + 2.0 * values) + triangles * Sample + patches * PerPatch;
  this->Fixed = static_cast<std::uint64_t>(fixed);
  // The largest sorts that are alive at a time: places and edges, or triangles and points by region.
  this->Whole = static_cast<std::uint64_t>(16.0 * MiB + 4.0 * (triangles + points) * (96.0 + values));
  // Fragments, patches and barycentres of the finest level, and the model itself: more than at any time before.
  this->SpoolSize =
    static_cast<std::uint64_t>(triangles * (68.0 + 2.0 * cellValues) + points * (58.0 + 2.0 * pointValues) + MiB);
}

std::size_t vtkMTMemoryPlan::GetSortMemory(std::uint64_t limit) const
{
  return static_cast<std::size_t>(limit == 0 ? this->Whole : std::min(this->Whole, limit - this->Fixed));
}

std::string vtkMTMemoryPlan::ToText(std::uint64_t bytes)
{
  const double mebibytes = std::ceil(static_cast<double>(bytes) / MiB);
  char text[64];
  if (mebibytes < 1024.0)
  {
    std::snprintf(text, sizeof(text), "%.0f MiB", mebibytes);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f GiB", std::ceil(mebibytes / 102.4) / 10.0);
  }
  return text;
}
