// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchAttributes
 * @brief a patch's data as the GPU wants it
 *
 * Every function gives tightly packed values: per wedge for vertex data, per triangle for the rest. What every patch
 * needs is written as bytes at once: patches come by the hundred while a user moves.
 */
#ifndef vtkMTPatchAttributes_h
#define vtkMTPatchAttributes_h

#include "vtkMTArrayInfo.h"
#include "vtkMTPatch.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMTGraph;
struct vtkMTPackedVertices;
class vtkUnsignedCharArray;

struct vtkMTPatchAttributes
{
  ///@{
  /// The index in the graph's Arrays of an array by name, or of the one that is the active attribute; -1 when there is
  /// none.
  static int FindArray(const vtkMTGraph& graph, const std::string& name, vtkMTArrayInfo::AssociationType association);
  static int FindAttribute(const vtkMTGraph& graph, int attribute, vtkMTArrayInfo::AssociationType association);
  static int FindRole(const vtkMTGraph& graph, vtkMTArrayInfo::RoleType role);
  ///@}

  /// The patch's column of the array.
  static const vtkMTColumn& GetColumn(const vtkMTGraph& graph, int array, const vtkMTPatch& patch);
  /// The column as a VTK array that shares its memory, so it must not outlive the patch; unknown values where only
  /// patches of the finest level have any, and this is none.
  static vtkSmartPointer<vtkDataArray> GetArray(const vtkMTGraph& graph, int array, const vtkMTPatch& patch);

  /// Lattice integers of 32 bits, three per wedge.
  static std::vector<unsigned char> GetPositions(const vtkMTPatch& patch);
  /// Three words per wedge, positions and normals of an array of three floats or anything else; none where they cannot
  /// be packed.
  static std::vector<unsigned char> GetPackedVertices(
    const vtkMTPackedVertices& packing, vtkDataArray* normals, const vtkMTPatch& patch);
  /// Three indices for each triangle, or two for each of its edges. Index: std::uint16_t or std::uint32_t.
  template <typename Index>
  static std::vector<unsigned char> GetIndices(const vtkMTPatch& patch, bool edges);
  /// The array's values with `components` components each, missing ones 0; component -1 starts at the first one.
  static std::vector<float> GetFloats(vtkDataArray* array, int components, int component = -1);
  /// Four bytes per tuple, each tuple `times` times.
  static std::vector<unsigned char> GetColors(vtkUnsignedCharArray* colors, int times);
  static std::vector<float> Repeat(const std::vector<float>& values, int components, int times);
};

#endif
