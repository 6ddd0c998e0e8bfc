// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFrameClock.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkMTFrameClock::Begin(double time)
{
  this->Now = Sums();
  this->Time = time;
  this->InFrame = true;
}

//------------------------------------------------------------------------------
vtkMTFrameClock::Frame vtkMTFrameClock::End(double time)
{
  Frame frame;
  frame.Counts = this->InFrame && this->Now.Drew && !this->Now.Discarded;
  frame.Seconds = time - this->Time;
  frame.Triangles = this->Now.Triangles;
  frame.Wanted = this->Now.Wanted;
  if (frame.Counts)
  {
    this->Before = this->Now;
  }
  this->InFrame = false;
  return frame;
}

//------------------------------------------------------------------------------
double vtkMTFrameClock::GetFairPart(double share) const
{
  // An actor that was not there in the last frame is in this one's sum, once it has drawn.
  const double shares = std::max({ this->Before.Shares, this->Now.Shares, share });
  return shares > 0.0 ? share / shares : 1.0;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTFrameClock::Allow(double share, double wanted)
{
  this->Now.Wanted = wanted;
  const std::uint64_t all = this->Rate.GetTriangles(wanted);
  if (all == 0)
  {
    return 0;
  }
  this->Now.All = static_cast<double>(all);
  double part = this->GetFairPart(share);
  if (this->Before.WantingShares > 0.0 && this->Before.All > 0.0)
  {
    part += this->Before.Left / this->Before.All * share / std::max(this->Before.WantingShares, share);
  }
  return std::max<std::uint64_t>(static_cast<std::uint64_t>(std::min(part, 1.0) * this->Now.All), 1);
}

//------------------------------------------------------------------------------
void vtkMTFrameClock::Draw(double share, std::uint64_t triangles, bool wantsMore)
{
  const double fair = this->GetFairPart(share) * this->Now.All;
  this->Now.Drew = true;
  this->Now.Shares += share;
  this->Now.Triangles += triangles;
  if (wantsMore)
  {
    this->Now.WantingShares += share;
  }
  else
  {
    this->Now.Left += std::max(fair - static_cast<double>(triangles), 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkMTFrameClock::Learn(const Frame& frame)
{
  if (frame.Counts)
  {
    this->Rate.AddFrame(frame.Triangles, frame.Seconds, frame.Wanted);
  }
}
