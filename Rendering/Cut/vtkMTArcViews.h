// SPDX-License-Identifier: BSD-3-Clause
// What a view says about arcs: looked up once a frame for each arc that somebody asks for. Not installed.
#ifndef vtkMTArcViews_h
#define vtkMTArcViews_h

#include "vtkMTExtraction.h"
#include "vtkMTFrustum.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

class vtkMTCut;
class vtkMTGraph;
struct vtkMTArc;
struct vtkMTView;

class vtkMTArcViews
{
public:
  static constexpr double NotWanted = -std::numeric_limits<double>::infinity();

  struct ArcView
  {
    bool Outside = false;      // of the frustum, and left out for that
    bool FacesAway = false;    // and left out for that
    double Wanted = NotWanted; // the error that refining the arc's node would remedy
    double Certified = 0.0;    // pixels

    bool IsDrawn() const { return !this->Outside && !this->FacesAway; }
  };

  // Begins a frame: forgets what was looked up. Graph and view must live until the next call.
  void Begin(const vtkMTGraph& graph, const vtkMTView* view, const vtkMTExtraction::Settings& settings);

  const ArcView& Look(std::uint32_t arc);
  // The largest Wanted of the arcs that enter the node.
  double GetWanted(std::uint32_t node);
  // Bytes of a patch on the GPU.
  std::uint64_t GetBytes(const vtkMTArc& arc) const;
  // Whether what is drawn is within the budgets.
  bool Fits(std::uint64_t triangles, std::uint64_t bytes) const;
  // Whether the patch is outside the frustum, but not by more than its own size.
  bool IsNearby(std::uint32_t arc) const;

  // The arcs of a cut that are drawn, and their figures; the refined nodes in any order, the source among them.
  void Report(const vtkMTCut& cut, const std::vector<std::uint32_t>& refinedNodes, vtkMTExtraction::Result& result);

  double GetThreshold() const { return this->Threshold; }

private:
  ArcView Make(const vtkMTArc& arc) const;

  const vtkMTGraph* Graph = nullptr;
  const vtkMTView* Eye = nullptr;
  vtkMTFrustum Frustum;
  vtkMTExtraction::Settings Options;
  double Threshold = 0.0;
  struct Facing
  {
    std::array<double, 3> Viewer; // perspective: the eye; parallel: the direction it looks in; model coordinates
    bool Parallel;
    double Sign; // -1 where the model is drawn mirrored
  };
  std::optional<Facing> Side; // none: nothing is left out for facing away

  std::vector<ArcView> Views;
  std::vector<std::uint32_t> ViewOfArc; // 1 + index in Views; 0 while nobody has looked
  std::vector<std::uint32_t> Touched;

  static std::optional<Facing> FindFacing(const vtkMTView& view);
  bool FacesAway(const vtkMTArc& arc, const double box[6]) const;
};

#endif
