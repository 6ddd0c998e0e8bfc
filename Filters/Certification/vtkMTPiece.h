// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPiece
 * @brief a convex polygon inside one triangle
 *
 * Splitting by a plane or a chord adds at most one corner to either part.
 */
#ifndef vtkMTPiece_h
#define vtkMTPiece_h

#include "vtkMTVector.h"

#include <algorithm>
#include <array>
#include <cstdint>

class vtkMTPiece
{
public:
  using Vector = vtkMTVector::Vector;
  static constexpr int Capacity = 16;

  std::array<Vector, Capacity> Corners;
  int Count = 0;
  int Depth = 0; ///< splits that it comes from
  std::uint32_t Triangle = 0;

  ///@{
  /// Copies have the corners that there are.
  vtkMTPiece() = default;
  vtkMTPiece(const vtkMTPiece& other) { *this = other; }
  vtkMTPiece& operator=(const vtkMTPiece& other)
  {
    this->Count = other.Count;
    this->Depth = other.Depth;
    this->Triangle = other.Triangle;
    std::copy_n(other.Corners.begin(), other.Count, this->Corners.begin());
    return *this;
  }
  ///@}

  void Append(const Vector& x) { this->Corners[this->Count++] = x; }
  Vector GetMiddle() const;
  /// Of a ball around the middle that holds the piece.
  double GetRadius() const;

  /// The two corners that are farthest from each other, and how far.
  struct Diagonal
  {
    int From = 0;
    int To = 0;
    double Length2 = 0.0;
  };
  Diagonal GetDiagonal() const;

  /// Splits by the plane through `on` with normal `normal` into what lies on the normal's side and the rest. False when
  /// the plane leaves the piece whole, but for slivers thinner than `thin` (then only one of the two has corners), or
  /// when rounding has made it too crooked for two parts with room for their corners.
  bool Split(const Vector& on, const Vector& normal, double thin, vtkMTPiece& inside, vtkMTPiece& outside) const;

  /// Across the longest side or diagonal.
  bool Halve(double thin, vtkMTPiece& one, vtkMTPiece& other) const;

  /// Some of the corners, one after the other around the piece, and a place on the side before and on that after them.
  struct Chord
  {
    int First;
    int Count; ///< fewer than the piece has
    Vector Before;
    Vector After;
  };
  /// Splits off the corners of a chord. False without room for the corners of the rest.
  bool SplitOff(const Chord& chord, vtkMTPiece& part, vtkMTPiece& rest) const;

private:
  vtkMTPiece MakePart() const;
};

#endif
