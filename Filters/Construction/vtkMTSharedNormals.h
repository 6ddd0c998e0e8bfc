// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSharedNormals
 * @brief the normals of points that several regions share
 *
 * vtkMTPointNormals sums over the triangles around a point; around a shared point these are in several
 * regions. Their terms are sorted by point and triangle (externally), summed, and the direction is sorted
 * back to every region that has the point. A term's sign is known when the orientation is. Where normals are split
 * along hard edges, the triangles around a point are in memory together, and those that do not belong to its first
 * group get a normal each.
 */
#ifndef vtkMTSharedNormals_h
#define vtkMTSharedNormals_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"
#include "vtkMTRecordSort.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTOrientation;

class VTKMTCONSTRUCTION_EXPORT vtkMTSharedNormals
{
public:
  /// Degrees, and the net that the normals are put on (vtkMTMadeNormals).
  struct Settings
  {
    double FeatureAngle;
    int Bits;
  };

  /// What one triangle adds at one of its corners, as it is stored.
  struct Term
  {
    std::uint64_t Key; ///< point above, the triangle's number below; AllTriangles for the entry that names a region
    std::uint32_t Component;
    std::uint32_t IsTurned;
    std::uint32_t Next; ///< identities of the triangle's other corners, in its order
    std::uint32_t Previous;
    std::uint32_t Region;
    std::uint32_t Triangle; ///< its index in the region
    std::array<double, 3> Sum;
  };

  /// Of a fragment's shared point: of all its triangles, or of one that has another normal than that.
  struct Normal
  {
    std::uint32_t Point;
    std::uint32_t Triangle; ///< or AllTriangles
    std::array<float, 3> Value;
  };
  static constexpr std::uint32_t AllTriangles = ~std::uint32_t(0);

  /// memory: bytes, for both sorts together.
  vtkMTSharedNormals(vtkMTSpoolStore& store, std::size_t memory);

  /**
   * The terms of a fragment's triangles at its shared points. Made by any thread; componentOf and isTurned are the
   * fragment's (vtkMTOrientation::Fragment), and components are still counted within it; identities are those of its
   * points.
   */
  static void FindTerms(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& numbers,
    const std::vector<std::uint32_t>& identities, const std::vector<std::uint32_t>& componentOf,
    const std::vector<unsigned char>& isTurned, std::uint32_t region, std::vector<Term>& terms);

  ///@{
  /// All fragments' terms, with the numbers that vtkMTOrientation gave to their components; then Solve; then regions in
  /// increasing order. False with a message in GetError.
  bool Add(const std::vector<Term>& terms, const std::vector<std::uint32_t>& components);
  bool Solve(const vtkMTOrientation& orientation, const Settings& settings);
  /// Of the fragment's shared points in their order, that of all triangles first.
  bool Take(std::uint32_t region, const vtkMTPatch& fragment, std::vector<Normal>& normals);
  ///@}

  const std::string& GetError() const { return this->Error; }

private:
  bool SolvePoint(std::vector<Term>& terms, const vtkMTOrientation& orientation, const Settings& settings);
  bool AddNormal(std::uint32_t region, const Normal& normal);

  vtkMTRecordSort Terms;
  vtkMTRecordSort Normals;
  const unsigned char* Next = nullptr;
  std::string Error;
};

#endif
