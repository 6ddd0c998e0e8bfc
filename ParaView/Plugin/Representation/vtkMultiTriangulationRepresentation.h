// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationRepresentation
 * @brief draws a Multi-Triangulation in ParaView's render views, as finely as the view needs
 *
 * A vtkGeometryRepresentation whose mapper is a vtkMultiTriangulationMapper, so it has ParaView's properties of
 * surfaces (colours, opacity, lighting, transforms, textures) and the mapper's own, which are forwarded to it. Data
 * without patches is drawn as the surface representation draws it.
 *
 * Where: data without patches goes where ParaView wants it; patches cannot go anywhere, as they are in a file. So the
 * view draws where the data is: in the server, if there is one, whatever ParaView's threshold for remote rendering
 * says.
 *
 * Several ranks, where a reader gave the model: each has the handle to all patches, finds the same cut and draws its
 * share of it (vtkMultiTriangulationMapper::SetDrawnShare), and ParaView composites. The cut is the same only where it
 * does not depend on time, so ranks always wait for their patches. Shares are patches in a row and cannot be put in an
 * order from back to front. Where something translucent is in the view, ParaView gives each rank a box of a k-d tree,
 * and puts the pictures over each other in the boxes' order: then a rank draws what lies in its box, clipped at the
 * faces. Where there are no such boxes, or they have more faces than a mapper has clipping planes, rank 0 draws all.
 *
 * Interaction: a still render waits until the picture is what the settings ask for. An interactive one draws what is
 * there, in the time that ParaView's frame rate allows. Where ParaView uses levels of detail (the model's finest level
 * is larger than the view's LODThreshold), PixelError is multiplied by 16^(1 - LODResolution), so 4 by default; and
 * where it is to use outlines, the model's box is drawn. ParaView's own decimation is never run.
 */
#ifndef vtkMultiTriangulationRepresentation_h
#define vtkMultiTriangulationRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkMTParaViewModule.h" // For export macro
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiTriangulation;
class vtkMultiTriangulationMapper;
class vtkPolyData;

class VTKMTPARAVIEW_EXPORT vtkMultiTriangulationRepresentation : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkMultiTriangulationRepresentation* New();
  vtkTypeMacro(vtkMultiTriangulationRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /// Whether what is drawn is a model, and not other data.
  bool ShowsModel() { return this->GetModel() != nullptr; }

  /// One that shows the patches of this model in this process, or nullptr.
  static vtkMultiTriangulationRepresentation* FindShowing(vtkMultiTriangulation& model);

  /// The mesh of the cut of the last frame, with its arrays, for selections in it; nullptr where there is none. It
  /// stays the representation's.
  vtkPolyData* GetDrawnMesh();

  /// What this process has of the data: a vtkMultiTriangulation, if the input is one.
  vtkDataObject* GetRenderedDataObject(int port) override;

  ///@{
  /**
   * Names of the arrays whose values a selection of points or cells gives; nullptr or empty: the input's ids where the
   * model keeps them. ParaView calls this.
   */
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;
  ///@}

  ///@{
  /**
   * Names of arrays of the model whose values a selection of its points or cells gives. Default empty: the input's ids,
   * where the model keeps them, as it does those of cells. Where there is no such array, nothing is selected, with a
   * warning the first time (hovering asks for selections all the time): places in the coarsest mesh would mean nothing.
   * A name of which the model has no array counts as none.
   */
  vtkSetStdStringFromCharMacro(PointIdArray);
  vtkSetStdStringFromCharMacro(CellIdArray);
  vtkGetCharFromStdStringMacro(PointIdArray);
  vtkGetCharFromStdStringMacro(CellIdArray);
  ///@}

  /// The name of the array that has the input's ids of points (vtkDataObject::POINT) or cells, or an empty one: what
  /// vtkMTSelectionEncoder asks for.
  std::string GetIdArrayName(int association);
  /// Whether this is the first time that it is asked of points or of cells.
  bool IsFirstWarning(int association);

  ///@{
  /// How the surface is drawn: POINTS, WIREFRAME, SURFACE (the default) or SURFACE_WITH_EDGES. Clamped.
  vtkSetClampMacro(Style, int, POINTS, SURFACE_WITH_EDGES);
  vtkGetMacro(Style, int);
  ///@}

  ///@{
  /// Forwarded to the mapper, which describes them. SetCutColoring is its SetColorBy.
  void SetPixelError(double pixels);
  void SetErrorMetric(int metric);
  void SetErrorMetricArray(const char* name);
  void SetValueError(double deviation);
  void SetTriangleLimit(vtkIdType triangles);
  void SetWaitForConvergence(int wait);
  void SetUploadLimit(vtkIdType bytes);
  void SetCutTimeLimit(double seconds);
  void SetPrefetch(bool on);
  void SetNumberOfLoaderThreads(int threads);
  void SetFrustumCulling(bool on);
  void SetFacingCulling(bool on);
  void SetFreezeCut(bool on);
  void SetCutColoring(int colors);
  void SetPatchMemoryLimit(vtkIdType bytes);
  void SetGraphicsMemoryLimit(vtkIdType bytes);
  void SetDrawingRate(double trianglesPerSecond);
  ///@}

  ///@{
  /**
   * Whether the mapper draws only what lies on the side of a plane that its normal points to (vtkPlane, in the world's
   * coordinates); triangles stay whole in the file, and no cap is drawn. Default off; a plane through the origin with
   * the normal x.
   */
  void SetClip(bool on);
  void SetClipOrigin(double x, double y, double z);
  void SetClipNormal(double x, double y, double z);
  ///@}

  ///@{
  /// The mapper's figures of the last frame in this process; vtkMTFigureInformation has those of all processes.
  vtkIdType GetNumberOfTriangles();
  vtkIdType GetNumberOfPatches();
  double GetAchievedPixelError();
  int GetConverged();
  int GetLoading();
  double GetFrameTime();
  vtkIdType GetGraphicsMemory();
  vtkIdType GetPatchMemory();
  ///@}

  /// The mapper that draws.
  vtkMultiTriangulationMapper* GetMultiTriangulationMapper();

protected:
  vtkMultiTriangulationRepresentation();
  ~vtkMultiTriangulationRepresentation() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  void UpdateColoringParameters() override;

private:
  vtkMultiTriangulationRepresentation(const vtkMultiTriangulationRepresentation&) = delete;
  void operator=(const vtkMultiTriangulationRepresentation&) = delete;

  vtkMultiTriangulation* GetModel();
  void RequestUpdate(vtkInformation* inInfo, vtkInformation* outInfo);
  void RequestLod(vtkInformation* inInfo);
  void RequestRender(vtkInformation* inInfo);
  void CountReplicas();
  void SetShare();
  void SetPlanes();

  vtkSmartPointer<vtkDataObject> Data;
  double PixelError = 1.0;
  int WaitForConvergence;
  double DrawingRate = 0.0;
  double LodFactor = 1.0;
  bool LodIsOutline = false;
  bool SharesModel = false;
  int Style = SURFACE;
  std::string PointIdArray;
  std::string CellIdArray;
  std::array<bool, 2> HasWarned{}; // of points, of cells
  bool Clips = false;
  vtkNew<vtkPlane> ClippingPlane;
  std::vector<std::array<double, 6>> RankPlanes; // where the view puts ranks in an order
  std::vector<std::uint32_t> DrawnArcs;          // of the cut that DrawnMesh is
  vtkIdType DrawnSearch = 0;                     // that found it
  vtkSmartPointer<vtkPolyData> DrawnMesh;
};

#endif
