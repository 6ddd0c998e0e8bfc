// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTShadingNormals
 * @brief the normals that a mesh is shaded with, at the corners of its triangles
 *
 * As the mapper chooses: the active normals of points, else those of cells, else the triangles' own; those of triangles
 * without area are (0, 0, 0).
 */
#ifndef vtkMTShadingNormals_h
#define vtkMTShadingNormals_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <cstddef>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTShadingNormals
{
public:
  explicit vtkMTShadingNormals(const std::vector<vtkMTArrayInfo>& arrays);

  /// [3 t + c]. The mesh has the columns of the arrays.
  std::vector<std::array<float, 3>> Get(const vtkMTPatch& mesh) const;

private:
  static void GetOfTriangles(const vtkMTPatch& mesh, std::vector<std::array<float, 3>>& normals);

  vtkMTArrayInfo Array;
  bool HasArray = false;
  std::size_t Column = 0; // among those of its association
};

#endif
