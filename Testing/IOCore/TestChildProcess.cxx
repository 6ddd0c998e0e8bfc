// SPDX-License-Identifier: BSD-3-Clause
// Work in a child process: what it reports, how it ends, and that it can be ended.
#include "vtkMTChildProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <thread>

#include <unistd.h>

namespace
{
void Sleep(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

std::vector<std::string> TakeAll(vtkMTChildProcess& child)
{
  std::vector<std::string> lines;
  do
  {
    const std::vector<std::string> more = child.TakeLines();
    lines.insert(lines.end(), more.begin(), more.end());
    Sleep(child.IsRunning() ? 1 : 0);
  } while (child.IsRunning());
  return lines;
}
}

TEST(ChildProcess, ReportsInOrderHoweverMuchThatIs)
{
  vtkMTChildProcess child;
  std::string error;
  int mine = 1;
  ASSERT_TRUE(child.Start(
    [&mine](const vtkMTChildProcess::Report& report)
    {
      mine = 2;
      for (int i = 0; i < 20000; ++i) // far more than a pipe holds
      {
        report("line " + std::to_string(i));
      }
      report("two\nlines");
      return 7;
    },
    error))
    << error;
  EXPECT_FALSE(child.Start([](const vtkMTChildProcess::Report&) { return 0; }, error)) << "one at a time";
  const std::vector<std::string> lines = TakeAll(child);
  ASSERT_EQ(lines.size(), 20001u);
  for (int i = 0; i < 20000; ++i)
  {
    ASSERT_EQ(lines[i], "line " + std::to_string(i));
  }
  EXPECT_EQ(lines.back(), "two lines");
  EXPECT_EQ(child.GetExitCode(), 7);
  EXPECT_EQ(mine, 1) << "it has memory of its own";
  EXPECT_TRUE(child.TakeLines().empty());
}

TEST(ChildProcess, ItsEndIsNotOurs)
{
  vtkMTChildProcess child;
  std::string error;
  ASSERT_TRUE(child.Start([](const vtkMTChildProcess::Report&) -> int { throw std::runtime_error("no"); }, error));
  EXPECT_TRUE(TakeAll(child).empty());
  EXPECT_EQ(child.GetExitCode(), 1);
  ASSERT_TRUE(child.Start(
    [](const vtkMTChildProcess::Report& report) -> int
    {
      report("last");
      std::raise(SIGKILL);
      return 0;
    },
    error));
  EXPECT_EQ(TakeAll(child), std::vector<std::string>{ "last" });
  EXPECT_EQ(child.GetExitCode(), 1000 + SIGKILL);
}

TEST(ChildProcess, EndsWhenItIsAskedToOrIsEnded)
{
  vtkMTChildProcess child;
  std::string error;
  ASSERT_TRUE(child.Start(
    [](const vtkMTChildProcess::Report&)
    {
      while (!vtkMTChildProcess::IsAskedToEnd())
      {
        Sleep(1);
      }
      return 5; // it has cleaned up
    },
    error));
  Sleep(50);
  child.End();
  EXPECT_FALSE(child.IsRunning());
  EXPECT_EQ(child.GetExitCode(), 5);
  EXPECT_FALSE(vtkMTChildProcess::IsAskedToEnd()) << "that was the child";

  ASSERT_TRUE(child.Start(
    [](const vtkMTChildProcess::Report& report)
    {
      report("stubborn");
      for (;;)
      {
        Sleep(1000);
      }
      return 0;
    },
    error));
  while (child.TakeLines().empty())
  {
    Sleep(1);
  }
  child.End(0.05);
  EXPECT_FALSE(child.IsRunning());
  EXPECT_EQ(child.GetExitCode(), 1000 + SIGKILL);
}
