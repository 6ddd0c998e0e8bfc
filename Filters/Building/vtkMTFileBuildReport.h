// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileBuildReport
 * @brief what vtkMultiTriangulationFileBuilder found and spent in its last run
 */
#ifndef vtkMTFileBuildReport_h
#define vtkMTFileBuildReport_h

#include "vtkMTBuildInput.h"

#include <cstdint>

struct vtkMTFileBuildReport
{
  vtkMTBuildInput::Result Input;
  std::uint64_t InputTriangles = 0;
  bool WasFinished = false; ///< the output was there already, as this build would have made it
  ///@{
  /// Of the whole build, and of opening the input alone: CPU time of all threads, and by the clock.
  double CpuSeconds = 0.0;
  double WallSeconds = 0.0;
  double ReadingCpuSeconds = 0.0;
  double ReadingWallSeconds = 0.0;
  ///@}
  std::uint64_t MemoryLimit = 0;    ///< bytes
  std::uint64_t TemporaryBytes = 0; ///< the most at a time
  std::uint64_t TemporaryBytesEstimated = 0;
};

#endif
