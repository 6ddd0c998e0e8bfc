// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"

#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkDoubleArray.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkMTFunctionSigns.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkSphere.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using Random = MTTestMeshes::Random;
using Function = vtkSmartPointer<vtkImplicitFunction>;

Function MakeSimple(Random& random)
{
  const auto place = [&] { return random.Uniform(-1.0, 1.0); };
  switch (random.Below(4))
  {
    case 0:
    {
      auto plane = vtkSmartPointer<vtkPlane>::New();
      plane->SetOrigin(place(), place(), place());
      plane->SetNormal(place(), place(), place());
      return plane;
    }
    case 1:
    {
      auto sphere = vtkSmartPointer<vtkSphere>::New();
      sphere->SetCenter(place(), place(), place());
      sphere->SetRadius(random.Uniform(0.05, 1.0));
      return sphere;
    }
    case 2:
    {
      auto box = vtkSmartPointer<vtkBox>::New();
      const double x[3] = { place(), place(), place() };
      box->SetBounds(x[0], x[0] + random.Uniform(), x[1], x[1] + random.Uniform(), x[2], x[2] + random.Uniform());
      return box;
    }
    default:
    {
      auto planes = vtkSmartPointer<vtkPlanes>::New();
      const double x[3] = { place(), place(), place() };
      planes->SetBounds(x[0], x[0] + 0.5, x[1], x[1] + 0.5, x[2], x[2] + 0.5);
      return planes;
    }
  }
}

Function MakeFunction(Random& random)
{
  Function function = MakeSimple(random);
  if (random.Below(2))
  {
    auto boolean = vtkSmartPointer<vtkImplicitBoolean>::New();
    boolean->SetOperationType(static_cast<int>(random.Below(3))); // union, intersection, difference
    boolean->AddFunction(function);
    boolean->AddFunction(MakeSimple(random));
    function = boolean;
  }
  if (random.Below(2))
  {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(random.Uniform(0.0, 360.0), random.Uniform(), random.Uniform(), random.Uniform() + 0.1);
    transform->Scale(random.Uniform(0.3, 2.0), random.Uniform(0.3, 2.0), random.Uniform(0.3, 2.0));
    function->SetTransform(transform);
  }
  return function;
}

void MakeBox(Random& random, double box[6])
{
  for (int i = 0; i < 3; ++i)
  {
    box[2 * i] = random.Uniform(-1.5, 1.5);
    box[2 * i + 1] = box[2 * i] + random.Uniform(0.0, 0.4);
  }
}
}

TEST(FunctionSigns, NoSignThatOccursIsDenied)
{
  Random random(7);
  int denied = 0;
  for (int test = 0; test < 4000; ++test)
  {
    const Function function = MakeFunction(random);
    double box[6];
    MakeBox(random, box);
    const vtkMTFunctionSigns signs = vtkMTFunctionSigns::Find(function, box);
    denied += signs.CanBeNegative && signs.CanBePositive ? 0 : 1;
    for (int sample = 0; sample < 60; ++sample)
    {
      double x[3];
      for (int i = 0; i < 3; ++i)
      {
        // Corners and edges of the box too.
        x[i] = box[2 * i] + (box[2 * i + 1] - box[2 * i]) * std::clamp(random.Uniform(-0.5, 1.5), 0.0, 1.0);
      }
      const double value = function->FunctionValue(x);
      ASSERT_TRUE(value > 0.0 || signs.CanBeNegative) << "test " << test;
      ASSERT_TRUE(value < 0.0 || signs.CanBePositive) << "test " << test;
    }
  }
  std::cout << denied << " of 4000 boxes are on one side\n";
  EXPECT_GT(denied, 2000) << "or the answer would say nothing";
}

TEST(FunctionSigns, WhatIsNotKnownIsSampled)
{
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetRadius(0.5);
  const double far[6] = { 3.0, 3.2, 0.0, 0.2, 3.0, 3.2 };
  const double inside[6] = { -0.1, 0.1, 0.0, 0.2, -0.1, 0.1 };
  const double across[6] = { 0.3, 0.8, 0.0, 0.2, -0.1, 0.1 };
  EXPECT_FALSE(vtkMTFunctionSigns::Find(cylinder, far).CanBeNegative);
  EXPECT_TRUE(vtkMTFunctionSigns::Find(cylinder, far).CanBePositive);
  EXPECT_FALSE(vtkMTFunctionSigns::Find(cylinder, inside).CanBePositive);
  EXPECT_TRUE(vtkMTFunctionSigns::Find(cylinder, inside).CanBeNegative);
  EXPECT_TRUE(vtkMTFunctionSigns::Find(cylinder, across).CanBePositive);
  EXPECT_TRUE(vtkMTFunctionSigns::Find(cylinder, across).CanBeNegative);
}

TEST(FunctionSigns, AnEmptyBoxHasNoSign)
{
  vtkNew<vtkSphere> sphere;
  const double box[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  EXPECT_FALSE(vtkMTFunctionSigns::Find(sphere, box).CanBeNegative);
  EXPECT_FALSE(vtkMTFunctionSigns::Find(sphere, box).CanBePositive);
}
