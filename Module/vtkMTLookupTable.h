// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLookupTable
 * @brief an array's vtkLookupTable as bytes that travel with the model
 *
 * The bytes are little-endian and have no padding: u32 colours n, n times four u8 (red, green, blue, alpha), two f64
 * (range), u8 scale (0 linear, 1 logarithmic), u8 indexed, three times u8 and four f64 (for NaN, below and above the
 * range: whether that colour is used, which NaN's always is, and the colour), u32 annotations m, m times a u8 (0: an
 * f64 follows; 1: a text) and the value, and a text that is its label. A text is a u32 length and as many bytes.
 */
#ifndef vtkMTLookupTable_h
#define vtkMTLookupTable_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkLookupTable;
class vtkScalarsToColors;
struct vtkMTArrayInfo;

struct VTKMTCORE_EXPORT vtkMTLookupTable
{
  static std::string Encode(vtkLookupTable* table);
  /// Null when the bytes are not such a table; nothing is allocated that they do not justify.
  static vtkSmartPointer<vtkLookupTable> Decode(const std::string& bytes);

  /// The annotated values as text, and their names, in order of value; none without a table.
  using NameList = std::vector<std::pair<std::string, std::string>>;
  static NameList GetNames(vtkScalarsToColors* table);
  /// Those of the table that travels with the array.
  static NameList GetNames(const vtkMTArrayInfo& array);
};

#endif
