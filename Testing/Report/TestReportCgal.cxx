// SPDX-License-Identifier: BSD-3-Clause
// The certified errors, the search for the worst place and CGAL's bounded-error Hausdorff distance agree.
#include "MTReportCgal.h"

#include "MTStiffCases.h"
#include "MTStiffLevels.h"

#include "vtkMTPatchStore.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

TEST(ReportCgal, DistanceOfTwoTrianglesIsTheOneThatIsKnown)
{
  const MTWorstPlace::Surface flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const MTWorstPlace::Surface lifted{ { { 0, 0, 0.25 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const MTReportCgal::Distance distance = MTReportCgal::GetSymmetricDistance(flat, lifted, 1e-6);
  EXPECT_LE(distance.Least, 0.25);
  EXPECT_GE(distance.Largest, 0.25);
  EXPECT_LE(distance.Largest - distance.Least, 2e-6);
}

TEST(ReportCgal, CertifiedErrorsAndWorstPlacesAreOnTheRightSideOfIt)
{
  // Where nearly all places are equally far, as on a cylinder, CGAL's search takes minutes.
  int compared = 0;
  double least = 1.0;
  for (const char* name : { "Double", "Spikes", "Moebius", "Klein", "WavedComb", "Fan", "TJunctions", "Stretched1e3" })
  {
    const auto input = MTStiffCases::FindCase(name)->Make(320);
    vtkMTPatchStore store;
    std::string error;
    ASSERT_TRUE(MTStiffStudy::Build(input, {}, store, error)) << error;
    const MTStiffLevels levels(input, store, 60, true);
    for (std::uint32_t level = 1; level < store.GetGraph().GetNumberOfLevels(); ++level)
    {
      const MTStiffStudy::Level measured = levels.Measure(level, 0);
      const double found = levels.ToLocal(measured.Found);
      const double certified = levels.ToLocal(measured.Certified);
      const double bound = std::max(1e-6, 0.01 * found);
      const auto distance = MTReportCgal::GetSymmetricDistance(levels.GetInput(), levels.GetSurface(level), bound);
      std::printf("%s, level %d: found %.6f, CGAL %.6f to %.6f, certified %.6f\n", name, static_cast<int>(level), found,
        distance.Least, distance.Largest, certified);
      EXPECT_LE(distance.Least, certified);
      EXPECT_LE(found, distance.Largest + 1e-12);
      least = std::min(least, found / distance.Largest);
      ++compared;
    }
  }
  std::printf("%d cuts: the search finds at least %.3f of what CGAL bounds\n", compared, least);
  EXPECT_GT(compared, 20);
  EXPECT_GT(least, 0.9);
}
