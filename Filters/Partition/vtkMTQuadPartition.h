// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTQuadPartition
 * @brief regions are the faces and, in turn, the edges of a quadrangulation that is subdivided
 *
 * Cignoni et al., "Batched Multi Triangulation" (2005), section 4.2.1, in two dimensions: seeds on the centres of
 * squares, then on the mid-points of their edges, "and so on". Every step halves the number of regions exactly; regions
 * are squares, straight and tilted by 45 degrees in turn, and the crossing of two of them is the bintree of right
 * triangles that terrain is known to be good with (BDAM). A plane is one quad, or a row of them where the mesh is long;
 * a sphere is the six sides of a cube, over whose edges the regions of edges fold, so no border stays locked. Only the
 * last steps on a sphere, from 6 regions to 3 to 1, are not halves.
 *
 * See vtkMTDomainPartition for what a domain is, and for which meshes this is good.
 */
#ifndef vtkMTQuadPartition_h
#define vtkMTQuadPartition_h

#include "vtkMTDomainPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

class VTKMTPARTITION_EXPORT vtkMTQuadPartition : public vtkMTDomainPartition
{
public:
  static vtkMTQuadPartition* New();
  vtkTypeMacro(vtkMTQuadPartition, vtkMTDomainPartition);

  const char* GetStrategyName() const override { return "quad"; }
  /// Two triangles of the bintree in each square.
  double GetPatchesPerRegion() const override { return 2.0; }

protected:
  vtkMTQuadPartition();
  ~vtkMTQuadPartition() override;

  std::unique_ptr<vtkMTDomainFamilies> MakeFamilies(
    const vtkMTDomain& domain, double largest, bool isOddLevel) const override;

private:
  vtkMTQuadPartition(const vtkMTQuadPartition&) = delete;
  void operator=(const vtkMTQuadPartition&) = delete;
};

#endif
