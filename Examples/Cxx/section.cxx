// SPDX-License-Identifier: BSD-3-Clause
// section MODEL.bmt [PICTURE.png]: one half of a model, clipped as it is drawn, and the line in which the plane meets
// the surface, from the patches that it meets.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkMultiTriangulationSection.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  reader->Update();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(reader->GetOutput()->GetCenter());
  plane->SetNormal(-1.0, 0.0, -0.5);

  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputConnection(reader->GetOutputPort());
  section->SetImplicitFunction(plane);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(section->GetOutputPort());
  tubes->SetRadius(0.004 * reader->GetOutput()->GetLength());
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputConnection(tubes->GetOutputPort());
  lines->ScalarVisibilityOff();
  vtkNew<vtkActor> outline;
  outline->SetMapper(lines);
  outline->GetProperty()->SetColor(1.0, 0.2, 0.1);

  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->AddClippingPlane(plane); // what is on its positive side stays
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> half;
  half->SetMapper(mapper);
  vtkNew<vtkProperty> inside;
  inside->SetColor(0.9, 0.75, 0.5);
  half->SetBackfaceProperty(inside);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(half);
  renderer->AddActor(outline);
  renderer->GetActiveCamera()->Azimuth(45.0);
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
