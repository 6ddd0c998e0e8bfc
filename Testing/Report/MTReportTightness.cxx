// SPDX-License-Identifier: BSD-3-Clause
// How far certified errors are above the true ones, against the time that a build takes: by the number of levels below
// a fragment that the mesh is which its errors are held against (bmt build --direct-levels).
#include "MTReportContext.h"
#include "MTReportModel.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportReference.h"
#include "MTReportTimes.h"

#include "vtkMTGraph.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace
{
using Kind = MTReportTable::Kind;

constexpr int DirectLevels[] = { 1, 2, 3, 4, 5, 6, 8 };
constexpr int Default = 5;

struct Tightness
{
  int Levels = 0;
  MTReportTimes Times;
  std::vector<double> Ratios; // of whole levels from 1 on: certified over sampled maximum
};

MTReportModel Build(const MTReportContext& context, const MTReportMesh& mesh, int levels)
{
  return MTReportModel(mesh.Data, context.GetPatchTriangles(),
    [levels](vtkMultiTriangulationBuilder* builder) { builder->SetDirectLevels(levels); });
}

std::vector<Tightness> Measure(MTReportContext& context, const MTReportMesh& mesh)
{
  const MTReportReference reference(mesh.Data);
  std::vector<Tightness> all;
  for (const int levels : DirectLevels)
  {
    context.Say(mesh.Name + ": direct levels " + std::to_string(levels));
    Tightness& tightness = all.emplace_back();
    tightness.Levels = levels;
    const MTReportModel model = Build(context, mesh, levels);
    for (std::uint32_t level = 1; level < model.GetGraph().GetNumberOfLevels(); ++level)
    {
      const MTReportCut cut = model.CutByLevel(level);
      // Of every model its own: points are rounded by the errors that are certified.
      tightness.Ratios.push_back(cut.Certified / reference.Measure(cut.Mesh, context.GetSamples()).Maximum);
    }
  }
  for (int repeat = 0; repeat < MTReportContext::Repeats; ++repeat)
  {
    for (Tightness& tightness : all)
    {
      tightness.Times.Add(Build(context, mesh, tightness.Levels).GetCpuSeconds());
    }
  }
  return all;
}

void Report(const MTReportMesh& mesh, const std::vector<Tightness>& all, MTReportTable& table, MTReportChart& chart)
{
  for (const Tightness& one : all)
  {
    const double median = MTReportTimes::GetQuantile(one.Ratios, 0.5);
    const double largest = MTReportTimes::GetQuantile(one.Ratios, 1.0);
    const double time = 1e6 * one.Times.GetMedian() / static_cast<double>(mesh.Data->GetNumberOfCells());
    table.AddRow({ mesh.Name, one.Levels, time, one.Times.GetSpread(), one.Times.GetMedian() / all[0].Times.GetMedian(),
      MTReportTimes::GetQuantile(one.Ratios, 0.0), median, largest });
    chart.AddPoint(mesh.Name + ", median", time, median);
    chart.AddPoint(mesh.Name + ", largest", time, largest);
  }
}
}

void MTReportTightness(MTReportContext& context, MTReportSection& section)
{
  section.AddText(
    "A build's errors are sums over its steps, or, where that is smaller, direct bounds against the mesh so many "
    "levels "
    "below (bmt build --direct-levels; 1: sums alone). A looser bound draws more triangles than a view needs. The "
    "ratios "
    "are those of whole levels from 1 on; the sampled maximum is a lower bound of the true one, so they are upper "
    "bounds. "
    "The default is 5: the median does not fall any more from 3 on, the largest does, and a model is built once and "
    "drawn often.");
  MTReportTable table("tightness", "Certified error of whole levels over the sampled maximum",
    { { "mesh", "" }, { "direct levels", "" }, { "CPU time per input triangle", "us", Kind::Time },
      { "spread", "%", Kind::Time }, { "over that of sums", "", Kind::Time }, { "ratio, least", "" },
      { "median of levels", "" }, { "largest", "" } });
  MTReportChart chart("tightness", "Tightness against build time: 1, 2, 3, 4, 5, 6 and 8 levels",
    { "CPU time [us per input triangle]", false }, { "certified over sampled maximum", false });
  double least = 1e300;
  double median = 0.0;
  for (const MTReportMesh& mesh : context.GetMeshes())
  {
    const std::vector<Tightness> all = Measure(context, mesh);
    Report(mesh, all, table, chart);
    for (const Tightness& one : all)
    {
      least = std::min(least, MTReportTimes::GetQuantile(one.Ratios, 0.0));
      median = std::max(median, one.Levels == Default ? MTReportTimes::GetQuantile(one.Ratios, 0.5) : 0.0);
    }
  }
  section.AddTable(table);
  section.AddChart(chart);
  section.AddClaim("Whole levels are never farther from the input than certified, whatever the errors are held against",
    "certified over sampled maximum: " + MTReportTable::Shorten(least) + " at the least", least >= 1.0);
  section.AddClaim(
    "By default the certified error of a whole level is at most 1.5 times the sampled one, in the median",
    MTReportTable::Shorten(median) + " on the worst mesh", median <= 1.5);
}
