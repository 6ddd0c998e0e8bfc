// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationReader
 * @brief reads a Multi-Triangulation file (.bmt)
 *
 * The output is a vtkMultiTriangulation: its points and cells are the coarsest cut, and it carries a handle to the
 * file, from which the toolkit's mapper and filters take other patches when they need them. So reading a file of any
 * size takes the time and the memory of its DAG and its coarsest patches. The file must stay in place while the output
 * is in use; replacing it by rename does no harm.
 *
 * Errors: vtkErrorMacro, and an error code (vtkErrorCode::NoFileNameError, FileNotFoundError, CannotOpenFileError,
 * UnrecognizedFileTypeError, FileFormatError).
 */
#ifndef vtkMultiTriangulationReader_h
#define vtkMultiTriangulationReader_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMultiTriangulation;

class VTKMTIO_EXPORT vtkMultiTriangulationReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMultiTriangulationReader* New();
  vtkTypeMacro(vtkMultiTriangulationReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// 1 when the file begins as a Multi-Triangulation file does, whatever its version and its name; else 0.
  static int CanReadFile(const char* fileName);

  ///@{
  /**
   * Which cut the output's own points and cells are, for filters that know polydata only: the coarsest one whose
   * certified distance to the input is at most this, in model units, or the finest level where that is not enough.
   * Default VTK_DOUBLE_MAX: the coarsest cut, of which users of such filters are warned (see vtkMultiTriangulation).
   * Negative values are clamped to 0, the finest level; NaN is ignored, with a warning. Reading takes the memory of
   * that cut.
   */
  void SetOutputError(double error);
  vtkGetMacro(OutputError, double);
  ///@}

  vtkMultiTriangulation* GetOutput();

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationReader();
  ~vtkMultiTriangulationReader() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;
  double OutputError;

private:
  vtkMultiTriangulationReader(const vtkMultiTriangulationReader&) = delete;
  void operator=(const vtkMultiTriangulationReader&) = delete;
};

#endif
