// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildError
 * @brief why a file was not built: a code for programs and a sentence for people
 */
#ifndef vtkMTBuildError_h
#define vtkMTBuildError_h

#include "vtkErrorCode.h"

#include <string>
#include <utility>

struct vtkMTBuildError
{
  unsigned long Code = vtkErrorCode::NoError; ///< of vtkErrorCode, or vtkMultiTriangulationFileBuilder::ErrorType
  std::string Message;

  /// Gives false, for the caller to return.
  bool Fail(unsigned long code, std::string message)
  {
    this->Code = code;
    this->Message = std::move(message);
    return false;
  }
};

#endif
