// SPDX-License-Identifier: BSD-3-Clause
// Clips the ears of a polygon. Not installed.
#ifndef vtkMTEarClipping_h
#define vtkMTEarClipping_h

#include "vtkMTPlaneOrientation.h"
#include "vtkNew.h"
#include "vtkPriorityQueue.h"

#include <array>
#include <cstdint>
#include <vector>

/// A polygon: its corners, of about unit size, and where they are in its plane, where it turns counterclockwise.
struct vtkMTOutline
{
  std::vector<std::array<double, 3>> Places;
  std::array<double, 3> Normal;
  std::vector<vtkMTPlaneOrientation::Point> Points;
};

/**
 * An ear is a corner whose triangle belongs to the polygon and can be clipped off. The best shaped one goes first: that
 * of the least ratio of squared perimeter to area, found and ordered as by vtkPolygon, so that convex polygons, and
 * concave ones with which that succeeds, get its triangles.
 *
 * Unlike vtkPolygon, this takes outlines that touch themselves, or run along themselves as the bridges to holes do. A
 * triangle is an ear when no part of the outline enters its interior. No edge of the polygon crosses the two edges
 * of the corner, so what enters has a corner inside of the triangle, or one on its border from which an edge leads
 * into it. Where other corners lie at the place of the ear's tip, its triangle may be outside of the polygon all the
 * same, between the two ways of a bridge: the winding number decides. Signs are exact (vtkMTPlaneOrientation).
 *
 * Order of the attempts: ears whose new edge touches no corner; ears whose new edge does; corners without an area. When
 * none is left the outline crosses itself.
 */
class vtkMTEarClipping
{
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Clips what can be clipped, triangles being appended. True when nothing is left.
  bool Clip(const vtkMTOutline& outline, std::vector<Triangle>& triangles);

  /// Whether the outline makes one full turn, as those do that do not cross themselves. Spikes do not count.
  bool TurnsOnce() const { return this->Turns == 1; }

  ///@{
  /// What Clip left: corners are clipped although they are no ears, until so many are left, which are given in order.
  void ClipAnyway(std::size_t left, std::vector<Triangle>& triangles);
  std::vector<std::uint32_t> GetLeft() const;
  ///@}

private:
  enum class Rule
  {
    Clear,
    Touching
  };

  void Link();
  void MakeGrid();
  void RemoveSpikes(std::vector<Triangle>& triangles);
  bool IsSpike(std::uint32_t corner) const;
  void CountTurns();
  void FillQueue();
  void Enqueue(std::uint32_t corner);
  bool ClipFlat(std::vector<Triangle>& triangles);
  void Remove(std::uint32_t corner, std::vector<Triangle>& triangles);
  void ClipCorner(std::uint32_t corner, std::vector<Triangle>& triangles);
  double GetMeasure(std::uint32_t corner) const;
  double GetTurn(std::uint32_t corner) const;
  bool IsEar(std::uint32_t corner, Rule rule) const;
  bool BlocksEar(std::uint32_t corner, std::uint32_t ear, Rule rule) const;
  bool IsInside(const vtkMTPlaneOrientation::Point& point) const;
  template <typename Visit>
  bool AnyOfCornersNear(std::uint32_t ear, const Visit& visit) const;

  const vtkMTOutline* Outline = nullptr;
  std::vector<std::uint32_t> Next;
  std::vector<std::uint32_t> Previous;
  std::vector<unsigned char> Alive;
  std::uint32_t Head = 0;
  std::uint32_t Count = 0;
  int Turns = 0;
  vtkNew<vtkPriorityQueue> Queue;

  // The corners by the cells of a grid; none of small polygons.
  std::uint32_t GridSize = 0;
  double GridOrigin[2] = { 0.0, 0.0 };
  double GridScale[2] = { 0.0, 0.0 };
  std::vector<std::uint32_t> CellBegins;
  std::vector<std::uint32_t> CellCorners;
};

#endif
