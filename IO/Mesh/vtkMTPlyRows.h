// SPDX-License-Identifier: BSD-3-Clause
// The values of a PLY file's elements, one after the other, from text or binary. Not installed.
#ifndef vtkMTPlyRows_h
#define vtkMTPlyRows_h

#include "vtkMTPlyHeader.h"
#include "vtkMTTextFormat.h"

#include <string>

class vtkMTPlyRows
{
public:
  vtkMTPlyRows(vtkMTTextFormat::Stream& stream, const vtkMTPlyHeader& header);

  /// Whether so many rows can be there at all.
  bool BeginElement(const vtkMTPlyElement& element);
  bool BeginRow();
  /// The next value; exact, as every type of PLY fits a double.
  bool Read(const vtkMTPlyProperty& property, double& value)
  {
    return this->ReadNumber(property.Type, property.Name, value);
  }
  /// The count of a list, when its items can be there.
  bool ReadCount(const vtkMTPlyProperty& property, std::uint64_t& count);
  bool SkipItems(const vtkMTPlyProperty& property, std::uint64_t count);
  bool EndRow();

  /// Puts element, row and byte before the reason; for the caller's own findings too. Gives false.
  bool Fail(const std::string& reason);
  const std::string& GetError() const { return this->Error; }

private:
  bool ReadNumber(int type, const std::string& name, double& value);
  bool ReadText(int type, const std::string& name, double& value);
  bool ReadBinary(int type, const std::string& name, double& value);

  vtkMTTextFormat::Stream& Stream;
  const vtkMTPlyHeader& Header;
  const vtkMTPlyElement* Element = nullptr;
  std::uint64_t Row = 0; // counted from 1
  std::uint64_t RowPosition = 0;
  std::string_view Line; // what is left of a row of text
  std::string Error;
};

#endif
