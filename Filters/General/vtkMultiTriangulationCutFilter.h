// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationCutFilter
 * @brief a cut of a Multi-Triangulation as one conforming, welded mesh
 *
 * Input is a vtkMultiTriangulation with patches, output its mesh at the resolution that was asked for: for every
 * filter, writer and mapper that knows polydata and nothing else. A point appears more than once only where its
 * attribute values differ (wedges). Any cut of a Multi-Triangulation is conforming (Cignoni et al., "Batched Multi
 * Triangulation", 2005, section 3.1), however its resolution varies; a closed manifold gives closed manifolds.
 *
 * Which cut, is what the last of these calls asked for:
 *
 *     SetError(e)           the coarsest cut that is certified to be within e of the input
 *     SetTriangleLimit(n)   the most precise cut of at most n triangles
 *     SetLevel(l)           one level, 0 being the finest
 *     SetRenderer(r), SetView(camera, width, height)
 *                           the coarsest cut that a picture shows within PixelError pixels of the input; what lies
 *                           outside the frustum is as coarse as the rest allows. No window is needed with SetView.
 *
 * None: SetError with no limit, which is the coarsest cut.
 *
 * A region of interest (SetRegion) confines what was asked for to where its function is negative or zero; elsewhere the
 * cut is as coarse as OutsideError and conformity allow. Promised is: every patch of the output whose box, grown by its
 * error, the function can be negative in, is as fine as asked. Because the input surface that a patch stands for lies
 * within that grown box, the surface inside the region is as fine as asked, too. What "can be negative in a box" means:
 * planes (vtkPlane, vtkPlanes), vtkSphere, vtkBox, their unions, intersections and differences (vtkImplicitBoolean),
 * all of these with linear transforms, are looked at by their geometry, and the promise is certain. Of any other
 * function nothing is known between two of its values, which are no distances in general; it is sampled at 5 x 5 x 5
 * points of each box, and twice the steepest gradient found there bounds what is between them. Features that are
 * smaller than a quarter of a patch's box and that no sample's gradient gives away can be missed: give their bounding
 * box as region.
 *
 * All lengths, the region and the camera are in the coordinates of the input object: what
 * vtkMultiTriangulationTransform has done to it is taken into account.
 *
 * The input's ids: where the model keeps them on its finest level alone, as builders make them, the arrays
 * vtkMTInputCellIds and vtkMTInputPointIds are -1 for triangles and points of coarser patches, unless FindInputIds has
 * the nearest ones looked for.
 *
 * The filter reports progress and can be aborted; the output is then empty. Errors: vtkErrorMacro, GetErrorMessage and
 * an error code: vtkErrorCode::UserError for what cannot be given (fewer triangles than the coarsest cut, a smaller
 * error than the finest level's, a level that is not there, a view without size), FileFormatError for patches that
 * cannot be read, UnknownError for input without patches. The output is then empty. An abort has UserError and raises
 * no event.
 *
 * @sa vtkMultiTriangulation vtkMultiTriangulationSection vtkMultiTriangulationTransform
 */
#ifndef vtkMultiTriangulationCutFilter_h
#define vtkMultiTriangulationCutFilter_h

#include "vtkMTFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <string>

class vtkCamera;
class vtkDataArraySelection;
class vtkImplicitFunction;
class vtkMTCut;
class vtkRenderer;

class VTKMTFILTERS_EXPORT vtkMultiTriangulationCutFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkMultiTriangulationCutFilter* New();
  vtkTypeMacro(vtkMultiTriangulationCutFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    BY_ERROR = 0,
    BY_TRIANGLES = 1,
    BY_LEVEL = 2,
    BY_VIEW = 3
  };
  /// What the last call asked for.
  vtkGetMacro(Mode, int);

  ///@{
  /**
   * Chooses BY_ERROR: the largest certified distance to the input, in the units of the input object. Default
   * VTK_DOUBLE_MAX, the coarsest cut. Negative values are clamped to 0; NaN is ignored, with a warning. That the finest
   * level does not reach the error is an error.
   */
  void SetError(double error);
  vtkGetMacro(Error, double);
  ///@}

  ///@{
  /**
   * Chooses BY_TRIANGLES: triangles at most. Default 0; negative values are clamped to 0. A limit of 50 mean patches or
   * more is filled to at least 90 %, unless the finest level has fewer (or a region asks for no more). Less than the
   * coarsest cut has is an error.
   */
  void SetTriangleLimit(vtkIdType limit);
  vtkGetMacro(TriangleLimit, vtkIdType);
  ///@}

  ///@{
  /// Chooses BY_LEVEL: 0, the default, is the finest. Negative values are clamped to 0. A level that the model does not
  /// have is an error.
  void SetLevel(int level);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Chooses BY_VIEW: the view of a renderer's active camera, as large as the renderer is in its window when the filter
   * runs. The renderer is not kept alive. The filter runs again when camera, renderer or window have been modified.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * Chooses BY_VIEW: the view of a camera in a picture of width times height pixels. What is outside its clipping range
   * counts as not seen. A size that is not positive is an error when the filter runs.
   */
  void SetView(vtkCamera* camera, int width, int height);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /// Of a view: how far, in pixels, a picture may be from that of the input. Default 1; clamped to [0, 1e9]; NaN is
  /// ignored, with a warning. Does not choose the mode.
  void SetPixelError(double error);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /// Where the cut is to be as fine as asked: where this function is negative or zero. Default none: everywhere.
  void SetRegion(vtkImplicitFunction* region);
  vtkImplicitFunction* GetRegion();
  ///@}

  ///@{
  /**
   * With a region: the largest certified distance to the input outside of it, in the units of the input object. Default
   * VTK_DOUBLE_MAX: as coarse as can be. Where the finest level does not reach it, that is taken. Negative values are
   * clamped to 0; NaN is ignored, with a warning. A limit of triangles holds all the same.
   */
  void SetOutsideError(double error);
  vtkGetMacro(OutsideError, double);
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
   * patch that a triangle is of, in the units of the input object. No point of the patch is farther from the input than
   * the first one, and no point of that part of the input which the patch stands for is farther from the patch than the
   * second one. Default off.
   */
  vtkSetMacro(GenerateDistances, bool);
  vtkGetMacro(GenerateDistances, bool);
  vtkBooleanMacro(GenerateDistances, bool);
  ///@}

  ///@{
  /**
   * Whether the input's ids that coarse triangles and points lack are looked for: of the cell that is nearest to a
   * triangle's barycentre, among those that face the same way where there are any, and of the point that is nearest to
   * a point. For that the finest patches below the cut are read. Off, the default: they are -1.
   */
  vtkSetMacro(FindInputIds, bool);
  vtkGetMacro(FindInputIds, bool);
  vtkBooleanMacro(FindInputIds, bool);
  ///@}

  ///@{
  /**
   * Figures of the cut that the output is; 0 when there is none. In the units of the input object: no point of the cut
   * is farther from the input than DistanceToInput, none of the input farther from the cut than DistanceFromInput;
   * CutError is the larger one. They are 0 where the cut is the input's own coordinates (Exact), bit for bit.
   */
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(CutError, double);
  vtkGetMacro(DistanceToInput, double);
  vtkGetMacro(DistanceFromInput, double);
  vtkGetMacro(Exact, bool);
  vtkGetMacro(FinestLevel, int);
  vtkGetMacro(CoarsestLevel, int);
  ///@}

  /// Why there is no output; empty when there is.
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

  vtkMTimeType GetMTime() override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationCutFilter();
  ~vtkMultiTriangulationCutFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMultiTriangulationCutFilter(const vtkMultiTriangulationCutFilter&) = delete;
  void operator=(const vtkMultiTriangulationCutFilter&) = delete;

  struct Model;

  bool FindCut(const Model& model, vtkMTCut& cut);
  bool FindRegionCut(const Model& model, vtkMTCut& cut);
  bool FindView(Model& model);
  void Describe(const Model& model, const vtkMTCut& cut);
  void Choose(int mode);
  int Fail(unsigned long code, const std::string& message);

  int Mode = BY_ERROR;
  double Error;
  vtkIdType TriangleLimit = 0;
  int Level = 0;
  double PixelError = 1.0;
  double OutsideError;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkCamera> Camera;
  std::array<int, 2> Size{ 0, 0 };
  vtkSmartPointer<vtkImplicitFunction> Region;
  vtkSmartPointer<vtkDataArraySelection> Selections[2];

  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfPatches = 0;
  bool GenerateDistances = false;
  bool FindInputIds = false;
  double CutError = 0.0;
  double DistanceToInput = 0.0;
  double DistanceFromInput = 0.0;
  bool Exact = false;
  int FinestLevel = 0;
  int CoarsestLevel = 0;
  std::string ErrorMessage;
};

#endif
