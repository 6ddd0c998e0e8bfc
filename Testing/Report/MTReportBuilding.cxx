// SPDX-License-Identifier: BSD-3-Clause
// Error against run time of building: cuts of Multi-Triangulations beside whole meshes, simplified by ourselves and by
// others to as many triangles.
#include "MTReportContext.h"
#include "MTReportModel.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportReference.h"
#include "MTReportTimes.h"
#include "MTReportYardsticks.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace
{
using Kind = MTReportTable::Kind;

constexpr const char* Simplifiers[] = { "fast", "best", "lindstrom-turk", "garland-heckbert" };
constexpr std::array<double, 3> Shares{ 0.25, 0.0625, 0.015625 };
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

// One method at one number of triangles.
struct Result
{
  std::string Method;
  bool IsCut = false; // of patches
  double Share = 0.0;
  vtkIdType Triangles = 0;
  MTReportDeviation Deviation;
  double Certified = NotMeasured;
  MTReportTimes Times;
};

// All methods on one mesh.
class Contest
{
public:
  Contest(MTReportContext& context, const MTReportMesh& mesh)
    : Context(context)
    , Mesh(mesh)
    , Reference(mesh.Data)
  {
  }

  void Run()
  {
    for (const char* simplifier : Simplifiers)
    {
      this->PrepareSimplifier(simplifier);
    }
    for (std::size_t i = 0; i < Shares.size(); ++i)
    {
      const vtkIdType triangles = this->Results[i].Triangles; // those that the cut of "fast" has
      for (const MTReportYardsticks::Yardstick& other : MTReportYardsticks::GetOthers())
      {
        this->PrepareWhole(other.Name, Shares[i], other.Prepare(this->Mesh.Data, triangles));
      }
    }
    this->TakeTimes();
  }

  double GetDiagonal() const { return this->Reference.GetDiagonal(); }
  double GetNumberOfTriangles() const { return static_cast<double>(this->Reference.GetNumberOfTriangles()); }

  const Result& Find(const std::string& method, bool isCut, double share) const
  {
    return *std::find_if(this->Results.begin(), this->Results.end(),
      [&](const Result& result) { return result.Method == method && result.IsCut == isCut && result.Share == share; });
  }

  std::vector<Result> Results;

private:
  // Something that is done in every turn, and the results that it is the time of.
  struct Turn
  {
    std::function<void()> Work;
    std::vector<std::size_t> Results;
  };

  std::size_t Add(const std::string& method, bool isCut, double share, vtkPolyData* mesh)
  {
    Result result;
    result.Method = method;
    result.IsCut = isCut;
    result.Share = share;
    result.Triangles = mesh->GetNumberOfCells();
    result.Deviation = this->Reference.Measure(mesh, this->Context.GetSamples());
    this->Results.push_back(result);
    return this->Results.size() - 1;
  }

  // Its cuts, and the whole mesh simplified by it to as many triangles as each of them has.
  void PrepareSimplifier(const std::string& simplifier)
  {
    this->Context.Say(this->Mesh.Name + ": " + simplifier);
    const auto build = [this, simplifier]
    {
      return MTReportModel(this->Mesh.Data,
        [&simplifier](vtkMultiTriangulationBuilder* builder)
        {
          vtkNew<vtkMTEdgeCollapse> collapse;
          collapse->SetModeByName(simplifier.c_str());
          builder->SetSimplifier(collapse);
        });
    };
    const MTReportModel model = build();
    Turn turn{ build, {} };
    for (const double share : Shares)
    {
      const MTReportCut cut = model.CutByTriangles(static_cast<vtkIdType>(share * this->GetNumberOfTriangles()));
      turn.Results.push_back(this->Add(simplifier, true, share, cut.Mesh));
      this->Results.back().Certified = cut.Certified;
    }
    for (const std::size_t cut : turn.Results)
    {
      this->PrepareWhole(simplifier, this->Results[cut].Share,
        MTReportYardsticks::PrepareOwn(simplifier, this->Mesh.Data, this->Results[cut].Triangles));
    }
    this->Turns.push_back(turn);
  }

  void PrepareWhole(const std::string& method, double share, const MTReportYardsticks::Work& work)
  {
    this->Turns.push_back({ work, { this->Add(method, false, share, work()) } });
  }

  void TakeTimes()
  {
    for (int repeat = 0; repeat < this->Context.GetRepeats(); ++repeat)
    {
      this->Context.Say(this->Mesh.Name + ": times, turn " + std::to_string(repeat + 1));
      for (const Turn& turn : this->Turns)
      {
        MTReportTimes once;
        once.Measure(turn.Work);
        for (const std::size_t result : turn.Results)
        {
          this->Results[result].Times.Add(once.GetMedian());
        }
      }
    }
  }

  MTReportContext& Context;
  const MTReportMesh& Mesh;
  const MTReportReference Reference;
  std::vector<Turn> Turns;
};

std::string GetLabel(const Result& result)
{
  const bool isOwn = std::find(std::begin(Simplifiers), std::end(Simplifiers), result.Method) != std::end(Simplifiers);
  return !isOwn ? result.Method : result.Method + (result.IsCut ? ", patches" : ", whole mesh");
}

void AddTable(const std::string& mesh, const Contest& contest, const std::string& name, MTReportSection& section)
{
  MTReportTable table("building-" + name,
    "Building, " + mesh + ", distances in per cent of the bounding box's diagonal",
    { { "method", "" }, { "share asked", "%" }, { "triangles", "" },
      { "CPU time per input triangle", "us", Kind::Time }, { "spread", "%", Kind::Time }, { "RMS", "%" },
      { "maximum", "%" }, { "certified", "%" }, { "normals, mean", "degrees" }, { "normals, 95 %", "degrees" } });
  const double percent = 100.0 / contest.GetDiagonal();
  for (const Result& result : contest.Results)
  {
    table.AddRow({ GetLabel(result), 100.0 * result.Share, result.Triangles,
      1e6 * result.Times.GetMedian() / contest.GetNumberOfTriangles(), result.Times.GetSpread(),
      percent * result.Deviation.RootMeanSquare, percent * result.Deviation.Maximum, percent * result.Certified,
      result.Deviation.NormalMean, result.Deviation.Normal95 });
  }
  section.AddTable(table);
}

void AddCharts(const std::string& mesh, const Contest& contest, const std::string& name, MTReportSection& section)
{
  const MTReportChart::Axis time{ "CPU time [us per input triangle]", true };
  const MTReportChart::Axis triangles{ "triangles", true };
  MTReportChart byTime(
    "building-" + name + "-time", "RMS against CPU time, " + mesh, time, { "RMS [% of the diagonal]", true });
  MTReportChart byTriangles(
    "building-" + name + "-rms", "RMS against triangles, " + mesh, triangles, { "RMS [% of the diagonal]", true });
  MTReportChart certified("building-" + name + "-certified", "Certified and sampled maximum of cuts, " + mesh,
    triangles, { "distance [% of the diagonal]", true });
  const double percent = 100.0 / contest.GetDiagonal();
  for (const Result& result : contest.Results)
  {
    const double rms = percent * result.Deviation.RootMeanSquare;
    byTime.AddPoint(GetLabel(result), 1e6 * result.Times.GetMedian() / contest.GetNumberOfTriangles(), rms);
    byTriangles.AddPoint(GetLabel(result), static_cast<double>(result.Triangles), rms);
    if (result.IsCut)
    {
      const auto x = static_cast<double>(result.Triangles);
      certified.AddPoint(result.Method + ", certified", x, percent * result.Certified);
      certified.AddPoint(result.Method + ", sampled", x, percent * result.Deviation.Maximum);
    }
  }
  section.AddChart(byTime);
  section.AddChart(byTriangles);
  section.AddChart(certified);
}

// What claims are judged by, over all meshes.
struct Extremes
{
  double LeastCertified = std::numeric_limits<double>::infinity(); // over the sampled maximum
  double MostCertified = 0.0;
  double PatchCost = 0.0;    // RMS of a cut of "fast" over that of the whole mesh, largest
  double FastOverBest = 0.0; // RMS, largest
  double FastTime = 0.0;     // CPU time of "fast" over that of the quickest of the others that are ours, largest
  double RmsOfMeshopt = 0.0; // RMS of a cut of "fast" over meshoptimizer's, largest

  void Add(const Contest& contest)
  {
    for (const Result& result : contest.Results)
    {
      if (result.IsCut && result.Deviation.Maximum > 0.0)
      {
        const double ratio = result.Certified / result.Deviation.Maximum;
        this->LeastCertified = std::min(this->LeastCertified, ratio);
        this->MostCertified = std::max(this->MostCertified, ratio);
      }
    }
    for (const double share : Shares)
    {
      const Result& fast = contest.Find("fast", true, share);
      const auto getRatio = [&](const std::string& method, bool isCut)
      { return fast.Deviation.RootMeanSquare / contest.Find(method, isCut, share).Deviation.RootMeanSquare; };
      this->PatchCost = std::max(this->PatchCost, getRatio("fast", false));
      this->FastOverBest = std::max(this->FastOverBest, getRatio("best", true));
      this->RmsOfMeshopt = std::max(this->RmsOfMeshopt, getRatio("meshoptimizer", false));
      for (const char* other : { "best", "lindstrom-turk", "garland-heckbert" })
      {
        this->FastTime =
          std::max(this->FastTime, fast.Times.GetMedian() / contest.Find(other, true, share).Times.GetMedian());
      }
    }
  }
};

void AddClaims(const Extremes& extremes, MTReportSection& section)
{
  const auto show = MTReportTable::Shorten;
  section.AddClaim("No cut is farther from its input than certified",
    "certified over sampled maximum: " + show(extremes.LeastCertified) + " at the least",
    extremes.LeastCertified >= 1.0);
  section.AddClaim("Building with \"fast\" takes less time than with any other simplifier",
    show(extremes.FastTime) + " of the quickest other one's CPU time", extremes.FastTime < 1.0);
}
}

void MTReportBuilding(MTReportContext& context, MTReportSection& section)
{
  section.AddText("text");
  Extremes extremes;
  int number = 0;
  for (const MTReportMesh& mesh : context.GetMeshes())
  {
    Contest contest(context, mesh);
    contest.Run();
    const std::string name = std::to_string(++number);
    AddTable(mesh.Name, contest, name, section);
    AddCharts(mesh.Name, contest, name, section);
    extremes.Add(contest);
  }
  AddClaims(extremes, section);
}
