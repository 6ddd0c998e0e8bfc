// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegionStep
 * @brief one region's simplification: from the patches of its floor to its certified fragment
 *
 * Assembles the patches by identity, locks the points that triangles outside the region use, simplifies, bounds the
 * two-sided distance between floor and fragment and by it that between input and fragment, and carries the attributes
 * over. Independent of all other regions.
 */
#ifndef vtkMTRegionStep_h
#define vtkMTRegionStep_h

#include "vtkMTCertifiedMesh.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTDirectDeviation.h"
#include "vtkMTNormalDeviation.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkMTSimplifier;
class vtkMTSurface;
struct vtkMTSimplification;

struct VTKMTCONSTRUCTION_EXPORT vtkMTRegionStep
{
  vtkMTCertifiedMesh Fragment; ///< points that are shared with other regions come first, with their ids
  std::size_t FloorTriangles = 0;
  double Error = 0.0; ///< certified distance of fragment and input, in steps of the lattice
  /// Certified angles between the normals of fragment and input.
  std::optional<vtkMTNormalDeviation::Angles> NormalDeviation;
  std::vector<double> ValueDeviations;         ///< certified ones of the arrays that are to be
  double EdgeLength = 0.0;                     ///< mean, in steps
  bool HasFullySharedBorder = false;           ///< BMT section 3.2, condition 3, is violated here
  std::map<std::string, std::int64_t> Blocked; ///< filled when the target was missed

  struct Context
  {
    const vtkMTSimplifier* Simplifier;
    const std::vector<vtkMTArrayInfo>* Arrays;
    const std::vector<std::uint64_t>* LockedIds; ///< sorted
    std::uint32_t FloorLevel;
    double Reduction;             ///< triangles of the floor over those of the fragment
    bool CertifyNormals = false;  ///< or else there is no NormalDeviation
    bool HasSmoothNormals = true; ///< of normals that are made: one for each point, and not split along hard edges
    /// Which arrays' values are certified; none or null: no ones.
    const std::vector<std::size_t>* CertifiedArrays = nullptr;
    /// Of the mesh that the sums of steps are held against (vtkMTDirectDeviation); below 2: they stand.
    std::uint32_t LevelsBelow = 0;
    /// Gives it near some triangles, relative to the origin that it is told.
    std::function<bool(const vtkMTDirectDeviation::Neighbourhood& near, std::size_t levelsBelow,
      const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part, std::string& error)>
      CollectFiner{};
  };

  /// False on failure, with a message in error. floorPatches are consumed.
  bool Run(std::vector<vtkMTCertifiedMesh>& floorPatches, const Context& context, std::string& error);

private:
  static vtkMTCertifiedMesh Assemble(
    std::vector<vtkMTCertifiedMesh>& patches, const std::vector<vtkMTArrayInfo>& arrays, std::string& error);
  bool Certify(
    vtkMTCertifiedMesh& floor, vtkMTSimplification& simplification, const Context& context, std::string& error);
  bool ImproveByFinerLevel(const vtkMTDirectDeviation::Mesh& floor, const vtkMTSurface& fragment,
    const vtkMTPoint& origin, const Context& context, std::vector<vtkMTTriangleDeviation>& deviations,
    std::string& error);
  void CertifyNormals(const vtkMTPatch& floor, const vtkMTSurface& floorSurface, const vtkMTSurface& fragmentSurface,
    const vtkMTDeviation::Relation& relation, const Context& context, vtkMTDeviation::Findings& findings);
  void CertifyValues(const vtkMTCertifiedMesh& floor, const vtkMTSurface& floorSurface,
    const vtkMTSurface& fragmentSurface, const Context& context, const std::vector<vtkMTDeviation::Pair>& pairs);
  void RenewNormals(const Context& context);
  void RoundPoints(std::vector<vtkMTTriangleDeviation>& deviations);
};

#endif
