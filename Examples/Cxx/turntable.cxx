// SPDX-License-Identifier: BSD-3-Clause
// turntable MODEL.bmt FOLDER [FRAMES]: pictures of a model that turns once, frame-000.png and so on, off screen; a film
// of them: ffmpeg -framerate 25 -i FOLDER/frame-%03d.png film.mp4
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: turntable MODEL.bmt FOLDER [FRAMES]\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(640, 480);
  window->AddRenderer(renderer);

  std::filesystem::create_directories(argv[2]);
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  const int frames = argc > 3 ? std::atoi(argv[3]) : 100;
  for (int frame = 0; frame < frames; ++frame)
  {
    const std::string number = std::to_string(1000 + frame).substr(1);
    writer->SetFileName((std::string(argv[2]) + "/frame-" + number + ".png").c_str());
    grabber->Modified(); // the camera has moved
    writer->Write();
    renderer->GetActiveCamera()->Azimuth(360.0 / frames);
  }
}
