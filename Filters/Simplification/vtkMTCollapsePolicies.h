// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief what CGAL's edge_collapse() is given: traits, constraints, filter, stop predicate and visitor over one region
 *
 * Run() is the one call of edge_collapse() for all modes. A mode is a class with GetPlace(profile, rule), and a cost
 * policy.
 */
#ifndef vtkMTCollapsePolicies_h
#define vtkMTCollapsePolicies_h

#include "vtkMTCollapseRegion.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>

#include <boost/optional.hpp>

#include <type_traits>
#include <utility>

/// Members of CGAL's algorithm are private: they are specialised for the versions that they were written for only.
#define vtkMT_CGAL_IS_KNOWN (CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000)

namespace vtkMTCollapse
{
namespace SMS = CGAL::Surface_mesh_simplification;
using Region = vtkMTCollapseRegion;
using Point = Region::Point;
using Place = boost::optional<Point>;
using Cost = boost::optional<double>;

/// CGAL collapses all edges between equal points first, past every predicate and filter. Here no two points are equal:
/// such an edge is one of length zero, with a cost like any other.
struct NeverEqual
{
  using result_type = bool;
  bool operator()(const Point&, const Point&) const { return false; }
};

struct Traits : public Region::Kernel
{
  using Equal_3 = NeverEqual;
  Equal_3 equal_3_object() const { return {}; }
};

struct ConstrainedMap
{
  using key_type = Region::Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const unsigned char* Flags;
  friend bool get(const ConstrainedMap& map, Region::Edge e) { return map.Flags[e.idx()] != 0; }
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
    if (!place || this->R->MakesChord(profile.v0_v1(), this->R->GetRule(profile.v0_v1())) ||
      this->R->MakesDoubleEdge(profile.v0_v1()) || this->R->TurnsTriangle(profile.v0_v1(), *place))
    {
      return boost::none;
    }
    return place;
  }
};

struct Visitor : public SMS::internal::Dummy_visitor
{
  Region* R;
  explicit Visitor(Region& region)
    : R(&region)
  {
  }
  template <class Profile>
  void OnCollapsing(const Profile& profile, const Place& place) const
  {
    this->R->BeginCollapse(profile.v0_v1(), *place);
  }
  template <class Profile>
  void OnCollapsed(const Profile&, Region::Vertex kept) const
  {
    this->R->EndCollapse(kept);
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
    const Region::Rule rule = this->R->GetRule(profile.v0_v1());
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
  std::declval<Region::Mesh&>(), std::declval<const Parameters<TraitsType>&>()))>;
template <class TraitsType>
using HalfedgeIndexMap = Bare<decltype(CGAL::get_initialized_halfedge_index_map(
  std::declval<Region::Mesh&>(), std::declval<const Parameters<TraitsType>&>()))>;
using PointMap = Bare<decltype(CGAL::get_property_map(CGAL::vertex_point, std::declval<Region::Mesh&>()))>;
template <class TraitsType, class Mode, class CostPolicy>
using Algorithm = SMS::EdgeCollapse<Region::Mesh, TraitsType, Stop, VertexIndexMap<TraitsType>, PointMap,
  HalfedgeIndexMap<TraitsType>, ConstrainedMap, CostPolicy, Placement<Mode>, Filter, Visitor, false>;
///@}

template <class TraitsType, class Mode, class CostPolicy>
void Run(Region& region, const Mode& mode, const CostPolicy& cost)
{
  const Stop stop{ &region };
  const TraitsType traits;
  const ConstrainedMap constrained{ region.Constrained.data() };
  const Placement<Mode> placement{ &region, &mode };
  const Filter filter{ &region };
  SMS::edge_collapse(region.Surface, stop,
    CGAL::parameters::geom_traits(traits)
      .edge_is_constrained_map(constrained)
      .get_cost(cost)
      .get_placement(placement)
      .filter(filter)
      .visitor(Visitor(region)));
}
}

#endif
