// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "vtkMTView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace
{
using MTTestMeshes::Random;
using Vector = std::array<double, 3>;

Vector RandomDirection(Random& random)
{
  Vector d;
  double length = 0.0;
  do
  {
    d = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
    length = std::hypot(d[0], d[1], d[2]);
  } while (length > 1.0 || length < 0.1);
  return { d[0] / length, d[1] / length, d[2] / length };
}

Vector Add(const Vector& a, const Vector& b, double factor)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

double GetDistance(const Vector& a, const Vector& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// A random view: any linear map, any offset.
vtkMTView RandomView(Random& random, bool parallel)
{
  vtkMTView view;
  for (int i = 0; i < 12; ++i)
  {
    view.ModelToEye[i] = i % 4 == 3 ? random.Uniform(-3, 3) : random.Uniform(-1.5, 1.5);
  }
  view.UpdateStretch();
  view.ParallelProjection = parallel;
  view.PixelsPerUnit = random.Uniform(100, 1000);
  view.HalfSize = { random.Uniform(0.2, 2.0), random.Uniform(0.2, 2.0) };
  view.Near = random.Below(3) == 0 ? 0.0 : random.Uniform(0.01, 2.0);
  view.Far = random.Uniform(20, 100);
  return view;
}

bool IsPointVisible(const vtkMTView& view, const Vector& model)
{
  const Vector eye = view.ToEye(model);
  const double depth = -eye[2];
  const double scale = view.ParallelProjection ? 1.0 : depth;
  return depth >= view.Near && depth <= view.Far && depth > 0.0 && std::abs(eye[0]) <= view.HalfSize[0] * scale &&
    std::abs(eye[1]) <= view.HalfSize[1] * scale;
}

std::array<double, 2> ToPixels(const vtkMTView& view, const Vector& model)
{
  const Vector eye = view.ToEye(model);
  const double f = view.PixelsPerUnit / (view.ParallelProjection ? 1.0 : -eye[2]);
  return { f * eye[0], f * eye[1] };
}

Vector RandomPointInSphere(const Vector& center, double radius, Random& random)
{
  // Half of the points on the surface, where the bound is attained.
  const double share = random.Below(2) == 0 ? 1.0 : random.Uniform();
  return Add(center, RandomDirection(random), radius * share);
}

Vector RandomPlace(Random& random)
{
  return { random.Uniform(-6, 6), random.Uniform(-6, 6), random.Uniform(-6, 6) };
}
}

TEST(View, PixelErrorBoundsEveryDisplacement)
{
  Random random(1);
  std::size_t tested = 0;
  double tightest = 0.0;
  double ratioSum = 0.0;
  std::size_t spheres = 0;
  for (int v = 0; v < 400; ++v)
  {
    const vtkMTView view = RandomView(random, v % 4 == 0);
    for (int s = 0; s < 20; ++s)
    {
      const Vector center = RandomPlace(random);
      const double radius = std::pow(10.0, random.Uniform(-3, 0.5));
      const double error = radius * std::pow(10.0, random.Uniform(-4, 0));
      const double bound = view.GetPixelError(center, radius, error);
      double worst = 0.0;
      for (int i = 0; i < 60; ++i)
      {
        const Vector p = RandomPointInSphere(center, radius, random);
        const Vector q = Add(p, RandomDirection(random), error * (random.Below(2) ? 1.0 : random.Uniform()));
        if (!IsPointVisible(view, p) || (!view.ParallelProjection && view.ToEye(q)[2] >= 0.0))
        {
          continue;
        }
        const std::array<double, 2> a = ToPixels(view, p);
        const std::array<double, 2> b = ToPixels(view, q);
        const double moved = std::hypot(a[0] - b[0], a[1] - b[1]);
        ASSERT_LE(moved, bound * (1.0 + 1e-9)) << "view " << v << ", radius " << radius << ", error " << error;
        worst = std::max(worst, moved);
        ++tested;
      }
      if (worst > 0.0 && std::isfinite(bound))
      {
        tightest = std::max(tightest, worst / bound);
        ratioSum += worst / bound;
        ++spheres;
      }
    }
  }
  std::cout << tested << " displacements of " << spheres << " spheres; worst over bound: mean " << ratioSum / spheres
            << ", largest " << tightest << "\n";
  EXPECT_GT(tested, 20000u);
  EXPECT_GT(tightest, 0.9) << "the bound is attained somewhere";
}

TEST(View, CornersOfAWideViewNeedMoreThanTheDistanceFormula)
{
  vtkMTView view;
  view.HalfSize = { 1.0, 1.0 };
  view.Near = 0.1;
  const Vector corner{ 9.99, 9.99, -10.0 };
  const double e = 1e-3;
  const double bound = view.GetPixelError(corner, 1e-3, e);
  const double formula = e * view.PixelsPerUnit / GetDistance(corner, { 0, 0, 0 });
  // Displace along the screen's radius, where the perspective moves most.
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / 1000;
    const Vector d{ std::sqrt(0.5) * std::cos(angle), std::sqrt(0.5) * std::cos(angle), std::sin(angle) };
    const std::array<double, 2> a = ToPixels(view, corner);
    const std::array<double, 2> b = ToPixels(view, Add(corner, d, e));
    worst = std::max(worst, std::hypot(a[0] - b[0], a[1] - b[1]));
  }
  std::cout << "moved " << worst << " pixels, bound " << bound << ", distance formula " << formula << "\n";
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.99 * bound);
  EXPECT_GT(worst, 1.4 * formula);
}

TEST(View, PixelErrorIsMonotoneForNestedSpheres)
{
  Random random(2);
  std::size_t infinite = 0;
  for (int v = 0; v < 400; ++v)
  {
    const vtkMTView view = RandomView(random, v % 4 == 0);
    for (int s = 0; s < 100; ++s)
    {
      const Vector outer = RandomPlace(random);
      const double outerRadius = std::pow(10.0, random.Uniform(-3, 1));
      const double outerError = outerRadius * std::pow(10.0, random.Uniform(-5, 0));
      // Touching from inside in half of the cases, but for the slack that saturation gives.
      const double innerRadius = outerRadius * random.Uniform();
      const double room = (outerRadius - innerRadius) * (random.Below(2) ? 1.0 : random.Uniform());
      const Vector inner = Add(outer, RandomDirection(random), room);
      const double innerError = outerError * (random.Below(2) ? 1.0 : random.Uniform());
      const double large = view.GetPixelError(outer, outerRadius * (1.0 + 1e-12), outerError);
      const double small = view.GetPixelError(inner, innerRadius, innerError);
      ASSERT_LE(small, large * (1.0 + 1e-12));
      infinite += std::isinf(large) ? 1 : 0;
    }
  }
  std::cout << infinite << " of 40000 outer spheres have no bound\n";
}

TEST(View, EyeInsideTheSphereHasNoBoundUnlessTheNearPlaneGivesOne)
{
  vtkMTView view;
  EXPECT_TRUE(std::isinf(view.GetPixelError({ 0, 0, -0.5 }, 1.0, 1e-6)));
  EXPECT_EQ(view.GetPixelError({ 0, 0, -0.5 }, 1.0, 0.0), 0.0);
  view.Near = 0.25;
  const double bound = view.GetPixelError({ 0, 0, -0.5 }, 1.0, 1e-6);
  EXPECT_NEAR(bound, 1e-6 * 500.0 / 0.25 * std::sqrt(3.0), 1e-6);
  EXPECT_TRUE(std::isinf(view.GetPixelError({ 0, 0, -0.5 }, 1.0, 0.3)));
}

TEST(View, StretchIsTheLargestSingularValue)
{
  Random random(4);
  for (int i = 0; i < 200; ++i)
  {
    vtkMTView view = RandomView(random, false);
    const double scale = i % 3 == 0 ? 1e-200 : (i % 3 == 1 ? 1e200 : 1.0);
    for (double& m : view.ModelToEye)
    {
      m *= scale;
    }
    view.UpdateStretch();
    double largest = 0.0;
    for (int j = 0; j < 2000; ++j)
    {
      const Vector d = RandomDirection(random);
      double image[3] = { 0.0, 0.0, 0.0 };
      for (int row = 0; row < 3; ++row)
      {
        for (int column = 0; column < 3; ++column)
        {
          image[row] += view.ModelToEye[4 * row + column] / scale * d[column];
        }
      }
      largest = std::max(largest, std::hypot(image[0], image[1], image[2]));
    }
    EXPECT_GE(view.Stretch / scale, largest);
    EXPECT_LE(view.Stretch / scale, largest * 1.02);
  }
  vtkMTView zero;
  zero.ModelToEye.fill(0.0);
  zero.UpdateStretch();
  EXPECT_EQ(zero.Stretch, 0.0);
}

TEST(View, NothingVisibleIsEverCulled)
{
  Random random(3);
  std::size_t visible = 0;
  std::size_t culled = 0;
  for (int v = 0; v < 400; ++v)
  {
    const vtkMTView view = RandomView(random, v % 4 == 0);
    for (int s = 0; s < 50; ++s)
    {
      const Vector center = RandomPlace(random);
      const double radius = std::pow(10.0, random.Uniform(-2, 0.5));
      const double bounds[6] = { center[0] - radius, center[0] + radius, center[1] - radius, center[1] + radius,
        center[2] - radius, center[2] + radius };
      const bool sphere = view.IsSphereVisible(center, radius);
      const bool box = view.IsBoxVisible(bounds);
      culled += sphere ? 0 : 1;
      for (int i = 0; i < 30; ++i)
      {
        if (IsPointVisible(view, RandomPointInSphere(center, radius, random)))
        {
          ASSERT_TRUE(sphere);
          ASSERT_TRUE(box) << "the box holds the sphere";
          ++visible;
        }
        const Vector p{ random.Uniform(bounds[0], bounds[1]), random.Uniform(bounds[2], bounds[3]),
          random.Uniform(bounds[4], bounds[5]) };
        ASSERT_TRUE(box || !IsPointVisible(view, p));
      }
    }
  }
  std::cout << visible << " visible points, " << culled << " of 20000 spheres culled\n";
  EXPECT_GT(visible, 10000u);
  EXPECT_GT(culled, 2000u);
}

TEST(View, UtmSizedOffsetsDoNotCullOrShortenTheBound)
{
  // A camera one unit from a point with large coordinates: the product's rounding is about 1e-9.
  Random random(6);
  const Vector far{ 500123.4, 5400321.1, 712.3 };
  for (int i = 0; i < 1000; ++i)
  {
    vtkMTView view;
    const double angle = random.Uniform(0, 6.28);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Vector target{ random.Uniform(-1, 1), random.Uniform(-1, 1), -1.0 };
    view.ModelToEye = { c, -s, 0, target[0] - (c * far[0] - s * far[1]), s, c, 0, target[1] - (s * far[0] + c * far[1]),
      0, 0, 1, target[2] - far[2], 0, 0, 0, 1 };
    ASSERT_TRUE(view.IsSphereVisible(far, 1e-12));
    const double bounds[6] = { far[0], far[0], far[1], far[1], far[2], far[2] };
    ASSERT_TRUE(view.IsBoxVisible(bounds));
  }
  const double empty[6] = { 1, -1, 1, -1, 1, -1 };
  EXPECT_FALSE(vtkMTView().IsBoxVisible(empty));
}
