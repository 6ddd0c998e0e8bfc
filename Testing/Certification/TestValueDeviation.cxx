// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSurface.h"
#include "vtkMTValueDeviation.h"
#include "vtkMTVector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

using namespace vtkMTVector;

namespace
{
using Values = vtkMTValueDeviation::Values;

// One triangle with values.
struct Triangle
{
  vtkMTPatch Patch;
  std::vector<Values> Corners{ Values() };

  vtkMTSurface MakeSurface() const { return vtkMTSurface(this->Patch, { 0, 0, 0 }); }
};

class Maker
{
public:
  explicit Maker(unsigned seed)
    : Random(seed)
  {
  }
  double Uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(this->Random); }

  Triangle Make(double length, double width, double height)
  {
    Triangle triangle;
    for (int c = 0; c < 3; ++c)
    {
      triangle.Patch.Points.push_back({ this->Round(length), this->Round(width), this->Round(height) });
      triangle.Corners[0][c] = this->Uniform(-10.0, 10.0);
    }
    triangle.Patch.Triangles.push_back({ 0, 1, 2 });
    return triangle;
  }

  std::array<double, 3> MakeWeights()
  {
    const double u = this->Uniform(0.0, 1.0);
    const double v = this->Uniform(0.0, 1.0 - u);
    return { 1.0 - u - v, u, v };
  }

private:
  std::int32_t Round(double size) { return static_cast<std::int32_t>(std::lround(this->Uniform(-size, size))); }

  std::mt19937 Random;
};

Vector GetPlace(const vtkMTSurface& surface, const std::array<double, 3>& weights)
{
  Vector x{ 0.0, 0.0, 0.0 };
  for (int c = 0; c < 3; ++c)
  {
    x = Add(x, Scale(surface.GetCorner(0, c), weights[c]));
  }
  return x;
}

double GetValue(const Values& values, const std::array<double, 3>& weights)
{
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
}
}

TEST(ValueDeviation, HoldsForThePointsWithinTheDistanceAndTheirNearest)
{
  Maker maker(3);
  std::size_t within = 0;
  std::vector<double> tightness;
  for (int round = 0; round < 4000; ++round)
  {
    const double width = std::pow(10.0, maker.Uniform(0.0, 4.0));
    const Triangle t = maker.Make(10000.0, width, 300.0);
    const Triangle s = maker.Make(10000.0, width, 300.0);
    const vtkMTSurface surfaceOfT = t.MakeSurface();
    const vtkMTSurface surfaceOfS = s.MakeSurface();
    const double distance = std::pow(10.0, maker.Uniform(1.0, 4.0));
    const double bound =
      vtkMTValueDeviation::GetDifference({ surfaceOfT, t.Corners }, 0, { surfaceOfS, s.Corners }, 0, distance);
    double largest = 0.0;
    for (int sample = 0; sample < 200; ++sample)
    {
      const std::array<double, 3> weights = maker.MakeWeights();
      const vtkMTSurface::Hit nearest = surfaceOfS.Project(GetPlace(surfaceOfT, weights), 0);
      if (nearest.Distance2 <= distance * distance)
      {
        ++within;
        largest =
          std::max(largest, std::abs(GetValue(t.Corners[0], weights) - GetValue(s.Corners[0], nearest.Weights)));
      }
    }
    ASSERT_LE(largest, bound * (1.0 + 1e-9)) << "round " << round;
    if (largest > 0.0)
    {
      tightness.push_back(bound / largest);
    }
  }
  std::sort(tightness.begin(), tightness.end());
  std::printf("%zu points within the distance; bound over sampled: median %.2f, 95 %% below %.2f\n", within,
    tightness[tightness.size() / 2], tightness[tightness.size() * 95 / 100]);
  EXPECT_GT(within, 50000u);
  EXPECT_LT(tightness[tightness.size() / 2], 1.5);
}

TEST(ValueDeviation, OfOneLinearFunctionOnOnePlaneIsNothing)
{
  Maker maker(4);
  for (int round = 0; round < 1000; ++round)
  {
    Triangle t = maker.Make(10000.0, 10000.0, 0.0);
    Triangle s = maker.Make(10000.0, 10000.0, 0.0);
    for (Triangle* triangle : { &t, &s })
    {
      for (int c = 0; c < 3; ++c)
      {
        const vtkMTPoint& p = triangle->Patch.Points[c];
        triangle->Corners[0][c] = 3.0 * p[0] - 2.0 * p[1] + 5.0;
      }
    }
    const vtkMTSurface surfaceOfT = t.MakeSurface();
    const vtkMTSurface surfaceOfS = s.MakeSurface();
    // Where t lies within s there is nothing to go outside for.
    EXPECT_LE(
      vtkMTValueDeviation::GetDifference({ surfaceOfT, t.Corners }, 0, { surfaceOfS, s.Corners }, 0, 1e-6), 1e-3);
  }
}

TEST(ValueDeviation, ConstantsDifferByTheirDifferenceAndNothingElse)
{
  Maker maker(5);
  Triangle t = maker.Make(1000.0, 1000.0, 1000.0);
  Triangle s = maker.Make(1000.0, 1000.0, 1000.0);
  const vtkMTSurface surfaceOfT = t.MakeSurface();
  const vtkMTSurface surfaceOfS = s.MakeSurface();
  const auto getDifference = [&](double ofT, double ofS)
  {
    t.Corners[0] = { ofT, ofT, ofT };
    s.Corners[0] = { ofS, ofS, ofS };
    return vtkMTValueDeviation::GetDifference({ surfaceOfT, t.Corners }, 0, { surfaceOfS, s.Corners }, 0, 1e4);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(getDifference(7.5, 7.5), 0.0);
  EXPECT_EQ(getDifference(7.5, 5.0), 2.5);
  EXPECT_EQ(getDifference(infinity, infinity), 0.0);
  EXPECT_EQ(getDifference(infinity, 1.0), infinity);
  EXPECT_EQ(getDifference(std::nan(""), std::nan("")), infinity) << "a value that is no number is never certified";
}

TEST(ValueDeviation, IsAddedToWhatIsKnownOfTheFloorForEachDirection)
{
  Maker maker(6);
  Triangle t = maker.Make(1000.0, 1000.0, 10.0);
  Triangle s = maker.Make(1000.0, 1000.0, 10.0);
  t.Corners[0] = { 1.0, 1.0, 1.0 };
  s.Corners[0] = { 1.5, 1.5, 1.5 };
  const vtkMTSurface surfaceOfT = t.MakeSurface();
  const vtkMTSurface surfaceOfS = s.MakeSurface();
  const auto add = [&](const std::vector<vtkMTValueDeviation>& known, bool isDown, bool isUp)
  {
    return vtkMTValueDeviation::Add(
      { surfaceOfT, t.Corners }, { surfaceOfS, s.Corners }, known, { { 0, 0, 10.0f, isDown, isUp } })[0];
  };
  EXPECT_DOUBLE_EQ(add({}, true, false).FromInput, 0.5);
  EXPECT_DOUBLE_EQ(add({}, true, false).ToInput, 0.0);
  EXPECT_DOUBLE_EQ(add({ { 0.25, 2.0 } }, true, true).ToInput, 0.75);
  EXPECT_DOUBLE_EQ(add({ { 0.25, 2.0 } }, true, true).FromInput, 2.5);
}
