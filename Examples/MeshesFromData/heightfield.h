// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file heightfield.h
 * @brief a terrain of joined SRTM tiles
 *
 * A tile (.hgt, or .hgt.gz) covers one degree by one degree: n rows of n big-endian 16-bit integers, metres above the
 * sea, the first row in the north; -32768 is a void. Its name is its south-west corner: N36W005. Neighbouring tiles
 * share their border samples.
 */
#ifndef heightfield_h
#define heightfield_h

#include <string>
#include <vector>

class vtkPolyData;

/**
 * One grid of all tiles, two triangles to a square; a triangle with a void corner, or in a missing tile, is left out.
 * In metres: x to the east, y to the north from the south-west corner, on a sphere of the Earth's mean radius, x scaled
 * for the latitude in the middle. Throws std::runtime_error.
 */
void MakeTerrain(const std::vector<std::string>& tiles, vtkPolyData* mesh);

#endif
