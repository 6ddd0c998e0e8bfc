// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArcViews.h"

#include "vtkMTView.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Straight = 3.14159265358979323846;
}

void vtkMTArcViews::Begin(
  const vtkMTGraph& graph, const std::vector<vtkMTView>& views, const vtkMTTargetCut::Settings& settings)
{
  ++this->Frame;
  // The number has come round, or arcs have other places: nothing that is known may be taken for this frame's.
  if (this->Frame == 0 || this->Views.size() != graph.Arcs.size())
  {
    this->Views.assign(graph.Arcs.size(), ArcView());
    this->Frame = 1;
  }
  this->Graph = &graph;
  this->Options = settings;
  this->Threshold = views.empty() ? settings.ModelError : settings.PixelError;
  this->Eyes.clear();
  const bool isOfNormals = settings.ErrorMetric == vtkMTTargetCut::NormalDeviation;
  const bool isOfValues = settings.ErrorMetric == vtkMTTargetCut::Value && !settings.ValueArray.empty();
  this->Deviations = isOfNormals ? graph.FindMeasure(vtkMTMeasure::MeanNormalDeviation)
    : isOfValues                 ? graph.FindMeasure(vtkMTMeasure::GetValueDeviationName(settings.ValueArray))
                                 : nullptr;
  for (const vtkMTView& view : views)
  {
    const std::optional<Facing> side =
      isOfNormals || settings.FacingCulling ? vtkMTArcViews::FindFacing(view) : std::nullopt;
    this->Eyes.push_back(
      { vtkMTArcProjector(graph.Lattice, view), settings.FacingCulling ? side : std::nullopt, side });
  }
}

double vtkMTArcViews::GetShadingLength(std::uint32_t node) const
{
  const double length = this->Graph->Nodes[node].EdgeLength;
  switch (this->Options.ErrorMetric)
  {
    case vtkMTTargetCut::EdgeLength:
      return length;
    case vtkMTTargetCut::NormalDeviation:
      return this->Deviations ? length * std::sin(0.5 * std::min(this->Deviations->Values[node], Straight)) : length;
    case vtkMTTargetCut::Value:
      return this->Deviations && !(this->Deviations->Values[node] > this->Options.ValueError) ? 0.0 : length;
    default:
      return 0.0;
  }
}

// From 1, where the axis of the patch's normals points to the eye, down to a sixteenth where it points away: what is
// seen from behind, on an open surface, is not to stay coarse however near it comes.
double vtkMTArcViews::GetFacingShare(const vtkMTArc& arc, const Facing& side) const
{
  constexpr double least = 0.25;
  double box[6];
  this->Graph->Lattice.ToWorld(arc.Box, box);
  double along = 0.0;
  double axis2 = 0.0;
  double sight2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double toward = side.Parallel ? -side.Viewer[i] : side.Viewer[i] - 0.5 * (box[2 * i] + box[2 * i + 1]);
    along += side.Sign * toward * arc.ConeAxis[i];
    axis2 += double(arc.ConeAxis[i]) * arc.ConeAxis[i];
    sight2 += toward * toward;
  }
  const double lengths = std::sqrt(axis2 * sight2);
  const double share = lengths > 0.0 ? std::max(least, 0.5 + 0.5 * along / lengths) : 1.0;
  return std::min(1.0, share * share);
}

double vtkMTArcViews::GetWanted(
  const vtkMTArc& arc, const Eye& eye, const vtkMTArcProjector::Depth& depth, double certified) const
{
  if (this->Options.ErrorMetric == vtkMTTargetCut::Distance)
  {
    return certified;
  }
  const double length = this->GetShadingLength(arc.To);
  if (this->Options.ErrorMetric == vtkMTTargetCut::EdgeLength)
  {
    return eye.Projector.GetPixelError(depth, length);
  }
  if (this->Options.ErrorMetric == vtkMTTargetCut::Value)
  {
    return std::max(certified, eye.Projector.GetPixelError(depth, length));
  }
  const bool counts = eye.Projector.GetPixelError(depth, this->Graph->Nodes[arc.To].EdgeLength) > 1.0;
  const double share = counts && eye.Toward ? this->GetFacingShare(arc, *eye.Toward) : 1.0;
  return counts ? std::max(certified, eye.Projector.GetPixelError(depth, length * share)) : certified;
}

void vtkMTArcViews::Make(std::uint32_t index, ArcView& view) const
{
  view = ArcView();
  view.Frame = this->Frame;
  const vtkMTArc& arc = this->Graph->Arcs[index];
  const vtkMTNode& node = this->Graph->Nodes[arc.To];
  if (this->Eyes.empty())
  {
    const double shading = this->GetShadingLength(arc.To);
    view.Wanted = this->Options.ErrorMetric == vtkMTTargetCut::EdgeLength ? shading : std::max(node.Error, shading);
    return;
  }
  const vtkMTArcProjector::Box box(arc.Box);
  bool visible = false;
  for (const Eye& eye : this->Eyes)
  {
    const double inside = eye.Projector.GetInside(box);
    visible = visible || inside >= 0.0;
    // What the patch stands for may reach into the frustum where the patch itself does not.
    if (inside + node.Error >= 0.0)
    {
      const vtkMTArcProjector::Depth depth = eye.Projector.GetDepth(box);
      const double certified = eye.Projector.GetPixelError(depth, node.Error);
      view.Certified = std::max(view.Certified, certified);
      view.Wanted = std::max(view.Wanted, this->GetWanted(arc, eye, depth, certified));
    }
  }
  view.Outside = !visible && this->Options.FrustumCulling;
  view.FacesAway = !view.Outside &&
    std::all_of(this->Eyes.begin(), this->Eyes.end(),
      [&](const Eye& eye) { return eye.Side && this->FacesAway(arc, *eye.Side); });
}

double vtkMTArcViews::GetWanted(std::uint32_t node)
{
  double wanted = NotWanted;
  for (const std::uint32_t arc : this->Graph->GetEntering(node))
  {
    wanted = std::max(wanted, this->Look(arc).Wanted);
  }
  return wanted;
}

bool vtkMTArcViews::Fits(std::uint64_t triangles, std::uint64_t bytes) const
{
  return (this->Options.TriangleLimit == 0 || triangles <= this->Options.TriangleLimit) &&
    (this->Options.ByteLimit == 0 || bytes <= this->Options.ByteLimit);
}

bool vtkMTArcViews::IsNearby(std::uint32_t arc) const
{
  const vtkMTArcProjector::Box box(this->Graph->Arcs[arc].Box);
  return std::any_of(this->Eyes.begin(), this->Eyes.end(),
    [&box](const Eye& eye) { return eye.Projector.IsVisible(box, 2.0 * eye.Projector.GetRadius(box)); });
}

// The determinant of an affine map says whether it keeps the sense in which a triangle's corners turn; the inverse of
// its linear part takes the eye, which is the origin of eye space, into the model.
std::optional<vtkMTArcViews::Facing> vtkMTArcViews::FindFacing(const vtkMTView& view)
{
  const std::array<double, 16>& m = view.ModelToEye;
  // Scaled, so that products of three neither overflow nor vanish.
  double scale = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    scale = i % 4 == 3 ? scale : std::max(scale, std::abs(m[i]));
  }
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    return std::nullopt;
  }
  double a[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      a[i][j] = m[4 * i + j] / scale;
    }
  }
  double adjoint[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int r = (j + 1) % 3;
      const int s = (j + 2) % 3;
      const int p = (i + 1) % 3;
      const int q = (i + 2) % 3;
      adjoint[i][j] = a[r][p] * a[s][q] - a[r][q] * a[s][p];
    }
  }
  const double determinant = a[0][0] * adjoint[0][0] + a[0][1] * adjoint[1][0] + a[0][2] * adjoint[2][0];
  // A model that is drawn flat, or nearly so, has no sides that one could rely on.
  if (!(std::abs(determinant) > 1e-9))
  {
    return std::nullopt;
  }
  Facing facing;
  facing.Parallel = view.ParallelProjection;
  facing.Sign = determinant > 0.0 ? 1.0 : -1.0;
  for (int i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      // Perspective: the place that is mapped to the origin. Parallel: what is mapped to -z.
      sum += adjoint[i][j] * (view.ParallelProjection ? (j == 2 ? -1.0 : 0.0) : -m[4 * j + 3] / scale);
    }
    facing.Viewer[i] = sum / determinant;
  }
  return facing;
}

// For all normals n of the cone and all x of the box n.(x - eye) > 0: for a given x the least n.(x - eye) is had at the
// cone's rim; as a function of x that is concave, so its least value over a box is at a corner. The angle between the
// axis and the line of sight must be less than a right angle by the cone's and by a little more, because the pictures
// are made in single precision.
bool vtkMTArcViews::FacesAway(const vtkMTArc& arc, const Facing& side) const
{
  constexpr double margin = 2e-3;
  const double length = std::sqrt(double(arc.ConeAxis[0]) * arc.ConeAxis[0] +
    double(arc.ConeAxis[1]) * arc.ConeAxis[1] + double(arc.ConeAxis[2]) * arc.ConeAxis[2]);
  if (!(arc.ConeCosine > 0.0f) || !(std::abs(length - 1.0) < 1e-3))
  {
    return false;
  }
  double box[6];
  this->Graph->Lattice.ToWorld(arc.Box, box);
  const double cosine = std::min(1.0, double(arc.ConeCosine));
  const double least = std::sqrt(1.0 - cosine * cosine) + margin;
  const double sign = side.Sign / length;
  const std::array<double, 3>& viewer = side.Viewer;
  for (int corner = 0; corner < (side.Parallel ? 1 : 8); ++corner)
  {
    double along = 0.0;
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double x = box[2 * i + ((corner >> i) & 1)];
      const double sight = side.Parallel ? viewer[i] : x - viewer[i];
      along += sign * arc.ConeAxis[i] * sight;
      square += sight * sight;
    }
    if (!(along > least * std::sqrt(square)))
    {
      return false;
    }
  }
  return true;
}

void vtkMTArcViews::Report(vtkMTTargetCut::Result& result)
{
  const vtkMTGraph& graph = *this->Graph;
  for (const std::uint32_t node : result.RefinedNodes)
  {
    const vtkMTNode& record = graph.Nodes[node];
    for (std::uint32_t index = record.FirstOut; index < record.FirstOut + record.OutCount; ++index)
    {
      const vtkMTArc& arc = graph.Arcs[index];
      if (!result.Cut.Contains(index))
      {
        continue;
      }
      const ArcView& view = this->Look(index);
      ++result.ArcsInCut;
      if (!result.Cut.IsRefined(arc.To)) // otherwise what was added to the patch says how precise the cut is
      {
        result.ModelError = std::max(result.ModelError, graph.Nodes[arc.To].Error);
        result.PixelError = std::max(result.PixelError, view.Certified);
        result.Converged = result.Converged && (arc.To == graph.GetSink() || !(view.Wanted > this->Threshold));
      }
      if (view.IsDrawn())
      {
        result.Arcs.push_back(index);
        result.Triangles += arc.Triangles;
        result.Bytes += this->GetBytes(arc);
      }
      else
      {
        ++(view.Outside ? result.ArcsCulled : result.ArcsFacingAway);
        (view.Outside ? result.TrianglesCulled : result.TrianglesFacingAway) += arc.Triangles;
      }
    }
  }
  result.NodesRefined =
    result.RefinedNodes.empty() ? 0 : result.RefinedNodes.size() - 1; // the source is always refined
  result.WithinLimits = this->Fits(result.Triangles, result.Bytes);
}
