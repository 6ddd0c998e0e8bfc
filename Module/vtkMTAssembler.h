// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTAssembler
 * @brief assembles patches to one welded mesh, by identity
 *
 * Points that carry the same id become one point; the wedges of such a point are one when all their attribute values
 * are equal byte for byte. Everything else is appended. The order of the result follows the order of the patches, so it
 * depends on nothing else. Used for floors (BMT section 6), for the mesh of a cut and by the validator.
 */
#ifndef vtkMTAssembler_h
#define vtkMTAssembler_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTAssembler
{
public:
  explicit vtkMTAssembler(const std::vector<vtkMTArrayInfo>& arrays);
  ~vtkMTAssembler();

  /**
   * Appends one patch. False when a shared id comes with another place than before, which is a broken model; the
   * message is in GetError. A column that is empty in the first patch is left empty in the result, and so is one of
   * role ExactPoints that is empty in any. Of other arrays that only the finest level has
   * (vtkMTArrayInfo::IsFinestOnly) the result has a column where any patch has one, with unknown values for the others;
   * a wedge that two patches share is one, with the value that is known.
   */
  bool Add(const vtkMTPatch& patch);

  /// The result so far: all Ids are kept, points with an id first come in order of appearance among the others, so Ids
  /// has one entry per point; points without identity have NoId.
  const vtkMTPatch& GetMesh() const { return this->Mesh; }
  vtkMTPatch TakeMesh();

  /// For each point of the patch that Add took last, its index in the mesh.
  const std::vector<std::uint32_t>& GetPointMap() const { return this->PointMap; }

  const std::string& GetError() const { return this->Error; }

  static constexpr std::uint64_t NoId = ~std::uint64_t(0);

private:
  bool AddPoints(const vtkMTPatch& patch);
  bool AddWedgesAndTriangles(const vtkMTPatch& patch);

  struct Internals;
  std::unique_ptr<Internals> Implementation;
  vtkMTPatch Mesh;
  std::vector<std::uint32_t> PointMap;
  std::string Error;
};

#endif
