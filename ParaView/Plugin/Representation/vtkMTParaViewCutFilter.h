// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewCutFilter
 * @brief vtkMultiTriangulationCutFilter as ParaView's property panels want it
 *
 * In the superclass the last call chooses which cut is made; in a panel all settings have a value, in no order. So here
 * Mode chooses, and the setters of the superclass's names keep their values for it. A camera is given by numbers.
 *
 * On several ranks, which all have the handle to all patches, the one with the points and cells makes the cut and the
 * others an empty one.
 */
#ifndef vtkMTParaViewCutFilter_h
#define vtkMTParaViewCutFilter_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMultiTriangulationCutFilter.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkCamera;
class vtkImplicitFunction;

class VTKMTPARAVIEW_EXPORT vtkMTParaViewCutFilter : public vtkMultiTriangulationCutFilter
{
public:
  static vtkMTParaViewCutFilter* New();
  vtkTypeMacro(vtkMTParaViewCutFilter, vtkMultiTriangulationCutFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// BY_ERROR (the default), BY_TRIANGLES, BY_LEVEL or BY_VIEW. Clamped.
  void SetMode(int mode);

  ///@{
  /// The superclass's, of the same defaults and ranges, without choosing the mode.
  void SetError(double error);
  void SetTriangleLimit(vtkIdType limit);
  void SetLevel(int level);
  ///@}

  ///@{
  /// The camera of BY_VIEW: position, focal point and view up of vtkCamera, with their defaults; the angle in degrees,
  /// default 30, or half the height of a parallel projection in model units, default 1; and the size of the picture in
  /// pixels, default 800 x 600. Everything between the camera and infinity counts as seen.
  void SetCameraPosition(double x, double y, double z);
  void SetCameraFocalPoint(double x, double y, double z);
  void SetCameraViewUp(double x, double y, double z);
  void SetCameraViewAngle(double degrees);
  void SetCameraParallelProjection(bool on);
  void SetCameraParallelScale(double scale);
  void SetImageSize(int width, int height);
  ///@}

  ///@{
  /// Whether RegionFunction is the region of interest. Default off.
  void SetUseRegion(bool on);
  void SetRegionFunction(vtkImplicitFunction* function);
  ///@}

  ///@{
  /// The array selections, for ParaView's lists: what they know, and their states.
  int GetNumberOfPointArrays();
  const char* GetPointArrayName(int index);
  int GetPointArrayStatus(const char* name);
  void SetPointArrayStatus(const char* name, int status);
  int GetNumberOfCellArrays();
  const char* GetCellArrayName(int index);
  int GetCellArrayStatus(const char* name);
  void SetCellArrayStatus(const char* name, int status);
  ///@}

protected:
  vtkMTParaViewCutFilter();
  ~vtkMTParaViewCutFilter() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewCutFilter(const vtkMTParaViewCutFilter&) = delete;
  void operator=(const vtkMTParaViewCutFilter&) = delete;

  void Choose();

  int ChosenMode = BY_ERROR;
  double ChosenError;
  vtkIdType ChosenLimit = 0;
  int ChosenLevel = 0;
  vtkNew<vtkCamera> ViewCamera;
  int ImageSize[2] = { 800, 600 };
  bool UseRegion = false;
  vtkSmartPointer<vtkImplicitFunction> RegionFunction;
};

#endif
