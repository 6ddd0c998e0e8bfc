// SPDX-License-Identifier: BSD-3-Clause
// region_of_interest MODEL.bmt [PICTURE.png]: a mesh for VTK's own filters and mappers, fine in a ball and coarse
// elsewhere, with its edges.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationCutFilter.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphere.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetModelBounds(bounds);
  const double size = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });

  vtkNew<vtkSphere> ball;
  ball->SetCenter(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), bounds[5]);
  ball->SetRadius(0.08 * size);
  vtkNew<vtkMultiTriangulationCutFilter> cut;
  cut->SetInputConnection(reader->GetOutputPort());
  cut->SetError(3e-5 * size); // within so much of the input, in the ball
  cut->SetRegion(ball);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cut->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->EdgeVisibilityOn();
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->SetFocalPoint(ball->GetCenter());
  renderer->GetActiveCamera()->Zoom(2.5);
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
  std::cout << cut->GetNumberOfTriangles() << " of " << reader->GetOutput()->GetNumberOfFinestTriangles()
            << " triangles\n";
}
