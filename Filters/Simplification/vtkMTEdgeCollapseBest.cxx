// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics in CGAL's own loop: after a collapse all edges that end next to the kept vertex are asked again.
#include "vtkMTCollapseModes.h"
#include "vtkMTCollapsePolicies.h"
#include "vtkMTQuadrics.h"

namespace
{
using namespace vtkMTCollapse;

struct QuadricMode
{
  const vtkMTQuadrics* Q;
  template <class Profile>
  Place GetPlace(const Profile& profile, Region::Rule rule) const
  {
    return vtkMTCgalMesh::ToPoint(this->Q->Propose(GetHalfedge(profile), rule).Place);
  }
};

struct QuadricCost
{
  using Update_tag = CGAL::Tag_true;
  Region* R;
  vtkMTQuadrics* Q;

  template <class Mesh, class PointMap, class GeomTraits>
  void initialize(const Mesh&, const PointMap&, const GeomTraits&) const
  {
    this->Q->Initialize();
  }
  template <class Profile>
  void update_after_collapse(const Profile&, vtkMTCgalMesh::Vertex kept) const
  {
    this->Q->Update(static_cast<std::uint32_t>(kept.idx()));
  }
  template <class Profile>
  Cost operator()(const Profile& profile, const Place& place) const
  {
    this->R->Step();
    const std::uint32_t h = GetHalfedge(profile);
    return place ? Cost(this->Q->Propose(h, this->R->GetRule(h)).Cost) : Cost(); // the place is the proposed one
  }
};
}

#if vtkMT_CGAL_IS_KNOWN
namespace CGAL
{
namespace Surface_mesh_simplification
{
/// The filter has looked at the shape already. CGAL's test also refuses neighbours of very different area, which blocks
/// everything beside slivers and triangles without area; the fast mode has no such bound either.
template <>
inline bool vtkMTCollapse::Algorithm<vtkMTCollapse::Traits, QuadricMode, QuadricCost>::are_shared_triangles_valid(
  const Point&, const Point&, const Point&, const Point&) const
{
  return true;
}
}
}
#endif

void vtkMTCollapse::RunBest(Region& region)
{
  vtkMTCgalMesh mesh(region.Mesh);
  vtkMTQuadrics quadrics(region);
  Run<Traits>(region, mesh, QuadricMode{ &quadrics }, QuadricCost{ &region, &quadrics });
}
