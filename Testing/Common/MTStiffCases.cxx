// SPDX-License-Identifier: BSD-3-Clause
#include "MTStiffCases.h"

#include "vtkMTBuildSettings.h"

#include <algorithm>

namespace MTStiffCases
{
namespace
{
using namespace MTStiffMeshes;

std::function<Mesh(int)> MakeScaled(double scale, int type = VTK_DOUBLE)
{
  return [=](int n) { return Scale(BumpySphere(n, type), scale, scale, scale); };
}

std::function<Mesh(int)> MakeStretched(double factor)
{
  return [=](int n) { return Scale(BumpySphere(n), factor, 1.0, 1.0); };
}

std::function<Mesh(int)> MakeTurned(Mesh (*make)(int))
{
  return [=](int n) { return TurnAndMove(make(n), 0.7, { 0.3, -0.2, 0.1 }); };
}

void AddScales(std::vector<Case>& cases)
{
  cases.push_back(
    { "Float", "single precision input", [](int n) { return BumpySphere(n, VTK_FLOAT); }, 1280, 20480, {} });
  cases.push_back({ "Double", "double precision input", [](int n) { return BumpySphere(n); }, 1280, 20480, {} });
  cases.push_back({ "Scale1em300", "scale 1e-300", MakeScaled(1e-300), 1280, 5120, {} });
  cases.push_back({ "Scale1em38Float", "scale 1e-38, single precision", MakeScaled(1e-38, VTK_FLOAT), 1280, 5120, {} });
  cases.push_back({ "Scale1e38Float", "scale 1e38, single precision", MakeScaled(1e38, VTK_FLOAT), 1280, 5120, {} });
  cases.push_back({ "Scale1e60", "scale 1e60, beyond single precision", MakeScaled(1e60), 1280, 5120, {} });
  cases.push_back({ "Scale1e300", "scale 1e300", MakeScaled(1e300), 1280, 5120, {} });
  cases.push_back({ "Denormals", "scale 1e-310: every coordinate is denormal", MakeScaled(1e-310), 1280, 5120, {} });
  cases.push_back({ "Offset1e6", "relief of 1e-3 at an offset of 1e6",
    [](int n) { return Move(Relief(n, 1e-3), 1e6, -2e6, 1e6); }, 1250, 5000, {} });
  cases.push_back({ "Offset1e9", "relief of 1e-3 at an offset of 1e9",
    [](int n) { return Move(Relief(n, 1e-3), 1e9, -1e9, 1e9); }, 1250, 5000, {} });
}

void AddProportions(std::vector<Case>& cases)
{
  cases.push_back(
    { "Stretched1e3", "a sphere stretched 1e3 times", MakeStretched(1e3), 1280, 5120, Limits().WithFlipped(0.05) });
  cases.push_back({ "Stretched1e6", "a sphere stretched 1e6 times", MakeStretched(1e6), 5120, 5120,
    Limits().WithFlipped(0.06).WithRoot(25) });
  cases.push_back({ "Stretched1e9", "a sphere stretched 1e9 times", MakeStretched(1e9), 1280, 5120, {} });
  cases.push_back({ "Stretched1e12", "a sphere stretched 1e12 times", MakeStretched(1e12), 1280, 5120, {} });
  cases.push_back({ "Graded", "areas over 12 orders of magnitude in one mesh", [](int n) { return Graded(n, 1e-6); },
    1250, 10000, Limits().WithFlipped(0.35).WithIntersections(4000) });
  cases.push_back({ "GradedRings", "areas over 12 orders of magnitude, triangles well shaped",
    [](int n) { return GradedRings(n, 1e-6); }, 1250, 20000, {} });
  cases.push_back({ "Slivers1e4", "triangles of aspect 1e4", [](int n) { return Slivers(n, 1e4); }, 1280, 5120,
    Limits().WithFlipped(0.6).WithIntersections(700), 31 });
  cases.push_back({ "Slivers1e8", "triangles of aspect 1e8", [](int n) { return Slivers(n, 1e8); }, 1280, 5120,
    Limits().WithFlipped(0.05).WithIntersections(1500), 31 });
  cases.push_back(
    { "Needles", "triangles as long as the mesh", Needles, 1280, 5000, Limits().WithRoot(8), 24, false, 80000 });
}

void AddThin(std::vector<Case>& cases)
{
  cases.push_back(
    { "RoughComb", "a comb of 20 thin teeth, rough", [](int n) { return RoughComb(n, std::max(4, n / 100)); }, 2000,
      4000, Limits().WithFlipped(0.9).WithIntersections(2500), 24, false, 4000 });
  cases.push_back(
    { "WavedComb", "a comb of 20 thin teeth, waved", [](int n) { return WavedComb(n, std::max(4, n / 100)); }, 2000,
      4000, Limits().WithFlipped(0.9).WithIntersections(2000), 24, false, 4000 });
  cases.push_back(
    { "ThinPlate", "a closed plate 1e-6 thick, flat", [](int n) { return ThinPlate(n, 1e-6, 0.0); }, 1280, 20000, {} });
  cases.push_back({ "WavedPlate", "a closed plate 1e-6 thick, waved", [](int n) { return ThinPlate(n, 1e-6, 0.05); },
    1280, 20000, Limits().WithFlipped(0.6).WithIntersections(3500) });
  cases.push_back({ "ThinSheets", "two waved sheets 1e-6 apart", [](int n) { return ThinSheets(n, 1e-6); }, 1280, 20000,
    Limits().WithFlipped(0.7).WithIntersections(5000) });
  cases.push_back({ "Spikes", "spikes of up to thirty radii", Spikes, 1280, 20480,
    Limits().WithFlipped(0.12).WithIntersections(30) });
  cases.push_back({ "Sponge", "a Menger sponge", Sponge, 2000, 20000, Limits().WithRoot(9) });
  cases.push_back(
    { "Crumpled", "paper folded 14 times, which crosses itself", Crumpled, 1250, 20000, Limits().WithFlipped(0.15) });
}

void AddFlat(std::vector<Case>& cases)
{
  cases.push_back({ "Noise1em7", "a plane with noise of 1e-7", [](int n) { return NoisyPlane(n, 1e-7); }, 1250, 20000,
    Limits().WithFlipped(0.08) });
  cases.push_back(
    { "Noise1em9", "a plane with noise of 1e-9", [](int n) { return NoisyPlane(n, 1e-9); }, 1250, 20000, {} });
  cases.push_back({ "Plane", "exactly flat", Plane, 1250, 20000, {}, 24, true });
  cases.push_back(
    { "SlopingPlane", "exactly flat on a slope", SlopingPlane, 1250, 20000, Limits().WithFlatError(3), 24, true });
  cases.push_back({ "TurnedSlope", "a larger plane turned, flat up to rounding",
    [](int n) {
      return TurnAndMove(SlopingPlane(n), 1.1, { 100.0, -70.0, 30.0 });
    },
    1250, 20000, {} });
  cases.push_back({ "TurnedPlane", "a plane turned, flat up to rounding", MakeTurned(Plane), 1250, 20000, {} });
  cases.push_back({ "Cylinder", "a cylinder", Cylinder, 1280, 20000, {} });
  cases.push_back({ "TurnedCylinder", "a cylinder turned", MakeTurned(Cylinder), 1280, 20000, {} });
  cases.push_back({ "Cone", "a cone", Cone, 1280, 20000, {} });
  cases.push_back({ "TurnedCone", "a cone turned", MakeTurned(Cone), 1280, 20000, {} });
  cases.push_back({ "Rings", "flat, each cell's corners on a circle, in rings", Rings, 1280, 20000, {} });
  cases.push_back({ "Terraces", "a lattice of squares in steps", Terraces, 1250, 20000, {} });
}

void AddTopology(std::vector<Case>& cases)
{
  cases.push_back({ "Components", "triangles that touch nothing", Components, 2000, 100000,
    Limits().WithLostComponents(), 24, false, 100000 });
  cases.push_back(
    { "Spheres", "many closed components", Tetrahedra, 2000, 40000, Limits().WithFlipped(0.1).WithLostComponents() });
  cases.push_back({ "Fan", "a fan about one vertex", Fan, 1500, 10000, {}, 24, false, 100000 });
  cases.push_back({ "TwoFans", "two fans tip to tip", TwoFans, 1500, 10000, {}, 24, false, 100000 });
  cases.push_back({ "Spindle", "two apexes over one ring", Spindle, 3000, 10000, {}, 24, false, 100000 });
  cases.push_back({ "Checkerboard", "squares corner to corner", Checkerboard, 1250, 20000, Limits().WithRoot(8) });
  cases.push_back({ "Moebius", "a Moebius strip", Moebius, 1280, 20000, {} });
  cases.push_back({ "Klein", "a Klein bottle", Klein, 1280, 20000, Limits().WithFlipped(0.5) });
  cases.push_back({ "Barycentres", "triangles around one barycentre", Barycentres, 500, 1000,
    Limits().WithLostComponents(), 24, false, 8000 });
  cases.push_back({ "Pages", "triangles at one edge", Pages, 1000, 10000, Limits().WithRoot(7), 24, false, 80000 });
  cases.push_back(
    { "TJunctions", "blocks of cells that share no points", TJunctions, 1500, 20000, Limits().WithLostComponents() });
}

void AddContent(std::vector<Case>& cases)
{
  cases.push_back({ "NoTriangle", "no triangle", FewTriangles, 0, 0, {}, 24, false, 0, "the input has no triangles" });
  cases.push_back({ "OneTriangle", "one triangle", FewTriangles, 1, 1, {} });
  cases.push_back({ "TwoTriangles", "two triangles", FewTriangles, 2, 2, {} });
  cases.push_back({ "SignedZeros", "zeros of both signs at the same places", SignedZeros, 1250, 20000, {} });
  cases.push_back({ "NotFinite", "NaN and infinity among coordinates", NotFinite, 1250, 20000, {} });
}

std::vector<Case> MakeCases()
{
  std::vector<Case> cases;
  AddScales(cases);
  AddProportions(cases);
  AddThin(cases);
  AddFlat(cases);
  AddTopology(cases);
  AddContent(cases);
  return cases;
}
}

//------------------------------------------------------------------------------
Limits Limits::WithFlipped(double share) const
{
  Limits changed = *this;
  changed.FlippedShare = share;
  return changed;
}

//------------------------------------------------------------------------------
Limits Limits::WithIntersections(double count) const
{
  Limits changed = *this;
  changed.MadeIntersections = count;
  return changed;
}

//------------------------------------------------------------------------------
Limits Limits::WithRoot(double targets) const
{
  Limits changed = *this;
  changed.RootTriangles = targets;
  return changed;
}

//------------------------------------------------------------------------------
Limits Limits::WithFlatError(double steps) const
{
  Limits changed = *this;
  changed.FlatError = steps;
  return changed;
}

//------------------------------------------------------------------------------
Limits Limits::WithLostComponents() const
{
  Limits changed = *this;
  changed.KeepsComponents = false;
  changed.KeepsEuler = false;
  return changed;
}

//------------------------------------------------------------------------------
const std::vector<Case>& GetCases()
{
  static const std::vector<Case> cases = MakeCases();
  return cases;
}

//------------------------------------------------------------------------------
const Case* FindCase(const std::string& name)
{
  const auto& cases = GetCases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& stiff) { return stiff.Name == name; });
  return found == cases.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
double GetRegionTarget(const MTStiffStudy::Settings& settings)
{
  return vtkMTBuildSettings().PatchesPerRegion * settings.PatchTriangles;
}

//------------------------------------------------------------------------------
MTStiffStudy::Settings GetSettings(const Case& stiff)
{
  MTStiffStudy::Settings settings;
  settings.LatticeBits = stiff.LatticeBits;
  return settings;
}

//------------------------------------------------------------------------------
std::vector<Verdict> GetVerdicts(
  const Case& stiff, const MTStiffStudy::Settings& settings, const MTStiffStudy::Result& result)
{
  const Limits& limit = stiff.Limit;
  const Limits claims;
  std::vector<Verdict> verdicts{ { *stiff.Refusal ? "is refused with the reason" : "builds",
    result.Error == stiff.Refusal ? 0.0 : 1.0, 0.0, 0.0 } };
  if (!result.Error.empty())
  {
    return verdicts;
  }
  verdicts.push_back({ "verifies", result.IsValid ? 0.0 : 1.0, 0.0, 0.0 });
  verdicts.push_back({ "every number is finite", result.IsFinite ? 0.0 : 1.0, 0.0, 0.0 });
  verdicts.push_back({ "triangles of the coarsest cut, in targets",
    static_cast<double>(result.RootTriangles) / GetRegionTarget(settings), claims.RootTriangles, limit.RootTriangles });
  if (stiff.IsFlat)
  {
    verdicts.push_back({ "largest error, in steps", result.LargestOwnError / result.Step, 0.0, limit.FlatError });
  }
  if (!result.IsSearched)
  {
    return verdicts;
  }
  verdicts.push_back({ "worst place over certified", result.GetViolation(), 1.0, 1.0 });
  verdicts.push_back({ "certified over worst place", result.GetLooseness(), claims.Looseness, limit.Looseness });
  verdicts.push_back(
    { "share of flipped triangles", result.GetFlippedShare(), claims.FlippedShare, limit.FlippedShare });
  verdicts.push_back(
    { "components change", result.KeepsComponents() ? 0.0 : 1.0, 0.0, limit.KeepsComponents ? 0.0 : 1.0 });
  verdicts.push_back({ "Euler number changes", result.KeepsEuler() ? 0.0 : 1.0, 0.0, limit.KeepsEuler ? 0.0 : 1.0 });
  if (result.GetMadeIntersections() >= 0)
  {
    verdicts.push_back({ "intersections made", static_cast<double>(result.GetMadeIntersections()),
      claims.MadeIntersections, limit.MadeIntersections });
  }
  return verdicts;
}
}
