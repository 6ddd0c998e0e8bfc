// SPDX-License-Identifier: BSD-3-Clause
// Stiff cases that grow, and those that become stiffer: build time against size, looseness and error against stiffness.
#include "MTReportStiff.h"

#include "MTReportContext.h"
#include "MTReportPage.h"
#include "MTReportTimes.h"

#include "MTStiffCases.h"

#include "vtkMTPatchStore.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

// CPU seconds; a mesh whose build would take longer, as the last two grew, is not built.
double GetLongestBuild(const MTReportContext& context)
{
  return context.IsQuick() ? 0.5 : 60.0;
}

double GuessNext(const std::vector<double>& seconds)
{
  const std::size_t n = seconds.size();
  return n == 0 ? 0.0 : seconds[n - 1] * (n == 1 ? 2.0 : std::fmax(2.0, seconds[n - 1] / seconds[n - 2]));
}

// Median CPU seconds of a build with default settings.
double TimeBuild(const MTStiffCases::Case& stiff, int triangles, int repeats)
{
  const auto input = stiff.Make(triangles);
  MTStiffStudy::Settings settings;
  settings.PatchTriangles = 1000;
  MTReportTimes times;
  std::string error;
  for (int i = 0; i < repeats && (i == 0 || times.GetLargest() < 5.0); ++i)
  {
    vtkMTPatchStore store;
    times.Measure([&] { MTStiffStudy::Build(input, settings, store, error); });
  }
  return times.GetMedian();
}

void AddGrowth(MTReportContext& context, MTReportSection& section)
{
  const MTReportTable::Kind time = MTReportTable::Kind::Time;
  MTReportTable table("stiff_growth", "Build time against size, patches of 1000, and log2 of the ratio of neighbours",
    { { "case", "" }, { "largest, 8n", "triangles" }, { "n", "CPU s", time }, { "2n", "CPU s", time },
      { "4n", "CPU s", time }, { "8n", "CPU s", time }, { "2n : n", "exponent", time }, { "4n : 2n", "exponent", time },
      { "8n : 4n", "exponent", time } });
  MTReportChart chart(
    "stiff_growth", "Build time of stiff cases against size", { "triangles", true }, { "CPU seconds", true });
  double largest = 0.0;
  std::string worst;
  for (const MTStiffCases::Case& stiff : MTStiffCases::GetCases())
  {
    const int triangles = context.IsQuick() ? stiff.GrowTo / 10 : stiff.GrowTo;
    if (triangles <= 0)
    {
      continue;
    }
    context.Say(std::string("growing ") + stiff.Name);
    std::vector<double> seconds;
    for (int divisor = 8; divisor >= 1; divisor /= 2)
    {
      const bool isTooLong = !(GuessNext(seconds) < GetLongestBuild(context));
      seconds.push_back(isTooLong ? NotMeasured : TimeBuild(stiff, triangles / divisor, context.IsQuick() ? 1 : 3));
      chart.AddPoint(stiff.Name, triangles / divisor, seconds.back());
    }
    std::vector<MTReportTable::Cell> row{ stiff.Name, triangles };
    row.insert(row.end(), seconds.begin(), seconds.end());
    for (int i = 0; i < 3; ++i)
    {
      row.emplace_back(std::log2(seconds[i + 1] / seconds[i]));
    }
    table.AddRow(row);
    // Where it grows most; the smallest one's time is mostly overhead.
    double exponent = 0.0;
    for (int i = 1; i < 3; ++i)
    {
      exponent = std::fmax(exponent, std::log2(seconds[i + 1] / seconds[i]));
    }
    worst = exponent > largest ? stiff.Name : worst;
    largest = exponent > largest ? exponent : largest;
  }
  section.AddTable(table);
  section.AddChart(chart);
  section.AddKnownClaim("Build time grows with an exponent of less than 1.5 in every growing case",
    "largest exponent " + MTReportTable::Shorten(largest) + " (" + worst + ")", largest < 1.5,
    "Direct bounds (DirectLevels) of triangles that all pass one place take most of it: with sums of steps, "
    "DirectLevels 1, the same meshes take a fraction of the time.");
}

// A family of meshes that become stiffer.
struct Family
{
  const char* Name;
  const char* Title;
  const char* Parameter;
  std::vector<double> Values;
  std::vector<const char*> Lines;
  std::function<MTStiffMeshes::Mesh(std::size_t line, double value)> Make;
};

void AddFamily(MTReportContext& context, const Family& family, MTReportSection& section)
{
  context.Say(std::string("curve ") + family.Name);
  MTReportTable table(family.Name, family.Title,
    { { "mesh", "" }, { family.Parameter, "" }, { "triangles", "" }, { "certified over worst place", "" },
      { "worst place at half the triangles", "% of diagonal" }, { "worst place at an eighth", "% of diagonal" },
      { "build", "CPU s", MTReportTable::Kind::Time } });
  MTReportChart looseness(std::string(family.Name) + "_looseness", std::string(family.Title) + ": looseness",
    { family.Parameter, true }, { "certified over worst place, largest of all levels", true });
  MTReportChart error(std::string(family.Name) + "_error", std::string(family.Title) + ": error",
    { family.Parameter, true }, { "worst place at half the triangles, % of the diagonal", true });
  for (std::size_t line = 0; line < family.Lines.size(); ++line)
  {
    for (const double value : family.Values)
    {
      MTStiffStudy::Settings settings;
      settings.IsVerified = false;
      settings.Pairs = 0;
      const MTStiffStudy::Result result = MTStiffStudy::Run(family.Make(line, value), settings);
      const auto getShare = [&](std::size_t level)
      { return level < result.Levels.size() ? 100.0 * result.Levels[level].Found / result.Diagonal : NotMeasured; };
      const double loose = result.GetLooseness() > 0.0 ? result.GetLooseness() : NotMeasured;
      table.AddRow(
        { family.Lines[line], value, result.InputTriangles, loose, getShare(1), getShare(3), result.CpuSeconds });
      looseness.AddPoint(family.Lines[line], value, loose);
      error.AddPoint(family.Lines[line], value, getShare(1));
    }
  }
  section.AddTable(table);
  section.AddChart(looseness);
  section.AddChart(error);
}

std::vector<double> GetPowers(double base, int first, int last)
{
  std::vector<double> powers;
  for (int i = first; i <= last; ++i)
  {
    powers.push_back(std::pow(base, i));
  }
  return powers;
}
}

//------------------------------------------------------------------------------
void MTReportStiffCurves(MTReportContext& context, MTReportSection& section)
{
  using namespace MTStiffMeshes;
  const bool isQuick = context.IsQuick();
  AddGrowth(context, section);
  AddFamily(context,
    { "stiff_anisotropy", "Surfaces stretched along one axis", "anisotropy", GetPowers(10.0, 0, isQuick ? 7 : 12),
      { "bumpy sphere", "relief" },
      [isQuick](std::size_t line, double value)
      {
        const int triangles = isQuick ? 1280 : 5120;
        return Scale(line == 0 ? BumpySphere(triangles) : Relief(triangles, 0.1), value, 1.0, 1.0);
      } },
    section);
  AddFamily(context,
    { "stiff_teeth", "Combs of thin teeth, 100 triangles each", "teeth", GetPowers(2.0, 2, isQuick ? 4 : 6),
      { "rough", "waved" },
      [](std::size_t line, double value)
      {
        const int teeth = static_cast<int>(value);
        return line == 0 ? RoughComb(100 * teeth, teeth) : WavedComb(100 * teeth, teeth);
      } },
    section);
  AddFamily(context,
    { "stiff_fans", "Fans about one vertex", "triangles", GetPowers(2.0, 8, isQuick ? 11 : 14),
      { "fan", "two fans", "spindle" },
      [](std::size_t line, double value)
      {
        const int triangles = static_cast<int>(value);
        return line == 0 ? Fan(triangles) : line == 1 ? TwoFans(triangles) : Spindle(triangles);
      } },
    section);
}
