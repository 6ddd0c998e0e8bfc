// SPDX-License-Identifier: BSD-3-Clause
// Certified deviations of values: what holds passes, what is too small is found, and all places within the distance are
// looked at.
#include "MTTestModel.h"

#include "Sampling/vtkMTValueSampling.h"
#include "vtkMTCut.h"
#include "vtkMTErrorSampling.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationVerifier.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>

namespace
{
constexpr double Unknown = std::numeric_limits<double>::max();

struct Figures
{
  int Tested = -1; // -1: there is no such check
  int Violations = -1;
  vtkIdType Skipped = 0;
  std::string Message;
};

Figures Verify(const vtkMTPatchStore& store)
{
  const vtkMTGraph& graph = store.GetGraph();
  vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_TRUE(vtkMultiTriangulation::CutToPolyData(store, vtkMTErrorSampling::MakeLevelCut(graph, 0), mesh, error));
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  verifier->SetNumberOfCuts(8);
  verifier->SetNumberOfSamples(2000);
  EXPECT_TRUE(verifier->Verify(store, [&](std::string&) { return std::make_unique<vtkMTPolyDataStream>(mesh); }))
    << verifier->GetErrorMessage();
  Figures figures;
  figures.Skipped = verifier->GetNumberOfSkippedValues();
  vtkTable* checks = verifier->GetChecks();
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    if (checks->GetValueByName(row, "name").ToString() == "certified_values")
    {
      figures.Tested = checks->GetValueByName(row, "tested").ToInt();
      figures.Violations = checks->GetValueByName(row, "violations").ToInt();
      figures.Message = checks->GetValueByName(row, "message").ToString();
    }
    else
    {
      EXPECT_EQ(checks->GetValueByName(row, "violations").ToInt(), 0)
        << checks->GetValueByName(row, "name").ToString() << ": " << checks->GetValueByName(row, "message").ToString();
    }
  }
  std::cout << figures.Tested << " tested, " << figures.Violations << " violations, " << figures.Skipped << " skipped. "
            << figures.Message << "\n";
  return figures;
}

// The measure of an array: a number for each node but the sink.
void SetDeviation(vtkMTPatchStore& store, const std::string& array, const std::function<double(const vtkMTNode&)>& get)
{
  vtkMTGraph& graph = store.GetMutableGraph();
  vtkMTMeasure measure{ vtkMTMeasure::GetValueDeviationName(array), {} };
  for (const vtkMTNode& node : graph.Nodes)
  {
    measure.Values.push_back(get(node));
  }
  measure.Values.back() = 0.0;
  graph.Measures = { measure };
}

// Replaces the heights of the finest level, or of all others.
void EditHeights(vtkMTPatchStore& store, bool finest, const std::function<float(float, std::size_t)>& get)
{
  for (std::uint32_t arc = 0; arc < store.GetGraph().Arcs.size(); ++arc)
  {
    if (store.GetGraph().IsFinest(arc) == finest)
    {
      vtkMTColumn& column = store.GetMutablePatches().at(arc).PointColumns.at(0);
      for (std::size_t i = 0; i < column.size() / sizeof(float); ++i)
      {
        float value;
        std::memcpy(&value, column.data() + i * sizeof(float), sizeof(float));
        value = get(value, i);
        std::memcpy(column.data() + i * sizeof(float), &value, sizeof(float));
      }
    }
  }
}

// Lets coarse levels be this much farther from the finest one than they are.
void AddError(vtkMTPatchStore& store, double error)
{
  vtkMTGraph& graph = store.GetMutableGraph();
  for (std::uint32_t i = 0; i < graph.GetSink(); ++i)
  {
    graph.Nodes[i].Error += error;
    graph.Nodes[i].OwnError += i > 0 ? 0.9 * error : 0.0; // with the lattice's rounding it is at most Error
  }
}

TEST(VerifyValues, ThereIsNoCheckWhereNothingWasCertified)
{
  EXPECT_EQ(Verify(*MTTestModel::MakeTube()).Tested, -1);
}

// The height is a coordinate, so it deviates by no more than the distance; floats are rounded.
TEST(VerifyValues, ADeviationThatHoldsPasses)
{
  const auto store = MTTestModel::MakeTube();
  SetDeviation(*store, "height", [](const vtkMTNode& node) { return node.Error + 1e-7; });
  const Figures figures = Verify(*store);
  EXPECT_EQ(figures.Violations, 0);
  EXPECT_GT(figures.Tested, 50000);
  EXPECT_EQ(figures.Skipped, 0);
}

// All coarse values are off by the same, and the finest ones are almost one value.
TEST(VerifyValues, ADeviationThatIsTooSmallIsFound)
{
  MTTestModel::TubeOptions
    options; // a small one: where nothing is found all triangles within the distance are searched
  options.Rings = 64;
  options.Regions = 4;
  const auto store = MTTestModel::MakeTube(options);
  EditHeights(*store, true, [](float height, std::size_t) { return 7.0f + 1e-4f * height; });
  EditHeights(*store, false, [](float height, std::size_t) { return 7.5f + 1e-4f * height; });
  const auto verify = [&](double deviation)
  {
    SetDeviation(*store, "height", [=](const vtkMTNode&) { return deviation; });
    return Verify(*store);
  };
  EXPECT_EQ(verify(0.5002).Violations, 0);
  for (const double deviation : { 0.499, 0.05, 0.0 })
  {
    const Figures figures = verify(deviation);
    EXPECT_GT(figures.Violations, figures.Tested / 2);
    EXPECT_NE(figures.Message.find("'height'"), std::string::npos) << figures.Message;
  }
  EditHeights(*store, false, [](float, std::size_t) { return 7.0f; });
  EXPECT_EQ(verify(5e-5).Violations, 0);
}

// One patch alone has a wrong value at one of its corners.
TEST(VerifyValues, OneWrongValueIsFound)
{
  const auto store = MTTestModel::MakeTube();
  SetDeviation(*store, "height", [](const vtkMTNode& node) { return node.Error + 1e-7; });
  const float wrong = 3.0f;
  std::memcpy(store->GetMutablePatches().at(0).PointColumns.at(0).data(), &wrong, sizeof(wrong));
  const Figures figures = Verify(*store);
  EXPECT_GT(figures.Violations, 0);
  EXPECT_LT(figures.Violations, figures.Tested / 10);
}

// Every value is there, but not at the nearest place.
TEST(VerifyValues, AllPlacesWithinTheDistanceAreLookedAt)
{
  const auto store = MTTestModel::MakeTube();
  EditHeights(*store, true, [](float height, std::size_t) { return std::clamp(height, -0.15f, 0.15f); });
  EditHeights(*store, false, [](float height, std::size_t) { return std::clamp(0.9f * height, -0.15f, 0.15f); });
  SetDeviation(*store, "height", [](const vtkMTNode&) { return 1e-6; });
  EXPECT_GT(Verify(*store).Violations, 0) << "the distance is too small for that";
  AddError(*store, 0.25);
  EXPECT_EQ(Verify(*store).Violations, 0);
  EditHeights(*store, false, [](float height, std::size_t) { return height == 0.15f ? 0.1501f : height; });
  const Figures higher = Verify(*store);
  EXPECT_GT(higher.Violations, 0) << "that is nowhere on the finest level";
  EXPECT_LT(higher.Violations, higher.Tested / 2);
}

TEST(VerifyValues, ArraysOfCellsAreConstantOverTriangles)
{
  const auto store = MTTestModel::MakeTube();
  const char* name = "vtkMTInputCellIds";
  double triangles = 0.0;
  for (const vtkMTArc& arc : store->GetGraph().Arcs)
  {
    triangles += arc.To == store->GetGraph().GetSink() ? arc.Triangles : 0.0;
  }
  SetDeviation(*store, name, [=](const vtkMTNode&) { return triangles; });
  EXPECT_EQ(Verify(*store).Violations, 0);
  SetDeviation(*store, name, [=](const vtkMTNode&) { return 0.0; });
  const Figures none = Verify(*store);
  EXPECT_GT(none.Violations, 0);
  EXPECT_NE(none.Message.find(name), std::string::npos);
  // Cells of one ring, or of few: a tenth of that is not enough.
  EXPECT_LT(none.Violations, none.Tested);
}

TEST(VerifyValues, NanIsSkippedAndCertifiesNothing)
{
  const auto store = MTTestModel::MakeTube();
  const auto blank = [](float height, std::size_t i) { return i % 16 < 2 ? std::nanf("") : height; };
  EditHeights(*store, true, blank);
  SetDeviation(*store, "height", [](const vtkMTNode& node) { return node.Error + 1e-7; });
  const Figures finite = Verify(*store);
  EXPECT_GT(finite.Skipped, 0);
  EXPECT_GT(finite.Violations, 0) << "coarse values have no counterpart where the finest ones are not numbers";
  EditHeights(*store, false, blank);
  SetDeviation(*store, "height", [](const vtkMTNode&) { return Unknown; });
  const Figures unknown = Verify(*store);
  EXPECT_GT(unknown.Skipped, finite.Skipped);
  EXPECT_GT(unknown.Tested, 0);
  EXPECT_EQ(unknown.Violations, 0);
}

// Two arrays are one check, and the message says which one it is.
TEST(VerifyValues, SeveralArraysAreOneCheck)
{
  const auto store = MTTestModel::MakeTube();
  SetDeviation(*store, "vtkMTInputCellIds", [](const vtkMTNode&) { return 0.0; });
  const vtkMTMeasure cells = store->GetGraph().Measures[0];
  SetDeviation(*store, "height", [](const vtkMTNode& node) { return node.Error + 1e-7; });
  const Figures height = Verify(*store);
  store->GetMutableGraph().Measures.push_back(cells);
  const Figures both = Verify(*store);
  EXPECT_EQ(both.Tested, 2 * height.Tested);
  EXPECT_EQ(height.Violations, 0);
  EXPECT_GT(both.Violations, 0);
  EXPECT_NE(both.Message.find("'vtkMTInputCellIds'"), std::string::npos) << both.Message;
}

//------------------------------------------------------------------------------
// What is asked of one triangle.
class OneTriangle : public vtkMTValueSampling
{
public:
  explicit OneTriangle(const vtkMTPatchSource& source)
    : vtkMTValueSampling(source, 1, 1)
  {
    this->Triangle.Surface.Triangles.push_back({ 0, 1, 2 });
  }

  // The distance from x to the part of the triangle where the value is within the node's deviation of the wanted one.
  double GetDistance(const std::array<vtkMTRealPoint, 3>& corners, const std::array<double, 3>& values,
    const vtkMTRealPoint& x, double value)
  {
    this->Triangle.Surface.Points.assign(corners.begin(), corners.end());
    this->Triangle.Data.assign(values.begin(), values.end());
    const Wanted wanted{ x, { value, 0.0, 0.0 }, 0 };
    double low = 0.0;
    double high = 100.0;
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (this->HasPoint(this->Triangle, 0, wanted, 0, middle) ? high : low) = middle;
    }
    return high;
  }

private:
  Side Triangle;
};

// A grid of places has one within a cell of every place.
TEST(VerifyValues, TheNearestPlaceOfATriangleWithTheValueIsFound)
{
  const auto store = MTTestModel::MakeTube();
  const double deviation = 0.1;
  SetDeviation(*store, "height", [=](const vtkMTNode&) { return deviation; });
  OneTriangle triangle(*store);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  constexpr int cells = 40;
  int none = 0;
  int cut = 0;
  double widest = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    std::array<vtkMTRealPoint, 3> corners;
    std::array<double, 3> values;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = { draw(random), draw(random), i % 5 == 0 ? 0.0 : draw(random) };
      values[k] = (i % 3 == 0 ? 0.1 : 1.0) * draw(random);
    }
    const vtkMTRealPoint x{ draw(random), draw(random), draw(random) };
    const double value = draw(random);
    double upper = 100.0;
    double lower = 100.0;
    double whole = 100.0;
    const double side = 4.0 / cells;
    for (int u = 0; u <= cells; ++u)
    {
      for (int v = 0; u + v <= cells; ++v)
      {
        const double w[3] = { double(cells - u - v) / cells, double(u) / cells, double(v) / cells };
        double square = 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double y = w[0] * corners[0][axis] + w[1] * corners[1][axis] + w[2] * corners[2][axis];
          square += (y - x[axis]) * (y - x[axis]);
        }
        const double off = std::abs(w[0] * values[0] + w[1] * values[1] + w[2] * values[2] - value);
        upper = off <= deviation ? std::min(upper, std::sqrt(square)) : upper;
        lower = off <= deviation + 2.0 / cells ? std::min(lower, std::sqrt(square) - side) : lower;
        whole = std::min(whole, std::sqrt(square));
      }
    }
    const double found = triangle.GetDistance(corners, values, x, value);
    ASSERT_LE(found, upper + 1e-9) << i;
    ASSERT_GE(found, lower) << i;
    none += found > 99.0 ? 1 : 0;
    cut += found < 99.0 && found > whole + side ? 1 : 0;
    widest = found < 99.0 && upper < 99.0 ? std::max(widest, upper - found) : widest;
  }
  std::cout << none << " without such a place, " << cut << " where it is not the nearest one, the grid's is up to "
            << widest << " farther\n";
  EXPECT_GT(none, 300);
  EXPECT_GT(cut, 300);
}
}
