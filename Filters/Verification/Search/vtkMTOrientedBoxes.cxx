// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrientedBoxes.h"

#include "vtkMTPrincipalAxes.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double LargestShareOfSurface = 0.125;
// Nodes whose boxes are made at once: most are not kept, so they do not all take memory.
constexpr std::size_t NodesPerTurn = 1 << 14;

vtkMTRealPoint Turn(const std::array<vtkMTRealPoint, 3>& axes, const vtkMTRealPoint& x)
{
  vtkMTRealPoint turned;
  for (int i = 0; i < 3; ++i)
  {
    turned[i] = axes[i][0] * x[0] + axes[i][1] * x[1] + axes[i][2] * x[2];
  }
  return turned;
}

// Half of it.
double GetSurface(const vtkMTRealBounds& box)
{
  const double x = box.Maximum[0] - box.Minimum[0];
  const double y = box.Maximum[1] - box.Minimum[1];
  const double z = box.Maximum[2] - box.Minimum[2];
  return x * y + y * z + z * x;
}

// Of points that are to be added twice: for the middle, and then for the axes.
class Moments
{
public:
  void AddToMiddle(const vtkMTRealPoint& x)
  {
    ++this->Count;
    for (int i = 0; i < 3; ++i)
    {
      this->Middle[i] += (x[i] - this->Middle[i]) / this->Count;
    }
  }
  void AddToSquares(const vtkMTRealPoint& x)
  {
    const vtkMTRealPoint d = { x[0] - this->Middle[0], x[1] - this->Middle[1], x[2] - this->Middle[2] };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Squares[i][j] += d[i] * d[j];
      }
    }
  }
  bool GetAxes(std::array<vtkMTRealPoint, 3>& axes)
  {
    double v[3][3];
    double values[3];
    double* rows[3] = { this->Squares[0], this->Squares[1], this->Squares[2] };
    double* rowsOfV[3] = { v[0], v[1], v[2] };
    if (vtkMath::Jacobi(rows, values, rowsOfV) == 0)
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      axes[axis] = { v[0][axis], v[1][axis], v[2][axis] };
    }
    return true;
  }

private:
  double Count = 0.0;
  double Middle[3] = {};
  double Squares[3][3] = {};
};
}

bool vtkMTOrientedBoxes::Make(std::size_t node, const vtkMTRealBounds& straight, const Corners& corners, Box& box)
{
  Moments moments;
  corners(node, [&](const vtkMTRealPoint& x) { moments.AddToMiddle(x); });
  corners(node, [&](const vtkMTRealPoint& x) { moments.AddToSquares(x); });
  box = Box();
  if (!moments.GetAxes(box.Axes))
  {
    return false;
  }
  corners(node, [&](const vtkMTRealPoint& x) { box.Bounds.Add(Turn(box.Axes, x)); });
  for (int axis = 0; axis < 3; ++axis)
  {
    const double most = std::max(std::abs(box.Bounds.Minimum[axis]), std::abs(box.Bounds.Maximum[axis]));
    box.Bounds.Minimum[axis] -= 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, most);
    box.Bounds.Maximum[axis] += 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, most);
  }
  return GetSurface(box.Bounds) < LargestShareOfSurface * GetSurface(straight);
}

void vtkMTOrientedBoxes::Fit(const std::vector<vtkMTRealBounds>& straight, const Corners& corners)
{
  this->Numbers.assign(straight.size(), None);
  std::vector<Box> made(std::min(NodesPerTurn, straight.size()));
  std::vector<unsigned char> isWanted(made.size());
  for (std::size_t first = 0; first < straight.size(); first += NodesPerTurn)
  {
    const std::size_t last = std::min(straight.size(), first + NodesPerTurn);
    vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto node = static_cast<std::size_t>(begin); node < static_cast<std::size_t>(end); ++node)
        {
          isWanted[node - first] = !straight[node].IsEmpty() && Make(node, straight[node], corners, made[node - first]);
        }
      });
    for (std::size_t node = first; node < last; ++node)
    {
      if (isWanted[node - first])
      {
        this->Numbers[node] = static_cast<std::uint32_t>(this->Boxes.size());
        this->Boxes.push_back(made[node - first]);
      }
    }
  }
}

double vtkMTOrientedBoxes::Measure(std::uint32_t number, const vtkMTRealPoint& x) const
{
  const Box& box = this->Boxes[number];
  const vtkMTRealPoint turned = Turn(box.Axes, x);
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double d =
      std::max({ box.Bounds.Minimum[axis] - turned[axis], turned[axis] - box.Bounds.Maximum[axis], 0.0 });
    sum += d * d;
  }
  return sum;
}
