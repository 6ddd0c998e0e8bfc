// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTEdgeCollapse
 * @brief simplification by edge collapse, under locks, seams and any topology
 *
 * The cheapest edge is collapsed until the target is reached (Hoppe, "Progressive Meshes", 1996). The floor is made an
 * oriented manifold first: its points are split into fans where they must be, and everything non-manifold keeps its
 * place. A collapse is refused when it would break the link condition, turn a triangle by a right angle or more, lay
 * two neighbouring triangles back to back, or join two locked points by a new edge (two regions might each make that
 * edge). Where seams run, collapses follow them, so every triangle keeps attributes of one side. Closed components end
 * as tetrahedra at the least. When a floor stays above its target, small holes are closed, which no outside triangle
 * touches and which have shrunk to three edges; then whole small components are left out (see vtkMTComponentRemoval),
 * and what remains is counted by cause. No collapse makes a vertex of more than 512 edges, or takes part in one
 * ("valence"), so that the time is in proportion to the floor whatever its shape.
 *
 * Modes. FAST uses memoryless area-weighted quadrics (Garland and Heckbert 1997; Lindstrom and Turk, "Evaluation of
 * Memoryless Simplification", 1999) in a loop of the toolkit's own: it asks again, after a collapse, for the costs at
 * the kept vertex only, and takes edges whose costs differ by less than a thirty-second in no particular order. BEST is
 * the same in CGAL's edge_collapse(), which asks for all costs within two rings: six times slower and one or two
 * percent nearer to the floor; a floor with a vertex of more than 64 edges, with which CGAL's loop takes time by the
 * cube of them, is left to FAST. LINDSTROM_TURK and GARLAND_HECKBERT are CGAL's policies of these names, with the same
 * locks, for comparison.
 *
 * This class's implementation includes CGAL, which is under the GPL.
 */
#ifndef vtkMTEdgeCollapse_h
#define vtkMTEdgeCollapse_h

#include "vtkMTSimplificationModule.h" // For export macro
#include "vtkMTSimplifier.h"

class vtkMTCollapseRegion;

class VTKMTSIMPLIFICATION_EXPORT vtkMTEdgeCollapse : public vtkMTSimplifier
{
public:
  static vtkMTEdgeCollapse* New();
  vtkTypeMacro(vtkMTEdgeCollapse, vtkMTSimplifier);

  enum ModeType
  {
    FAST = 0,
    BEST = 1,
    LINDSTROM_TURK = 2,
    GARLAND_HECKBERT = 3
  };

  ///@{
  /// Default FAST. Values outside the enumeration are clamped to it.
  vtkSetClampMacro(Mode, int, FAST, GARLAND_HECKBERT);
  vtkGetMacro(Mode, int);
  ///@}
  /// By the name that GetSimplifierName gives: "fast", "best", "lindstrom-turk" or "garland-heckbert". False, and
  /// nothing changed, for any other name.
  bool SetModeByName(const char* name);

  ///@{
  /**
   * Components with a bounding-box diagonal above this are never left out, and such holes never closed. Unit:
   * diagonals of the floor's own box. Default 0.125, range 0 (never any) to 1; values outside are clamped, NaN is
   * refused with an error.
   */
  void SetComponentBound(double value);
  vtkGetMacro(ComponentBound, double);
  ///@}

  ///@{
  /**
   * A watchdog: how many steps (costs asked for, edges taken from the queue) a region may use for each edge of its
   * floor before it ends with what it has, which is then counted as blocked by "steps". Default 1000, at least 1.
   * Ordinary regions need about 10.
   */
  vtkSetClampMacro(StepsPerEdge, int, 1, VTK_INT_MAX);
  vtkGetMacro(StepsPerEdge, int);
  ///@}

  /// See vtkMTSimplifier. A floor without any triangle of three different points gives an empty result.
  bool Simplify(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::size_t target,
    vtkMTSimplification& result, std::string& error) const override;

  const char* GetSimplifierName() const override;
  std::string GetSettings() const override;

protected:
  vtkMTEdgeCollapse();
  ~vtkMTEdgeCollapse() override;

private:
  vtkMTEdgeCollapse(const vtkMTEdgeCollapse&) = delete;
  void operator=(const vtkMTEdgeCollapse&) = delete;

  bool SimplifyOrThrow(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::size_t target,
    vtkMTSimplification& result, std::string& error) const;
  bool Collapse(vtkMTCollapseRegion& region, double largestHole, std::string& error) const;

  int Mode = FAST;
  double ComponentBound = 0.125;
  int StepsPerEdge = 1000;
};

#endif
