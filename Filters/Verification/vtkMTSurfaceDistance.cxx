// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSurfaceDistance.h"

#include "vtkMTClosestPoint.h"
#include "vtkMTSurfaceSampler.h"

#include <algorithm>
#include <cmath>

namespace
{
// Samples are taken and measured in turns, so that memory does not grow with their number.
constexpr std::size_t SamplesPerTurn = 1 << 20;

// One direction, in the frame's units.
class Direction
{
public:
  Direction(const vtkMTSampledSurface& from, const vtkMTSampledSurface& to, const vtkMTClosestPoint::Progress& progress)
    : From(from)
    , To(to)
    , Progress(progress)
  {
  }

  bool Measure(std::size_t samples, std::uint64_t seed)
  {
    return this->MeasureSamples(samples, seed) && this->MeasureVertices();
  }

  double Maximum = 0.0;
  double MeanSquare = 0.0;
  std::size_t Samples = 0;
  std::size_t Vertices = 0;

private:
  void Add(const std::vector<double>& distances, double& sumOfSquares)
  {
    for (double distance : distances)
    {
      this->Maximum = std::max(this->Maximum, distance);
      sumOfSquares += distance * distance;
    }
  }

  bool MeasureSamples(std::size_t samples, std::uint64_t seed)
  {
    const vtkMTSurfaceSampler sampler(this->From, samples, seed);
    const std::size_t all = sampler.GetNumberOfSamples();
    std::vector<double> distances;
    double sum = 0.0;
    for (std::size_t first = 0; first < all; first += SamplesPerTurn)
    {
      const std::size_t count = std::min(SamplesPerTurn, all - first);
      const auto advance = [&](double share)
      {
        return this->Progress(
          0.5 * (static_cast<double>(first) + share * static_cast<double>(count)) / static_cast<double>(all));
      };
      if (!this->To.Measure(sampler.Take(first, first + count).Points, distances, nullptr, advance))
      {
        return false;
      }
      this->Add(distances, sum);
      this->Samples += distances.size();
    }
    this->MeanSquare = this->Samples > 0 ? sum / static_cast<double>(this->Samples) : 0.0;
    return true;
  }

  bool MeasureVertices()
  {
    std::vector<double> distances;
    const auto advance = [&](double share) { return this->Progress(0.5 + 0.5 * share); };
    if (!this->To.Measure(this->From.GetUsedPoints(), distances, nullptr, advance))
    {
      return false;
    }
    double sum = 0.0;
    this->Add(distances, sum);
    this->Vertices = distances.size();
    if (this->Samples == 0) // a surface without area: its vertices are all there is
    {
      this->MeanSquare = sum / static_cast<double>(distances.size());
    }
    return true;
  }

  const vtkMTSampledSurface& From;
  const vtkMTClosestPoint To;
  const vtkMTClosestPoint::Progress Progress;
};
}

bool vtkMTSurfaceDistance::Measure(vtkMTSampledSurface& a, vtkMTSampledSurface& b, std::size_t samples,
  std::uint64_t seed, const vtkMTVerificationProgress& progress)
{
  vtkMTRealBounds bounds = a.GetBounds();
  bounds.Add(b.GetBounds());
  const vtkMTMeasuringFrame frame = vtkMTMeasuringFrame::FromBounds(bounds);
  a.Transform(frame);
  b.Transform(frame);
  const auto measure = [&](const vtkMTSampledSurface& from, const vtkMTSampledSurface& to, const char* step,
                         double before, OneSided& result, double& meanSquare)
  {
    Direction direction(from, to, [&](double share) { return progress(step, before + 0.5 * share); });
    if (!direction.Measure(samples, seed))
    {
      return false;
    }
    meanSquare = direction.MeanSquare;
    result = { frame.ToModel(direction.Maximum), frame.ToModel(std::sqrt(meanSquare)), direction.Samples,
      direction.Vertices };
    return true;
  };
  double ab = 0.0;
  double ba = 0.0;
  if (!measure(a, b, "measuring A to B", 0.0, this->FromAToB, ab) ||
    !measure(b, a, "measuring B to A", 0.5, this->FromBToA, ba))
  {
    return false;
  }
  this->Maximum = std::max(this->FromAToB.Maximum, this->FromBToA.Maximum);
  this->RootMeanSquare = frame.ToModel(std::sqrt(0.5 * (ab + ba)));
  this->Diagonal = bounds.GetDiagonal();
  return true;
}
