// SPDX-License-Identifier: BSD-3-Clause
// Vertex shader, at the beginning of main: as vtkMTLatticeImpl.glsl, of a packed vertex.
  vec4 vertexMC = vec4(vec3(ivec3(packedMC >> uvec3(uint(packedBits.x))) - latticeOrigin), 1.0);
  vec3 normalMC = getPackedNormal();
