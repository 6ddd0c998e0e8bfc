// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCutMesh
 * @brief patches as one welded polydata, read one after the other
 *
 * The order of points and cells is that of the arcs, so it depends on nothing else. Arrays that only the finest level
 * has (vtkMTArrayInfo::IsFinestOnly), such as the input's ids, are complete where all arcs are of that level; elsewhere
 * they are -1 for triangles of coarser patches, and for their points, but not for those that they share with a patch of
 * the finest level.
 */
#ifndef vtkMTCutMesh_h
#define vtkMTCutMesh_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkMTGraph;
class vtkMTPatchSource;
class vtkPolyData;
struct vtkMTPatch;
struct vtkMTPlacement;

struct VTKMTCORE_EXPORT vtkMTCutMesh
{
  std::vector<std::uint32_t> Arcs;
  const std::vector<unsigned char>* Arrays = nullptr; ///< one entry per array of the graph, 0 leaves it out; none: all
  const vtkMTPlacement* Placement = nullptr;          ///< where the mesh is to stand; none: where the patches do
  /// Whether the mesh has two arrays of cells more, DistanceToInputName and DistanceFromInputName: what is certified of
  /// the patch that a triangle is of (vtkMTGraph::GetDistanceToInput), where the mesh stands.
  bool GenerateDistances = false;
  std::function<bool(double)> Progress; ///< takes a fraction; false stops

  static constexpr const char* DistanceToInputName = "DistanceToInput";
  static constexpr const char* DistanceFromInputName = "DistanceFromInput";

  /**
   * False, with the reason in error, when a patch cannot be read; error is empty where Progress stopped it.
   * wedgePoints, when given, gets for each point of the polydata (a wedge) the point that it is of: those with the same
   * value are the same place and differ in attribute values.
   */
  bool Make(const vtkMTPatchSource& source, vtkPolyData* output, std::string& error,
    std::vector<std::uint32_t>* wedgePoints = nullptr) const;

private:
  void AddUnknown(const vtkMTGraph& graph, vtkMTPatch& mesh) const;
  void AddDistances(const vtkMTGraph& graph, vtkPolyData* output) const;
};

#endif
