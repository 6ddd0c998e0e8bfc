// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFrameFigures
 * @brief the figures of a frame, over all models of a renderer
 */
#ifndef vtkMTFrameFigures_h
#define vtkMTFrameFigures_h

#include "vtkMTInteractionModule.h" // For export macro
#include "vtkType.h"

#include <cstddef>

class vtkRenderer;

struct VTKMTINTERACTION_EXPORT vtkMTFrameFigures
{
  std::size_t Models = 0;
  vtkIdType Triangles = 0;
  vtkIdType Patches = 0;
  vtkIdType CulledPatches = 0;
  double PixelError = 0.0;       ///< the largest that was achieved
  double WantedPixelError = 0.0; ///< the largest that is allowed
  double CutTime = 0.0;          ///< seconds
  double PatchMemory = 0.0;      ///< bytes
  double GraphicsMemory = 0.0;   ///< bytes
  bool IsConverged = true;
  bool IsLoading = false;
  bool IsFrozen = false;

  /// Of the models that it shows; null has none.
  static vtkMTFrameFigures Find(vtkRenderer* renderer);
};

#endif
