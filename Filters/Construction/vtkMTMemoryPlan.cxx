// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemoryPlan.h"

#include "vtkMTArrayInfo.h"
#include "vtkMTTriangleStream.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;

// Buffers, and blocks of the input without their values.
constexpr double Base = 24.0 * MiB;
// Blocks of the input, or pieces of its file, that are in hand at a time: triangles, and copies of their values.
constexpr double BlockTriangles = 65536.0;
constexpr double CopiesOfBlock = 4.0;
constexpr double CopiesAhead = 4.0; // more of them, where other threads are at work as well
// Simplifying a region, and cutting a fragment: bytes per triangle, and copies of its values.
constexpr double PerFloorTriangle = 900.0;
constexpr double CopiesOfFloor = 5.0;
constexpr double PerCutTriangle = 300.0;
constexpr double CopiesOfCut = 4.0;
// What a record of a patch has per triangle beside values.
constexpr double PerRecordTriangle = 22.0;
// The sample, and the seeds' relaxation: bytes per triangle of the mesh.
constexpr double Sample = 1.5;
// The DAG's records in builder, graph and sink: bytes per patch.
constexpr double PerPatch = 600.0;

// What no machine has is said as 2^60, so that sums of several fit as well.
std::uint64_t ToBytes(double bytes)
{
  constexpr std::uint64_t most = std::uint64_t(1) << 60;
  return bytes < static_cast<double>(most) ? static_cast<std::uint64_t>(bytes) : most;
}
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
  const double values = 1.0 * pointValues + cellValues;
  const double ofTriangle = 0.5 * pointValues + cellValues; // there are half as many points
  const double record = PerRecordTriangle + ofTriangle;
  this->PerByteSimplified = (PerFloorTriangle + CopiesOfFloor * ofTriangle) / record;
  this->PerByteCut = (PerCutTriangle + CopiesOfCut * ofTriangle) / record;
  const double floor = 2.0 * settings.GetRegionTarget();
  const double patches = 2.2 * triangles / static_cast<double>(settings.PatchTriangles) + 16.0;
  const double copies = CopiesOfBlock + (settings.Threads > 1 ? CopiesAhead : 0.0);
  const double standing = Base + BlockTriangles * copies * values + triangles * Sample + patches * PerPatch;
  // A region for each thread, and half a one that waits to be taken over.
  const double work = (settings.Threads + 0.5) * floor * this->PerByteSimplified * record;
  this->Blocks = ToBytes(0.5 * Base + BlockTriangles * copies * values);
  this->Standing = ToBytes(standing);
  this->Fixed = ToBytes(standing + work);
  // The largest sorts that are alive at a time: places and edges, or triangles and points by region.
  this->Whole = ToBytes(16.0 * MiB + 4.0 * (triangles + points) * (96.0 + values));
  // Fragments, patches and barycentres of the finest level, and the model itself: more than at any time before.
  this->SpoolSize = ToBytes(triangles * (68.0 + 2.0 * cellValues) + points * (58.0 + 2.0 * pointValues) + MiB);
}

std::size_t vtkMTMemoryPlan::GetSortMemory(std::uint64_t limit) const
{
  return static_cast<std::size_t>(limit == 0 ? this->Whole : std::min(this->Whole, limit - this->Fixed));
}

std::uint64_t vtkMTMemoryPlan::GetWorkMemory(std::uint64_t limit) const
{
  return limit == 0 ? 0 : limit - this->Standing;
}

// While blocks are in hand no region is: they may have that as well.
std::uint64_t vtkMTMemoryPlan::GetBlockMemory(std::uint64_t limit) const
{
  return limit == 0 ? 0 : this->GetWorkMemory(limit) - this->GetSortMemory(limit) + this->Blocks;
}

void vtkMTMemoryPlan::Apply(std::uint64_t limit, vtkMTBuildSettings& settings) const
{
  settings.MemoryLimit = limit;
  settings.SortMemory = this->GetSortMemory(limit);
  settings.WorkMemory = this->GetWorkMemory(limit);
  settings.BlockMemory = this->GetBlockMemory(limit);
  settings.MemoryPerByteSimplified = this->PerByteSimplified;
  settings.MemoryPerByteCut = this->PerByteCut;
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
