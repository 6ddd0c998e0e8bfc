// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeasuringFrame
 * @brief the frame in which the verification measures distances, and the boxes that it is made from
 *
 * Distances are taken in coordinates relative to the centre of a common box, scaled by a power of two so that the box
 * is about of size 1: far from the origin no digits are lost to the offset, and tiny or huge scenes neither underflow
 * nor overflow when squared.
 */
#ifndef vtkMTMeasuringFrame_h
#define vtkMTMeasuringFrame_h

#include "vtkMTVerificationModule.h" // For export macro

#include <array>

using vtkMTRealPoint = std::array<double, 3>;

struct VTKMTVERIFICATION_EXPORT vtkMTRealBounds
{
  vtkMTRealPoint Minimum;
  vtkMTRealPoint Maximum;

  vtkMTRealBounds(); ///< empty
  void Add(const vtkMTRealPoint& x);
  void Add(const vtkMTRealBounds& other);
  bool IsEmpty() const { return this->Minimum[0] > this->Maximum[0]; }
  double GetDiagonal() const;
};

struct VTKMTVERIFICATION_EXPORT vtkMTMeasuringFrame
{
  vtkMTRealPoint Center{ 0.0, 0.0, 0.0 };
  double Scale = 1.0; ///< local = (model - Center) * Scale; a power of two

  static vtkMTMeasuringFrame FromBounds(const vtkMTRealBounds& bounds);
  vtkMTRealPoint ToLocal(const vtkMTRealPoint& x) const;
  double ToModel(double localDistance) const { return localDistance / this->Scale; }
  vtkMTRealPoint ToModelPoint(const vtkMTRealPoint& local) const;
  /**
   * Allowance for the rounding of coordinates in double precision, in local units: 1e-12 of the largest coordinate,
   * which is at most 1 here. No other tolerance is used anywhere.
   */
  static constexpr double Tolerance = 1e-12;
};

#endif
