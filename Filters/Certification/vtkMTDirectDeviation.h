// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDirectDeviation
 * @brief bounds by a mesh several levels below, for the triangles of a fragment whose sums over the steps are loose
 *
 * Sums over levels (vtkMTDeviation) always hold, but the largest deviations of several steps do not add up in truth.
 * Here those triangles of a fragment whose sums decide, as they are the largest, are held against a mesh that lies more
 * than one level below: the finer mesh, whose own deviations are added. What is smaller than the sum takes its place.
 *
 * From the fragment to the input: every place of the finer mesh is within its triangle's ToInput of the input, so any
 * part of the finer mesh will do, and a triangle t is bounded by pieces (vtkMTPieceBound) against what lies nearby.
 *
 * From the input to the fragment: a point p of the input that has come to stand on t is within t's FromInput of it; on
 * the finer mesh it stands on a triangle s, within that one's FromInput. So s is within the sum of both of t: all finer
 * triangles that are so near are the *candidates* of t, a superset of those whose points stand on t. Each of them is
 * bounded against the fragment, its pieces against single triangles, and where all candidates of t are nearer than what
 * t has, the points of t are handed on to those triangles: p is then within s's FromInput and the piece's bound of one
 * of them. It remains in the fragment, so every cut holds exactly one of the triangles that have p. What belongs to the
 * region next door is left out: p stands on a triangle f of the floor too, within f's FromInput of it, so a piece of s
 * that is farther from every f of the floor than the sum of both holds nothing of this region.
 *
 * Only the largest sums are looked at: those above so many times the largest deviation that is known to be true, which
 * is found first, by the few triangles of the largest sums. A mesh one level farther below has twice the triangles; so
 * where it is more than NearLevels below, sums may be LoosenessFarBelow times as large and stay, but on coarse levels,
 * from CoarseLevel on, which have a few regions only. And a mesh farther below is asked only for the triangles that a
 * trial by the mesh NearLevels below leaves, whose own deviations are small already.
 */
#ifndef vtkMTDirectDeviation_h
#define vtkMTDirectDeviation_h

#include "vtkMTBoxRuns.h"
#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTDeviation.h"
#include "vtkMTSurface.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTDirectDeviation
{
public:
  ///@{
  /// How far above the largest true deviation a sum of a fragment of a level may be and stay.
  static constexpr double Looseness = 1.25;
  static constexpr double LoosenessFarBelow = 1.4;
  static constexpr double LoosenessOfCoarse = 1.1;
  static constexpr std::size_t NearLevels = 3;
  static constexpr std::size_t CoarseLevel = 6;
  static double GetLooseness(std::size_t level, std::size_t levelsBelow)
  {
    return levelsBelow <= NearLevels ? Looseness : level < CoarseLevel ? LoosenessFarBelow : LoosenessOfCoarse;
  }
  ///@}
  /// Triangles of the finer mesh per triangle of the floor that are in memory at a time, at most: where it would be
  /// more, the fragment is worked on part by part. A floor counts as of this size at least: near the top they are
  /// smaller, and sums so large that all is near.
  static constexpr std::size_t MostPerTriangle = 4;
  static constexpr std::size_t LeastFloor = 4096;

  using Deviations = std::vector<vtkMTTriangleDeviation>;

  /// A surface and what is known of its triangles.
  struct Mesh
  {
    const vtkMTSurface& Surface;
    const Deviations& Known;
  };

  /// Some triangles of a fragment, from first to end.
  struct Range
  {
    std::uint32_t First;
    std::uint32_t End;
  };
  /// Those of a range of which more than least is known, and how far around them is near: that.
  class Neighbourhood
  {
  public:
    Neighbourhood(const Mesh& fragment, const Range& range, double least);

    /// Whether a ball (relative to the surface's origin) is near one of them. By one thread at a time.
    bool Touches(const vtkMTBoxRuns::Ball& ball) const;

  private:
    const Mesh Fragment;
    std::vector<std::uint32_t> Triangles;
    mutable std::uint32_t Last = 0;    // the one that was near before, which may be near again
    std::optional<vtkMTBoxRuns> Boxes; // of these, and what is near
  };

  /// A part of a finer mesh.
  struct FinerPart
  {
    vtkMTPatch Mesh;
    Deviations Known;     ///< [its triangles]
    std::size_t Most = 0; ///< given: triangles at most; with more the part is of no use and may be incomplete
  };
  /// Gives that part of the mesh some levels below the fragment (1: the floor's) which touches a neighbourhood: every
  /// triangle whose ball, its own FromInput wider, does. False on failure, with a message in error.
  using Collect =
    std::function<bool(const Neighbourhood& near, std::size_t levelsBelow, FinerPart& part, std::string& error)>;

  /// Which mesh a fragment is held against, and how well.
  struct Aim
  {
    std::size_t LevelsBelow; ///< 2 or more
    double Looseness;        ///< above 1
    std::size_t LeastFloor = vtkMTDirectDeviation::LeastFloor;
  };
  /// Lowers what is known of the fragment's triangles. Surfaces are relative to origin, in steps. False on failure,
  /// with a message in error.
  static bool Improve(const Mesh& floor, const vtkMTSurface& fragment, const vtkMTPoint& origin, const Aim& aim,
    const Collect& collect, Deviations& deviations, std::string& error);

  /// A ball around a triangle, and so much wider.
  static vtkMTBoxRuns::Ball GetBall(
    const vtkMTSurface::Vector& a, const vtkMTSurface::Vector& b, const vtkMTSurface::Vector& c, double wider);
};

#endif
