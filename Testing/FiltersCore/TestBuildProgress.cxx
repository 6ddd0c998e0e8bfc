// SPDX-License-Identifier: BSD-3-Clause
// The progress of a build: one fraction that never falls, made of the shares that the builder gives its steps.
#include "vtkMTBuildProgress.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
vtkMTBuildProgress MakeProgress()
{
  return vtkMTBuildProgress({ { "reading", 0.0 }, { "sorting", 0.1 } }, 0.4);
}

double GetFractionOf(const vtkMTWorkSettings::ProgressReport& report)
{
  vtkMTBuildProgress progress = MakeProgress();
  progress.Update(report);
  return progress.GetFraction();
}
}

TEST(BuildProgress, StepsOfTheInputHaveTheSharesThatTheCallerGave)
{
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "reading", 0, 0, 100 }), 0.0);
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "reading", 0, 50, 100 }), 0.05);
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "reading", 0, 500, 100 }), 0.1) << "more than expected";
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "sorting", 0, 50, 100 }), 0.25);
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "sorting", 0, 50, 0 }), 0.1) << "not known how much is expected";
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "something else", 0, 50, 100 }), 0.0);
}

TEST(BuildProgress, LevelsHaveTheRest)
{
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.0, "simplifying", 1, 0, 0 }), 0.4);
  EXPECT_DOUBLE_EQ(GetFractionOf({ 0.5, "simplifying", 3, 0, 0 }), 0.7);
  EXPECT_DOUBLE_EQ(GetFractionOf({ 1.0, "reading", 1, 0, 100 }), 1.0)
    << "a step's name is of the input at level 0 only";
  EXPECT_DOUBLE_EQ(GetFractionOf({ 1.5, "simplifying", 9, 0, 0 }), 1.0);
}

TEST(BuildProgress, FractionNeverFalls)
{
  vtkMTBuildProgress progress = MakeProgress();
  double last = 0.0;
  const vtkMTWorkSettings::ProgressReport reports[] = { { 0.0, "reading", 0, 90, 100 }, { 0.0, "reading", 0, 10, 100 },
    { 0.0, "sorting", 0, 1, 2 }, { 0.6, "simplifying", 1, 5, 9 }, { 0.1, "simplifying", 2, 1, 9 },
    { 0.0, "reading", 0, 1, 9 }, { 1.0, "simplifying", 2, 9, 9 } };
  for (const auto& report : reports)
  {
    progress.Update(report);
    std::printf("%-34s %.3f\n", progress.GetText().c_str(), progress.GetFraction());
    EXPECT_GE(progress.GetFraction(), last);
    last = progress.GetFraction();
  }
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(BuildProgress, TextSaysLevelStepAndHowMuchIsDone)
{
  vtkMTBuildProgress progress = MakeProgress();
  progress.Update({ 0.0, "reading", 0, 0, 100 });
  EXPECT_EQ(progress.GetText(), "level 0, reading");
  progress.Update({ 0.0, "sorting", 0, 7, 0 });
  EXPECT_EQ(progress.GetText(), "level 0, sorting: 7");
  progress.Update({ 0.2, "simplifying", 3, 20, 50 });
  EXPECT_EQ(progress.GetText(), "level 3, simplifying: 20 of 50");
}
