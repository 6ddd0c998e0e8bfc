// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief what CGAL's edge_collapse() is given: traits, constraints, filter, stop predicate and visitor over one region
 *
 * Run() is the one call of edge_collapse() for all modes. A mode is a class with GetPlace(profile, rule), and a cost
 * policy.
 */
#ifndef vtkMTCollapsePolicies_h
#define vtkMTCollapsePolicies_h

#include "vtkMTCgalCompatibility.h"
#include "vtkMTCgalMesh.h"
#include "vtkMTCollapseRegion.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace vtkMTCollapse
{
namespace SMS = CGAL::Surface_mesh_simplification;
using Region = vtkMTCollapseRegion;
using Surface = vtkMTCgalMesh::Surface;
using Point = vtkMTCgalMesh::Point;
using Place = Optional<Point>;
using Cost = Optional<double>;

/// The collapsing edge of a profile, as the region numbers it.
template <class Profile>
std::uint32_t GetHalfedge(const Profile& profile)
{
  return static_cast<std::uint32_t>(profile.v0_v1().idx());
}

/// CGAL collapses all edges between equal points first, past every predicate and filter. Here no two points are equal:
/// such an edge is one of length zero, with a cost like any other.
struct NeverEqual
{
  using result_type = bool;
  bool operator()(const Point&, const Point&) const { return false; }
};

struct Traits : public vtkMTCgalMesh::Kernel
{
  using Equal_3 = NeverEqual;
  Equal_3 equal_3_object() const { return {}; }
};

/// Edges between two locked vertices stay.
struct ConstrainedMap
{
  using key_type = vtkMTCgalMesh::Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const Region* R;
  friend bool get(const ConstrainedMap& map, vtkMTCgalMesh::Edge e)
  {
    const auto h = static_cast<std::uint32_t>(2 * e.idx());
    return map.R->GetState(map.R->Mesh.GetSource(h)).Lock && map.R->GetState(map.R->Mesh.GetTarget(h)).Lock;
  }
};

/// Counts triangles, not edges as CGAL's count predicates do: open borders get shorter on the way.
struct Stop
{
  Region* R;
  template <class Profile>
  bool operator()(double, const Profile&, std::size_t, std::size_t) const
  {
    this->R->Step();
    return this->R->Faces <= this->R->Target;
  }
};

struct Filter
{
  const Region* R;
  template <class Profile>
  Place operator()(const Profile& profile, const Place& place) const
  {
    const std::uint32_t h = GetHalfedge(profile);
    const bool isRefused = !place || this->R->MakesHub(h) || this->R->MakesChord(h, this->R->GetRule(h)) ||
      this->R->MakesDoubleEdge(h) || this->R->SpoilsShape(h, vtkMTCgalMesh::ToVector(*place));
    return isRefused ? Place() : place;
  }
};

struct Visitor : public SMS::internal::Dummy_visitor
{
  Region* R;
  vtkMTCgalMesh* M;
  Visitor(Region& region, vtkMTCgalMesh& mesh)
    : R(&region)
    , M(&mesh)
  {
  }
  template <class Profile>
  void OnCollapsing(const Profile& profile, const Place& place) const
  {
    this->R->BeginCollapse(GetHalfedge(profile), vtkMTCgalMesh::ToVector(*place));
    this->M->BeginCollapse(profile.v0_v1());
  }
  template <class Profile>
  void OnCollapsed(const Profile&, vtkMTCgalMesh::Vertex kept) const
  {
    this->M->EndCollapse(kept);
    this->R->EndCollapse(static_cast<std::uint32_t>(kept.idx()));
  }
};

/// Asks the mode where its rule leaves a choice.
template <class Mode>
struct Placement
{
  const Region* R;
  const Mode* M;
  template <class Profile>
  Place operator()(const Profile& profile) const
  {
    const Region::Rule rule = this->R->GetRule(GetHalfedge(profile));
    return rule == Region::Rule::Refused ? Place() : this->M->GetPlace(profile, rule);
  }
};

///@{
/// CGAL's algorithm for a mode, as edge_collapse() instantiates it: for specialising members.
template <class T>
using Bare = std::remove_cv_t<std::remove_reference_t<T>>;
template <class TraitsType>
using Parameters = Bare<decltype(CGAL::parameters::geom_traits(std::declval<TraitsType&>()))>;
template <class TraitsType>
using VertexIndexMap = Bare<decltype(CGAL::get_initialized_vertex_index_map(
  std::declval<Surface&>(), std::declval<const Parameters<TraitsType>&>()))>;
template <class TraitsType>
using HalfedgeIndexMap = Bare<decltype(CGAL::get_initialized_halfedge_index_map(
  std::declval<Surface&>(), std::declval<const Parameters<TraitsType>&>()))>;
using PointMap = Bare<decltype(CGAL::get_property_map(CGAL::vertex_point, std::declval<Surface&>()))>;
template <class TraitsType, class Mode, class CostPolicy>
using Algorithm = SMS::EdgeCollapse<Surface, TraitsType, Stop, VertexIndexMap<TraitsType>, PointMap,
  HalfedgeIndexMap<TraitsType>, ConstrainedMap, CostPolicy, Placement<Mode>, Filter, Visitor, false>;
///@}

template <class TraitsType, class Mode, class CostPolicy>
void Run(Region& region, vtkMTCgalMesh& mesh, const Mode& mode, const CostPolicy& cost)
{
  const Stop stop{ &region };
  const TraitsType traits;
  const ConstrainedMap constrained{ &region };
  const Placement<Mode> placement{ &region, &mode };
  const Filter filter{ &region };
  SMS::edge_collapse(mesh.Mesh, stop,
    CGAL::parameters::geom_traits(traits)
      .edge_is_constrained_map(constrained)
      .get_cost(cost)
      .get_placement(placement)
      .filter(filter)
      .visitor(Visitor(region, mesh)));
}
}

#endif
