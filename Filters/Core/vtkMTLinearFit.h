// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLinearFit
 * @brief values at the corners of triangles, linear between them, that are as near as can be to samples of a function
 *
 * Samples lie on triangles, each with a weight, such as the area that it stands for. The values of the free corners are
 * chosen by least squares, those of the others are given: the projection of a function to piecewise linear ones, where
 * taking the function's value at the corner alone would keep its noise and miss its curvature. Solved by conjugate
 * gradients on the normal equations, with a fixed number of steps from what is given, so that the result depends on
 * nothing else. A value stays within the samples on the triangles around its corner; one without samples stays as
 * given.
 */
#ifndef vtkMTLinearFit_h
#define vtkMTLinearFit_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <array>
#include <cstdint>
#include <vector>

class VTKMTFILTERSCORE_EXPORT vtkMTLinearFit
{
public:
  static constexpr int Steps = 12;

  struct Sample
  {
    std::array<std::uint32_t, 3> Corners;
    std::array<double, 3> Weights; ///< barycentric, where on the triangle of these corners it lies
    double Weight = 1.0;           ///< above zero
  };

  /// isFree: [corners]
  vtkMTLinearFit(std::vector<unsigned char>&& isFree, std::vector<Sample>&& samples);

  /// What the function is at a sample; and the least and the most that it is near it.
  struct Value
  {
    double Mean;
    double Least;
    double Most;
  };
  /// ofSamples: [samples] finite. values: [corners] given, and finite; those of free corners change.
  void Solve(const std::vector<Value>& ofSamples, std::vector<double>& values) const;

private:
  using Vector = std::vector<double>; // [corners] zero where it is not free

  double Evaluate(const Sample& sample, const Vector& values) const;
  Vector ApplyTransposed(const std::vector<double>& ofSamples) const;
  void Clamp(const std::vector<Value>& ofSamples, std::vector<double>& values) const;

  std::vector<unsigned char> IsFree;
  std::vector<Sample> Samples;
  Vector Diagonal; // of the normal equations
};

#endif
