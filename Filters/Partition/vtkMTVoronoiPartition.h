// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVoronoiPartition
 * @brief irregular V-partitions: seeds that follow the triangles, relaxed
 *
 * Cignoni et al., "Batched Multi Triangulation" (2005), section 4.2.2: a triangle belongs to the nearest seed of a seed
 * set that is found by scanning the mesh's barycentres. Seeds are placed, relaxed and completed:
 *
 * 1. A sample of the barycentres (SamplesPerRegion of the target) is taken in one scan. With SeedPlacement ALONG_CURVE
 * it is sorted along a Hilbert curve and split into chunks of equal counts; the mean of each chunk is a seed. So the
 * seeds follow the number of triangles, however their density varies. Curves of different levels lie differently, so
 * that successive partitions are not cut in the same places. With RADIUS_SCAN, the paper's way, a second scan makes a
 * seed of each barycentre that is farther than a radius from all seeds before it; the radius is found by bisection on
 * the sample.
 * 2. LloydSteps times, on the sample: regions with less than SmallRegion of the target lose their seed, the other seeds
 * move to the mean of their region (Lloyd's relaxation). With ALONG_CURVE, regions of more than twice the target are
 * split again along a curve of their own instead.
 * 3. All barycentres are counted, scan by scan; regions of more than MaximumOverload times the target get further seeds
 *    among their own barycentres until none is left. What remains above the bound are regions where more than
 * MaximumOverload - 1 times the target coincide with the seed, and these hold at most the target besides.
 *
 * Memory: the sample (SamplesPerRegion barycentres for each region) and a few numbers per region; never all
 * barycentres. Barycentres that are not finite have no influence and are in region 0. Distances are squared in double
 * precision: coordinates may be anything from 1e-140 to 1e140.
 */
#ifndef vtkMTVoronoiPartition_h
#define vtkMTVoronoiPartition_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkMTPartitionStrategy.h"

class VTKMTPARTITION_EXPORT vtkMTVoronoiPartition : public vtkMTPartitionStrategy
{
public:
  static vtkMTVoronoiPartition* New();
  vtkTypeMacro(vtkMTVoronoiPartition, vtkMTPartitionStrategy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SeedPlacementType
  {
    ALONG_CURVE = 0,
    RADIUS_SCAN = 1
  };

  ///@{
  /// How the first seeds are found. Default ALONG_CURVE; clamped to [ALONG_CURVE, RADIUS_SCAN].
  vtkSetClampMacro(SeedPlacement, int, ALONG_CURVE, RADIUS_SCAN);
  vtkGetMacro(SeedPlacement, int);
  void SetSeedPlacementToAlongCurve() { this->SetSeedPlacement(ALONG_CURVE); }
  void SetSeedPlacementToRadiusScan() { this->SetSeedPlacement(RADIUS_SCAN); }
  ///@}

  ///@{
  /// Steps of Lloyd's relaxation. Default 2; clamped to [0, 100]. With 0, small regions are kept.
  vtkSetClampMacro(LloydSteps, int, 0, 100);
  vtkGetMacro(LloydSteps, int);
  ///@}

  ///@{
  /// Regions with less than this share of the target are removed in each step. Default 0.25; clamped to [0, 0.9].
  vtkSetClampMacro(SmallRegion, double, 0.0, 0.9);
  vtkGetMacro(SmallRegion, double);
  ///@}

  ///@{
  /**
   * Barycentres of a region of the target's size that are kept in memory for placing and relaxing seeds. Default 64;
   * clamped to [8, 65536]. All are kept where the target is less than twice that.
   */
  vtkSetClampMacro(SamplesPerRegion, int, 8, 65536);
  vtkGetMacro(SamplesPerRegion, int);
  ///@}

  std::unique_ptr<vtkMTPartition> Build(vtkMTBarycentreScan& scan, double target, int level) const override;
  const char* GetStrategyName() const override { return "v"; }
  std::string GetSettings() const override;

protected:
  vtkMTVoronoiPartition();
  ~vtkMTVoronoiPartition() override;

private:
  vtkMTVoronoiPartition(const vtkMTVoronoiPartition&) = delete;
  void operator=(const vtkMTVoronoiPartition&) = delete;

  int SeedPlacement = ALONG_CURVE;
  int LloydSteps = 2;
  double SmallRegion = 0.25;
  int SamplesPerRegion = 64;
};

#endif
