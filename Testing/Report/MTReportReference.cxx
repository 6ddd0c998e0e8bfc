// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportReference.h"

#include "MTReportTimes.h"

#include "vtkMTClosestPoint.h"
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
    const vtkMTSurfaceSampler sampler(this->From, count, Seed);
    const vtkMTSurfaceSampler::Samples samples = sampler.Take(0, sampler.GetNumberOfSamples());
    std::vector<double> distances;
    std::vector<std::uint32_t> nearest;
    this->Places.Measure(samples.Points, distances, &nearest, goOn);
    double squares = 0.0;
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      squares += distances[i] * distances[i];
      this->Angles.push_back(GetAngle(GetNormal(this->From, samples.Triangles[i]), GetNormal(this->To, nearest[i])));
    }
    this->MeanSquare = distances.empty() ? 0.0 : squares / static_cast<double>(distances.size());
    std::vector<double> ofVertices;
    this->Places.Measure(this->From.GetUsedPoints(), ofVertices, nullptr, goOn);
    this->Maximum = ofVertices.empty() ? 0.0 : *std::max_element(ofVertices.begin(), ofVertices.end());
    this->ClimbFrom(samples, distances);
  }

  double MeanSquare = 0.0;
  double Maximum = 0.0;
  std::vector<double> Angles;

private:
  void ClimbFrom(const vtkMTSurfaceSampler::Samples& samples, const std::vector<double>& distances)
  {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), 0);
    const std::size_t count = std::min(Climbers, order.size());
    const auto isFarther = [&](std::size_t a, std::size_t b)
    { return distances[a] > distances[b] || (distances[a] == distances[b] && a < b); };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), isFarther);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Maximum = std::max(
        this->Maximum, this->Climb(samples.Triangles[order[i]], samples.Points[order[i]], distances[order[i]]));
    }
  }

  // Steps towards and away from the triangle's corners, shorter ones when none of them leads higher.
  double Climb(std::uint32_t triangle, vtkMTRealPoint place, double distance) const
  {
    for (double step = 0.5; step > 1e-3;)
    {
      bool isHigher = false;
      for (const std::uint32_t corner : this->From.Triangles[triangle])
      {
        vtkMTRealPoint next;
        for (int axis = 0; axis < 3; ++axis)
        {
          next[axis] = place[axis] + step * (this->From.Points[corner][axis] - place[axis]);
        }
        const double there = std::sqrt(this->Places.Find(next).Distance2);
        if (there > distance)
        {
          place = next;
          distance = there;
          isHigher = true;
        }
      }
      step *= isHigher ? 1.0 : 0.5;
    }
    return distance;
  }

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
