// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCertifiedMesh
 * @brief a part of a level's mesh, fragment or patch, with what is known of its triangles' distances from the input
 *
 * Splitting, spooling and assembling keep both in the same order. Never part of a file: it is stored in the spools of
 * the construction. Of the input's own mesh all deviations are zero; these take no room.
 */
#ifndef vtkMTCertifiedMesh_h
#define vtkMTCertifiedMesh_h

#include "vtkMTBytes.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTDeviation.h"
#include "vtkMTPatch.h"
#include "vtkMTValueDeviation.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vtkMTBytes
{
class Reader;
class Writer;
}

struct VTKMTCONSTRUCTION_EXPORT vtkMTCertifiedMesh
{
  vtkMTPatch Mesh;
  std::vector<vtkMTTriangleDeviation> Deviations; ///< of the triangles, steps
  /// Of the values of the arrays that are certified: [triangle * arrays + array]. None: all are zero.
  std::vector<vtkMTValueDeviation> ValueDeviations;

  /// Those of some triangles of a whole, of which the mesh is made.
  void TakeDeviations(const vtkMTCertifiedMesh& whole, const std::vector<std::uint32_t>& triangles);

  ///@{
  /// As bytes. Take gives false when they are not those of such a mesh; Decode has a message then.
  void Put(vtkMTBytes::Writer& writer) const;
  bool Take(vtkMTBytes::Reader& reader);
  void Encode(std::vector<unsigned char>& bytes) const;
  bool Decode(const vtkMTBytes::Record& bytes, std::string& error);
  ///@}
};

#endif
