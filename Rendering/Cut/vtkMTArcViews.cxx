// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArcViews.h"

#include "vtkMTArcBounds.h"
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTView.h"

#include <algorithm>
#include <cmath>

void vtkMTArcViews::Begin(const vtkMTGraph& graph, const vtkMTView* view, const vtkMTExtraction::Settings& settings)
{
  for (const std::uint32_t arc : this->Touched)
  {
    this->ViewOfArc[arc] = 0;
  }
  this->Views.clear();
  this->Touched.clear();
  this->ViewOfArc.resize(graph.Arcs.size(), 0);
  this->Graph = &graph;
  this->Eye = view;
  this->Frustum = view ? vtkMTFrustum(*view) : vtkMTFrustum();
  this->Options = settings;
  this->Threshold = view ? settings.PixelError : settings.ModelError;
  this->Side = view && settings.FacingCulling ? vtkMTArcViews::FindFacing(*view) : std::nullopt;
}

const vtkMTArcViews::ArcView& vtkMTArcViews::Look(std::uint32_t arc)
{
  std::uint32_t& known = this->ViewOfArc[arc];
  if (known == 0)
  {
    this->Touched.push_back(arc);
    this->Views.push_back(this->Make(this->Graph->Arcs[arc]));
    known = static_cast<std::uint32_t>(this->Views.size());
  }
  return this->Views[known - 1];
}

vtkMTArcViews::ArcView vtkMTArcViews::Make(const vtkMTArc& arc) const
{
  ArcView view;
  const vtkMTNode& node = this->Graph->Nodes[arc.To];
  const double error = this->Options.ErrorChoice == vtkMTExtraction::EdgeLength ? node.EdgeLength : node.Error;
  if (!this->Eye)
  {
    view.Wanted = error;
    return view;
  }
  const vtkMTArcBounds bounds(*this->Graph, arc);
  const bool visible = this->Frustum.IsVisible(bounds);
  view.Outside = !visible && this->Options.FrustumCulling;
  view.FacesAway = !view.Outside && this->Side && this->FacesAway(arc, bounds.Box);
  // What the patch stands for may reach into the frustum where the patch itself does not.
  if (visible || this->Frustum.IsVisible(bounds, node.Error))
  {
    view.Certified = this->Eye->GetPixelError(bounds.Center, bounds.Radius, node.Error);
    view.Wanted = this->Options.ErrorChoice == vtkMTExtraction::Distance
      ? view.Certified
      : this->Eye->GetPixelError(bounds.Center, bounds.Radius, error);
  }
  return view;
}

double vtkMTArcViews::GetWanted(std::uint32_t node)
{
  const vtkMTNode& record = this->Graph->Nodes[node];
  double wanted = NotWanted;
  for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
  {
    wanted = std::max(wanted, this->Look(this->Graph->Entering[k]).Wanted);
  }
  return wanted;
}

std::uint64_t vtkMTArcViews::GetBytes(const vtkMTArc& arc) const
{
  return std::uint64_t(arc.Wedges) * this->Options.BytesPerVertex +
    std::uint64_t(arc.Triangles) * this->Options.BytesPerTriangle;
}

bool vtkMTArcViews::Fits(std::uint64_t triangles, std::uint64_t bytes) const
{
  return (this->Options.TriangleBudget == 0 || triangles <= this->Options.TriangleBudget) &&
    (this->Options.ByteBudget == 0 || bytes <= this->Options.ByteBudget);
}

bool vtkMTArcViews::IsNearby(std::uint32_t arc) const
{
  const vtkMTArcBounds bounds(*this->Graph, this->Graph->Arcs[arc]);
  return this->Eye && this->Frustum.IsVisible(bounds, 2.0 * bounds.Radius);
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
bool vtkMTArcViews::FacesAway(const vtkMTArc& arc, const double box[6]) const
{
  constexpr double margin = 2e-3;
  const double length = std::sqrt(double(arc.ConeAxis[0]) * arc.ConeAxis[0] +
    double(arc.ConeAxis[1]) * arc.ConeAxis[1] + double(arc.ConeAxis[2]) * arc.ConeAxis[2]);
  if (!(arc.ConeCosine > 0.0f) || !(std::abs(length - 1.0) < 1e-3))
  {
    return false;
  }
  const double cosine = std::min(1.0, double(arc.ConeCosine));
  const double least = std::sqrt(1.0 - cosine * cosine) + margin;
  const double sign = this->Side->Sign / length;
  const std::array<double, 3>& viewer = this->Side->Viewer;
  for (int corner = 0; corner < (this->Side->Parallel ? 1 : 8); ++corner)
  {
    double along = 0.0;
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double x = box[2 * i + ((corner >> i) & 1)];
      const double sight = this->Side->Parallel ? viewer[i] : x - viewer[i];
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

void vtkMTArcViews::Report(
  const vtkMTCut& cut, const std::vector<std::uint32_t>& refinedNodes, vtkMTExtraction::Result& result)
{
  const vtkMTGraph& graph = *this->Graph;
  for (const std::uint32_t node : refinedNodes)
  {
    const vtkMTNode& record = graph.Nodes[node];
    for (std::uint32_t index = record.FirstOut; index < record.FirstOut + record.OutCount; ++index)
    {
      const vtkMTArc& arc = graph.Arcs[index];
      if (cut.IsRefined(arc.To))
      {
        continue;
      }
      const ArcView& view = this->Look(index);
      ++result.ArcsInCut;
      result.ModelError = std::max(result.ModelError, graph.Nodes[arc.To].Error);
      result.PixelError = std::max(result.PixelError, view.Certified);
      result.Converged = result.Converged && (arc.To == graph.GetSink() || !(view.Wanted > this->Threshold));
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
  std::sort(result.Arcs.begin(), result.Arcs.end());
  result.NodesRefined = refinedNodes.empty() ? 0 : refinedNodes.size() - 1; // the source is always refined
  result.WithinBudget = this->Fits(result.Triangles, result.Bytes);
}
