// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBallGrid
 * @brief which of many balls touch a ball
 *
 * Most balls are in the cell of a regular grid that holds their middle, so a question looks at the cells that are as
 * near as the largest of them reaches; rows of cells lie one behind the other in memory. Those that are much larger
 * than most are kept apart, and looked at for every question, by runs of neighbours in order.
 *
 * Threads: const and safe.
 */
#ifndef vtkMTBallGrid_h
#define vtkMTBallGrid_h

#include "vtkMTCertificationModule.h" // For export macro

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTBallGrid
{
public:
  struct Ball
  {
    std::array<double, 3> Middle;
    double Radius;
  };

  /// A box, and so much around it.
  struct Box
  {
    std::array<double, 3> Low;
    std::array<double, 3> High;
    double Radius;
  };

  explicit vtkMTBallGrid(std::vector<Ball> balls);

  const Ball& GetBall(std::size_t index) const { return this->Balls[index]; }
  /// The indices of those that touch a ball, each once.
  void Find(const Ball& ball, std::vector<std::uint32_t>& found) const;
  /// Whether one of those that touch a ball or a box is accepted: accept(index) is asked until it is.
  template <typename Shape, typename Accept>
  bool HasTouching(const Shape& shape, const Accept& accept) const;

  static bool Touch(const Ball& a, const Ball& b)
  {
    const double x = a.Middle[0] - b.Middle[0];
    const double y = a.Middle[1] - b.Middle[1];
    const double z = a.Middle[2] - b.Middle[2];
    const double reach = a.Radius + b.Radius;
    return x * x + y * y + z * z <= reach * reach;
  }
  static bool Touch(const Box& box, const Ball& ball)
  {
    double distance2 = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double away = std::max({ box.Low[i] - ball.Middle[i], ball.Middle[i] - box.High[i], 0.0 });
      distance2 += away * away;
    }
    const double reach = box.Radius + ball.Radius;
    return distance2 <= reach * reach;
  }

private:
  static constexpr std::size_t RunLength = 8;

  struct CellRange
  {
    std::array<int, 3> First;
    std::array<int, 3> Last;
  };

  int GetCell(int axis, double x) const;
  std::size_t GetIndex(int x, int y, int z) const;
  void PutIntoCells(const std::vector<std::uint32_t>& ordinary);
  void MakeRuns();
  CellRange GetCells(const std::array<double, 3>& low, const std::array<double, 3>& high, double around) const;
  CellRange GetCells(const Ball& ball) const { return this->GetCells(ball.Middle, ball.Middle, ball.Radius); }
  CellRange GetCells(const Box& box) const { return this->GetCells(box.Low, box.High, box.Radius); }

  std::vector<Ball> Balls;
  double Reach = 0.0; // of those in cells
  std::array<double, 3> Low{ 0.0, 0.0, 0.0 };
  std::array<int, 3> Cells{ 1, 1, 1 };
  double CellsPerUnit = 0.0;
  std::vector<std::uint32_t> First; // per cell, one more than cells
  std::vector<std::uint32_t> InCells;
  std::vector<Ball> BallsInCells; // the same balls once more, for they are read one after the other
  std::vector<std::uint32_t> Large;
  std::vector<Ball> Runs; // of Large
};

//------------------------------------------------------------------------------
template <typename Shape, typename Accept>
bool vtkMTBallGrid::HasTouching(const Shape& shape, const Accept& accept) const
{
  for (std::size_t run = 0; run < this->Runs.size(); ++run)
  {
    const std::size_t end = std::min(RunLength * (run + 1), this->Large.size());
    for (std::size_t i = RunLength * run; i < end && Touch(shape, this->Runs[run]); ++i)
    {
      if (Touch(shape, this->Balls[this->Large[i]]) && accept(this->Large[i]))
      {
        return true;
      }
    }
  }
  if (this->InCells.empty())
  {
    return false;
  }
  const CellRange cells = this->GetCells(shape);
  for (int z = cells.First[2]; z <= cells.Last[2]; ++z)
  {
    for (int y = cells.First[1]; y <= cells.Last[1]; ++y)
    {
      const std::uint32_t end = this->First[this->GetIndex(cells.Last[0], y, z) + 1];
      for (std::uint32_t i = this->First[this->GetIndex(cells.First[0], y, z)]; i < end; ++i)
      {
        if (Touch(shape, this->BallsInCells[i]) && accept(this->InCells[i]))
        {
          return true;
        }
      }
    }
  }
  return false;
}

#endif
