// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinerRecord.h"

#include "vtkMTBytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);
constexpr std::size_t GroupLength = 8; // triangles that are taken together, as neighbours in order are in space
using Small = std::uint16_t;
constexpr std::int64_t LargestSmall = std::numeric_limits<Small>::max();

// A patch's shape in its record: points relative to its corner, and indices, each in two bytes where that is enough.
struct Header
{
  vtkMTPoint Corner;
  std::uint32_t HasSmallPoints;
  std::uint32_t HasSmallIndices;
};
// The ball around some triangles and what stands on them, relative to the corner. GroupLength of them make a block,
// which has a ball as well.
struct Group
{
  std::array<float, 3> Middle;
  float Radius;
};

vtkMTSurface::Vector GetPlace(const vtkMTPoint& point, const vtkMTPoint& origin)
{
  return { double(point[0]) - origin[0], double(point[1]) - origin[1], double(point[2]) - origin[2] };
}

std::size_t CountGroups(std::size_t size, std::size_t length)
{
  return (size + length - 1) / length;
}

void Include(const vtkMTBox& box, vtkMTBox& whole)
{
  for (int i = 0; i < 3; ++i)
  {
    whole[2 * i] = std::min(whole[2 * i], box[2 * i]);
    whole[2 * i + 1] = std::max(whole[2 * i + 1], box[2 * i + 1]);
  }
}

// Rounded so that nothing is left out: single precision is within 2^-23 of coordinates that are below 2^32 in size.
Group MakeGroup(const vtkMTBox& box, const vtkMTPoint& corner, double wider)
{
  const vtkMTBoxRuns::Ball ball = vtkMTFinerRecord::GetBall(box, corner, wider);
  Group group;
  double largest = ball.Radius;
  for (int i = 0; i < 3; ++i)
  {
    group.Middle[i] = static_cast<float>(ball.Middle[i]);
    largest = std::max(largest, std::abs(ball.Middle[i]));
  }
  group.Radius = static_cast<float>(ball.Radius + largest * 1e-6);
  return group;
}

template <typename Value>
void PutSmall(vtkMTBytes::Writer& writer, const std::vector<std::array<Value, 3>>& values, bool isSmall)
{
  if (!isSmall)
  {
    writer.PutList(values);
    return;
  }
  std::vector<std::array<Small, 3>> converted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      converted[i][c] = static_cast<Small>(values[i][c]);
    }
  }
  writer.PutList(converted);
}

using Reader = vtkMTBytes::Reader;

// A patch's shape as it lies in its record.
template <typename Offset, typename Index>
struct Shape
{
  vtkMTPoint Corner;
  vtkMTBytes::View<Group> Blocks;
  vtkMTBytes::View<Group> Groups;
  vtkMTBytes::View<std::array<Offset, 3>> Points;
  vtkMTBytes::View<std::array<Index, 3>> Triangles;
  vtkMTBytes::View<float> Known;

  bool Take(const vtkMTPoint& corner, Reader& reader)
  {
    this->Corner = corner;
    this->Blocks = reader.TakeView<Group>();
    this->Groups = reader.TakeView<Group>();
    this->Points = reader.TakeView<std::array<Offset, 3>>();
    this->Triangles = reader.TakeView<std::array<Index, 3>>();
    this->Known = reader.TakeView<float>();
    const std::size_t triangles = this->Triangles.size();
    return reader.IsSound() && reader.IsAtEnd() && this->Groups.size() == CountGroups(triangles, GroupLength) &&
      this->Blocks.size() == CountGroups(this->Groups.size(), GroupLength) &&
      (this->Known.empty() || this->Known.size() == 2 * triangles);
  }
};

// Appends what is near of a patch to a part.
template <typename Offset, typename Index>
class Appender
{
public:
  Appender(const Shape<Offset, Index>& shape, const vtkMTDirectDeviation::Neighbourhood& near, const vtkMTPoint& origin,
    vtkMTDirectDeviation::FinerPart& part)
    : From(shape)
    , Near(near)
    , Corner(GetPlace(shape.Corner, origin))
    , Part(part)
    , NewIndex(shape.Points.size(), None)
  {
  }

  // False where triangles use points that are not there.
  bool Run()
  {
    for (std::size_t b = 0; b < this->From.Blocks.size(); ++b)
    {
      const std::size_t end = std::min(GroupLength * (b + 1), this->From.Groups.size());
      if (!this->IsNear(this->From.Blocks[b]))
      {
        continue;
      }
      for (std::size_t g = GroupLength * b; g < end; ++g)
      {
        if (this->IsNear(this->From.Groups[g]) && !this->AppendGroup(g))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  bool IsNear(const Group& group) const
  {
    vtkMTBoxRuns::Ball ball{ this->Corner, group.Radius };
    for (int i = 0; i < 3; ++i)
    {
      ball.Middle[i] += group.Middle[i];
    }
    return this->Near.Touches(ball);
  }

  bool AppendGroup(std::size_t group)
  {
    const auto& known = this->From.Known;
    const std::size_t end = std::min(GroupLength * (group + 1), this->From.Triangles.size());
    for (std::size_t t = GroupLength * group; t < end; ++t)
    {
      const std::array<Index, 3> p = this->From.Triangles[t];
      if (std::max({ p[0], p[1], p[2] }) >= this->NewIndex.size())
      {
        return false;
      }
      this->Part.Mesh.Triangles.push_back({ this->GetIndex(p[0]), this->GetIndex(p[1]), this->GetIndex(p[2]) });
      this->Part.Known.push_back(
        { known.empty() ? 0.0f : known[2 * t], known.empty() ? 0.0f : known[2 * t + 1], 0, 0 });
    }
    return true;
  }

  std::uint32_t GetIndex(std::size_t p)
  {
    if (this->NewIndex[p] == None)
    {
      this->NewIndex[p] = static_cast<std::uint32_t>(this->Part.Mesh.Points.size());
      const std::array<Offset, 3> offset = this->From.Points[p];
      vtkMTPoint point;
      for (int i = 0; i < 3; ++i)
      {
        point[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(this->From.Corner[i]) + offset[i]);
      }
      this->Part.Mesh.Points.push_back(point);
    }
    return this->NewIndex[p];
  }

  const Shape<Offset, Index>& From;
  const vtkMTDirectDeviation::Neighbourhood& Near;
  const vtkMTSurface::Vector Corner;
  vtkMTDirectDeviation::FinerPart& Part;
  std::vector<std::uint32_t> NewIndex; // of the patch's points, in the part
};

// What a record is taken with.
struct Taking
{
  const vtkMTDirectDeviation::Neighbourhood& Near;
  const vtkMTPoint& Origin;
  vtkMTDirectDeviation::FinerPart& Part;

  template <typename Offset, typename Index>
  bool Append(const vtkMTPoint& corner, Reader& reader) const
  {
    Shape<Offset, Index> shape;
    return shape.Take(corner, reader) && Appender<Offset, Index>(shape, this->Near, this->Origin, this->Part).Run();
  }
};
}

//------------------------------------------------------------------------------
vtkMTBoxRuns::Ball vtkMTFinerRecord::GetBall(const vtkMTBox& box, const vtkMTPoint& origin, double wider)
{
  const vtkMTSurface::Vector low = GetPlace({ box[0], box[2], box[4] }, origin);
  return vtkMTDirectDeviation::GetBall(low, low, GetPlace({ box[1], box[3], box[5] }, origin), wider);
}

//------------------------------------------------------------------------------
void vtkMTFinerRecord::Encode(const vtkMTPatch& mesh, const vtkMTDirectDeviation::Deviations& deviations, Bytes& bytes)
{
  const vtkMTBox box = mesh.GetBox();
  const Header header{ { box[0], box[2], box[4] },
    std::int64_t(box[1]) - box[0] <= LargestSmall && std::int64_t(box[3]) - box[2] <= LargestSmall &&
      std::int64_t(box[5]) - box[4] <= LargestSmall,
    mesh.Points.size() <= static_cast<std::size_t>(LargestSmall) };
  std::vector<std::array<std::uint32_t, 3>> points(mesh.Points.size());
  std::vector<vtkMTTriangle> triangles(mesh.Triangles.size());
  std::vector<float> known;
  std::vector<Group> groups;
  std::vector<Group> blocks;
  const vtkMTBox nothing{ box[1], box[0], box[3], box[2], box[5], box[4] };
  vtkMTBox aroundBlock = nothing;
  float widerBlock = 0.0f;
  bool isZero = true;
  for (std::size_t first = 0; first < triangles.size(); first += GroupLength)
  {
    vtkMTBox around = nothing;
    float wider = 0.0f;
    for (std::size_t t = first; t < std::min(first + GroupLength, triangles.size()); ++t)
    {
      triangles[t] = mesh.GetPointsOfTriangle(t);
      known.push_back(deviations[t].ToInput);
      known.push_back(deviations[t].FromInput);
      wider = std::max(wider, deviations[t].FromInput);
      isZero = isZero && deviations[t].ToInput == 0.0f && deviations[t].FromInput == 0.0f;
      for (const std::uint32_t p : triangles[t])
      {
        for (int i = 0; i < 3; ++i)
        {
          const std::int32_t x = mesh.Points[p][i];
          around[2 * i] = std::min(around[2 * i], x);
          around[2 * i + 1] = std::max(around[2 * i + 1], x);
          points[p][i] = static_cast<std::uint32_t>(x) - static_cast<std::uint32_t>(header.Corner[i]);
        }
      }
    }
    groups.push_back(MakeGroup(around, header.Corner, wider));
    Include(around, aroundBlock);
    widerBlock = std::max(widerBlock, wider);
    if (groups.size() % GroupLength == 0 || first + GroupLength >= triangles.size())
    {
      blocks.push_back(MakeGroup(aroundBlock, header.Corner, widerBlock));
      aroundBlock = nothing;
      widerBlock = 0.0f;
    }
  }
  bytes.clear();
  vtkMTBytes::Writer writer(bytes);
  writer.Put(header);
  writer.PutList(blocks);
  writer.PutList(groups);
  PutSmall(writer, points, header.HasSmallPoints);
  PutSmall(writer, triangles, header.HasSmallIndices);
  writer.PutList(isZero ? std::vector<float>() : known);
}

//------------------------------------------------------------------------------
bool vtkMTFinerRecord::Append(const vtkMTBytes::Record& record, const vtkMTDirectDeviation::Neighbourhood& near,
  const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part)
{
  Reader reader(record);
  const auto header = reader.Take<Header>();
  const Taking taking{ near, origin, part };
  if (header.HasSmallPoints)
  {
    return header.HasSmallIndices ? taking.Append<Small, Small>(header.Corner, reader)
                                  : taking.Append<Small, std::uint32_t>(header.Corner, reader);
  }
  return header.HasSmallIndices ? taking.Append<std::uint32_t, Small>(header.Corner, reader)
                                : taking.Append<std::uint32_t, std::uint32_t>(header.Corner, reader);
}
