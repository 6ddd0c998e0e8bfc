// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief CGAL's edge collapse for the fast mode: costs are asked again on the 1-ring only, and nothing is allocated
 *
 * CGAL's loop asks for the cost of every edge that ends at a neighbour of the kept vertex, about thirty after each
 * collapse, collects them in two sets, and makes a profile with two vectors for each. The quadric of an edge changes most where the
 * edge ends at the kept vertex itself; asking only these six or so leaves the result within a few percent and costs a
 * quarter of the time. The members below are explicit specialisations for this project's own traits type; CGAL's headers and every other
 * use of them stay as they are. They speak of private members, so they hold for the CGAL versions they were
 * written for, and with any other the fast mode is the stock loop.
 */
#ifndef vtkMTRingUpdate_h
#define vtkMTRingUpdate_h

#include "vtkMTQuadricMode.h"

#include <type_traits>
#include <utility>

namespace vtkMTCollapse
{
/// A traits type of its own, which makes all of the fast mode's types its own.
struct FastTraits : public Traits
{
};
}

#if CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000
#define vtkMT_RING_UPDATE

namespace vtkMTCollapse
{
template <class T>
using Plain = std::remove_cv_t<std::remove_reference_t<T>>;
using FastParameters = Plain<decltype(CGAL::parameters::geom_traits(std::declval<FastTraits&>()))>;
using FastVertexIndexMap = Plain<decltype(CGAL::get_initialized_vertex_index_map(
  std::declval<Region::Mesh&>(), std::declval<const FastParameters&>()))>;
using FastHalfedgeIndexMap = Plain<decltype(CGAL::get_initialized_halfedge_index_map(
  std::declval<Region::Mesh&>(), std::declval<const FastParameters&>()))>;
using FastPointMap = Plain<decltype(CGAL::get_property_map(CGAL::vertex_point, std::declval<Region::Mesh&>()))>;
using FastCollapse = SMS::EdgeCollapse<Region::Mesh, FastTraits, Stop, FastVertexIndexMap, FastPointMap,
  FastHalfedgeIndexMap, ConstrainedMap, QuadricCost, Placement<QuadricMode>, Filter, Visitor, false>;
}

namespace CGAL
{
namespace Surface_mesh_simplification
{
/// What the loop and the project's policies ask of a profile. It has no link and no triangles, so the loop's stock
/// members do not compile with it: the specialisations below cannot be passed by unnoticed.
template <>
class Edge_profile<vtkMTCollapse::Region::Mesh, vtkMTCollapse::FastPointMap, vtkMTCollapse::FastTraits>
{
public:
  using Triangle_mesh = vtkMTCollapse::Region::Mesh;
  using Point = vtkMTCollapse::Point;
  using FT = double;
  using vertex_descriptor = vtkMTCollapse::Region::Vertex;
  using halfedge_descriptor = vtkMTCollapse::Region::Halfedge;

  template <class VertexIndexMap, class HalfedgeIndexMap>
  Edge_profile(halfedge_descriptor h, const Triangle_mesh& mesh, const vtkMTCollapse::FastTraits&, const VertexIndexMap&,
    const vtkMTCollapse::FastPointMap&, const HalfedgeIndexMap&, bool)
    : Mesh(mesh)
    , Forth(h)
    , Back(mesh.opposite(h))
  {
  }

  halfedge_descriptor v0_v1() const { return this->Forth; }
  halfedge_descriptor v1_v0() const { return this->Back; }
  vertex_descriptor v0() const { return this->Mesh.target(this->Back); }
  vertex_descriptor v1() const { return this->Mesh.target(this->Forth); }
  const Point& p0() const { return this->Mesh.point(this->v0()); }
  const Point& p1() const { return this->Mesh.point(this->v1()); }

  bool is_v0_v1_a_border() const { return this->Mesh.is_border(this->Forth); }
  bool is_v1_v0_a_border() const { return this->Mesh.is_border(this->Back); }
  bool left_face_exists() const { return !this->is_v0_v1_a_border(); }
  bool right_face_exists() const { return !this->is_v1_v0_a_border(); }

  // Asked for only where the face exists; where it does not, vL and vR are null as in CGAL's profile.
  vertex_descriptor vL() const
  {
    return this->left_face_exists() ? this->Mesh.target(this->v1_vL()) : Triangle_mesh::null_vertex();
  }
  vertex_descriptor vR() const
  {
    return this->right_face_exists() ? this->Mesh.target(this->v0_vR()) : Triangle_mesh::null_vertex();
  }
  halfedge_descriptor v1_vL() const { return this->Mesh.next(this->Forth); }
  halfedge_descriptor vL_v0() const { return this->Mesh.prev(this->Forth); }
  halfedge_descriptor v0_vR() const { return this->Mesh.next(this->Back); }
  halfedge_descriptor vR_v1() const { return this->Mesh.prev(this->Back); }

private:
  const Triangle_mesh& Mesh;
  const halfedge_descriptor Forth;
  const halfedge_descriptor Back;
};

template <>
inline void vtkMTCollapse::FastCollapse::update_neighbors(const vertex_descriptor kept)
{
  const halfedge_descriptor begin = m_tm.halfedge(kept);
  halfedge_descriptor around = begin;
  do
  {
    const halfedge_descriptor h = primary_edge(around);
    around = m_tm.prev(m_tm.opposite(around));
    if (is_constrained(h))
    {
      continue;
    }
    Edge_data& data = get_data(h);
    Cost_type now = cost(create_profile(h));
    if (data.is_in_PQ())
    {
      // An edge without a cost would only be taken off the queue's top again.
      if (!now)
      {
        remove_from_PQ(h, data);
      }
      data.cost() = now;
      if (now)
      {
        update_in_PQ(h, data);
      }
    }
    else if (now)
    {
      data.cost() = now;
      insert_in_PQ(h, data);
    }
  } while (around != begin);
}

/// The same test as CGAL's: no two neighbouring triangles back to back. It walks the half-edges instead of searching for them,
/// and leaves out the bound on the ratio of areas, which forbids collapses beside slivers.
template <>
inline bool vtkMTCollapse::FastCollapse::is_collapse_geometrically_valid(const Profile& profile, Placement_type place)
{
  return place && !m_should_ignore.R->FoldsEdge(profile.v0_v1(), *place);
}
}
}
#endif

#endif
