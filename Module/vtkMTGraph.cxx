// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGraph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
// Spheres are computed in steps, in double precision; this much more makes up for the rounding of a few operations.
constexpr double RadiusSlack = 1e-13;
constexpr int CenterIterations = 40;

struct Ball
{
  std::array<double, 3> Center{ 0.0, 0.0, 0.0 };
  double Radius = 0.0;
};

//------------------------------------------------------------------------------
double GetDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

//------------------------------------------------------------------------------
void AddCorners(const vtkMTBox& box, std::vector<Ball>& balls)
{
  if (box[0] > box[1])
  {
    return;
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    Ball ball;
    ball.Center = { static_cast<double>(box[corner & 1]), static_cast<double>(box[2 + ((corner >> 1) & 1)]),
      static_cast<double>(box[4 + (corner >> 2)]) };
    balls.push_back(ball);
  }
}

//------------------------------------------------------------------------------
// The farthest ball from a centre, and the radius that reaches around it.
std::size_t FindFarthest(const std::vector<Ball>& balls, const std::array<double, 3>& center, double& radius)
{
  std::size_t farthest = 0;
  radius = -1.0;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const double reach = GetDistance(balls[i].Center, center) + balls[i].Radius;
    if (reach > radius)
    {
      radius = reach;
      farthest = i;
    }
  }
  return farthest;
}

//------------------------------------------------------------------------------
std::array<double, 3> GetMiddleOfBox(const std::vector<Ball>& balls)
{
  std::array<double, 3> middle;
  for (int i = 0; i < 3; ++i)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Ball& ball : balls)
    {
      low = std::min(low, ball.Center[i] - ball.Radius);
      high = std::max(high, ball.Center[i] + ball.Radius);
    }
    middle[i] = 0.5 * (low + high);
  }
  return middle;
}

//------------------------------------------------------------------------------
/**
 * A small ball around balls, after Badoiu and Clarkson ("Smaller core-sets for balls", 2003): go towards the farthest
 * one by smaller and smaller steps, keep the best centre. The centre is a lattice point, so that its place in model
 * units is exact and the radius holds there as well.
 */
Ball Enclose(const std::vector<Ball>& balls)
{
  Ball best;
  if (balls.empty())
  {
    return best;
  }
  best.Radius = std::numeric_limits<double>::infinity();
  std::array<double, 3> center = GetMiddleOfBox(balls);
  for (int iteration = 0; iteration < CenterIterations; ++iteration)
  {
    std::array<double, 3> rounded;
    std::transform(center.begin(), center.end(), rounded.begin(), [](double x) { return std::nearbyint(x); });
    double radius = 0.0;
    FindFarthest(balls, rounded, radius);
    if (radius < best.Radius)
    {
      best.Center = rounded;
      best.Radius = radius;
    }
    const Ball& farthest = balls[FindFarthest(balls, center, radius)];
    const double distance = GetDistance(farthest.Center, center);
    if (!(distance > 0.0))
    {
      break;
    }
    const double stride = (distance + farthest.Radius) / distance / (iteration + 3.0);
    for (int i = 0; i < 3; ++i)
    {
      center[i] += (farthest.Center[i] - center[i]) * stride;
    }
  }
  best.Radius += best.Radius * RadiusSlack;
  return best;
}

//------------------------------------------------------------------------------
double AddUp(double a, double b)
{
  return a == 0.0 || b == 0.0 ? a + b : std::nextafter(a + b, std::numeric_limits<double>::infinity());
}

//------------------------------------------------------------------------------
double GetDiameter(const vtkMTGraph& graph, const vtkMTNode& node)
{
  std::array<double, 3> low;
  std::array<double, 3> high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < node.InCount; ++i)
  {
    const vtkMTBox& box = graph.Arcs[graph.Entering[node.FirstIn + i]].Box;
    for (int j = 0; j < 3 && box[0] <= box[1]; ++j)
    {
      low[j] = std::min(low[j], static_cast<double>(box[2 * j]));
      high[j] = std::max(high[j], static_cast<double>(box[2 * j + 1]));
    }
  }
  return low[0] <= high[0] ? graph.Lattice.Step * GetDistance(low, high) : 0.0;
}
}

//------------------------------------------------------------------------------
const vtkMTMeasure* vtkMTGraph::FindMeasure(const std::string& name) const
{
  const auto found = std::find_if(this->Measures.begin(), this->Measures.end(),
    [&name](const vtkMTMeasure& measure) { return measure.Name == name; });
  return found == this->Measures.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTGraph::GetNumberOfKnownNodes() const
{
  const std::uint32_t known = this->Known.Count.load(std::memory_order_acquire);
  return known == KnownPrefix::All ? static_cast<std::uint32_t>(this->Nodes.size()) : known;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTGraph::GetNumberOfKnownArcs() const
{
  const std::uint32_t known = this->Known.Count.load(std::memory_order_acquire);
  if (known == KnownPrefix::All)
  {
    return static_cast<std::uint32_t>(this->Arcs.size());
  }
  return known == 0 ? 0 : this->Nodes[known - 1].FirstOut + this->Nodes[known - 1].OutCount;
}

//------------------------------------------------------------------------------
void vtkMTGraph::SetNumberOfKnownNodes(std::uint32_t nodes)
{
  this->Known.Count.store(nodes < this->Nodes.size() ? nodes : KnownPrefix::All, std::memory_order_release);
}

//------------------------------------------------------------------------------
vtkMTGraphFigures vtkMTGraph::GetFigures() const
{
  if (!this->IsWhole())
  {
    return this->Figures;
  }
  vtkMTGraphFigures figures;
  figures.Levels = this->GetNumberOfLevels();
  figures.FinestTriangles = this->GetNumberOfFinestTriangles();
  for (const vtkMTArc& arc : this->Arcs)
  {
    figures.LargestWedges = std::max(figures.LargestWedges, arc.Wedges);
    figures.AddBox(arc.Box);
  }
  return figures;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTGraph::GetNumberOfLevels() const
{
  if (!this->IsWhole())
  {
    return this->Figures.Levels;
  }
  std::uint32_t levels = 0;
  for (const vtkMTArc& arc : this->Arcs)
  {
    levels = std::max(levels, this->Nodes[arc.To].Level + 1);
  }
  return levels;
}

//------------------------------------------------------------------------------
double vtkMTGraph::GetDistance(std::uint32_t arc, float steps) const
{
  const double error = this->Nodes[this->Arcs[arc].To].Error;
  if (!(steps >= 0.0f))
  {
    return error;
  }
  const double distance =
    steps > 0.0f ? std::nextafter(steps * this->Lattice.Step, std::numeric_limits<double>::infinity()) : 0.0;
  return std::min(error, AddUp(distance, this->Lattice.MaximumShift));
}

//------------------------------------------------------------------------------
bool vtkMTGraph::HasArcDistances() const
{
  const std::uint32_t known = this->GetNumberOfKnownArcs();
  return known > 0 &&
    std::all_of(this->Arcs.begin(), this->Arcs.begin() + known, [](const vtkMTArc& arc) { return arc.HasDistances(); });
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTGraph::GetNumberOfRootTriangles() const
{
  std::uint64_t triangles = 0;
  for (std::uint32_t i = 0; !this->Nodes.empty() && i < this->Nodes.front().OutCount; ++i)
  {
    triangles += this->Arcs[this->Nodes.front().FirstOut + i].Triangles;
  }
  return triangles;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTGraph::GetNumberOfFinestTriangles() const
{
  if (!this->IsWhole())
  {
    return this->Figures.FinestTriangles;
  }
  std::uint64_t triangles = 0;
  for (std::uint32_t arc = 0; arc < this->Arcs.size(); ++arc)
  {
    triangles += this->IsFinest(arc) ? this->Arcs[arc].Triangles : 0;
  }
  return triangles;
}

//------------------------------------------------------------------------------
void vtkMTGraph::GetBounds(double bounds[6]) const
{
  this->Lattice.ToWorld(this->GetFigures().Box, bounds);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTGraph::Index()
{
  std::vector<std::uint32_t> order(this->Arcs.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [this](std::uint32_t a, std::uint32_t b)
    {
      const vtkMTArc& left = this->Arcs[a];
      const vtkMTArc& right = this->Arcs[b];
      return left.From != right.From ? left.From < right.From : left.To < right.To;
    });
  std::vector<vtkMTArc> sorted;
  sorted.reserve(order.size());
  for (vtkMTNode& node : this->Nodes)
  {
    node.FirstOut = node.OutCount = node.FirstIn = node.InCount = 0;
  }
  for (std::uint32_t old : order)
  {
    sorted.push_back(this->Arcs[old]);
    ++this->Nodes[sorted.back().From].OutCount;
    ++this->Nodes[sorted.back().To].InCount;
  }
  this->Arcs.swap(sorted);
  std::uint32_t out = 0;
  std::uint32_t in = 0;
  std::vector<std::uint32_t> next(this->Nodes.size());
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    this->Nodes[i].FirstOut = out;
    this->Nodes[i].FirstIn = next[i] = in;
    out += this->Nodes[i].OutCount;
    in += this->Nodes[i].InCount;
  }
  this->Entering.resize(this->Arcs.size());
  for (std::uint32_t arc = 0; arc < this->Arcs.size(); ++arc)
  {
    this->Entering[next[this->Arcs[arc].To]++] = arc;
  }
  return order;
}

//------------------------------------------------------------------------------
void vtkMTGraph::Saturate(double sinkError)
{
  if (this->Nodes.empty())
  {
    return;
  }
  const std::uint32_t sink = this->GetSink();
  std::vector<Ball> spheres(this->Nodes.size()); // in steps
  std::vector<Ball> inside;
  this->Nodes.front().Level = this->GetNumberOfLevels();
  this->Nodes.front().OwnError = 0.0;
  for (std::uint32_t index = sink + 1; index-- > 0;)
  {
    vtkMTNode& node = this->Nodes[index];
    inside.clear();
    // The source has no fragment, only what is below it.
    node.Error = index == 0 ? 0.0 : AddUp(node.OwnError, sinkError);
    for (std::uint32_t i = 0; i < node.OutCount; ++i)
    {
      const vtkMTArc& arc = this->Arcs[node.FirstOut + i];
      node.Error = std::max(node.Error, this->Nodes[arc.To].Error);
      node.EdgeLength = std::max(node.EdgeLength, this->Nodes[arc.To].EdgeLength);
      for (vtkMTMeasure& measure : this->Measures)
      {
        measure.Values[index] = std::max(measure.Values[index], measure.Values[arc.To]);
      }
      AddCorners(arc.Box, inside);
      if (arc.To != sink)
      {
        inside.push_back(spheres[arc.To]);
      }
    }
    for (std::uint32_t i = 0; i < node.InCount; ++i)
    {
      AddCorners(this->Arcs[this->Entering[node.FirstIn + i]].Box, inside);
    }
    if (index == sink)
    {
      inside.clear();
      for (const vtkMTArc& arc : this->Arcs)
      {
        AddCorners(arc.Box, inside);
      }
    }
    spheres[index] = Enclose(inside);
    node.Center = this->Lattice.ToWorld(spheres[index].Center);
    node.Radius = spheres[index].Radius * this->Lattice.Step;
  }
}

//------------------------------------------------------------------------------
// Arcs that leave a node come after those that enter it.
void vtkMTGraph::SaturateRanges(vtkMTArcRanges& ranges) const
{
  const std::size_t columns = ranges.Columns.size();
  for (std::size_t arc = columns > 0 ? this->Arcs.size() : 0; arc-- > 0;)
  {
    const vtkMTNode& node = this->Nodes[this->Arcs[arc].To];
    for (std::size_t finer = node.FirstOut; finer < std::size_t(node.FirstOut) + node.OutCount; ++finer)
    {
      for (std::size_t c = 0; c < columns; ++c)
      {
        ranges.Values[arc * columns + c].Add(ranges.Values[finer * columns + c]);
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkMTGraph::Conditioning vtkMTGraph::GetConditioning() const
{
  Conditioning result;
  result.FullySharedBorders = this->FullySharedBorders;
  std::vector<std::uint32_t> depth(this->Nodes.size(), 0);
  std::vector<std::vector<double>> diameters(this->GetNumberOfLevels());
  for (std::uint32_t index = 0; index < this->Nodes.size(); ++index)
  {
    const vtkMTNode& node = this->Nodes[index];
    const bool inner = index != this->GetSource() && index != this->GetSink();
    std::uint64_t floor = 0;
    for (std::uint32_t i = 0; i < node.OutCount; ++i)
    {
      const vtkMTArc& arc = this->Arcs[node.FirstOut + i];
      depth[arc.To] = std::max(depth[arc.To], depth[index] + (inner ? 1 : 0));
      floor += arc.Triangles;
    }
    result.LargestFloor = std::max(result.LargestFloor, inner ? floor : 0);
    if (inner && node.Level < diameters.size())
    {
      diameters[node.Level].push_back(GetDiameter(*this, node));
    }
  }
  result.Depth = depth.empty() ? 0 : depth.back();
  int ratios = 0;
  double finer = 0.0;
  for (std::vector<double>& level : diameters)
  {
    if (level.empty())
    {
      continue;
    }
    std::nth_element(level.begin(), level.begin() + level.size() / 2, level.end());
    const double median = level[level.size() / 2];
    if (finer > 0.0)
    {
      result.DiameterRatio += median / finer;
      ++ratios;
    }
    finer = median;
  }
  result.DiameterRatio = ratios > 0 ? result.DiameterRatio / ratios : 0.0;
  return result;
}
