// SPDX-License-Identifier: BSD-3-Clause
// Error against run time of drawing: a flight past a model at several pixel errors of each metric, beside the pictures
// of full resolution; and what VTK's own mappers and actors do on the same flight.
#include "MTReportContext.h"
#include "MTReportFlight.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportTimes.h"

#include "vtkMultiTriangulationMapper.h"

#include "vtkActor.h"
#include "vtkLODActor.h"
#include "vtkNew.h"
#include "vtkQuadricLODActor.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace
{
using Kind = MTReportTable::Kind;
using Figure = double MTReportDifference::*;

struct Metric
{
  const char* Name;
  int Type;
};
constexpr Metric Metrics[] = { { "distance", vtkMultiTriangulationMapper::DISTANCE },
  { "edge length", vtkMultiTriangulationMapper::EDGE_LENGTH },
  { "normal deviation", vtkMultiTriangulationMapper::NORMAL_DEVIATION } };
constexpr double PixelErrors[] = { 4.0, 2.0, 1.0, 0.5 };

double GetMean(const std::vector<double>& values)
{
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double GetMost(const std::vector<double>& values)
{
  return MTReportTimes::GetQuantile(values, 1.0);
}

std::vector<double> Collect(const std::vector<MTReportDifference>& differences, Figure figure)
{
  std::vector<double> values;
  for (const MTReportDifference& difference : differences)
  {
    values.push_back(difference.*figure);
  }
  return values;
}

double GetMilliseconds(const std::vector<double>& seconds, double share)
{
  return 1e3 * MTReportTimes::GetQuantile(seconds, share);
}

using Columns = std::vector<MTReportTable::Column>;
using Row = std::vector<MTReportTable::Cell>;

Columns GetDifferenceColumns(const std::string& of, Kind kind)
{
  return { { of + "RMS", "of 255", kind }, { of + "largest", "of 255", kind }, { of + "above 8", "%", kind },
    { of + "above 20", "%", kind }, { of + "SSIM", "", kind } };
}

Row GetDifferenceCells(const std::vector<MTReportDifference>& differences)
{
  return { GetMean(Collect(differences, &MTReportDifference::RootMeanSquare)),
    GetMost(Collect(differences, &MTReportDifference::Largest)),
    100.0 * GetMean(Collect(differences, &MTReportDifference::ShareAbove8)),
    100.0 * GetMean(Collect(differences, &MTReportDifference::ShareAbove20)),
    GetMean(Collect(differences, &MTReportDifference::Similarity)) };
}

template <class Value>
std::vector<Value> Join(std::vector<Value> first, const std::vector<Value>& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// What claims are judged by, over all flights.
struct Extremes
{
  double CertifiedOverAsked = 0.0; // by distance, most
  double OutlineOverAsked = 0.0;   // pixels beyond what was asked for, by distance, most
  bool FinerIsNearer = true;       // pictures, of each metric
  double CutShare = 0.0;           // of a frame's time, most of the medians
};

class Drawing
{
public:
  Drawing(MTReportContext& context, const MTReportMesh& mesh, std::string name, MTReportSection& section)
    : Context(context)
    , Mesh(mesh.Name)
    , Name(std::move(name))
    , Section(section)
    , Flight(context, mesh)
  {
  }

  void Run(Extremes& extremes)
  {
    this->FlyModels(extremes);
    this->FlyActors();
  }

  void AddPictures()
  {
    const std::string file = "drawing-" + this->Name + "-pictures.png";
    this->Flight.WritePictures(2.0, this->Context.GetFolder() + "/" + file);
    this->Section.AddPicture(file, this->Mesh + ": full resolution above, two pixels of distance below");
  }

private:
  void FlyModels(Extremes& extremes)
  {
    MTReportTable table("drawing-" + this->Name,
      "Drawing, " + this->Mesh + ": a flight beside pictures of full resolution",
      Join(Join(Columns{ { "metric", "" }, { "pixel error", "" }, { "triangles, mean", "" },
                  { "frame, median", "CPU ms", Kind::Time }, { "frame, 95 %", "CPU ms", Kind::Time },
                  { "cut, median", "ms", Kind::Time }, { "certified, most", "pixels" }, { "outline, most", "pixels" } },
             GetDifferenceColumns("", Kind::Figure)),
        GetDifferenceColumns("popping, ", Kind::Figure)));
    const MTReportChart::Axis triangles{ "triangles, mean over the flight", true };
    const MTReportChart::Axis rms{ "RMS of the picture [of 255]", true };
    MTReportChart byTime("drawing-" + this->Name + "-time", "Picture against time, " + this->Mesh,
      { "CPU time of a frame, median [ms]", false }, rms);
    MTReportChart byTriangles(
      "drawing-" + this->Name + "-triangles", "Picture against triangles, " + this->Mesh, triangles, rms);
    MTReportChart popping(
      "drawing-" + this->Name + "-popping", "Popping, " + this->Mesh, triangles, { "RMS of popping [of 255]", true });
    for (const Metric& metric : Metrics)
    {
      double last = std::numeric_limits<double>::infinity();
      for (const double pixels : PixelErrors)
      {
        this->Context.Say(this->Mesh + ": " + metric.Name + ", " + MTReportTable::Shorten(pixels) + " pixels");
        const MTReportFrames frames = this->Flight.FlyModel(metric.Type, pixels);
        const double picture = GetMean(Collect(frames.Differences, &MTReportDifference::RootMeanSquare));
        const double shown = GetMean(frames.Triangles);
        table.AddRow(this->MakeRow(metric.Name, pixels, frames));
        byTime.AddPoint(metric.Name, GetMilliseconds(frames.FrameSeconds, 0.5), picture);
        byTriangles.AddPoint(metric.Name, shown, picture);
        popping.AddPoint(metric.Name, shown, GetMean(Collect(frames.Popping, &MTReportDifference::RootMeanSquare)));
        extremes.FinerIsNearer = extremes.FinerIsNearer && picture <= last;
        last = picture;
        Judge(metric, pixels, frames, extremes);
      }
    }
    this->Section.AddTable(table);
    this->Section.AddChart(byTime);
    this->Section.AddChart(byTriangles);
    this->Section.AddChart(popping);
  }

  static Row MakeRow(const char* metric, double pixels, const MTReportFrames& frames)
  {
    const Row row{ metric, pixels, GetMean(frames.Triangles), GetMilliseconds(frames.FrameSeconds, 0.5),
      GetMilliseconds(frames.FrameSeconds, 0.95), GetMilliseconds(frames.CutSeconds, 0.5),
      GetMost(frames.CertifiedPixels), GetMost(Collect(frames.Differences, &MTReportDifference::Outline)) };
    return Join(Join(row, GetDifferenceCells(frames.Differences)), GetDifferenceCells(frames.Popping));
  }

  static void Judge(const Metric& metric, double pixels, const MTReportFrames& frames, Extremes& extremes)
  {
    extremes.CutShare = std::max(extremes.CutShare,
      MTReportTimes::GetQuantile(frames.CutSeconds, 0.5) / MTReportTimes::GetQuantile(frames.FrameSeconds, 0.5));
    if (metric.Type == vtkMultiTriangulationMapper::DISTANCE)
    {
      extremes.CertifiedOverAsked = std::max(extremes.CertifiedOverAsked, GetMost(frames.CertifiedPixels) / pixels);
      extremes.OutlineOverAsked = std::max(
        extremes.OutlineOverAsked, GetMost(Collect(frames.Differences, &MTReportDifference::Outline)) - pixels);
    }
  }

  // Which coarse mesh they draw depends on the clock, and so do all figures.
  void FlyActors()
  {
    MTReportTable table("drawing-" + this->Name + "-actors",
      "The same flight by VTK's mapper and actors, " + this->Mesh +
        ", in a window that asks for many frames per second",
      Join(Columns{ { "drawn by", "" }, { "frame, median", "CPU ms", Kind::Time },
             { "frame, 95 %", "CPU ms", Kind::Time } },
        GetDifferenceColumns("", Kind::Time)));
    const auto add = [&table](const char* name, const MTReportFrames& frames)
    {
      const Row row{ name, GetMilliseconds(frames.FrameSeconds, 0.5), GetMilliseconds(frames.FrameSeconds, 0.95) };
      table.AddRow(Join(row, GetDifferenceCells(frames.Differences)));
    };
    constexpr double ManyFrames = 1e6;
    vtkNew<vtkActor> plain;
    add("vtkPolyDataMapper, full resolution", this->Flight.FlyMesh(plain, 0.0));
    vtkNew<vtkQuadricLODActor> quadric;
    add("vtkQuadricLODActor", this->Flight.FlyMesh(quadric, ManyFrames));
    vtkNew<vtkLODActor> lod;
    add("vtkLODActor", this->Flight.FlyMesh(lod, ManyFrames));
    this->Section.AddTable(table);
  }

  MTReportContext& Context;
  const std::string Mesh;
  const std::string Name;
  MTReportSection& Section;
  const MTReportFlight Flight;
};

void AddClaims(const Extremes& extremes, MTReportSection& section)
{
  const auto show = [](double number) { return MTReportTable::Shorten(number); };
  section.AddClaim("By distance, no frame is certified worse than its pixel error",
    show(extremes.CertifiedOverAsked) + " of what was asked for, at the most", extremes.CertifiedOverAsked <= 1.0);
  section.AddClaim("By distance, no outline is off by more than the pixel error and one pixel, which is how pixels are "
                   "sampled",
    show(extremes.OutlineOverAsked) + " pixels beyond the pixel error, at the most", extremes.OutlineOverAsked <= 1.0);
  section.AddClaim(
    "A smaller pixel error gives a nearer picture, by every metric", "RMS over the flight", extremes.FinerIsNearer);
  section.AddClaim("Finding the cut takes less than a tenth of a frame",
    show(100.0 * extremes.CutShare) + " % of the median frame's CPU time, at the most", extremes.CutShare < 0.1);
}
}

void MTReportDrawing(MTReportContext& context, MTReportSection& section)
{
  section.AddText(
    "A flight from afar to the surface, along it and back. Every frame of a cut is compared with the picture of the "
    "finest level in a vtkPolyDataMapper, over the pixels that show the model in either one: RMS and SSIM are means "
    "over "
    "the flight, largest is of all frames, above 8 and above 20 are shares of pixels that differ by more grey levels. "
    "Popping is what the change of the cut alone does to the picture: the cut of the frame before and that of the "
    "frame, seen from the same place. Outline: the farthest that a pixel which shows the model in one picture is from "
    "one that does in the other. Drawing is by software here, so CPU time is what a frame costs. Models for "
    "normal deviation are built with certified normals, whose distances are sums of steps and looser. Where the "
    "differences of one of VTK's actors are zero, it drew full resolution: vtkLODActor goes by the time that commands "
    "to "
    "OpenGL take and not by that of drawing.");
  Extremes extremes;
  int number = 0;
  for (const MTReportMesh& mesh : context.GetMeshes())
  {
    Drawing drawing(context, mesh, std::to_string(++number), section);
    if (number == 1)
    {
      drawing.AddPictures();
    }
    drawing.Run(extremes);
  }
  AddClaims(extremes, section);
}
