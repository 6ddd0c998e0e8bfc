// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTHexagonPartition
 * @brief regions are hexagons, each level with a third of the regions of the next finer one
 *
 * Cignoni et al., "Batched Multi Triangulation" (2005), section 4.2.1, figure 7: seeds on the points of a triangle
 * lattice, of which every third is a seed of the next coarser level (dual sqrt-3 subdivision). The reduction of a level
 * is 3 and not 2, so there are fewer levels, each with larger steps between them; floors are simplified to a third. A
 * third of the hexagons lie within one of the next level and are one patch, the others are divided among three.
 *
 * On a sphere lattices lie on the sides of an icosahedron, and regions fold over its edges; 12 regions are pentagons.
 * The last steps, from 12 regions to 4 to 1, are not thirds. In a plane hexagons at the border of the mesh are bounded
 * by it, so a step that has few regions is a third only about.
 *
 * See vtkMTDomainPartition for what a domain is, and for which meshes this is good.
 */
#ifndef vtkMTHexagonPartition_h
#define vtkMTHexagonPartition_h

#include "vtkMTDomainPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

class VTKMTPARTITION_EXPORT vtkMTHexagonPartition : public vtkMTDomainPartition
{
public:
  static vtkMTHexagonPartition* New();
  vtkTypeMacro(vtkMTHexagonPartition, vtkMTDomainPartition);

  const char* GetStrategyName() const override { return "hexagon"; }
  double GetReduction() const override { return 3.0; }
  /// One in every third hexagon, three in the others.
  double GetPatchesPerRegion() const override { return 7.0 / 3.0; }

protected:
  vtkMTHexagonPartition();
  ~vtkMTHexagonPartition() override;

  std::unique_ptr<vtkMTDomainFamilies> MakeFamilies(
    const vtkMTDomain& domain, double largest, bool isOddLevel) const override;

private:
  vtkMTHexagonPartition(const vtkMTHexagonPartition&) = delete;
  void operator=(const vtkMTHexagonPartition&) = delete;
};

#endif
