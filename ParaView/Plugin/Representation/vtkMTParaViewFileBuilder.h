// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewFileBuilder
 * @brief builds a Multi-Triangulation file from files, and reads it
 *
 * vtkMultiTriangulationFileBuilder has no output; ParaView's sources have. When a setting of the builder has changed,
 * this one has it build its file, and then reads that. On several ranks, rank 0 builds and the others wait.
 */
#ifndef vtkMTParaViewFileBuilder_h
#define vtkMTParaViewFileBuilder_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMTParaViewReader.h"
#include "vtkSmartPointer.h"

class vtkMultiTriangulationFileBuilder;

class VTKMTPARAVIEW_EXPORT vtkMTParaViewFileBuilder : public vtkMTParaViewReader
{
public:
  static vtkMTParaViewFileBuilder* New();
  vtkTypeMacro(vtkMTParaViewFileBuilder, vtkMTParaViewReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The builder, with its settings. Default: one with its defaults. nullptr is an error when the source runs.
  void SetBuilder(vtkMultiTriangulationFileBuilder* builder);
  vtkMultiTriangulationFileBuilder* GetBuilder();
  ///@}

  /// The settings of the builder included.
  vtkMTimeType GetMTime() override;

protected:
  vtkMTParaViewFileBuilder();
  ~vtkMTParaViewFileBuilder() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewFileBuilder(const vtkMTParaViewFileBuilder&) = delete;
  void operator=(const vtkMTParaViewFileBuilder&) = delete;

  bool Build();
  void OnProgress(vtkObject* caller, unsigned long event, void* data);

  vtkSmartPointer<vtkMultiTriangulationFileBuilder> Builder;
};

#endif
