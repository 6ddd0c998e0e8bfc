// SPDX-License-Identifier: BSD-3-Clause
// Fragment shader, in place of VTK's distance to a light: that of a vector in units near 1, which stays in them.
      vertLightDirectionVC *= viewUnit;
      float distanceVC = length(vertLightDirectionVC) / viewUnit;
