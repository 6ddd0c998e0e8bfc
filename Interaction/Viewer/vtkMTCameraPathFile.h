// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCameraView
 * @brief one view of a camera path, and the file that a path is kept in (see vtkMTCameraPath)
 */
#ifndef vtkMTCameraPathFile_h
#define vtkMTCameraPathFile_h

#include "vtkMTInteractionModule.h" // For export macro

#include <array>
#include <string>
#include <vector>

class vtkCamera;

struct VTKMTINTERACTION_EXPORT vtkMTCameraView
{
  double Time = 0.0;
  std::array<double, 3> Position{ 0.0, 0.0, 1.0 };
  std::array<double, 3> FocalPoint{ 0.0, 0.0, 0.0 };
  std::array<double, 3> ViewUp{ 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  double ParallelScale = 0.0; ///< 0: perspective

  static vtkMTCameraView Get(double time, vtkCamera* camera);
  void Set(vtkCamera* camera) const;

  /// Empty where a camera can look so, or else what is wrong.
  std::string FindProblem() const;
};

struct vtkMTCameraPathFile
{
  /// False on failure, with the reason.
  static bool Write(const std::string& path, const std::vector<vtkMTCameraView>& views, std::string& error);
  static bool Read(const std::string& path, std::vector<vtkMTCameraView>& views, std::string& error);
};

#endif
