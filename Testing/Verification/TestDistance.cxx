// SPDX-License-Identifier: BSD-3-Clause
// The verification's own parts: closest points, sampling, the frame of measuring, the distance of two surfaces.
#include "MTTestMeshes.h"

#include "vtkMTClosestPoint.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTSurfaceDistance.h"
#include "vtkMTSurfaceSampler.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
vtkMTSampledSurface ToSurface(vtkPolyData* mesh)
{
  vtkMTSampledSurface surface;
  surface.Points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, corners);
    vtkMTTriangle triangle;
    for (int c = 0; c < 3; ++c)
    {
      triangle[c] = static_cast<std::uint32_t>(corners->GetId(c));
    }
    surface.Triangles.push_back(triangle);
  }
  return surface;
}

using LongPoint = std::array<long double, 3>;

long double Dot(const LongPoint& a, const LongPoint& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LongPoint Along(const LongPoint& a, const LongPoint& b, long double t)
{
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) };
}

long double SegmentDistance(const LongPoint& x, const LongPoint& a, const LongPoint& b)
{
  const LongPoint e = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const LongPoint p = { x[0] - a[0], x[1] - a[1], x[2] - a[2] };
  const long double t = Dot(e, e) > 0 ? std::clamp<long double>(Dot(p, e) / Dot(e, e), 0, 1) : 0;
  const LongPoint y = Along(a, b, t);
  const LongPoint d = { x[0] - y[0], x[1] - y[1], x[2] - y[2] };
  return std::sqrt(Dot(d, d));
}

// The least distance to the segments from corner a to the side bc: a convex function of the place on bc, minimised by
// ternary search in extended precision. Shares nothing with what is tested.
long double ReferenceDistance(
  const vtkMTRealPoint& px, const vtkMTRealPoint& pa, const vtkMTRealPoint& pb, const vtkMTRealPoint& pc)
{
  const LongPoint x = { px[0], px[1], px[2] };
  const LongPoint a = { pa[0], pa[1], pa[2] };
  const LongPoint b = { pb[0], pb[1], pb[2] };
  const LongPoint c = { pc[0], pc[1], pc[2] };
  long double low = 0;
  long double high = 1;
  for (int i = 0; i < 300; ++i)
  {
    const long double first = low + (high - low) / 3;
    const long double second = high - (high - low) / 3;
    (SegmentDistance(x, a, Along(b, c, first)) < SegmentDistance(x, a, Along(b, c, second)) ? high : low) =
      SegmentDistance(x, a, Along(b, c, first)) < SegmentDistance(x, a, Along(b, c, second)) ? second : first;
  }
  return SegmentDistance(x, a, Along(b, c, (low + high) / 2));
}
}

TEST(ClosestPoint, AgreesWithATrialOfAllTrianglesAndWithVtk)
{
  const auto mesh = MTTestMeshes::FractalSphere(4, 7);
  const vtkMTSampledSurface surface = ToSurface(mesh);
  const vtkMTClosestPoint search(surface);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  MTTestMeshes::Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const double reach = i % 2 ? 1.2 : 4.0;
    const vtkMTRealPoint x = { random.Uniform(-reach, reach), random.Uniform(-reach, reach),
      random.Uniform(-reach, reach) };
    double least = HUGE_VAL;
    for (const vtkMTTriangle& t : surface.Triangles)
    {
      least = std::min(
        least, vtkMTClosestPoint::GetDistance2(x, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]]));
    }
    const vtkMTClosestPoint::Result found = search.Find(x);
    EXPECT_EQ(found.Distance2, least);
    EXPECT_EQ(search.Find(x, 17).Distance2, least) << "a hint changed the result";
    EXPECT_EQ(search.Find(x, 17).Triangle, found.Triangle) << "a hint changed the result";
    double closest[3];
    double distance2 = 0.0;
    vtkIdType id = 0;
    int sub = 0;
    locator->FindClosestPoint(x.data(), closest, cell, id, sub, distance2);
    worst = std::max(worst, std::abs(std::sqrt(distance2) - std::sqrt(found.Distance2)));
  }
  std::cout << "largest difference from vtkStaticCellLocator: " << worst << "\n";
  EXPECT_LT(worst, 1e-12);
}

TEST(ClosestPoint, IsAccurateForSliversAndTrianglesWithoutArea)
{
  MTTestMeshes::Random random(5);
  double worst = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const double height = i % 10 == 0 ? 0.0 : std::pow(10.0, random.Uniform(-17.0, 0.0));
    vtkMTRealPoint a, b, c, x;
    const double along = random.Uniform(-0.2, 1.2);
    for (int axis = 0; axis < 3; ++axis)
    {
      a[axis] = random.Uniform(-1.0, 1.0);
      b[axis] = random.Uniform(-1.0, 1.0);
      c[axis] = a[axis] + along * (b[axis] - a[axis]) + height * random.Uniform(-1.0, 1.0);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double inside = 0.4 * a[axis] + 0.3 * b[axis] + 0.3 * c[axis];
      x[axis] = inside + std::pow(10.0, random.Uniform(-12.0, 0.0)) * random.Uniform(-1.0, 1.0);
    }
    const double distance = std::sqrt(vtkMTClosestPoint::GetDistance2(x, a, b, c));
    worst = std::max(worst, std::abs(distance - static_cast<double>(ReferenceDistance(x, a, b, c))));
  }
  std::cout << "largest error, edges of length about 1: " << worst << "\n";
  EXPECT_LT(worst, 1e-14);
}

namespace
{
// Needles askew through the unit cube, some of them without area, between many small triangles.
vtkMTSampledSurface MakeNeedles(std::size_t needles, std::size_t small, unsigned int seed)
{
  MTTestMeshes::Random random(seed);
  vtkMTSampledSurface surface;
  const auto at = [&random](const vtkMTRealPoint& center, double reach)
  {
    vtkMTRealPoint x = center;
    for (double& coordinate : x)
    {
      coordinate += random.Uniform(-reach, reach);
    }
    return x;
  };
  for (std::size_t i = 0; i < needles + small; ++i)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(surface.Points.size());
    const vtkMTRealPoint a = at({ 0, 0, 0 }, 1.0);
    const vtkMTRealPoint b = i < needles ? at({ 0, 0, 0 }, 1.0) : at(a, 1e-3);
    surface.Points.insert(surface.Points.end(), { a, b, i % 5 == 0 ? a : at(b, 1e-3) });
    surface.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return surface;
}
}

TEST(ClosestPoint, NeedlesAreDividedAndFoundWhole)
{
  for (const std::size_t needles : { 3, 200, 2000 })
  {
    const vtkMTSampledSurface surface = MakeNeedles(needles, 2000, static_cast<unsigned int>(needles));
    const vtkMTTrianglePieces pieces(surface);
    const std::vector<std::uint32_t> list = pieces.List();
    double largest = 0.0;
    std::vector<unsigned char> isThere(surface.Triangles.size(), 0);
    for (const std::uint32_t piece : list)
    {
      largest = std::max(largest, pieces.GetBounds(piece).GetDiagonal());
      isThere[pieces.GetTriangle(piece)] = 1;
    }
    std::cout << needles << " needles: " << surface.Triangles.size() << " triangles, " << list.size()
              << " pieces, the largest box " << largest << "\n";
    EXPECT_EQ(std::count(isThere.begin(), isThere.end(), 0), 0);
    EXPECT_GT(list.size(), surface.Triangles.size());
    EXPECT_LE(list.size(), 3 * surface.Triangles.size());
    EXPECT_LT(largest, 2.0) << "a needle is up to 3.4 long";
    const vtkMTClosestPoint search(surface);
    MTTestMeshes::Random random(9);
    for (int i = 0; i < 300; ++i)
    {
      const vtkMTRealPoint x = { random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5) };
      double least = HUGE_VAL;
      for (const vtkMTTriangle& t : surface.Triangles)
      {
        least = std::min(
          least, vtkMTClosestPoint::GetDistance2(x, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]]));
      }
      EXPECT_EQ(search.Find(x).Distance2, least);
    }
  }
}

TEST(ClosestPoint, EqualNeedlesAreFoundQuickly)
{
  vtkMTSampledSurface surface = MakeNeedles(1, 100, 1);
  surface.Triangles.insert(surface.Triangles.end(), 3000, surface.Triangles.front());
  const vtkMTClosestPoint search(surface);
  EXPECT_EQ(search.Find(surface.Points[0]).Triangle, 0u) << "ties go to the smaller index";
}

TEST(ClosestPoint, HandlesAnythingFromNothingToCoincidentTriangles)
{
  vtkMTSampledSurface surface;
  EXPECT_EQ(vtkMTClosestPoint(surface).Find({ 0, 0, 0 }).Triangle, vtkMTClosestPoint::NoTriangle);
  surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  surface.Triangles.assign(1000, { 0, 1, 2 });
  const vtkMTClosestPoint search(surface);
  const vtkMTClosestPoint::Result found = search.Find({ 0.25, 0.25, 2.0 }, 500);
  EXPECT_EQ(found.Distance2, 4.0);
  EXPECT_EQ(found.Triangle, 0u) << "ties go to the smaller index";
}

TEST(Sampling, IsAreaWeightedAndRepeatable)
{
  vtkMTSampledSurface surface; // areas 1, 3 and 0
  surface.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 6, 0, 0 } };
  surface.Triangles = { { 0, 1, 2 }, { 0, 3, 2 }, { 0, 1, 1 } };
  const vtkMTSurfaceSampler sampler(surface, 4000, 11);
  const vtkMTSurfaceSampler::Samples samples = sampler.Take(0, 4000);
  ASSERT_EQ(samples.Points.size(), 4000u);
  const auto count = std::count(samples.Triangles.begin(), samples.Triangles.end(), 0u);
  EXPECT_NEAR(static_cast<double>(count), 1000.0, 1.0);
  EXPECT_EQ(std::count(samples.Triangles.begin(), samples.Triangles.end(), 2u), 0);
  EXPECT_EQ(sampler.Take(1000, 1001).Points.front(), samples.Points[1000]) << "parts are the same as the whole";
  EXPECT_NE(vtkMTSurfaceSampler(surface, 4000, 12).Take(0, 1).Points, sampler.Take(0, 1).Points);
  for (const vtkMTRealPoint& x : samples.Points)
  {
    EXPECT_GE(std::min(x[0], x[1]), 0.0);
    EXPECT_LE(x[0] / 6.0 + x[1], 1.0 + 1e-12);
  }
  surface.Triangles = { { 0, 1, 1 } };
  EXPECT_EQ(vtkMTSurfaceSampler(surface, 100, 1).GetNumberOfSamples(), 0u);
}

TEST(Frame, LosesNothingAtExtremeScalesAndOffsets)
{
  for (const double size : { 1e-300, 1e-30, 1.0, 1e30, 1e300 })
  {
    vtkMTRealBounds bounds;
    bounds.Add({ -size, 0.0, 3.0 * size });
    bounds.Add({ size, size, 5.0 * size });
    const vtkMTMeasuringFrame frame = vtkMTMeasuringFrame::FromBounds(bounds);
    const vtkMTRealPoint local = frame.ToLocal({ size, size, 5.0 * size });
    for (double coordinate : local)
    {
      EXPECT_LE(std::abs(coordinate), 1.0) << size;
    }
    EXPECT_GE(local[0], 0.25) << size;
    EXPECT_EQ(frame.ToModel(local[0]), size);
  }
}

TEST(SurfaceDistance, TheTwoDirectionsAreToldApart)
{
  // A: the unit square. B: its left half. From A to B the distance grows to 1/2, from B to A it is 0.
  vtkMTSampledSurface a =
    ToSurface(MTTestMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
  vtkMTSampledSurface b = ToSurface(
    MTTestMeshes::Make({ { 0, 0, 0 }, { 0.5, 0, 0 }, { 0.5, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
  vtkMTSurfaceDistance distance;
  std::vector<double> seen;
  ASSERT_TRUE(distance.Measure(a, b, 100000, 1,
    [&seen](const std::string&, double share)
    {
      seen.push_back(share);
      return true;
    }));
  EXPECT_NEAR(distance.FromAToB.Maximum, 0.5, 1e-12);
  EXPECT_LT(distance.FromBToA.Maximum, 1e-15);
  // The mean of d^2 over A: half of it is 0, the other half the mean of t^2 for t in [0, 1/2], 1/12.
  EXPECT_NEAR(distance.FromAToB.RootMeanSquare, std::sqrt(1.0 / 24.0), 1e-3);
  EXPECT_EQ(distance.Maximum, distance.FromAToB.Maximum);
  EXPECT_NEAR(distance.Diagonal, std::sqrt(2.0), 1e-15);
  EXPECT_EQ(distance.FromAToB.Samples, 100000u);
  EXPECT_EQ(distance.FromAToB.Vertices, 4u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
  EXPECT_FALSE(distance.Measure(a, b, 100000, 1, [](const std::string&, double) { return false; }));
}
