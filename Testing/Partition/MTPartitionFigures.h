// SPDX-License-Identifier: BSD-3-Clause
// What is measured of partitions.
#ifndef MTPartitionFigures_h
#define MTPartitionFigures_h

#include "MTPartitionMeshes.h"
#include "vtkMTPartition.h"
#include "vtkMTPartitionStrategy.h"

#include <memory>
#include <string>

namespace MTPartitionTest
{
using Regions = std::vector<std::uint32_t>;

Regions LocateAll(const vtkMTPartition& partition, const Points& barycentres);

struct Figures
{
  std::size_t Regions = 0;
  std::size_t Empty = 0;
  double Mean = 0.0;    ///< triangles in a region that is not empty, over the target
  double Largest = 0.0; ///< over the target
  double Small = 0.0;   ///< share of the regions that have less than a quarter of the target
  /// Regions above four times the target, and above what their most frequent barycentre and the target allow.
  std::size_t Overfull = 0;
};

Figures Measure(const vtkMTPartition& partition, const Points& barycentres, double target);

void Print(const std::string& name, const Figures& figures);

struct Borders
{
  std::size_t First = 0;  ///< edges between two regions of the first partition
  std::size_t Second = 0; ///< of the second
  std::size_t Both = 0;   ///< of both
  double GetShare() const
  {
    return static_cast<double>(this->Both) / static_cast<double>(this->Second > 0 ? this->Second : 1);
  }
};

/// Borders of two partitions of a mesh that are the same edges.
Borders CompareBorders(const Mesh& mesh, const Regions& first, const Regions& second);

struct Elements
{
  std::size_t Count = 0;  ///< elements of the crossing
  double PerRegion = 0.0; ///< per region of the first partition
  double Small = 0.0;     ///< share of elements with less than a tenth of the mean
};

Elements MeasureCrossing(const Regions& first, const Regions& second);

/// Seconds of processor time that this process has taken, of all its threads: what other processes do has little
/// influence.
double GetSeconds();

/// The regions of some triangles by a strategy.
std::unique_ptr<vtkMTPartition> BuildPartition(
  const vtkMTPartitionStrategy* strategy, const Points& barycentres, double target, int level);
}

#endif
