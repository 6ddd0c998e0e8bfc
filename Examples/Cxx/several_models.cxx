// SPDX-License-Identifier: BSD-3-Clause
// several_models MODEL.bmt... [PICTURE.png]: models beside each other in one scene. Each keeps within a pixel; a frame
// rate that the window asks for is shared by all.
#include <vtkActor.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <string>

int main(int argc, char* argv[])
{
  const bool drawn = argc > 1 && std::string(argv[argc - 1]).find(".png") != std::string::npos;
  vtkNew<vtkRenderer> renderer;
  double left = 0.0;
  for (int i = 1; i < argc - (drawn ? 1 : 0); ++i)
  {
    vtkNew<vtkMultiTriangulationReader> reader;
    reader->SetFileName(argv[i]);
    reader->Update();
    double bounds[6];
    reader->GetOutput()->GetModelBounds(bounds);
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputConnection(reader->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(left - bounds[0], -bounds[2], -bounds[4]);
    left += 1.1 * (bounds[1] - bounds[0]);
    renderer->AddActor(actor);
  }
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (drawn)
  {
    window->OffScreenRenderingOn();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grabber->GetOutputPort());
    writer->SetFileName(argv[argc - 1]);
    writer->Write();
  }
  else
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
}
