// SPDX-License-Identifier: BSD-3-Clause
// Build rate, memory and the cost of a cut against the size of the model and the number of threads; and the tightness
// of certified errors against build time. The defaults follow from these.
#include "MTReportContext.h"
#include "MTReportMemory.h"
#include "MTReportMeshes.h"
#include "MTReportModel.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportTimes.h"

#include "vtkMTGraph.h"
#include "vtkMTTargetCut.h"
#include "vtkMTView.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace
{
using Kind = MTReportTable::Kind;

// Looks along -z at the origin, at a picture of 1920 x 1080 pixels with an angle of view of 30 degrees.
vtkMTView LookFrom(double distance)
{
  constexpr double Height = 1080.0;
  const double tangent = std::tan(3.14159265358979323846 / 12.0);
  vtkMTView view;
  view.ModelToEye[11] = -distance;
  view.PixelsPerUnit = 0.5 * Height / tangent;
  view.HalfSize = { tangent * 1920.0 / Height, tangent };
  view.Near = 0.01;
  return view;
}

struct CutCost
{
  std::uint64_t Triangles = 0;
  MTReportTimes Times;
};

CutCost MeasureCut(const vtkMTGraph& graph, double distance)
{
  CutCost cost;
  vtkMTTargetCut target;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Views = { LookFrom(distance) };
  for (int i = 0; i < 25; ++i)
  {
    cost.Times.Measure([&] { cost.Triangles = target.Extract(input, {}).Triangles; });
  }
  return cost;
}

// Of a sphere whose radius is about 1.3: far, it is a tenth of the picture high, near, a bit more than half.
constexpr double FarView = 50.0;
constexpr double NearView = 9.0;

struct Size
{
  double Triangles = 0.0;
  MTReportTimes Cpu;
  MTReportTimes Wall;
  double Memory = 0.0;
  bool IsSame = true; // as with one thread
  CutCost Far;
  CutCost Near;
};

std::vector<double> GetErrors(const vtkMTGraph& graph)
{
  std::vector<double> errors;
  std::transform(graph.Nodes.begin(), graph.Nodes.end(), std::back_inserter(errors),
    [](const vtkMTNode& node) { return node.Error; });
  return errors;
}

Size MeasureSize(vtkPolyData* mesh, int threads, int repeats, std::vector<double>& errorsOfOneThread)
{
  Size size;
  size.Triangles = static_cast<double>(mesh->GetNumberOfCells());
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    const MTReportMemory memory;
    const auto begin = std::chrono::steady_clock::now();
    const MTReportModel model(mesh, MTReportModel::DefaultPatchTriangles,
      [threads](vtkMultiTriangulationBuilder* builder) { builder->SetNumberOfThreads(threads); });
    size.Wall.Add(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    size.Cpu.Add(model.GetCpuSeconds());
    size.Memory = std::max(size.Memory, memory.GetPeak());
    if (repeat == 0)
    {
      const std::vector<double> errors = GetErrors(model.GetGraph());
      errorsOfOneThread = errorsOfOneThread.empty() ? errors : errorsOfOneThread;
      size.IsSame = errors == errorsOfOneThread;
      size.Far = MeasureCut(model.GetGraph(), FarView);
      size.Near = MeasureCut(model.GetGraph(), NearView);
    }
  }
  return size;
}

std::vector<int> GetThreads()
{
  std::vector<int> threads{ 1 };
  while (2 * threads.back() <= static_cast<int>(std::thread::hardware_concurrency()) && threads.back() < 16)
  {
    threads.push_back(2 * threads.back());
  }
  return threads;
}

void AddClaims(const std::vector<Size>& sizes, MTReportSection& section)
{
  const auto getSpread = [&sizes](CutCost Size::*view)
  {
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end(),
      [view](const Size& a, const Size& b) { return (a.*view).Triangles < (b.*view).Triangles; });
    return static_cast<double>(((*most).*view).Triangles) / static_cast<double>(((*least).*view).Triangles);
  };
  section.AddClaim("Builds with any number of threads give the same errors, to the last bit",
    std::to_string(sizes.size()) + " builds",
    std::all_of(sizes.begin(), sizes.end(), [](const Size& size) { return size.IsSame; }));
  const double spread = getSpread(&Size::Far);
  section.AddClaim(
    "A view from afar, within one pixel, takes triangles of one level more or less, whatever the model's size",
    MTReportTable::Shorten(spread) + " times the fewest", spread <= 2.05);
  section.AddKnownClaim(
    "A view from afar, within one pixel, takes at most 1.5 times the triangles, whatever the model's size",
    MTReportTable::Shorten(spread) + " times the fewest", spread <= 1.5,
    "errors of all regions of a level are about the same, so a sphere that is seen as a whole changes by whole levels");
}

void ReportSizes(MTReportContext& context, MTReportSection& section)
{
  MTReportTable table("scaling-size", "Fractal spheres built in memory, and cuts within one certified pixel",
    { { "triangles", "" }, { "threads", "" }, { "CPU time per triangle", "us", Kind::Time },
      { "spread", "%", Kind::Time }, { "wall time per triangle", "us", Kind::Time },
      { "peak memory per triangle", "bytes", Kind::Time }, { "triangles, far view", "" },
      { "its cut", "CPU us", Kind::Time }, { "triangles, near view", "" }, { "its cut, near", "CPU us", Kind::Time } });
  MTReportChart rate(
    "scaling-rate", "Building against size", { "triangles", true }, { "time [us per triangle]", false });
  MTReportChart cuts("scaling-cut", "Finding a cut against size", { "triangles", true }, { "CPU time [us]", true });
  std::vector<Size> sizes;
  const std::vector<int> counts =
    context.IsQuick() ? std::vector<int>{ 20480, 81920, 327680 } : std::vector<int>{ 81920, 327680, 1310720, 5242880 };
  for (const int triangles : counts)
  {
    const auto mesh = MTReportMeshes::MakeFractalSphere(triangles);
    std::vector<double> errors;
    for (const int threads : GetThreads())
    {
      context.Say(std::to_string(triangles) + " triangles, " + std::to_string(threads) + " threads");
      const int repeats = triangles > 300000 && context.IsQuick() ? 1 : triangles > 2000000 ? 1 : 3;
      const Size size = MeasureSize(mesh, threads, repeats, errors);
      const double perTriangle = 1e6 / size.Triangles;
      table.AddRow({ size.Triangles, threads, perTriangle * size.Cpu.GetMedian(),
        repeats > 1 ? size.Cpu.GetSpread() : std::numeric_limits<double>::quiet_NaN(),
        perTriangle * size.Wall.GetMedian(), size.Memory / size.Triangles, size.Far.Triangles,
        1e6 * size.Far.Times.GetMedian(), size.Near.Triangles, 1e6 * size.Near.Times.GetMedian() });
      const std::string label = std::to_string(threads) + (threads == 1 ? " thread" : " threads");
      rate.AddPoint("CPU, " + label, size.Triangles, perTriangle * size.Cpu.GetMedian());
      rate.AddPoint("wall, " + label, size.Triangles, perTriangle * size.Wall.GetMedian());
      if (threads == 1)
      {
        cuts.AddPoint("far view", size.Triangles, 1e6 * size.Far.Times.GetMedian());
        cuts.AddPoint("near view", size.Triangles, 1e6 * size.Near.Times.GetMedian());
      }
      sizes.push_back(size);
    }
  }
  section.AddTable(table);
  section.AddChart(rate);
  section.AddChart(cuts);
  AddClaims(sizes, section);
}
}

void MTReportScaling(MTReportContext& context, MTReportSection& section)
{
  section.AddText(
    "Builds of fractal spheres with default settings. CPU time is that of all threads, memory what the process holds "
    "at "
    "most beyond the input, as Linux counts it. All patches stay in memory here; bmt build works within a limit and "
    "keeps "
    "the rest in files. Cuts are found for a picture of 1920 x 1080 pixels, at one pixel of certified distance, "
    "without "
    "drawing them. A cut should cost what it shows and not what the model holds. Wall times depend on what else the "
    "machine does.");
  ReportSizes(context, section);
}
