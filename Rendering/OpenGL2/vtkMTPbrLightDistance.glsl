// SPDX-License-Identifier: BSD-3-Clause
// Fragment shader, in place of VTK's distance to a light in physically based shading: as vtkMTLightDistance.
  L *= viewUnit;
  distanceVC = length(L) / viewUnit;
