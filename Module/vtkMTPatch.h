// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatch
 * @brief an indexed triangle mesh on the lattice: a patch, or a floor or a fragment assembled from patches
 *
 * Three kinds of index meet here. A *point* is a place on the lattice with an identity. A *wedge* is a point together
 * with one set of attribute values: where a seam runs through a point (texture coordinates, hard edges), that point has
 * several wedges. A triangle has three wedges. Geometry and conformity refer to points, attributes to wedges.
 *
 * Identity: two patches of one cut share a point when both hold the same id, and then both hold the same integers. Only
 * the first Ids.size() points can be shared with other patches; all later points belong to this patch alone. (While a
 * Multi-Triangulation is built, every point has an id.)
 *
 * Shapes: Points [n], Ids [s <= n], WedgePoints [w] (empty when wedge i is point i, so w = n), Triangles [t] of wedge
 * indices, PointColumns [arrays of association Point] of w tuples, CellColumns [arrays of association Cell] of t
 * tuples, in the order of the graph's Arrays.
 */
#ifndef vtkMTPatch_h
#define vtkMTPatch_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTLattice.h"

#include <array>
#include <cstdint>
#include <vector>

/// What a patch describes the surface, or the space, with. Everything but codec, painter and validation is the same for
/// all kinds. Triangles are the only kind that is made today.
enum class vtkMTPatchKind : std::uint8_t
{
  Triangles = 0,
  Points = 1,
  Voxels = 2, ///< points with a size
  Grid = 3    ///< samples whose places follow from a corner and a size
};

using vtkMTTriangle = std::array<std::uint32_t, 3>;

struct VTKMTCORE_EXPORT vtkMTPatch
{
  vtkMTPatchKind Kind = vtkMTPatchKind::Triangles;
  std::vector<vtkMTPoint> Points;
  std::vector<std::uint64_t> Ids;
  std::vector<std::uint32_t> WedgePoints;
  std::vector<vtkMTTriangle> Triangles;
  std::vector<vtkMTColumn> PointColumns;
  std::vector<vtkMTColumn> CellColumns;

  std::size_t GetNumberOfWedges() const
  {
    const std::size_t wedges = this->WedgePoints.size();
    return wedges > 0 ? wedges : this->Points.size();
  }
  std::uint32_t GetPointOfWedge(std::uint32_t wedge) const
  {
    return this->WedgePoints.empty() ? wedge : this->WedgePoints[wedge];
  }
  /// The triangle's three point indices.
  vtkMTTriangle GetPointsOfTriangle(std::size_t triangle) const
  {
    const vtkMTTriangle& t = this->Triangles[triangle];
    return { this->GetPointOfWedge(t[0]), this->GetPointOfWedge(t[1]), this->GetPointOfWedge(t[2]) };
  }
  /// Of the points that triangles use; xmin > xmax when there are none.
  vtkMTBox GetBox() const;
  /// Mean length of the triangles' edges, in steps; an edge of two triangles counts twice.
  double GetMeanEdgeLength() const;
  /// Bytes held, capacity not counted.
  std::size_t GetMemorySize() const;
  /// What vtkMTArrayInfo::GetRanges gives for the columns of these arrays, one array after the other.
  std::vector<vtkMTRange> GetRanges(const std::vector<vtkMTArrayInfo>& arrays) const;
};

#endif
