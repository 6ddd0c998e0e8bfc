// SPDX-License-Identifier: BSD-3-Clause
// Lines from many directions hit what a search over all triangles of the cut hits.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStore.h"
#include "vtkMath.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationLocator.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkTransform.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Place = std::array<double, 3>;

struct Line
{
  Place Begin;
  Place End;
};

// What a call before this one may have left on the stack: a value that outlived its memory is not what it was.
__attribute__((noinline)) void LeaveOnTheStack(double value)
{
  volatile double left[512];
  for (volatile double& number : left)
  {
    number = value;
  }
}

// Through the box, evenly from all directions, and along the axes, each way.
std::vector<Line> GetLines(const double bounds[6], int count)
{
  Place center;
  double radius = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    radius = std::max(radius, bounds[2 * i + 1] - bounds[2 * i]);
  }
  std::vector<Line> lines;
  const auto add = [&](const Place& direction, double aside, double along)
  {
    Line line;
    for (int i = 0; i < 3; ++i)
    {
      const double shift = radius * (aside * direction[(i + 1) % 3] - along * direction[(i + 2) % 3]);
      line.Begin[i] = center[i] + shift - 2.0 * radius * direction[i];
      line.End[i] = center[i] + shift + 2.0 * radius * direction[i];
    }
    lines.push_back(line);
  };
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = 2.399963229728653 * i;
    const double r = std::sqrt(1.0 - z * z);
    add({ r * std::cos(angle), r * std::sin(angle), z }, 0.01 * (i % 37), 0.013 * (i % 29));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      for (int i = 0; i < 10; ++i)
      {
        Place direction{ 0.0, 0.0, 0.0 };
        direction[axis] = sign;
        add(direction, 0.037 * i - 0.15, 0.051 * i - 0.2);
      }
    }
  }
  return lines;
}

struct Hit
{
  double T = std::numeric_limits<double>::infinity();
  std::set<vtkIdType> Cells; // the input's, of all triangles that are hit there
};

// By the volumes of tetrahedra, so that nothing is shared with the locator's arithmetic.
Hit FindByBruteForce(vtkPolyData* mesh, const Line& line)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("CellIds"));
  Hit best;
  std::vector<std::pair<double, vtkIdType>> hits;
  const auto volume = [](const Place& a, const Place& b, const Place& c, const Place& d)
  {
    const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
    return vtkMath::Determinant3x3(u, v, w);
  };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* points;
    mesh->GetCellPoints(cell, count, points);
    std::array<Place, 3> t;
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(points[i], t[i].data());
    }
    const double sides[3] = { volume(line.Begin, line.End, t[0], t[1]), volume(line.Begin, line.End, t[1], t[2]),
      volume(line.Begin, line.End, t[2], t[0]) };
    const double sum = std::abs(sides[0] + sides[1] + sides[2]);
    const bool isInside = sum > 0.0 &&
      (std::min({ sides[0], sides[1], sides[2] }) >= -1e-12 * sum ||
        std::max({ sides[0], sides[1], sides[2] }) <= 1e-12 * sum);
    const double before = volume(line.Begin, t[0], t[1], t[2]);
    const double after = volume(line.End, t[0], t[1], t[2]);
    if (isInside && before * after <= 0.0 && before != after)
    {
      hits.emplace_back(before / (before - after), ids->GetValue(cell));
      best.T = std::min(best.T, hits.back().first);
    }
  }
  for (const auto& hit : hits)
  {
    if (hit.first <= best.T + 1e-9)
    {
      best.Cells.insert(hit.second);
    }
  }
  return best;
}

struct Found
{
  bool Hit = false;
  double T = -1.0;
  Place Where{};
  Place Weights{};
  vtkIdType Cell = -1;
  Place Again{}; // by the cell's corners
};

Found Ask(vtkMultiTriangulationLocator* locator, const Line& line, double left)
{
  Found found;
  int part = -1;
  vtkNew<vtkGenericCell> cell;
  LeaveOnTheStack(left);
  found.Hit = locator->IntersectWithLine(line.Begin.data(), line.End.data(), 0.0, found.T, found.Where.data(),
                found.Weights.data(), part, found.Cell, cell) != 0;
  for (int i = 0; i < 3 && found.Hit; ++i)
  {
    double corner[3];
    cell->GetPoints()->GetPoint(i, corner);
    const double weight =
      i == 0 ? 1.0 - found.Weights[0] - found.Weights[1] : found.Weights[static_cast<std::size_t>(i - 1)];
    for (int k = 0; k < 3; ++k)
    {
      found.Again[k] += weight * corner[k];
    }
  }
  return found;
}

// Compares a mapper's locator with the search over all triangles of what it drew last.
void ExpectTheHitsOfBruteForce(vtkMultiTriangulationMapper* mapper, int count)
{
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  mesh->BuildCells();
  vtkNew<vtkMultiTriangulationLocator> locator;
  locator->SetMapper(mapper);
  double bounds[6];
  mesh->GetBounds(bounds);
  int hits = 0;
  int asked = 0;
  for (const Line& line : GetLines(bounds, count))
  {
    const Hit expected = FindByBruteForce(mesh, line);
    ++asked;
    for (const double left : { 0.0, 0.5, -1.0, 2.0, 1e300, std::numeric_limits<double>::quiet_NaN() })
    {
      const Found found = Ask(locator, line, left);
      ASSERT_EQ(found.Hit, !expected.Cells.empty()) << "line " << asked << ", " << left << " left on the stack";
      if (!found.Hit)
      {
        EXPECT_EQ(locator->GetDistanceToInput(), 0.0);
        continue;
      }
      hits += left == 0.0;
      EXPECT_GT(locator->GetDistanceToInput() + locator->GetDistanceFromInput(), 0.0);
      EXPECT_LE(locator->GetDistanceToInput(), mapper->GetDistanceToInput());
      EXPECT_LE(locator->GetDistanceFromInput(), mapper->GetDistanceFromInput());
      EXPECT_NEAR(found.T, expected.T, 1e-9);
      EXPECT_EQ(expected.Cells.count(found.Cell), 1u) << "cell " << found.Cell;
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(found.Where[i], line.Begin[i] + expected.T * (line.End[i] - line.Begin[i]), 1e-8);
        EXPECT_NEAR(found.Where[i], found.Again[i], 1e-8);
      }
    }
  }
  std::cout << asked << " lines, " << hits << " hit one of " << mesh->GetNumberOfPolys() << " triangles\n";
  EXPECT_GT(hits, asked / 4);
  EXPECT_LT(hits, asked);
}

TEST(Locator, LinesFromAllDirectionsHitWhatBruteForceHits)
{
  for (const double pixelError : { 1.0, 8.0 })
  {
    vtkNew<vtkMultiTriangulation> model;
    ASSERT_TRUE(model->SetSource(MTGridModel().Make()));
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(model);
    mapper->SetPixelError(pixelError);
    mapper->FrustumCullingOff();
    MTScene scene(mapper);
    scene.Render();
    ExpectTheHitsOfBruteForce(mapper, 200);
  }
}

TEST(Locator, ModelsThatAFrameMovesAreHitWhereTheyAre)
{
  for (const double mirror : { 1.0, -1.0 })
  {
    vtkNew<vtkMultiTriangulation> model;
    ASSERT_TRUE(model->SetSource(MTGridModel().Make()));
    vtkNew<vtkTransform> transform;
    transform->Translate(3.0, -2.0, 1.0);
    transform->RotateWXYZ(40.0, 1.0, 0.4, 0.3);
    transform->Scale(2.0 * mirror, 1.0, 1.5);
    ASSERT_TRUE(model->ApplyTransform(transform->GetMatrix()->GetData()));
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(model);
    mapper->SetPixelError(2.0);
    mapper->FrustumCullingOff();
    MTScene scene(mapper);
    scene.Render();
    ExpectTheHitsOfBruteForce(mapper, 100);
  }
}
}
