// SPDX-License-Identifier: BSD-3-Clause
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>

MTScene::MTScene(vtkMapper* mapper, int width, int height)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
  , Mapper(mapper)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(0.1, 0.1, 0.2);
  this->Actor->SetMapper(mapper);
}

MTScene::~MTScene() = default;

vtkSmartPointer<vtkImageData> MTScene::Render()
{
  this->Window->Render();
  const int* size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->GetPointData()->SetScalars(pixels);
  return picture;
}

void MTScene::LookFromTheSide(double zoom)
{
  this->Renderer->ResetCamera();
  this->Renderer->GetActiveCamera()->Elevation(-50.0);
  this->Renderer->GetActiveCamera()->Zoom(zoom);
  this->Renderer->ResetCameraClippingRange();
}

std::set<vtkIdType> MTScene::Select(int association, const unsigned int (&area)[4])
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(area[0], area[1], area[2], area[3]);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<vtkIdType> ids;
  for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
  {
    auto* list = vtkIdTypeArray::SafeDownCast(selection->GetNode(n)->GetSelectionList());
    for (vtkIdType i = 0; i < list->GetNumberOfValues(); ++i)
    {
      ids.insert(list->GetValue(i));
    }
  }
  return ids;
}

MTDifference MTDifference::Compare(vtkImageData* a, vtkImageData* b)
{
  MTDifference difference;
  auto* x = vtkUnsignedCharArray::SafeDownCast(a->GetPointData()->GetScalars());
  auto* y = vtkUnsignedCharArray::SafeDownCast(b->GetPointData()->GetScalars());
  if (x->GetNumberOfTuples() != y->GetNumberOfTuples() || x->GetNumberOfComponents() != y->GetNumberOfComponents())
  {
    difference.Pixels = difference.ClearlyOff = static_cast<std::size_t>(y->GetNumberOfTuples());
    difference.Largest = 255;
    return difference;
  }
  for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i)
  {
    int largest = 0;
    bool background = true;
    for (int c = 0; c < x->GetNumberOfComponents(); ++c)
    {
      const int value = y->GetTypedComponent(i, c);
      largest = std::max(largest, std::abs(x->GetTypedComponent(i, c) - value));
      background = background && value == y->GetTypedComponent(0, c);
    }
    difference.Pixels += largest > 0;
    difference.ClearlyOff += largest > MTDifference::Slight;
    difference.Drawn += !background;
    difference.Largest = std::max(difference.Largest, largest);
  }
  return difference;
}

std::ostream& operator<<(std::ostream& os, const MTDifference& difference)
{
  return os << difference.Drawn << " pixels drawn, " << difference.Pixels << " differ, " << difference.ClearlyOff
            << " clearly, the largest difference is " << difference.Largest;
}

void MTWritePicture(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->Write();
}

bool MTMatchesBaseline(vtkImageData* picture, const std::string& name, std::string& reason)
{
  const std::string baseline = std::string(MT_BASELINE_DIRECTORY) + "/" + name + ".png";
  const std::string output = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/" + name + ".png";
  MTWritePicture(picture, output);
  if (!std::ifstream(baseline))
  {
    reason = baseline + " is missing; the picture is in " + output;
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const MTDifference difference = MTDifference::Compare(picture, reader->GetOutput());
  if (difference.ClearlyOff > 0)
  {
    std::ostringstream text;
    text << difference << "; the picture is in " << output << ", the baseline is " << baseline;
    reason = text.str();
    return false;
  }
  return true;
}
