// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLinearFit.h"

#include <algorithm>
#include <limits>

namespace
{
double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}
}

//------------------------------------------------------------------------------
vtkMTLinearFit::vtkMTLinearFit(std::vector<unsigned char>&& isFree, std::vector<Sample>&& samples)
  : IsFree(std::move(isFree))
  , Samples(std::move(samples))
  , Diagonal(this->IsFree.size(), 0.0)
{
  for (const Sample& sample : this->Samples)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Diagonal[sample.Corners[c]] += sample.Weight * sample.Weights[c] * sample.Weights[c];
    }
  }
}

//------------------------------------------------------------------------------
double vtkMTLinearFit::Evaluate(const Sample& sample, const Vector& values) const
{
  return sample.Weights[0] * values[sample.Corners[0]] + sample.Weights[1] * values[sample.Corners[1]] +
    sample.Weights[2] * values[sample.Corners[2]];
}

//------------------------------------------------------------------------------
std::vector<double> vtkMTLinearFit::ApplyTransposed(const std::vector<double>& ofSamples) const
{
  Vector result(this->IsFree.size(), 0.0);
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const Sample& sample = this->Samples[i];
    for (int c = 0; c < 3; ++c)
    {
      if (this->IsFree[sample.Corners[c]])
      {
        result[sample.Corners[c]] += sample.Weight * sample.Weights[c] * ofSamples[i];
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkMTLinearFit::Solve(const std::vector<Value>& ofSamples, std::vector<double>& values) const
{
  std::vector<double> difference(this->Samples.size());
  const auto evaluate = [&](const Vector& of)
  {
    for (std::size_t i = 0; i < this->Samples.size(); ++i)
    {
      difference[i] = this->Evaluate(this->Samples[i], of);
    }
  };
  const auto precondition = [&](const Vector& vector)
  {
    Vector result(vector.size(), 0.0);
    for (std::size_t i = 0; i < vector.size(); ++i)
    {
      result[i] = this->Diagonal[i] > 0.0 ? vector[i] / this->Diagonal[i] : 0.0;
    }
    return result;
  };
  evaluate(values);
  std::transform(ofSamples.begin(), ofSamples.end(), difference.begin(), difference.begin(),
    [](const Value& sample, double here) { return sample.Mean - here; });
  Vector residual = this->ApplyTransposed(difference);
  Vector direction = precondition(residual);
  double before = Dot(residual, direction);
  for (int step = 0; step < Steps && before > 0.0; ++step)
  {
    evaluate(direction);
    const Vector image = this->ApplyTransposed(difference);
    const double curvature = Dot(direction, image);
    if (!(curvature > 0.0))
    {
      break;
    }
    const double length = before / curvature;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] += length * direction[i];
      residual[i] -= length * image[i];
    }
    const Vector next = precondition(residual);
    const double after = Dot(residual, next);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      direction[i] = next[i] + after / before * direction[i];
    }
    before = after;
  }
  this->Clamp(ofSamples, values);
}

//------------------------------------------------------------------------------
void vtkMTLinearFit::Clamp(const std::vector<Value>& ofSamples, std::vector<double>& values) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> least(values.size(), infinity);
  std::vector<double> most(values.size(), -infinity);
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    for (const std::uint32_t corner : this->Samples[i].Corners)
    {
      least[corner] = std::min(least[corner], ofSamples[i].Least);
      most[corner] = std::max(most[corner], ofSamples[i].Most);
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (this->IsFree[i] && least[i] <= most[i])
    {
      values[i] = std::clamp(values[i], least[i], most[i]);
    }
  }
}
