// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDrawingRate.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t MostSamples = 24;
// After so many frames a limit may be found to be wrong.
constexpr std::size_t FewSamples = 4;
// If the last ones of a longer row are so many that are off, the scene has changed.
constexpr std::size_t ChangedSamples = 6;
// Of what is wanted, whatever the frames' spread; and with all samples.
constexpr double Tolerance = 0.04;
constexpr double MostTolerance = 0.08;
// The fixed part is not taken to be more of a frame than this: an error in it would lead far off.
constexpr double MostFixed = 0.75;

// Of two in the middle the lower one: the outliers among frames are slow.
double GetMiddle(std::vector<double> values)
{
  const std::size_t half = (values.size() - 1) / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half), values.end());
  return values[half];
}
}

//------------------------------------------------------------------------------
void vtkMTDrawingRate::AddFrame(std::uint64_t triangles, double seconds, double wanted)
{
  const bool unhurried = !(wanted < Unhurried);
  if (triangles == 0 || !(seconds > 0.0) || !(wanted > 0.0) || (unhurried && this->Wanted > 0.0))
  {
    return;
  }
  if (this->Settling && this->Now.Seconds > 0.0)
  {
    // It has the patches to upload that the new limit let in.
    this->Settling = false;
    return;
  }
  this->Samples.push_back({ static_cast<double>(triangles), seconds });
  if (this->Samples.size() > MostSamples)
  {
    this->Samples.erase(this->Samples.begin());
  }
  const bool first = this->Now.Seconds == 0.0;
  if (first || this->Samples.size() >= FewSamples)
  {
    this->Now = this->GetMedian(this->Samples.size());
  }
  if (unhurried || this->Wanted == 0.0 || this->Samples.size() < FewSamples)
  {
    return;
  }
  if (this->IsOff(this->Samples.size()))
  {
    this->AdjustLimit();
  }
  else if (this->Samples.size() > ChangedSamples && this->IsOff(ChangedSamples))
  {
    // What was before says no more.
    this->Samples.erase(this->Samples.begin(), this->Samples.end() - ChangedSamples);
    this->Now = this->GetMedian(ChangedSamples);
    this->AdjustLimit();
  }
}

//------------------------------------------------------------------------------
// Where there are fewer triangles than there may be, frames are quicker than they need be, and the limit is right.
void vtkMTDrawingRate::AdjustLimit()
{
  if (std::abs(this->Predict(this->Wanted) / this->Limit - 1.0) > Tolerance)
  {
    this->SetLimit(this->Wanted);
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTDrawingRate::GetTriangles(double wanted)
{
  if (this->Now.Seconds == 0.0)
  {
    return 0;
  }
  double triangles = 0.0;
  if (!(wanted < Unhurried))
  {
    triangles = this->Predict(wanted);
  }
  else
  {
    if (std::abs(wanted - this->Wanted) > 1e-6 * wanted)
    {
      this->SetLimit(wanted);
    }
    triangles = this->Limit;
  }
  return static_cast<std::uint64_t>(std::clamp(triangles, 1.0, 1e18));
}

//------------------------------------------------------------------------------
double vtkMTDrawingRate::GetTriangleSeconds() const
{
  const double fixed = std::min(this->Fixed, MostFixed * this->Now.Seconds);
  return (this->Now.Seconds - fixed) / this->Now.Triangles;
}

//------------------------------------------------------------------------------
double vtkMTDrawingRate::Predict(double wanted) const
{
  const double triangles = this->Now.Triangles + (wanted - this->Now.Seconds) / this->GetTriangleSeconds();
  // What it would be without a fixed part bounds how far one that was found wrongly can lead.
  const double proportional = this->Now.Triangles * wanted / this->Now.Seconds;
  return std::clamp(triangles, 0.25 * proportional, 2.0 * proportional);
}

//------------------------------------------------------------------------------
// Of the last frames, as if all had had the same number of triangles.
vtkMTDrawingRate::Sample vtkMTDrawingRate::GetMedian(std::size_t count) const
{
  std::vector<double> triangles;
  for (std::size_t i = this->Samples.size() - count; i < this->Samples.size(); ++i)
  {
    triangles.push_back(this->Samples[i].Triangles);
  }
  Sample median;
  median.Triangles = GetMiddle(std::move(triangles));
  const double each = this->Now.Seconds > 0.0 ? this->GetTriangleSeconds() : 0.0;
  std::vector<double> seconds;
  for (std::size_t i = this->Samples.size() - count; i < this->Samples.size(); ++i)
  {
    const Sample& sample = this->Samples[i];
    seconds.push_back(std::max(sample.Seconds + each * (median.Triangles - sample.Triangles), 0.1 * sample.Seconds));
  }
  median.Seconds = GetMiddle(std::move(seconds));
  return median;
}

//------------------------------------------------------------------------------
// Median deviation, as a share of the median.
double vtkMTDrawingRate::GetSpread(double median) const
{
  std::vector<double> deviations;
  for (const Sample& sample : this->Samples)
  {
    deviations.push_back(std::abs(sample.Seconds - median) / median);
  }
  return GetMiddle(std::move(deviations));
}

//------------------------------------------------------------------------------
bool vtkMTDrawingRate::IsOff(std::size_t count) const
{
  const double seconds = this->GetMedian(count).Seconds;
  const double spread = std::max(this->GetSpread(this->Now.Seconds), this->LastSpread);
  const auto n = static_cast<double>(count);
  const double uncertain = std::max(0.3 / n, 5.0 * spread / std::sqrt(n));
  const double most = count == MostSamples ? MostTolerance : 1.0;
  return std::abs(seconds / this->Wanted - 1.0) > std::min(Tolerance + uncertain, most);
}

//------------------------------------------------------------------------------
// By the secant through what was measured under the last two limits.
void vtkMTDrawingRate::LearnFixedPart()
{
  const double triangles = this->Now.Triangles - this->Before.Triangles;
  if (this->Before.Seconds > 0.0 && std::abs(triangles) > 0.2 * std::min(this->Now.Triangles, this->Before.Triangles))
  {
    const double each = (this->Now.Seconds - this->Before.Seconds) / triangles;
    if (each > 0.0)
    {
      this->Fixed = std::clamp(this->Now.Seconds - each * this->Now.Triangles, 0.0, MostFixed * this->Now.Seconds);
    }
  }
  this->Before = this->Now;
}

//------------------------------------------------------------------------------
void vtkMTDrawingRate::SetLimit(double wanted)
{
  this->LearnFixedPart();
  this->LastSpread = this->Samples.size() >= FewSamples ? this->GetSpread(this->Now.Seconds) : 0.0;
  this->Wanted = wanted;
  this->Limit = this->Predict(wanted);
  this->Samples.clear();
  this->Settling = true;
}
