// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchOrder.h"

#include "Tuples/vtkMTTuples.h"
#include "vtkMTFill.h"
#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);

vtkMTColumn Permute(const vtkMTColumn& column, const std::vector<std::uint32_t>& from)
{
  return vtkMTTuples::Gather(column, from.empty() ? 0 : column.size() / from.size(), from);
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

// Points and wedges in order of use, and their places in the stored patch.
struct Numbering
{
  std::vector<std::uint32_t> WedgeOrder;  // the patch's wedge for each in order of use
  std::vector<std::uint32_t> PointOrder;  // empty where wedge i is point i: it is the same
  std::vector<std::uint32_t> WedgePoints; // order of use of points
  std::vector<std::uint32_t> PointPlace;
  std::vector<std::uint32_t> WedgePlace;

  Numbering(const vtkMTPatch& patch, std::vector<std::uint32_t> wedgeOrder)
    : WedgeOrder(std::move(wedgeOrder))
  {
    if (!patch.WedgePoints.empty())
    {
      this->NumberPoints(patch);
    }
    const std::vector<std::uint32_t>& points = this->GetPointOrder();
    const std::size_t shared = patch.Ids.size();
    std::vector<unsigned char> isShared(points.size());
    std::transform(points.begin(), points.end(), isShared.begin(),
      [shared](std::uint32_t point) { return static_cast<unsigned char>(point < shared ? 1 : 0); });
    this->PointPlace = vtkMTPatchOrder::PlacePoints(isShared);
    this->WedgePlace = vtkMTPatchOrder::PlaceWedges(this->WedgePoints, this->PointPlace);
  }

  const std::vector<std::uint32_t>& GetPointOrder() const
  {
    return this->PointOrder.empty() ? this->WedgeOrder : this->PointOrder;
  }

private:
  void NumberPoints(const vtkMTPatch& patch)
  {
    FirstUse points(patch.Points.size());
    for (const std::uint32_t w : this->WedgeOrder)
    {
      points.Meet(patch.WedgePoints[w]);
    }
    points.Finish();
    this->WedgePoints.reserve(patch.WedgePoints.size());
    for (const std::uint32_t w : this->WedgeOrder)
    {
      this->WedgePoints.push_back(points.Number[patch.WedgePoints[w]]);
    }
    this->PointOrder = std::move(points.Order);
  }
};

void PermutePoints(const vtkMTPatch& patch, const Numbering& numbering, vtkMTPatch& ordered)
{
  ordered.Points.resize(patch.Points.size());
  ordered.Ids.resize(patch.Ids.size());
  const std::vector<std::uint32_t>& order = numbering.GetPointOrder();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::uint32_t from = order[i];
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

void PermuteTriangles(const vtkMTPatch& patch, const std::vector<std::uint32_t>& place,
  const vtkMTTriangleCodec::Decoded& mesh, const std::vector<std::uint32_t>& from, vtkMTPatch& ordered)
{
  vtkMTFill(ordered.Triangles, from.size(),
    [place = place.data(), triangles = mesh.Triangles.data()](std::size_t i)
    {
      const std::array<std::uint32_t, 4>& t = triangles[i];
      return vtkMTTriangle{ place[t[0]], place[t[1]], place[t[2]] };
    });
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

vtkMTPatchOrder vtkMTPatchOrder::Make(const vtkMTPatch& patch, vtkMTTriangleCodec::Decoded& mesh)
{
  vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(patch.Triangles, patch.GetNumberOfWedges(), mesh);
  Numbering numbering(patch, std::move(coded.Vertices));
  vtkMTPatchOrder result;
  result.Steps = std::move(coded.Steps);
  result.Names = std::move(coded.Names);
  PermutePoints(patch, numbering, result.Patch);
  PermuteTriangles(patch, numbering.WedgePlace, mesh, coded.Order, result.Patch);
  result.PointOfStream = std::move(numbering.PointPlace);
  result.WedgePoints = std::move(numbering.WedgePoints);
  return result;
}

vtkMTPatchOrder vtkMTPatchOrder::Make(const vtkMTPatch& patch)
{
  vtkMTTriangleCodec::Decoded mesh;
  return vtkMTPatchOrder::Make(patch, mesh);
}
