// SPDX-License-Identifier: BSD-3-Clause
// The cells of a triangle below those of another mesh: they cover it, and none is farther away than it says.
#include "MTTestMeshes.h"

#include "vtkMTCellsOver.h"
#include "vtkMTSurface.h"
#include "vtkMTVector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using Random = MTTestMeshes::Random;
using Vector = vtkMTSurface::Vector;
const vtkMTPoint Origin{ 0, 0, 0 };

// A field of cells with random heights, points off their places, and here and there none.
vtkMTPatch MakeField(Random& random, int side, int step, double height, double holes)
{
  vtkMTPatch mesh;
  for (int j = 0; j <= side; ++j)
  {
    for (int i = 0; i <= side; ++i)
    {
      const auto off = [&] { return static_cast<std::int32_t>(0.4 * step * (random.Uniform() - 0.5)); };
      mesh.Points.push_back(
        { step * i + off(), step * j + off(), static_cast<std::int32_t>(height * (random.Uniform() - 0.5)) });
    }
  }
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const auto a = static_cast<std::uint32_t>(j * (side + 1) + i);
      const std::uint32_t c = a + static_cast<std::uint32_t>(side) + 1;
      if (random.Uniform() >= holes)
      {
        mesh.Triangles.push_back({ a, a + 1, c + 1 });
        mesh.Triangles.push_back({ a, c + 1, c });
      }
    }
  }
  return mesh;
}

// How far outside of a convex shape in one plane a place is.
double GetOutside(const vtkMTPiece& shape, const Vector& normal, const Vector& x)
{
  double outside = 0.0;
  for (int i = 0; i < shape.Count; ++i)
  {
    const Vector along = vtkMTVector::Subtract(shape.Corners[(i + 1) % shape.Count], shape.Corners[i]);
    const Vector inward = vtkMTVector::Cross(normal, along);
    const double length = vtkMTVector::Norm(along);
    const double inside = vtkMTVector::Dot(vtkMTVector::Subtract(x, shape.Corners[i]), inward);
    outside = std::max(outside, length > 0.0 ? -inside / length : 0.0);
  }
  return outside;
}
}

TEST(CellsOver, CoverTheTriangleAndAreNoFartherThanTheySay)
{
  std::size_t found = 0;
  std::size_t beyond = 0;
  std::size_t asked = 0;
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    Random random(seed);
    const vtkMTPatch fine = MakeField(random, 24, 100, seed % 3 == 0 ? 200.0 : 30.0, seed % 2 == 0 ? 0.02 : 0.0);
    const vtkMTPatch coarse = MakeField(random, 7, seed % 5 == 0 ? 70 : 400, 60.0, 0.0);
    const vtkMTSurface to(fine, Origin);
    const vtkMTSurface from(coarse, Origin);
    vtkMTCellsOver over(from, to);
    for (std::uint32_t t = 0; t < from.GetNumberOfTriangles(); ++t)
    {
      ++asked;
      over.Begin(t, static_cast<std::uint32_t>(random.Uniform() * static_cast<double>(to.GetNumberOfTriangles())));
      if (!over.HasBegun() || !over.Split())
      {
        continue;
      }
      ++found;
      most = std::max(most, over.GetCells().size());
      for (int sample = 0; sample < 40; ++sample)
      {
        const double a = random.Uniform();
        const double b = (1.0 - a) * random.Uniform();
        const Vector& origin = from.GetCorner(t, 0);
        const Vector x = vtkMTVector::Add(origin,
          vtkMTVector::Add(vtkMTVector::Scale(vtkMTVector::Subtract(from.GetCorner(t, 1), origin), a),
            vtkMTVector::Scale(vtkMTVector::Subtract(from.GetCorner(t, 2), origin), b)));
        double least = std::numeric_limits<double>::infinity();
        for (const vtkMTCellsOver::Cell& cell : over.GetCells())
        {
          vtkMTPiece shape;
          over.GetShape(cell, shape);
          const double outside = GetOutside(shape, from.GetNormal(t), x);
          least = std::min(least, outside);
          if (outside > 0.0)
          {
            continue;
          }
          beyond += std::isfinite(cell.Height) ? 0 : 1;
          const double distance2 = to.GetDistance2(x, cell.Triangle, std::numeric_limits<double>::infinity());
          EXPECT_LE(std::sqrt(distance2), cell.Height + 1e-6);
        }
        EXPECT_LT(least, 1e-6) << "triangle " << t << ", seed " << seed << ", x " << x[0] << " " << x[1];
      }
    }
  }
  std::cout << found << " of " << asked << " triangles have cells, up to " << most << "; " << beyond
            << " places are beyond borders\n";
  EXPECT_GT(found, asked / 2);
  EXPECT_GT(beyond, 100u);
}
