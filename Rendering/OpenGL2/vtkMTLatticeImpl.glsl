// SPDX-License-Identifier: BSD-3-Clause
// Vertex shader, at the beginning of main: integers are subtracted without rounding, so a point has the same vertexMC in
// every patch that shares it.
  vec4 vertexMC = vec4(vec3(latticeMC - latticeOrigin), 1.0);
