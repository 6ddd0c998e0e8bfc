// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPiece.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace vtkMTVector;

namespace
{
double GetArea(const vtkMTPiece& piece)
{
  Vector sum{ 0.0, 0.0, 0.0 };
  for (int i = 1; i + 1 < piece.Count; ++i)
  {
    sum =
      Add(sum, Cross(Subtract(piece.Corners[i], piece.Corners[0]), Subtract(piece.Corners[i + 1], piece.Corners[0])));
  }
  return 0.5 * Norm(sum);
}

// A convex polygon with its corners on an ellipse, the largest that there is room for.
vtkMTPiece MakePiece(int corners, double width, double height)
{
  vtkMTPiece piece;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / corners;
    piece.Append({ width * std::cos(angle), height * std::sin(angle), 0.25 * width * std::cos(angle) });
  }
  return piece;
}
}

TEST(Piece, PartsAreTheWhole)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int splits = 0;
  for (int round = 0; round < 20000; ++round)
  {
    const vtkMTPiece whole =
      MakePiece(3 + round % (vtkMTPiece::Capacity - 2), 1000.0, std::pow(10.0, 3.0 * unit(random)));
    vtkMTPiece one;
    vtkMTPiece other;
    const Vector on = Lerp(whole.GetMiddle(), whole.Corners[0], unit(random));
    if (whole.Split(on, { unit(random), unit(random), unit(random) }, 1e-9, one, other))
    {
      ++splits;
      ASSERT_GE(one.Count, 2);
      ASSERT_GE(other.Count, 2);
      ASSERT_LE(std::max(one.Count, other.Count), vtkMTPiece::Capacity);
      ASSERT_EQ(one.Depth, whole.Depth + 1);
      ASSERT_NEAR(GetArea(one) + GetArea(other), GetArea(whole), 1e-9 * GetArea(whole) + 1e-9);
    }
  }
  std::printf("%d of 20000 split\n", splits);
  EXPECT_GT(splits, 5000);
}

TEST(Piece, CornersThatAreNearlyInLineHaveRoom)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int left = 0;
  for (int round = 0; round < 20000; ++round)
  {
    // Corners in line but for rounding, and a plane along that line.
    vtkMTPiece whole;
    for (int i = 0; i < vtkMTPiece::Capacity; ++i)
    {
      whole.Append({ 100.0 * i, 1e-13 * unit(random), 0.0 });
    }
    vtkMTPiece one;
    vtkMTPiece other;
    if (!whole.Split({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.0, one, other))
    {
      ++left;
      ASSERT_TRUE(one.Count == whole.Count || other.Count == whole.Count);
    }
    ASSERT_LE(std::max(one.Count, other.Count), vtkMTPiece::Capacity);
  }
  std::printf("%d of 20000 left whole\n", left);
  EXPECT_GT(left, 10000);
}

TEST(Piece, WhatAChordSplitsOffAndTheRestAreTheWhole)
{
  const vtkMTPiece whole = MakePiece(7, 1000.0, 10.0);
  for (int first = 0; first < whole.Count; ++first)
  {
    for (int count = 1; count < whole.Count; ++count)
    {
      const auto corner = [&](int i) { return whole.Corners[(i + whole.Count) % whole.Count]; };
      vtkMTPiece part;
      vtkMTPiece rest;
      ASSERT_TRUE(whole.SplitOff({ first, count, Lerp(corner(first), corner(first - 1), 0.25),
                                   Lerp(corner(first + count - 1), corner(first + count), 0.25) },
        part, rest));
      EXPECT_EQ(part.Count + rest.Count, whole.Count + 4);
      EXPECT_NEAR(GetArea(part) + GetArea(rest), GetArea(whole), 1e-6);
    }
  }
  const vtkMTPiece full = MakePiece(vtkMTPiece::Capacity, 1000.0, 10.0);
  vtkMTPiece part;
  vtkMTPiece rest;
  EXPECT_FALSE(full.SplitOff({ 0, 1, full.Corners[15], full.Corners[1] }, part, rest));
}
