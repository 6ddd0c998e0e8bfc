// SPDX-License-Identifier: BSD-3-Clause
// Fragment shader: which of the textures that are limited to some cells a triangle has.
uniform samplerBuffer cellTextures;
int getCellTexture()
{
  return int(texelFetch(cellTextures, gl_PrimitiveID + PrimitiveIDOffset).r);
}
