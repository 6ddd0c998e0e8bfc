// SPDX-License-Identifier: BSD-3-Clause
// The text form of STL. Not installed.
#ifndef vtkMTStlText_h
#define vtkMTStlText_h

#include "vtkMTInputReport.h"
#include "vtkMTStlSolids.h"
#include "vtkMTTextFormat.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/**
 * Line by line; what a line begins with says what it is, "end loop" being "endloop". Facets of more than three vertices
 * become a fan. A line that is none of STL's is stepped over and counted, and so is a facet with too few vertices; more
 * than a few of them are an error.
 */
class vtkMTStlText
{
public:
  explicit vtkMTStlText(vtkMTTextFormat::Stream& stream);

  /// Whether a file that begins like this is text, unless its size is that of a binary one.
  static bool IsText(std::string_view begin);

  /// Appends the coordinates of the next vertices, at most so many, a multiple of three; fewer at the end. False when
  /// the file is malformed.
  bool Read(std::size_t vertices, std::vector<float>& coordinates);
  const std::string& GetError() const { return this->Error; }

  ///@{
  /// Of what has been read.
  const vtkMTStlSolids& GetSolids() const { return this->Solids; }
  const vtkMTInputReport& GetReport() const { return this->Report; }
  ///@}

private:
  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }
  bool CountBad(const char* reason, const std::string& what);
  bool ReadLine(std::string_view line);
  bool ReadEnd(const std::string& keyword);
  bool ReadVertex(std::string_view line);
  bool FinishFacet();
  void TakeTriangle(std::vector<float>& coordinates);

  vtkMTTextFormat::Stream& Stream;
  std::uint64_t LineNumber = 0;
  std::uint64_t BadLines = 0;
  std::uint64_t Triangles = 0;
  vtkMTStlSolids Solids;
  vtkMTInputReport Report;
  bool IsInSolid = false;
  bool IsInFacet = false;
  std::vector<float> Facet;   // coordinates of its vertices
  std::vector<float> Pending; // those of the last facet, from which the next triangles are taken
  std::size_t NextPending = 0;
  std::string Error;
};

#endif
