// SPDX-License-Identifier: BSD-3-Clause
// The values of a PLY element's properties as VTK's arrays. Not installed.
#ifndef vtkMTPlyColumns_h
#define vtkMTPlyColumns_h

#include "vtkMTPlyHeader.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTPlyColors;
class vtkDataArray;
class vtkDataSetAttributes;

/// First the arrays are made, each of one property or of a group of them, then the values are stored row by row.
class vtkMTPlyColumns
{
public:
  /// For so many rows of the element, which must outlive this; the count must have been compared with the file's size.
  vtkMTPlyColumns(const vtkMTPlyElement& element, std::uint64_t count);

  /// An array of these properties, if the element has them all, no list among them and none in an array yet; else none.
  /// The array must stay in place while values are stored.
  vtkSmartPointer<vtkDataArray> Group(const std::vector<std::string>& properties, const char* name, int type);

  /// VTK_DOUBLE where single precision does not hold all values of the properties' types, else VTK_FLOAT.
  int FindRealType(const std::vector<std::string>& properties) const;

  /// Colours, of the types that the file has; the first group of them becomes the scalars.
  void AddColors(const vtkMTPlyColors& colors, vtkDataSetAttributes* attributes);
  /// Every property that is no list and in no array yet, as an array of its own.
  void AddOthers(vtkDataSetAttributes* attributes);

  /// For a property that is no list, when AddOthers has been called.
  void Store(std::size_t property, std::uint64_t row, double value);
  /// Whether every property is stored in the type that it has in the file, and none is a list.
  bool AreAsInFile() const;
  /// Of so many rows that lie one behind the other, in the machine's order, where that is so.
  void Copy(const unsigned char* rows, std::uint64_t first, std::uint64_t count);
  /// Makes a row's values NaN or, of integers, 0.
  void Blank(std::uint64_t row);

private:
  // Where the values of one property go.
  struct Target
  {
    unsigned char* Values = nullptr; // of the first row
    std::size_t Stride = 0;
    int Type = 0;
  };

  std::size_t IndexOf(const vtkMTPlyProperty* property) const
  {
    return static_cast<std::size_t>(property - this->Element.Properties.data());
  }

  const vtkMTPlyElement& Element;
  const std::uint64_t Count;
  std::vector<Target> Targets;
};

#endif
