// SPDX-License-Identifier: BSD-3-Clause
// pipeline MODEL.bmt: shows a Multi-Triangulation in a window; turn it with the mouse and it is drawn as finely as the
// picture needs.
#include <vtkActor.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
