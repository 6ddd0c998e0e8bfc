// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFarOutliers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace
{
using Box = std::array<double, 6>;

constexpr int GapBits = 7; // between powers of two: more than 64 between the numbers themselves
constexpr double StepsPerEdge = 16.0;
constexpr std::uint64_t AlwaysFew = 16;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr Box Empty{ Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity };

// The exponent of the power of two at or below x; zero and infinity have some of their own.
constexpr int PowerOfZero = -1100;
int GetPower(double x)
{
  return x > 0.0 ? (std::isinf(x) ? std::numeric_limits<double>::max_exponent : std::ilogb(x)) : PowerOfZero;
}

// The same of a length, without a call for those in the normal range.
int GetPowerOfLength(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const std::uint64_t exponent = bits >> 52;
  constexpr std::uint64_t mostNormal = 0x7fe;
  return exponent - 1 < mostNormal ? static_cast<int>(exponent) - 1023 : GetPower(x);
}

void Extend(Box& box, const vtkMTInputBlock::Place& place)
{
  for (int i = 0; i < 3; ++i)
  {
    box[2 * i] = std::min(box[2 * i], place[i]);
    box[2 * i + 1] = std::max(box[2 * i + 1], place[i]);
  }
}

double GetStep(const Box& box, int bits)
{
  double step = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    step = std::max(step, std::ldexp(box[2 * i + 1], -bits) - std::ldexp(box[2 * i], -bits)); // no overflow
  }
  return step;
}

std::string Describe(const Box& box)
{
  std::ostringstream text;
  text.precision(6);
  text << "(" << box[0] << " " << box[2] << " " << box[4] << ") (" << box[1] << " " << box[3] << " " << box[5] << ")";
  return text.str();
}

// Keys are in the order of the numbers.
constexpr std::uint64_t SignBit = std::uint64_t(1) << 63;

std::uint64_t ToKey(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return (bits & SignBit) ? ~bits : bits | SignBit;
}

double FromKey(std::uint64_t key)
{
  const std::uint64_t bits = (key & SignBit) ? key & ~SignBit : ~key;
  double x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}
}

vtkMTFarOutliers::vtkMTFarOutliers(int latticeBits, vtkMTSpoolStore& store, std::size_t memory)
  : Bits(latticeBits)
  , Limit(std::numeric_limits<int>::max())
  , Lengths(std::numeric_limits<double>::max_exponent - PowerOfZero + 1, 0)
  , Bounds(Empty)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Coordinates.push_back(std::make_unique<vtkMTRecordSort>(store, sizeof(std::uint64_t), memory / 3));
  }
}

vtkMTFarOutliers::~vtkMTFarOutliers() = default;

//------------------------------------------------------------------------------
bool vtkMTFarOutliers::Add(const vtkMTInputBlock& block)
{
  if (this->Step != Edges)
  {
    if (this->Step == Reaches)
    {
      this->AddReaches(block);
    }
    return this->Step != Middles || this->AddMiddles(block);
  }
  this->Triangles += block.Triangles.size();
  for (const vtkMTInputBlock::Triangle& t : block.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const vtkMTInputBlock::Place& a = block.Places[t[c]];
      const vtkMTInputBlock::Place& b = block.Places[t[(c + 1) % 3]];
      const double length = std::max(std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1])), std::abs(a[2] - b[2]));
      ++this->Lengths[static_cast<std::size_t>(GetPowerOfLength(length) - PowerOfZero)];
    }
  }
  const std::vector<unsigned char> used = block.GetUsed();
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    if (used[p] != 0)
    {
      Extend(this->Bounds, block.Places[p]);
    }
  }
  return true;
}

bool vtkMTFarOutliers::AddMiddles(const vtkMTInputBlock& block)
{
  for (const vtkMTInputBlock::Triangle& t : block.Triangles)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::uint64_t key = ToKey(block.Places[t[0]][axis]);
      if (!this->Coordinates[axis]->Add(&key))
      {
        this->Error = this->Coordinates[axis]->GetError();
        return false;
      }
    }
  }
  return true;
}

void vtkMTFarOutliers::AddReaches(const vtkMTInputBlock& block)
{
  for (const vtkMTInputBlock::Triangle& t : block.Triangles)
  {
    Shell& shell = this->Shells.emplace(GetPower(this->GetReach(block, t)), Shell{ 0, Empty }).first->second;
    ++shell.Triangles;
    for (const std::uint32_t p : t)
    {
      Extend(shell.Bounds, block.Places[p]);
    }
  }
}

bool vtkMTFarOutliers::FinishStep()
{
  if (this->Step == Edges)
  {
    this->FindTypicalEdge();
    this->Step = this->Triangles > 0 && this->IsTooCoarse(this->Bounds) ? Middles : Finished;
    return true;
  }
  if (this->Step == Middles)
  {
    this->Step = Reaches;
    return this->FindMiddle();
  }
  this->Step = Finished;
  this->Decide();
  return true;
}

// The power of two above the median edge, of all triangles: few outliers do not move it.
void vtkMTFarOutliers::FindTypicalEdge()
{
  std::size_t power = 0;
  for (std::uint64_t count = this->Lengths[0]; 2 * count < 3 * this->Triangles; count += this->Lengths[power])
  {
    ++power;
  }
  this->TypicalEdge = std::ldexp(1.0, static_cast<int>(power) + PowerOfZero + 1);
}

bool vtkMTFarOutliers::FindMiddle()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    vtkMTRecordSort& sort = *this->Coordinates[axis];
    const unsigned char* record = sort.Finish() ? sort.Next() : nullptr;
    for (std::uint64_t i = 0; record && i < this->Triangles / 2; ++i)
    {
      record = sort.Next();
    }
    if (!record)
    {
      this->Error = sort.GetError();
      return false;
    }
    this->Middle[axis] = FromKey(vtkMTRecordSort::GetKey(record));
    this->Coordinates[axis].reset();
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkMTFarOutliers::GetReach(const vtkMTInputBlock& block, const vtkMTInputBlock::Triangle& triangle) const
{
  double reach = 0.0;
  for (const std::uint32_t p : triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      reach = std::max(reach, std::abs(block.Places[p][i] - this->Middle[i]));
    }
  }
  return reach;
}

bool vtkMTFarOutliers::IsFar(const vtkMTInputBlock& block, const vtkMTInputBlock::Triangle& triangle) const
{
  return this->Outliers > 0 && GetPower(this->GetReach(block, triangle)) > this->Limit;
}

Box vtkMTFarOutliers::FindBox(int limit) const
{
  Box box = Empty;
  for (const auto& [power, shell] : this->Shells)
  {
    for (int i = 0; i < 3 && power <= limit; ++i)
    {
      box[2 * i] = std::min(box[2 * i], shell.Bounds[2 * i]);
      box[2 * i + 1] = std::max(box[2 * i + 1], shell.Bounds[2 * i + 1]);
    }
  }
  return box;
}

bool vtkMTFarOutliers::IsTooCoarse(const Box& box) const
{
  return GetStep(box, this->Bits) > this->TypicalEdge / StepsPerEdge;
}

std::uint64_t vtkMTFarOutliers::GetMostFew() const
{
  return std::min(std::max(AlwaysFew, this->Triangles / 1000), this->Triangles / 4);
}

void vtkMTFarOutliers::Decide()
{
  std::uint64_t beyond = 0;
  for (auto outer = this->Shells.rbegin(); outer != this->Shells.rend() && std::next(outer) != this->Shells.rend();
       ++outer)
  {
    beyond += outer->second.Triangles;
    const int inner = std::next(outer)->first;
    if (outer->first - inner < GapBits)
    {
      continue;
    }
    if (beyond > this->GetMostFew())
    {
      this->Explain(beyond, outer->first);
      break;
    }
    this->Limit = inner;
    if (!this->IsTooCoarse(this->FindBox(inner)))
    {
      break;
    }
  }
  if (!this->Refused)
  {
    this->Collect();
  }
}

void vtkMTFarOutliers::Collect()
{
  for (const auto& [power, shell] : this->Shells)
  {
    this->Outliers += power > this->Limit ? shell.Triangles : 0;
  }
  if (this->Outliers == 0)
  {
    return;
  }
  const Box near = this->FindBox(this->Limit);
  std::ostringstream text;
  text << this->Outliers << " of " << this->Triangles
       << " triangles are far outliers and were left out (dropped_far_outlier): all others lie within "
       << Describe(near) << ", with them the bounds would be " << Describe(this->Bounds) << " and a lattice step "
       << GetStep(this->Bounds, this->Bits) << ", too coarse for edges of " << this->TypicalEdge
       << "; keep them with --keep-far-outliers (KeepFarOutliers), or use more --lattice-bits";
  this->Message = text.str();
  this->Bounds = near;
}

// More than a few triangles beyond the gap: refused, or built with a warning.
void vtkMTFarOutliers::Explain(std::uint64_t beyond, int power)
{
  std::ostringstream text;
  text << beyond << " of " << this->Triangles << " triangles reach at least 64 times as far as the others, which "
       << "lie within " << Describe(this->FindBox(power - 1)) << "; with bounds of " << Describe(this->Bounds)
       << " the lattice step is " << GetStep(this->Bounds, this->Bits) << ", too coarse for edges of "
       << this->TypicalEdge;
  this->Refused = beyond <= this->Triangles / 2;
  text << (this->Refused ? "; take them out of the input, build the parts as models of their own, use more "
                           "--lattice-bits (LatticeBits), "
                           "or accept that step with --keep-far-outliers (KeepFarOutliers)"
                         : "; more --lattice-bits (LatticeBits) or models of its parts would keep more");
  this->Message = text.str();
}
