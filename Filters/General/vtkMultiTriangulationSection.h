// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationSection
 * @brief the lines in which an implicit function is zero on a Multi-Triangulation
 *
 * What vtkCutter makes of a mesh, without the mesh: the cut is refined to the asked error where the function can be
 * zero and stays as coarse as conformity allows elsewhere, and of it only those patches are read whose boxes the
 * function can be zero in. So the cost follows the section and not the model.
 *
 * The patches that are read are welded by identity, and a line's ends belong to edges of the welded mesh. Patches of a
 * cut share their border points (Cignoni et al., "Batched Multi Triangulation", 2005, section 3.1), so the section has
 * no gap where patches meet: on a closed manifold every point has two lines, and the lines are closed loops. Where the
 * mesh has wedges, as along the seam of a texture, points are doubled, place by place, as they are in the mesh. Lines
 * of length 0 occur where the function is exactly zero at a point of the mesh. Each cell of the output is one line of
 * two points, which run so that the negative side is on their left; vtkStripper joins them.
 *
 * Point arrays are interpolated along the edges; ids and labels come from the nearer end, normals are scaled to length
 * 1, global ids are left out. Cell arrays are those of the triangle that a line lies in; the input's ids are -1 on
 * triangles of coarser levels where the model keeps them on the finest level alone.
 *
 * Every point of a section is within SectionError of the input surface. That bounds the distance of the surfaces; how
 * far the lines are from those of the input depends on the angle at which the function meets the surface, too.
 *
 * For which functions it is certain that no patch is missed, and what is done with others, is described at
 * vtkMultiTriangulationCutFilter. The function and all lengths are in the coordinates of the input object.
 *
 * The filter reports progress and can be aborted; the output is then empty. Errors: vtkErrorMacro and an error code:
 * vtkErrorCode::UserError when there is no function, FileFormatError for patches that cannot be read, UnknownError for
 * input without patches. An abort has UserError and raises no event.
 *
 * @sa vtkMultiTriangulation vtkMultiTriangulationCutFilter
 */
#ifndef vtkMultiTriangulationSection_h
#define vtkMultiTriangulationSection_h

#include "vtkMTFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataArraySelection;
class vtkImplicitFunction;

class VTKMTFILTERS_EXPORT vtkMultiTriangulationSection : public vtkPolyDataAlgorithm
{
public:
  static vtkMultiTriangulationSection* New();
  vtkTypeMacro(vtkMultiTriangulationSection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whose zeros are looked for. Default none, which is an error.
  void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  ///@}

  ///@{
  /**
   * The largest certified distance of the patches to the input, in the units of the input object. Default 0; negative
   * values are clamped to 0; NaN is ignored, with a warning. Where the finest level does not reach it, that is taken.
   */
  void SetError(double error);
  vtkGetMacro(Error, double);
  ///@}

  ///@{
  /// Which arrays the output has. Arrays that a selection does not know are there; the filter makes those of its input
  /// known when it runs.
  vtkDataArraySelection* GetPointArraySelection();
  vtkDataArraySelection* GetCellArraySelection();
  ///@}

  ///@{
  /**
   * Whether the output has two arrays of cells more, DistanceToInput and DistanceFromInput: what is certified of the
   * patch that a line lies in, in the units of the input object. No point of the patch is farther from the input than
   * the first one, and no point of that part of the input which the patch stands for is farther from the patch than the
   * second one. Default off.
   */
  vtkSetMacro(GenerateDistances, bool);
  vtkGetMacro(GenerateDistances, bool);
  vtkBooleanMacro(GenerateDistances, bool);
  ///@}

  ///@{
  /// Of the last section: patches that were read, and their largest certified distance to the input.
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(SectionError, double);
  ///@}

  vtkMTimeType GetMTime() override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationSection();
  ~vtkMultiTriangulationSection() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMultiTriangulationSection(const vtkMultiTriangulationSection&) = delete;
  void operator=(const vtkMultiTriangulationSection&) = delete;

  int Fail(unsigned long code, const std::string& message);

  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
  double Error = 0.0;
  bool GenerateDistances = false;
  vtkSmartPointer<vtkDataArraySelection> Selections[2];
  vtkIdType NumberOfPatches = 0;
  double SectionError = 0.0;
};

#endif
