// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegularFamily
 * @brief one seed set of the regular partitions, with the nearest seed in closed form
 *
 * The seeds are the cube centres, the face centres or the edge centres of a regular grid. Families are numbered in the
 * fine-going order of BMT section 4.2.1: cube centres, face centres, edge centres of a grid, then cube centres of the
 * grid of half the cell size, and so on; family 0 has the cubes of cell size 1. Cell sizes are powers of two and the
 * grid passes through the origin of the coordinates, so the families of all meshes and levels fit into one another and
 * the cell of a point is found without rounding.
 *
 * With r the place of a point relative to its cube's centre, the nearest face centre is on the axis where |r| is
 * largest (Voronoi regions are octahedra over two cubes), the nearest edge centre is on the edge along the axis where
 * |r| is smallest.
 */
#ifndef vtkMTRegularFamily_h
#define vtkMTRegularFamily_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

class vtkMTRegularFamily
{
public:
  using Point = std::array<double, 3>;

  enum SeedType
  {
    Cubes = 0,
    Faces = 1,
    Edges = 2
  };

  /// A seed. Along the axis named by Axis a face centre is on a grid plane and an edge centre is not; 0 for cubes.
  struct Cell
  {
    std::int64_t I = 0;
    std::int64_t J = 0;
    std::int64_t K = 0;
    int Family = 0;
    int Axis = 0;

    bool operator==(const Cell& other) const
    {
      return this->I == other.I && this->J == other.J && this->K == other.K && this->Family == other.Family &&
        this->Axis == other.Axis;
    }
    bool operator<(const Cell& other) const
    {
      return std::tie(this->Family, this->K, this->J, this->I, this->Axis) <
        std::tie(other.Family, other.K, other.J, other.I, other.Axis);
    }
  };

  struct Hash
  {
    std::size_t operator()(const Cell& cell) const;
  };

  explicit vtkMTRegularFamily(int family = 0);

  int GetFamily() const { return this->Family; }
  SeedType GetType() const { return this->Type; }

  /// The nearest seed of a point. False when the point is not finite or too far away for this cell size.
  bool Locate(const Point& x, Cell& cell) const;

  /// Coordinates of a seed of this family.
  Point GetSeed(const Cell& cell) const;

  static int GetFamilyOf(int exponent, SeedType type) { return -3 * exponent + static_cast<int>(type); }

  /// The largest power of two, as an exponent, that a cell size may have, and the smallest one for coordinates up to
  /// `largest`.
  static constexpr int LargestExponent = 1000;
  static int GetSmallestExponent(double largest);

private:
  int Family;
  SeedType Type;
  double CellSize;
  double CellsPerUnit;
};

#endif
