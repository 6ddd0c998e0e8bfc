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

  /// Whether all places are finite.
  bool IsFinite() const;
  /// Whether two of its corners are at one place.
  bool IsDegenerate(const Triangle& triangle) const
  {
    const Place& a = this->Places[triangle[0]];
    const Place& b = this->Places[triangle[1]];
    const Place& c = this->Places[triangle[2]];
    return (a[0] == b[0] && a == b) || (b[0] == c[0] && b == c) || (c[0] == a[0] && c == a);
  }

  /// Drops the other triangles.
  template <typename Test>
  void Keep(Test&& isKept)
  {
    std::size_t kept = 0;
    while (kept < this->Triangles.size() && isKept(this->Triangles[kept]))
    {
      ++kept;
    }
    const std::size_t count = this->Triangles.size();
    for (std::size_t t = kept + 1; t < count; ++t)
    {
      if (isKept(this->Triangles[t]))
      {
        this->Move(t, kept++);
      }
    }
    this->Shrink(kept);
  }

  /// Bytes of all lists.
  std::size_t GetMemorySize() const;

  void Encode(std::vector<unsigned char>& bytes) const;
  bool Decode(const vtkMTBytes::Record& bytes, std::string& error);

private:
  void Move(std::size_t from, std::size_t to);
  void Shrink(std::size_t triangles);
};

#endif
