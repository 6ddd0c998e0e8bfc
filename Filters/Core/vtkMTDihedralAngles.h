// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDihedralAngles
 * @brief the angles between the triangles of a mesh, and what they say of its hard edges
 *
 * Counted are the edges of exactly two triangles that run in opposite directions, by the angle between their normals:
 * flat ones (below 1 degree), hard ones (40 and more), of these the sharp ones (60 and more) and the creases, which lie
 * between flat parts: each of the two triangles has a flat edge as well. What is designed has flat parts that end at
 * sharp edges; what was scanned, or is terrain or noise, has next to no flat edge beside a hard one, and the fewer
 * edges the larger the angle. A mesh is CAD when
 *
 * - at least half of its hard edges are creases, and these are a ten-thousandth of its edges or more; or
 * - flat and sharp edges are both frequent (the product of their shares is at least 0.0075, by number or by length),
 * and at least a twentieth of its hard edges are creases; or
 * - at least half of its edges are sharp, as a tetrahedron's.
 *
 * All sums are of whole numbers (lengths in lattice steps), so they depend on no order.
 * Documentation/decisions/0035-feature-angle.md has the figures.
 */
#ifndef vtkMTDihedralAngles_h
#define vtkMTDihedralAngles_h

#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct vtkMTHalfedgePairs;

class VTKMTFILTERSCORE_EXPORT vtkMTDihedralAngles
{
public:
  static constexpr double Smooth = 180.0; ///< the feature angle that splits nothing
  static constexpr double OfCad = 30.0;

  ///@{
  /// Degrees.
  static constexpr double LargestFlat = 1.0;
  static constexpr double LeastHard = 40.0;
  static constexpr double LeastSharp = 60.0;
  ///@}
  static constexpr double LeastProduct = 0.0075;
  static constexpr double LeastProductWithoutCreases = 0.02; ///< such as cones, whose sides have no flat edge

  void Add(const vtkMTPatch& mesh);
  void Add(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs);
  void Add(const vtkMTDihedralAngles& other);

  struct Sum
  {
    std::uint64_t Edges = 0;
    std::uint64_t Flat = 0;
    std::uint64_t Hard = 0;
    std::uint64_t Sharp = 0;
    std::uint64_t Creases = 0;
  };
  const Sum& GetNumbers() const { return this->Numbers; }
  const Sum& GetLengths() const { return this->Lengths; }

  bool IsCad() const;
  /// OfCad or Smooth.
  double ChooseFeatureAngle() const { return this->IsCad() ? OfCad : Smooth; }
  /// The shares that the choice was made by, in percent, for a report.
  std::string Describe() const;

private:
  // By the angle, from small to large.
  enum EdgeKind : unsigned char
  {
    None,
    Flat,
    Soft,
    Hard,
    Sharp
  };
  struct Normal
  {
    std::array<double, 3> Direction;
    double Length;
  };

  static EdgeKind GetKind(const Normal& a, const Normal& b);
  std::vector<EdgeKind> AddKinds(
    const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs, std::vector<std::uint32_t>& hardEdges);
  static void AddKinds(const std::array<std::uint64_t, Sharp + 1>& weights, Sum& sum);

  Sum Numbers;
  Sum Lengths;
};

#endif
