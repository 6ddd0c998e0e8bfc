// SPDX-License-Identifier: BSD-3-Clause
// Vertex shader, in place of VTK's "in vec4 vertexMC;": points are lattice integers.
in ivec3 latticeMC;
uniform ivec3 latticeOrigin;
