// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSharedNormals
 * @brief the normals of points that several regions share
 *
 * vtkMTPointNormals sums over the triangles around a point, in their order; around a shared point these are in several
 * regions. Their terms are sorted by point and triangle (externally), summed in that order, and the direction is sorted
 * back to every region that has the point. A term's sign is known when the orientation is.
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
  /// What one triangle adds at one of its corners, as it is stored.
  struct Term
  {
    std::uint64_t Key; ///< point above, the triangle's number below; AllTriangles for the entry that names a region
    std::uint32_t Component;
    std::uint32_t IsTurned;
    std::array<double, 3> Sum;
  };

  /// memory: bytes, for both sorts together.
  vtkMTSharedNormals(vtkMTSpoolStore& store, std::size_t memory);

  /**
   * The terms of a fragment's triangles at its shared points. Made by any thread; componentOf and isTurned are the
   * fragment's (vtkMTOrientation::Fragment), and components are still counted within it.
   */
  static void FindTerms(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& numbers,
    const std::vector<std::uint32_t>& componentOf, const std::vector<unsigned char>& isTurned, std::uint32_t region,
    std::vector<Term>& terms);

  ///@{
  /// All fragments' terms, with the numbers that vtkMTOrientation gave to their components; then Solve; then regions in
  /// increasing order. False with a message in GetError.
  bool Add(const std::vector<Term>& terms, const std::vector<std::uint32_t>& components);
  bool Solve(const vtkMTOrientation& orientation);
  /// Replaces the normals of the fragment's shared points.
  bool Take(std::uint32_t region, const vtkMTPatch& fragment, std::vector<std::array<float, 3>>& normals);
  ///@}

  const std::string& GetError() const { return this->Error; }

private:
  static constexpr std::uint32_t AllTriangles = ~std::uint32_t(0);

  vtkMTRecordSort Terms;
  vtkMTRecordSort Normals;
  const unsigned char* Next = nullptr;
  std::string Error;
};

#endif
