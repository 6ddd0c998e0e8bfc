// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFrameFigures.h"

#include "vtkActor.h"
#include "vtkMTColorSelector.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTFrameFigures vtkMTFrameFigures::Find(vtkRenderer* renderer)
{
  vtkMTFrameFigures sums;
  for (const auto& [actor, mapper] : vtkMTColorSelector::FindModels(renderer))
  {
    ++sums.Models;
    sums.Triangles += mapper->GetNumberOfTriangles();
    sums.Patches += mapper->GetNumberOfPatches();
    sums.CulledPatches += mapper->GetNumberOfCulledPatches();
    sums.PixelError = std::max(sums.PixelError, mapper->GetAchievedPixelError());
    sums.WantedPixelError = std::max(sums.WantedPixelError, mapper->GetPixelError());
    sums.CutTime += mapper->GetCutTime();
    sums.PatchMemory += static_cast<double>(mapper->GetPatchMemory());
    sums.GraphicsMemory += static_cast<double>(mapper->GetGraphicsMemory());
    sums.IsConverged = sums.IsConverged && mapper->GetConverged();
    sums.IsLoading = sums.IsLoading || mapper->GetLoading();
    sums.IsFrozen = sums.IsFrozen || mapper->GetFreezeCut();
  }
  return sums;
}
