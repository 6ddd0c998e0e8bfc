// SPDX-License-Identifier: BSD-3-Clause
// Certified errors beside a second oracle: CGAL's bounded-error Hausdorff distance, which shares nothing with ours.
#include "MTReportStiff.h"

#include "MTReportCgal.h"
#include "MTReportContext.h"
#include "MTReportPage.h"

#include "MTStiffCases.h"
#include "MTStiffLevels.h"

#include "vtkMTPatchStore.h"

#include <algorithm>
#include <string>

namespace
{
constexpr double Share = 0.01; // of what was found: how far apart CGAL's bounds may be

struct Counts
{
  int Cuts = 0;
  int Refuted = 0; // certified errors that are smaller than CGAL's lower bound
  int Beyond = 0;  // places that are farther than CGAL's upper bound
  double LeastFound = 1.0;
};

void AddCase(const MTStiffCases::Case& stiff, int triangles, MTReportTable& table, Counts& counts)
{
  const auto input = stiff.Make(triangles);
  vtkMTPatchStore store;
  std::string error;
  if (!MTStiffStudy::Build(input, MTStiffCases::GetSettings(stiff), store, error))
  {
    return;
  }
  const MTStiffLevels levels(input, store, 60, true);
  for (std::uint32_t level = 1; level < store.GetGraph().GetNumberOfLevels(); ++level)
  {
    const MTStiffStudy::Level measured = levels.Measure(level, 0);
    const double found = levels.ToLocal(measured.Found);
    const double certified = levels.ToLocal(measured.Certified);
    if (found <= 1e-6)
    {
      continue; // of the frame's size: CGAL's bounds would be as far apart as that
    }
    const auto distance =
      MTReportCgal::GetSymmetricDistance(levels.GetInput(), levels.GetSurface(level), Share * found);
    ++counts.Cuts;
    counts.Refuted += certified < distance.Least ? 1 : 0;
    counts.Beyond += found > distance.Largest * (1.0 + 1e-12) ? 1 : 0;
    counts.LeastFound = std::min(counts.LeastFound, found / distance.Largest);
    table.AddRow({ stiff.Name, level, measured.Triangles, 100.0 * found, 100.0 * distance.Least,
      100.0 * distance.Largest, 100.0 * certified, certified / distance.Least });
  }
}
}

//------------------------------------------------------------------------------
void MTReportStiffOracle(MTReportContext& context, MTReportSection& section)
{
  MTReportTable table("stiff_oracle",
    "Small cuts: the worst place found, CGAL's bounds of the distance, the certified error",
    { { "case", "" }, { "level", "" }, { "triangles", "" }, { "found", "% of the frame" },
      { "CGAL, at least", "% of the frame" }, { "CGAL, at most", "% of the frame" }, { "certified", "% of the frame" },
      { "certified over CGAL's", "" } });
  Counts counts;
  for (const char* name : { "Double", "Spikes", "Moebius", "Klein", "RoughComb", "WavedComb", "Fan", "TwoFans",
         "TJunctions", "Checkerboard", "Stretched1e3", "Graded" })
  {
    context.Say(std::string("CGAL: ") + name);
    AddCase(*MTStiffCases::FindCase(name), context.IsQuick() ? 320 : 1280, table, counts);
  }
  section.AddTable(table);
  const std::string cuts = std::to_string(counts.Cuts) + " cuts";
  section.AddClaim("CGAL's lower bound of the distance is nowhere above the certified error",
    std::to_string(counts.Refuted) + " of " + cuts, counts.Refuted == 0);
  section.AddClaim("No place that was found is farther than CGAL's upper bound",
    std::to_string(counts.Beyond) + " of " + cuts, counts.Beyond == 0);
  section.AddClaim("The search finds nine tenths of CGAL's upper bound or more",
    "at least " + MTReportTable::Shorten(counts.LeastFound), counts.LeastFound >= 0.9);
}
