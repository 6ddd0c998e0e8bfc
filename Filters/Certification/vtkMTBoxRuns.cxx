// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBoxRuns.h"

#include <limits>
#include <utility>

//------------------------------------------------------------------------------
vtkMTBoxRuns::vtkMTBoxRuns(std::vector<Box> boxes)
{
  this->Levels.push_back(std::move(boxes));
  while (this->Levels.back().size() > Length)
  {
    const std::vector<Box>& below = this->Levels.back();
    std::vector<Box> runs((below.size() + Length - 1) / Length);
    for (std::size_t run = 0; run < runs.size(); ++run)
    {
      Box whole = below[Length * run];
      for (std::size_t i = Length * run + 1; i < std::min(Length * (run + 1), below.size()); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          whole.Low[c] = std::min(whole.Low[c], below[i].Low[c]);
          whole.High[c] = std::max(whole.High[c], below[i].High[c]);
        }
      }
      runs[run] = whole;
    }
    this->Levels.push_back(std::move(runs));
  }
  double largest = 0.0;
  for (const Box& box : this->Levels.back())
  {
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max({ largest, std::abs(box.Low[c]), std::abs(box.High[c]) });
    }
  }
  for (const std::vector<Box>& level : this->Levels)
  {
    this->Runs.push_back(MakeRuns(level, GetMargin(largest)));
  }
}

//------------------------------------------------------------------------------
// Of boxes with a margin that is enough for the largest; at least one run. What is missing in the last is no number, so
// that not even a question without bounds touches it.
std::vector<vtkMTBoxRuns::Run> vtkMTBoxRuns::MakeRuns(const std::vector<Box>& boxes, double margin)
{
  std::vector<Run> runs(std::max<std::size_t>(1, (boxes.size() + Length - 1) / Length));
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    Run& run = runs[i / Length];
    for (int c = 0; c < 3; ++c)
    {
      run.Low[c][i % Length] = static_cast<float>(boxes[i].Low[c] - margin);
      run.High[c][i % Length] = static_cast<float>(boxes[i].High[c] + margin);
    }
  }
  for (std::size_t i = boxes.size(); i < Length * runs.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      runs.back().Low[c][i % Length] = std::numeric_limits<float>::quiet_NaN();
      runs.back().High[c][i % Length] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return runs;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTBoxRuns::FindNear(const Vector& x) const
{
  std::size_t nearest = 0;
  for (std::size_t level = this->Levels.size(); level > 0; --level)
  {
    const std::vector<Box>& boxes = this->Levels[level - 1];
    const std::size_t begin = level == this->Levels.size() ? 0 : Length * nearest;
    const std::size_t end = level == this->Levels.size() ? boxes.size() : std::min(begin + Length, boxes.size());
    double least = GetDistance2(boxes[begin], x);
    nearest = begin;
    for (std::size_t i = begin + 1; i < end; ++i)
    {
      const double distance2 = GetDistance2(boxes[i], x);
      if (distance2 < least)
      {
        least = distance2;
        nearest = i;
      }
    }
  }
  return static_cast<std::uint32_t>(nearest);
}

//------------------------------------------------------------------------------
vtkMTBoxRuns::Box vtkMTBoxRuns::GetBox(const vtkMTSurface& surface, std::uint32_t triangle, double wider)
{
  const Vector& a = surface.GetCorner(triangle, 0);
  const Vector& b = surface.GetCorner(triangle, 1);
  const Vector& c = surface.GetCorner(triangle, 2);
  Box box;
  for (int i = 0; i < 3; ++i)
  {
    box.Low[i] = std::min(std::min(a[i], b[i]), c[i]) - wider;
    box.High[i] = std::max(std::max(a[i], b[i]), c[i]) + wider;
  }
  return box;
}

//------------------------------------------------------------------------------
vtkMTBoxRuns::Box vtkMTBoxRuns::GetBox(const Ball& ball)
{
  Box box;
  for (int i = 0; i < 3; ++i)
  {
    const double reach = ball.Radius + (ball.Radius + std::abs(ball.Middle[i])) * 0x1p-36;
    box.Low[i] = ball.Middle[i] - reach;
    box.High[i] = ball.Middle[i] + reach;
  }
  return box;
}
