// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBarycentreSample.h"

#include <algorithm>

std::uint64_t vtkMTBarycentreSample::Hash(std::uint64_t number)
{
  // The finaliser of SplitMix64.
  std::uint64_t hash = number + 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

bool vtkMTBarycentreSample::Take(vtkMTBarycentreScan& scan, std::size_t stride)
{
  this->Points.clear();
  this->Points.reserve(scan.GetNumberOfTriangles() / stride + 1);
  this->Count = 0;
  Point first = { 0.0, 0.0, 0.0 };
  Point sum = { 0.0, 0.0, 0.0 };
  Point lo = { 0.0, 0.0, 0.0 };
  Point hi = { 0.0, 0.0, 0.0 };
  std::size_t run = 0;   // the next one
  std::size_t taken = 0; // of the present one
  const bool ok = scan.Scan(
    [&](const Point* barycentres, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (!IsFinite(barycentres[i]))
        {
          continue;
        }
        if (this->Count == 0)
        {
          first = lo = hi = barycentres[i];
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          sum[axis] += barycentres[i][axis] - first[axis];
          lo[axis] = std::min(lo[axis], barycentres[i][axis]);
          hi[axis] = std::max(hi[axis], barycentres[i][axis]);
        }
        // Once per run: divisions for every barycentre take longer than all the rest.
        if (this->Count == run * stride)
        {
          taken = GetPlaceInRun(run++, stride);
        }
        if (this->Count++ == taken)
        {
          this->Points.push_back(barycentres[i]);
        }
      }
    });
  this->Lo = lo;
  this->Hi = hi;
  this->Largest = std::max({ -lo[0], hi[0], -lo[1], hi[1], -lo[2], hi[2] });
  for (int axis = 0; ok && this->Count > 0 && axis < 3; ++axis)
  {
    this->Mean[axis] = first[axis] + sum[axis] / static_cast<double>(this->Count);
  }
  // The only run may have ended before its place.
  if (ok && this->Count > 0 && this->Points.empty())
  {
    this->Points.push_back(this->Mean);
  }
  return ok;
}
