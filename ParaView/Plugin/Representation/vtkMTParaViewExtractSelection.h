// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTParaViewExtractSelection
 * @brief ParaView's extraction for highlights and tooltips, which takes selected parts of a model from what is drawn
 *
 * ParaView extracts what is selected, or is under the cursor, from the data of the pipeline, which for a
 * Multi-Triangulation is its coarsest mesh: most of what a user sees is not in it. The plugin puts this class in place
 * of the one that ParaView extracts with. Where the input is a model that a vtkMultiTriangulationRepresentation shows
 * and the selection is one of values (ids of the input), the first output is extracted from the cut of the last frame.
 * Everything else is as in vtkPVExtractSelection.
 *
 * On several ranks the first one extracts: all have the same cut.
 */
#ifndef vtkMTParaViewExtractSelection_h
#define vtkMTParaViewExtractSelection_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkPVExtractSelection.h"
#include "vtkVersion.h"

class VTKMTPARAVIEW_EXPORT vtkMTParaViewExtractSelection : public vtkPVExtractSelection
{
public:
  static vtkMTParaViewExtractSelection* New();
  vtkTypeMacro(vtkMTParaViewExtractSelection, vtkPVExtractSelection);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 20240617)
  /// ParaView 5.13 sets this wherever it extracts; before it there is no such choice, and this does nothing.
  void SetHyperTreeGridToUnstructuredGrid(bool)
  {
  }
#endif

protected:
  vtkMTParaViewExtractSelection();
  ~vtkMTParaViewExtractSelection() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMTParaViewExtractSelection(const vtkMTParaViewExtractSelection&) = delete;
  void operator=(const vtkMTParaViewExtractSelection&) = delete;
};

#endif
