// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputBlock
 * @brief a run of the input's triangles with the points that they use, each once
 *
 * The input goes through the construction in blocks of Size triangles, in its own order. Triangles index the
 * block's own points by their place in Points.
 */
#ifndef vtkMTInputBlock_h
#define vtkMTInputBlock_h

#include "vtkMTArrayInfo.h"
#include "vtkMTBytes.h"
#include "vtkMTConstructionModule.h" // For export macro

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTInputBlock
{
  static constexpr std::size_t Size = 65536;
  using Place = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<std::uint32_t> Points; ///< the input's indices, in increasing order
  std::vector<Place> Places;         ///< of the points, once they are known; model units
  std::vector<unsigned char> IsOpen; ///< whether other blocks use the point as well
  std::vector<Triangle> Triangles;   ///< indices into Points
  std::vector<std::int64_t> CellIds; ///< the input's cell of each triangle
  std::vector<vtkMTColumn> Columns;  ///< the input's cell arrays

  /// Fills Points from Triangles that hold the input's indices, and makes these the block's own.
  void FindPoints();

  /// Whether triangles use the points, after some were dropped.
  std::vector<unsigned char> GetUsed() const;

  /// Why a triangle cannot be part of a surface, for the report: "dropped_not_finite", "dropped_degenerate"; null: it
  /// can.
  const char* FindFault(const Triangle& triangle) const;

  /// Drops the other triangles.
  void Keep(const std::function<bool(const Triangle&)>& isKept);

  void Encode(std::vector<unsigned char>& bytes) const;
  bool Decode(const vtkMTBytes::Record& bytes, std::string& error);
};

#endif
