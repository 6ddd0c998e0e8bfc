// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTExtraction.h"

#include "vtkMTGraph.h"
#include "vtkMTView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <sstream>

namespace
{
constexpr double NotWanted = -std::numeric_limits<double>::infinity();

struct ArcBounds
{
  double Box[6];
  std::array<double, 3> Center;
  double Radius;

  ArcBounds(const vtkMTGraph& graph, const vtkMTArc& arc)
  {
    graph.Lattice.ToWorld(arc.Box, this->Box);
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      this->Center[i] = 0.5 * (this->Box[2 * i] + this->Box[2 * i + 1]);
      const double half = 0.5 * (this->Box[2 * i + 1] - this->Box[2 * i]);
      square += half * half;
    }
    // Rounding must not make the sphere smaller than the box.
    this->Radius = std::sqrt(square) * (1.0 + 1e-12);
  }

  bool IsVisible(const vtkMTView& view) const
  {
    return view.IsSphereVisible(this->Center, this->Radius) && view.IsBoxVisible(this->Box);
  }

  /// Of the box that reaches farther by that much on every side.
  bool IsVisibleGrown(const vtkMTView& view, double by) const
  {
    double grown[6];
    for (int i = 0; i < 3; ++i)
    {
      grown[2 * i] = this->Box[2 * i] - by;
      grown[2 * i + 1] = this->Box[2 * i + 1] + by;
    }
    return view.IsSphereVisible(this->Center, this->Radius + 2.0 * by) && view.IsBoxVisible(grown);
  }
};

double ChosenError(const vtkMTNode& node, vtkMTExtraction::ErrorChoiceType choice)
{
  return choice == vtkMTExtraction::EdgeLength ? node.EdgeLength : node.Error;
}
}

// What is known of the arcs that a call has looked at; kept between calls so that a frame costs as much as its cut, not
// as much as its graph.
struct vtkMTExtraction::Scratch
{
  struct ArcView
  {
    bool Drawn = true;
    double Wanted = NotWanted; // the error that refining the arc's node would remedy
    double Certified = 0.0;    // pixels
  };

  std::vector<ArcView> Views;
  std::vector<std::uint32_t> ViewOfArc; // 1 + index in Views; 0 while nobody has looked
  std::vector<std::uint32_t> TouchedArcs;
  std::vector<unsigned char> Marks; // nodes of the closure at hand; all zero between uses
  std::vector<double> Wanted;       // per node, the error with which it was last put into the heap
  std::vector<std::uint32_t> TouchedNodes;

  void Begin(const vtkMTGraph& graph)
  {
    for (const std::uint32_t arc : this->TouchedArcs)
    {
      this->ViewOfArc[arc] = 0;
    }
    for (const std::uint32_t node : this->TouchedNodes)
    {
      this->Wanted[node] = NotWanted;
    }
    this->Views.clear();
    this->TouchedArcs.clear();
    this->TouchedNodes.clear();
    this->ViewOfArc.resize(graph.Arcs.size(), 0);
    this->Marks.resize(graph.Nodes.size(), 0);
    this->Wanted.resize(graph.Nodes.size(), NotWanted);
  }
};

class vtkMTExtraction::Worker
{
public:
  Worker(const Input& input, const Settings& settings, Scratch& memory)
    : Graph(*input.Graph)
    , Eye(input.View)
    , Resident(input.Resident)
    , Options(settings)
    , Threshold(input.View ? settings.PixelError : settings.ModelError)
    , Memory(memory)
    , Out(*input.Graph)
  {
    this->Memory.Begin(this->Graph);
  }

  Result Run()
  {
    if (!this->Graph.IsEmpty())
    {
      this->RefinedNodes.push_back(this->Graph.GetSource());
      this->EnterLeaving(this->Graph.GetSource());
      this->Out.WithinBudget = this->Fits(this->Out.Triangles);
      this->Refine();
      this->Finish();
    }
    return std::move(this->Out);
  }

  Result Show(const vtkMTCut& cut)
  {
    this->Out.Cut = cut;
    for (std::uint32_t node = 0; node < this->Graph.GetSink(); ++node)
    {
      if (cut.IsRefined(node))
      {
        this->RefinedNodes.push_back(node);
      }
    }
    if (!this->Graph.IsEmpty())
    {
      this->Finish();
      for (const std::uint32_t arc : this->Out.Arcs)
      {
        this->Out.Triangles += this->Graph.Arcs[arc].Triangles;
      }
      this->Out.WithinBudget = this->Fits(this->Out.Triangles);
    }
    return std::move(this->Out);
  }

private:
  struct Candidate
  {
    double Error;
    std::uint32_t Node;
    bool operator<(const Candidate& other) const
    {
      return this->Error != other.Error ? this->Error < other.Error : this->Node > other.Node;
    }
  };

  bool Fits(std::uint64_t triangles) const
  {
    return this->Options.TriangleBudget == 0 || triangles <= this->Options.TriangleBudget;
  }

  const Scratch::ArcView& Look(std::uint32_t arc)
  {
    std::uint32_t& known = this->Memory.ViewOfArc[arc];
    if (known == 0)
    {
      this->Memory.TouchedArcs.push_back(arc);
      this->Memory.Views.push_back(this->MakeView(this->Graph.Arcs[arc]));
      known = static_cast<std::uint32_t>(this->Memory.Views.size());
    }
    return this->Memory.Views[known - 1];
  }

  Scratch::ArcView MakeView(const vtkMTArc& arc) const
  {
    Scratch::ArcView view;
    const vtkMTNode& node = this->Graph.Nodes[arc.To];
    const double error = ChosenError(node, this->Options.ErrorChoice);
    if (!this->Eye)
    {
      view.Wanted = error;
      return view;
    }
    const ArcBounds bounds(this->Graph, arc);
    const bool visible = bounds.IsVisible(*this->Eye);
    view.Drawn = visible || !this->Options.FrustumCulling;
    // What the patch stands for may reach into the frustum where the patch itself does not.
    if (visible || bounds.IsVisibleGrown(*this->Eye, node.Error))
    {
      view.Certified = this->Eye->GetPixelError(bounds.Center, bounds.Radius, node.Error);
      view.Wanted = this->Options.ErrorChoice == Distance
        ? view.Certified
        : this->Eye->GetPixelError(bounds.Center, bounds.Radius, error);
    }
    return view;
  }

  bool IsDrawn(std::uint32_t arc) { return this->Look(arc).Drawn; }

  bool IsResident(std::uint32_t arc) const { return !this->Resident || (*this->Resident)[arc] != 0; }

  void EnterLeaving(std::uint32_t node)
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
    {
      this->Enter(arc);
    }
  }

  void Enter(std::uint32_t arc)
  {
    const vtkMTArc& record = this->Graph.Arcs[arc];
    if (this->IsDrawn(arc))
    {
      this->Out.Triangles += record.Triangles;
    }
    if (record.To == this->Graph.GetSink())
    {
      return;
    }
    const double error = this->Look(arc).Wanted;
    double& wanted = this->Memory.Wanted[record.To];
    if (error > this->Threshold && error > wanted)
    {
      if (wanted == NotWanted)
      {
        this->Memory.TouchedNodes.push_back(record.To);
      }
      wanted = error;
      this->Heap.push({ error, record.To });
    }
  }

  /// The node and all unrefined ones that it depends on; ascending, which is an order in which they can be refined.
  const std::vector<std::uint32_t>& GetClosure(std::uint32_t node)
  {
    this->Closure.assign(1, node);
    this->Memory.Marks[node] = 1;
    for (std::size_t i = 0; i < this->Closure.size(); ++i)
    {
      const vtkMTNode& record = this->Graph.Nodes[this->Closure[i]];
      for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
      {
        const std::uint32_t from = this->Graph.Arcs[this->Graph.Entering[k]].From;
        if (!this->Memory.Marks[from] && !this->Out.Cut.IsRefined(from))
        {
          this->Memory.Marks[from] = 1;
          this->Closure.push_back(from);
        }
      }
    }
    std::sort(this->Closure.begin(), this->Closure.end());
    return this->Closure;
  }

  void Unmark()
  {
    for (const std::uint32_t node : this->Closure)
    {
      this->Memory.Marks[node] = 0;
    }
  }

  /// Whether the closure at hand may be refined: enough budget, and all that it would draw is resident.
  bool IsFeasible(double error)
  {
    std::uint64_t added = 0;
    std::uint64_t removed = 0;
    this->Missing.clear();
    for (const std::uint32_t node : this->Closure)
    {
      const vtkMTNode& record = this->Graph.Nodes[node];
      for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
      {
        if (!this->Memory.Marks[this->Graph.Arcs[arc].To] && this->IsDrawn(arc))
        {
          added += this->Graph.Arcs[arc].Triangles;
          if (!this->IsResident(arc))
          {
            this->Missing.push_back({ arc, error });
          }
        }
      }
      for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
      {
        const std::uint32_t arc = this->Graph.Entering[k];
        if (!this->Memory.Marks[this->Graph.Arcs[arc].From] && this->IsDrawn(arc))
        {
          removed += this->Graph.Arcs[arc].Triangles;
        }
      }
    }
    if (added > removed && !this->Fits(this->Out.Triangles + added - removed))
    {
      return false;
    }
    this->Out.Requests.insert(this->Out.Requests.end(), this->Missing.begin(), this->Missing.end());
    return this->Missing.empty();
  }

  /// Refines the node with everything that it depends on, or does nothing.
  bool TryRefine(std::uint32_t node, double error)
  {
    ++this->Out.Operations;
    this->GetClosure(node);
    const bool feasible = this->IsFeasible(error);
    this->Unmark();
    if (!feasible)
    {
      return false;
    }
    const std::vector<std::uint32_t> nodes = this->Closure;
    for (const std::uint32_t each : nodes)
    {
      this->RefineOne(each);
    }
    return true;
  }

  void RefineOne(std::uint32_t node)
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
    {
      const std::uint32_t arc = this->Graph.Entering[k];
      if (this->IsDrawn(arc))
      {
        this->Out.Triangles -= this->Graph.Arcs[arc].Triangles;
      }
    }
    this->Out.Cut.Refine(node);
    this->RefinedNodes.push_back(node);
    this->EnterLeaving(node);
  }

  /// Refines by the heap until nothing more can be done.
  void Refine()
  {
    std::size_t refinedAtLastRetry = 0;
    while (true)
    {
      while (!this->Heap.empty())
      {
        const Candidate candidate = this->Heap.top();
        this->Heap.pop();
        const bool outdated =
          this->Out.Cut.IsRefined(candidate.Node) || candidate.Error < this->Memory.Wanted[candidate.Node];
        if (!outdated && !this->TryRefine(candidate.Node, candidate.Error))
        {
          this->Postponed.push_back(candidate);
        }
      }
      // Somebody else may have refined what a postponed one was waiting for.
      if (this->RefinedNodes.size() == refinedAtLastRetry || this->Postponed.empty())
      {
        this->ForgetRefined();
        return;
      }
      refinedAtLastRetry = this->RefinedNodes.size();
      for (const Candidate& candidate : this->Postponed)
      {
        this->Heap.push(candidate);
      }
      this->Postponed.clear();
    }
  }

  void ForgetRefined()
  {
    const auto done = [this](const Candidate& candidate)
    { return this->Out.Cut.IsRefined(candidate.Node) || candidate.Error < this->Memory.Wanted[candidate.Node]; };
    this->Postponed.erase(std::remove_if(this->Postponed.begin(), this->Postponed.end(), done), this->Postponed.end());
  }

  void Finish()
  {
    for (const std::uint32_t node : this->RefinedNodes)
    {
      const vtkMTNode& record = this->Graph.Nodes[node];
      for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
      {
        if (!this->Out.Cut.IsRefined(this->Graph.Arcs[arc].To))
        {
          this->Report(arc);
        }
      }
    }
    std::sort(this->Out.Arcs.begin(), this->Out.Arcs.end());
    this->Out.NodesRefined = this->RefinedNodes.size() - 1; // the source is always refined
    this->Out.Postponed = this->Postponed.size();
    this->SortRequests();
  }

  void Report(std::uint32_t arc)
  {
    const vtkMTArc& record = this->Graph.Arcs[arc];
    const vtkMTNode& node = this->Graph.Nodes[record.To];
    ++this->Out.ArcsInCut;
    this->Out.ModelError = std::max(this->Out.ModelError, node.Error);
    this->Out.PixelError = std::max(this->Out.PixelError, this->Look(arc).Certified);
    if (record.To != this->Graph.GetSink() && this->Look(arc).Wanted > this->Threshold)
    {
      this->Out.Converged = false;
    }
    if (this->IsDrawn(arc))
    {
      this->Out.Arcs.push_back(arc);
    }
    else
    {
      ++this->Out.ArcsCulled;
    }
  }

  void SortRequests()
  {
    std::vector<Request>& requests = this->Out.Requests;
    std::sort(requests.begin(), requests.end(),
      [](const Request& a, const Request& b) { return a.Arc != b.Arc ? a.Arc < b.Arc : a.Error > b.Error; });
    requests.erase(
      std::unique(requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.Arc == b.Arc; }),
      requests.end());
    std::stable_sort(
      requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.Error > b.Error; });
  }

  const vtkMTGraph& Graph;
  const vtkMTView* Eye;
  const std::vector<unsigned char>* Resident;
  const Settings& Options;
  const double Threshold;
  Scratch& Memory;
  Result Out;
  std::priority_queue<Candidate> Heap;
  std::vector<Candidate> Postponed; // the largest error first
  std::vector<std::uint32_t> RefinedNodes;
  std::vector<std::uint32_t> Closure;
  std::vector<Request> Missing;
};

vtkMTExtraction::vtkMTExtraction()
  : Memory(std::make_unique<Scratch>())
{
}

vtkMTExtraction::~vtkMTExtraction() = default;

vtkMTExtraction::Result vtkMTExtraction::Extract(const Input& input, const Settings& settings)
{
  return Worker(input, settings, *this->Memory).Run();
}

vtkMTExtraction::Result vtkMTExtraction::View(const vtkMTCut& cut, const Input& input, const Settings& settings)
{
  return Worker(input, settings, *this->Memory).Show(cut);
}

bool vtkMTExtraction::ByTriangles(const vtkMTGraph& graph, std::uint64_t triangles, vtkMTCut& cut, std::string& message)
{
  if (triangles < graph.GetRootTriangles())
  {
    message = "the coarsest cut has " + std::to_string(graph.GetRootTriangles()) + " triangles, more than the " +
      std::to_string(triangles) + " asked for";
    return false;
  }
  Settings settings;
  settings.ModelError = -1.0;
  settings.TriangleBudget = std::max<std::uint64_t>(triangles, 1);
  Input input;
  input.Graph = &graph;
  cut = this->Extract(input, settings).Cut;
  return true;
}

bool vtkMTExtraction::ByError(const vtkMTGraph& graph, double error, vtkMTCut& cut, std::string& message)
{
  Settings settings;
  settings.ModelError = error;
  Input input;
  input.Graph = &graph;
  Result result = this->Extract(input, settings);
  if (!(result.ModelError <= error))
  {
    std::ostringstream text;
    text << "the finest level has an error of " << result.ModelError << ", more than the " << error << " asked for";
    message = text.str();
    return false;
  }
  cut = std::move(result.Cut);
  return true;
}

bool vtkMTExtraction::ByLevel(const vtkMTGraph& graph, std::uint32_t level, vtkMTCut& cut, std::string& message)
{
  if (level >= graph.GetNumberOfLevels())
  {
    message = "the model has " + std::to_string(graph.GetNumberOfLevels()) + " levels, there is no level " +
      std::to_string(level);
    return false;
  }
  cut = vtkMTCut(graph);
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    if (graph.Nodes[node].Level > level)
    {
      cut.RefineWithDependencies(node);
    }
  }
  return true;
}

double vtkMTExtraction::GetPixelError(
  const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc, ErrorChoiceType choice)
{
  const ArcBounds bounds(graph, graph.Arcs[arc]);
  return view.GetPixelError(bounds.Center, bounds.Radius, ChosenError(graph.Nodes[graph.Arcs[arc].To], choice));
}

bool vtkMTExtraction::IsVisible(const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc)
{
  return ArcBounds(graph, graph.Arcs[arc]).IsVisible(view);
}
