// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDomainPartition
 * @brief regions from a subdivision of a plane or a sphere that the mesh is seen from
 *
 * What vtkMTQuadPartition and vtkMTHexagonPartition have in common. Barycentres are projected to the domain, straight
 * down to a plane or from the middle to a sphere, and the domain is subdivided in the same way everywhere. So the
 * regions of all levels are known beforehand: the partition of every level is the next finer one with GetReduction()
 * times fewer regions, exactly where the mesh covers the domain, and no border of one is a border of the next but at
 * the corners of regions, of which half or a third are corners on the next level.
 *
 * The subdivision is even in the domain and not in triangles: where the mesh has twice as many triangles over the same
 * place a region has twice as many. Regions of more than MaximumOverload times the target are replaced by those of
 * finer families, two, four, six or eight levels finer, and by cells of a grid in space where that is not enough.
 * Regions with few triangles stay. So terrain sampled in a grid is what planes are for, planets and star-shaped things
 * (balls, heads, potatoes) are for spheres; other meshes are partitioned as correctly, but several sheets over one
 * place of the domain are one region of several components, and their sizes vary: choose vtkMTVoronoiPartition for
 * them.
 *
 * The family is the one whose regions have the target in the mean where the mesh covers the domain, or else a finer one
 * so that there are enough regions that are not empty, judged by a sample of 64 barycentres for each region. In
 * sequences that do not grow by the reduction two levels may be of one family: odd sums of family and level divide a
 * domain that is turned, whose borders are elsewhere. Regions of the same family have the same area in a plane (but
 * for hexagons at its border), and up to 1.5 times the mean one's on a sphere.
 *
 * Memory: 64 to 128 barycentres and a hash table entry for each region. Barycentres that are not finite have no
 * influence and are in region 0.
 */
#ifndef vtkMTDomainPartition_h
#define vtkMTDomainPartition_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkMTPartitionStrategy.h"

class vtkMTDomain;
class vtkMTDomainFamilies;

class VTKMTPARTITION_EXPORT vtkMTDomainPartition : public vtkMTPartitionStrategy
{
public:
  vtkTypeMacro(vtkMTDomainPartition, vtkMTPartitionStrategy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DomainType
  {
    AUTOMATIC = 0,
    PLANE = 1,
    SPHERE = 2
  };

  ///@{
  /**
   * What the mesh is projected to. PLANE: the two longest sides of the barycentres' box; the third is left out. SPHERE:
   * from the middle of the box. AUTOMATIC, the default: a plane where the box's least side is at most half as long as
   * the middle one, a sphere elsewhere. Clamped to these.
   */
  vtkSetClampMacro(Domain, int, AUTOMATIC, SPHERE);
  vtkGetMacro(Domain, int);
  void SetDomainToAutomatic() { this->SetDomain(AUTOMATIC); }
  void SetDomainToPlane() { this->SetDomain(PLANE); }
  void SetDomainToSphere() { this->SetDomain(SPHERE); }
  ///@}

  std::unique_ptr<vtkMTPartition> Build(vtkMTBarycentreScan& scan, double target, int level) const override;
  std::string GetSettings() const override;

protected:
  vtkMTDomainPartition();
  ~vtkMTDomainPartition() override;

  /// The families of a domain, for meshes with coordinates up to `largest`.
  virtual std::unique_ptr<vtkMTDomainFamilies> MakeFamilies(
    const vtkMTDomain& domain, double largest, bool isOddLevel) const = 0;

private:
  vtkMTDomainPartition(const vtkMTDomainPartition&) = delete;
  void operator=(const vtkMTDomainPartition&) = delete;

  int Domain = AUTOMATIC;
};

#endif
