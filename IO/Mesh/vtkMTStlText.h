// SPDX-License-Identifier: BSD-3-Clause
// The text form of STL. Not installed.
#ifndef vtkMTStlText_h
#define vtkMTStlText_h

#include "vtkMTTextFormat.h"

#include <string>
#include <string_view>
#include <vector>

/// Line by line; what a line begins with says what it is.
class vtkMTStlText
{
public:
  explicit vtkMTStlText(vtkMTTextFormat::Stream& stream)
    : Stream(stream)
  {
  }

  /// Whether a file that begins like this is text, unless its size is that of a binary one.
  static bool IsText(std::string_view begin);

  /// Appends the coordinates of the next vertices, at most so many; fewer at the end. False when the file is malformed.
  bool Read(std::size_t vertices, std::vector<float>& coordinates);
  const std::string& GetError() const { return this->Error; }

private:
  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }
  bool ReadLine(std::string_view line, std::vector<float>& coordinates);
  bool ReadVertex(std::string_view line, std::vector<float>& coordinates);

  vtkMTTextFormat::Stream& Stream;
  std::uint64_t LineNumber = 0;
  bool IsInSolid = false;
  bool IsInFacet = false;
  int Corners = 0;
  std::string Error;
};

#endif
