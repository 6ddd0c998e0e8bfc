// SPDX-License-Identifier: BSD-3-Clause
// source_to_screen MESH.ply [PICTURE.png]: from the file of a mesh to the screen in one pipeline, in memory.
#include <vtkActor.h>
#include <vtkMultiTriangulationBuilder.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "mesh.ply");
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(builder->GetOutputPort());
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
