// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "vtkMTLattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using MTTestMeshes::Random;

struct Scene
{
  const char* Name;
  double Bounds[6];
};

const Scene Scenes[] = {
  { "unit", { 0, 1, 0, 1, 0, 1 } },
  { "UTM", { 500000, 501000, 5400000, 5402000, 100, 900 } },
  { "far and small", { 5e6, 5e6 + 1e-6, 0, 1e-6, 0, 0 } },
  { "1e-30", { -1e-30, 2e-30, 0, 1e-30, 3e-31, 4e-31 } },
  { "1e30", { -1e30, 2e30, 0, 1e30, 3e29, 4e29 } },
  { "the largest doubles", { -1.7e308, 1.7e308, 0, 1, 0, 1 } },
  { "subnormal", { 0, 1e-310, 0, 0, 0, 0 } },
  { "flat", { -3, 5, -2, 7, 11, 11 } },
  { "one point", { 0.1, 0.1, 12345.678, 12345.678, -7e-5, -7e-5 } },
  { "the origin", { 0, 0, 0, 0, 0, 0 } },
};

std::array<double, 3> RandomPlace(const double bounds[6], Random& random)
{
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i)
  {
    const double t = random.Uniform();
    x[i] = (1.0 - t) * bounds[2 * i] + t * bounds[2 * i + 1];
    x[i] = std::min(std::max(x[i], bounds[2 * i]), bounds[2 * i + 1]);
  }
  return x;
}

// The distance, without overflow or underflow in between.
double GetDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
}

TEST(Lattice, SnappingNeverShiftsMoreThanMaximumShift)
{
  for (const Scene& scene : Scenes)
  {
    for (int bits : { 0, 10, 24, 31, 99 })
    {
      const vtkMTLattice lattice = vtkMTLattice::FromBounds(scene.Bounds, bits);
      Random random(7);
      double worst = 0.0;
      for (int i = 0; i < 2000; ++i)
      {
        std::array<double, 3> x = RandomPlace(scene.Bounds, random);
        for (int j = 0; i < 8 && j < 3; ++j)
        {
          x[j] = scene.Bounds[2 * j + ((i >> j) & 1)]; // the corners of the box as well
        }
        worst = std::max(worst, GetDistance(x, lattice.ToWorld(lattice.Snap(x.data()))));
      }
      EXPECT_LE(worst, lattice.MaximumShift) << scene.Name << ", " << bits << " bits";
      EXPECT_GT(lattice.MaximumShift, 0.0);
      if (bits == 24)
      {
        std::cout << scene.Name << ": step " << lattice.Step << ", worst shift / bound " << worst / lattice.MaximumShift
                  << "\n";
      }
    }
  }
}

TEST(Lattice, PlacesAreExactInDoublePrecision)
{
  for (const Scene& scene : Scenes)
  {
    for (int bits : { 10, 24, 31 })
    {
      const vtkMTLattice lattice = vtkMTLattice::FromBounds(scene.Bounds, bits);
      int exponent = 0;
      EXPECT_EQ(std::frexp(lattice.Step, &exponent), 0.5) << scene.Name;
      Random random(3);
      for (int i = 0; i < 1000; ++i)
      {
        const std::array<double, 3> x = RandomPlace(scene.Bounds, random);
        const vtkMTPoint k = lattice.Snap(x.data());
        const std::array<double, 3> place = lattice.ToWorld(k);
        for (int j = 0; j < 3; ++j)
        {
          // 64 bits of mantissa: this product has no rounding.
          const long double exact =
            static_cast<long double>(lattice.Step) * static_cast<long double>(lattice.Origin[j] + k[j]);
          ASSERT_EQ(static_cast<long double>(place[j]), exact) << scene.Name;
        }
        ASSERT_EQ(lattice.Snap(place.data()), k) << scene.Name << ": what is on the lattice stays where it is";
      }
    }
  }
}

TEST(Lattice, StepIsTheFinestThatBitsAndDoublePrecisionAllow)
{
  for (int bits = vtkMTLattice::MinimumBits; bits <= vtkMTLattice::MaximumBits; ++bits)
  {
    for (double side : { 1.0, 1.0 + 1e-9, 3.0, 1023.0 })
    {
      const double bounds[6] = { -1, -1 + side, 0, 0, 0, 0 };
      const vtkMTLattice lattice = vtkMTLattice::FromBounds(bounds, bits);
      EXPECT_LE(side / lattice.Step, std::ldexp(1.0, bits));
      EXPECT_GT(side / lattice.Step, std::ldexp(1.0, bits - 1));
    }
  }
  const double far[6] = { 5e6, 5e6 + 1e-6, 0, 0, 0, 0 };
  EXPECT_EQ(vtkMTLattice::FromBounds(far).Step, std::nextafter(5e6, 1e9) - 5e6);
}

TEST(Lattice, ThirtyOneBitsFitIntoTheIntegers)
{
  const double bounds[6] = { 0.0, 0x1p31, -0x1p31, 0.0, 7.0, 0x1p31 + 7.0 };
  const vtkMTLattice lattice = vtkMTLattice::FromBounds(bounds, 31);
  EXPECT_EQ(lattice.Step, 1.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<double, 3> x{ bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)] };
    EXPECT_EQ(lattice.ToWorld(lattice.Snap(x.data())), x);
  }
}

TEST(Lattice, OnePointKeepsTheCoordinatesThatItsFarthestOneResolves)
{
  const double x[3] = { 0.1, 12345.678, -7e-5 };
  const double bounds[6] = { x[0], x[0], x[1], x[1], x[2], x[2] };
  const vtkMTLattice lattice = vtkMTLattice::FromBounds(bounds);
  const std::array<double, 3> place = lattice.ToWorld(lattice.Snap(x));
  EXPECT_EQ(place[1], x[1]);
  EXPECT_NEAR(place[0], x[0], 1e-12);
  EXPECT_NEAR(place[2], x[2], 1e-12);
}

TEST(Lattice, BadNumbersAreDefinedBehaviour)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double bad[6] = { 0, nan, 0, 1, 0, 1 };
  EXPECT_EQ(vtkMTLattice::FromBounds(bad).Step, 1.0);
  const double inverted[6] = { 1, -1, 1, -1, 1, -1 };
  EXPECT_EQ(vtkMTLattice::FromBounds(inverted).Step, 1.0);
  const double bounds[6] = { 0, 1, 0, 1, 0, 1 };
  const vtkMTLattice lattice = vtkMTLattice::FromBounds(bounds);
  const double wild[3] = { nan, 1e300, -1e300 };
  const vtkMTPoint k = lattice.Snap(wild);
  EXPECT_EQ(k[0], std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(k[1], std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(k[2], std::numeric_limits<std::int32_t>::min());
  double empty[6];
  lattice.ToWorld(vtkMTBox{ 0, -1, 0, -1, 0, -1 }, empty);
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(empty));
}
