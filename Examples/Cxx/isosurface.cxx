// SPDX-License-Identifier: BSD-3-Clause
// isosurface VOLUME VALUE SURFACE.bmt [PICTURE.png]: the isosurface of a volume (.vti, .mhd, .nrrd, .nii.gz) as a file,
// built out of core.
#include <vtkActor.h>
#include <vtkMultiTriangulationFileBuilder.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: isosurface VOLUME VALUE SURFACE.bmt [PICTURE.png]\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName(argv[1]);
  builder->SetIsoValue(std::atof(argv[2]));
  builder->SetOutputFileName(argv[3]);
  builder->SetMemoryLimit(vtkTypeInt64(1) << 30); // 1 GiB for the whole process
  if (!builder->Write())
  {
    std::cerr << builder->GetErrorMessage() << "\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argv[3]);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.8, 0.65);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (argc > 4)
  {
    window->OffScreenRenderingOn();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grabber->GetOutputPort());
    writer->SetFileName(argv[4]);
    writer->Write();
  }
  else
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
}
