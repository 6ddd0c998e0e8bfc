// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewSection
 * @brief vtkMultiTriangulationSection as ParaView's pipelines want it
 *
 * With the array selections as lists. On several ranks, which all have the handle to all patches, the one with the
 * points and cells makes the section and the others an empty one.
 */
#ifndef vtkMTParaViewSection_h
#define vtkMTParaViewSection_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkMultiTriangulationSection.h"

class VTKMTPARAVIEW_EXPORT vtkMTParaViewSection : public vtkMultiTriangulationSection
{
public:
  static vtkMTParaViewSection* New();
  vtkTypeMacro(vtkMTParaViewSection, vtkMultiTriangulationSection);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The array selections, for ParaView's lists: what they know, and their states.
  int GetNumberOfPointArrays();
  const char* GetPointArrayName(int index);
  int GetPointArrayStatus(const char* name);
  void SetPointArrayStatus(const char* name, int status);
  int GetNumberOfCellArrays();
  const char* GetCellArrayName(int index);
  int GetCellArrayStatus(const char* name);
  void SetCellArrayStatus(const char* name, int status);
  ///@}

protected:
  vtkMTParaViewSection();
  ~vtkMTParaViewSection() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewSection(const vtkMTParaViewSection&) = delete;
  void operator=(const vtkMTParaViewSection&) = delete;
};

#endif
