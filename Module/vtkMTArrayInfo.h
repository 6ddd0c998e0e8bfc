// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArrayInfo
 * @brief what one point or cell array of a Multi-Triangulation is: its name, type and how it is resampled
 *
 * Values are kept as bytes in native VTK layout: tuple by tuple, Components values of VTK type Type each. Point arrays
 * have one tuple per wedge of a patch, cell arrays one per triangle. On level 0 the bytes are the input's; above, they
 * are resampled as Resampling says. Of some arrays the patches above the finest level have no values (IsFinestOnly).
 *
 * vtkMTRange is the least and the largest of some values.
 */
#ifndef vtkMTArrayInfo_h
#define vtkMTArrayInfo_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

/// The least and the largest of some values; empty, Minimum above Maximum, where there are none.
struct vtkMTRange
{
  double Minimum = std::numeric_limits<double>::infinity();
  double Maximum = -std::numeric_limits<double>::infinity();

  bool IsEmpty() const { return this->Minimum > this->Maximum; }
  void Add(const vtkMTRange& other)
  {
    this->Minimum = other.Minimum < this->Minimum ? other.Minimum : this->Minimum;
    this->Maximum = other.Maximum > this->Maximum ? other.Maximum : this->Maximum;
  }
  bool Holds(const vtkMTRange& other) const
  {
    return other.IsEmpty() || (this->Minimum <= other.Minimum && other.Maximum <= this->Maximum);
  }
  bool operator==(const vtkMTRange& other) const
  {
    return this->Minimum == other.Minimum && this->Maximum == other.Maximum;
  }
};

/// The values of one array in one patch: tuples times GetTupleSize() bytes.
using vtkMTColumn = std::vector<unsigned char>;

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
    InputCellIds = 1,  ///< the input's cell id of each triangle, for picking; one vtkIdType
    MadeNormals = 2,   ///< normals that the builder made because the input had none
    ExactPoints = 3,   ///< level 0 only, empty above: the input's coordinates, see vtkMTExactPoints
    InputPointIds = 4, ///< the input's point id of each point, for picking; one vtkIdType
    Materials = 5,     ///< what surfaces are made of: indices or colours that a painter shades with
    Heights = 6        ///< of the samples of a grid, along its third axis, in steps of the lattice
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
  /// vtkMTLookupTable); and "levels", see IsFinestOnly.
  std::map<std::string, std::string> Properties;

  /// Bytes of one tuple; 0 for a type that is not carried.
  std::size_t GetTupleSize() const;

  ///@{
  /// Whether only patches of the finest level have values, and the array's column is empty in all others: exact points,
  /// and arrays whose property "levels" is "finest". What stands for missing values where patches of several levels
  /// become one mesh is MakeUnknown: all bits one, which are -1, NaN, or the largest number of an unsigned type.
  bool IsFinestOnly() const;
  void SetFinestOnly() { this->Properties["levels"] = "finest"; }
  vtkMTColumn MakeUnknown(std::size_t tuples) const { return vtkMTColumn(tuples * this->GetTupleSize(), 0xff); }
  ///@}

  /// The range of each component of a column. NaN is left out, 64-bit integers are rounded to double; residuals
  /// (ExactPoints) are no values and have empty ranges.
  std::vector<vtkMTRange> GetRanges(const vtkMTColumn& column) const;

  /**
   * Whether it holds colours: bytes of two to four components, any numbers of three or four whose name has "color",
   * "colour" or "rgb" in it, and single integers named as a channel is (red, diffuse_green, intensity, gray ...).
   */
  bool IsColor() const;
  /// By type, name, components and attribute: real numbers are interpolated, directions where they are normals;
  /// integers are labels, of which no mean may be taken, unless they are colours. Cell arrays and ids have the nearest
  /// value.
  ResamplingType GetDefaultResampling() const;
  /// What it is taken for: "labels", "values", "colors", "directions" or "ids".
  const char* GetMeaning() const;
  /**
   * Point arrays of these names become labels or values, whatever their type; directions stay what they are among the
   * values, and cell arrays, of which no mean is ever taken, stay as they are. Gives a name of which there is no array;
   * empty when there is none.
   */
  static std::string ChooseMeanings(const std::vector<std::string>& labels, const std::vector<std::string>& values,
    std::vector<vtkMTArrayInfo>& arrays);

  /// Why the values of arrays of these names cannot be certified; empty when they can.
  static std::string FindUncertifiable(
    const std::vector<std::string>& names, const std::vector<vtkMTArrayInfo>& arrays);

  bool operator==(const vtkMTArrayInfo& other) const;
};

#endif
