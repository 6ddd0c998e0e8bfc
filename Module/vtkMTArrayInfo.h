// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArrayInfo
 * @brief what one point or cell array of a Multi-Triangulation is: its name, type and how it is resampled
 *
 * Values are kept as bytes in native VTK layout: tuple by tuple, Components values of VTK type Type each. Point arrays
 * have one tuple per wedge of a patch, cell arrays one per triangle. On level 0 the bytes are the input's; above, they
 * are resampled as Resampling says. An array of role ExactPoints is empty above level 0.
 */
#ifndef vtkMTArrayInfo_h
#define vtkMTArrayInfo_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTArrayInfo
{
  enum AssociationType : std::uint8_t
  {
    Point = 0,
    Cell = 1
  };

  enum ResamplingType : std::uint8_t
  {
    Interpolate = 0, ///< barycentric on the finer surface, rounded to nearest for integers
    Nearest = 1,     ///< the nearest value, for ids, labels and every cell array
    Direction = 2    ///< interpolated, then scaled to unit length (normals)
  };

  enum RoleType : std::uint8_t
  {
    Plain = 0,
    InputCellIds = 1, ///< the input's cell id of each triangle, for picking; one vtkIdType
    MadeNormals = 2,  ///< normals that the builder made because the input had none
    ExactPoints = 3   ///< level 0 only, empty above: the input's coordinates, see vtkMTExactPoints
  };

  std::string Name;
  int Type = 10; ///< VTK_FLOAT and so on, of fixed size: string, variant and bit arrays are not carried
  int Components = 1;
  AssociationType Association = Point;
  ResamplingType Resampling = Interpolate;
  RoleType Role = Plain;
  int Attribute = -1; ///< vtkDataSetAttributes::SCALARS, NORMALS, TCOORDS ... where the array is the active one, or -1
  std::vector<std::string> ComponentNames; ///< Components names, or none
  /// What else the input's array says of itself: "units" (vtkDataArray::UNITS_LABEL), "lookup_table" (the bytes of
  /// vtkMTLookupTable).
  std::map<std::string, std::string> Properties;

  /// Bytes of one tuple; 0 for a type that is not carried.
  std::size_t GetTupleSize() const;

  bool operator==(const vtkMTArrayInfo& other) const;
};

/// The values of one array in one patch: tuples times GetTupleSize() bytes.
using vtkMTColumn = std::vector<unsigned char>;

#endif
