// SPDX-License-Identifier: BSD-3-Clause
// open_file MODEL.bmt [PICTURE.png]: a model in a window: turn it with the mouse, and it is drawn as finely as each
// view needs.
#include <vtkActor.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetPixelError(1.0); // nothing is farther from where the input would put it
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (argc > 2)
  {
    window->OffScreenRenderingOn();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grabber->GetOutputPort());
    writer->SetFileName(argv[2]);
    writer->Write();
  }
  else
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
}
