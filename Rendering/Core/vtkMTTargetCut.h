// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTargetCut
 * @brief finds the cut to draw: a pure function of graph, view, settings and what is resident
 *
 * The refinement half of Cignoni et al., "Batched Multi Triangulation" (2005), section 5. Extraction starts at the
 * coarsest cut and keeps the refinements that are wanted in a heap, the largest error first, ties by node index. A
 * refinement that needs coarser nodes refined takes them along (BMT section 3.1), so after every operation the cut is
 * closed and its patches conform. A refinement that does not fit the triangle budget is put aside, smaller ones are
 * tried instead, and what was put aside is tried again whenever the cut has changed; so nothing that is wanted and fits
 * is left undone. Because errors are saturated, the coarser nodes that a refinement waits for are wanted themselves.
 *
 * The error of an arc's patch is the pixel error of the node that it enters, taken over the patch's own box, which is
 * tighter than the node's sphere; that of a node is the largest of the arcs that enter it. An arc whose box, grown by
 * its error, lies outside the frustum asks for nothing: the input surface that it stands for cannot be seen. An arc
 * whose box lies outside is not drawn and does not count against the budget. Several views are served by one cut: the
 * largest error over the views counts, outside is what is outside of all of them, and a patch faces away where it does
 * in all of them. Without a view the error is the node's own, in model units, and every arc counts.
 *
 * Where everything that is wanted fits the budgets and can be drawn, the order does not matter, and the heap is not
 * needed: wanted nodes are taken, with what they depend on, as they are met.
 *
 * Patches that face away, where they are left out (FacingCulling), are refined like those that do not: what they stand
 * for may face the eye where they do not.
 *
 * Extraction can be stopped before any operation: by a TimeLimit, read off a Clock that tests can give. What has been
 * refined until then is a conforming cut within the budgets, the largest errors having been remedied first.
 *
 * The result depends on the arguments alone. The object keeps scratch memory between calls, so use one object per
 * thread.
 */
#ifndef vtkMTTargetCut_h
#define vtkMTTargetCut_h

#include "vtkMTCut.h"
#include "vtkMTRenderingCoreModule.h" // For export macro
#include "vtkMTView.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkMTArcViews;
class vtkMTGraph;

class VTKMTRENDERINGCORE_EXPORT vtkMTTargetCut
{
public:
  enum ErrorMetricType : std::uint8_t
  {
    Distance = 0,   ///< the certified distance to the input: says where the surface is
    EdgeLength = 1, ///< the mean edge length (BMT section 5.1): says how finely it can be shaded
    /// The certified distance, and where it is more, what shading may differ by: the mean edge length L times
    /// sin(a / 2), half the difference of two normals with the angle a, the fragment's certified mean normal deviation;
    /// times ((1 + c) / 2)^2, or 1 / 16 if that is more, c being the cosine between the axis of the patch's normals and
    /// the direction to the eye, as a patch that is turned away covers few pixels. Normals count only where L is more
    /// than a pixel. Where the model does not have the measure, a is a straight angle. Without a view, distance and L
    /// sin(a / 2) count.
    NormalDeviation = 2,
    /// The certified distance, and where the certified deviation of an array's values (ValueArray) is above ValueError,
    /// the mean edge length, if that is more: what deviates by more is refined until its edges are no longer than the
    /// threshold, so what is too small to be seen is never refined for its values. Where the model does not have the
    /// measure, every deviation is above.
    Value = 3
  };

  struct Settings
  {
    /// With a view, pixels: what is above is refined. Default 1; negative refines everything that can be seen.
    double PixelError = 1.0;
    /// Without a view, model units: what is above is refined. Default 0; negative refines everything.
    double ModelError = 0.0;
    /// Triangles drawn at most; 0, the default, is no limit. Where the coarsest cut has more, it is drawn all the same
    /// and the result is not WithinLimits.
    std::uint64_t TriangleLimit = 0;
    /// Bytes on the GPU of the patches drawn at most, a patch counting BytesPerVertex for each wedge and
    /// BytesPerTriangle for each triangle; 0, the default, is no limit. The coarsest cut is an exception as above.
    std::uint64_t ByteLimit = 0;
    std::uint32_t BytesPerVertex = 12;
    std::uint32_t BytesPerTriangle = 12;
    /// Seconds from the beginning of the call after which no further operation is begun; 0, the default, is no limit.
    double TimeLimit = 0.0;
    /// Gives seconds, from any origin on; none: a steady clock.
    std::function<double()> Clock;
    ErrorMetricType ErrorMetric = Distance;
    /// For the metric Value: the array's name, default none, and the largest deviation of its values that is allowed,
    /// in the array's units, default 0.
    std::string ValueArray;
    double ValueError = 0.0;
    /// Whether patches outside the frustum are left out. Refinement follows the frustum in either case. Default on.
    bool FrustumCulling = true;
    /// Whether patches all of whose triangles are seen from behind are left out, by their normal cones. Default off:
    /// right only where the back of a triangle is not drawn.
    bool FacingCulling = false;
  };

  /// What extraction works on.
  struct Input
  {
    const vtkMTGraph* Graph = nullptr;
    /// One to a few views that the cut serves at once, the two eyes of a stereo picture for example: an arc's error is
    /// the largest over the views, and it is left out where none of them shows it. None: errors in model units, nothing
    /// is culled.
    std::vector<vtkMTView> Views;
    /// One entry per arc, 0 where the patch cannot be drawn now; none: all can. The coarsest patches are always drawn.
    const std::vector<unsigned char>* Resident = nullptr;
  };

  /// A patch that is not resident and is wanted.
  struct Request
  {
    std::uint32_t Arc = 0;
    double Error = 0.0; ///< what refining would remedy, in the units of the threshold
  };

  struct Result
  {
    explicit Result(const vtkMTGraph& graph)
      : Cut(graph)
    {
    }

    vtkMTCut Cut;
    std::vector<std::uint32_t> RefinedNodes; ///< of Cut, ascending; the source is the first one
    std::vector<std::uint32_t> Arcs;         ///< to draw, ascending
    std::uint64_t Triangles = 0;             ///< of Arcs
    std::uint64_t Bytes = 0;                 ///< of Arcs on the GPU
    /// With a view: upper bound, in pixels, of how far anything in the picture is from where the input would put it; it
    /// is the certified distance whatever ErrorMetric says, and infinite where the camera is inside a patch's error.
    double PixelError = 0.0;
    double ModelError = 0.0; ///< the cut's largest certified distance to the input, model units
    bool Converged = true;   ///< nothing that can be seen is above the threshold
    bool WithinLimits = true;
    bool Complete = true; ///< not stopped by the TimeLimit

    std::size_t NodesRefined = 0;
    std::size_t ArcsInCut = 0;
    std::size_t ArcsCulled = 0;     ///< by the frustum
    std::size_t ArcsFacingAway = 0; ///< of the others, left out for that
    std::uint64_t TrianglesCulled = 0;
    std::uint64_t TrianglesFacingAway = 0;
    std::size_t Operations = 0;    ///< refinements tried, where their order matters
    std::size_t Postponed = 0;     ///< refinements wanted that did not fit or were not resident
    std::vector<Request> Requests; ///< the largest error first
  };

  vtkMTTargetCut();
  ~vtkMTTargetCut();
  vtkMTTargetCut(const vtkMTTargetCut&) = delete;
  vtkMTTargetCut& operator=(const vtkMTTargetCut&) = delete;

  Result Extract(const Input& input, const Settings& settings);

  /**
   * The arcs of a given cut that are to be drawn in a view, with their figures, as Extract gives them: for a cut that
   * is kept while the camera moves.
   */
  Result View(const vtkMTCut& cut, const Input& input, const Settings& settings);

  ///@{
  /**
   * Cuts without a view. ByTriangles gives the most precise cut of at most `triangles` triangles; where that is 50 mean
   * patches or more, at least 90 % of them are used unless the finest level has fewer. False, with a message, where
   * the coarsest cut has more. ByError gives the coarsest cut whose certified distance to the input is at most `error`
   * in model units; false where the finest level does not reach it. ByLevel gives one level, 0 being the finest; false
   * where there is no such level.
   */
  bool ByTriangles(const vtkMTGraph& graph, std::uint64_t triangles, vtkMTCut& cut, std::string& message);
  bool ByError(const vtkMTGraph& graph, double error, vtkMTCut& cut, std::string& message);
  static bool ByLevel(const vtkMTGraph& graph, std::uint32_t level, vtkMTCut& cut, std::string& message);
  ///@}

  ///@{
  /// Of one arc's patch in a view: its bound in pixels, by a metric or by that of the settings, and whether any of it
  /// can be seen.
  static double GetPixelError(
    const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc, ErrorMetricType choice);
  static double GetPixelError(
    const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc, const Settings& settings);
  static bool IsVisible(const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc);
  ///@}

private:
  friend class vtkMTCutFollower;
  class Worker;
  struct Scratch;
  vtkMTArcViews& GetViews();
  std::unique_ptr<Scratch> Memory;
};

#endif
