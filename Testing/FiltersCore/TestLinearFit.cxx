// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLinearFit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace
{
constexpr std::uint32_t Cells = 16;

// Triangles over the unit square, with samples of a function all over them.
class Square
{
public:
  std::vector<std::array<double, 2>> Corners;
  std::vector<vtkMTLinearFit::Sample> Samples;
  std::vector<std::array<double, 2>> Places; // of the samples

  explicit Square(unsigned seed)
    : Random(seed)
  {
    for (std::uint32_t j = 0; j <= Cells; ++j)
    {
      for (std::uint32_t i = 0; i <= Cells; ++i)
      {
        this->Corners.push_back({ double(i) / Cells, double(j) / Cells });
      }
    }
    for (std::uint32_t j = 0; j < Cells; ++j)
    {
      for (std::uint32_t i = 0; i < Cells; ++i)
      {
        const std::uint32_t a = j * (Cells + 1) + i;
        this->AddSamples({ a, a + 1, a + Cells + 2 });
        this->AddSamples({ a, a + Cells + 2, a + Cells + 1 });
      }
    }
  }

  bool IsOnBorder(std::size_t corner) const
  {
    const auto& [x, y] = this->Corners[corner];
    return x == 0.0 || x == 1.0 || y == 0.0 || y == 1.0;
  }

private:
  void AddSamples(const std::array<std::uint32_t, 3>& corners)
  {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 12; ++k)
    {
      const double u = unit(this->Random);
      const double v = (1.0 - u) * unit(this->Random);
      const std::array<double, 3> w{ 1.0 - u - v, u, v };
      this->Samples.push_back({ corners, w, 1.0 });
      std::array<double, 2> place{ 0.0, 0.0 };
      for (int c = 0; c < 3; ++c)
      {
        place[0] += w[c] * this->Corners[corners[c]][0];
        place[1] += w[c] * this->Corners[corners[c]][1];
      }
      this->Places.push_back(place);
    }
  }

  std::mt19937 Random;
};

using Function = std::function<double(double x, double y)>;

std::vector<vtkMTLinearFit::Value> Sample(const Square& square, const Function& function)
{
  std::vector<vtkMTLinearFit::Value> values;
  for (const auto& [x, y] : square.Places)
  {
    const double value = function(x, y);
    values.push_back({ value, value, value });
  }
  return values;
}

std::vector<double> GetAtCorners(const Square& square, const Function& function)
{
  std::vector<double> values;
  for (const auto& [x, y] : square.Corners)
  {
    values.push_back(function(x, y));
  }
  return values;
}

double GetRms(
  const Square& square, const std::vector<vtkMTLinearFit::Value>& samples, const std::vector<double>& values)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    double here = -samples[i].Mean;
    for (int c = 0; c < 3; ++c)
    {
      here += square.Samples[i].Weights[c] * values[square.Samples[i].Corners[c]];
    }
    sum += here * here;
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}
}

TEST(LinearFit, FindsLinearFunctionsFromAnything)
{
  const Square square(1);
  const auto linear = [](double x, double y) { return 3.0 * x - 7.0 * y + 2.0; };
  std::vector<double> values(square.Corners.size(), 0.0);
  const std::vector<double> wanted = GetAtCorners(square, linear);
  std::vector<vtkMTLinearFit::Value> samples = Sample(square, linear);
  for (vtkMTLinearFit::Value& sample : samples)
  {
    sample.Least = -100.0;
    sample.Most = 100.0;
  }
  const vtkMTLinearFit fit(
    std::vector<unsigned char>(values.size(), 1), std::vector<vtkMTLinearFit::Sample>(square.Samples));
  fit.Solve(samples, values);
  double farthest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    farthest = std::max(farthest, std::abs(values[i] - wanted[i]));
  }
  std::printf("%d steps: off by at most %.2e of a range of 10\n", vtkMTLinearFit::Steps, farthest);
  EXPECT_LT(farthest, 0.02);
}

TEST(LinearFit, IsNearerToCurvedAndNoisyFunctionsThanTheirValuesAtTheCorners)
{
  const Square square(2);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.3);
  const std::pair<const char*, Function> functions[] = {
    { "curved", [](double x, double y) { return std::sin(20.0 * x) * std::cos(20.0 * y); } },
    { "noisy", [&](double x, double y) { return x + y + noise(random); } }
  };
  for (const auto& [name, function] : functions)
  {
    const std::vector<vtkMTLinearFit::Value> samples = Sample(square, function);
    std::vector<double> values = GetAtCorners(square, function);
    const double before = GetRms(square, samples, values);
    std::vector<unsigned char> isFree(values.size());
    for (std::size_t i = 0; i < isFree.size(); ++i)
    {
      isFree[i] = square.IsOnBorder(i) ? 0 : 1;
    }
    const std::vector<double> given = values;
    const vtkMTLinearFit fit(std::vector<unsigned char>(isFree), std::vector<vtkMTLinearFit::Sample>(square.Samples));
    fit.Solve(samples, values);
    const double after = GetRms(square, samples, values);
    std::printf("%s: %.4f with the values at the corners, %.4f fitted\n", name, before, after);
    EXPECT_LT(after, 0.85 * before) << name;
    for (std::size_t i = 0; i < isFree.size(); ++i)
    {
      ASSERT_TRUE(isFree[i] || values[i] == given[i]) << "a corner that is not free has changed";
    }
  }
}

TEST(LinearFit, StaysWithinWhatTheFunctionIsAndKeepsCornersWithoutSamples)
{
  const Square square(4);
  const auto step = [](double x, double) { return x < 0.4 ? 0.0 : 1.0; };
  std::vector<double> values = GetAtCorners(square, step);
  values.push_back(77.0); // of no triangle
  const vtkMTLinearFit fit(
    std::vector<unsigned char>(values.size(), 1), std::vector<vtkMTLinearFit::Sample>(square.Samples));
  fit.Solve(Sample(square, step), values);
  EXPECT_EQ(values.back(), 77.0);
  values.pop_back();
  for (const double value : values)
  {
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
  }
}
