// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtSurface.h
 * @brief a triangle surface as the independent checker sees it, and the frame in which distances are measured
 *
 * The checker of `bmt verify` and `bmt compare` shares no code with the builder: it has its own surface, sampling and
 * closest point search. What it does share is the definition of the input: polygons and strips are taken apart by
 * vtkMTPolyDataStream, because a bent polygon is no surface before somebody says where its diagonals run.
 */
#ifndef bmtSurface_h
#define bmtSurface_h

#include <array>
#include <cstdint>
#include <string>
#include <vector>

using bmtPoint = std::array<double, 3>;
using bmtTriangle = std::array<std::uint32_t, 3>;

struct bmtBounds
{
  bmtPoint Minimum;
  bmtPoint Maximum;

  bmtBounds(); ///< empty
  void Add(const bmtPoint& x);
  void Add(const bmtBounds& other);
  bool IsEmpty() const { return this->Minimum[0] > this->Maximum[0]; }
  double GetDiagonal() const;
};

/**
 * Distances are taken in coordinates relative to the centre of a common box, scaled by a power of two so that the box
 * is about of size 1: far from the origin no digits are lost to the offset, and tiny or huge scenes neither underflow
 * nor overflow when squared.
 */
struct bmtFrame
{
  bmtPoint Center{ 0.0, 0.0, 0.0 };
  double Scale = 1.0; ///< local = (model - Center) * Scale; a power of two

  static bmtFrame FromBounds(const bmtBounds& bounds);
  bmtPoint ToLocal(const bmtPoint& x) const;
  double ToModel(double localDistance) const { return localDistance / this->Scale; }
  bmtPoint ToModelPoint(const bmtPoint& local) const;
  /**
   * Allowance for the rounding of coordinates in double precision, in local units: 1e-12 of the largest coordinate,
   * which is at most 1 here. No other tolerance is used anywhere.
   */
  static constexpr double Tolerance = 1e-12;
};

struct bmtSurface
{
  std::vector<bmtPoint> Points;
  std::vector<bmtTriangle> Triangles;
  std::int64_t NonFinite = 0;   ///< triangles left out because a corner is NaN or infinite
  std::int64_t OutOfRange = 0;  ///< triangles left out because an index is
  std::int64_t FarOutliers = 0; ///< triangles left out because the model says that it lacks what is so far away
  std::int64_t Degenerate = 0;  ///< triangles left out because two corners are at one place: no surface

  bmtBounds GetBounds() const;
  void Transform(const bmtFrame& frame);
  /// The points that triangles use, each once, in order.
  std::vector<bmtPoint> GetUsedPoints() const;
  double GetArea(std::size_t triangle) const;
};

struct bmtInput;
class vtkMTTriangleStream;

/// The stream's triangles, without those that are no surface; name is for messages. Throws bmtError.
bmtSurface bmtMakeSurface(vtkMTTriangleStream& stream, const std::string& name);

/// Reads what the command line names, as one surface. Throws bmtError.
bmtSurface bmtReadSurface(const bmtInput& input);

#endif
