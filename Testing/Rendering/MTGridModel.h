// SPDX-License-Identifier: BSD-3-Clause
// A small Multi-Triangulation made by hand: a height field over a quadtree of square tiles. Each node merges four tiles
// into one with a coarser inside and the same border, so all cuts conform without any help of the builder.
#ifndef MTGridModel_h
#define MTGridModel_h

#include "vtkSmartPointer.h"

#include <array>
#include <memory>

class vtkMTPatchStore;
class vtkMultiTriangulation;
class vtkMultiTriangulationMapper;
class vtkPolyData;

struct MTGridModel
{
  int Cells = 128;   // of the finest grid, per side; a power of two
  int TileCells = 8; // per side of a finest patch; a power of two, at least 4
  double Size = 1.0; // of the side, model units
  std::array<double, 3> Corner{ 0.0, 0.0, 0.0 };
  bool WithPointNormals = true;
  bool WithCellNormals = false;
  bool WithCellIds = true;

  // Arrays: point Elevation (float, the active scalars), Color (RGBA bytes), TCoords, Normals; cell Block (int),
  // CellIds.
  std::shared_ptr<vtkMTPatchStore> Make() const;

  // The same as what a pipeline carries.
  vtkSmartPointer<vtkMultiTriangulation> MakeData() const;

  // A mapper of such a model (or of another input), which colours by its elevation.
  static vtkSmartPointer<vtkMultiTriangulationMapper> MakeMapper(vtkPolyData* input, double pixelError);

  // Height over the unit square for a side of 1.
  static double GetHeight(double u, double v);
};

#endif
