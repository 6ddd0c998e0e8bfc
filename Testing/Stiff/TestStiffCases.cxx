// SPDX-License-Identifier: BSD-3-Clause
// Every stiff and extreme case, one test each.
#include "MTStiffCases.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
class StiffCase : public testing::TestWithParam<MTStiffCases::Case>
{
};

void Print(const MTStiffStudy::Result& result)
{
  std::printf("%d triangles, step %g, diagonal %g, built in %.3f s\n", static_cast<int>(result.InputTriangles),
    result.Step, result.Diagonal, result.CpuSeconds);
  std::printf("level triangles certified, its own, found ratio | patch cut | flipped components Euler crossings\n");
  for (std::size_t i = 0; i < result.Levels.size(); ++i)
  {
    const MTStiffStudy::Level& level = result.Levels[i];
    std::printf("%d %d %g %g %g %.2f | %.3f %.3f | %d %d %d %d\n", static_cast<int>(i),
      static_cast<int>(level.Triangles), level.Certified, level.OwnDistance, level.Found,
      level.Found > 0.0 ? level.Certified / level.Found : 0.0, level.ViolatedPatch, level.ViolatedCut,
      static_cast<int>(level.Flipped), static_cast<int>(level.Topology.Components),
      static_cast<int>(level.Topology.Euler), static_cast<int>(level.Topology.Intersections));
  }
}
}

TEST_P(StiffCase, BuildsVerifiesAndStaysWithinItsCertifiedErrors)
{
  const MTStiffCases::Case& stiff = GetParam();
  const MTStiffStudy::Settings settings = MTStiffCases::GetSettings(stiff);
  const MTStiffStudy::Result result = MTStiffStudy::Run(stiff.Make(stiff.Triangles), settings);
  std::printf("%s\n", stiff.What);
  Print(result);
  EXPECT_EQ(result.Error, stiff.Refusal);
  EXPECT_EQ(result.Violation, "");
  for (const MTStiffCases::Verdict& verdict : MTStiffCases::GetVerdicts(stiff, settings, result))
  {
    std::printf("%s: %g (%s)\n", verdict.Claim.c_str(), verdict.Figure, verdict.Holds() ? "holds" : "does not hold");
    EXPECT_LE(verdict.Figure, verdict.Limit) << verdict.Claim;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, StiffCase, testing::ValuesIn(MTStiffCases::GetCases()),
  [](const testing::TestParamInfo<MTStiffCases::Case>& info) { return std::string(info.param.Name); });
