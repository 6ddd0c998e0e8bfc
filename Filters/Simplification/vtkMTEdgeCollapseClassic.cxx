// SPDX-License-Identifier: BSD-3-Clause
// CGAL's own policies, for comparison, under the same locks, seams and filters.
#include "vtkMTCollapseModes.h"
#include "vtkMTCollapsePolicies.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>

#include <cmath>

namespace
{
using namespace vtkMTCollapse;

/// A cost that is always a number, so that the queue keeps its order.
Cost Finite(const Cost& cost)
{
  return cost && !std::isfinite(*cost) ? Cost(0.0) : cost;
}

/// Lindstrom-Turk takes no traits but its kernel, so it gets profiles of its own.
class LindstromTurk
{
public:
  explicit LindstromTurk(Surface& mesh)
    : M(&mesh)
    , HasBorder(!CGAL::is_closed(mesh))
  {
  }
  template <class Profile>
  Cost GetCost(const Profile& profile, const Place& place) const
  {
    return this->C(this->MakeProfile(profile), place);
  }
  template <class Profile>
  Place GetPlace(const Profile& profile) const
  {
    return this->P(this->MakeProfile(profile));
  }

private:
  using PointMap = Surface::Property_map<vtkMTCgalMesh::Vertex, Point>;
  using KernelProfile = SMS::Edge_profile<Surface, PointMap, vtkMTCgalMesh::Kernel>;

  template <class Profile>
  KernelProfile MakeProfile(const Profile& profile) const
  {
    Surface& mesh = *this->M;
    return KernelProfile(profile.v0_v1(), mesh, this->Kernel, CGAL::get(boost::vertex_index, mesh), mesh.points(),
      CGAL::get(boost::halfedge_index, mesh), this->HasBorder);
  }

  Surface* M;
  bool HasBorder;
  vtkMTCgalMesh::Kernel Kernel;
  SMS::LindstromTurk_cost<Surface> C;
  SMS::LindstromTurk_placement<Surface> P;
};

class GarlandHeckbert
{
public:
  explicit GarlandHeckbert(Surface& mesh)
    : Policies(mesh)
  {
  }
  template <class Profile>
  Cost GetCost(const Profile& profile, const Place& place) const
  {
    return this->Policies(profile, place);
  }
  template <class Profile>
  Place GetPlace(const Profile& profile) const
  {
    return this->Policies(profile);
  }
  const SMS::GarlandHeckbert_plane_policies<Surface, Traits> Policies;
};

/// CGAL's policies where the rule leaves the place open; what is not finite (triangles without area) becomes the
/// midpoint.
template <class Policy>
struct ClassicMode
{
  const Region* R;
  const Policy* P;

  template <class Profile>
  Place GetPlace(const Profile& profile, Region::Rule rule) const
  {
    const Point& p0 = profile.p0();
    const Point& p1 = profile.p1();
    switch (rule)
    {
      case Region::Rule::First:
        return p0;
      case Region::Rule::Second:
        return p1;
      case Region::Rule::Ends:
      {
        const Cost c0 = this->P->GetCost(profile, p0);
        const Cost c1 = this->P->GetCost(profile, p1);
        return !c1 || (c0 && *c0 <= *c1) ? p0 : p1;
      }
      default:
        break;
    }
    const Place place = this->P->GetPlace(profile);
    const bool finite = place && std::isfinite(place->x() + place->y() + place->z());
    return vtkMTCgalMesh::ToPoint(this->R->Snap(vtkMTCgalMesh::ToVector(finite ? *place : CGAL::midpoint(p0, p1))));
  }
};

template <class Policy>
struct ClassicCost
{
  Region* R;
  const Policy* P;
  template <class Profile>
  Cost operator()(const Profile& profile, const Place& place) const
  {
    this->R->Step();
    return place ? Finite(this->P->GetCost(profile, place)) : Cost();
  }
};

struct GarlandHeckbertCost : public ClassicCost<GarlandHeckbert>
{
  using Update_tag = CGAL::Tag_true;
  template <class Mesh, class PointMap>
  void initialize(const Mesh& mesh, const PointMap& points, const Traits& traits) const
  {
    this->P->Policies.initialize(mesh, points, traits);
  }
  template <class Profile>
  void update_after_collapse(const Profile& profile, vtkMTCgalMesh::Vertex kept) const
  {
    this->P->Policies.update_after_collapse(profile, kept);
  }
};
}

void vtkMTCollapse::RunLindstromTurk(Region& region)
{
  vtkMTCgalMesh mesh(region.Mesh);
  const LindstromTurk policy(mesh.Mesh);
  Run<Traits>(
    region, mesh, ClassicMode<LindstromTurk>{ &region, &policy }, ClassicCost<LindstromTurk>{ &region, &policy });
}

void vtkMTCollapse::RunGarlandHeckbert(Region& region)
{
  vtkMTCgalMesh mesh(region.Mesh);
  const GarlandHeckbert policy(mesh.Mesh);
  Run<Traits>(
    region, mesh, ClassicMode<GarlandHeckbert>{ &region, &policy }, GarlandHeckbertCost{ { &region, &policy } });
}
