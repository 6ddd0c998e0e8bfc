// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewReader
 * @brief vtkMultiTriangulationReader as ParaView's pipelines want it
 *
 * Three things differ from the superclass:
 *
 * - The arrays of the output say the range of the whole model's finest level when they are asked for theirs
 *   (vtkDataArray::GetRange), also where the coarsest cut, which their values are, has less. ParaView takes the ranges
 *   of colour maps from there.
 * - Of the ranks of a parallel ParaView the first has the points and cells. The others have none, but have the handle
 * to the patches, so that each can draw its share.
 * - There is no warning of filters that do not know the patches: in ParaView there are always some.
 */
#ifndef vtkMTParaViewReader_h
#define vtkMTParaViewReader_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMultiTriangulationReader.h"

class VTKMTPARAVIEW_EXPORT vtkMTParaViewReader : public vtkMultiTriangulationReader
{
public:
  static vtkMTParaViewReader* New();
  vtkTypeMacro(vtkMTParaViewReader, vtkMultiTriangulationReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMTParaViewReader();
  ~vtkMTParaViewReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewReader(const vtkMTParaViewReader&) = delete;
  void operator=(const vtkMTParaViewReader&) = delete;
};

#endif
