// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationLocator
 * @brief lets vtkCellPicker pick in what a vtkMultiTriangulationMapper has drawn
 *
 * By itself vtkCellPicker looks at a mapper's input, and a vtkMultiTriangulation's own cells are the coarsest cut. With
 * this locator it finds the triangle that was drawn, and gives the input's cell id:
 *
 *     locator->SetMapper(mapper);
 *     picker->AddLocator(locator);
 *     picker->Pick(x, y, 0.0, renderer); // GetCellId() is a cell of the input mesh
 *
 * On a coarse triangle that is the id of the input cell nearest to the place that was picked, among those that face the
 * same way where there are any (vtkMTInputIdFinder); of a model that keeps ids on all levels, that of the triangle.
 * Position and parametric coordinates are those of the drawn triangle. GetPointId, and the normal where the model has
 * point normals, come from the coarsest cut, whose nearest points stand for the triangle's, because the picker looks
 * them up in the mapper's input; so do not look up GetCellId there; GetInputPointId is the input's nearest point. Where
 * the model keeps no ids (no array of role InputCellIds), or they cannot be read, which is an error, every cell id is
 * 0.
 *
 * The line is tested against the boxes of the drawn patches, and then, from the nearest box on, against their
 * triangles, in double precision. Patches that are in main memory are used as they are. Only where a drawn patch is on
 * the GPU alone, and the line meets its box before it meets anything else, is it read, by the calling thread and
 * without waiting for the loader; likewise the ids of the one patch that is hit, where the mapper does not keep ids
 * with it, or the few patches of the finest level that can hold the input's nearest cell or point. So a pick takes no
 * longer than reading these few patches, a few milliseconds, and no frame is made to wait. A model whose graph is still
 * being read is waited for. Neighbours share their points bit for bit, so there is no crack to
 * fall through, and the picker's tolerance is not needed and not looked at.
 *
 * @sa vtkMultiTriangulationMapper vtkCellPicker
 */
#ifndef vtkMultiTriangulationLocator_h
#define vtkMultiTriangulationLocator_h

#include "vtkAbstractCellLocator.h"
#include "vtkMTRenderingOpenGL2Module.h" // For export macro
#include "vtkSmartPointer.h"

class vtkMultiTriangulationMapper;

class VTKMTRENDERINGOPENGL2_EXPORT vtkMultiTriangulationLocator : public vtkAbstractCellLocator
{
public:
  static vtkMultiTriangulationLocator* New();
  vtkTypeMacro(vtkMultiTriangulationLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The mapper in whose last frame is picked. None, the default, is never hit.
  void SetMapper(vtkMultiTriangulationMapper* mapper);
  vtkMultiTriangulationMapper* GetMapper();
  ///@}

  /// The mapper's input: by this vtkCellPicker knows whose locator it is.
  vtkDataSet* GetDataSet() override;

  using vtkAbstractCellLocator::IntersectWithLine;
  /// The first triangle on the way from p1 to p2, in the model's coordinates; t is 0 at p1 and 1 at p2.
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3], double pcoords[3],
    int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;

  ///@{
  /// Of the patch that was hit last (vtkMTGraph::GetDistanceToInput), in the units of the mapper's input: how far the
  /// place that was picked can be from the input's surface, and how far the part of the input that the patch stands for
  /// can be from the patch. 0 when nothing has been hit.
  vtkGetMacro(DistanceToInput, double);
  vtkGetMacro(DistanceFromInput, double);
  ///@}

  /// Of the input's points the one nearest to the place that was picked last; -1 where the model keeps no ids of points
  /// (vtkMultiTriangulationBuilder::SetInputPointIds), and when nothing has been hit.
  vtkGetMacro(InputPointId, vtkIdType);

  ///@{
  /// There is nothing to build: the cut is another one in every frame.
  void BuildLocator() override {}
  void FreeSearchStructure() override {}
  void GenerateRepresentation(int level, vtkPolyData* mesh) override;
  ///@}

protected:
  vtkMultiTriangulationLocator();
  ~vtkMultiTriangulationLocator() override;

private:
  vtkMultiTriangulationLocator(const vtkMultiTriangulationLocator&) = delete;
  void operator=(const vtkMultiTriangulationLocator&) = delete;

  vtkSmartPointer<vtkMultiTriangulationMapper> Mapper;
  double DistanceToInput = 0.0;
  double DistanceFromInput = 0.0;
  vtkIdType InputPointId = -1;
};

#endif
