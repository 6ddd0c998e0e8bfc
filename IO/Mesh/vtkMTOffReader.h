// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOffReader
 * @brief reads a mesh from OFF, the object file format of Geomview, as text
 *
 * The word OFF, or COFF, NOFF, STOFF and their combinations, numbers of vertices, faces and edges, then the vertices
 * and the faces, all separated by white space; "#" begins a comment. What a vertex has beside its place follows from
 * the word: a normal of three numbers ("Normals"), a colour of three or four ("RGB", "RGBA"), texture coordinates of
 * two ("TCoords"). A face may end with a colour: one number (an index, kept as "ColorIndex"), three or four. Colours
 * are bytes where they are whole numbers, or else count to 1; cells without any are white, and counted. Vertices of OFF
 * that have three or four numbers more on each line are taken for COFF, which many programs mean.
 *
 * A line that cannot be read makes its vertex NaN, or its face one without corners; more than a few are an error. The
 * binary form and those of other dimensions (4OFF, nOFF) are refused.
 */
#ifndef vtkMTOffReader_h
#define vtkMTOffReader_h

#include "vtkMTInputReport.h"

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class vtkMTOffReader
{
public:
  /// False, with the reason and the line in error, and an empty output when the file cannot be read. The report gets
  /// what was not read as it is in the file.
  static bool Read(
    const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report = nullptr);
};

#endif
