// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputComparison.h"

#include "vtkMTCutMesh.h"
#include "vtkMTGraph.h"
#include "vtkMTInputArrays.h"
#include "vtkMTLabelCheck.h"
#include "vtkMTLatticeKeys.h"
#include "vtkMTPatchSource.h"
#include "vtkMTVector.h"
#include "vtkMTVerifyPolygons.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace vtkMTVector;

namespace
{

template <class... Parts>
std::string Write(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(9);
  (text << ... << parts);
  return text.str();
}
}

vtkMTInputComparison::~vtkMTInputComparison() = default;

vtkMTInputComparison::vtkMTInputComparison(
  const vtkMTPatchSource& source, vtkPolyData* input, double rounding, std::size_t limit)
  : Source(source)
  , InputMesh(input)
  , Rounding(rounding)
  , Limit(limit)
{
}

std::int64_t vtkMTInputComparison::GetCount(const std::string& name) const
{
  const auto& report = this->Source.GetGraph().InputReport;
  const auto found = report.find(name);
  return found == report.end() ? 0 : found->second;
}

std::string vtkMTInputComparison::Describe(const Vector& local) const
{
  const Vector x = this->Frame.ToModelPoint(local);
  return Write("(", x[0], ", ", x[1], ", ", x[2], ")");
}

bool vtkMTInputComparison::Load(const vtkMTVerificationProgress& progress, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  vtkMTCutMesh mesh;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    if (graph.IsFinest(arc))
    {
      mesh.Arcs.push_back(arc);
    }
  }
  mesh.Progress = [&](double share) { return progress("reading the finest level", 0.4 * share); };
  if (!mesh.Make(this->Source, this->ModelMesh, error))
  {
    return false;
  }
  vtkMTVerifyPolygons(nullptr).Split(this->ModelMesh, this->Model);
  double box[6];
  graph.GetBounds(box);
  // Input that is read as it is comes to the very lattice points of the model.
  double reach = 0.0;
  for (int side = 0; this->Rounding > 0.0 && side < 6; ++side)
  {
    reach = std::max(reach, graph.Lattice.MaximumShift + this->Rounding * std::abs(box[side]));
  }
  this->Keys = std::make_unique<vtkMTLatticeKeys>(graph.Lattice, box, reach, this->Model);
  vtkMTVerifyPolygons polygons(
    [this](const Vector& a, const Vector& b, const Vector& c) { return this->Keys->CountTriangles(a, b, c); });
  polygons.Split(this->InputMesh, this->Original);
  this->Original.LeaveOutFar(graph);
  this->InputKeys = std::make_unique<vtkMTLatticeKeys>(graph.Lattice, box, 0.0, this->Original);
  this->OpenTriangles = polygons.GetOpenTriangles();
  this->OpenArea = polygons.GetOpenArea();
  this->OpenVolume = polygons.GetOpenVolume();

  const vtkMTRealBounds bounds = this->Original.GetBounds();
  double largest = 0.0;
  for (int axis = 0; axis < 3 && !bounds.IsEmpty(); ++axis)
  {
    largest = std::max({ largest, std::abs(bounds.Minimum[axis]), std::abs(bounds.Maximum[axis]) });
  }
  this->Original.Rounding = this->Rounding * largest;
  this->Allowance = graph.Lattice.MaximumShift + (this->Rounding + vtkMTMeasuringFrame::Tolerance) * largest;
  vtkMTRealBounds both = this->Model.GetBounds();
  both.Add(bounds);
  this->OpenTriangles += this->Rounding > 0.0 ? this->CountSmall() : 0;
  this->Frame = vtkMTMeasuringFrame::FromBounds(both);
  this->Input = this->Original;
  this->Input.Transform(this->Frame);
  this->Model.Transform(this->Frame);
  return true;
}

// Triangles that are degenerate, or may be where coordinates are rounded.
std::int64_t vtkMTInputComparison::CountSmall() const
{
  const auto isSmall = [this](const vtkMTTriangle& t)
  {
    const auto isShort = [&](int i)
    {
      return Length(Subtract(this->Original.Points[t[i]], this->Original.Points[t[(i + 1) % 3]])) <=
        2.0 * this->Allowance;
    };
    return isShort(0) || isShort(1) || isShort(2);
  };
  return this->Original.Degenerate +
    std::count_if(this->Original.Triangles.begin(), this->Original.Triangles.end(), isSmall);
}

vtkMTInputComparison::Figures vtkMTInputComparison::Measure(const vtkMTSampledSurface& surface) const
{
  Figures figures;
  figures.Triangles = static_cast<std::int64_t>(surface.Triangles.size());
  const double s = this->Allowance * this->Frame.Scale;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Vector& a = surface.Points[surface.Triangles[t][0]];
    const Vector& b = surface.Points[surface.Triangles[t][1]];
    const Vector& c = surface.Points[surface.Triangles[t][2]];
    figures.Area += surface.GetArea(t);
    figures.AreaAllowance += s * (Length(Subtract(b, a)) + Length(Subtract(c, a))) + 2.0 * s * s;
    const Vector bc = Cross(b, c);
    figures.Volume += Dot(a, bc) / 6.0;
    const double change = Length(bc) + Length(Cross(c, a)) + Length(Cross(a, b));
    figures.VolumeAllowance += (s * change + s * s * (Length(a) + Length(b) + Length(c)) + s * s * s) / 6.0;
  }
  const double scale = this->Frame.Scale;
  figures.AreaAllowance += 1e-9 * figures.Area + this->OpenArea * scale * scale;
  figures.VolumeAllowance += 1e-9 * figures.Area + this->OpenVolume * scale * scale * scale;
  return figures;
}

double vtkMTInputComparison::ToModel(double figure, int dimensions) const
{
  for (int i = 0; i < dimensions; ++i)
  {
    figure = this->Frame.ToModel(figure);
  }
  return figure;
}

vtkMTVerificationCheck vtkMTInputComparison::TestTriangles() const
{
  vtkMTVerificationCheck check("input_triangles");
  const std::int64_t difference = this->InputFigures.Triangles - this->ModelFigures.Triangles;
  check.Tested = static_cast<std::uint64_t>(this->InputFigures.Triangles);
  if (std::abs(difference) > this->OpenTriangles)
  {
    check.Fail(Write("the input has ", this->InputFigures.Triangles, " triangles, the model ",
      this->ModelFigures.Triangles, difference > 0 ? ": too few" : ": too many"));
  }
  const std::pair<const char*, std::int64_t> reasons[] = { { "dropped_not_finite", this->Original.NonFinite },
    { "dropped_index_out_of_range", this->Original.OutOfRange }, { "dropped_degenerate", this->Original.Degenerate },
    { "dropped_far_outlier", this->Original.FarOutliers } };
  for (const auto& [name, found] : reasons)
  {
    if (this->GetCount(name) > found + this->OpenTriangles)
    {
      check.Fail(Write("the model's report says ", name, ": ", this->GetCount(name), ", but the input has ", found,
        " such triangles"));
    }
  }
  return check;
}

vtkMTVerificationCheck vtkMTInputComparison::TestBounds() const
{
  vtkMTVerificationCheck check("input_bounds");
  const vtkMTRealBounds input = this->Input.GetBounds();
  const vtkMTRealBounds model = this->Model.GetBounds();
  for (int side = 0; side < 6; ++side)
  {
    const double a = side % 2 == 0 ? input.Minimum[side / 2] : input.Maximum[side / 2];
    const double b = side % 2 == 0 ? model.Minimum[side / 2] : model.Maximum[side / 2];
    const double apart = this->Frame.ToModel(std::abs(a - b));
    ++check.Tested;
    check.Worst = std::max(check.Worst, this->Allowance > 0.0 ? apart / this->Allowance : 0.0);
    if (!(apart <= this->Allowance))
    {
      const double center = this->Frame.Center[side / 2];
      check.Fail(Write("the input's ", side % 2 == 0 ? "least " : "largest ", "xyz"[side / 2], " is ",
        center + this->Frame.ToModel(a), ", the model's ", center + this->Frame.ToModel(b), "; allowed are ",
        this->Allowance));
    }
  }
  return check;
}

vtkMTVerificationCheck vtkMTInputComparison::TestArea() const
{
  vtkMTVerificationCheck check("input_area");
  const double apart = std::abs(this->InputFigures.Area - this->ModelFigures.Area);
  const double allowed = this->InputFigures.AreaAllowance;
  check.Tested = 1;
  check.Worst = allowed > 0.0 ? apart / allowed : 0.0;
  if (!(apart <= allowed))
  {
    check.Fail(Write("the input's area is ", this->ToModel(this->InputFigures.Area, 2), ", the model's ",
      this->ToModel(this->ModelFigures.Area, 2), "; allowed are ", this->ToModel(allowed, 2)));
  }
  return check;
}

vtkMTVerificationCheck vtkMTInputComparison::TestVolume() const
{
  vtkMTVerificationCheck check("input_volume");
  if (this->GetCount("reoriented_triangles") > 0)
  {
    return check; // the builder turned triangles, which input_orientation holds against its report
  }
  const double apart = std::abs(this->InputFigures.Volume - this->ModelFigures.Volume);
  const double allowed = this->InputFigures.VolumeAllowance;
  check.Tested = 1;
  check.Worst = allowed > 0.0 ? apart / allowed : 0.0;
  if (!(apart <= allowed))
  {
    const bool isTurned = std::abs(this->InputFigures.Volume + this->ModelFigures.Volume) <= allowed;
    check.Fail(Write("the input's signed volume is ", this->ToModel(this->InputFigures.Volume, 3), ", the model's ",
      this->ToModel(this->ModelFigures.Volume, 3), "; allowed are ", this->ToModel(allowed, 3),
      isTurned ? ": the model is turned inside out" : ""));
  }
  return check;
}

// One is so thin that its corners may be anything's, or depends on how a polygon is split.
bool vtkMTInputComparison::IsUnclear(std::uint32_t t) const
{
  const vtkMTTriangle& corners = this->Input.Triangles[t];
  const auto& x = this->Input.Points;
  const double longest = std::max({ Length(Subtract(x[corners[1]], x[corners[0]])),
    Length(Subtract(x[corners[2]], x[corners[1]])), Length(Subtract(x[corners[0]], x[corners[2]])) });
  return this->Input.Slack[t] > 0.0 ||
    2.0 * this->Input.GetArea(t) <= 8.0 * this->Allowance * this->Frame.Scale * longest;
}

void vtkMTInputComparison::TestTriangle(
  std::uint32_t t, const vtkMTCounterparts& counterparts, vtkMTVerificationCheck& check)
{
  vtkMTCounterparts::Found found = counterparts.Find(t);
  const std::int64_t mayTurn = this->GetCount("reoriented_triangles");
  const std::size_t inputs = found.InputSame + found.InputTurned;
  const std::size_t models = found.SameCount + found.TurnedCount;
  const bool isLacking = found.Rank >= found.SameCount; // the model has fewer in this turn
  const auto describe = [&] { return this->Describe(this->Input.Points[this->Input.Triangles[t][0]]); };
  if (models == 0)
  {
    check.Fail("the triangle with a corner at " + describe() + " of the input is not in the model");
    return;
  }
  if (isLacking && models < inputs)
  {
    check.Fail(Write("the triangle with a corner at ", describe(), " is ", inputs, " times in the input, ", models,
      " times in the model"));
    return;
  }
  this->Turned += isLacking ? 1 : 0;
  if (isLacking && this->Turned > mayTurn)
  {
    check.Fail(Write("the triangle with a corner at ", describe(), " is turned over, and the model's report counts ",
      mayTurn, " such"));
  }
  // Where triangles may be turned, or are, the turn does not say which is which.
  Pair pair{ t, found.Same };
  if (isLacking || mayTurn > 0)
  {
    pair.Models.insert(pair.Models.end(), found.Turned.begin(), found.Turned.end());
  }
  if (!this->Input.Mixed[t] && found.SameCount <= vtkMTCounterparts::CopiesLimit &&
    found.TurnedCount <= vtkMTCounterparts::CopiesLimit)
  {
    this->Pairs.push_back(std::move(pair));
  }
}

bool vtkMTInputComparison::TestOrientation(const vtkMTVerificationProgress& progress, vtkMTVerificationCheck& check)
{
  const std::size_t count = this->Input.Triangles.size();
  const std::size_t stride = std::max<std::size_t>(1, (count + this->Limit - 1) / this->Limit);
  const double allowed = this->Allowance * this->Frame.Scale + vtkMTMeasuringFrame::Tolerance;
  const vtkMTCounterparts counterparts(
    *this->InputKeys, this->Original.Points, *this->Keys, this->Input, this->Model, allowed);
  for (std::size_t i = 0; i < count; i += stride)
  {
    if (i % (stride * 1024) == 0 && !progress("comparing triangles", 0.4 + 0.4 * static_cast<double>(i) / count))
    {
      return false;
    }
    const auto t = static_cast<std::uint32_t>(i);
    if (!this->IsUnclear(t))
    {
      ++check.Tested;
      this->TestTriangle(t, counterparts, check);
    }
  }
  return true;
}

bool vtkMTInputComparison::Test(
  const vtkMTVerificationProgress& progress, std::vector<vtkMTVerificationCheck>& checks, std::string& error)
{
  vtkMTVerificationCheck orientation("input_orientation");
  if (!this->Load(progress, error))
  {
    return false;
  }
  this->InputFigures = this->Measure(this->Input);
  this->ModelFigures = this->Measure(this->Model);
  this->ModelFigures.Triangles = static_cast<std::int64_t>(this->Source.GetGraph().GetNumberOfFinestTriangles());
  checks.insert(checks.end(), { this->TestTriangles(), this->TestBounds(), this->TestArea(), this->TestVolume() });
  if (!this->TestOrientation(progress, orientation))
  {
    return false;
  }
  checks.push_back(orientation);
  const vtkMTInputArrays arrays(this->InputMesh, this->Input, this->ModelMesh, this->Model, this->Pairs);
  checks.push_back(arrays.Test(this->Source.GetGraph(), [this](const Vector& x) { return this->Describe(x); }));
  vtkMTVerificationCheck labels("labels");
  if (!vtkMTLabelCheck::Test(
        this->Source, [&progress](const std::string& step, double share) { return progress(step, 0.8 + 0.2 * share); },
        labels, error))
  {
    return false;
  }
  checks.push_back(labels);
  return true;
}
