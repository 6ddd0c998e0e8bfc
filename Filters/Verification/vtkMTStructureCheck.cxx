// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStructureCheck.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidate.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Spheres are nested in double arithmetic: this much of the coordinates' magnitude is rounding.
constexpr double Rounding = 1e-12;

void Append(vtkMTVerificationCheck& check, const vtkMTValidate::Result& result)
{
  check.Tested += result.Tested;
  check.Violations += result.Violations;
  if (check.Message.empty() && !result.Findings.empty())
  {
    check.Message = result.Findings.front().What;
  }
}

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class Nesting
{
public:
  explicit Nesting(const vtkMTGraph& graph)
    : Check("nesting")
    , Graph(graph)
  {
    double bounds[6];
    graph.GetBounds(bounds);
    for (double coordinate : bounds)
    {
      this->Slack = std::max(this->Slack, Rounding * std::abs(coordinate));
    }
  }

  void TestArcs()
  {
    for (std::size_t arc = 0; arc < this->Graph.Arcs.size(); ++arc)
    {
      const vtkMTNode& from = this->Graph.Nodes[this->Graph.Arcs[arc].From];
      const vtkMTNode& to = this->Graph.Nodes[this->Graph.Arcs[arc].To];
      if (this->Graph.Arcs[arc].From != this->Graph.GetSource())
      {
        // The error never grows towards the input, and covers the node's own and the lattice's rounding.
        this->Test(to.Error, from.Error, "error", arc);
        this->Test(from.OwnError + this->Graph.Nodes.back().Error, from.Error * (1.0 + Rounding), "own error", arc);
        this->Test(to.EdgeLength, from.EdgeLength * (1.0 + Rounding), "edge length", arc);
      }
      if (this->Graph.Arcs[arc].To != this->Graph.GetSink()) // the sink's sphere is the whole model's
      {
        const double inner = Distance(from.Center, to.Center) + to.Radius;
        this->Test(inner, from.Radius * (1.0 + Rounding) + this->Slack, "sphere", arc);
      }
    }
  }

  void TestPatch(std::size_t arc, const vtkMTPatch& patch)
  {
    const vtkMTNode& from = this->Graph.Nodes[this->Graph.Arcs[arc].From];
    const vtkMTNode& to = this->Graph.Nodes[this->Graph.Arcs[arc].To];
    double outside[2] = { 0.0, 0.0 };
    for (const vtkMTPoint& point : patch.Points)
    {
      const std::array<double, 3> x = this->Graph.Lattice.ToWorld(point);
      outside[0] = std::max(outside[0], Distance(x, from.Center));
      outside[1] = std::max(outside[1], Distance(x, to.Center));
    }
    this->Test(outside[0], from.Radius * (1.0 + Rounding) + this->Slack, "patch in its floor's sphere", arc);
    this->Test(outside[1], to.Radius * (1.0 + Rounding) + this->Slack, "patch in its fragment's sphere", arc);
  }

  vtkMTVerificationCheck Check;

private:
  void Test(double inner, double outer, const char* what, std::size_t arc)
  {
    ++this->Check.Tested;
    this->Check.Worst = std::max(this->Check.Worst, outer > 0.0 ? inner / outer : (inner > 0.0 ? HUGE_VAL : 0.0));
    if (!(inner <= outer))
    {
      std::ostringstream text;
      text.precision(17);
      text << "arc " << arc << " (node " << this->Graph.Arcs[arc].From << " to node " << this->Graph.Arcs[arc].To
           << "): " << what << " not nested, " << inner << " against " << outer;
      this->Check.Fail(text.str());
    }
  }

  const vtkMTGraph& Graph;
  double Slack = 0.0;
};
}

bool vtkMTStructureCheck::TestParts(const vtkMTPatchSource& source, const vtkMTVerificationProgress& progress,
  std::vector<vtkMTVerificationCheck>& checks)
{
  const vtkMTGraph& graph = source.GetGraph();
  vtkMTVerificationCheck dag("graph");
  Append(dag, vtkMTValidate::Graph(graph));
  vtkMTVerificationCheck checksums("checksums");
  vtkMTVerificationCheck patches("patches");
  Nesting nesting(graph);
  nesting.TestArcs();

  vtkMTPatch patch;
  std::string error;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    if (!progress("reading patches", static_cast<double>(arc) / static_cast<double>(graph.Arcs.size())))
    {
      return false;
    }
    ++checksums.Tested;
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      checksums.Fail(error);
      continue;
    }
    Append(patches, vtkMTValidate::Patch(graph, arc, patch));
    nesting.TestPatch(arc, patch);
  }
  std::vector<unsigned char> blob;
  for (std::uint32_t i = 0; i < graph.Blobs.size(); ++i)
  {
    ++checksums.Tested;
    if (!source.ReadBlob(i, blob, error))
    {
      checksums.Fail(error);
    }
  }
  checks.insert(checks.end(), { checksums, dag, patches, nesting.Check });
  return true;
}

vtkMTVerificationCheck vtkMTStructureCheck::TestPasting(const vtkMTPatchSource& source, vtkMTValidate::Borders& borders)
{
  vtkMTVerificationCheck check("pasting");
  Append(check, borders.Load(source));
  return check;
}

namespace
{
// Small models have few cuts that span many levels: so many random ones are looked at, for each that is tested, to find
// them.
constexpr std::size_t TriesPerCut = 30;

// Random cuts of which at least half are wide, as far as they can be found.
class CutSequence
{
public:
  CutSequence(const vtkMTGraph& graph, std::size_t cuts, std::uint32_t seed)
    : Graph(graph)
    , Seed(seed)
    , NarrowAllowed(cuts / 2)
    , Tries(TriesPerCut * cuts)
  {
  }

  vtkMTCut Next()
  {
    for (;;)
    {
      const std::size_t index = this->Index++;
      vtkMTCut cut = vtkMTRandomCut::Make(this->Graph, this->Seed, index);
      this->Span = vtkMTRandomCut::GetLevelSpan(this->Graph, cut);
      const bool isWide = this->Span >= vtkMTStructureCheck::WideSpan;
      if (isWide || this->NarrowAllowed > 0 || index >= this->Tries)
      {
        this->NarrowAllowed -= !isWide && this->NarrowAllowed > 0 ? 1 : 0;
        return cut;
      }
    }
  }

  /// Of the last cut.
  std::uint32_t GetSpan() const { return this->Span; }
  std::size_t GetIndex() const { return this->Index - 1; }

private:
  const vtkMTGraph& Graph;
  std::uint32_t Seed;
  std::size_t NarrowAllowed;
  std::size_t Tries;
  std::size_t Index = 0;
  std::uint32_t Span = 0;
};
}

bool vtkMTStructureCheck::TestConformity(const vtkMTPatchSource& source, const vtkMTValidate::Borders& borders,
  std::size_t cuts, std::uint32_t seed, const vtkMTVerificationProgress& progress,
  std::vector<vtkMTVerificationCheck>& checks, std::map<std::uint32_t, std::size_t>& spans)
{
  vtkMTVerificationCheck check("conformity");
  CutSequence sequence(source.GetGraph(), cuts, seed);
  for (std::size_t i = 0; i < cuts; ++i)
  {
    if (!progress("checking cuts", static_cast<double>(i) / static_cast<double>(cuts)))
    {
      return false;
    }
    const vtkMTValidate::Result result = borders.Cut(sequence.Next());
    ++spans[sequence.GetSpan()];
    ++check.Tested;
    if (!result.IsValid())
    {
      const std::string what = result.Findings.empty() ? "not conforming" : result.Findings.front().What;
      check.Fail("random cut " + std::to_string(sequence.GetIndex()) + ": " + what);
    }
  }
  checks.push_back(check);
  return true;
}
