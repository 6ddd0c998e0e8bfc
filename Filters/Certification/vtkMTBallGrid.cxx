// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBallGrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr double LargeRadius = 3.0; // times the mean
constexpr double MostCells = 4.0;   // per ball
}

//------------------------------------------------------------------------------
vtkMTBallGrid::vtkMTBallGrid(std::vector<Ball> balls)
  : Balls(std::move(balls))
{
  double mean = 0.0;
  for (const Ball& ball : this->Balls)
  {
    mean += ball.Radius / static_cast<double>(this->Balls.size());
  }
  std::vector<std::uint32_t> ordinary;
  ordinary.reserve(this->Balls.size());
  for (std::uint32_t i = 0; i < this->Balls.size(); ++i)
  {
    const double radius = this->Balls[i].Radius;
    if (radius > LargeRadius * mean)
    {
      this->Large.push_back(i);
      continue;
    }
    ordinary.push_back(i);
    this->Reach = std::max(this->Reach, radius);
  }
  this->PutIntoCells(ordinary);
  this->MakeRuns();
}

//------------------------------------------------------------------------------
int vtkMTBallGrid::GetCell(int axis, double x) const
{
  return static_cast<int>(std::clamp((x - this->Low[axis]) * this->CellsPerUnit, 0.0, this->Cells[axis] - 1.0));
}

//------------------------------------------------------------------------------
std::size_t vtkMTBallGrid::GetIndex(int x, int y, int z) const
{
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(this->Cells[1]) + static_cast<std::size_t>(y)) *
    static_cast<std::size_t>(this->Cells[0]) +
    static_cast<std::size_t>(x);
}

//------------------------------------------------------------------------------
// Cells are cubes as wide as the largest ball, but wider where that would be too many.
void vtkMTBallGrid::PutIntoCells(const std::vector<std::uint32_t>& ordinary)
{
  if (ordinary.empty())
  {
    return;
  }
  std::array<double, 3> high;
  this->Low = high = this->Balls[ordinary.front()].Middle;
  for (const std::uint32_t b : ordinary)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Low[i] = std::min(this->Low[i], this->Balls[b].Middle[i]);
      high[i] = std::max(high[i], this->Balls[b].Middle[i]);
    }
  }
  const auto getCells = [&](int axis, double width)
  { return std::floor((high[axis] - this->Low[axis]) / width) + 1.0; };
  const double longest = std::max({ high[0] - this->Low[0], high[1] - this->Low[1], high[2] - this->Low[2] });
  double width = std::max({ this->Reach, longest / 1024.0, 1.0 });
  while (getCells(0, width) * getCells(1, width) * getCells(2, width) >
    std::max(64.0, MostCells * static_cast<double>(ordinary.size())))
  {
    width *= 1.25;
  }
  this->CellsPerUnit = 1.0 / width;
  for (int i = 0; i < 3; ++i)
  {
    this->Cells[i] = static_cast<int>(getCells(i, width));
  }
  std::vector<std::uint32_t> cells(ordinary.size());
  this->First.assign(this->GetIndex(this->Cells[0] - 1, this->Cells[1] - 1, this->Cells[2] - 1) + 2, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::array<double, 3>& x = this->Balls[ordinary[i]].Middle;
    cells[i] = static_cast<std::uint32_t>(
      this->GetIndex(this->GetCell(0, x[0]), this->GetCell(1, x[1]), this->GetCell(2, x[2])));
    ++this->First[cells[i] + 1];
  }
  for (std::size_t cell = 1; cell < this->First.size(); ++cell)
  {
    this->First[cell] += this->First[cell - 1];
  }
  std::vector<std::uint32_t> next(this->First.begin(), this->First.end() - 1);
  this->InCells.resize(ordinary.size());
  this->BallsInCells.resize(ordinary.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::uint32_t place = next[cells[i]]++;
    this->InCells[place] = ordinary[i];
    this->BallsInCells[place] = this->Balls[ordinary[i]];
  }
}

//------------------------------------------------------------------------------
void vtkMTBallGrid::MakeRuns()
{
  for (std::size_t first = 0; first < this->Large.size(); first += RunLength)
  {
    const std::size_t end = std::min(first + RunLength, this->Large.size());
    Ball run = this->Balls[this->Large[first]];
    for (std::size_t i = first; i < end; ++i)
    {
      const Ball& ball = this->Balls[this->Large[i]];
      const double x = ball.Middle[0] - run.Middle[0];
      const double y = ball.Middle[1] - run.Middle[1];
      const double z = ball.Middle[2] - run.Middle[2];
      run.Radius = std::max(run.Radius, (std::sqrt(x * x + y * y + z * z) + ball.Radius) * (1.0 + 1e-12));
    }
    this->Runs.push_back(run);
  }
}

//------------------------------------------------------------------------------
vtkMTBallGrid::CellRange vtkMTBallGrid::GetCells(
  const std::array<double, 3>& low, const std::array<double, 3>& high, double around) const
{
  CellRange cells;
  const double way = around + this->Reach;
  for (int i = 0; i < 3; ++i)
  {
    cells.First[i] = this->GetCell(i, low[i] - way);
    cells.Last[i] = this->GetCell(i, high[i] + way);
  }
  return cells;
}

//------------------------------------------------------------------------------
void vtkMTBallGrid::Find(const Ball& ball, std::vector<std::uint32_t>& found) const
{
  found.clear();
  this->HasTouching(ball,
    [&](std::uint32_t index)
    {
      found.push_back(index);
      return false;
    });
}
