// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace
{
using MTTestModel::FillRecord;
using MTTestModel::TubeOptions;

//------------------------------------------------------------------------------
class TubeMaker
{
public:
  explicit TubeMaker(const TubeOptions& options)
    : Options(options)
  {
    this->PlacePoints();
  }

  std::shared_ptr<vtkMTPatchStore> Make()
  {
    int steps = 1;
    for (int regions = this->Options.Regions; regions > 1; regions /= 2)
    {
      ++steps;
    }
    // Nodes: source, then the regions of the last step (one), of the one before (two), ..., sink.
    this->Graph.Nodes.resize(1);
    this->FirstNode.resize(steps);
    for (int step = steps; step-- > 0;)
    {
      this->FirstNode[step] = static_cast<std::uint32_t>(this->Graph.Nodes.size());
      const int regions = this->GetRegions(step);
      for (int region = 0; region < regions; ++region)
      {
        vtkMTNode node;
        node.Level = step + 1;
        node.Region = region;
        this->Graph.Nodes.push_back(node);
      }
    }
    this->Graph.Nodes.emplace_back();
    this->Graph.Nodes.back().EdgeLength = 0.0;
    this->FillArrays();
    for (int step = 0; step <= steps; ++step)
    {
      this->WritePatches(step, steps);
      if (step < steps)
      {
        this->Simplify(step);
      }
    }
    return this->Finish();
  }

private:
  struct Segment
  {
    int First;           // ring
    int Length;          // in rings of the finest level
    std::uint32_t Finer; // the node that made it: arcs with it enter that node
    vtkIdType Cell;      // an input cell that it stands for
  };

  int GetRegions(int step) const { return std::max(1, this->Options.Regions >> step); }

  // Regions of odd steps begin in the middle of those of even ones.
  std::uint32_t GetRegionNode(int step, const Segment& segment) const
  {
    const int rings = this->Options.Rings;
    const int regions = this->GetRegions(step);
    const int length = rings / regions;
    const int middle = 2 * segment.First + segment.Length + (step % 2 ? length : 0);
    return this->FirstNode[step] + static_cast<std::uint32_t>(middle / 2 % rings / length);
  }

  void PlacePoints()
  {
    const double full = 2.0 * vtkMath::Pi();
    std::vector<std::array<double, 3>> places;
    double bounds[6];
    for (int i = 0; i < 6; ++i)
    {
      bounds[i] = i % 2 ? -VTK_DOUBLE_MAX : VTK_DOUBLE_MAX;
    }
    for (int r = 0; r < this->Options.Rings; ++r)
    {
      const double u = full * r / this->Options.Rings;
      const double radius = 0.3 * (1.0 + 0.3 * std::sin(7.0 * u) + 0.1 * std::sin(31.0 * u + 1.0));
      for (int c = 0; c < this->Options.Across; ++c)
      {
        const double v = full * c / this->Options.Across;
        const double s = 1.0 + radius * std::cos(v);
        std::array<double, 3> p{ s * std::cos(u), s * std::sin(u), radius * std::sin(v) };
        for (int i = 0; i < 3; ++i)
        {
          p[i] = p[i] * this->Options.Scale + this->Options.Offset[i];
          bounds[2 * i] = std::min(bounds[2 * i], p[i]);
          bounds[2 * i + 1] = std::max(bounds[2 * i + 1], p[i]);
        }
        places.push_back(p);
      }
      this->Segments.push_back({ r, 1, 0, static_cast<vtkIdType>(r) * 2 * this->Options.Across });
    }
    this->Graph.Lattice = vtkMTLattice::FromBounds(bounds);
    for (const std::array<double, 3>& p : places)
    {
      this->Points.push_back(this->Graph.Lattice.Snap(p.data()));
    }
  }

  void FillArrays()
  {
    this->Graph.InputCounts.Triangles = 2ull * this->Options.Across * this->Options.Rings;
    this->Graph.Settings = { { "partition", "runs of rings" }, { "simplifier", "every second ring" } };
    if (!this->Options.Arrays)
    {
      return;
    }
    vtkMTArrayInfo height;
    height.Name = "height";
    height.Attribute = 0; // scalars
    vtkMTArrayInfo uv;
    uv.Name = "uv";
    uv.Components = 2;
    uv.Attribute = 3; // texture coordinates
    vtkMTArrayInfo cells;
    cells.Name = "vtkMTInputCellIds";
    cells.Type = VTK_ID_TYPE;
    cells.Association = vtkMTArrayInfo::Cell;
    cells.Resampling = vtkMTArrayInfo::Nearest;
    cells.Role = vtkMTArrayInfo::InputCellIds;
    this->Graph.Arrays = { height, uv, cells };
  }

  const vtkMTPoint& GetPoint(int ring, int c) const
  {
    const int across = this->Options.Across;
    return this->Points[static_cast<std::size_t>(ring % this->Options.Rings) * across + c % across];
  }

  // Mesh `step`, split into patches by the regions that made it and the regions that will simplify it.
  void WritePatches(int step, int steps)
  {
    const std::uint32_t sink = static_cast<std::uint32_t>(this->Graph.Nodes.size()) - 1;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Segment>> patches;
    for (Segment& segment : this->Segments)
    {
      const std::uint32_t to = step == 0 ? sink : segment.Finer;
      const std::uint32_t from = step == steps ? 0 : this->GetRegionNode(step, segment);
      patches[{ from, to }].push_back(segment);
    }
    for (const auto& entry : patches)
    {
      vtkMTPatch patch = this->MakePatch(entry.second);
      vtkMTArc arc;
      arc.From = entry.first.first;
      arc.To = entry.first.second;
      FillRecord(patch, this->Graph.Lattice, arc);
      double& edge = this->Graph.Nodes[arc.To].EdgeLength;
      edge = std::max<double>(edge, arc.MeanEdgeLength);
      this->Graph.Arcs.push_back(arc);
      this->Patches.push_back(std::move(patch));
    }
  }

  // Points of rings at the ends of a run come first: those are shared.
  vtkMTPatch MakePatch(const std::vector<Segment>& segments) const
  {
    const int across = this->Options.Across;
    const int rings = this->Options.Rings;
    std::map<int, int> uses; // per ring, how many of the segments touch it
    for (const Segment& s : segments)
    {
      ++uses[s.First];
      ++uses[(s.First + s.Length) % rings];
    }
    vtkMTPatch patch;
    std::map<int, std::uint32_t> firstPoint;
    for (const int wanted : { 1, 2 })
    {
      for (const auto& use : uses)
      {
        if (use.second != wanted)
        {
          continue;
        }
        firstPoint[use.first] = static_cast<std::uint32_t>(patch.Points.size());
        for (int c = 0; c < across; ++c)
        {
          patch.Points.push_back(this->GetPoint(use.first, c));
          if (wanted == 1)
          {
            patch.Ids.push_back(static_cast<std::uint64_t>(use.first) * across + c);
          }
        }
      }
    }
    this->AddWedges(patch);
    vtkMTColumn cells;
    for (const Segment& s : segments)
    {
      const std::uint32_t a = firstPoint[s.First];
      const std::uint32_t b = firstPoint[(s.First + s.Length) % rings];
      for (int c = 0; c < across; ++c)
      {
        const std::uint32_t aNext = this->GetWedge(patch, a, c + 1);
        const std::uint32_t bNext = this->GetWedge(patch, b, c + 1);
        patch.Triangles.push_back({ a + c, b + c, bNext });
        patch.Triangles.push_back({ a + c, bNext, aNext });
        for (vtkIdType cell : { s.Cell + 2 * c, s.Cell + 2 * c + 1 })
        {
          const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&cell);
          cells.insert(cells.end(), bytes, bytes + sizeof(cell));
        }
      }
    }
    if (this->Options.Arrays)
    {
      patch.CellColumns.push_back(std::move(cells));
    }
    return patch;
  }

  // With arrays, every ring has one more wedge: its point 0 with the texture coordinate 1.
  std::uint32_t GetWedge(const vtkMTPatch& patch, std::uint32_t firstOfRing, int c) const
  {
    const std::uint32_t across = static_cast<std::uint32_t>(this->Options.Across);
    if (static_cast<std::uint32_t>(c) < across)
    {
      return firstOfRing + c;
    }
    return this->Options.Arrays ? static_cast<std::uint32_t>(patch.Points.size()) + firstOfRing / across : firstOfRing;
  }

  void AddWedges(vtkMTPatch& patch) const
  {
    if (!this->Options.Arrays)
    {
      return;
    }
    const std::uint32_t across = static_cast<std::uint32_t>(this->Options.Across);
    const std::uint32_t points = static_cast<std::uint32_t>(patch.Points.size());
    patch.PointColumns.resize(2);
    for (std::uint32_t w = 0; w < points + points / across; ++w)
    {
      const std::uint32_t point = w < points ? w : (w - points) * across;
      patch.WedgePoints.push_back(point);
      const std::array<double, 3> place = this->Graph.Lattice.ToWorld(patch.Points[point]);
      const float height = static_cast<float>(place[2]);
      const float angle = static_cast<float>(std::atan2(place[1], place[0]));
      const float uv[2] = { angle, w < points ? static_cast<float>(w % across) / across : 1.0f };
      const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&height);
      patch.PointColumns[0].insert(patch.PointColumns[0].end(), bytes, bytes + sizeof(height));
      bytes = reinterpret_cast<const unsigned char*>(uv);
      patch.PointColumns[1].insert(patch.PointColumns[1].end(), bytes, bytes + sizeof(uv));
    }
  }

  // Takes every second ring inside a region away; the segments on its two sides become one.
  void Simplify(int step)
  {
    std::map<std::uint32_t, std::size_t> inner; // rings inside each region so far
    std::vector<Segment> coarser;
    std::vector<unsigned char> mergeWithNext(this->Segments.size(), 0);
    const std::size_t count = this->Segments.size();
    for (std::size_t i = 0; i + 1 < count; ++i) // ring 0 always stays
    {
      const std::uint32_t node = this->GetRegionNode(step, this->Segments[i]);
      if (node == this->GetRegionNode(step, this->Segments[i + 1]))
      {
        mergeWithNext[i] = inner[node]++ % 2 == 0;
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint32_t node = this->GetRegionNode(step, this->Segments[i]);
      Segment merged = this->Segments[i];
      const std::size_t first = i;
      for (; mergeWithNext[i]; ++i)
      {
        merged.Length += this->Segments[i + 1].Length;
      }
      merged.Finer = node;
      double below = 0.0; // what the merged ones are from the input already
      for (std::size_t k = first; k <= i; ++k)
      {
        below = std::max(below, step > 0 ? this->Graph.Nodes[this->Segments[k].Finer].OwnError : 0.0);
      }
      double& error = this->Graph.Nodes[node].OwnError;
      error = std::max(error, this->GetDistance(first, i, merged) + below);
      coarser.push_back(merged);
    }
    this->Segments.swap(coarser);
  }

  double GetTwist(int ring, int length, int c) const
  {
    const vtkMTPoint& p00 = this->GetPoint(ring, c);
    const vtkMTPoint& p10 = this->GetPoint(ring + length, c);
    const vtkMTPoint& p01 = this->GetPoint(ring, c + 1);
    const vtkMTPoint& p11 = this->GetPoint(ring + length, c + 1);
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double w = (static_cast<double>(p00[i]) - p10[i]) + (static_cast<double>(p11[i]) - p01[i]);
      sum += w * w;
    }
    return 0.25 * std::sqrt(sum);
  }

  // Two-sided bound: the bilinear patches differ most at the rings; a triangulated quad is within its twist / 4 of its
  // bilinear patch.
  double GetDistance(std::size_t first, std::size_t last, const Segment& merged) const
  {
    double twist = 0.0;
    double shift = 0.0;
    for (int c = 0; c < this->Options.Across; ++c)
    {
      double finerTwist = 0.0;
      for (std::size_t i = first; i <= last; ++i)
      {
        const Segment& s = this->Segments[i];
        finerTwist = std::max(finerTwist, this->GetTwist(s.First, s.Length, c));
        const double t = static_cast<double>(s.First - merged.First) / merged.Length;
        const vtkMTPoint& a = this->GetPoint(merged.First, c);
        const vtkMTPoint& b = this->GetPoint(merged.First + merged.Length, c);
        double sum = 0.0;
        for (int j = 0; j < 3; ++j)
        {
          const double d = (1.0 - t) * a[j] + t * b[j] - this->GetPoint(s.First, c)[j];
          sum += d * d;
        }
        shift = std::max(shift, std::sqrt(sum));
      }
      twist = std::max(twist, finerTwist + this->GetTwist(merged.First, merged.Length, c));
    }
    return first == last ? 0.0 : (shift + twist) * this->Graph.Lattice.Step * (1.0 + 1e-12);
  }

  std::shared_ptr<vtkMTPatchStore> Finish()
  {
    const std::vector<std::uint32_t> patchOfArc = this->Graph.Index();
    this->Graph.Saturate(this->Graph.Lattice.MaximumShift);
    auto store = std::make_shared<vtkMTPatchStore>();
    bool ok = store->Begin(this->Graph.Arrays);
    for (vtkMTPatch& patch : this->Patches)
    {
      ok = ok && store->WritePatch(std::move(patch));
    }
    ok = ok && store->Finish(this->Graph, patchOfArc);
    return ok ? store : nullptr;
  }

  TubeOptions Options;
  vtkMTGraph Graph;
  std::vector<vtkMTPoint> Points;
  std::vector<Segment> Segments;
  std::vector<std::uint32_t> FirstNode; // per step
  std::vector<vtkMTPatch> Patches;
};
}

namespace MTTestModel
{
//------------------------------------------------------------------------------
void FillRecord(const vtkMTPatch& patch, const vtkMTLattice& lattice, vtkMTArc& arc)
{
  arc.Triangles = static_cast<std::uint32_t>(patch.Triangles.size());
  arc.Points = static_cast<std::uint32_t>(patch.Points.size());
  arc.Wedges = static_cast<std::uint32_t>(patch.GetNumberOfWedges());
  arc.SharedPoints = static_cast<std::uint32_t>(patch.Ids.size());
  arc.Box = patch.GetBox();
  arc.MeanEdgeLength = static_cast<float>(patch.GetMeanEdgeLength() * lattice.Step);
  std::vector<std::array<double, 3>> normals;
  double axis[3] = { 0.0, 0.0, 0.0 };
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    double u[3];
    double v[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = static_cast<double>(patch.Points[p[1]][i]) - patch.Points[p[0]][i];
      v[i] = static_cast<double>(patch.Points[p[2]][i]) - patch.Points[p[0]][i];
    }
    std::array<double, 3> n;
    vtkMath::Cross(u, v, n.data());
    if (vtkMath::Normalize(n.data()) > 0.0)
    {
      normals.push_back(n);
      vtkMath::Add(axis, n.data(), axis);
    }
  }
  double cosine = vtkMath::Normalize(axis) > 0.0 ? 1.0 : -1.0;
  for (const std::array<double, 3>& n : normals)
  {
    cosine = std::min(cosine, vtkMath::Dot(n.data(), axis));
  }
  arc.ConeAxis = { static_cast<float>(axis[0]), static_cast<float>(axis[1]), static_cast<float>(axis[2]) };
  arc.ConeCosine = static_cast<float>(std::max(-1.0, cosine - 1e-6));
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkMTPatchStore> MakeTube(const TubeOptions& options)
{
  return TubeMaker(options).Make();
}
}
