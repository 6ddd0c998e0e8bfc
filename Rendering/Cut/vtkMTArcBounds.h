// SPDX-License-Identifier: BSD-3-Clause
// A patch's tight bounds in model units. Not installed.
#ifndef vtkMTArcBounds_h
#define vtkMTArcBounds_h

#include "vtkMTGraph.h"

#include <array>
#include <cmath>

struct vtkMTArcBounds
{
  double Box[6];
  std::array<double, 3> Center;
  double Radius;

  vtkMTArcBounds(const vtkMTGraph& graph, const vtkMTArc& arc)
  {
    graph.Lattice.ToWorld(arc.Box, this->Box);
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      this->Center[i] = 0.5 * (this->Box[2 * i] + this->Box[2 * i + 1]);
      const double half = 0.5 * (this->Box[2 * i + 1] - this->Box[2 * i]);
      square += half * half;
    }
    // Rounding must not make the sphere smaller than the box.
    this->Radius = std::sqrt(square) * (1.0 + 1e-12);
  }
};

#endif
