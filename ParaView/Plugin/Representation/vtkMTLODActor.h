// SPDX-License-Identifier: BSD-3-Clause
// A vtkPVLODActor that tells the actor that it draws by how much time it has, and whether a frame begins: without that
// the mapper knows of neither.
#ifndef vtkMTLODActor_h
#define vtkMTLODActor_h

#include "vtkPVLODActor.h"

class vtkMTLODActor : public vtkPVLODActor
{
public:
  static vtkMTLODActor* New();
  vtkTypeMacro(vtkMTLODActor, vtkPVLODActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

protected:
  vtkMTLODActor();
  ~vtkMTLODActor() override;

private:
  vtkMTLODActor(const vtkMTLODActor&) = delete;
  void operator=(const vtkMTLODActor&) = delete;
};

#endif
