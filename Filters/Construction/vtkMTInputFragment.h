// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputFragment
 * @brief one region of the input as a fragment of M_0: assembled, with what is needed to finish it
 *
 * A fragment is made in two steps, as its orientation and the normals at its shared points depend on other fragments.
 * Make assembles the region's triangles and points, finds its connected parts and the terms of shared normals. Then
 * triangles are reversed and normals added. In between it is kept as bytes.
 */
#ifndef vtkMTInputFragment_h
#define vtkMTInputFragment_h

#include "vtkMTBytes.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTDihedralAngles.h"
#include "vtkMTInputRegions.h"
#include "vtkMTOrientation.h"
#include "vtkMTPatch.h"
#include "vtkMTSharedNormals.h"

#include <string>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTInputFragment
{
  vtkMTPatch Mesh;
  std::vector<std::uint32_t> Numbers; ///< of the triangles, in the whole input
  vtkMTOrientation::Fragment Orientation;
  std::vector<vtkMTSharedNormals::Term> Terms;
  vtkMTDihedralAngles Angles;              ///< where normals are made; not encoded
  std::vector<std::uint32_t> SharedPlaces; ///< of Make, vtkMTSharedIds::FindPlaces; not encoded
  std::vector<std::uint32_t> Components;   ///< as vtkMTOrientation::Add numbered them

  struct Layout
  {
    std::vector<std::size_t> PointTupleSizes;
    std::vector<std::size_t> CellTupleSizes;
    bool HasCellIds;  ///< whether the mesh gets a column of them behind those of the cells
    bool HasPointIds; ///< likewise behind those of the points: the input's point that stands for the wedge
    bool MakeNormals;
  };

  /// The region's records are given up.
  void Make(std::uint32_t region, vtkMTInputRegions::Region&& records, const Layout& layout);

  ///@{
  /// Mesh, orientation and components, as bytes.
  void Encode(std::vector<unsigned char>& bytes) const;
  bool Decode(const vtkMTBytes::Record& bytes, std::string& error);
  ///@}

  void TurnRound(const vtkMTOrientation& orientation);
  /// One normal per point.
  void AddNormals(const std::vector<std::array<float, 3>>& normals);
  /// One normal per corner (3 t + c): wedges whose corners differ are split.
  void AddNormalsByCorner(const std::vector<std::array<float, 3>>& normals);
};

#endif
