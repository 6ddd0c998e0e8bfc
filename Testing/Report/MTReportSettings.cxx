// SPDX-License-Identifier: BSD-3-Clause
// What the settings of a build do to time and error: partition strategies, sizes of patches, and steps of the lattice,
// one at a time, everything else by default.
#include "MTReportContext.h"
#include "MTReportModel.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportReference.h"
#include "MTReportStrategies.h"
#include "MTReportTimes.h"

#include "vtkMTGraph.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{
using Kind = MTReportTable::Kind;

constexpr std::array<double, 2> Shares{ 0.125, 0.015625 };
constexpr int DefaultBits = 24;
constexpr int MostBits = 31;

struct Variant
{
  std::string Setting;
  std::string Value;
  double Number = 0.0; // of settings that are numbers
  MTReportModel::Configure Configure;

  vtkIdType Patches = 0;
  std::array<vtkIdType, Shares.size()> Triangles{};
  std::array<MTReportDeviation, Shares.size()> Deviations;
  std::array<double, Shares.size()> Certified{};
  MTReportTimes Times;
};

std::vector<Variant> MakeVariants(int patchTriangles)
{
  std::vector<Variant> variants;
  const auto add = [&variants](const std::string& setting, const std::string& value, double number, auto configure)
  {
    Variant& variant = variants.emplace_back();
    variant.Setting = setting;
    variant.Value = value;
    variant.Number = number;
    variant.Configure = configure;
  };
  for (const MTReportStrategy& strategy : MTReportGetStrategies())
  {
    add("partition", strategy.Name, 0.0,
      [&strategy](vtkMultiTriangulationBuilder* builder) { builder->SetPartitionStrategy(strategy.Strategy); });
  }
  for (const int triangles :
    { patchTriangles / 4, patchTriangles / 2, patchTriangles, 2 * patchTriangles, 4 * patchTriangles })
  {
    add("patch triangles", std::to_string(triangles), triangles,
      [triangles](vtkMultiTriangulationBuilder* builder) { builder->SetPatchTriangles(triangles); });
  }
  for (const int bits : { 12, 16, 20, DefaultBits, MostBits })
  {
    add("lattice bits", std::to_string(bits), bits,
      [bits](vtkMultiTriangulationBuilder* builder) { builder->SetLatticeBits(bits); });
  }
  return variants;
}

void Measure(MTReportContext& context, const MTReportMesh& mesh, const MTReportReference& reference, Variant& variant)
{
  const MTReportModel model(mesh.Data, context.GetPatchTriangles(), variant.Configure);
  variant.Patches = static_cast<vtkIdType>(model.GetGraph().Arcs.size());
  for (std::size_t i = 0; i < Shares.size(); ++i)
  {
    const double wanted = Shares[i] * static_cast<double>(reference.GetNumberOfTriangles());
    const MTReportCut cut = model.CutByTriangles(static_cast<vtkIdType>(wanted));
    variant.Triangles[i] = cut.Mesh->GetNumberOfCells();
    variant.Deviations[i] = reference.Measure(cut.Mesh, context.GetSamples());
    variant.Certified[i] = cut.Certified;
  }
}

std::vector<Variant> MeasureAll(MTReportContext& context, const MTReportMesh& mesh, const MTReportReference& reference)
{
  std::vector<Variant> variants = MakeVariants(context.GetPatchTriangles());
  for (Variant& variant : variants)
  {
    context.Say(mesh.Name + ": " + variant.Setting + " " + variant.Value);
    Measure(context, mesh, reference, variant);
  }
  for (int repeat = 0; repeat < MTReportContext::Repeats; ++repeat)
  {
    for (Variant& variant : variants)
    {
      variant.Times.Add(MTReportModel(mesh.Data, context.GetPatchTriangles(), variant.Configure).GetCpuSeconds());
    }
  }
  return variants;
}

void AddTable(const std::string& mesh, const std::string& name, const std::vector<Variant>& variants,
  const MTReportReference& reference, MTReportSection& section)
{
  MTReportTable table("settings-" + name,
    "Settings, " + mesh + ", cuts of 12.5 and 1.56 % of the triangles, distances in per cent of the diagonal",
    { { "setting", "" }, { "value", "" }, { "CPU time per input triangle", "us", Kind::Time },
      { "spread", "%", Kind::Time }, { "patches", "" }, { "triangles at 12.5 %", "" }, { "RMS", "%" },
      { "maximum", "%" }, { "certified", "%" }, { "normals, mean", "degrees" }, { "triangles at 1.56 %", "" },
      { "RMS at 1.56 %", "%" }, { "maximum at 1.56 %", "%" }, { "certified at 1.56 %", "%" },
      { "normals at 1.56 %, mean", "degrees" } });
  const double percent = 100.0 / reference.GetDiagonal();
  for (const Variant& variant : variants)
  {
    std::vector<MTReportTable::Cell> row{ variant.Setting, variant.Value,
      1e6 * variant.Times.GetMedian() / static_cast<double>(reference.GetNumberOfTriangles()),
      variant.Times.GetSpread(), variant.Patches };
    for (std::size_t i = 0; i < Shares.size(); ++i)
    {
      row.insert(row.end(),
        { variant.Triangles[i], percent * variant.Deviations[i].RootMeanSquare, percent * variant.Deviations[i].Maximum,
          percent * variant.Certified[i], variant.Deviations[i].NormalMean });
    }
    table.AddRow(row);
  }
  section.AddTable(table);
}

void AddCharts(const std::string& mesh, const std::string& name, const std::vector<Variant>& variants,
  const MTReportReference& reference, MTReportSection& section)
{
  const double percent = 100.0 / reference.GetDiagonal();
  const MTReportChart::Axis distance{ "distance at 12.5 % of the triangles [% of the diagonal]", true };
  MTReportChart patches(
    "settings-" + name + "-patch", "Size of patches, " + mesh, { "patch triangles", true }, distance);
  MTReportChart lattice("settings-" + name + "-lattice", "Step of the lattice, " + mesh,
    { "lattice bits: 2^bits steps on the longest side", false }, distance);
  for (const Variant& variant : variants)
  {
    if (variant.Number > 0.0)
    {
      MTReportChart& chart = variant.Setting == "lattice bits" ? lattice : patches;
      chart.AddPoint("RMS", variant.Number, percent * variant.Deviations[0].RootMeanSquare);
      chart.AddPoint("maximum", variant.Number, percent * variant.Deviations[0].Maximum);
      chart.AddPoint("certified", variant.Number, percent * variant.Certified[0]);
    }
  }
  section.AddChart(patches);
  section.AddChart(lattice);
}

const Variant& Find(const std::vector<Variant>& variants, const std::string& setting, double number)
{
  return *std::find_if(variants.begin(), variants.end(),
    [&](const Variant& variant) { return variant.Setting == setting && variant.Number == number; });
}
}

void MTReportSettings(MTReportContext& context, MTReportSection& section)
{
  section.AddText("One setting at a time, everything else by default (patches of " +
    std::to_string(context.GetPatchTriangles()) + " triangles in this run).");
  section.AddText(
    "The defaults that follow. Seeds along a curve: the errors of the strategies hardly differ, so what decides is "
    "that "
    "no region is larger than four times the target however uneven the mesh. 1000 triangles: smaller patches have more "
    "border that is locked while a region is simplified, and cost more time for each triangle; larger ones gain little "
    "and follow a view less closely. 2^24 steps: finer ones gain nothing, and coordinates relative to a patch are "
    "exact "
    "in single precision, as the GPU has them.");
  double lattice = 0.0;
  double certified = 1e300;
  int number = 0;
  for (const MTReportMesh& mesh : context.GetMeshes())
  {
    const MTReportReference reference(mesh.Data);
    const std::vector<Variant> variants = MeasureAll(context, mesh, reference);
    const std::string name = std::to_string(++number);
    AddTable(mesh.Name, name, variants, reference, section);
    AddCharts(mesh.Name, name, variants, reference, section);
    for (std::size_t i = 0; i < Shares.size(); ++i)
    {
      const double step = Find(variants, "lattice bits", DefaultBits).Deviations[i].RootMeanSquare;
      lattice = std::max(lattice, step / Find(variants, "lattice bits", MostBits).Deviations[i].RootMeanSquare);
      for (const Variant& variant : variants)
      {
        certified = std::min(certified, variant.Certified[i] / variant.Deviations[i].Maximum);
      }
    }
  }
  section.AddClaim("No setting makes a cut that is farther from its input than certified",
    "certified over sampled maximum: " + MTReportTable::Shorten(certified) + " at the least", certified >= 1.0);
  section.AddClaim("The step of the default lattice adds no more than 2 % to the RMS",
    MTReportTable::Shorten(lattice) + " times that of 2^31 steps at the most", lattice <= 1.02);
}
