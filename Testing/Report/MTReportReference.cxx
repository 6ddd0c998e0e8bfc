// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportReference.h"

#include "MTReportTimes.h"

#include "vtkMTClosestPoint.h"
#include "vtkMTFarthestPlaces.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSurfaceSampler.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr std::uint64_t Seed = 1;
// So many of the samples that are farthest away are climbed from.
constexpr std::size_t Climbers = 24;

vtkMTSampledSurface ReadSurface(vtkPolyData* mesh)
{
  vtkMTPolyDataStream stream(mesh);
  vtkMTSampledSurface surface;
  std::string error;
  if (!surface.Read(
        stream, [] { return true; }, error))
  {
    throw std::runtime_error(error);
  }
  return surface;
}

std::array<double, 3> GetNormal(const vtkMTSampledSurface& surface, std::uint32_t triangle)
{
  const vtkMTTriangle& corners = surface.Triangles[triangle];
  double edges[2][3];
  for (int e = 0; e < 2; ++e)
  {
    vtkMath::Subtract(surface.Points[corners[e + 1]].data(), surface.Points[corners[0]].data(), edges[e]);
  }
  std::array<double, 3> normal;
  vtkMath::Cross(edges[0], edges[1], normal.data());
  vtkMath::Normalize(normal.data());
  return normal;
}

double GetAngle(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return vtkMath::DegreesFromRadians(std::acos(std::clamp(vtkMath::Dot(a.data(), b.data()), -1.0, 1.0)));
}

// From one surface to another, in the frame's coordinates.
class Direction
{
public:
  Direction(const vtkMTSampledSurface& from, const vtkMTSampledSurface& to, const vtkMTClosestPoint& places)
    : From(from)
    , To(to)
    , Places(places)
  {
  }

  void Measure(std::size_t count)
  {
    const auto goOn = [](double) { return true; };
    const vtkMTFarthestPlaces search(this->From, this->Places);
    const vtkMTSurfaceSampler sampler(this->From, count, Seed);
    const vtkMTSurfaceSampler::Samples samples = sampler.Take(0, sampler.GetNumberOfSamples());
    vtkMTFarthestPlaces::Places places;
    search.Measure(samples.Points, samples.Triangles, places, goOn);
    double squares = 0.0;
    for (const vtkMTFarthestPlaces::Place& place : places)
    {
      squares += place.Distance * place.Distance;
      this->Angles.push_back(GetAngle(GetNormal(this->From, place.Triangle), GetNormal(this->To, place.Nearest)));
    }
    this->MeanSquare = places.empty() ? 0.0 : squares / static_cast<double>(places.size());
    vtkMTFarthestPlaces::Places vertices;
    search.Measure(this->From.GetUsedPoints(), {}, vertices, goOn);
    vtkMTFarthestPlaces::Places climbed;
    search.Climb(
      places, [](const vtkMTFarthestPlaces::Place&) { return 0; }, Climbers, climbed, goOn);
    for (const vtkMTFarthestPlaces::Places* each : { &vertices, &climbed })
    {
      for (const vtkMTFarthestPlaces::Place& place : *each)
      {
        this->Maximum = std::max(this->Maximum, place.Distance);
      }
    }
  }

  double MeanSquare = 0.0;
  double Maximum = 0.0;
  std::vector<double> Angles;

private:
  const vtkMTSampledSurface& From;
  const vtkMTSampledSurface& To;
  const vtkMTClosestPoint& Places; // of To
};
}

MTReportReference::MTReportReference(vtkPolyData* mesh)
  : Surface(ReadSurface(mesh))
{
  const vtkMTRealBounds bounds = this->Surface.GetBounds();
  this->Diagonal = bounds.GetDiagonal();
  this->Frame = vtkMTMeasuringFrame::FromBounds(bounds);
  this->Surface.Transform(this->Frame);
  this->Places = std::make_unique<vtkMTClosestPoint>(this->Surface);
}

MTReportReference::~MTReportReference() = default;

MTReportDeviation MTReportReference::Measure(vtkPolyData* approximation, std::size_t samples) const
{
  vtkMTSampledSurface other = ReadSurface(approximation);
  other.Transform(this->Frame);
  const vtkMTClosestPoint otherPlaces(other);
  Direction there(other, this->Surface, *this->Places);
  there.Measure(samples);
  Direction back(this->Surface, other, otherPlaces);
  back.Measure(samples);
  MTReportDeviation deviation;
  deviation.RootMeanSquare = this->Frame.ToModel(std::sqrt(0.5 * (there.MeanSquare + back.MeanSquare)));
  deviation.Maximum = this->Frame.ToModel(std::max(there.Maximum, back.Maximum));
  std::vector<double> angles = std::move(there.Angles);
  angles.insert(angles.end(), back.Angles.begin(), back.Angles.end());
  if (!angles.empty())
  {
    deviation.NormalMean = std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
    deviation.Normal95 = MTReportTimes::GetQuantile(angles, 0.95);
  }
  return deviation;
}
