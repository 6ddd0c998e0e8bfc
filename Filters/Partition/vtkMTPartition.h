// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPartition
 * @brief a partition of space into regions: it tells in which region a point lies
 *
 * BMT section 4: a triangle goes by its barycentre. Immutable once made; Locate may be called from any number of
 * threads. Coordinates are those of the scan that it was built from (steps of the lattice in the builder, model units
 * in a filter).
 */
#ifndef vtkMTPartition_h
#define vtkMTPartition_h

#include "vtkMTPartitionModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

class VTKMTPARTITION_EXPORT vtkMTPartition
{
public:
  virtual ~vtkMTPartition();

  virtual std::uint32_t GetNumberOfRegions() const = 0;

  /// The region of a point: the same for the same coordinates, always. Ties go to the smaller index.
  virtual std::uint32_t Locate(const std::array<double, 3>& x) const = 0;

  /// The same for many points; fast where neighbours in the list are neighbours in space.
  virtual void LocateAll(const std::array<double, 3>* points, std::size_t count, std::uint32_t* regions) const;

  /// The point that stands for the region: its seed.
  virtual std::array<double, 3> GetSeed(std::uint32_t region) const = 0;
};

/**
 * A sequential scan over the barycentres of a mesh's triangles, repeatable as often as wanted: all that a strategy sees
 * of a mesh, so that meshes larger than memory can be partitioned (BMT section 4.2.2).
 */
class VTKMTPARTITION_EXPORT vtkMTBarycentreScan
{
public:
  virtual ~vtkMTBarycentreScan();
  using Block = std::function<void(const std::array<double, 3>* barycentres, std::size_t count)>;
  virtual std::size_t GetNumberOfTriangles() const = 0;
  /// How many there would be on this level of a sequence if every step made exactly the reduction's share of them; 0,
  /// which it is here: not known. So a strategy can have its exact share of regions whatever simplification left.
  virtual double GetNominalTriangles() const { return 0.0; }
  /// Calls block for all barycentres in order, a few thousand at a time. False when the scan failed.
  virtual bool Scan(const Block& block) = 0;
};

#endif
