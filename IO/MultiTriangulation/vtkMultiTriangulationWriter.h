// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationWriter
 * @brief writes a Multi-Triangulation file (.bmt)
 *
 * Copies the patches of a vtkMultiTriangulation, wherever they are, into a file, which is published whole or not at all
 * (vtkMTFileSink), with the frame that the object has. Plain vtkPolyData has no patches and is refused:
 * vtkMultiTriangulationBuilder makes some.
 *
 * Errors: vtkErrorMacro, and an error code (vtkErrorCode::NoFileNameError, FileFormatError, CannotOpenFileError,
 * OutOfDiskSpaceError when the file could not be written).
 */
#ifndef vtkMultiTriangulationWriter_h
#define vtkMultiTriangulationWriter_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkWriter.h"

class vtkMTPatchSource;
class vtkMultiTriangulation;

class VTKMTIO_EXPORT vtkMultiTriangulationWriter : public vtkWriter
{
public:
  static vtkMultiTriangulationWriter* New();
  vtkTypeMacro(vtkMultiTriangulationWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationWriter();
  ~vtkMultiTriangulationWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;

private:
  vtkMultiTriangulationWriter(const vtkMultiTriangulationWriter&) = delete;
  void operator=(const vtkMultiTriangulationWriter&) = delete;
  void WritePatches(const vtkMTPatchSource& source, const vtkMultiTriangulation& model);
};

#endif
