// SPDX-License-Identifier: BSD-3-Clause
// Picks and selections on coarse triangles of a model that keeps the input's ids on its finest level.
#include "MTPicture.h"
#include "MTTestMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationLocator.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <vector>

namespace
{
using Builder = vtkMultiTriangulationBuilder;
using Place = std::array<double, 3>;

vtkPolyData* GetInput()
{
  static const MTTestMeshes::Mesh input = MTTestMeshes::FractalSphere(6);
  return input;
}

vtkMultiTriangulation* GetModel(int ids)
{
  const auto build = [](int which)
  {
    vtkNew<Builder> builder;
    builder->SetInputData(GetInput());
    builder->SetPatchTriangles(250);
    builder->SetInputIds(which);
    builder->InputPointIdsOn();
    builder->Update();
    return vtkSmartPointer<vtkMultiTriangulation>(vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0)));
  };
  static const vtkSmartPointer<vtkMultiTriangulation> finest = build(Builder::FinestInputIds);
  static const vtkSmartPointer<vtkMultiTriangulation> all = build(Builder::AllInputIds);
  return ids == Builder::AllInputIds ? all : finest;
}

// The window's middle, which a selector looks at.
constexpr unsigned int Middle[4] = { 110, 110, 190, 190 };

struct View
{
  explicit View(double pixelError, int ids = Builder::FinestInputIds)
    : Scene(Mapper)
  {
    this->Mapper->SetInputData(GetModel(ids));
    this->Mapper->SetPixelError(pixelError);
    this->Scene.Renderer->ResetCamera();
    this->Scene.Render();
  }
  // The same, as VTK's own mapper shows it: the cells or points of the mesh.
  std::set<vtkIdType> SelectInMesh(int association)
  {
    EXPECT_TRUE(this->Mapper->GetCut(this->Mesh));
    vtkNew<vtkPolyDataMapper> reference;
    reference->SetInputData(this->Mesh);
    reference->ScalarVisibilityOff();
    MTScene plain(reference);
    plain.Renderer->ResetCamera(GetModel(Builder::FinestInputIds)->GetBounds());
    plain.Renderer->GetActiveCamera()->DeepCopy(this->Scene.Renderer->GetActiveCamera());
    plain.Render();
    return plain.Select(association, Middle);
  }
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  MTScene Scene;
  vtkNew<vtkPolyData> Mesh;
};

std::array<Place, 3> GetCorners(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  std::array<Place, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    mesh->GetPoint(ids->GetId(i), corners[i].data());
  }
  return corners;
}

double GetDistance(vtkIdType inputCell, const Place& x)
{
  static const vtkNew<vtkTriangle> triangle;
  const std::array<Place, 3> corners = GetCorners(GetInput(), inputCell);
  for (int i = 0; i < 3; ++i)
  {
    triangle->GetPoints()->SetPoint(i, corners[i].data());
  }
  double closest[3];
  double coordinates[3];
  double weights[3];
  double distance2 = 0.0;
  int part = 0;
  triangle->EvaluatePosition(x.data(), closest, part, coordinates, distance2, weights);
  return std::sqrt(distance2);
}

double FindNearest(const Place& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType c = 0; c < GetInput()->GetNumberOfCells(); ++c)
  {
    least = std::min(least, GetDistance(c, x));
  }
  return least;
}

double FindNearestPoint(const Place& x, vtkIdType id, double& ofId)
{
  double least = std::numeric_limits<double>::infinity();
  double y[3];
  for (vtkIdType p = 0; p < GetInput()->GetNumberOfPoints(); ++p)
  {
    GetInput()->GetPoint(p, y);
    least = std::min(least, vtkMath::Distance2BetweenPoints(x.data(), y));
  }
  GetInput()->GetPoint(id, y);
  ofId = std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), y));
  return std::sqrt(least);
}

double GetTolerance()
{
  const vtkMTLattice& lattice = GetModel(Builder::FinestInputIds)->GetSource()->GetGraph().Lattice;
  return 2.0 * lattice.MaximumShift + lattice.Step;
}
}

// The sphere's folds are far from each other here, so the nearest cell of all is the one that faces the same way.
TEST(MapperInputIds, SelectorOnACoarseViewGivesTheCellsNearestToTheTriangles)
{
  View view(6.0);
  const auto begin = std::chrono::steady_clock::now();
  const std::set<vtkIdType> ids = view.Scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, Middle);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  const std::set<vtkIdType> triangles = view.SelectInMesh(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto* kept = vtkIdTypeArray::SafeDownCast(view.Mesh->GetCellData()->GetArray("vtkMTInputCellIds"));
  std::set<vtkIdType> expected;
  int coarse = 0;
  int without = 0;
  for (const vtkIdType t : triangles)
  {
    coarse += kept->GetValue(t) < 0 ? 1 : 0;
    const std::array<Place, 3> corners = GetCorners(view.Mesh, t);
    Place middle;
    vtkTriangle::TriangleCenter(corners[0].data(), corners[1].data(), corners[2].data(), middle.data());
    const double nearest = FindNearest(middle);
    bool isThere = false;
    for (const vtkIdType id : ids)
    {
      if (id < GetInput()->GetNumberOfCells() && GetDistance(id, middle) <= nearest + GetTolerance())
      {
        isThere = true;
        expected.insert(id);
      }
    }
    without += isThere ? 0 : 1;
  }
  std::cout << triangles.size() << " triangles selected, " << coarse << " of them coarse: " << ids.size()
            << " cells of the input, " << ids.size() - expected.size() << " of them nearest to none, " << without
            << " triangles without theirs; " << time.count() << " ms\n";
  EXPECT_GT(coarse, 50);
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(without, 0);
}

TEST(MapperInputIds, WithIdsOnAllLevelsSelectorGivesThoseOfTheTriangles)
{
  View view(6.0, Builder::AllInputIds);
  const std::set<vtkIdType> ids = view.Scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, Middle);
  std::set<vtkIdType> expected;
  const std::set<vtkIdType> triangles = view.SelectInMesh(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto* kept = vtkIdTypeArray::SafeDownCast(view.Mesh->GetCellData()->GetArray("vtkMTInputCellIds"));
  for (const vtkIdType t : triangles)
  {
    expected.insert(kept->GetValue(t));
  }
  EXPECT_GT(ids.size(), 50u);
  EXPECT_EQ(ids, expected);
}

TEST(MapperInputIds, PointsAreSelectedByTheInputsIdsWithNoArrayNamed)
{
  for (const double pixelError : { 0.0, 6.0 })
  {
    View view(pixelError);
    const std::set<vtkIdType> ids = view.Scene.Select(vtkDataObject::FIELD_ASSOCIATION_POINTS, Middle);
    const std::set<vtkIdType> points = view.SelectInMesh(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    std::set<vtkIdType> expected;
    double worst = 0.0;
    for (const vtkIdType p : points)
    {
      Place x;
      view.Mesh->GetPoint(p, x.data());
      double best = std::numeric_limits<double>::infinity();
      vtkIdType bestId = -1;
      for (const vtkIdType id : ids)
      {
        double y[3];
        GetInput()->GetPoint(id, y);
        const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), y));
        bestId = distance < best ? id : bestId;
        best = std::min(best, distance);
      }
      double ofId = 0.0;
      worst = std::max(worst, -FindNearestPoint(x, bestId, ofId) + best);
      expected.insert(bestId);
    }
    std::cout << "at " << pixelError << ": " << points.size() << " points selected, " << ids.size()
              << " of the input; farther than the nearest one by " << worst << " at most\n";
    EXPECT_GT(ids.size(), 20u);
    EXPECT_LE(worst, GetTolerance());
    EXPECT_EQ(ids, expected);
  }
}

TEST(MapperInputIds, WhatWasNotFoundWhenASelectionIsStoppedIsNotSelected)
{
  View view(6.0);
  struct Abort
  {
    int Events = 0;
    bool Stops = true;
  } abort;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&abort);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* self = static_cast<Abort*>(data);
      ++self->Events;
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(self->Stops ? 1 : 0);
    });
  view.Mapper->AddObserver(vtkCommand::ProgressEvent, command);
  const std::set<vtkIdType> stopped = view.Scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, Middle);
  abort.Stops = false;
  const std::set<vtkIdType> whole = view.Scene.Select(vtkDataObject::FIELD_ASSOCIATION_CELLS, Middle);
  std::cout << stopped.size() << " of " << whole.size() << " cells, " << abort.Events << " events\n";
  EXPECT_GT(abort.Events, 0);
  EXPECT_LT(stopped.size(), whole.size());
  for (const vtkIdType id : stopped)
  {
    EXPECT_EQ(whole.count(id), 1u);
  }
}

TEST(MapperInputIds, PickerWithTheLocatorFindsTheNearestCellAndPointOfThePlace)
{
  for (const double pixelError : { 0.0, 6.0, 60.0 })
  {
    View view(pixelError);
    vtkNew<vtkMultiTriangulationLocator> locator;
    locator->SetMapper(view.Mapper);
    vtkNew<vtkCellPicker> picker;
    picker->AddLocator(locator);
    MTTestMeshes::Random random(3);
    int picked = 0;
    int wrong = 0;
    int wrongPoints = 0;
    double slowest = 0.0;
    double all = 0.0;
    for (int i = 0; i < 60; ++i)
    {
      const auto begin = std::chrono::steady_clock::now();
      const bool hit =
        picker->Pick(random.Uniform(60.0, 240.0), random.Uniform(60.0, 240.0), 0.0, view.Scene.Renderer) != 0;
      const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
      if (!hit)
      {
        continue;
      }
      all += time.count();
      slowest = std::max(slowest, time.count());
      ++picked;
      Place x;
      std::copy_n(picker->GetMapperPosition(), 3, x.begin());
      wrong += GetDistance(picker->GetCellId(), x) <= FindNearest(x) + GetTolerance() ? 0 : 1;
      double ofId = 0.0;
      const double nearest = FindNearestPoint(x, locator->GetInputPointId(), ofId);
      wrongPoints += ofId <= nearest + GetTolerance() ? 0 : 1;
    }
    std::cout << "at " << pixelError << ": " << picked << " picks, " << wrong << " wrong cells, " << wrongPoints
              << " wrong points; " << all / picked << " ms each, " << slowest << " at most\n";
    EXPECT_GT(picked, 40);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(wrongPoints, 0);
  }
}
