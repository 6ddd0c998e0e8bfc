// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputMesh
 * @brief makes mesh M_0 of a triangle stream: checked, snapped to the lattice, stitched, with wedges, in fragments
 *
 * Triangles that cannot be part of a surface are dropped and counted: with an index out of range
 * ("dropped_index_out_of_range"), a coordinate that is not finite ("dropped_not_finite") or two corners at one place
 * ("dropped_degenerate"), and the few that lie so far away that they would coarsen the lattice for all others
 * ("dropped_far_outlier", vtkMTFarOutliers). Every other triangle is kept, whatever its shape or its neighbours. Points
 * that no kept triangle uses are left out ("isolated_points"). Points that are stitched (vtkMTPointWelding) become one
 * point with one wedge per different set of attribute values. Triangles whose cell array "PartId" (one int) differs are
 * of different parts, which are never stitched to each other. Parts with mixed windings are oriented as most of their
 * triangles are
 * ("reoriented_triangles", vtkMTOrientation); parts that cannot be stay as they are ("not_orientable_triangles").
 *
 * The stream is read once. All that grows with the mesh is in spools and external sorts; one block of the input, or one
 * region, is in memory at a time. Where spools lie in memory, blocks are kept there, and what would be sorted is looked
 * up (vtkMTInputSpool, vtkMTInputRegions). The result does not depend on that, nor on the memory that sorts are given.
 */
#ifndef vtkMTInputMesh_h
#define vtkMTInputMesh_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro

#include <memory>
#include <string>

class vtkMTSequenceState;
class vtkMTTriangleStream;

class VTKMTCONSTRUCTION_EXPORT vtkMTInputMesh
{
public:
  explicit vtkMTInputMesh(const vtkMTBuildSettings& settings);
  ~vtkMTInputMesh();

  /// Fills a state that has just been made. False with a message in GetError; an input without a usable triangle is an
  /// error, and so is one with more than a few far outliers unless they are to be kept.
  bool Read(vtkMTTriangleStream& stream, vtkMTSequenceState& state);

  const std::string& GetError() const;
  /// What a person should know of the input; empty as a rule.
  const std::string& GetWarning() const;
  bool WasAborted() const;

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
