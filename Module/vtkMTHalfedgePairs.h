// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTHalfedgePairs
 * @brief which triangles of any mesh are neighbours across an edge
 *
 * Half-edge h = 3 t + e runs from corner e of triangle t to the next one. Two half-edges are partners when they are the
 * only two between their points, whichever way they run. They are opposite when they run in opposite directions
 * besides, and are not of two triangles with the same three points. Found in one pass in linear time: half-edges are
 * chained by the lower of their points. Meshes whose chains are long, as those of hubs are, have them sorted instead.
 *
 * What knows the partners of a mesh hands them on as an object, so that they are found once.
 */
#ifndef vtkMTHalfedgePairs_h
#define vtkMTHalfedgePairs_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTHalfedgePairs
{
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  ///@{
  /// In place of a partner, where there are more than two: the one that stands for an odd number of them; any other.
  static constexpr std::uint32_t Odd = None - 1;
  static constexpr std::uint32_t Other = None - 2;
  ///@}

  static std::uint32_t Next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t Previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// corners: the point of each corner, three for each triangle. Gives the opposite of each half-edge, None where it
  /// has none.
  static std::vector<std::uint32_t> Find(const std::vector<std::uint32_t>& corners);
  /// The same of points below a number.
  static std::vector<std::uint32_t> Find(const std::vector<std::uint32_t>& corners, std::size_t points);

  explicit vtkMTHalfedgePairs(const vtkMTPatch& mesh);
  /// Of triangles of so many points, as corners.
  vtkMTHalfedgePairs(const std::vector<vtkMTTriangle>& triangles, std::size_t points);

  std::vector<std::uint32_t> Corners;  ///< the mesh's point of each corner
  std::vector<std::uint32_t> Partners; ///< of each half-edge; None, Odd or Other where it has none

  bool HasPartner(std::uint32_t h) const { return this->Partners[h] < Other; }
  /// Of two partners.
  bool AreOpposite(std::uint32_t g, std::uint32_t h) const
  {
    // Of triangles with two points in common: their third ones differ as the sums of all three do.
    const std::uint32_t* s = this->Corners.data() + g / 3 * 3;
    const std::uint32_t* t = this->Corners.data() + h / 3 * 3;
    return this->Corners[g] != this->Corners[h] && s[0] + s[1] + s[2] != t[0] + t[1] + t[2];
  }
};

#endif
