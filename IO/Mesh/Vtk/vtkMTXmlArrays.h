// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a file in VTK's XML format, read a range at a time. Not installed.
#ifndef vtkMTXmlArrays_h
#define vtkMTXmlArrays_h

#include "vtkMTErrorCollector.h"
#include "vtkMTTextFormat.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>

class vtkAbstractArray;
class vtkDataArray;
class vtkXMLDataElement;

/**
 * VTK's own parser finds the arrays and decodes what is raw, base64 or compressed, a block at a time. Arrays as text it
 * would only read whole: those are read here, from front to end.
 */
class vtkMTXmlArrays
{
public:
  vtkMTXmlArrays();
  ~vtkMTXmlArrays();

  /// Parses the file. False with a message in error.
  bool Open(const std::string& path, std::string& error);
  vtkXMLDataElement* GetRoot() const;

  /// An empty array of the type, the name and the components that the element says; null when there is no such type.
  static vtkSmartPointer<vtkAbstractArray> MakeArray(vtkXMLDataElement* element);

  /// Tuples first ... first + count - 1 of the element's array; of an array as text they must come in order, but for
  /// going back to the first. False with a message in error.
  bool Read(
    vtkXMLDataElement* element, std::uint64_t first, std::uint64_t count, vtkDataArray* values, std::string& error);

private:
  class Parser;
  struct Text;

  bool ReadText(vtkXMLDataElement* element, std::uint64_t first, vtkDataArray* values, std::string& error);

  std::string Path;
  vtkMTErrorCollector Errors;
  vtkSmartPointer<Parser> Xml;
  std::map<vtkXMLDataElement*, std::unique_ptr<Text>> Texts;
};

#endif
