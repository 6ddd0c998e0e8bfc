// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMadeNormals
 * @brief normals that the toolkit makes: sums over triangles, and their places on an octahedron's net
 *
 * A point's normal is the direction of the sum of its triangles' unit normals, each weighted by the triangle's angle at
 * the point (Thuermer and Wuethrich, "Computing vertex normals from polygonal facets", 1998), so that the triangulation
 * of a flat part has no influence. The angle is an arc tangent by a polynomial, off by less than 3e-5 radians. Each
 * term is a whole number of 2^-17: sums do not depend on the order of the triangles. There are only operations here
 * that IEEE 754 defines to the last bit (+ - * / and the square root), so whoever knows the triangles has the same
 * normals, on every machine. That is what files rest on, which keep the differences alone.
 *
 * Normals are rounded to places of an octahedron's net (Meyer et al., "On floating-point normal vectors", 2010) as soon
 * as they are made, so that a file gives them back as they were. With b bits the net has 2^b - 1 places each way, and N
 * = 2^(b - 1) - 1 of them on each side of its middle: coordinate k in [0, 2 N] is (k - N) / N. (2 N + 1, 2 N + 1) is
 * the normal (0, 0, 0). The places on the net's rim are two for each direction; the one of positive coordinates is
 * used.
 */
#ifndef vtkMTMadeNormals_h
#define vtkMTMadeNormals_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTMadeNormals
{
  ///@{
  /// Bits of each coordinate on the net.
  static constexpr int MinimumBits = 6;
  static constexpr int DefaultBits = 12;
  static constexpr int MaximumBits = 16;
  ///@}

  ///@{
  /// What the array says of it, in the property "normal_bits"; the default where it does not.
  static int GetBits(const vtkMTArrayInfo& array);
  static void SetBits(int bits, vtkMTArrayInfo& array);
  ///@}
  /// Whether the array has normals that are on a net: of points, three floats, made by the builder.
  static bool AreIn(const vtkMTArrayInfo& array);
  /// No direction is off by more than this when it is put on the net, radians.
  static double GetRounding(int bits);

  using Place = std::array<std::uint16_t, 2>;
  using Sum = std::array<std::int64_t, 3>; ///< in 2^-17

  /// What a triangle adds at its corners, before it is rounded towards zero to whole numbers. False when the triangle
  /// is degenerate. A reversed triangle adds exactly the opposite.
  static bool GetTerms(const std::array<const vtkMTPoint*, 3>& corners, std::array<std::array<double, 3>, 3>& terms);
  /// The sums of a mesh's points, or of its wedges.
  static void GetSums(const vtkMTPatch& mesh, bool ofPoints, std::vector<Sum>& sums);

  ///@{
  /// A vector's place; that of the z axis for a sum of zeros, and of (0, 0, 0) for a normal that is zero or not finite.
  static Place GetPlace(const Sum& sum, int bits);
  static Place GetPlace(const std::array<float, 3>& normal, int bits);
  /// Those of the sums of a mesh's points, or of its wedges.
  static void GetPlaces(
    const vtkMTPatch& mesh, bool ofPoints, int bits, std::vector<std::uint16_t>& u, std::vector<std::uint16_t>& v);
  ///@}

  ///@{
  /// A place's unit vector.
  static std::array<float, 3> GetNormal(const Place& place, int bits);
  /// Many: the i-th is written behind 12 * places[i] bytes, or 12 * i without places.
  static void GetNormals(const std::uint16_t* u, const std::uint16_t* v, std::size_t count, int bits,
    const std::uint32_t* places, unsigned char* normals);
  ///@}
};

#endif
