// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTKdPartition
 * @brief regions that are the boxes of a k-d tree, divided at a third or at two thirds in turn from level to level
 *
 * What Nexus builds from (Cignoni et al., "Batched Multi Triangulation" (2005), section 4, for what a partition has to
 * be; the splitting is that of Nexus's builder): barycentres are inserted into a tree in an order that looks like
 * chance (vtkMTStreamShuffle), and a leaf that is full is divided across the longest side of what it holds. On even
 * levels a third lies below the plane and on odd levels two thirds, so that the planes of successive partitions, which
 * are made of nearly the same surface, do not coincide. Placing is a way down a tree, the fastest that there is;
 * regions are boxes, so their parts of the surface are less compact than Voronoi regions, and their borders are
 * straighter.
 *
 * A leaf is full at Target / 0.6365: halving by shares p and 1 - p leaves leaves filled by -(p ln p + (1 - p) ln (1 -
 * p)) in the mean, so the mean region has about the target. Regions of more than MaximumOverload times the target are
 * halved until there is none, but where barycentres coincide.
 *
 * Memory: SamplesPerRegion to twice that many barycentres for a region, and about 100 bytes for each region.
 * Barycentres that are not finite have no influence and are in region 0.
 */
#ifndef vtkMTKdPartition_h
#define vtkMTKdPartition_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkMTPartitionStrategy.h"

class VTKMTPARTITION_EXPORT vtkMTKdPartition : public vtkMTPartitionStrategy
{
public:
  static vtkMTKdPartition* New();
  vtkTypeMacro(vtkMTKdPartition, vtkMTPartitionStrategy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Barycentres of a region of the target's size that are inserted, at least; the rest is only counted. Default 64;
   * clamped to [8, 65536]. All are inserted where the target is less than twice that.
   */
  vtkSetClampMacro(SamplesPerRegion, int, 8, 65536);
  vtkGetMacro(SamplesPerRegion, int);
  ///@}

  std::unique_ptr<vtkMTPartition> Build(vtkMTBarycentreScan& scan, double target, int level) const override;
  const char* GetStrategyName() const override { return "kd"; }
  std::string GetSettings() const override;

protected:
  vtkMTKdPartition();
  ~vtkMTKdPartition() override;

private:
  vtkMTKdPartition(const vtkMTKdPartition&) = delete;
  void operator=(const vtkMTKdPartition&) = delete;

  int SamplesPerRegion = 64;
};

#endif
