// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewTransform
 * @brief vtkMultiTriangulationTransform as ParaView's pipelines want it
 *
 * The arrays of the output say the ranges of the whole model, as those of vtkMTParaViewReader do. Of the ranks that
 * have the handle to all patches, those without points and cells stay without.
 */
#ifndef vtkMTParaViewTransform_h
#define vtkMTParaViewTransform_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMultiTriangulationTransform.h"

class VTKMTPARAVIEW_EXPORT vtkMTParaViewTransform : public vtkMultiTriangulationTransform
{
public:
  static vtkMTParaViewTransform* New();
  vtkTypeMacro(vtkMTParaViewTransform, vtkMultiTriangulationTransform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMTParaViewTransform();
  ~vtkMTParaViewTransform() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewTransform(const vtkMTParaViewTransform&) = delete;
  void operator=(const vtkMTParaViewTransform&) = delete;
};

#endif
