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

  explicit vtkMTBallGrid(std::vector<Ball> balls);

  const Ball& GetBall(std::size_t index) const { return this->Balls[index]; }
  /// The indices of those that touch a ball, each once.
  void Find(const Ball& ball, std::vector<std::uint32_t>& found) const;

  static bool Touch(const Ball& a, const Ball& b)
  {
    const double x = a.Middle[0] - b.Middle[0];
    const double y = a.Middle[1] - b.Middle[1];
    const double z = a.Middle[2] - b.Middle[2];
    const double reach = a.Radius + b.Radius;
    return x * x + y * y + z * z <= reach * reach;
  }

private:
  static constexpr std::size_t RunLength = 8;

  void SetBounds();
  int GetCell(int axis, double x) const;
  std::size_t GetIndex(int x, int y, int z) const;
  void PutIntoCells(const std::vector<std::uint32_t>& ordinary);
  void MakeRuns();

  std::vector<Ball> Balls;
  double Reach = 0.0; // of those in cells
  std::array<double, 3> Low{ 0.0, 0.0, 0.0 };
  std::array<int, 3> Cells{ 1, 1, 1 };
  double CellsPerUnit = 0.0;
  std::vector<std::uint32_t> First; // per cell, one more than cells
  std::vector<std::uint32_t> InCells;
  std::vector<std::uint32_t> Large;
  std::vector<Ball> Runs; // of Large
};

#endif
