// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchOrder.h"

#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);

vtkMTColumn Permute(const vtkMTColumn& column, const std::vector<std::uint32_t>& from)
{
  vtkMTColumn result(column.size());
  const std::size_t size = from.empty() ? 0 : column.size() / from.size();
  for (std::size_t i = 0; i < from.size() && size > 0; ++i)
  {
    std::memcpy(result.data() + i * size, column.data() + from[i] * size, size);
  }
  return result;
}

// Numbers `count` things as they are first met, those that are not met last.
class FirstUse
{
public:
  explicit FirstUse(std::size_t count)
    : Number(count, None)
  {
    this->Order.reserve(count);
  }
  void Meet(std::uint32_t i)
  {
    if (this->Number[i] == None)
    {
      this->Number[i] = static_cast<std::uint32_t>(this->Order.size());
      this->Order.push_back(i);
    }
  }
  void Finish()
  {
    for (std::uint32_t i = 0; i < this->Number.size(); ++i)
    {
      this->Meet(i);
    }
  }
  std::vector<std::uint32_t> Number; // the new one of each
  std::vector<std::uint32_t> Order;  // which one is new number i
};

// Points and wedges in order of use, and their places in the stored patch, for triangles in some order.
struct Numbering
{
  std::vector<vtkMTTriangle> Triangles;  // of wedges in order of use
  std::vector<std::uint32_t> WedgeOrder; // the patch's wedge for each in order of use
  std::vector<std::uint32_t> PointOrder;
  std::vector<std::uint32_t> WedgePoints; // order of use of points
  std::vector<std::uint32_t> PointPlace;
  std::vector<std::uint32_t> WedgePlace;

  Numbering(const vtkMTPatch& patch, const std::vector<vtkMTTriangle>& triangles)
    : Triangles(triangles)
  {
    FirstUse wedges(patch.GetNumberOfWedges());
    for (vtkMTTriangle& t : this->Triangles)
    {
      for (std::uint32_t& w : t)
      {
        wedges.Meet(w);
        w = wedges.Number[w];
      }
    }
    wedges.Finish();
    FirstUse points(patch.Points.size());
    for (std::uint32_t w : wedges.Order)
    {
      points.Meet(patch.GetPointOfWedge(w));
    }
    points.Finish();
    std::vector<unsigned char> isShared(points.Order.size());
    for (std::size_t i = 0; i < isShared.size(); ++i)
    {
      isShared[i] = points.Order[i] < patch.Ids.size() ? 1 : 0;
    }
    for (std::size_t w = 0; w < patch.WedgePoints.size(); ++w)
    {
      this->WedgePoints.push_back(points.Number[patch.WedgePoints[wedges.Order[w]]]);
    }
    this->PointPlace = vtkMTPatchOrder::PlacePoints(isShared);
    this->WedgePlace = vtkMTPatchOrder::PlaceWedges(this->WedgePoints, this->PointPlace);
    this->WedgeOrder = std::move(wedges.Order);
    this->PointOrder = std::move(points.Order);
  }
};

void PermutePoints(const vtkMTPatch& patch, const Numbering& numbering, vtkMTPatch& ordered)
{
  ordered.Points.resize(patch.Points.size());
  ordered.Ids.resize(patch.Ids.size());
  for (std::size_t i = 0; i < numbering.PointOrder.size(); ++i)
  {
    const std::uint32_t from = numbering.PointOrder[i];
    const std::uint32_t place = numbering.PointPlace[i];
    ordered.Points[place] = patch.Points[from];
    if (from < patch.Ids.size())
    {
      ordered.Ids[place] = patch.Ids[from];
    }
  }
  std::vector<std::uint32_t> wedgeFrom(numbering.WedgePlace.size());
  ordered.WedgePoints.resize(patch.WedgePoints.size());
  for (std::size_t w = 0; w < wedgeFrom.size(); ++w)
  {
    wedgeFrom[numbering.WedgePlace[w]] = numbering.WedgeOrder[w];
    if (!patch.WedgePoints.empty())
    {
      ordered.WedgePoints[numbering.WedgePlace[w]] = numbering.PointPlace[numbering.WedgePoints[w]];
    }
  }
  for (const vtkMTColumn& column : patch.PointColumns)
  {
    ordered.PointColumns.push_back(Permute(column, wedgeFrom));
  }
}

void PermuteTriangles(
  const vtkMTPatch& patch, const Numbering& numbering, const std::vector<std::uint32_t>& from, vtkMTPatch& ordered)
{
  const std::vector<std::uint32_t>& place = numbering.WedgePlace;
  ordered.Triangles.reserve(numbering.Triangles.size());
  for (const vtkMTTriangle& t : numbering.Triangles)
  {
    ordered.Triangles.push_back({ place[t[0]], place[t[1]], place[t[2]] });
  }
  for (const vtkMTColumn& column : patch.CellColumns)
  {
    ordered.CellColumns.push_back(Permute(column, from));
  }
}
}

std::vector<std::uint32_t> vtkMTPatchOrder::PlacePoints(const std::vector<unsigned char>& isShared)
{
  std::vector<std::uint32_t> place(isShared.size());
  std::uint32_t shared = 0;
  std::uint32_t own = static_cast<std::uint32_t>(std::count(isShared.begin(), isShared.end(), 1));
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    // Without a branch, as which way it goes cannot be predicted.
    const std::uint32_t one = isShared[i] ? 1 : 0;
    place[i] = one != 0 ? shared : own;
    shared += one;
    own += 1 - one;
  }
  return place;
}

std::vector<std::uint32_t> vtkMTPatchOrder::PlaceWedges(
  const std::vector<std::uint32_t>& wedgePoints, const std::vector<std::uint32_t>& pointOfStream)
{
  if (wedgePoints.empty())
  {
    return pointOfStream;
  }
  std::vector<std::uint32_t> next(pointOfStream.size() + 1, 0);
  for (std::uint32_t point : wedgePoints)
  {
    ++next[pointOfStream[point] + std::size_t(1)];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> place(wedgePoints.size());
  for (std::size_t w = 0; w < place.size(); ++w)
  {
    place[w] = next[pointOfStream[wedgePoints[w]]]++;
  }
  return place;
}

vtkMTPatchOrder vtkMTPatchOrder::Make(const vtkMTPatch& patch)
{
  vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(patch.Triangles, patch.GetNumberOfWedges());
  const Numbering numbering(patch, coded.Triangles);
  vtkMTPatchOrder result;
  result.Steps = std::move(coded.Steps);
  result.Names = std::move(coded.Names);
  result.PointOfStream = numbering.PointPlace;
  result.WedgePoints = numbering.WedgePoints;
  PermutePoints(patch, numbering, result.Patch);
  PermuteTriangles(patch, numbering, coded.Order, result.Patch);
  return result;
}
