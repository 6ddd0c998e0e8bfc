// SPDX-License-Identifier: BSD-3-Clause
// Vertex shader, in place of VTK's "in vec4 vertexMC;": vtkMTPackedVertices says what a vertex is.
in uvec3 packedMC;
uniform ivec3 latticeOrigin;
uniform ivec2 packedBits; // of each word that are the normal's; of each of the normal's numbers
vec3 getPackedNormal()
{
  uint mask = (1u << uint(packedBits.x)) - 1u;
  uvec3 parts = packedMC & uvec3(mask);
  uint code = parts.x | parts.y << uint(packedBits.x) | parts.z << uint(2 * packedBits.x);
  float middle = float((1 << (packedBits.y - 1)) - 1);
  vec2 place = vec2(float(code & ((1u << uint(packedBits.y)) - 1u)), float(code >> uint(packedBits.y))) / middle - 1.0;
  float z = 1.0 - abs(place.x) - abs(place.y);
  float fold = max(-z, 0.0);
  place.x += place.x < 0.0 ? fold : -fold;
  place.y += place.y < 0.0 ? fold : -fold;
  return normalize(vec3(place, z));
}
