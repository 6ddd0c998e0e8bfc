// SPDX-License-Identifier: BSD-3-Clause
// colour_by_array MODEL.bmt ARRAY [PICTURE.png]: colours that span the range of the whole model, whatever is drawn of
// it.
#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkLookupTable.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  reader->Update();
  const char* array = argc > 2 ? argv[2] : "Elevation";
  vtkMultiTriangulation* model = reader->GetOutput();
  double range[2];
  const bool ofPoints = model->GetArrayRange(array, vtkDataObject::POINT, 0, range);
  if (!ofPoints && !model->GetArrayRange(array, vtkDataObject::CELL, 0, range))
  {
    std::cerr << "the model has no array " << array << "\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.667, 0.0); // blue to red
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScalarMode(ofPoints ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectColorArray(array);
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(range);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle(array);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AddActor2D(bar);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (argc > 3)
  {
    window->OffScreenRenderingOn();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grabber->GetOutputPort());
    writer->SetFileName(argv[3]);
    writer->Write();
  }
  else
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
}
