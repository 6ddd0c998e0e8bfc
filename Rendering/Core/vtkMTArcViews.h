// SPDX-License-Identifier: BSD-3-Clause
// What the views of a cut say about arcs, taken together: looked up once a frame for each arc that is asked for.
// Not installed.
#ifndef vtkMTArcViews_h
#define vtkMTArcViews_h

#include "vtkMTArcProjector.h"
#include "vtkMTGraph.h"
#include "vtkMTTargetCut.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

class vtkMTArcViews
{
public:
  static constexpr double NotWanted = -std::numeric_limits<double>::infinity();

  struct ArcView
  {
    bool Outside = false;      // of all frusta, and left out for that
    bool FacesAway = false;    // in all views, and left out for that
    std::uint32_t Frame = 0;   // in which it was looked up last
    double Wanted = NotWanted; // the error that refining the arc's node would remedy
    double Certified = 0.0;    // pixels

    bool IsDrawn() const { return !this->Outside && !this->FacesAway; }
  };

  // Begins a frame: forgets what was looked up. The graph must live until the next call.
  void Begin(const vtkMTGraph& graph, const std::vector<vtkMTView>& views, const vtkMTTargetCut::Settings& settings);

  const ArcView& Look(std::uint32_t arc)
  {
    ArcView& view = this->Views[arc];
    if (view.Frame != this->Frame)
    {
      this->Make(arc, view);
    }
    return view;
  }
  // The largest Wanted of the arcs that enter the node.
  double GetWanted(std::uint32_t node);
  // Bytes of a patch on the GPU.
  std::uint64_t GetBytes(const vtkMTArc& arc) const
  {
    return std::uint64_t(arc.Wedges) * this->Options.BytesPerVertex +
      std::uint64_t(arc.Triangles) * this->Options.BytesPerTriangle;
  }
  // Whether what is drawn is within the budgets.
  bool Fits(std::uint64_t triangles, std::uint64_t bytes) const;
  // Whether the patch is outside of a frustum by no more than its own size.
  bool IsNearby(std::uint32_t arc) const;

  // The arcs of the result's cut that are drawn, and their figures; its refined nodes must be there.
  void Report(vtkMTTargetCut::Result& result);

  double GetThreshold() const { return this->Threshold; }

private:
  struct Facing
  {
    std::array<double, 3> Viewer; // perspective: the eye; parallel: the direction it looks in; model coordinates
    bool Parallel;
    double Sign; // -1 where the model is drawn mirrored
  };
  struct Eye
  {
    vtkMTArcProjector Projector;
    std::optional<Facing> Side;   // none: nothing is left out for facing away
    std::optional<Facing> Toward; // of the metric; none: all counts as if it faced the eye
  };

  void Make(std::uint32_t arc, ArcView& view) const;
  // What counts in place of the certified distance, where it is more; model units.
  double GetShadingLength(std::uint32_t node) const;
  double GetWanted(const vtkMTArc& arc, const Eye& eye, const vtkMTArcProjector::Depth& depth, double certified) const;
  double GetFacingShare(const vtkMTArc& arc, const Facing& side) const;

  const vtkMTGraph* Graph = nullptr;
  const vtkMTMeasure* Deviations = nullptr; // of normals or values, as the metric says; none: not known
  std::vector<Eye> Eyes;
  vtkMTTargetCut::Settings Options;
  double Threshold = 0.0;

  std::vector<ArcView> Views; // per arc; those of earlier frames are told by their number
  std::uint32_t Frame = 0;

  static std::optional<Facing> FindFacing(const vtkMTView& view);
  bool FacesAway(const vtkMTArc& arc, const Facing& side) const;
};

#endif
