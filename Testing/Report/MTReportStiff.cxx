// SPDX-License-Identifier: BSD-3-Clause
// Stiff and extreme cases (MTStiffCases.h): a table of figures, a table of claims with verdicts, and what follows from
// both. The same cases are ctests, of smaller sizes.
#include "MTReportStiff.h"

#include "MTReportContext.h"
#include "MTReportPage.h"
#include "MTReportParts.h"

#include "MTStiffCases.h"

#include "vtkMTPatchStore.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
using MTStiffCases::Verdict;
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

struct Measured
{
  const MTStiffCases::Case* Stiff;
  MTStiffStudy::Settings Settings;
  MTStiffStudy::Result Result;
  double Motion = NotMeasured; // see MTStiffStudy::CompareErrors
};

Measured Measure(const MTStiffCases::Case& stiff, bool isQuick)
{
  Measured measured{ &stiff, MTStiffCases::GetSettings(stiff), {}, NotMeasured };
  MTStiffStudy::Settings& settings = measured.Settings;
  const auto input = stiff.Make(isQuick ? stiff.Triangles : stiff.ReportTriangles);
  if (!isQuick)
  {
    settings.PatchTriangles = 250;
    settings.Samples = 20000;
    settings.Climbs = 100;
  }
  measured.Result = MTStiffStudy::Run(input, settings);
  // What is at the ends of the range of doubles, or not finite, cannot be turned; what has no errors, not compared.
  const double diagonal = measured.Result.Diagonal;
  if (measured.Result.Error.empty() && diagonal > 1e-290 && diagonal < 1e290)
  {
    MTStiffStudy::Settings moved = settings;
    moved.IsVerified = false;
    moved.SearchTriangles = 0;
    const auto turned = MTStiffMeshes::TurnAndMove(input, 1.1, { diagonal, -0.7 * diagonal, 0.3 * diagonal });
    const MTStiffStudy::Result other = MTStiffStudy::Run(turned, moved);
    measured.Motion = other.Error.empty() ? MTStiffStudy::CompareErrors(measured.Result, other) : NotMeasured;
  }
  return measured;
}

std::string GetAnswer(bool isTrue)
{
  return isTrue ? "yes" : "no";
}

void AddFigures(const std::vector<Measured>& all, MTReportSection& section)
{
  MTReportTable table("stiff", "Stiff and extreme cases: figures",
    { { "case", "" }, { "what", "" }, { "triangles", "" }, { "levels", "" },
      { "build", "CPU s", MTReportTable::Kind::Time }, { "coarsest cut", "triangles" },
      { "its worst place", "% of diagonal" }, { "worst place over certified", "" },
      { "certified over worst place", "" }, { "by patches' own distances", "" }, { "flipped", "%" },
      { "components kept", "" }, { "Euler number kept", "" }, { "intersections at level 0", "" }, { "made", "" },
      { "after a rigid motion", "factor" } });
  for (const Measured& measured : all)
  {
    const MTStiffStudy::Result& result = measured.Result;
    const bool isSearched = result.IsSearched && !result.Levels.empty();
    const auto ifSearched = [isSearched](double figure) { return isSearched ? figure : NotMeasured; };
    const auto ifPositive = [](double figure) { return figure > 0.0 ? figure : NotMeasured; };
    const auto ifCounted = [&](std::int64_t count) { return ifSearched(count < 0 ? NotMeasured : double(count)); };
    table.AddRow({ measured.Stiff->Name, measured.Stiff->What, result.InputTriangles, result.Levels.size(),
      result.Error.empty() ? result.CpuSeconds : NotMeasured, result.RootTriangles,
      ifSearched(100.0 * result.GetCoarsestShare()), ifSearched(result.GetViolation()),
      ifPositive(result.GetLooseness()), ifPositive(result.GetOwnLooseness()),
      ifSearched(100.0 * result.GetFlippedShare()), isSearched ? GetAnswer(result.KeepsComponents()) : "-",
      isSearched ? GetAnswer(result.KeepsEuler()) : "-",
      isSearched ? ifCounted(result.Levels[0].Topology.Intersections) : NotMeasured,
      ifCounted(result.GetMadeIntersections()), measured.Motion });
  }
  section.AddTable(table);
}

// Of a case, that of motions included.
std::vector<Verdict> GetVerdicts(const Measured& measured)
{
  std::vector<Verdict> verdicts = MTStiffCases::GetVerdicts(*measured.Stiff, measured.Settings, measured.Result);
  if (!std::isnan(measured.Motion))
  {
    verdicts.push_back({ "errors after a rigid motion, factor", measured.Motion, 2.0, 2.0 });
  }
  return verdicts;
}

void AddVerdicts(const std::vector<Measured>& all, MTReportSection& section)
{
  MTReportTable table("stiff_claims", "Stiff and extreme cases: claims and verdicts",
    { { "case", "" }, { "claim", "" }, { "figure", "" }, { "at most", "" }, { "verdict", "" } });
  for (const Measured& measured : all)
  {
    for (const Verdict& verdict : GetVerdicts(measured))
    {
      table.AddRow({ measured.Stiff->Name, verdict.Claim, verdict.Figure, verdict.Claimed,
        verdict.Holds() ? "holds" : "does not hold" });
    }
  }
  section.AddTable(table);
}

// For each kind of claim in how many cases it holds, and those where it holds least.
struct Kind
{
  std::string Name;
  int Cases = 0;
  std::vector<std::pair<double, std::string>> Failed; // figure, case

  std::string GetFigure() const
  {
    std::string text = std::to_string(this->Cases - static_cast<int>(this->Failed.size())) + " of " +
      std::to_string(this->Cases) + " cases";
    for (std::size_t i = 0; i < std::min<std::size_t>(8, this->Failed.size()); ++i)
    {
      text += (i == 0 ? "; not " : ", ") + this->Failed[i].second + " (" +
        MTReportTable::Shorten(this->Failed[i].first) + ")";
    }
    return text + (this->Failed.size() > 8 ? " and others" : "");
  }
};

std::vector<Kind> Collect(const std::vector<Measured>& all)
{
  std::vector<Kind> kinds;
  for (const Measured& measured : all)
  {
    for (const Verdict& verdict : GetVerdicts(measured))
    {
      auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& other) { return other.Name == verdict.Claim; });
      if (kind == kinds.end())
      {
        kind = kinds.insert(kinds.end(), Kind{ verdict.Claim, 0, {} });
      }
      ++kind->Cases;
      if (!verdict.Holds())
      {
        kind->Failed.emplace_back(verdict.Figure, measured.Stiff->Name);
      }
    }
  }
  for (Kind& kind : kinds)
  {
    std::sort(kind.Failed.rbegin(), kind.Failed.rend());
  }
  return kinds;
}

// A claim of verdicts as a sentence, and why it is known not to hold in every case; empty: it is to hold in all.
struct Sentence
{
  const char* Claim;
  const char* Text;
  const char* Reason;
};

const Sentence& GetSentence(const std::string& claim)
{
  static const Sentence sentences[] = {
    { "builds", "Every mesh is built", "" },
    { "is refused with the reason", "A mesh without triangles is refused with the reason", "" },
    { "verifies", "Every model verifies", "" },
    { "every number is finite", "Every number of a model is finite", "" },
    { "worst place over certified", "No place that is found is farther than what is certified for its patch or cut",
      "" },
    { "certified over worst place", "Certified errors are at most 5 times the worst place",
      "Needles that vanish in one region: its own patch is truly as far from them as they are long (worst place, own "
      "patch, "
      "over certified: 0.97), but needles of the regions beside lie there, so that the cut as a whole is near." },
    { "triangles of the coarsest cut, in targets", "The coarsest cut has at most 4 times the triangles of a region",
      "Where hardly an edge can be collapsed (strips without inner points, edges with many triangles, corners of "
      "cubes) "
      "coarse levels stay as they are." },
    { "largest error, in steps", "What is exactly flat has no error at any level",
      "On a slope a new vertex is rounded to the lattice next to the plane, and certified there." },
    { "share of flipped triangles", "No triangle faces away from the finest level beside it",
      "Where sheets are nearer to each other than the error, what is beside a triangle is often another sheet; where "
      "triangles grow from cell to cell or are slivers, some are turned over." },
    { "components change", "No level has other components than the finest one",
      "Whole small components are left out where the target cannot be reached with them (vtkMTComponentRemoval); how "
      "far "
      "away what is left is, is certified." },
    { "Euler number changes", "No level has another Euler number than the finest one", "As components." },
    { "intersections made", "No level has more triangles that cross each other than the finest one",
      "Triangles that share no corner are not held apart: sheets that are nearer than the error cross." },
    { "errors after a rigid motion, factor",
      "Turned and moved, median errors of levels are the same up to a factor of 2",
      "A mesh that is long along an axis lies on few planes of the lattice; turned it does not, and no edge is exactly "
      "collapsible any more. Loose bounds differ too." },
  };
  const auto* found = std::find_if(
    std::begin(sentences), std::end(sentences), [&](const Sentence& sentence) { return claim == sentence.Claim; });
  if (found == std::end(sentences))
  {
    throw std::logic_error("no sentence for the claim '" + claim + "'");
  }
  return *found;
}

void AddClaims(const std::vector<Measured>& all, MTReportSection& section)
{
  for (const Kind& kind : Collect(all))
  {
    const Sentence& sentence = GetSentence(kind.Name);
    if (*sentence.Reason)
    {
      section.AddKnownClaim(sentence.Text, kind.GetFigure(), kind.Failed.empty(), sentence.Reason);
    }
    else
    {
      section.AddClaim(sentence.Text, kind.GetFigure(), kind.Failed.empty());
    }
  }
}

// Powers of two, which are exact: the model is the same one bit for bit.
void AddScales(MTReportContext& context, MTReportSection& section)
{
  context.Say("powers of two");
  MTReportTable table("stiff_scales", "Models of meshes that are scaled by powers of two, beside the model at scale 1",
    { { "case", "" }, { "nodes", "" }, { "2^-996", "" }, { "2^-100", "" }, { "2^128", "" }, { "2^900", "" } });
  int same = 0;
  int compared = 0;
  for (const char* name :
    { "Double", "Graded", "RoughComb", "Spikes", "Fan", "TwoFans", "Crumpled", "Klein", "Barycentres" })
  {
    const auto input = MTStiffCases::FindCase(name)->Make(1000);
    vtkMTPatchStore plain;
    std::string error;
    MTStiffStudy::Build(input, {}, plain, error);
    std::vector<MTReportTable::Cell> row{ name, plain.GetGraph().Nodes.size() };
    for (const int power : { -996, -100, 128, 900 })
    {
      const double scale = std::ldexp(1.0, power);
      vtkMTPatchStore scaled;
      const bool isSame = MTStiffStudy::Build(MTStiffMeshes::Scale(input, scale, scale, scale), {}, scaled, error) &&
        MTStiffStudy::CompareScaled(plain, scaled, scale).empty();
      row.emplace_back(isSame ? "the same" : "another one");
      same += isSame ? 1 : 0;
      ++compared;
    }
    table.AddRow(row);
  }
  section.AddTable(table);
  section.AddClaim("A power of two changes no node, no patch and no error but by itself",
    std::to_string(same) + " of " + std::to_string(compared) + " models", same == compared);
}
}

//------------------------------------------------------------------------------
void MTReportStiff(MTReportContext& context, MTReportSection& section)
{
  section.AddText(
    "Meshes that are hard by their scale, proportions, thinness, topology or content. Each is built, verified, "
    "and searched for the worst place of every level's cut, in both directions: vertices, edges, barycentres, "
    "then hill climbing. What is found is a lower bound of the deviation: over certified it is at most 1 where "
    "the certified error holds; certified over found says how loose it is (over ten steps of the lattice "
    "where less was found). Flipped triangles face away from the finest level beside them. Components, Euler "
    "number and intersections are counted on the lattice with exact predicates.");
  std::vector<Measured> all;
  for (const MTStiffCases::Case& stiff : MTStiffCases::GetCases())
  {
    context.Say(std::string("case ") + stiff.Name);
    all.push_back(Measure(stiff, context.IsQuick()));
  }
  AddClaims(all, section);
  AddFigures(all, section);
  AddScales(context, section);
  MTReportStiffCurves(context, section);
  MTReportStiffOracle(context, section);
  AddVerdicts(all, section);
}
