// SPDX-License-Identifier: BSD-3-Clause
// time_budget MODEL.bmt [RATE [PICTURE.png]]: on a slow machine: the window asks for frames per second (30), and the
// cut becomes as coarse as that needs while the camera moves. What was drawn is printed.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  const double rate = argc > 2 ? std::atof(argv[2]) : 30.0;
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetPixelError(0.5);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (argc > 3)
  {
    window->OffScreenRenderingOn();
    window->SetDesiredUpdateRate(rate);
    std::array<double, 40> seconds;
    for (double& second : seconds)
    {
      renderer->GetActiveCamera()->Azimuth(2.0);
      const double start = vtkTimerLog::GetUniversalTime();
      window->Render();
      window->WaitForCompletion();
      second = vtkTimerLog::GetUniversalTime() - start;
    }
    std::nth_element(seconds.begin(), seconds.begin() + 20, seconds.end());
    std::cout << 1.0 / seconds[20] << " frames per second of " << rate << " asked for\n";
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
    interactor->SetDesiredUpdateRate(rate); // while the mouse moves the camera
    interactor->Start();
  }
  std::cout << mapper->GetNumberOfTriangles() << " triangles in the last frame, within "
            << mapper->GetAchievedPixelError() << " pixels\n";
}
