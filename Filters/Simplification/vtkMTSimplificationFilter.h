// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSimplificationFilter
 * @brief simplifies a polydata with the toolkit's simplifier, as a filter of its own
 *
 * The input's polygons and strips are triangulated; vertices and lines are left out. Points are snapped to a lattice
 * (see vtkMTLattice), simplified by vtkMTEdgeCollapse as one region, and brought back: a point that nothing has moved
 * keeps its input coordinates bit for bit. Point arrays: such a point keeps its values; a point that has moved takes
 * those of the nearest place of the input, interpolated in its triangle; normals are scaled to unit length. Cell arrays
 * take the values of the input triangle nearest to the new triangle's barycentre. Field data passes.
 *
 * Identity is that of the input's point indices: points that lie at the same place are not merged, so a mesh that is
 * split open along its seams stays closed only while LockBorder is on.
 *
 * Errors (the output is then empty): vtkErrorCode::UserError for points that are not finite numbers, UnknownError when
 * the simplifier fails.
 */
#ifndef vtkMTSimplificationFilter_h
#define vtkMTSimplificationFilter_h

#include "vtkMTEdgeCollapse.h"
#include "vtkMTSimplificationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector>

struct vtkMTLattice;

class VTKMTSIMPLIFICATION_EXPORT vtkMTSimplificationFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkMTSimplificationFilter* New();
  vtkTypeMacro(vtkMTSimplificationFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// One of vtkMTEdgeCollapse's modes. Default FAST; clamped to the enumeration.
  vtkSetClampMacro(Mode, int, vtkMTEdgeCollapse::FAST, vtkMTEdgeCollapse::GARLAND_HECKBERT);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /// The part of the triangles to take away. Default 0.5, range 0 to 1, clamped. Not used when TargetTriangles is above
  /// 0.
  vtkSetClampMacro(TargetReduction, double, 0.0, 1.0);
  vtkGetMacro(TargetReduction, double);
  ///@}

  ///@{
  /// The number of triangles wanted; 0, the default, to go by TargetReduction instead. Negative values become 0.
  vtkSetClampMacro(TargetTriangles, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(TargetTriangles, vtkIdType);
  ///@}

  ///@{
  /// Whether points on edges with one triangle keep their place. Default on.
  vtkSetMacro(LockBorder, bool);
  vtkGetMacro(LockBorder, bool);
  vtkBooleanMacro(LockBorder, bool);
  ///@}

  ///@{
  /// Bits of the lattice along the box's longest side. Default vtkMTLattice::DefaultBits (24), range 10 to 31, clamped.
  vtkSetClampMacro(LatticeBits, int, 10, 31);
  vtkGetMacro(LatticeBits, int);
  ///@}

  ///@{
  /// What became of the last input: edges that nothing could collapse when the target was not reached, and components
  /// left out.
  vtkGetMacro(NumberOfBlockedEdges, vtkIdType);
  vtkGetMacro(NumberOfRemovedComponents, vtkIdType);
  ///@}

protected:
  vtkMTSimplificationFilter();
  ~vtkMTSimplificationFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMTSimplificationFilter(const vtkMTSimplificationFilter&) = delete;
  void operator=(const vtkMTSimplificationFilter&) = delete;

  bool MakeFloor(vtkPolyData* mesh, vtkMTLattice& lattice, vtkMTPatch& floor);
  std::vector<unsigned char> MakeLocks(const vtkMTPatch& floor) const;
  std::size_t GetTarget(std::size_t triangles) const;
  static void MakeOutput(
    vtkPolyData* mesh, const vtkMTLattice& lattice, const vtkMTSimplification& result, vtkPolyData* output);

  int Mode = vtkMTEdgeCollapse::FAST;
  double TargetReduction = 0.5;
  vtkIdType TargetTriangles = 0;
  bool LockBorder = true;
  int LatticeBits = 24;
  vtkIdType NumberOfBlockedEdges = 0;
  vtkIdType NumberOfRemovedComponents = 0;
};

#endif
