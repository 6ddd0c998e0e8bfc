// SPDX-License-Identifier: BSD-3-Clause
// Small scenes, their pictures, and comparisons that forgive nothing but rounding.
#ifndef MTPicture_h
#define MTPicture_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <set>
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

  // All of it from above one side, aslant; a smaller zoom is farther away.
  void LookFromTheSide(double zoom = 1.3);

  // What a hardware selector finds in an area (the least and largest column and row), as ids.
  std::set<vtkIdType> Select(int association, const unsigned int (&area)[4]);

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
