// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCameraPath
 * @brief views of a camera, each with its time, and the smooth flight through them
 *
 * Between two views the focal point, the logarithms of the distance from it, of the view angle and of the parallel
 * scale, and the orientation as a unit quaternion are interpolated by Kochanek splines (vtkTupleInterpolator), so that
 * the camera turns about what it looks at on an arc instead of coming closer on a chord, and starts and stops nowhere
 * in between. At the time of a view the camera is that view, bit for bit. Whether the projection is parallel is that of
 * the last view before.
 *
 * A path is kept in a text file of comma-separated values: a line with the names of the columns, and one line a view:
 *
 * @code
 * time,px,py,pz,fx,fy,fz,ux,uy,uz,view_angle,parallel_scale
 * 0,0,0,10,0,0,0,0,1,0,30,0
 * 2.5,10,0,0,0,0,0,0,1,0,30,0
 * @endcode
 *
 * Seconds; position, focal point and view up in world coordinates, in the order of `bmt view --camera`; the vertical
 * view angle in degrees; half the height of a parallel projection in world units, or 0 where it is a perspective one.
 * Empty lines and lines that begin with # are left out. Numbers are written so that they are read back bit for bit,
 * whatever the locale.
 *
 * @sa vtkMTInteractorStyle
 */
#ifndef vtkMTCameraPath_h
#define vtkMTCameraPath_h

#include "vtkMTInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory>
#include <string>

class vtkCamera;

class VTKMTINTERACTION_EXPORT vtkMTCameraPath : public vtkObject
{
public:
  static vtkMTCameraPath* New();
  vtkTypeMacro(vtkMTCameraPath, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds the view of a camera at a time in seconds, which must be finite and later than that of the last view. True on
   * success; false, with the reason in GetErrorMessage and nothing added, where the time is none of these or the camera
   * has no view (position and focal point are equal, view up points along the view).
   */
  bool AddView(double time, vtkCamera* camera);
  /// Forgets all of them.
  void RemoveAllViews();
  /// How many there are.
  int GetNumberOfViews() const;

  ///@{
  /// Seconds of the first and of the last view; 0 without views.
  double GetFirstTime() const;
  double GetLastTime() const;
  ///@}

  /**
   * Places the camera as it is at that time; times before the first view are taken for that, and those after the last
   * likewise. The clipping range is left to the renderer. False, with the camera as it was, where there are no views or
   * the time is NaN.
   */
  bool GetView(double time, vtkCamera* camera);

  ///@{
  /**
   * The file described above, written whole or not at all; reading replaces the views. False on failure, with what is
   * wrong and where (file, line, column) in GetErrorMessage; a path that cannot be read is as it was.
   */
  bool Write(const char* fileName);
  bool Read(const char* fileName);
  ///@}

  /// Why the last call failed, in one sentence; empty after success.
  vtkGetMacro(ErrorMessage, std::string);

protected:
  vtkMTCameraPath();
  ~vtkMTCameraPath() override;

private:
  vtkMTCameraPath(const vtkMTCameraPath&) = delete;
  void operator=(const vtkMTCameraPath&) = delete;

  struct Internals;
  bool Fail(const std::string& why);

  std::string ErrorMessage;
  std::unique_ptr<Internals> Implementation;
};

#endif
