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
#include <ostream>
#include <string>
#include <vector>

namespace MTStiffCases
{
/// At most, or whether; the claims as they are, and what tests assert of a case where that is less.
struct Limits
{
  double Looseness = 5.0;    ///< certified over found, or over ten steps where less was found
  double FlippedShare = 0.0; ///< triangles that face away from the input beside them
  double MadeIntersections = 0.0;
  double RootTriangles = 4.0; ///< of the coarsest cut, in targets of a region
  double FlatError = 0.0;     ///< of what is flat, in steps
  bool KeepsComponents = true;
  bool KeepsEuler = true;

  ///@{
  /// These limits with one of them changed.
  Limits WithFlipped(double share) const;
  Limits WithIntersections(double count) const;
  Limits WithRoot(double targets) const;
  Limits WithFlatError(double steps) const;
  Limits WithLostComponents() const;
  ///@}
};

struct Case
{
  const char* Name; ///< letters and digits, a test's name
  const char* What; ///< for the report
  std::function<MTStiffMeshes::Mesh(int)> Make;
  int Triangles; ///< of the test
  int ReportTriangles;
  Limits Limit;
  int LatticeBits = 24;
  bool IsFlat = false;      ///< its errors are zero, at every level
  int GrowTo = 0;           ///< the report shows its build time against its size, up to that one; 0: it does not
  const char* Refusal = ""; ///< the message with which it is refused; empty: it is built
};

/// What a failed test prints.
inline std::ostream& operator<<(std::ostream& os, const Case& stiff)
{
  return os << stiff.Name;
}

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
/// Of everything that a result has; figures that were not counted are left out.
std::vector<Verdict> GetVerdicts(
  const Case& stiff, const MTStiffStudy::Settings& settings, const MTStiffStudy::Result& result);
}

#endif
