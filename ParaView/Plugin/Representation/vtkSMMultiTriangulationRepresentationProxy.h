// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMMultiTriangulationRepresentationProxy
 * @brief the client's handle of a vtkMultiTriangulationRepresentation, whose figures are those of all processes
 *
 * ParaView gives properties that only inform the values of the client's own process, and a model is drawn in the
 * server, on several ranks by each. So UpdatePropertyInformation gathers the figures of the last frame
 * (vtkMTFigureInformation). Nothing else does: a frame costs no message.
 */
#ifndef vtkSMMultiTriangulationRepresentationProxy_h
#define vtkSMMultiTriangulationRepresentationProxy_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkSMRepresentationProxy.h"

class VTKMTPARAVIEW_EXPORT vtkSMMultiTriangulationRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMMultiTriangulationRepresentationProxy* New();
  vtkTypeMacro(vtkSMMultiTriangulationRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMMultiTriangulationRepresentationProxy();
  ~vtkSMMultiTriangulationRepresentationProxy() override;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMMultiTriangulationRepresentationProxy(const vtkSMMultiTriangulationRepresentationProxy&) = delete;
  void operator=(const vtkSMMultiTriangulationRepresentationProxy&) = delete;
};

#endif
