// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyMesh
 * @brief what the verification's own readers fill in: points, polygons and arrays, all values as doubles
 *
 * A value that the file does not have for a point or a cell is NaN. Colours are scaled to 0..1 and their array is the
 * active scalars; normals and texture coordinates are active as such; arrays of names hold the index of the name and
 * have the names as annotations of their lookup table.
 */
#ifndef vtkMTVerifyMesh_h
#define vtkMTVerifyMesh_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyMesh
{
public:
  enum KindType
  {
    Plain,
    Colors,
    Normals,
    Coordinates,
    Names
  };
  struct Array
  {
    std::string Name;
    KindType Kind = Plain;
    bool IsOfCells = false;
    int Components = 1;
    std::vector<double> Values;
    std::vector<std::string> Names; ///< of kind Names
  };

  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<vtkIdType>> Polygons; ///< indices may be out of range
  std::vector<Array> Arrays;

  /// The array of that name and association; a new one where there is none.
  Array& GetArray(const std::string& name, KindType kind, bool isOfCells, int components);
  /// Makes all arrays as long as the points and cells, with NaN.
  void Fill();
  /// The value of a name in an array of kind Names.
  static double GetIndexOfName(Array& array, const std::string& name);
  /// Fills, and moves it to a polydata.
  void Give(vtkPolyData* mesh);
};

#endif
