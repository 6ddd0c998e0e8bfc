// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshMerge
 * @brief merges several meshes into one that says of every cell which mesh it comes from
 *
 * The cells stay in the order in which VTK numbers them (vertices, lines, polygons, strips), within each kind in the
 * order of the meshes. The cell array "PartId" (int, counted from 0 in the order of the meshes) names the mesh of each
 * cell; the builder never stitches triangles of different parts (vtkMTPointWelding), so parts that touch stay apart. An
 * earlier "PartId" of a mesh is kept as "InputPartId".
 *
 * Arrays are united: those of one name, type and number of components become one array. Where a mesh lacks it, its
 * values are NaN for real numbers and 0 for whole ones, or -1 where these are ids that have names; point normals, which
 * would be of no use that way, are made for the meshes that lack them (area-weighted mean of the cells' normals).
 * Normals and texture coordinates in single and in double precision are united in double precision. Any other array
 * whose name is taken by one of another type gets "_2", "_3" ... after its name.
 *
 * Ids keep their values, whose names (annotations of the lookup tables) are united; an id that has several names in the
 * meshes gets all of them, with " | " between.
 *
 * The report counts: "united_arrays_filled" (arrays that some mesh lacks), "renamed_arrays", "made_part_normals"
 * (points), "united_names_differ" (ids), and the arrays that are left out because they hold no numbers
 * ("arrays_of_strings") or not one tuple for each point or cell ("arrays_of_wrong_length"). Field data are left out.
 */
#ifndef vtkMTMeshMerge_h
#define vtkMTMeshMerge_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTMeshMerge
{
public:
  static const char* GetPartIdName() { return "PartId"; }

  /// False, with the reason in error, and an empty output when there is not memory enough.
  static bool Merge(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, vtkPolyData* output,
    std::map<std::string, std::int64_t>& report, std::string& error);
};

#endif
