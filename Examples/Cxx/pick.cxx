// SPDX-License-Identifier: BSD-3-Clause
// pick MODEL.bmt [X Y PICTURE.png]: which triangle of the input is drawn at a pixel, and where it is; in a window the
// key p picks under the cursor.
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCellPicker.h>
#include <vtkMultiTriangulationLocator.h>
#include <vtkMultiTriangulationMapper.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
void ShowPick(vtkObject* caller, unsigned long, void* label, void*)
{
  auto* picker = vtkCellPicker::SafeDownCast(caller);
  if (picker->GetCellId() < 0)
  {
    std::cout << "nothing there\n";
    return;
  }
  double place[3];
  picker->GetPickPosition(place);
  const std::string text = "triangle " + std::to_string(picker->GetCellId());
  std::cout << text << " of the input at (" << place[0] << ", " << place[1] << ", " << place[2] << ")\n";
  static_cast<vtkTextActor*>(label)->SetInput(text.c_str());
  static_cast<vtkTextActor*>(label)->SetPosition(picker->GetSelectionPoint());
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "model.bmt");
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);

  vtkNew<vtkMultiTriangulationLocator> locator;
  locator->SetMapper(mapper);
  vtkNew<vtkCellPicker> picker;
  picker->AddLocator(locator);
  vtkNew<vtkTextActor> label;
  label->GetTextProperty()->SetFontSize(28);
  label->GetTextProperty()->SetColor(0.8, 0.1, 0.0);
  renderer->AddActor2D(label);
  vtkNew<vtkCallbackCommand> show;
  show->SetCallback(ShowPick);
  show->SetClientData(label);
  picker->AddObserver(vtkCommand::EndPickEvent, show);
  renderer->SetBackground(0.2, 0.25, 0.3);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  if (argc > 4)
  {
    window->OffScreenRenderingOn();
    window->Render(); // picked is in what has been drawn
    picker->Pick(std::atof(argv[2]), std::atof(argv[3]), 0.0, renderer);
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
    interactor->SetPicker(picker);
    interactor->Start();
  }
}
