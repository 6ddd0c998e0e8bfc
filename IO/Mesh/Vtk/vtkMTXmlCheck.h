// SPDX-License-Identifier: BSD-3-Clause
// What VTK's XML readers do not look at before they allocate. Not installed.
#ifndef vtkMTXmlCheck_h
#define vtkMTXmlCheck_h

#include <cstdint>
#include <string>
#include <string_view>

class vtkMTByteSource;

/// The text is searched, not parsed: VTK's reader does that, and says what is wrong with it.
class vtkMTXmlCheck
{
public:
  explicit vtkMTXmlCheck(const vtkMTByteSource& bytes);

  /// The type of the dataset; empty where the file does not begin as VTK's XML files do.
  const std::string& GetType() const { return this->Type; }
  /// Whether a file of that size can hold as many points, cells and components as it says anywhere. False with the
  /// reason in error.
  bool CheckCounts(std::string& error) const;

private:
  bool CheckBlock(std::string_view text, std::string& error) const;

  const vtkMTByteSource& Bytes;
  std::string Type;
  bool IsCompressed = false;
};

#endif
