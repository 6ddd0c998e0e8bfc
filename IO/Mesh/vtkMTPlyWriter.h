// SPDX-License-Identifier: BSD-3-Clause
// A triangle stream as binary PLY. Not installed; vtkMTMeshWriter is the public side.
#ifndef vtkMTPlyWriter_h
#define vtkMTPlyWriter_h

#include "vtkMTMeshWriter.h"
#include "vtkMTTriangleStream.h"

class vtkMTOutputFile;

class vtkMTPlyWriter
{
public:
  vtkMTPlyWriter(vtkMTTriangleStream& mesh, bool isDouble, const vtkMTMeshWriter::Progress& progress);
  ~vtkMTPlyWriter();

  /// Writes everything into the open file; does not commit it.
  bool Write(vtkMTOutputFile& file, std::string& error);

private:
  // One component of one array, and how its values become a property's.
  struct Property
  {
    std::string Name;
    std::string Type;
    std::size_t Column; // among the arrays of the same association
    std::size_t Offset; // of the component within a tuple
    std::size_t TupleSize;
    std::size_t Size;    // of the component
    std::size_t PlySize; // of the property
    bool Is64 = false;   // a 64-bit integer, to be narrowed
    bool IsSigned = false;
    bool FitsInt = true;
    bool FitsUInt = true;
    bool FitsDouble = true;
  };

  void AddProperties(const vtkMTArrayInfo& array, std::size_t column, std::vector<Property>& properties);
  bool Survey(std::string& error);
  void SurveyColumns(const std::vector<vtkMTColumn>& columns, std::size_t rows, std::vector<Property>& properties);
  bool ChooseTypes(std::vector<Property>& properties, std::string& error);
  std::string MakeHeader() const;
  bool WritePoints(vtkMTOutputFile& file, std::string& error);
  bool WriteTriangles(vtkMTOutputFile& file, std::string& error);
  void Report(std::uint64_t done);

  vtkMTTriangleStream& Mesh;
  vtkMTMeshWriter::Progress Progress;
  bool IsDouble;
  std::vector<Property> PointProperties;
  std::vector<Property> CellProperties;
};

#endif
