// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputMesh
 * @brief the builder's input, whole in memory: checked, snapped to the lattice, stitched, with wedges
 *
 * Triangles that cannot be part of a surface are dropped and counted: with an index out of range
 * ("dropped_index_out_of_range"), a coordinate that is not finite ("dropped_not_finite") or two corners at one place
 * ("dropped_degenerate"), and the few that lie so far away that they would coarsen the lattice for all others
 * ("dropped_far_outlier", vtkMTFarOutliers). Every other triangle is kept, whatever its shape or its neighbours. Points
 * that no kept triangle uses are left out ("isolated_points"). Points that are stitched (vtkMTStitch) become one point
 * with one wedge per different set of attribute values. Triangles whose cell array "PartId" (one int) differs are of
 * different parts, which are never stitched to each other. Parts with mixed windings are oriented as most of their
 * triangles are
 * ("reoriented_triangles", vtkMTOrientation); parts that cannot be stay as they are ("not_orientable_triangles").
 */
#ifndef vtkMTInputMesh_h
#define vtkMTInputMesh_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkMTTriangleStream;

struct VTKMTCONSTRUCTION_EXPORT vtkMTInputMesh
{
  vtkMTLattice Lattice;
  vtkMTPatch Mesh;                    ///< without ids: a point's identity is its index
  std::vector<vtkMTArrayInfo> Arrays; ///< the stream's, then the input cell ids, then the made normals, if any
  std::uint64_t InputTriangles = 0;
  std::map<std::string, std::int64_t> Report;
  std::string Warning; ///< what a person should know of the input; empty as a rule

  /// False with a message in error; an input without a usable triangle is an error, and so is one with more than a few
  /// far outliers unless they are to be kept.
  bool Read(
    vtkMTTriangleStream& stream, int latticeBits, bool makeNormals, std::string& error, bool keepFarOutliers = false);
};

#endif
