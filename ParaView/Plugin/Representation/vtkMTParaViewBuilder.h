// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewBuilder
 * @brief vtkMultiTriangulationBuilder as ParaView's pipelines want it
 *
 * The arrays of the output say the ranges of the whole model, as those of vtkMTParaViewReader do. On several ranks each
 * makes a model of the part that it has, and they are drawn side by side: parts are not stitched.
 */
#ifndef vtkMTParaViewBuilder_h
#define vtkMTParaViewBuilder_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMultiTriangulationBuilder.h"

class VTKMTPARAVIEW_EXPORT vtkMTParaViewBuilder : public vtkMultiTriangulationBuilder
{
public:
  static vtkMTParaViewBuilder* New();
  vtkTypeMacro(vtkMTParaViewBuilder, vtkMultiTriangulationBuilder);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMTParaViewBuilder();
  ~vtkMTParaViewBuilder() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewBuilder(const vtkMTParaViewBuilder&) = delete;
  void operator=(const vtkMTParaViewBuilder&) = delete;
};

#endif
