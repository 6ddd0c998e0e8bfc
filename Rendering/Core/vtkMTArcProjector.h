// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArcProjector
 * @brief a view in the lattice's steps, for many boxes: what of them can be seen, and what errors in them become
 *
 * What all boxes have in common - planes, rounding, the angle of the view's corner - is found once, in the units of the
 * boxes, so that a look costs a few dozen multiplications. The bounds are vtkMTView's. Rounding is allowed for as if
 * every coordinate had all of its 31 bits, which is still far below one step. Not installed.
 */
#ifndef vtkMTArcProjector_h
#define vtkMTArcProjector_h

#include "vtkMTLattice.h"
#include "vtkMTView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

class vtkMTArcProjector
{
public:
  struct Box
  {
    // In steps. Exact.
    std::array<double, 3> Center;
    std::array<double, 3> Half;

    explicit Box(const vtkMTBox& box)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Center[i] = 0.5 * (static_cast<double>(box[2 * i]) + static_cast<double>(box[2 * i + 1]));
        this->Half[i] = 0.5 * (static_cast<double>(box[2 * i + 1]) - static_cast<double>(box[2 * i]));
      }
    }
    bool IsEmpty() const { return this->Half[0] < 0.0; }
    // Rounding must not make the sphere smaller than the box.
    double GetRadius() const
    {
      return std::sqrt(this->Half[0] * this->Half[0] + this->Half[1] * this->Half[1] + this->Half[2] * this->Half[2]) *
        (1.0 + 1e-12);
    }
  };

  /// How near a box comes, and how far off the axis it reaches.
  struct Depth
  {
    double Nearest; // along the axis, eye units
    double Cosine;  // of the largest angle off the axis
  };

  vtkMTArcProjector() = default;
  vtkMTArcProjector(const vtkMTLattice& lattice, const vtkMTView& view);

  /**
   * By how much (model units) the box can shrink on every side before it is outside of the frustum; negative, by how
   * much it has to grow before any of it may be inside. A bound: not less than what it is.
   */
  double GetInside(const Box& box) const
  {
    if (box.IsEmpty())
    {
      return -std::numeric_limits<double>::infinity();
    }
    // At the corner that lies farthest inside. No plane is skipped, so that several are done at once.
    std::array<double, Planes> values;
    for (int i = 0; i < Planes; ++i)
    {
      values[i] = this->Constant[i] + this->Slope[0][i] * box.Center[0] + this->Slope[1][i] * box.Center[1] +
        this->Slope[2][i] * box.Center[2] + std::abs(this->Slope[0][i]) * box.Half[0] +
        std::abs(this->Slope[1][i]) * box.Half[1] + std::abs(this->Slope[2][i]) * box.Half[2];
    }
    return *std::min_element(values.begin(), values.end());
  }

  /// False only when no point of the box, grown by so much (model units) on every side, can be seen.
  bool IsVisible(const Box& box, double grown = 0.0) const { return this->GetInside(box) + grown >= 0.0; }

  Depth GetDepth(const Box& box) const;

  /// Upper bound of what an error of so many model units can do there; as vtkMTView::GetPixelError.
  double GetPixelError(const Depth& depth, double error) const;

  double GetRadius(const Box& box) const { return this->Step * box.GetRadius(); }

private:
  static constexpr int Planes = 6;
  // Of steps; scaled so that a model unit more on every side of a box adds 1. The constant has what rounding may take
  // off.
  std::array<std::array<double, Planes>, 3> Slope{};
  std::array<double, Planes> Constant{};
  std::array<double, 12> ToEye{}; // rows; from steps
  double Step = 1.0;
  double Stretch = 1.0;       // of model units
  double RadiusStretch = 1.0; // of steps
  double Slack = 0.0;         // of an eye coordinate
  double Near = 0.0;
  double PixelsPerUnit = 1.0;
  double CornerCosine = 1.0;
  bool Parallel = false;
};

#endif
