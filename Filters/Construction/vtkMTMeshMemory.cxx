// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshMemory.h"

#include "vtkMTArrayInfo.h"
#include "vtkMTBuildSettings.h"
#include "vtkMTDirectDeviation.h"
#include "vtkMTTriangleStream.h"

#include <algorithm>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;

// Buffers, and blocks of the input without their values.
constexpr double Base = 24.0 * MiB;
// Blocks of the input, or of its file, that are worked on at a time: triangles, and copies of their values.
constexpr double BlockTriangles = 65536.0;
constexpr double CopiesOfBlock = 4.0;
constexpr double CopiesAhead = 4.0; // more of them, where other threads are at work as well
// Simplifying a region, and splitting a fragment: bytes per triangle, and copies of its values.
constexpr double PerFloorTriangle = 900.0;
constexpr double PerFinerTriangle = 350.0; // of what a fragment is held against
constexpr double CopiesOfFloor = 5.0;
constexpr double PerSplitTriangle = 300.0;
constexpr double CopiesOfSplit = 4.0;
// What a record of a patch has per triangle beside values.
constexpr double PerRecordTriangle = 26.0;
// The sample, and the seeds' relaxation: bytes per triangle of the mesh.
constexpr double Sample = 1.5;
// The DAG's records in builder, graph and sink: bytes per patch.
constexpr double PerPatch = 600.0;
// A partition's seeds with their neighbours: bytes per region.
constexpr double PerRegion = 300.0;
}

vtkMTMeshMemory::vtkMTMeshMemory(const vtkMTTriangleStream& input, const vtkMTBuildSettings& settings)
{
  const double triangles = static_cast<double>(input.GetNumberOfTriangles());
  const double points = static_cast<double>(input.GetNumberOfPoints());
  // Normals, residuals and ids.
  double pointValues = 12.0 + (settings.ExactPoints ? 24.0 : 0.0) + (settings.InputPointIds ? 8.0 : 0.0);
  double cellValues = 20.0; // ids and deviations
  for (const vtkMTArrayInfo& array : input.GetArrays())
  {
    (array.Association == vtkMTArrayInfo::Point ? pointValues : cellValues) +=
      static_cast<double>(array.GetTupleSize());
  }
  const double values = 1.0 * pointValues + cellValues;
  const double ofTriangle = 0.5 * pointValues + cellValues; // there are half as many points
  const double record = PerRecordTriangle + ofTriangle;
  const double finerOfFloor =
    settings.KeepsFinerLevels() ? PerFinerTriangle * vtkMTDirectDeviation::MostPerTriangle : 0.0;
  const double perFloorTriangle = PerFloorTriangle + finerOfFloor;
  this->PerByteSimplified = (perFloorTriangle + CopiesOfFloor * ofTriangle) / record;
  this->PerByteSplit = (PerSplitTriangle + CopiesOfSplit * ofTriangle) / record;
  const double patches = 2.2 * triangles / static_cast<double>(settings.PatchTriangles) + 16.0;
  const double copies = CopiesOfBlock + (settings.Threads > 1 ? CopiesAhead : 0.0);
  const double blocks = BlockTriangles * copies * values;
  const double regions = triangles / settings.GetRegionTarget() + 16.0;
  this->Needs.Standing = Base + blocks + triangles * Sample + patches * PerPatch + regions * PerRegion;
  // A region for each thread, and half a one that waits to be taken over.
  const double smaller = std::max(0.0, vtkMTDirectDeviation::LeastFloor - settings.GetFloorTarget());
  this->Needs.Work =
    (settings.Threads + 0.5) * (settings.GetFloorTarget() * this->PerByteSimplified * record + finerOfFloor * smaller);
  this->Needs.Blocks = 0.5 * Base + blocks;
  // The largest sorts that are alive at a time: places and edges, or triangles and points by region.
  this->Needs.Sorts = 16.0 * MiB + 4.0 * (triangles + points) * (96.0 + values);
  const double finer = settings.KeepsFinerLevels() ? 14.0 : 0.0;
  // Fragments and patches of the finest level, and the model itself: more than at any time before.
  this->Needs.Spools = triangles * (44.0 + finer + 2.0 * cellValues) + points * (58.0 + 2.0 * pointValues) + MiB;
}
