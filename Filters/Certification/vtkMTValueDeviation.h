// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTValueDeviation
 * @brief certified differences between the values of an array on a fragment and on the input
 *
 * The bound of a step (vtkMTDeviation) rests on pairs of a floor's triangle t and a fragment's triangle s, parts of
 * which stand for each other: every point of such a part is within the pair's distance d of the other triangle. Here
 * it is bounded by how much the value at a point x of that part of t differs from that at the point of s nearest to x,
 * and the other way round. The two points are no farther apart than d, so distance and value hold for one and the same
 * point of the input, and what is known of the floor's triangle is added (decision 0014).
 *
 * Values of points are linear over a triangle, those of cells constant. The value of s goes on linearly over its plane;
 * with p, x projected to that plane, the difference is at most |f_t(x) - f_s(p)| + K h: h is how far p lies outside of
 * s, K the steepness of f_s. That is convex in x, so largest at the corners of what it is taken over: t, clipped to
 * what is within d of s. h is at most d. Where all corners of t and s differ by less, that is the bound, and the one
 * where s has no area or a value is infinite; a value that is not a number is never certified (infinity).
 */
#ifndef vtkMTValueDeviation_h
#define vtkMTValueDeviation_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTDeviation.h"

#include <array>
#include <vector>

class vtkMTSurface;

struct VTKMTCERTIFICATION_EXPORT vtkMTValueDeviation
{
  double ToInput = 0.0;   ///< every point of a triangle has one of the input within both bounds, of which this is one
  double FromInput = 0.0; ///< the same for every point of the input that the triangle stands for

  /// Of a triangle's corners.
  using Values = std::array<double, 3>;
  struct Mesh
  {
    const vtkMTSurface& Surface;
    const std::vector<Values>& Corners; ///< [triangles]
  };

  /// Of an array of one component, which is the mesh's column of its association.
  static std::vector<Values> Get(const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays, std::size_t array);

  /// What is known of the fragment's triangles by the pairs. floorKnown: [floor's triangles], or none: they are the
  /// input's.
  static std::vector<vtkMTValueDeviation> Add(const Mesh& floor, const Mesh& fragment,
    const std::vector<vtkMTValueDeviation>& floorKnown, const std::vector<vtkMTDeviation::Pair>& pairs);

  /// How much the values of the points of t that are within the distance of s differ from those of s's points nearest
  /// to them, at most.
  static double GetDifference(const Mesh& from, std::uint32_t t, const Mesh& to, std::uint32_t s, double distance);
};

#endif
