// SPDX-License-Identifier: BSD-3-Clause
/**
 * The table of stiff and extreme cases that tests and report go through. What holds for all of them is asserted for all
 * of them: they build, verify, no certified error is violated, every number is finite. The rest is a figure with a
 * claim, which is the same for every case (Claims), and what holds today (Limits), which tests assert; where a limit is
 * wider than the claim the report says that the claim does not hold.
 */
#ifndef MTStiffCases_h
#define MTStiffCases_h

#include "MTStiffMeshes.h"
#include "MTStiffStudy.h"

#include <functional>
#include <string>
#include <vector>

namespace MTStiffCases
{
/// The least that is claimed; NoLimit: nothing is.
struct Limits
{
  double Looseness = 5.0;    ///< certified over found, where more than ten steps were found
  double FlippedShare = 0.0; ///< triangles that face away from the input beside them
  double MadeIntersections = 0.0;
  bool KeepsComponents = true;
  bool KeepsEuler = true;
  double RootTriangles = 4.0; ///< of the coarsest cut, in targets of a region
  double Motion = 2.0;        ///< ratio of median errors after a rigid motion
};
constexpr double NoLimit = 1e300;
const Limits Claims;

struct Case
{
  const char* Name; ///< letters and digits, a test's name
  const char* What; ///< for the report
  std::function<MTStiffMeshes::Mesh(int)> Make;
  int Triangles; ///< of the test
  int ReportTriangles;
  Limits Limit;
  int LatticeBits = 24;
  bool IsFlat = false; ///< its errors are zero, at every level
  bool Grows = false;  ///< the report shows its build time against its size
};

const std::vector<Case>& GetCases();
/// Null when there is none.
const Case* FindCase(const std::string& name);

/// What a settings' region of the coarsest cut is wanted to have.
double GetRegionTarget(const MTStiffStudy::Settings& settings);
/// Those of a case, for a mesh of its test.
MTStiffStudy::Settings GetSettings(const Case& stiff);

/// A claim beside its figure.
struct Verdict
{
  std::string Claim;
  double Figure = 0.0;
  double Claimed = 0.0; ///< the figure is at most that
  double Limit = 0.0;   ///< what tests assert: at most that
  bool Holds() const { return this->Figure <= this->Claimed; }
};
/// Of everything but the motion; figures that were not counted are left out.
std::vector<Verdict> GetVerdicts(
  const Case& stiff, const MTStiffStudy::Settings& settings, const MTStiffStudy::Result& result);
}

#endif
