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

}

// Number, mean and sums of squares of points; those of two sets follow from those of each (Chan, Golub and LeVeque,
// 1979).
class vtkMTOrientedBoxes::Moments
{
public:
  void Add(const vtkMTRealPoint& x)
  {
    Moments other;
    other.Count = 1.0;
    std::copy(x.begin(), x.end(), other.Middle);
    this->Add(other);
  }
  void Add(const Moments& other)
  {
    const double count = this->Count + other.Count;
    if (!(count > 0.0))
    {
      return;
    }
    double d[3];
    for (int i = 0; i < 3; ++i)
    {
      d[i] = other.Middle[i] - this->Middle[i];
      this->Middle[i] += d[i] * (other.Count / count);
    }
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Squares[i][j] += other.Squares[i][j] + d[i] * d[j] * (this->Count * other.Count / count);
      }
    }
    this->Count = count;
  }
  // Principal axes, and the least that the points extend along each.
  bool GetAxes(std::array<vtkMTRealPoint, 3>& axes, double extents[3]) const
  {
    double squares[3][3];
    double v[3][3];
    double values[3];
    double* rows[3] = { squares[0], squares[1], squares[2] };
    double* rowsOfV[3] = { v[0], v[1], v[2] };
    std::copy(&this->Squares[0][0], &this->Squares[0][0] + 9, &squares[0][0]);
    if (!(this->Count > 0.0) || vtkMath::Jacobi(rows, values, rowsOfV) == 0)
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      axes[axis] = { v[0][axis], v[1][axis], v[2][axis] };
      extents[axis] = 2.0 * std::sqrt(std::max(0.0, values[axis]) / this->Count);
    }
    return true;
  }

private:
  double Count = 0.0;
  double Middle[3] = {};
  double Squares[3][3] = {};
};

bool vtkMTOrientedBoxes::Make(
  std::size_t node, const vtkMTRealBounds& straight, const Moments& moments, const Corners& corners, Box& box)
{
  const double most = LargestShareOfSurface * GetSurface(straight);
  double extents[3];
  box = Box();
  if (!moments.GetAxes(box.Axes, extents) ||
    extents[0] * extents[1] + extents[1] * extents[2] + extents[2] * extents[0] > most)
  {
    return false;
  }
  corners(node, [&](const vtkMTRealPoint& x) { box.Bounds.Add(Turn(box.Axes, x)); });
  for (int axis = 0; axis < 3; ++axis)
  {
    const double farthest = std::max(std::abs(box.Bounds.Minimum[axis]), std::abs(box.Bounds.Maximum[axis]));
    box.Bounds.Minimum[axis] -= 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, farthest);
    box.Bounds.Maximum[axis] += 4.0 * vtkMTPrincipalAxes::Rounding * std::max(1.0, farthest);
  }
  return GetSurface(box.Bounds) < most;
}

void vtkMTOrientedBoxes::Fit(const std::vector<vtkMTRealBounds>& straight, const Corners& corners)
{
  this->Numbers.assign(straight.size(), None);
  std::vector<Moments> moments(straight.size());
  const std::size_t firstLeaf = straight.size() / 2;
  vtkSMPTools::For(static_cast<vtkIdType>(firstLeaf), static_cast<vtkIdType>(straight.size()), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType leaf = begin; leaf < end; ++leaf)
      {
        Moments& own = moments[static_cast<std::size_t>(leaf)];
        corners(static_cast<std::size_t>(leaf), [&own](const vtkMTRealPoint& x) { own.Add(x); });
      }
    });
  for (std::size_t node = firstLeaf; node-- > 0;)
  {
    moments[node].Add(moments[2 * node + 1]);
    moments[node].Add(moments[2 * node + 2]);
  }
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
          isWanted[node - first] =
            !straight[node].IsEmpty() && Make(node, straight[node], moments[node], corners, made[node - first]);
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
