// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLeastOverlap.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = vtkMTPlaneOrientation::Point;

struct Cost
{
  bool operator<(const Cost& other) const
  {
    return this->Overlap < other.Overlap || (this->Overlap == other.Overlap && this->Shape < other.Shape);
  }
  double Overlap = 0.0;
  double Shape = 0.0;
};

// Of the chain of corners from one to another: what its triangles cost, and the third corner of that on its ends.
struct Chain
{
  Cost Least;
  std::size_t Middle = 0;
};

class Chains
{
public:
  Chains(const std::vector<Point>& points, const std::vector<std::uint32_t>& corners)
    : Size(corners.size())
    , Table(corners.size() * corners.size())
    , Lengths(corners.size() * corners.size())
  {
    for (const std::uint32_t corner : corners)
    {
      this->Points.push_back(points[corner]);
    }
    double extent = 0.0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      for (std::size_t j = 0; j < this->Size; ++j)
      {
        double& length = this->Lengths[i * this->Size + j];
        length = std::hypot(this->Points[i][0] - this->Points[j][0], this->Points[i][1] - this->Points[j][1]);
        extent = std::max(extent, length);
      }
    }
    this->SmallestArea = 1e-12 * extent * extent;
  }

  void Find()
  {
    for (std::size_t length = 2; length < this->Size; ++length)
    {
      for (std::size_t first = 0; first + length < this->Size; ++first)
      {
        this->FindMiddle(first, first + length);
      }
    }
  }

  std::size_t GetMiddle(std::size_t first, std::size_t last) const
  {
    return this->Table[first * this->Size + last].Middle;
  }

private:
  void FindMiddle(std::size_t first, std::size_t last)
  {
    Chain& chain = this->Table[first * this->Size + last];
    for (std::size_t middle = first + 1; middle < last; ++middle)
    {
      const Cost& before = this->Table[first * this->Size + middle].Least;
      const Cost& after = this->Table[middle * this->Size + last].Least;
      Cost cost = this->GetCost(first, middle, last);
      cost.Overlap += before.Overlap + after.Overlap;
      cost.Shape += before.Shape + after.Shape;
      if (chain.Middle == 0 || cost < chain.Least)
      {
        chain.Least = cost;
        chain.Middle = middle;
      }
    }
  }

  Cost GetCost(std::size_t a, std::size_t b, std::size_t c) const
  {
    const double area = 0.5 * vtkMTPlaneOrientation::Of(this->Points[a], this->Points[b], this->Points[c]);
    const double perimeter =
      this->Lengths[a * this->Size + b] + this->Lengths[b * this->Size + c] + this->Lengths[c * this->Size + a];
    const double shape = perimeter * perimeter / std::max({ area, this->SmallestArea, 1e-300 });
    return { area < -this->SmallestArea ? -area : 0.0, shape };
  }

  const std::size_t Size;
  std::vector<Point> Points;
  std::vector<Chain> Table;
  std::vector<double> Lengths;
  double SmallestArea = 0.0; // that is no rounding
};
}

void vtkMTLeastOverlap::Split(const std::vector<Point>& points, const std::vector<std::uint32_t>& corners,
  std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  Chains chains(points, corners);
  chains.Find();
  std::vector<std::array<std::size_t, 2>> left{ { 0, corners.size() - 1 } };
  while (!left.empty())
  {
    const auto [first, last] = left.back();
    left.pop_back();
    if (last - first < 2)
    {
      continue;
    }
    const std::size_t middle = chains.GetMiddle(first, last);
    triangles.push_back({ corners[first], corners[middle], corners[last] });
    left.push_back({ middle, last });
    left.push_back({ first, middle });
  }
}
