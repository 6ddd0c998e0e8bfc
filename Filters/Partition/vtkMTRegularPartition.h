// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegularPartition
 * @brief regular V-partitions: cube, face and edge centres of a grid that is halved again and again
 *
 * Cignoni et al., "Batched Multi Triangulation" (2005), section 4.2.1, in three dimensions: seeds on cube centres, face
 * centres and edge centres of a regular grid, then the same on the grid of half the cell size; Voronoi regions are
 * cubes and octahedra, and those of successive families have no border in common. Cell sizes are powers of two and the
 * grid passes through the origin of the coordinates, so that the partitions of one sequence fit into one another
 * whatever mesh each of them is built on. The nearest seed is found in closed form; only regions that hold a barycentre
 * are numbered, by family and place.
 *
 * The family is the one whose non-empty regions come nearest to the target in their mean number of triangles, on a
 * sample of the barycentres. Face and edge centres have about the same number of regions: odd levels use the faces,
 * even levels the edges. Cubes are used only where their mean is within a factor of 2^(1/4) of the target, or where
 * faces and edges are farther off by more than a factor of 2^(1/2). So two successive partitions are of the same family
 * only when they ask for nearly the same number of cubes. The mean is within a factor of about 1.7 of the target on an
 * evenly sampled surface.
 *
 * Regions of more than MaximumOverload times the target are replaced by those of the next finer family (or of the
 * family whose cells have the size of what the region holds, if that is much smaller), among the triangles of such
 * regions only, until none is left, except where barycentres coincide or differ by less than 2^-52 of the largest
 * coordinate.
 *
 * A point in a cell without barycentres is in the region with the nearest seed.
 *
 * Memory: SamplesPerRegion barycentres and a hash table entry for each region. Barycentres that are not finite have no
 * influence and are in region 0.
 */
#ifndef vtkMTRegularPartition_h
#define vtkMTRegularPartition_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkMTPartitionStrategy.h"

class VTKMTPARTITION_EXPORT vtkMTRegularPartition : public vtkMTPartitionStrategy
{
public:
  static vtkMTRegularPartition* New();
  vtkTypeMacro(vtkMTRegularPartition, vtkMTPartitionStrategy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Barycentres of a region of the target's size that are kept in memory for choosing the family. Default 64; clamped
   * to [8, 65536]. All are kept where the target is less than twice that.
   */
  vtkSetClampMacro(SamplesPerRegion, int, 8, 65536);
  vtkGetMacro(SamplesPerRegion, int);
  ///@}

  std::unique_ptr<vtkMTPartition> Build(vtkMTBarycentreScan& scan, double target, int level) const override;
  const char* GetStrategyName() const override { return "regular"; }
  std::string GetSettings() const override;

protected:
  vtkMTRegularPartition();
  ~vtkMTRegularPartition() override;

private:
  vtkMTRegularPartition(const vtkMTRegularPartition&) = delete;
  void operator=(const vtkMTRegularPartition&) = delete;

  int SamplesPerRegion = 64;
};

#endif
