// SPDX-License-Identifier: BSD-3-Clause
#include "bmtClosestPoint.h"
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtSampling.h"
#include "bmtSurface.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
struct Options
{
  std::string A;
  std::string B;
  bmtInput Input; // what holds for both
  std::uint64_t Samples = 1000000;
  std::uint64_t Seed = 1;
};

bmtSurface ReadSurface(const std::string& path, bmtInput input)
{
  input.Paths = { path };
  return bmtReadSurface(input);
}

struct OneSided
{
  double Maximum = 0.0;    // over samples and vertices
  double MeanSquare = 0.0; // over the samples, which are area weighted
  std::size_t Samples = 0;
  std::size_t Vertices = 0;
};

// Samples are taken and measured in turns, so that memory does not grow with their number.
constexpr std::size_t SamplesPerTurn = 1 << 20;

void MeasureSamples(
  const bmtSurface& from, const bmtClosestPoint& to, const Options& options, const char* progress, OneSided& result)
{
  const bmtSampler sampler(from, options.Samples, options.Seed);
  std::vector<double> distances;
  double sum = 0.0;
  for (std::size_t first = 0; first < sampler.GetCount(); first += SamplesPerTurn)
  {
    to.Measure(sampler.Take(first, first + SamplesPerTurn).Points, distances, nullptr, progress);
    for (double distance : distances)
    {
      result.Maximum = std::max(result.Maximum, distance);
      sum += distance * distance;
    }
    result.Samples += distances.size();
  }
  result.MeanSquare = result.Samples > 0 ? sum / static_cast<double>(result.Samples) : 0.0;
}

void MeasureVertices(const bmtSurface& from, const bmtClosestPoint& to, const char* progress, OneSided& result)
{
  std::vector<double> distances;
  to.Measure(from.GetUsedPoints(), distances, nullptr, progress);
  double sum = 0.0;
  for (double distance : distances)
  {
    result.Maximum = std::max(result.Maximum, distance);
    sum += distance * distance;
  }
  result.Vertices = distances.size();
  if (result.Samples == 0) // a surface without area: its vertices are all there is
  {
    result.MeanSquare = sum / static_cast<double>(distances.size());
  }
}

OneSided MeasureOneSided(const bmtSurface& from, const bmtSurface& target, const Options& options, const char* progress)
{
  const bmtClosestPoint to(target);
  OneSided result;
  MeasureSamples(from, to, options, progress, result);
  MeasureVertices(from, to, progress, result);
  return result;
}

bmtJson Compare(const Options& options)
{
  bmtSurface a = ReadSurface(options.A, options.Input);
  bmtSurface b = ReadSurface(options.B, options.Input);
  bmtBounds bounds = a.GetBounds();
  bounds.Add(b.GetBounds());
  const bmtFrame frame = bmtFrame::FromBounds(bounds);
  a.Transform(frame);
  b.Transform(frame);

  const OneSided ab = MeasureOneSided(a, b, options, "measuring A to B");
  const OneSided ba = MeasureOneSided(b, a, options, "measuring B to A");
  bmtJson result;
  result["max"] = frame.ToModel(std::max(ab.Maximum, ba.Maximum));
  result["rms"] = frame.ToModel(std::sqrt(0.5 * (ab.MeanSquare + ba.MeanSquare)));
  result["max_ab"] = frame.ToModel(ab.Maximum);
  result["max_ba"] = frame.ToModel(ba.Maximum);
  result["rms_ab"] = frame.ToModel(std::sqrt(ab.MeanSquare));
  result["rms_ba"] = frame.ToModel(std::sqrt(ba.MeanSquare));
  result["diagonal"] = bounds.GetDiagonal();
  result["triangles_a"] = a.Triangles.size();
  result["triangles_b"] = b.Triangles.size();
  result["samples_a"] = ab.Samples;
  result["samples_b"] = ba.Samples;
  result["vertices_a"] = ab.Vertices;
  result["vertices_b"] = ba.Vertices;
  return result;
}
}

void bmtAddCompare(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Measure the two-sided distance between two meshes");
  command->footer(
    "Distances go from area-weighted samples and from all vertices of one surface to the closest point of the other,\n"
    "in model units. max is over both; rms over the samples alone, both directions weighing the same.\n"
    "A and B may also be .bmt files; then their finest level is meant.");
  command->add_option("A", options->A, std::string("A mesh: ") + bmtGetInputKinds())->required();
  command->add_option("B", options->B, "Another mesh")->required();
  command->add_option("--samples", options->Samples, "Samples on each surface")
    ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1000000000)))
    ->capture_default_str();
  command->add_option("--seed", options->Seed, "Seed of the samples; the same seed gives the same figures")
    ->capture_default_str();
  bmtAddInputOptions(*command, options->Input);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Compare(*options));
        return bmtExit::Success;
      };
    });
}
