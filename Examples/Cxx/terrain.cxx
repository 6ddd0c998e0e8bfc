// SPDX-License-Identifier: BSD-3-Clause
// terrain TERRAIN.bmt TILE... [PICTURE.png]: joins tiles (.hgt, .hgt.gz, .dem, GeoTIFF) into one terrain in metres, a
// file that is built out of core, and colours it by height.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationFileBuilder.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  const bool drawn = argc > 1 && std::string(argv[argc - 1]).find(".png") != std::string::npos;
  vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetOutputFileName(argc > 1 ? argv[1] : "terrain.bmt");
  for (int i = 2; i < argc - (drawn ? 1 : 0); ++i)
  {
    builder->AddFileName(argv[i]);
  }
  builder->SetVerticalScale(2.0);
  if (!builder->Write())
  {
    std::cerr << builder->GetErrorMessage() << "\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(builder->GetOutputFileName());
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetModelBounds(bounds);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(bounds[4], 0.3, 0.6, 0.3);
  colors->AddRGBPoint(0.5 * (bounds[4] + bounds[5]), 0.7, 0.65, 0.4);
  colors->AddRGBPoint(bounds[5], 1.0, 1.0, 1.0);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetLookupTable(colors);
  const double low[3] = { 0.0, 0.0, bounds[4] };
  const double high[3] = { 0.0, 0.0, bounds[5] };
  mapper->SetColorByElevation(low, high, bounds + 4);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->Elevation(-55.0); // from the south
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
