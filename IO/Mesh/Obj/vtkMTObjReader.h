// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTObjReader
 * @brief reads a mesh from Wavefront OBJ, safely
 *
 * Vertices, texture coordinates (two components), normals, vertex colours, faces, lines and points, with positive or
 * negative indices. Points are in single precision unless the text says more than that holds. A point whose corners
 * have different texture coordinates or normals becomes several points with the same place; all others stay one, unlike
 * VTK 9.1's vtkOBJReader, which gives every corner a point of its own and crashes on indices out of range.
 *
 * Arrays: points "TCoords" (float x 2), "Normals" (float x 3), "RGB" (float x 3) or "RGBA" (float x 4, where some
 * colour has an alpha), from 0 to 1, also where the file counts to 255; vertices without one are white. Cells
 * "MaterialIds" (int, counted in the order of the first use, -1 for none) where a material is named, "GroupIds" and
 * "ObjectIds" (int, counted in the order of their first cells; objects: -1 for none) where there are several. Their
 * names are the annotations of the arrays' lookup tables, and the materials' diffuse colours (Kd), from the libraries
 * beside the file, are the colours of that of MaterialIds. Field data "MaterialNames" and "MaterialLibraries".
 *
 * A record that is wrong costs itself alone, as do free forms, which are not read. The report counts:
 * - "bad_vertices": with fewer than three numbers; they keep their index and have no place;
 * - "not_finite_vertices": NaN or infinity, as "nan", "inf" or "1.#QNAN";
 * - "bad_cells": with a corner that is none or does not exist; "degenerate_cells": with too few corners;
 * - "missing_texture_coordinates", "missing_normals": corners that name some that do not exist;
 * - "filled_texture_coordinates", "filled_normals": corners of faces without, which get 0, where others have some;
 * - "filled_colors": vertices without, where others have some;
 * - "bad_texture_coordinates", "bad_normals": not numbers, taken for 0;
 * - "ignored_numbers" (vertices with more than can be told), "ignored_weights", "ignored_smoothing_groups" (several,
 * without normals), "free_forms" (curves and surfaces), "unknown_records".
 */
#ifndef vtkMTObjReader_h
#define vtkMTObjReader_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkMTInputReport.h"

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTObjReader
{
public:
  ///@{
  /// False, with the reason in error, and an empty output when the file cannot be read, is text in UTF-16 or has a line
  /// of more than 16 MiB. A file without faces is not an error. report: what was counted is added to it.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error);
  static bool Read(
    const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report = nullptr);
  ///@}
};

#endif
