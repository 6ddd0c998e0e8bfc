// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFunctionSigns.h"

#include "vtkBox.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkImplicitFunctionCollection.h"
#include "vtkLinearTransform.h"
#include "vtkMTPlacement.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>

namespace
{
// Several times the relative rounding error of the sums of products below.
constexpr double Rounding = 1e-13;

//------------------------------------------------------------------------------
vtkMTFunctionSigns FromRange(double least, double largest, double slack)
{
  vtkMTFunctionSigns signs;
  signs.CanBeNegative = !(least - slack > 0.0);
  signs.CanBePositive = !(largest + slack < 0.0);
  return signs;
}

//------------------------------------------------------------------------------
vtkMTFunctionSigns OfPlane(vtkPlane* plane, const double box[6])
{
  const double* normal = plane->GetNormal();
  const double* origin = plane->GetOrigin();
  double least = 0.0;
  double largest = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double a = normal[i] * (box[2 * i] - origin[i]);
    const double b = normal[i] * (box[2 * i + 1] - origin[i]);
    least += std::min(a, b);
    largest += std::max(a, b);
    size += std::abs(normal[i]) * (std::max(std::abs(box[2 * i]), std::abs(box[2 * i + 1])) + std::abs(origin[i]));
  }
  return FromRange(least, largest, Rounding * size);
}

//------------------------------------------------------------------------------
// The largest of the planes' values.
vtkMTFunctionSigns OfPlanes(vtkPlanes* planes, const double box[6])
{
  vtkMTFunctionSigns signs{ true, false };
  vtkNew<vtkPlane> plane;
  for (int i = 0; i < planes->GetNumberOfPlanes(); ++i)
  {
    planes->GetPlane(i, plane);
    const vtkMTFunctionSigns each = OfPlane(plane, box);
    signs.CanBeNegative = signs.CanBeNegative && each.CanBeNegative;
    signs.CanBePositive = signs.CanBePositive || each.CanBePositive;
  }
  return planes->GetNumberOfPlanes() > 0 ? signs : vtkMTFunctionSigns();
}

//------------------------------------------------------------------------------
vtkMTFunctionSigns OfSphere(vtkSphere* sphere, const double box[6])
{
  const double* center = sphere->GetCenter();
  double nearest = 0.0;
  double farthest = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double below = center[i] - box[2 * i];
    const double above = box[2 * i + 1] - center[i];
    const double outside = std::max({ -below, -above, 0.0 });
    const double largest = std::max(std::abs(below), std::abs(above));
    const double coordinate = std::abs(center[i]) + std::max(std::abs(box[2 * i]), std::abs(box[2 * i + 1]));
    nearest += outside * outside;
    farthest += largest * largest;
    size += coordinate * coordinate;
  }
  const double square = sphere->GetRadius() * sphere->GetRadius();
  return FromRange(nearest - square, farthest - square, Rounding * (size + square));
}

//------------------------------------------------------------------------------
vtkMTFunctionSigns OfBox(vtkBox* function, const double box[6])
{
  double bounds[6];
  function->GetBounds(bounds);
  vtkMTFunctionSigns signs{ true, false };
  for (int i = 0; i < 3; ++i)
  {
    const double slack = Rounding * (std::abs(bounds[2 * i]) + std::abs(bounds[2 * i + 1]));
    signs.CanBeNegative =
      signs.CanBeNegative && !(box[2 * i] > bounds[2 * i + 1] + slack) && !(box[2 * i + 1] < bounds[2 * i] - slack);
    signs.CanBePositive =
      signs.CanBePositive || !(box[2 * i] > bounds[2 * i] + slack) || !(box[2 * i + 1] < bounds[2 * i + 1] - slack);
  }
  return signs;
}

//------------------------------------------------------------------------------
vtkMTFunctionSigns OfSamples(vtkImplicitFunction* function, const double box[6])
{
  constexpr int steps = 4;
  constexpr double steeper = 2.0;
  double least = VTK_DOUBLE_MAX;
  double largest = -VTK_DOUBLE_MAX;
  double slope = 0.0;
  bool finite = true;
  for (int index = 0; index < (steps + 1) * (steps + 1) * (steps + 1); ++index)
  {
    const int place[3] = { index % (steps + 1), index / (steps + 1) % (steps + 1), index / (steps + 1) / (steps + 1) };
    double x[3];
    double gradient[3];
    for (int i = 0; i < 3; ++i)
    {
      x[i] = box[2 * i] + (box[2 * i + 1] - box[2 * i]) * place[i] / steps;
    }
    const double value = function->FunctionValue(x);
    function->FunctionGradient(x, gradient);
    const double length = std::hypot(gradient[0], gradient[1], gradient[2]);
    finite = finite && std::isfinite(value) && std::isfinite(length);
    least = std::min(least, value);
    largest = std::max(largest, value);
    slope = std::max(slope, length);
  }
  if (!finite)
  {
    return vtkMTFunctionSigns();
  }
  const double reach = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]) / (2.0 * steps);
  return FromRange(least, largest, steeper * slope * reach);
}

vtkMTFunctionSigns OfBoolean(vtkImplicitBoolean* boolean, const double box[6]);

//------------------------------------------------------------------------------
vtkMTFunctionSigns WithoutTransform(vtkImplicitFunction* function, const double box[6], bool& known)
{
  known = true;
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    return OfPlane(plane, box);
  }
  if (auto* planes = vtkPlanes::SafeDownCast(function))
  {
    return OfPlanes(planes, box);
  }
  if (auto* sphere = vtkSphere::SafeDownCast(function))
  {
    return OfSphere(sphere, box);
  }
  if (auto* other = vtkBox::SafeDownCast(function))
  {
    return OfBox(other, box);
  }
  auto* boolean = vtkImplicitBoolean::SafeDownCast(function);
  if (boolean && boolean->GetOperationType() != vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES &&
    boolean->GetFunction()->GetNumberOfItems() > 0)
  {
    return OfBoolean(boolean, box);
  }
  known = false;
  return vtkMTFunctionSigns();
}

//------------------------------------------------------------------------------
// Union: the least value; intersection: the largest; difference: the largest of the first and of the others' negatives.
vtkMTFunctionSigns OfBoolean(vtkImplicitBoolean* boolean, const double box[6])
{
  vtkImplicitFunctionCollection* functions = boolean->GetFunction();
  vtkMTFunctionSigns signs;
  vtkCollectionSimpleIterator iterator;
  functions->InitTraversal(iterator);
  for (bool first = true; vtkImplicitFunction* each = functions->GetNextImplicitFunction(iterator); first = false)
  {
    vtkMTFunctionSigns next = vtkMTFunctionSigns::Find(each, box);
    if (first)
    {
      signs = next;
      continue;
    }
    if (boolean->GetOperationType() == vtkImplicitBoolean::VTK_DIFFERENCE)
    {
      std::swap(next.CanBeNegative, next.CanBePositive);
    }
    const bool isUnion = boolean->GetOperationType() == vtkImplicitBoolean::VTK_UNION;
    signs.CanBeNegative =
      isUnion ? signs.CanBeNegative || next.CanBeNegative : signs.CanBeNegative && next.CanBeNegative;
    signs.CanBePositive =
      isUnion ? signs.CanBePositive && next.CanBePositive : signs.CanBePositive || next.CanBePositive;
  }
  return signs;
}
}

//------------------------------------------------------------------------------
vtkMTFunctionSigns vtkMTFunctionSigns::Find(vtkImplicitFunction* function, const double box[6])
{
  if (box[0] > box[1])
  {
    return { false, false };
  }
  vtkAbstractTransform* transform = function->GetTransform();
  vtkMTPlacement placement;
  auto* linear = vtkLinearTransform::SafeDownCast(transform);
  if (linear)
  {
    linear->Update();
    const double* matrix = linear->GetMatrix()->GetData();
    std::copy(matrix, matrix + 16, placement.Matrix.begin());
  }
  if (!transform || (linear && vtkMTPlacement::IsSound(placement.Matrix.data())))
  {
    double own[6];
    placement.ToObject(box, own);
    bool known = false;
    const vtkMTFunctionSigns signs = WithoutTransform(function, own, known);
    if (known)
    {
      return signs;
    }
  }
  return OfSamples(function, box);
}
