// SPDX-License-Identifier: BSD-3-Clause
// Small scenes, their pictures, and comparisons that forgive nothing but rounding.
#ifndef MTPicture_h
#define MTPicture_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <string>

class vtkActor;
class vtkImageData;
class vtkMapper;
class vtkRenderWindow;
class vtkRenderer;

// One actor in one off-screen window of 300 x 300 pixels, without multisampling, seen as ResetCamera sees it.
class MTScene
{
public:
  explicit MTScene(vtkMapper* mapper, int width = 300, int height = 300);
  ~MTScene();

  vtkSmartPointer<vtkImageData> Render();

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkMapper> Mapper;
};

struct MTDifference
{
  std::size_t Pixels = 0;     // that differ at all
  std::size_t ClearlyOff = 0; // that differ by more than MTDifference::Slight in a channel
  std::size_t Drawn = 0;      // that are not background in the second picture
  int Largest = 0;            // in a channel

  // Two roundings of the same shading: the last bits of an eight-bit channel.
  static constexpr int Slight = 3;

  static MTDifference Compare(vtkImageData* a, vtkImageData* b);
};

std::ostream& operator<<(std::ostream& os, const MTDifference& difference);

// Compares with Testing/Data/Baseline/<name>.png; when that is missing or differs, the picture is written to the output
// folder and false is returned with the reason.
bool MTMatchesBaseline(vtkImageData* picture, const std::string& name, std::string& reason);

void MTWritePicture(vtkImageData* picture, const std::string& path);

#endif
