// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTEdgeCollapse.h"

#include "vtkMTCollapseModes.h"
#include "vtkMTCollapseRegion.h"
#include "vtkMTComponentRemoval.h"
#include "vtkMTFanMesh.h"
#include "vtkMTSetMacros.h"

#include "vtkObjectFactory.h"

#include <array>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkMTEdgeCollapse);
vtkMTCxxSetClampMacro(vtkMTEdgeCollapse, ComponentBound, 0.0, 1.0);

namespace
{
struct ModeRecord
{
  const char* Name;
  void (*Run)(vtkMTCollapseRegion&);
};

const std::array<ModeRecord, 4> Modes = { { { "fast", vtkMTCollapse::RunFast }, { "best", vtkMTCollapse::RunBest },
  { "lindstrom-turk", vtkMTCollapse::RunLindstromTurk }, { "garland-heckbert", vtkMTCollapse::RunGarlandHeckbert } } };

// A pass may leave edges that later collapses nearby have set free; it is worth another one while it gets anywhere.
constexpr int MaximumPasses = 16;

// CGAL's loop asks, after every collapse, for all edges of all neighbours, and goes around both ends of each: the cube
// of the number of edges at a vertex. Regions with a vertex of more edges than these are left to the toolkit's own
// loop.
constexpr std::uint32_t LargestValenceOfStockLoop = 64;

double GetDiagonal(const vtkMTBox& box)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double side = static_cast<double>(box[2 * i + 1]) - static_cast<double>(box[2 * i]);
    sum += side * side;
  }
  return std::sqrt(sum);
}
}

vtkMTEdgeCollapse::vtkMTEdgeCollapse() = default;

vtkMTEdgeCollapse::~vtkMTEdgeCollapse() = default;

bool vtkMTEdgeCollapse::SetModeByName(const char* name)
{
  for (std::size_t i = 0; name && i < Modes.size(); ++i)
  {
    if (std::string(name) == Modes[i].Name)
    {
      this->SetMode(static_cast<int>(i));
      return true;
    }
  }
  return false;
}

const char* vtkMTEdgeCollapse::GetSimplifierName() const
{
  return Modes[this->Mode].Name;
}

std::string vtkMTEdgeCollapse::GetSettings() const
{
  std::ostringstream out;
  out.precision(17);
  out << this->GetSimplifierName() << " component_bound=" << this->ComponentBound
      << " steps_per_edge=" << this->StepsPerEdge;
  return out.str();
}

bool vtkMTEdgeCollapse::Simplify(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::size_t target,
  vtkMTSimplification& result, std::string& error) const
{
  result = {};
  try
  {
    return this->SimplifyOrThrow(floor, locked, target, result, error);
  }
  catch (const std::exception& e)
  {
    error = e.what();
  }
  result = {};
  return false;
}

bool vtkMTEdgeCollapse::SimplifyOrThrow(const vtkMTPatch& floor, const std::vector<unsigned char>& locked,
  std::size_t target, vtkMTSimplification& result, std::string& error) const
{
  vtkMTFanMesh fans;
  if (!fans.Build(floor, locked, error))
  {
    return false;
  }
  vtkMTCollapseRegion region(floor, fans);
  region.Target = target;
  region.StepLimit =
    static_cast<std::uint64_t>(this->StepsPerEdge) * (region.Mesh.GetNumberOfEdges() + std::uint64_t(1));
  fans = {};
  const double smallPart = this->ComponentBound * GetDiagonal(region.GetBox());
  if (!this->Collapse(region, smallPart, error))
  {
    return false;
  }
  region.Extract(result);
  if (result.Triangles.size() > target)
  {
    region.CountBlocked(result.Blocked);
    vtkMTComponentRemoval removal;
    removal.MaximumDiagonal = smallPart;
    removal.Remove(locked, target, result);
  }
  return true;
}

bool vtkMTEdgeCollapse::Collapse(vtkMTCollapseRegion& region, double largestHole, std::string& error) const
{
  const bool isFast = this->Mode == FAST || region.HasVertexAbove(LargestValenceOfStockLoop);
  region.HubValence = isFast ? vtkMTCollapseRegion::LargestValence : LargestValenceOfStockLoop;
  const auto run = Modes[isFast ? FAST : this->Mode].Run;
  try
  {
    for (int pass = 0; pass < MaximumPasses && region.Faces > region.Target; ++pass)
    {
      const std::size_t before = region.Faces;
      run(region);
      const bool stuck = region.Faces == before;
      if (stuck && region.CloseHoles(largestHole) == 0)
      {
        break;
      }
    }
  }
  catch (const vtkMTCollapseRegion::StepLimitReached& e)
  {
    // Steps are counted between collapses, so the mesh is whole, unless the endless loop has its cause in the mesh.
    if (!region.Mesh.IsValid())
    {
      error = e.what();
      return false;
    }
  }
  return true;
}
