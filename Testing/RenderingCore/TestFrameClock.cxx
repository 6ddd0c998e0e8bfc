// SPDX-License-Identifier: BSD-3-Clause
// The models in a window share the time of its frames with everything else there, on a simulated machine.
#include "vtkMTFrameClock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <vector>

namespace
{
constexpr double Wanted = 1.0 / 30.0;

struct Actor
{
  double Share = 0.0;     // of the frame's time
  double Each = 1e-7;     // seconds a triangle
  std::uint64_t Most = 0; // triangles that it draws without a limit
  std::uint64_t Drawn = 0;
};

// Draws with a clock of its own.
struct Window
{
  vtkMTFrameClock Clock;
  double Time = 100.0;
  double Other = 0.003; // seconds of a frame that are no model's

  double Draw(std::vector<Actor>& actors, double wanted = Wanted)
  {
    this->Clock.Begin(this->Time);
    for (Actor& actor : actors)
    {
      const std::uint64_t limit = this->Clock.Allow(actor.Share, wanted);
      actor.Drawn = limit > 0 ? std::min(limit, actor.Most) : actor.Most;
      this->Time += actor.Each * static_cast<double>(actor.Drawn);
      this->Clock.Draw(actor.Share, actor.Drawn, actor.Drawn < actor.Most);
    }
    this->Time += this->Other;
    const vtkMTFrameClock::Frame frame = this->Clock.End(this->Time);
    this->Clock.Learn(frame);
    this->Time += 0.5; // between frames
    return frame.Seconds;
  }

  double DrawSome(std::vector<Actor>& actors, int frames)
  {
    std::vector<double> seconds;
    for (int i = 0; i < frames; ++i)
    {
      seconds.push_back(this->Draw(actors));
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
  }
};

TEST(FrameClock, WholeFrameTakesTheTimeWhateverElseIsDrawn)
{
  for (const double other : { 0.0, 0.005, 0.02 })
  {
    Window window;
    window.Other = other;
    // The others have the larger part of the time that VTK divides.
    std::vector<Actor> actors{ { 0.3, 1e-7, 10000000 } };
    window.DrawSome(actors, 40);
    const double seconds = window.DrawSome(actors, 60);
    std::cout << other << " s for others: frames of " << seconds << " s, " << actors[0].Drawn << " triangles\n";
    EXPECT_NEAR(seconds, Wanted, 0.1 * Wanted);
  }
}

TEST(FrameClock, ActorsShareTheFrameByTheirParts)
{
  Window window;
  std::vector<Actor> actors{ { 0.2, 1e-7, 10000000 }, { 0.6, 1e-7, 10000000 } };
  window.DrawSome(actors, 40);
  const double seconds = window.DrawSome(actors, 60);
  std::cout << actors[0].Drawn << " and " << actors[1].Drawn << " triangles, " << seconds << " s\n";
  EXPECT_NEAR(seconds, Wanted, 0.1 * Wanted);
  EXPECT_NEAR(static_cast<double>(actors[1].Drawn) / static_cast<double>(actors[0].Drawn), 3.0, 0.01);
}

TEST(FrameClock, WhatOneActorLeavesTheOthersHave)
{
  Window window;
  std::vector<Actor> actors{ { 0.5, 1e-7, 20000 }, { 0.25, 1e-7, 10000000 }, { 0.25, 3e-7, 10000000 } };
  window.DrawSome(actors, 40);
  const double seconds = window.DrawSome(actors, 60);
  std::cout << actors[0].Drawn << ", " << actors[1].Drawn << " and " << actors[2].Drawn << " triangles, " << seconds
            << " s\n";
  EXPECT_NEAR(seconds, Wanted, 0.1 * Wanted);
  EXPECT_EQ(actors[0].Drawn, 20000u);
  EXPECT_EQ(actors[1].Drawn, actors[2].Drawn);
  // It wants more again.
  actors[0].Most = 10000000;
  window.DrawSome(actors, 40);
  EXPECT_NEAR(window.DrawSome(actors, 60), Wanted, 0.1 * Wanted);
  EXPECT_NEAR(static_cast<double>(actors[0].Drawn) / static_cast<double>(actors[1].Drawn), 2.0, 0.01);
}

TEST(FrameClock, AnActorThatComesHasItsShareAtOnceAndTheOthersInTheNextFrame)
{
  Window window;
  std::vector<Actor> actors{ { 1.0, 1e-7, 10000000 } };
  window.DrawSome(actors, 60);
  const std::uint64_t all = actors[0].Drawn;
  actors[0].Share = 0.5;
  actors.push_back({ 0.5, 1e-7, 10000000, 0 });
  window.Draw(actors);
  window.Draw(actors);
  EXPECT_LE(actors[0].Drawn + actors[1].Drawn, all + 1);
  EXPECT_EQ(actors[0].Drawn, actors[1].Drawn);
}

TEST(FrameClock, AnotherRateLeavesTheSharesAsTheyAre)
{
  Window window;
  std::vector<Actor> actors{ { 1.0, 1e-7, 10000000 } };
  for (int i = 0; i < 3; ++i)
  {
    window.Draw(actors, 1e4); // what an interactor that rests asks for
  }
  EXPECT_NEAR(window.Draw(actors), Wanted, 0.1 * Wanted);
}

TEST(FrameClock, FramesUnlikeOthersAreNotLearntFrom)
{
  Window window;
  std::vector<Actor> actors{ { 1.0, 1e-7, 10000000 } };
  window.DrawSome(actors, 60);
  const std::uint64_t limit = actors[0].Drawn;
  for (int i = 0; i < 10; ++i)
  {
    window.Clock.Begin(window.Time);
    window.Clock.Allow(1.0, Wanted);
    window.Clock.Draw(1.0, limit, true);
    window.Clock.Discard();
    const vtkMTFrameClock::Frame frame = window.Clock.End(window.Time + 3.0);
    EXPECT_FALSE(frame.Counts);
    window.Clock.Learn(frame);
  }
  window.Clock.Begin(window.Time);
  EXPECT_FALSE(window.Clock.End(window.Time + 3.0).Counts); // nothing was drawn
  window.Draw(actors);
  EXPECT_EQ(actors[0].Drawn, limit);
  EXPECT_FALSE(window.Clock.End(window.Time).Counts); // no frame began
}
}
