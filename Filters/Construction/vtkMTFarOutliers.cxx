// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFarOutliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace
{
using Points = std::vector<std::array<double, 3>>;
using TriangleList = std::vector<std::array<std::uint32_t, 3>>;
using Box = std::array<double, 6>;
using Histogram = std::map<int, std::size_t>; // by power of two

constexpr int GapBits = 7; // between powers of two: more than 64 between the numbers themselves
constexpr double StepsPerEdge = 16.0;
constexpr std::size_t AlwaysFew = 16;

// The exponent of the power of two at or below x; zero and infinity have some of their own.
constexpr int PowerOfZero = -1100;
int GetPower(double x)
{
  return x > 0.0 ? (std::isinf(x) ? std::numeric_limits<double>::max_exponent : std::ilogb(x)) : PowerOfZero;
}

class Finder
{
public:
  Finder(const Points& points, const TriangleList& triangles, int bits)
    : Places(points)
    , Corners(triangles)
    , Bits(bits)
    , Limit(std::numeric_limits<int>::max())
  {
  }

  vtkMTFarOutliers Run()
  {
    vtkMTFarOutliers result;
    if (this->Corners.empty() || !this->IsTooCoarse(this->FindBox()))
    {
      return result;
    }
    this->FindMiddle();
    const Histogram reach = this->CountReach();
    std::size_t beyond = 0;
    for (auto outer = reach.rbegin(); outer != reach.rend() && std::next(outer) != reach.rend(); ++outer)
    {
      beyond += outer->second;
      const int inner = std::next(outer)->first;
      if (outer->first - inner < GapBits)
      {
        continue;
      }
      if (beyond > this->GetMostFew())
      {
        this->Explain(beyond, outer->first, result);
        if (result.IsRefused)
        {
          return result;
        }
        break;
      }
      this->Limit = inner;
      if (!this->IsTooCoarse(this->FindBox()))
      {
        break;
      }
    }
    this->Collect(result);
    return result;
  }

private:
  double GetReach(const std::array<std::uint32_t, 3>& t) const
  {
    double reach = 0.0;
    for (std::uint32_t p : t)
    {
      for (int i = 0; i < 3; ++i)
      {
        reach = std::max(reach, std::abs(this->Places[p][i] - this->Middle[i]));
      }
    }
    return reach;
  }

  bool IsFar(const std::array<std::uint32_t, 3>& t) const { return GetPower(this->GetReach(t)) > this->Limit; }

  Box FindBox() const
  {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Box box{ inf, -inf, inf, -inf, inf, -inf };
    for (const auto& t : this->Corners)
    {
      if (this->IsFar(t))
      {
        continue;
      }
      for (std::uint32_t p : t)
      {
        for (int i = 0; i < 3; ++i)
        {
          box[2 * i] = std::min(box[2 * i], this->Places[p][i]);
          box[2 * i + 1] = std::max(box[2 * i + 1], this->Places[p][i]);
        }
      }
    }
    return box;
  }

  // The power of two above the median edge, of all triangles: few outliers do not move it.
  double GetTypicalEdge()
  {
    if (this->TypicalEdge > 0.0)
    {
      return this->TypicalEdge;
    }
    std::vector<std::size_t> lengths(std::numeric_limits<double>::max_exponent - PowerOfZero + 1, 0);
    for (const auto& t : this->Corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        double length = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          length = std::max(length, std::abs(this->Places[t[c]][i] - this->Places[t[(c + 1) % 3]][i]));
        }
        ++lengths[static_cast<std::size_t>(GetPower(length) - PowerOfZero)];
      }
    }
    std::size_t power = 0;
    for (std::size_t count = lengths[0]; 2 * count < 3 * this->Corners.size(); count += lengths[power])
    {
      ++power;
    }
    this->TypicalEdge = std::ldexp(1.0, static_cast<int>(power) + PowerOfZero + 1);
    return this->TypicalEdge;
  }

  static double GetStep(const Box& box, int bits)
  {
    double step = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      step = std::max(step, std::ldexp(box[2 * i + 1], -bits) - std::ldexp(box[2 * i], -bits)); // no overflow
    }
    return step;
  }

  bool IsTooCoarse(const Box& box) { return GetStep(box, this->Bits) > this->GetTypicalEdge() / StepsPerEdge; }

  void FindMiddle()
  {
    std::vector<double> coordinates(this->Corners.size());
    for (int i = 0; i < 3; ++i)
    {
      std::transform(this->Corners.begin(), this->Corners.end(), coordinates.begin(),
        [this, i](const auto& t) { return this->Places[t[0]][i]; });
      const auto middle = coordinates.begin() + static_cast<std::ptrdiff_t>(coordinates.size() / 2);
      std::nth_element(coordinates.begin(), middle, coordinates.end());
      this->Middle[i] = *middle;
    }
  }

  Histogram CountReach() const
  {
    Histogram reach;
    for (const auto& t : this->Corners)
    {
      ++reach[GetPower(this->GetReach(t))];
    }
    return reach;
  }

  std::size_t GetMostFew() const
  {
    const std::size_t all = this->Corners.size();
    return std::min(std::max(AlwaysFew, all / 1000), all / 4);
  }

  void Collect(vtkMTFarOutliers& result)
  {
    for (std::uint32_t t = 0; t < this->Corners.size(); ++t)
    {
      if (this->IsFar(this->Corners[t]))
      {
        result.Triangles.push_back(t);
      }
    }
    if (!result.Triangles.empty())
    {
      const Box all = this->WithLimit(std::numeric_limits<int>::max());
      std::ostringstream text;
      text << result.Triangles.size() << " of " << this->Corners.size()
           << " triangles are far outliers and were left out (dropped_far_outlier): all others lie within "
           << Describe(this->FindBox()) << ", with them the bounds would be " << Describe(all) << " and a lattice step "
           << GetStep(all, this->Bits) << ", too coarse for edges of " << this->GetTypicalEdge()
           << "; keep them with --keep-far-outliers (KeepFarOutliers), or use more --lattice-bits";
      result.Message = text.str();
    }
  }

  Box WithLimit(int limit)
  {
    std::swap(this->Limit, limit);
    const Box box = this->FindBox();
    std::swap(this->Limit, limit);
    return box;
  }

  // More than a few triangles beyond the gap: refused, or built with a warning.
  void Explain(std::size_t beyond, int power, vtkMTFarOutliers& result)
  {
    const Box all = this->WithLimit(std::numeric_limits<int>::max());
    const Box near = this->WithLimit(power - 1);
    std::ostringstream text;
    text << beyond << " of " << this->Corners.size()
         << " triangles reach at least 64 times as far as the others, which "
         << "lie within " << Describe(near) << "; with bounds of " << Describe(all) << " the lattice step is "
         << GetStep(all, this->Bits) << ", too coarse for edges of " << this->GetTypicalEdge();
    result.IsRefused = beyond <= this->Corners.size() / 2;
    text << (result.IsRefused ? "; take them out of the input, build the parts as models of their own, use more "
                                "--lattice-bits (LatticeBits), "
                                "or accept that step with --keep-far-outliers (KeepFarOutliers)"
                              : "; more --lattice-bits (LatticeBits) or models of its parts would keep more");
    result.Message = text.str();
  }

  static std::string Describe(const Box& box)
  {
    std::ostringstream text;
    text.precision(6);
    text << "(" << box[0] << " " << box[2] << " " << box[4] << ") (" << box[1] << " " << box[3] << " " << box[5] << ")";
    return text.str();
  }

  const Points& Places;
  const TriangleList& Corners;
  const int Bits;
  int Limit; // triangles that reach a higher power of two are outliers
  double TypicalEdge = 0.0;
  std::array<double, 3> Middle{ 0.0, 0.0, 0.0 };
};
}

vtkMTFarOutliers vtkMTFarOutliers::Find(const Points& points, const TriangleList& triangles, int latticeBits)
{
  return Finder(points, triangles, latticeBits).Run();
}
