// SPDX-License-Identifier: BSD-3-Clause
// Frames take the time that is asked for, on simulated machines.
#include "vtkMTDrawingRate.h"
#include "vtkMTFrameClock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr double Unhurried = 1e4; // seconds: what an interactor that rests asks for

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// What frames cost.
struct Machine
{
  std::string Name;
  double Fixed = 0.0;    // seconds
  double Each = 1e-7;    // seconds a triangle
  double Power = 1.0;    // of the number of triangles
  double Noise = 0.0;    // standard deviation, of all
  double Outliers = 0.0; // share of the frames that take five times as long
  double Least = 500.0;  // triangles of the coarsest cut
  double Most = 5e6;     // of the finest
  double Grain = 0.0;    // the cut has so many less than it may, at most

  std::mt19937 Random{ 1 };

  double Draw(double triangles)
  {
    std::normal_distribution<double> noise(1.0, this->Noise);
    std::uniform_real_distribution<double> chance;
    const double seconds = this->Fixed + this->Each * std::pow(triangles, this->Power);
    const double factor = chance(this->Random) < this->Outliers ? 5.0 : 1.0;
    return seconds * factor * std::max(noise(this->Random), 0.3);
  }

  double Fit(double limit) const
  {
    const double grains = this->Grain > 0.0 ? std::floor(limit / this->Grain) * this->Grain : limit;
    return std::floor(std::clamp(limit > 0.0 ? grains : this->Most, this->Least, this->Most));
  }
};

// Frames in a row, at a rate.
struct Flight
{
  std::vector<double> Seconds;
  int Changes = 0; // of the limit

  void Draw(vtkMTDrawingRate& rate, Machine& machine, double wanted, int frames)
  {
    std::uint64_t last = 0;
    for (int i = 0; i < frames; ++i)
    {
      const std::uint64_t limit = rate.GetTriangles(wanted);
      this->Changes += i > 0 && limit != last ? 1 : 0;
      last = limit;
      const double triangles = machine.Fit(static_cast<double>(limit));
      this->Seconds.push_back(machine.Draw(triangles));
      rate.AddFrame(static_cast<std::uint64_t>(triangles), this->Seconds.back(), wanted);
    }
  }

  double GetMedianOf(std::size_t first, std::size_t count) const
  {
    const auto begin = this->Seconds.begin() + static_cast<std::ptrdiff_t>(first);
    return GetMedian({ begin, begin + static_cast<std::ptrdiff_t>(count) });
  }
};

std::vector<Machine> GetMachines()
{
  std::vector<Machine> machines;
  const auto add = [&](const char* name, double fixed, double each, double power, double noise, double outliers)
  {
    Machine machine;
    machine.Name = name;
    machine.Fixed = fixed;
    machine.Each = each;
    machine.Power = power;
    machine.Noise = noise;
    machine.Outliers = outliers;
    machine.Most = 1e9;
    machines.push_back(machine);
  };
  add("cost by triangle", 0.0, 2e-7, 1.0, 0.0, 0.0);
  add("fixed part", 0.006, 1e-7, 1.0, 0.0, 0.0);
  add("mostly fixed", 0.012, 1e-8, 1.0, 0.0, 0.0);
  add("noise", 0.004, 1e-7, 1.0, 0.05, 0.0);
  add("noise and outliers", 0.004, 1e-7, 1.0, 0.05, 0.1);
  add("much noise", 0.004, 1e-7, 1.0, 0.12, 0.05);
  add("less than linear", 0.003, 2e-5, 0.6, 0.03, 0.02);
  add("more than linear", 0.003, 2e-9, 1.3, 0.03, 0.02);
  add("fast", 0.002, 4e-9, 1.0, 0.03, 0.02);
  add("slow", 0.004, 3e-6, 1.0, 0.03, 0.02);
  return machines;
}

TEST(DrawingRate, NothingIsKnownBeforeTheFirstFrame)
{
  vtkMTDrawingRate rate;
  EXPECT_EQ(rate.GetTriangles(0.1), 0u);
  EXPECT_EQ(rate.GetRate(), 0.0);
  rate.AddFrame(0, 1.0, 0.1);
  rate.AddFrame(1000, 0.0, 0.1);
  rate.AddFrame(1000, 1.0, 0.0);
  EXPECT_EQ(rate.GetTriangles(0.1), 0u);
  rate.AddFrame(1000, 1.0, 0.1);
  EXPECT_EQ(rate.GetTriangles(0.1), 100u);
  EXPECT_EQ(rate.GetRate(), 1000.0);
}

TEST(DrawingRate, MedianIsWhatIsAsked)
{
  for (const double asked : { 60.0, 30.0, 15.0 })
  {
    for (Machine machine : GetMachines())
    {
      vtkMTDrawingRate rate;
      Flight flight;
      flight.Draw(rate, machine, 1.0 / asked, 40 + 120);
      const double median = 1.0 / flight.GetMedianOf(40, 120);
      std::cout << machine.Name << ": asked " << asked << ", median " << median << ", limits " << flight.Changes + 1
                << "\n";
      EXPECT_NEAR(median, asked, 0.1 * asked) << machine.Name;
    }
  }
}

TEST(DrawingRate, AStillSceneKeepsItsCut)
{
  for (Machine machine : GetMachines())
  {
    vtkMTDrawingRate rate;
    Flight settling;
    settling.Draw(rate, machine, 1.0 / 30.0, 60);
    Flight still;
    still.Draw(rate, machine, 1.0 / 30.0, 1000);
    std::cout << machine.Name << ": " << still.Changes << " other limits in 1000 frames\n";
    EXPECT_LE(still.Changes, 20) << machine.Name;
    if (machine.Noise <= 0.05)
    {
      EXPECT_LE(still.Changes, 3) << machine.Name;
    }
    EXPECT_NEAR(still.GetMedianOf(0, 1000) * 30.0, 1.0, 0.1) << machine.Name;
  }
}

TEST(DrawingRate, AHeavierSceneIsAnsweredInAFewFrames)
{
  for (const double factor : { 0.25, 0.5, 2.0, 4.0 })
  {
    Machine machine;
    machine.Fixed = 0.004;
    machine.Each = 1e-7;
    machine.Noise = 0.03;
    vtkMTDrawingRate rate;
    Flight flight;
    flight.Draw(rate, machine, 1.0 / 30.0, 60);
    machine.Each *= factor;
    Flight after;
    after.Draw(rate, machine, 1.0 / 30.0, 60);
    const double soon = after.GetMedianOf(16, 8) * 30.0;
    std::cout << factor << " times the cost: " << soon << " of the time after 16 frames\n";
    EXPECT_NEAR(soon, 1.0, 0.15);
    EXPECT_NEAR(after.GetMedianOf(20, 40) * 30.0, 1.0, 0.1);
  }
}

TEST(DrawingRate, OneSlowFrameChangesNothing)
{
  Machine machine;
  machine.Fixed = 0.004;
  vtkMTDrawingRate rate;
  Flight flight;
  flight.Draw(rate, machine, 1.0 / 30.0, 60);
  const std::uint64_t limit = rate.GetTriangles(1.0 / 30.0);
  rate.AddFrame(limit, 2.0, 1.0 / 30.0);
  EXPECT_EQ(rate.GetTriangles(1.0 / 30.0), limit);
  flight.Draw(rate, machine, 1.0 / 30.0, 5);
  EXPECT_EQ(rate.GetTriangles(1.0 / 30.0), limit);
}

TEST(DrawingRate, RecoversFromASceneThatIsTooSlowAtItsCoarsest)
{
  Machine machine;
  machine.Fixed = 0.1;
  vtkMTDrawingRate rate;
  Flight slow;
  slow.Draw(rate, machine, 1.0 / 30.0, 60);
  EXPECT_LE(rate.GetTriangles(1.0 / 30.0), 500u);
  machine.Fixed = 0.004;
  Flight flight;
  flight.Draw(rate, machine, 1.0 / 30.0, 120);
  EXPECT_NEAR(flight.GetMedianOf(60, 60) * 30.0, 1.0, 0.1);
}

TEST(DrawingRate, CoarseGrainsGiveNoOscillation)
{
  for (const double grain : { 0.1, 0.3, 0.45 })
  {
    Machine machine;
    machine.Fixed = 0.004;
    machine.Grain = grain * 0.029 / machine.Each;
    machine.Noise = 0.02;
    vtkMTDrawingRate rate;
    Flight settling;
    settling.Draw(rate, machine, 1.0 / 30.0, 100);
    const double triangles = machine.Fit(static_cast<double>(rate.GetTriangles(1.0 / 30.0)));
    int other = 0;
    for (int i = 0; i < 300; ++i)
    {
      Flight still;
      still.Draw(rate, machine, 1.0 / 30.0, 1);
      other += machine.Fit(static_cast<double>(rate.GetTriangles(1.0 / 30.0))) != triangles ? 1 : 0;
    }
    std::cout << grain << ": " << triangles * machine.Each + machine.Fixed << " s, other cuts in " << other
              << " of 300 frames\n";
    EXPECT_EQ(other, 0);
  }
}

TEST(DrawingRate, RestingFramesDoNotCountWhereOthersDo)
{
  Machine machine;
  machine.Fixed = 0.004;
  vtkMTDrawingRate rate;
  Flight flight;
  flight.Draw(rate, machine, 1.0 / 30.0, 60);
  const std::uint64_t limit = rate.GetTriangles(1.0 / 30.0);
  EXPECT_GT(rate.GetTriangles(Unhurried), 1000000u);
  for (int i = 0; i < 20; ++i)
  {
    rate.AddFrame(2000000, 5.0, Unhurried); // waited for patches
  }
  EXPECT_EQ(rate.GetTriangles(1.0 / 30.0), limit);
}

TEST(DrawingRate, RestingFramesAreAFirstGuess)
{
  Machine machine;
  machine.Fixed = 0.004;
  vtkMTDrawingRate rate;
  for (int i = 0; i < 3; ++i)
  {
    rate.AddFrame(2000000, machine.Draw(2e6), Unhurried);
  }
  Flight flight;
  flight.Draw(rate, machine, 1.0 / 30.0, 40);
  EXPECT_NEAR(flight.Seconds.front() * 30.0, 1.0, 0.2);
  EXPECT_NEAR(flight.GetMedianOf(10, 30) * 30.0, 1.0, 0.1);
}

TEST(DrawingRate, AnotherRateIsMetAtOnceByWhatIsKnown)
{
  Machine machine;
  machine.Fixed = 0.004;
  vtkMTDrawingRate rate;
  Flight flight;
  flight.Draw(rate, machine, 1.0 / 30.0, 60);
  Flight other;
  other.Draw(rate, machine, 1.0 / 15.0, 4);
  EXPECT_NEAR(other.Seconds.back() * 15.0, 1.0, 0.1);
}

TEST(DrawingRate, SameFramesGiveSameLimits)
{
  std::vector<std::uint64_t> limits[2];
  for (std::vector<std::uint64_t>& list : limits)
  {
    Machine machine = GetMachines()[5];
    vtkMTDrawingRate rate;
    for (int i = 0; i < 200; ++i)
    {
      list.push_back(rate.GetTriangles(0.03));
      const double triangles = machine.Fit(static_cast<double>(list.back()));
      rate.AddFrame(static_cast<std::uint64_t>(triangles), machine.Draw(triangles), 0.03);
    }
  }
  EXPECT_EQ(limits[0], limits[1]);
}
}
