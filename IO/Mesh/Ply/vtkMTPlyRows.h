// SPDX-License-Identifier: BSD-3-Clause
// The values of a PLY file's elements, one after the other, from text or binary. Not installed.
#ifndef vtkMTPlyRows_h
#define vtkMTPlyRows_h

#include "vtkMTPlyHeader.h"
#include "vtkMTTextFormat.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

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
  /// Appends a list of vertices, of which there are so many; nothing, and the row is bad, where one does not exist.
  /// Number: std::uint64_t, or a signed one for lists that may have -1 between strips.
  template <class Number>
  bool ReadCorners(const vtkMTPlyProperty& property, std::uint64_t vertices, std::vector<Number>& corners);
  bool SkipProperty(const vtkMTPlyProperty& property);
  /**
   * Ends a row that was read, or not (isRead). Gives whether the file goes on; isGood becomes whether the row is to be
   * used. A row of text that cannot be read, and one whose corners do not exist, is a bad record, which the file
   * survives: others follow in lines of their own. Too many of them, or one in which the file ends, are a failure.
   */
  bool EndRow(bool isRead, bool& isGood);

  /// Steps over rows of an element without lists; their values are not looked at.
  bool SkipRows(std::uint64_t count);
  /// Rows without lists, as far as they are in memory as the machine has numbers: how many, at most so many; they are
  /// still to be skipped.
  std::uint64_t GetBuffered(std::uint64_t most, const unsigned char*& rows) const;
  /**
   * What most files consist of, taken at once as far as it is in memory: rows of one list of three corners, with their
   * number in one byte and four bytes for each, little-endian. Gives how many were taken; any other row is left.
   */
  std::uint64_t TakeTriangles(
    const vtkMTPlyProperty& list, std::uint64_t most, std::uint64_t vertices, std::vector<std::uint64_t>& corners);

  /// Bytes after the last element mean that a count is wrong; what editors append is no harm.
  bool CheckIsAtEnd(std::string& error);

  /// What was wrong, by reason, with rows that were read.
  const vtkMTInputReport& GetReport() const { return this->Report; }
  /// Something was left out of the row.
  void Count(const char* reason) { ++this->Report[reason]; }

  /// Puts element, row and byte before the reason; for the caller's own findings too. Gives false.
  bool Fail(const std::string& reason);
  const std::string& GetError() const { return this->Error; }

private:
  bool SkipItems(const vtkMTPlyProperty& property, std::uint64_t count);
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
  bool HasBadCorner = false;
  std::uint64_t BadRows = 0; // of the element
  vtkMTInputReport Report;
};

template <class Number>
bool vtkMTPlyRows::ReadCorners(const vtkMTPlyProperty& property, std::uint64_t vertices, std::vector<Number>& corners)
{
  std::uint64_t count = 0;
  if (!this->ReadCount(property, count))
  {
    return false;
  }
  const std::size_t before = corners.size();
  bool good = true;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (!this->Read(property, value))
    {
      return false;
    }
    const bool isSeparator = std::is_signed_v<Number> && value == -1.0;
    if (good && !isSeparator && !(value >= 0.0 && value < static_cast<double>(vertices)))
    {
      good = false;
      this->HasBadCorner = true;
      this->Fail("vertex " + std::to_string(static_cast<std::int64_t>(value)) + " does not exist; there are " +
        std::to_string(vertices));
    }
    corners.push_back(good ? static_cast<Number>(value) : Number());
  }
  corners.resize(good ? corners.size() : before);
  return true;
}

#endif
