// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationMapper
 * @brief draws a Multi-Triangulation, as finely as the view needs
 *
 * A mapper for any vtkActor. In every frame it finds the cut that shows the model within a given number of pixels of
 * error (see vtkMTTargetCut and vtkMTCutFollower; Cignoni et al., "Batched Multi Triangulation", 2005, section 5), has
 * loader threads read the patches that it lacks (vtkMTPatchCache), and draws them with the shaders of
 * vtkOpenGLPolyDataMapper: property, lights, scalar colouring, textures, clipping planes, edges, translucency and
 * picking are VTK's own. Patches that a clipping plane takes away whole are not drawn, and do not count. All passes of
 * a frame that look through the same camera share one cut, and so do both eyes of a stereo picture. Several renderers
 * and windows may share a mapper: each has its own cut, patches in main memory are shared by all, those on the GPU by
 * all renderers of a window.
 *
 * Input is a vtkMultiTriangulation with a patch source. Any other vtkPolyData is drawn as vtkPolyDataMapper draws it.
 *
 * Points reach the GPU as lattice integers; the shader subtracts, in integers, a lattice point near the camera and only
 * then computes in floating point, with matrices that were multiplied in double precision on the CPU. So a scene at UTM
 * coordinates does not jitter, and a point that patches share comes out the same in each of them, bit for bit: no
 * cracks.
 *
 * Scalars: the scalar mode, array name or id, lookup table and range mean what they mean for the coarsest cut, which
 * the input's own points and cells are. Of an array in the input's field data, the tuple that SetFieldDataTupleId names
 * colours everything. Normals are the model's active point normals, texture coordinates and tangents likewise.
 *
 * Colours: an array of three or four components that is of bytes, or whose name ("RGB", "COLOR_0", "Colors" ...) or
 * component names say that it is colours, is drawn as it is unless the colour mode is MapScalars: floating point from 0
 * to 1, bytes and 16-bit values are converted (as VTK's DirectScalars, but for integers above 255, of which that keeps
 * the lowest byte). Where the scalar mode is the default one and no scalars are active, the first array of colours is
 * drawn, of points or else of cells. An array that carries a lookup table with annotations, as ids of groups and
 * materials do, is coloured by that table. Of arrays that the finest level alone has, as ids, coarse patches show the
 * colour of -1.
 *
 * Arrays that are not part of the model, because a filter has added them, have values on its coarsest cut alone: they
 * are not drawn, and a warning says so once. Elevations can be, by SetColorByElevation.
 *
 * Picking: vtkHardwareSelector gives the input's cell ids where the model keeps them, and otherwise the place of the
 * triangle in the arena, which means nothing outside of it; for points, the values of the array that
 * SetPointIdArrayName names, or the input's point ids. Where the finest level alone has ids, those of a coarse triangle
 * or vertex are looked for below it, for all pixels together, by threads; the selector waits, the mapper tells
 * progress, and what has not been found when AbortExecute is set, or cannot be read, is not selected. Software pickers
 * look at the coarsest cut. With a vtkMultiTriangulationLocator vtkCellPicker picks in what was drawn, and its cell ids
 * are the input's.
 *
 * @sa vtkMultiTriangulation vtkMultiTriangulationLocator vtkMTTargetCut
 */
#ifndef vtkMultiTriangulationMapper_h
#define vtkMultiTriangulationMapper_h

#include "vtkMTRenderingOpenGL2Module.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory> // For std::unique_ptr
#include <string>
#include <vector>

class vtkDataArray;
class vtkMTGraph;
struct vtkMTArrayInfo;
struct vtkMTPatch;

class VTKMTRENDERINGOPENGL2_EXPORT vtkMultiTriangulationMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkMultiTriangulationMapper* New();
  vtkTypeMacro(vtkMultiTriangulationMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far, in pixels, the picture of the surface may be from that of the input. Default 1; clamped to [0, 1e9]; NaN
   * is refused with an error event. At 0 everything that can be seen and deviates from the input at all is drawn as
   * finely as it is stored.
   */
  void SetPixelError(double pixels);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /**
   * Triangles drawn in a frame at most; 0, the default, is no limit. Negative values are clamped to 0. The coarsest cut
   * is drawn even when it has more, and so is a frozen one.
   */
  vtkSetClampMacro(TriangleLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(TriangleLimit, vtkIdType);
  ///@}

  enum WaitForConvergenceType
  {
    WAIT_NEVER = 0,
    WAIT_ALWAYS = 1,
    WAIT_WHEN_STILL = 2
  };

  ///@{
  /**
   * Whether a frame waits until everything that it needs is there. WAIT_NEVER: it draws what is there, the coarsest
   * patches at least, while loader threads bring the rest; GetLoading says whether another frame would be better.
   * WAIT_ALWAYS: for pictures and tests, which then do not depend on timing. WAIT_WHEN_STILL, the default: it waits
   * unless the window asks for a frame rate, as an interactor does while the camera moves (DesiredUpdateRate of 0.01
   * frames per second or more). On and Off mean ALWAYS and NEVER. Other values are clamped. A frozen cut is waited for.
   */
  vtkSetClampMacro(WaitForConvergence, int, WAIT_NEVER, WAIT_WHEN_STILL);
  vtkGetMacro(WaitForConvergence, int);
  vtkBooleanMacro(WaitForConvergence, int);
  ///@}

  ///@{
  /**
   * Bytes that a frame which does not wait sends to the GPU at most, the coarsest patches not counted: the cut is
   * refined by no more patches than that. 0 is no limit; default 16 MiB; negative values are clamped to 0. It should be
   * a few times what the largest patch takes: a patch that takes more is not drawn in such a frame.
   */
  vtkSetClampMacro(UploadLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(UploadLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Seconds after which a frame that does not wait stops looking for a better cut and draws the one that it has. 0 is
   * no limit; default 0.01; clamped to [0, 1e9]; NaN is refused with an error event.
   */
  void SetCutTimeLimit(double seconds);
  vtkGetMacro(CutTimeLimit, double);
  ///@}

  ///@{
  /**
   * Whether patches around the cut are loaded when there is nothing more urgent: coarser ones, finer ones and those
   * just outside the view. Default on. Only in windows that have an interactor, or in frames that do not wait:
   * otherwise the camera does not move while they come.
   */
  vtkSetMacro(Prefetch, bool);
  vtkGetMacro(Prefetch, bool);
  vtkBooleanMacro(Prefetch, bool);
  ///@}

  ///@{
  /// Threads that read and decode patches, from the next input on. Default 2; clamped to [1, 64].
  vtkSetClampMacro(NumberOfLoaderThreads, int, 1, 64);
  vtkGetMacro(NumberOfLoaderThreads, int);
  ///@}

  enum ErrorMetricType
  {
    DISTANCE = 0,
    EDGE_LENGTH = 1,
    NORMAL_DEVIATION = 2,
    VALUE = 3
  };

  ///@{
  /**
   * What PixelError is compared with: the certified distance to the input (the default), which says where the surface
   * is; the mean edge length (BMT section 5.1), which says how finely it can be shaded; the normal deviation, which
   * spends triangles where shading shows them (vtkMTTargetCut says how); or the values of an array, see below. Models
   * that were not built with CertifyNormals, or CertifiedValues, lack what the latter two go by and are drawn by the
   * larger one of the first two. Other values are clamped.
   */
  vtkSetClampMacro(ErrorMetric, int, DISTANCE, VALUE);
  vtkGetMacro(ErrorMetric, int);
  void SetErrorMetricToDistance() { this->SetErrorMetric(DISTANCE); }
  void SetErrorMetricToEdgeLength() { this->SetErrorMetric(EDGE_LENGTH); }
  void SetErrorMetricToNormalDeviation() { this->SetErrorMetric(NORMAL_DEVIATION); }
  void SetErrorMetricToValue() { this->SetErrorMetric(VALUE); }
  ///@}

  ///@{
  /**
   * For VALUE: the name of the array, default none, and the largest deviation of its values that is allowed, in the
   * array's units; default 0, clamped to [0, 1e300]; NaN is refused with an error event. What can be seen is refined
   * while its certified distance is above PixelError, and while the certified deviation of its values is above
   * ValueError and its mean edge length above PixelError: colours are right to within ValueError wherever a triangle is
   * large enough to be seen. AchievedPixelError stays that of the distance.
   */
  vtkSetStdStringFromCharMacro(ErrorMetricArray);
  vtkGetCharFromStdStringMacro(ErrorMetricArray);
  void SetValueError(double deviation);
  vtkGetMacro(ValueError, double);
  ///@}

  ///@{
  /**
   * Whether patches outside the frustum are left out. Default on. Off costs time and changes no pixel: what lies
   * outside stays as coarse as it was. In stereo what is outside of both eyes' frusta is left out.
   */
  vtkSetMacro(FrustumCulling, bool);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  ///@}

  ///@{
  /**
   * Whether patches that are seen from behind in all their triangles are left out, where the property's BackfaceCulling
   * is on and surfaces are drawn. Default on. Off costs time and changes no pixel. In stereo what both eyes see from
   * behind is left out.
   */
  vtkSetMacro(FacingCulling, bool);
  vtkGetMacro(FacingCulling, bool);
  vtkBooleanMacro(FacingCulling, bool);
  ///@}

  ///@{
  /// Whether the cut stays what it is while the camera moves. Default off. Culling goes on.
  vtkSetMacro(FreezeCut, bool);
  vtkGetMacro(FreezeCut, bool);
  vtkBooleanMacro(FreezeCut, bool);
  ///@}

  enum ColorByType
  {
    NONE = 0,
    LEVEL = 1,
    PATCH = 2,
    ERROR_IN_PIXELS = 3,
    ELEVATION = 4
  };

  ///@{
  /**
   * Colours that show the cut instead of the data: each level a hue (0, the finest, is green), each patch a hue, or the
   * pixel error of each patch (blue none, white half of PixelError, red all of it or more). ELEVATION: see
   * SetColorByElevation. Default NONE: property and scalars say the colour. Other values are clamped.
   */
  vtkSetClampMacro(ColorBy, int, NONE, ELEVATION);
  vtkGetMacro(ColorBy, int);
  void SetColorByToNone() { this->SetColorBy(NONE); }
  void SetColorByToLevel() { this->SetColorBy(LEVEL); }
  void SetColorByToPatch() { this->SetColorBy(PATCH); }
  void SetColorByToError() { this->SetColorBy(ERROR_IN_PIXELS); }
  ///@}

  ///@{
  /**
   * Colours by place, as vtkElevationFilter and the lookup table make them, but for every vertex of every patch: a
   * value that goes from range[0] at the low point to range[1] at the high point, along the line between them, and
   * stays the same beyond. The points are in the input's coordinates. Sets ColorBy to ELEVATION and the scalar range to
   * the same range; set another one afterwards to have the table span other values. Default points (0, 0, 0) and (0, 0,
   * 1), range 0 to 1. Points that are equal, and numbers that are not finite, are refused with an error event.
   */
  void SetColorByElevation(const double lowPoint[3], const double highPoint[3], const double range[2]);
  vtkGetVector3Macro(ElevationLowPoint, double);
  vtkGetVector3Macro(ElevationHighPoint, double);
  vtkGetVector2Macro(ElevationRange, double);
  ///@}

  /**
   * Has the scalars be the model's colours, whatever scalars are active: the first array of points that is colours, or
   * else of cells, or else "MaterialIds" where they carry the materials' colours. Turns ScalarVisibility on and gives
   * true; false, with nothing changed, where the input is no model or has no colours.
   */
  bool SelectColors();

  ///@{
  /**
   * Limits a texture of the actor's property (vtkProperty::SetTexture, by its name) to cells: those whose "MaterialIds"
   * are the material and whose "PartId" is the part, where -1, for either, is all; a cell has the first texture that it
   * may have. By default each texture is on all cells, as in VTK. A name that was given before gets the new cells, an
   * empty one or null is ignored. VTK takes all textures but the first by their blending mode: give them
   * VTK_TEXTURE_BLENDING_MODE_MODULATE.
   */
  void MapTextureToMaterial(const char* texture, int material, int part = -1);
  void RemoveTextureMappings();
  ///@}

  ///@{
  /**
   * Share number share, from 0, of count: what of the cut is drawn, where several processes that find the same cut
   * draw one picture. Shares are disjoint, about equal in triangles; number count is empty. Default 0 of 1: all.
   * Clamped: count to 1 or more, share to [0, count]. Figures are the share's. With WAIT_ALWAYS and a DrawingRate of
   * 1e15 the cut depends on nothing but the view.
   */
  void SetDrawnShare(int share, int count);
  vtkGetVector2Macro(DrawnShare, int);
  ///@}

  ///@{
  /**
   * Bytes of patches in main memory, with what loading takes: never more. Default 512 MiB; negative values are clamped
   * to 0. Of a patch that does not fit while it is read the coarser one is drawn, and an error is reported.
   */
  vtkSetClampMacro(PatchMemoryLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(PatchMemoryLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Bytes that buffers on the GPU take at most, copies while they grow included. Default 512 MiB; negative values are
   * clamped to 0. The cut becomes coarser where its patches need more than three quarters of it. The coarsest cut is
   * drawn in any case, so what that needs is the least limit there is. Windows that share a mapper share the limit in
   * equal parts, and so do, of a window's part, the renderers that draw it in turn.
   */
  vtkSetClampMacro(GraphicsMemoryLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(GraphicsMemoryLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * How many triangles are drawn in a second, by which the time that a renderer allows the actor becomes a number of
   * triangles; see vtkProp::GetAllocatedRenderTime, which a window's DesiredUpdateRate leads to. Default 0: the
   * window's whole frames are measured, whatever else is drawn in them, and the next ones' triangles are chosen so that
   * the median frame takes the time that is asked for, as far as the coarsest cut allows it; see vtkMTDrawingRate. All
   * models in the window share these triangles as its renderers share the time. Clamped to [0, 1e15]; NaN is refused
   * with an error event. While the camera is still, an interactor asks for 0.0001 frames per second, and without one
   * that is what a window asks for anyway, so then there is all the time that PixelError needs; a picture depends on
   * the clock only where a frame rate is asked for and nothing is set here.
   */
  void SetDrawingRate(double trianglesPerSecond);
  vtkGetMacro(DrawingRate, double);
  /// Triangles per second, set or measured in whole frames of the window that was drawn last; 0 while nothing has been
  /// measured. The frame in which the mapper is first drawn in a window is not measured.
  double GetCurrentDrawingRate();
  ///@}

  ///@{
  /**
   * Figures of the last frame. AchievedPixelError bounds, in pixels, how far anything in the picture is from where the
   * input would put it, whatever ErrorMetric says; it is infinite where the camera is closer to the surface than the
   * error. Converged: nothing that can be seen is above PixelError. Loading: the picture is not yet what the settings
   * ask for, so another frame may be a better one; it stays so where PatchMemoryLimit has no room for what is missing.
   * NumberOfTriangles and NumberOfPatches were drawn. The culled ones were left out for being outside the frustum,
   * those facing away for being seen from behind. Times are seconds: CutTime of the last new cut; FrameTime of the
   * mapper's part of the frame, reading and upload included, until the last command was given to OpenGL.
   */
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(NumberOfCulledPatches, vtkIdType);
  vtkGetMacro(NumberOfCulledTriangles, vtkIdType);
  vtkGetMacro(NumberOfFacingAwayPatches, vtkIdType);
  vtkGetMacro(NumberOfFacingAwayTriangles, vtkIdType);
  vtkGetMacro(NumberOfRefinedNodes, vtkIdType);
  vtkGetMacro(AchievedPixelError, double);
  vtkGetMacro(Converged, bool);
  vtkGetMacro(Loading, bool);
  vtkGetMacro(CutTime, double);
  vtkGetMacro(FrameTime, double);
  /// The part of it that was not spent in draw calls: cut, uploads, shaders, bookkeeping.
  vtkGetMacro(OverheadTime, double);
  ///@}

  ///@{
  /// Bytes of the GPU's buffers in all windows, now and at most so far, and of patches in main memory.
  vtkIdType GetGraphicsMemory();
  vtkIdType GetMostGraphicsMemory();
  vtkIdType GetPatchMemory();
  /// Cuts that were looked for, in this mapper's life: at most one for each renderer and frame, however many passes
  /// draw it and however many eyes look.
  vtkIdType GetNumberOfCuts();
  /// Patches read since the input was set, and bytes sent to the GPU in this mapper's life.
  vtkIdType GetNumberOfReads();
  vtkIdType GetNumberOfUploadedBytes();
  /// The most that PatchMemoryLimit has had to count so far, and the longest time, in seconds, that the loader's lock
  /// took from a frame.
  vtkIdType GetMostPatchMemory();
  double GetLongestLock();
  ///@}

  /// The mesh of the cut of the last frame, welded, culled patches included, with all arrays. False, with an error
  /// event, when nothing has been drawn yet or a patch cannot be read. findInputIds: whether the input's ids that
  /// coarse triangles and points lack (-1) are looked for, as vtkMultiTriangulationCutFilter::SetFindInputIds has it.
  bool GetCut(vtkPolyData* output, bool findInputIds = false);

  ///@{
  /// Of what was drawn in the last frame, in the units of the input object: no point of it is farther from the input
  /// than the first one, and no point of the input that it stands for is farther from it than the second one. 0 when
  /// nothing has been drawn.
  double GetDistanceToInput() const;
  double GetDistanceFromInput() const;
  ///@}

  /// The arcs of the model's graph whose patches were drawn in the last frame, ascending.
  std::vector<std::uint32_t> GetDrawnArcs() const;

  /// An arc's patch, if it is in main memory, or null. It has the arrays that were needed to draw it, at least. Waits
  /// for nothing.
  std::shared_ptr<const vtkMTPatch> GetPatchInMemory(std::uint32_t arc) const;

  void ShallowCopy(vtkAbstractMapper* mapper) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool HasTranslucentPolygonalGeometry() override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop) override;

  ///@{
  /// Called by VTK while it renders.
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  ///@}

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationMapper();
  ~vtkMultiTriangulationMapper() override;

  void ComputeBounds() override;
  void UpdateCameraShiftScale(vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateMaximumPointCellIds(vtkRenderer* renderer, vtkActor* actor) override;
  void GetShaderTemplate(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkMultiTriangulationMapper(const vtkMultiTriangulationMapper&) = delete;
  void operator=(const vtkMultiTriangulationMapper&) = delete;

  struct Internals;

  bool HasPatches();
  void FollowInput();
  void ForgetBuffers();
  bool ShowsCut() const;
  int FindScalars(const vtkMTGraph& graph, int& cellFlag);
  bool IsDirect(const vtkMTArrayInfo& info) const;
  double GetFullColor(const vtkMTArrayInfo& info);
  bool HasTranslucentColors();
  int GetMappingMode() const;
  void PlanColors();
  void PlanScalars();
  void PlanElevation();
  void PlanFieldColor();
  void PlanAttributes(vtkActor* actor);
  void PlanCellTextures(vtkActor* actor);
  void SubstituteCellTextures(std::string& source) const;
  void BuildTemplate(vtkRenderer* renderer);
  void WarnOfForeignArrays();
  void UpdateColorRevision();
  vtkSmartPointer<vtkDataArray> GetElevations(const vtkMTPatch& patch);
  vtkSmartPointer<vtkDataArray> GetPatchScalars(int array, const vtkMTPatch& patch);
  void MapPatchScalars(int array, const vtkMTPatch& patch, std::vector<unsigned char>& bytes);
  void ForgetColors();
  void UpdateFrame(vtkRenderer* renderer, vtkActor* actor);
  bool WaitsFor(vtkRenderer* renderer);
  std::uint64_t GetTrianglesInTime(vtkRenderer* renderer, vtkActor* actor);
  void TakeFigures();
  void UpdateCellTextures(vtkRenderer* renderer);
  void TakeClippingPlanes(vtkActor* actor);
  void UseClippingPlanes(vtkOpenGLHelper& cellBO);
  void DrawPrimitives(vtkRenderer* renderer, vtkActor* actor, vtkOpenGLHelper& cellBO, unsigned int mode);
  void DrawVertices(vtkRenderer* renderer, vtkActor* actor);
  std::array<unsigned char, 4> GetPatchColor(std::uint32_t arc);

  double PixelError = 1.0;
  vtkIdType TriangleLimit = 0;
  int ErrorMetric = DISTANCE;
  std::string ErrorMetricArray;
  double ValueError = 0.0;
  bool FrustumCulling = true;
  bool FacingCulling = true;
  int WaitForConvergence = WAIT_WHEN_STILL;
  vtkIdType UploadLimit = vtkIdType(16) << 20;
  double CutTimeLimit = 0.01;
  bool Prefetch = true;
  int NumberOfLoaderThreads = 2;
  bool FreezeCut = false;
  int ColorBy = NONE;
  double ElevationLowPoint[3] = { 0.0, 0.0, 0.0 };
  double ElevationHighPoint[3] = { 0.0, 0.0, 1.0 };
  double ElevationRange[2] = { 0.0, 1.0 };
  vtkIdType PatchMemoryLimit = vtkIdType(512) << 20;
  vtkIdType GraphicsMemoryLimit = vtkIdType(512) << 20;
  double DrawingRate = 0.0;
  int DrawnShare[2] = { 0, 1 };

  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfPatches = 0;
  vtkIdType NumberOfCulledPatches = 0;
  vtkIdType NumberOfCulledTriangles = 0;
  vtkIdType NumberOfFacingAwayPatches = 0;
  vtkIdType NumberOfFacingAwayTriangles = 0;
  vtkIdType NumberOfRefinedNodes = 0;
  double AchievedPixelError = 0.0;
  bool Converged = false;
  bool Loading = false;
  double CutTime = 0.0;
  double FrameTime = 0.0;
  double OverheadTime = 0.0;

  std::unique_ptr<Internals> Implementation;
};

#endif
