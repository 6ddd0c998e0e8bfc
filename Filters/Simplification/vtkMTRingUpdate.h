// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief CGAL's edge collapse for the fast mode: costs are asked again on the 1-ring only, and nothing is allocated
 *
 * CGAL's loop asks for the cost of every edge that ends at a neighbour of the kept vertex, about thirty after each
 * collapse, collects them in two sets, and makes a profile with two vectors for each. The quadric of an edge changes
 * most where the edge ends at the kept vertex itself; asking only these six or so leaves the result within a few
 * percent and costs a quarter of the time. The members below are explicit specialisations for this project's own traits
 * type; CGAL's headers and every other use of them stay as they are. They speak of private members, so they hold for
 * the CGAL versions they were written for, and with any other the fast mode is the stock loop.
 */
#ifndef vtkMTRingUpdate_h
#define vtkMTRingUpdate_h

#include "vtkMTQuadricMode.h"

namespace vtkMTCollapse
{
/// A traits type of its own, which makes all of the fast mode's types its own.
struct FastTraits : public Traits
{
};
}

#if vtkMT_CGAL_IS_KNOWN
namespace vtkMTCollapse
{
using FastCollapse = Algorithm<FastTraits, QuadricMode, QuadricCost>;
}

namespace CGAL
{
namespace Surface_mesh_simplification
{
/// What the loop and the project's policies ask of a profile. It has no link and no triangles, so the loop's stock
/// members do not compile with it: the specialisations below cannot be passed by unnoticed.
template <>
class Edge_profile<vtkMTCollapse::Region::Mesh, vtkMTCollapse::PointMap, vtkMTCollapse::FastTraits>
{
public:
  using Triangle_mesh = vtkMTCollapse::Region::Mesh;
  using Point = vtkMTCollapse::Point;
  using FT = double;
  using vertex_descriptor = vtkMTCollapse::Region::Vertex;
  using halfedge_descriptor = vtkMTCollapse::Region::Halfedge;

  template <class VertexIndexMap, class HalfedgeIndexMap>
  Edge_profile(halfedge_descriptor h, const Triangle_mesh& mesh, const vtkMTCollapse::FastTraits&,
    const VertexIndexMap&, const vtkMTCollapse::PointMap&, const HalfedgeIndexMap&, bool)
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

/// The same test as CGAL's, with marks instead of a search around every neighbour. CGAL also keeps apart two vertices
/// that both have constrained edges; here only locked vertices have these, and the edge between two of them is
/// constrained itself.
template <>
inline bool vtkMTCollapse::FastCollapse::is_collapse_topologically_valid(const Profile& profile)
{
  return m_should_ignore.R->SatisfiesLink(profile.v0_v1());
}

/// The last word before a collapse. The cost by which the edge has come to the top of the queue may be out of date,
/// since the quadric at its other end has changed with the ring; when it is now dearer than the next edge, it goes back
/// into the queue with its true cost. So stale costs that are too low do no harm, at the price of one more look at a
/// few edges. Otherwise the same test as CGAL's, that no two neighbouring triangles come to lie back to back; it walks
/// the half-edges instead of searching for them, and leaves out the bound on the ratio of areas, which forbids
/// collapses beside slivers.
template <>
inline bool vtkMTCollapse::FastCollapse::is_collapse_geometrically_valid(const Profile& profile, Placement_type place)
{
  if (!place)
  {
    return false;
  }
  const halfedge_descriptor h = primary_edge(profile.v0_v1());
  Edge_data& data = get_data(h);
  const Cost_type now = m_get_cost(profile, place);
  if (now > data.cost() && !mPQ->empty() && now > get_data(mPQ->top()).cost())
  {
    data.cost() = now;
    insert_in_PQ(h, data);
    return false;
  }
  return !m_should_ignore.R->FoldsEdge(profile.v0_v1(), *place);
}
}
}
#endif

#endif
