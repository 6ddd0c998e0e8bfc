// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSelectionEncoder
 * @brief makes selections in pictures of a Multi-Triangulation selections of the input's ids
 *
 * ParaView takes what is selected in a picture for indices of the points and cells of the data that is shown. Here that
 * is the coarsest cut, and what was selected are the input's ids, which the mapper has put into the picture. So this
 * encoder, in place of ParaView's (by vtkObjectFactory), makes a selection by values of the array of ids; it selects
 * the same in every cut, section or mesh that has this array. Other representations' selections stay what they are.
 */
#ifndef vtkMTSelectionEncoder_h
#define vtkMTSelectionEncoder_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkPVEncodeSelectionForServer.h"

class VTKMTPARAVIEW_EXPORT vtkMTSelectionEncoder : public vtkPVEncodeSelectionForServer
{
public:
  static vtkMTSelectionEncoder* New();
  vtkTypeMacro(vtkMTSelectionEncoder, vtkPVEncodeSelectionForServer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool ProcessSelection(vtkSelection* rawSelection, vtkSMRenderViewProxy* viewProxy, bool multipleSelectionsAllowed,
    vtkCollection* selectedRepresentations, vtkCollection* selectionSources, int modifier, bool selectBlocks) override;

protected:
  vtkMTSelectionEncoder();
  ~vtkMTSelectionEncoder() override;

private:
  vtkMTSelectionEncoder(const vtkMTSelectionEncoder&) = delete;
  void operator=(const vtkMTSelectionEncoder&) = delete;
};

#endif
