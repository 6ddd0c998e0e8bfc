// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTNormalDeviation
 * @brief certified angles between the shading normals of a fragment and those of the input
 *
 * The bound of a step (vtkMTDeviation) rests on pairs of a floor's triangle t and a fragment's triangle s, parts of
 * which stand for each other: every point of such a part has a partner no farther away than the pair's distance d. Here
 * the angle between the normals of any two points of t and s that are no farther apart than d is bounded, so that the
 * partner which is within the distance is within the angle as well.
 *
 * A shading normal is the direction of the corners' normals, interpolated linearly. Over a triangle that is an affine
 * map n(x) of the place, which goes on over the plane: where x is a place on t and y one on s, |n_t(x) - n_s(y)| is at
 * most |n_t(x) - n_s(p)| + K d, p being x projected to the plane of s and K how fast n_s changes; |n_t(x) - n_s(p)| is
 * convex in x, so largest at the corners of t. Two vectors whose difference is at most c, the longer one of at least
 * the length m, have an angle of at most asin(c / m). The least of three bounds is taken: that one, the same with t and
 * s exchanged, and the largest angle between a corner's normal of t and one of s, where all are below a right angle
 * (then both triangles' normals lie in convex cones around each other's). The first one is of second order: it does not
 * grow with the curvature of what is merely a large triangle.
 *
 * Over levels angles add up like distances (decision 0014), at the same pairs of points, as angles between directions
 * obey the triangle inequality; no sum is above pi. Angles of triangles are stored in units of pi / 65535, rounded up.
 */
#ifndef vtkMTNormalDeviation_h
#define vtkMTNormalDeviation_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTDeviation.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkMTSurface;

struct VTKMTCERTIFICATION_EXPORT vtkMTNormalDeviation
{
  static constexpr double Pi = 3.14159265358979323846;

  ///@{
  /// An angle in radians as it is stored, rounded up, and back.
  static std::uint16_t RoundUp(double angle);
  static double ToRadians(std::uint16_t units) { return Pi / 65535.0 * units; }
  ///@}

  struct Mesh
  {
    const vtkMTSurface& Surface;
    const std::vector<std::array<float, 3>>& Normals; ///< [3 t + c], of the corners; of any length
  };
  /// Of a fragment's triangles, radians. The mean is weighted by area; each triangle counts with its own bound.
  struct Angles
  {
    double Largest = 0.0;
    double Mean = 0.0;
  };
  struct Settings
  {
    const std::vector<vtkMTTriangleDeviation>& FloorDeviations; ///< [floor's triangles]
  };

  /**
   * Fills in the angles of findings.Deviations by its pairs. Gives those of the fragment. Normals are taken as they
   * will be stored: those that are made are rounded before (vtkMTMadeNormals).
   */
  static Angles Add(
    const Mesh& floor, const Mesh& fragment, const Settings& settings, vtkMTDeviation::Findings& findings);

  /// Of any two points, one on either triangle, that are no farther apart than distance (steps). Radians.
  static double Between(
    const Mesh& floor, std::uint32_t floorTriangle, const Mesh& fragment, std::uint32_t triangle, double distance);
};

#endif
