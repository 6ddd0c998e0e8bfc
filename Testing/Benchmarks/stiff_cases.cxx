// SPDX-License-Identifier: BSD-3-Clause
// stiff_cases [--triangles N] [--patch N] [--direct N] [--levels] [--build] [NAME...]: the figures of stiff and extreme
// cases (MTStiffCases.h), of all of them or those named, at the report's sizes or at one that is given. A row for each
// case; with --levels, one for each level as well; with --build models are built only.
#include "MTStiffCases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace
{
void PrintLevels(const MTStiffStudy::Result& result)
{
  for (std::size_t i = 0; i < result.Levels.size(); ++i)
  {
    const MTStiffStudy::Level& level = result.Levels[i];
    std::printf(
      "  level %zu: %lld triangles, certified %g, found %g (of the diagonal %.2g, of the bound %.3f), flipped %lld, "
      "components %lld, Euler %lld, intersections %lld\n",
      i, static_cast<long long>(level.Triangles), level.Certified, level.Found, level.Found / result.Diagonal,
      level.Certified > 0.0 ? level.Found / level.Certified : 0.0, static_cast<long long>(level.Flipped),
      static_cast<long long>(level.Topology.Components), static_cast<long long>(level.Topology.Euler),
      static_cast<long long>(level.Topology.Intersections));
  }
}
}

int main(int argc, char** argv)
{
  int triangles = -1;
  MTStiffStudy::Settings given;
  given.PatchTriangles = 250;
  bool showsLevels = false;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    if (!std::strcmp(argv[i], "--levels"))
    {
      showsLevels = true;
    }
    else if (!std::strcmp(argv[i], "--build"))
    {
      given.IsVerified = false;
      given.SearchTriangles = 0;
    }
    else if (i + 1 < argc && !std::strncmp(argv[i], "--", 2))
    {
      (argv[i][2] == 't'      ? triangles
          : argv[i][2] == 'p' ? given.PatchTriangles
                              : given.DirectLevels) = std::atoi(argv[i + 1]);
      ++i;
    }
    else if (MTStiffCases::FindCase(argv[i]))
    {
      names.emplace_back(argv[i]);
    }
    else
    {
      std::fprintf(
        stderr, "usage: stiff_cases [--triangles N] [--patch N] [--direct N] [--levels] [--build] [NAME...]\n");
      return 2;
    }
  }
  for (const MTStiffCases::Case& stiff : MTStiffCases::GetCases())
  {
    if (!names.empty() && std::find(names.begin(), names.end(), stiff.Name) == names.end())
    {
      continue;
    }
    MTStiffStudy::Settings settings = given;
    settings.LatticeBits = stiff.LatticeBits;
    const auto result = MTStiffStudy::Run(stiff.Make(triangles < 0 ? stiff.ReportTriangles : triangles), settings);
    std::printf("%s: %lld triangles, %.3f CPU s, coarsest %.3g of the diagonal off", stiff.Name,
      static_cast<long long>(result.InputTriangles), result.CpuSeconds, result.GetCoarsestShare());
    for (const MTStiffCases::Verdict& verdict : MTStiffCases::GetVerdicts(stiff, settings, result))
    {
      std::printf("; %s %s%.4g", verdict.Claim.c_str(), verdict.Holds() ? "" : "!", verdict.Figure);
    }
    std::printf("\n");
    if (showsLevels)
    {
      PrintLevels(result);
    }
    std::fflush(stdout);
  }
  return 0;
}
