// SPDX-License-Identifier: BSD-3-Clause
// The four modes on fractal patches: errors and speed, relative to CGAL's Garland-Heckbert.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace SimplificationTesting;

namespace
{
struct Figures
{
  double Rms = 0.0;
  double Max = 0.0;
  double Seconds = 0.0;
  std::size_t Triangles = 0;
};

std::array<Figures, 4> CompareModes(int subdivisions, std::size_t triangles)
{
  std::array<Figures, 4> figures;
  for (int direction = 0; direction < 2; ++direction)
  {
    const vtkMTPatch floor = MakeFractalCap(subdivisions, triangles, direction);
    const Locks locked = LockBorder(floor);
    for (const int mode : AllModes)
    {
      double best = 1e30;
      Outcome run;
      for (int repeat = 0; repeat < 2; ++repeat)
      {
        const double start = GetThreadSeconds();
        run = Simplify(floor, locked, floor.Triangles.size() / 2, mode);
        best = std::min(best, GetThreadSeconds() - start);
      }
      EXPECT_TRUE(run.Ok) << run.Error;
      EXPECT_EQ(FindFault(floor, locked, run.Result), "");
      EXPECT_LE(run.Result.Triangles.size(), floor.Triangles.size() / 2);
      const Distance d = Measure(floor, ToPatch(run.Result));
      figures[mode].Rms += d.Rms;
      figures[mode].Max += d.Max;
      figures[mode].Seconds += best;
      figures[mode].Triangles += floor.Triangles.size();
    }
  }
  const Figures& reference = figures[vtkMTEdgeCollapse::GARLAND_HECKBERT];
  for (const int mode : AllModes)
  {
    vtkNew<vtkMTEdgeCollapse> named;
    named->SetMode(mode);
    const Figures& f = figures[mode];
    std::printf("%6zu triangles  %-17s RMS %.3f  max %.3f of garland-heckbert  %6.0f ktri/s\n", triangles,
      named->GetSimplifierName(), f.Rms / reference.Rms, f.Max / reference.Max,
      1e-3 * static_cast<double>(f.Triangles) / f.Seconds);
  }
  return figures;
}
}

TEST(Modes, FastIsNearlyAsNearToTheFloorAsBest)
{
  for (const auto& size : { std::make_pair(6, std::size_t(4000)), std::make_pair(7, std::size_t(16000)) })
  {
    const auto figures = CompareModes(size.first, size.second);
    const Figures& fast = figures[vtkMTEdgeCollapse::FAST];
    const Figures& best = figures[vtkMTEdgeCollapse::BEST];
    EXPECT_LE(fast.Rms, 1.03 * best.Rms);
    EXPECT_LE(best.Rms, figures[vtkMTEdgeCollapse::GARLAND_HECKBERT].Rms);
  }
}
